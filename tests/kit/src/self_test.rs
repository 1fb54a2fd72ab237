//! Cases of the power-on self-test: generators and samplers, good and faulty, and the verdict on
//! each, which boards and host compare.

use core::convert::Infallible;
use coslobe::integers::CosPower;
use coslobe::rand_core::{Rng, TryRng};
use coslobe::self_test::{
    self, Alarm, Fault, InFixed, InSpace, Invalid, Place, Report, Subject, Test,
};
use coslobe::{CircleArc, CircleShell, Disk, Fast, Fixed, Lambert, Planar, SphereShell};
use fixed::types::U16F16;
use rand_pcg::Pcg32;

/// What can be asked for; `fixed` in integers. The last word is the fault.
pub const NAMES: [&str; 20] = [
    "good",
    "fast",
    "plane",
    "cost",
    "stuck",
    "ones",
    "bit",
    "biased",
    "period",
    "counter",
    "law",
    "arc",
    "nan",
    "fixed",
    "fixed-plane",
    "fixed-power",
    "fixed-stuck",
    "fixed-plane-biased",
    "fixed-power-bit",
    "fixed-power-law",
];

/// The exponent of `fixed-power`.
const EXPONENT: U16F16 = U16F16::lit("7.3");

/// The verdict on a case; none for a name that is not in [`NAMES`].
pub fn verdict(name: &str) -> Option<Result<Report, Fault>> {
    let mut rng = generator(name)?;
    let rng = &mut rng;
    Some(match name {
        "fast" => judge(self_test::spatial::<Fast<f32>, _>(SphereShell), rng),
        "plane" => judge(self_test::planar::<f32, _>(Disk), rng),
        "law" => judge(Test::new(LambertForShell), rng),
        "arc" => fed(self_test::planar::<f32, _>(CircleShell), || {
            Planar::sample(&CircleArc, rng)
        }),
        "nan" => {
            let mut test = self_test::spatial::<f32, _>(Lambert);
            test.feed(&[f32::NAN, 0.8, 0.6]);
            test.verdict(Alarm::OneInBillion)
        }
        "fixed" | "fixed-stuck" => judge(self_test::fixed(Fixed(Lambert)), rng),
        "fixed-plane" | "fixed-plane-biased" => judge(self_test::fixed(Fixed(Disk)), rng),
        "fixed-power" | "fixed-power-bit" => judge(power(), rng),
        "fixed-power-law" => fed(power(), || Fixed(SphereShell).sample(rng)),
        _ => judge(self_test::spatial::<f32, _>(Lambert), rng),
    })
}

fn judge<S: Subject>(mut test: Test<S>, rng: &mut Generator) -> Result<Report, Fault> {
    test.run(rng, self_test::SAMPLES);
    test.verdict(Alarm::OneInBillion)
}

/// From samples alone.
fn fed<S: Subject>(
    mut test: Test<S>,
    mut draw: impl FnMut() -> S::Sample,
) -> Result<Report, Fault> {
    for _ in 0..self_test::SAMPLES {
        test.feed(&draw());
    }
    test.verdict(Alarm::OneInBillion)
}

fn power() -> Test<InFixed<Fixed<CosPower>>> {
    self_test::fixed(Fixed(CosPower::new(EXPONENT)))
}

/// The generator of a case.
pub fn generator(name: &str) -> Option<Generator> {
    if !NAMES.contains(&name) {
        return None;
    }
    let fault: fn(u32, u32) -> u32 = match name.rsplit('-').next()? {
        "stuck" => |_, _| 0,
        "ones" => |_, _| !0,
        "bit" => |word, _| word | 1 << 9,
        "biased" => |word, _| biased(word),
        "period" => |_, i| {
            (i % 4096)
                .wrapping_mul((i % 4096) | 1)
                .wrapping_mul(0x9e37_79b9)
        },
        "counter" => |_, i| i,
        _ => |word, _| word,
    };
    let rng = Pcg32::new(2024, 1);
    Some(Generator {
        rng,
        count: 0,
        fault,
    })
}

/// The top bit is 1 with probability 9/16.
fn biased(word: u32) -> u32 {
    if word & 7 == 0 { word | 1 << 31 } else { word }
}

/// PCG with a fault.
#[derive(Clone)]
pub struct Generator {
    rng: Pcg32,
    count: u32,
    fault: fn(u32, u32) -> u32,
}

impl TryRng for Generator {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.count += 1;
        Ok((self.fault)(self.rng.next_u32(), self.count))
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        let low = u64::from(self.try_next_u32()?);
        Ok(low | u64::from(self.try_next_u32()?) << 32)
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        self.rng.fill_bytes(bytes);
        Ok(())
    }
}

/// Draws from Lambert's law and claims a shell's.
struct LambertForShell;

impl Subject for LambertForShell {
    type Sample = [f32; 3];

    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [f32; 3] {
        Lambert.sample(rng)
    }

    fn place(&self, sample: &[f32; 3]) -> Result<Place, Invalid> {
        InSpace::new(SphereShell).place(sample)
    }
}
