//! Bodies in one place or nearly so: they wait, or are thrown out and reported.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::scalar::Factor;
use fixstep::{AllPairs, Body, BodyId, Point, Pull, Scalar, Step, World};

use crate::nbody::scene::*;
use crate::support::*;

pub fn pull<S: Scalar>(constant: f64, softening: f64) -> AllPairs<Pull<S>> {
    AllPairs(Pull::new(ratio(constant), ratio(softening)).unwrap())
}

/// One step of 1/60 s.
pub fn step<S: Scalar, const M: usize>(
    world: &mut World<Point<S>, M>,
    scheme: Scheme,
    pull: &mut AllPairs<Pull<S>>,
) {
    world.step(&mut scheme.method(), pull, &Step::hz(60).unwrap());
}

/// Three bodies of some kilograms, `apart` units from each other, moving alike.
fn trio<S: Scale>(apart: f64, masses: [f64; 3]) -> World<Point<S>, 3> {
    let (x, y) = (0.5 * S::LENGTH, -0.25 * S::LENGTH);
    let places = [[0.0, 0.0], [1.0, 0.0], [0.0, -1.0]];
    let body = |i: usize| {
        let [dx, dy] = places[i].map(|d: f64| d * apart);
        let place = [x + dx * S::unit(x), y + dy * S::unit(y)];
        point(place, [0.01 * x, -0.02 * x], masses[i])
    };
    world([0, 1, 2].map(body))
}

/// Bodies in one place move as one; `d` is zero and so is the pull.
fn check_together<S: Scale>() {
    let least = least_softening::<S>(1.0);
    for scheme in SCHEMES {
        for (softening, scale) in [(least, 1.0), (least, 5e5), (0.25, 1.0), (0.25, 5e5)] {
            let mut world = trio::<S>(0.0, [scale, 2.0 * scale, 3.7 * scale]);
            let mut pull = pull::<S>(1.0, softening);
            let velocity = world.bodies()[0].velocity();
            for _ in 0..1000 {
                step(&mut world, scheme, &mut pull);
                let first = world.bodies()[0];
                for body in world.bodies() {
                    assert_eq!(body.position(), first.position());
                    assert_eq!(body.velocity(), velocity, "{} {scheme:?}", S::name());
                }
            }
            assert_eq!(world.out_of_range().count(), 0);
        }
    }
}

#[test]
fn bodies_in_one_place_stay_together() {
    check_together::<f32>();
    check_together::<f64>();
    check_together::<I16F16>();
    check_together::<I12F20>();
    check_together::<I8F24>();
    check_together::<I20F12>();
}

/// Whether every number is away from both ends of the range, judged by its value.
fn inside<S: Scalar>(body: &Point<S>) -> bool {
    let parts = body
        .position()
        .array()
        .into_iter()
        .chain(body.velocity().array());
    let end = S::MAX.to_f64();
    parts
        .map(S::to_f64)
        .all(|value| value.abs() < end || value.abs() == end && end > 1e30)
}

/// Steps of which each is looked at: who is at an end is reported, and nobody else. Gives the number
/// of steps with a report.
fn reports<S: Scalar>(
    scheme: Scheme,
    mut world: World<Point<S>, 3>,
    mut pull: AllPairs<Pull<S>>,
) -> u32 {
    let mut count = 0;
    for _ in 0..600 {
        step(&mut world, scheme, &mut pull);
        let out: Vec<BodyId> = world
            .iter()
            .filter(|(_, b)| !inside(*b))
            .map(|(id, _)| id)
            .collect();
        assert!(
            world.out_of_range().eq(out.iter().copied()),
            "{scheme:?} {:?}",
            world.bodies()
        );
        count += u32::from(!out.is_empty());
    }
    count
}

/// A unit apart. Ordinary masses and softening: nothing leaves the scene. 1000 t and the least softening:
/// the coefficient saturates at `2^30`, a unit of distance makes a kick of half the range, and whoever
/// gets to the end of the range is reported.
fn check_close<S: Scale>(fixed: bool) {
    let least = least_softening::<S>(1.0);
    for scheme in SCHEMES {
        let ordinary = trio::<S>(1.0, [1.0, 2.0, 3.7]);
        assert_eq!(
            reports(scheme, ordinary, pull(1.0, 0.5 * S::LENGTH)),
            0,
            "{}",
            S::name()
        );
        let heavy = || trio::<S>(1.0, [1e6, 2e6, 1.5e6]);
        let thrown = reports(scheme, heavy(), pull(1.0, least));
        assert!(!fixed || thrown > 0, "{} {scheme:?}: not thrown", S::name());
        reports(scheme, heavy(), pull(1.0, 0.5));
        reports(scheme, heavy(), pull(1e3, 0.5));
    }
}

#[test]
fn bodies_a_unit_apart_are_thrown_no_further_than_the_range() {
    check_close::<f32>(false);
    check_close::<f64>(false);
    check_close::<I16F16>(true);
    check_close::<I12F20>(true);
    check_close::<I8F24>(true);
    check_close::<I20F12>(true);
}

/// What the constructor accepts is right: two grams, so near each other that the coefficient is at the
/// end of its range before their mass joins it, against `h G m d / s³` in `f64`. One rounding a kick.
fn check_grams<S: Scale>() {
    let least = least_softening::<S>(1.0);
    for i in 0..16 {
        let distance = [1.0, 2.0, 5.0, 20.0][i % 4] * least * (1.0 + spread(i));
        let distance = scalar::<S>(distance).to_f64();
        let (mass, still) = (1e-3, [0.0; 2]);
        let mut world: World<_, 2> = world([
            point(still, still, mass),
            point([distance, 0.0], still, mass),
        ]);
        let mut pull = pull::<S>(1.0, least);
        step(&mut world, Scheme::SemiImplicitEuler, &mut pull);
        let s = distance.hypot(scalar::<S>(least).to_f64());
        let m = 1.0 / world.bodies()[1].inv_mass().to_f64();
        let exact = m * distance / (60.0 * s * s * s);
        let got = world.bodies()[0].velocity().x.to_f64();
        // Six roundings of 2^-24 in f32; those of fixed point, of 2^-30, are less.
        let bound = 0.5 * S::unit(exact) + exact * 6.0 * 2.0_f64.powi(-24);
        let error = (got - exact).abs();
        assert!(error <= bound, "{} {i}: {got} for {exact}", S::name());
    }
}

#[test]
fn what_a_pull_accepts_it_does_right() {
    check_grams::<f32>();
    check_grams::<f64>();
    check_grams::<I16F16>();
    check_grams::<I12F20>();
    check_grams::<I8F24>();
    check_grams::<I20F12>();
}

/// `G/ε³` is refused where it would become infinite: 1e18 kg do the worst they can. What they throw
/// stays finite in the first step, and whatever becomes infinite later is reported.
#[test]
fn absurd_masses_in_a_float_are_reported() {
    for (scheme, apart) in SCHEMES.into_iter().flat_map(|s| [(s, 0.0), (s, 1.0)]) {
        let mut world = trio::<f32>(apart, [1e18; 3]);
        let mut pull = pull::<f32>(1.0, 1e-6);
        step(&mut world, scheme, &mut pull);
        assert_eq!(world.out_of_range().count(), 0, "{scheme:?}");
        reports(scheme, world, pull);
    }
}
