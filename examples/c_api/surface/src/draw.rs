//! Functions that draw, or that write a direction.

use crate::Law;
use crate::function::{Function, handle, name};
use crate::number::{Number, Role};

const DRAWS: [&str; 6] = [
    "sample",
    "sample_around",
    "fill",
    "warp_direction",
    "point",
    "self_test",
];

pub(crate) fn functions(number: Number, law: Law) -> impl Iterator<Item = Function> {
    let offered = move |op: &&str| match *op {
        "sample_around" | "warp_direction" => law.size == 3,
        "point" => !law.has_handle(),
        _ => true,
    };
    let offered = DRAWS.into_iter().filter(offered);
    offered.map(move |op| function(number, law, op))
}

/// An argument in C and in Rust.
fn argument(c: impl Into<String>, rust: impl Into<String>) -> [String; 2] {
    [c.into(), rust.into()]
}

fn function(number: Number, law: Law, op: &str) -> Function {
    let (c, rust) = (number.c(Role::Component, law), number.rust(Role::Component));
    let (size, subject) = (law.size, number.law(law));
    let traits = if size == 2 { "Planar" } else { "Spatial" };
    // A method, by its trait for floats.
    let call = |traits: &str, method: &str, arguments: &str| {
        number.get_each(&if number.is_integer() {
            format!("{subject}.{method}({arguments})")
        } else {
            format!("{traits}::{method}(&{subject}, {arguments})")
        })
    };
    let rng = argument("const coslobe_rng *rng", "rng: *const Generator");
    let direction = argument(
        format!("{c} direction[{size}]"),
        format!("direction: *mut [{rust}; {size}]"),
    );
    let (arguments, body) = match op {
        "sample" => (
            vec![rng, direction],
            format!(
                "draw(rng, direction, |words| {})",
                call(traits, "sample", "words")
            ),
        ),
        "sample_around" => {
            let normal = match number.constructor(Role::Component) {
                Some(constructor) => format!("normal.map({constructor})"),
                None => "normal".into(),
            };
            let around = call(traits, op, &format!("{normal}, words"));
            (
                vec![
                    argument(
                        format!("const {c} normal[3]"),
                        format!("normal: *const [{rust}; 3]"),
                    ),
                    rng,
                    direction,
                ],
                format!("around(normal, rng, direction, |normal, words| {around})"),
            )
        }
        "fill" => (
            vec![
                rng,
                argument(
                    format!("{c} *directions"),
                    format!("directions: *mut [{rust}; {size}]"),
                ),
                argument("size_t n", "n: usize"),
                argument("size_t *filled", "filled: *mut usize"),
            ],
            format!(
                "fill(rng, directions, n, filled, |words| {})",
                call(traits, "sample", "words")
            ),
        ),
        "warp_direction" => {
            let role = Role::Probability;
            let of = |x: &str| {
                argument(
                    format!("{} {x}", number.c(role, law)),
                    format!("{x}: {}", number.rust(role)),
                )
            };
            let [p, turn] = ["p", "turn"].map(|x| number.value(role, x));
            let warped = call(traits, op, &format!("[{p}, {turn}]"));
            (
                vec![of("p"), of("turn"), direction],
                format!("put(direction, {warped})"),
            )
        }
        "point" => {
            let (c, rust) = (number.c(Role::Length, law), number.rust(Role::Length));
            let radius = number.value(Role::Length, "radius");
            let checked = if number.is_integer() {
                "FixedRadius"
            } else {
                "Radius"
            };
            let drawn = call(&format!("{traits}Point"), "sample_point", "radius, words");
            (
                vec![
                    argument(format!("{c} radius"), format!("radius: {rust}")),
                    rng,
                    argument(
                        format!("{c} point[{size}]"),
                        format!("point: *mut [{rust}; {size}]"),
                    ),
                ],
                format!(
                    "match {checked}::new({radius}) {{ \
                     Ok(radius) => draw(rng, point, |words| {drawn}), Err(_) => RADIUS }}"
                ),
            )
        }
        _ => {
            let test = if number.is_integer() {
                "fixed".into()
            } else {
                let kind = traits.to_lowercase();
                format!("{kind}::<{}, _>", number.rust_component())
            };
            (
                vec![rng, argument("coslobe_fault *fault", "fault: *mut CFault")],
                format!("judge(rng, fault, self_test::{test}({subject}))"),
            )
        }
    };
    let body = if law.has_handle() {
        format!("with(law, NULL_POINTER, |law| {{ {body} }})")
    } else {
        body
    };
    let kind = match op {
        "self_test" => op.into(),
        _ => format!("{op}{size}_{}", number.base()),
    };
    Function {
        name: name(law, op, number),
        arguments,
        result: ["int".into(), "c_int".into()],
        body,
        kind,
        handle: handle(law, number),
    }
}
