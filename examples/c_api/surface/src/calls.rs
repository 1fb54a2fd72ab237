//! What the C test runs.

use crate::function::functions;
use crate::number::Number;

/// `CALL(kind, function, name)` of each function; a handle is passed by a function of its own.
pub fn calls() -> String {
    let (mut wrappers, mut list) = (String::new(), String::new());
    for number in Number::ALL {
        let all = number.laws().flat_map(|law| functions(number, law));
        for f in all {
            let mut called = f.name.clone();
            if f.handle.is_some() {
                called = f.name.replace("coslobe_", "");
                let (result, name) = (&f.result[0], &f.name);
                let taken: Vec<_> = f.arguments.iter().map(|[c, _]| c.as_str()).collect();
                let passed = f.arguments.iter().map(|[_, rust]| rust.split(':').next());
                let passed: Vec<_> = passed.flatten().collect();
                let (taken, passed, lobe) = (taken.join(", "), passed.join(", "), number.name());
                wrappers += &format!(
                    "static {result} {called}({taken})\n\
                     {{\n    return {name}(&lobe_{lobe}, {passed});\n}}\n"
                );
            }
            list += &format!("CALL({}, {called}, \"{}\")\n", f.kind, f.name);
        }
    }
    format!("#ifdef WRAPPERS\n{wrappers}#else\n{list}#endif\n")
}
