//! What this machine computes.

use crate::failure::{Failure, Result, While};
use crate::types::{FIXED, FIXED16};
use coslobe::{Fast, Precise};
use kit::{Answer, Integers, Integers16, Laws, Subject, Visitor, answer, directions};

/// Something that can be done in a number type.
pub(crate) trait InType {
    type Output;
    fn run<T: Laws>(self) -> Self::Output;
}

/// Does it in the type of this name.
pub(crate) fn in_type<F: InType>(name: &str, f: F) -> Result<F::Output> {
    match name {
        "f32" => Ok(f.run::<f32>()),
        "f64" => Ok(f.run::<f64>()),
        "Fast<f32>" => Ok(f.run::<Fast<f32>>()),
        "Precise<f32>" => Ok(f.run::<Precise<f32>>()),
        "Precise<f64>" => Ok(f.run::<Precise<f64>>()),
        FIXED => Ok(f.run::<Integers>()),
        FIXED16 => Ok(f.run::<Integers16>()),
        _ => Err(Failure(format!("no number type {name}"))),
    }
}

/// What the image `hash` in this type answers.
pub(crate) fn hashes(number: &str, request: &[&str]) -> Result<String> {
    struct Request<'a>(&'a [&'a str]);
    impl InType for Request<'_> {
        type Output = Result<String>;
        fn run<T: Laws>(self) -> Result<String> {
            let mut lines = String::new();
            let words = self.0.iter().copied();
            match answer::<T>(words, &mut lines).while_("writing to a string")? {
                Answer::Done => Ok(lines),
                Answer::NotUnderstood => Err(Failure(lines)),
            }
        }
    }
    in_type(number, Request(request))?
}

/// What the image `law` of this law and type prints.
pub(crate) fn law(law: &str, number: &str) -> Result<String> {
    struct One<'a> {
        law: &'a str,
        lines: String,
    }
    impl Visitor for One<'_> {
        fn visit<S: Subject>(&mut self, subject: &S) {
            if S::LAW == self.law {
                directions(subject, &mut self.lines).expect("a string grows");
            }
        }
    }
    impl InType for One<'_> {
        type Output = String;
        fn run<T: Laws>(mut self) -> String {
            T::each(&mut self);
            self.lines
        }
    }
    let lines = in_type(
        number,
        One {
            law,
            lines: String::new(),
        },
    )?;
    if lines.is_empty() {
        return Err(Failure(format!("no law {law}")));
    }
    Ok(lines)
}
