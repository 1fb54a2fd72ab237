//! What a scene does not call for is not simulated, and forcing it on changes no bit.

use shade::cells::{SHIPPED, cells};
use shade::file::{World, parse, scene};
use shade_core::effect::Lamp;
use shade_core::{
    Asked, Counters, Effect, Effects, Number, NumberVisitor, Pixel, Scene, Set, Vector,
    every_number, pixel,
};

/// Every scene's pixels on a coarse grid, two samples each.
fn pixels<V: Vector, E: Effects>(
    of: &Scene<V>,
    e: E,
    law: &V::Law,
    n: &mut Counters,
) -> Vec<Pixel<V::T>> {
    let (w, h) = (of.camera.width, of.camera.height);
    let row = |y: u16| (0..8).map(move |x: u16| (x * (w / 8), y * (h / 6)));
    (0..6)
        .flat_map(row)
        .map(|at| pixel(of, e, law, at, 2, n))
        .collect()
}

fn shipped<V: World>() -> Vec<(&'static str, Scene<V>, V::Law)> {
    let flat = V::DIM == 2;
    let own = SHIPPED
        .iter()
        .filter(|s| s.name.starts_with("flat") == flat);
    let of = own.map(|s| {
        let raw = parse(s.name, s.text).expect("a shipped scene");
        let (of, law) = scene(&raw, None).expect("a scene of this world");
        (s.name, of, law)
    });
    of.collect()
}

/// What was counted of effects outside the set.
fn strays(n: &Counters, set: Set) -> Vec<Effect> {
    let all = Effect::ALL.into_iter().filter(|&e| !set.has(e));
    all.filter(|&e| n.words[e as usize] + n.rays[e as usize] + n.runs[e as usize] > 0)
        .collect()
}

#[test]
fn absent_effects_do_nothing() {
    fn check<V: World>() {
        for (name, of, law) in shipped::<V>() {
            let set = of.called_for();
            let mut n = Counters::default();
            pixels(&of, Asked(set), &law, &mut n);
            assert_eq!(strays(&n, set), [], "{name}");
            // A planted stray: each effect that the scene does not call for, on all the same.
            let mut forced = of.clone();
            if forced.lamps.is_empty() {
                forced.lamps.push(Lamp::neutral()).expect("room");
            }
            for stray in Effect::ALL.into_iter().filter(|&e| !set.has(e)) {
                // Without another that is absent too these may have nothing to do.
                let silent = matches!(
                    stray,
                    Effect::Bounces
                        | Effect::Lens
                        | Effect::Mix
                        | Effect::Diffuse
                        | Effect::Gloss
                        | Effect::Sun
                        | Effect::Lamp
                );
                let mut n = Counters::default();
                pixels(&forced, Asked(set.with(stray)), &law, &mut n);
                assert!(
                    silent || strays(&n, set).contains(&stray),
                    "{name}: {stray:?}"
                );
            }
        }
    }
    check::<[f32; 3]>();
    check::<[f32; 2]>();
}

/// Forced on, every effect runs somewhere, and the image is the same to the bit, in every number
/// type.
#[test]
fn forcing_all_changes_no_bit() {
    fn check<V: World>() -> Counters
    where
        Pixel<V::T>: PartialEq,
    {
        let mut total = Counters::default();
        for (name, of, law) in shipped::<V>() {
            let needed = pixels(&of, Asked(of.called_for()), &law, &mut Counters::default());
            let mut forced = of.clone();
            if forced.lamps.is_empty() {
                forced.lamps.push(Lamp::neutral()).expect("room");
            }
            let all = pixels(&forced, Asked(Set::ALL), &law, &mut total);
            assert!(needed == all, "{name}");
            // A planted change: fog of the least density that can be seen.
            forced.fog.region.radius = V::T::from_f64(1e3);
            forced.fog.absorption = [V::T::from_f64(1e-4); 3];
            let fogged = pixels(&forced, Asked(Set::ALL), &law, &mut Counters::default());
            assert!(needed != fogged, "{name}");
        }
        total
    }
    let n = check::<[f32; 3]>();
    for e in Effect::ALL.into_iter().filter(|&e| e != Effect::Bounces) {
        assert!(n.runs[e as usize] > 0, "{e:?}");
    }
    struct Same;
    impl NumberVisitor for Same {
        fn number<T: Number>(&mut self) {
            check::<[T; 3]>();
            check::<[T; 2]>();
        }
    }
    every_number(&mut Same);
}

/// Effects as part of the type, asked as it goes, all of them, and shaders written by hand: the
/// same bits.
#[test]
fn all_ways_agree() {
    let cells = cells();
    assert_eq!(
        cells.iter().filter(|c| c.way == "hand").count(),
        SHIPPED.len() - 1
    );
    for c in &cells {
        let needed = cells
            .iter()
            .find(|d| d.scene == c.scene && d.way == "needed");
        assert!(
            needed.is_some_and(|d| (d.pixels)() == (c.pixels)()),
            "{}: {}",
            c.scene,
            c.way
        );
    }
}

/// Words and rays are those that the effects' costs say: entries times cost, where each entry draws
/// all.
#[test]
fn costs_are_as_stated() {
    fn check<V: World>() {
        for (name, of, law) in shipped::<V>() {
            let mut n = Counters::default();
            pixels(&of, Asked(of.called_for()), &law, &mut n);
            for e in [
                Effect::Filter,
                Effect::Lens,
                Effect::Mix,
                Effect::Diffuse,
                Effect::Gloss,
            ] {
                let (i, cost) = (e as usize, e.cost::<V>());
                assert_eq!(
                    n.words[i],
                    n.runs[i] * u64::from(cost.words),
                    "{name}: {e:?}"
                );
                assert_eq!(n.rays[i], n.runs[i] * u64::from(cost.rays), "{name}: {e:?}");
            }
            for e in [Effect::Sun, Effect::Lamp] {
                let (i, cost) = (e as usize, e.cost::<V>());
                // A surface that looks away asks for no ray.
                assert!(
                    n.rays[i] <= n.runs[i] * u64::from(cost.rays),
                    "{name}: {e:?}"
                );
                assert_eq!(
                    n.words[i],
                    n.runs[i] * u64::from(cost.words),
                    "{name}: {e:?}"
                );
            }
            for e in [
                Effect::Sky,
                Effect::Emission,
                Effect::Absorption,
                Effect::Bounces,
            ] {
                assert_eq!(n.words[e as usize] + n.rays[e as usize], 0, "{name}: {e:?}");
            }
        }
    }
    struct Stated;
    impl NumberVisitor for Stated {
        fn number<T: Number>(&mut self) {
            check::<[T; 3]>();
            check::<[T; 2]>();
        }
    }
    every_number(&mut Stated);
}
