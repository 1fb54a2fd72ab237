//! The Rust functions behind the header, a module for each number type.

use crate::LAWS;
use crate::function::functions;
use crate::number::{Number, Role};

/// All of them, to be included where `boundary` is a module of the crate.
pub fn shims() -> String {
    let modules = Number::ALL.map(|number| {
        let (name, text) = (number.name(), module(number));
        format!("pub mod {name} {{\n{text}}}\n")
    });
    modules.concat()
}

fn imports(number: Number) -> String {
    let mut names: Vec<_> = LAWS.iter().map(|law| law.rust).collect();
    let mut text = "use crate::boundary::*;\nuse core::ffi::c_int;\n".to_string();
    names.push("CosSin, self_test");
    if number.is_integer() {
        names.retain(|name| *name != "CosPower");
        text += "use coslobe::integers::FixedRadius;\n";
    } else {
        names.push("Law, Planar, PlanarPoint, Radius, Spatial, SpatialPoint");
    }
    names.extend(number.wrapper());
    match number {
        Number::Q31 => {
            text += "use coslobe::integers::CosPower;\n\
                     use fixed::types::{I0F32, I1F31, I32F0, U0F32, U16F16};\n";
        }
        Number::Q15 => text += "use fixed::types::{I0F16, I1F15, I16F0, U0F16};\n",
        _ => {}
    }
    text + &format!("use coslobe::{{{}}};\n", names.join(", "))
}

fn module(number: Number) -> String {
    let (r, inner) = (number.rust(Role::Component), number.rust_component());
    let [get, new] = [
        ["at.cos", "at.sin"].map(|x| number.get(x)),
        ["at.cos", "at.sin"].map(|x| number.value(Role::Component, x)),
    ]
    .map(|[cos, sin]| format!("{{ cos: {cos}, sin: {sin} }}"));
    let mut text = imports(number)
        + &format!(
            "fn plain(at: CosSin<{inner}>) -> Pair<{r}> {{ Pair {get} }}\n\
             fn pair(at: Pair<{r}>) -> CosSin<{inner}> {{ CosSin {new} }}\n"
        );
    if let Some(words) = number.handle_words() {
        text += &handle(number, words);
    }
    for law in number.laws() {
        for function in functions(number, law) {
            text += &function.shim();
        }
    }
    text
}

/// The handle of `cos_power`, and what fills it in.
fn handle(number: Number, words: usize) -> String {
    let (r, name) = (number.rust(Role::Component), number.name());
    let exponent = number.value(Role::Exponent, "exponent");
    let (lobe, made, none) = if number.is_integer() {
        let made = format!("Some(Fixed(CosPower::new({exponent})))");
        ("Fixed<CosPower>".into(), made, "0")
    } else {
        let made = format!("CosPower::new({exponent}).ok()");
        let lobe = format!("CosPower<{}>", number.rust_component());
        (lobe, made, "f32::NAN")
    };
    let exponent = number.rust(Role::Exponent);
    format!(
        "/// `coslobe_cos_power_{name}` of the header.\n\
         pub type Lobe = Handle<{lobe}, {words}>;\n\
         const NO_PAIR: Pair<{r}> = Pair {{ cos: {none}, sin: {none} }};\n\
         #[unsafe(no_mangle)]\n\
         pub unsafe extern \"C\" fn coslobe_cos_power_init_{name}\
         (law: *mut Lobe, exponent: {exponent}) -> c_int {{ unsafe {{ init(law, {made}) }} }}\n"
    )
}
