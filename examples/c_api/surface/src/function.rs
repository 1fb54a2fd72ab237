//! One function: its C prototype, its Rust text, and how the test calls it.

use crate::number::Number;
use crate::{Law, draw, value};

pub(crate) struct Function {
    pub(crate) name: String,
    /// C's and Rust's declarations, a law's handle apart.
    pub(crate) arguments: Vec<[String; 2]>,
    /// C's and Rust's type.
    pub(crate) result: [String; 2],
    /// Rust's expression.
    pub(crate) body: String,
    /// The runner in test/main.c.
    pub(crate) kind: String,
    /// C's type of the handle.
    pub(crate) handle: Option<String>,
}

pub(crate) fn name(law: Law, op: &str, number: Number) -> String {
    format!("coslobe_{}_{op}_{}", law.c, number.name())
}

/// C's type of a law's handle.
pub(crate) fn handle(law: Law, number: Number) -> Option<String> {
    law.has_handle()
        .then(|| format!("coslobe_{}_{}", law.c, number.name()))
}

/// All functions of a law: those that draw or write, then those that give a value.
pub(crate) fn functions(number: Number, law: Law) -> impl Iterator<Item = Function> {
    draw::functions(number, law).chain(value::functions(number, law))
}

impl Function {
    pub(crate) fn c_arguments(&self) -> Vec<String> {
        let handle = self
            .handle
            .iter()
            .map(|handle| format!("const {handle} *law"));
        let own = self.arguments.iter().map(|[c, _]| c.clone());
        handle.chain(own).collect()
    }

    pub(crate) fn prototype(&self) -> String {
        let arguments = self.c_arguments();
        let must_be = |c: &String| {
            let may_be_null = c.ends_with("*filled") || c.ends_with("*fault");
            (c.contains('*') || c.contains('[')) && !may_be_null
        };
        let pointers = (1..).zip(&arguments).filter(|(_, c)| must_be(c));
        let pointers: Vec<String> = pointers.map(|(i, _)| i.to_string()).collect();
        let checked = if self.result[0] == "int" {
            "COSLOBE_CHECKED "
        } else {
            ""
        };
        let pure = if pointers.is_empty() {
            "COSLOBE_CONST".into()
        } else {
            format!("COSLOBE_NONNULL(({}))", pointers.join(", "))
        };
        let (result, name, arguments) = (&self.result[0], &self.name, arguments.join(", "));
        format!("{checked}{pure} {result} {name}({arguments});")
    }

    pub(crate) fn shim(&self) -> String {
        let handle = self.handle.iter().map(|_| "law: *const Lobe".into());
        let own = self.arguments.iter().map(|[_, rust]| rust.clone());
        let arguments: Vec<String> = handle.chain(own).collect();
        let arguments = arguments.join(", ");
        let (name, result, body) = (&self.name, &self.result[1], &self.body);
        let (marker, body) = if arguments.contains('*') {
            ("unsafe ", format!("unsafe {{ {body} }}"))
        } else {
            ("", body.clone())
        };
        format!(
            "#[unsafe(no_mangle)]\n\
             pub {marker}extern \"C\" fn {name}({arguments}) -> {result} {{ {body} }}\n"
        )
    }
}
