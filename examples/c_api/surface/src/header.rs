//! coslobe.h.

use crate::function::functions;
use crate::number::{Number, Role};

/// The header of the library of this version.
pub fn header(version: &str) -> String {
    let mut text = include_str!("../top.h").to_string();
    for (part, number) in ["@MAJOR@", "@MINOR@", "@PATCH@"]
        .into_iter()
        .zip(version.split('.'))
    {
        text = text.replace(part, number);
    }
    for number in Number::ALL {
        let name = number.name();
        text += &format!("\n/* ---- {name}: {} ---- */\n", number.title());
        if let Some(words) = number.handle_words() {
            text += &format!(
                "\n/* The law cos_power with its constants: coslobe_cos_power_init_{name} fills it in. */\n\
                 typedef struct coslobe_cos_power_{name} {{\n    uint32_t state[{words}];\n\
                 }} coslobe_cos_power_{name};\n"
            );
        }
        for law in number.laws() {
            text += &format!("\n/* {}, {}. */\n", law.c, law.what);
            if law.has_handle() {
                let exponent = number.c(Role::Exponent, law);
                text += &wrapped(&format!(
                    "COSLOBE_CHECKED COSLOBE_NONNULL((1)) int coslobe_cos_power_init_{name}\
                     (coslobe_cos_power_{name} *law, {exponent} exponent);"
                ));
            }
            for function in functions(number, law) {
                text += &wrapped(&function.prototype());
            }
        }
    }
    text + include_str!("../end.h")
}

/// A prototype as lines of at most 96 columns.
fn wrapped(prototype: &str) -> String {
    let name = prototype.find(" coslobe_").unwrap_or(0);
    let Some(open) = prototype[name..].find('(') else {
        return prototype.into();
    };
    if prototype.len() <= 96 {
        return format!("{prototype}\n");
    }
    let (head, rest) = prototype.split_at(name + open + 1);
    let (mut text, mut line) = (format!("{head}\n"), String::new());
    for piece in rest.split_inclusive(", ") {
        if 4 + line.len() + piece.len() > 92 {
            text += &format!("    {}\n", line.trim_end());
            line.clear();
        }
        line += piece;
    }
    text + &format!("    {line}\n")
}
