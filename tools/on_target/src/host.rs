//! What this machine computes.

use crate::failure::{Failure, Result, While};
use crate::types::{FIXED, FIXED16};
use kit::catalogue::every_number;
use kit::{
    Answer, Integers, Integers16, Laws, Number, NumberVisitor, Subject, Visitor, answer, directions,
};

/// Something that can be done in a number type.
pub(crate) trait InType {
    type Output;
    fn run<T: Laws>(self) -> Self::Output;
}

/// Does it in the type of this name.
pub(crate) fn in_type<F: InType>(name: &str, f: F) -> Result<F::Output> {
    match name {
        FIXED => return Ok(f.run::<Integers>()),
        FIXED16 => return Ok(f.run::<Integers16>()),
        _ => {}
    }
    let mut named = Named {
        name,
        task: Some(f),
        output: None,
    };
    every_number(&mut named);
    named
        .output
        .ok_or_else(|| Failure(format!("no number type {name}")))
}

/// Looks for a number type by its name.
struct Named<'a, F: InType> {
    name: &'a str,
    task: Option<F>,
    output: Option<F::Output>,
}

impl<F: InType> NumberVisitor for Named<'_, F> {
    fn number<T: Number>(&mut self) {
        if T::NAME == self.name {
            self.output = self.task.take().map(F::run::<T>);
        }
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
