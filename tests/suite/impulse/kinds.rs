//! Bodies that no force moves, and bodies that nothing turns.

use fixstep::rigid::Kind;
use fixstep::rigid::torque::{Attached, SpinDrag, Torque, Wrench};
use fixstep::{
    AllPairs, Anchor, Angle, Ballistic, BodyId, Decay, DyadicStep, ExactDrag, ExactPair,
    ExactQuadraticDrag, ExactSpring, Force, Gravity, GravityY, LinearDrag, Method, Pairs, PerBody,
    Pull, Push, QuadraticDrag, Spring, Time, World,
};

use super::*;

const STEPS: u32 = 640;

type Hz64<S> = DyadicStep<S, 1, 6>;

/// A body that is driven, one that stands, one that flies, and one that flies and is locked.
fn scene<C: Middle>() -> World<Rigid<C>, 4> {
    let mut driven = Rigid::kinematic(vector(-2.0, 1.0), vector(0.5, -0.25)).unwrap();
    driven.set_angle(Angle::turns(dec!(0.125)));
    driven.set_spin(scalar(-0.375)).unwrap();
    let wall = Rigid::static_at(vector(3.0, -1.0)).unwrap();
    let wall = wall.with_angle(Angle::turns(dec!(0.3)));
    let centre = |x: f64| C::from(point([x, 2.0], [0.3, -0.2], 1.7));
    let free = Rigid::new(centre(1.0), dec!(0.6)).unwrap();
    let locked = Rigid::locked(centre(-1.0)).with_spin(dec!(0.25)).unwrap();
    assert_eq!(
        [driven, wall, free, locked].map(|body: Rigid<C>| body.kind()),
        [Kind::Kinematic, Kind::Static, Kind::Dynamic, Kind::Dynamic]
    );
    world([driven, wall, free, locked])
}

/// Every force that pushes or brakes, on all bodies that it can name.
fn forces<B: Rotating<S: Decay>>(ids: &[BodyId]) -> impl Force<B> + use<B> {
    let [driven, wall, free, locked] = ids[..] else {
        unreachable!()
    };
    let spring = || Spring::new(dec!(0.7), 5, dec!(0.9)).unwrap();
    let pairs = [
        [free, driven],
        [wall, free],
        [locked, driven],
        [driven, wall],
    ];
    let attached = Attached {
        spring: spring(),
        at: [vector(0.4, 0.1), vector(-0.2, 0.3)],
    };
    let anchor = |id| Anchor::new(id, vector(1.0, 1.0), 7, dec!(0.3)).unwrap();
    let (torque, push) = (scalar(1.3), vector(0.7, -0.4));
    (
        (
            Gravity::new(vector(0.9, -2.0)),
            GravityY::new(-1).unwrap(),
            PerBody(move |_: Time, _: &B| Wrench {
                force: push,
                torque,
            }),
        ),
        (
            LinearDrag::new(dec!(0.4)).unwrap(),
            QuadraticDrag::new(dec!(0.2)).unwrap(),
            ExactDrag::new(dec!(0.3)).unwrap(),
            ExactQuadraticDrag::new(dec!(0.1)).unwrap(),
            SpinDrag::new(dec!(0.2)).unwrap(),
        ),
        (Pairs::new(spring(), pairs), Pairs::new(attached, pairs)),
        AllPairs(Pull::new(2, dec!(0.5)).unwrap()),
        [driven, wall, free].map(anchor),
        [driven, wall, free, locked].map(|body| (Push::new(body, push), Torque { body, torque })),
    )
}

/// The driven body goes on by its own velocity and spin, exactly: `h v` and `h s` have the bits. A `Pefrl`
/// step is five shares, each rounded: its bodies are those of a world without forces.
fn check_driven<C: Middle>(name: &str, exactly: bool, world: &[Rigid<C>], free: &[Rigid<C>]) {
    assert_eq!(world[..2], free[..2], "{name}");
    if exactly {
        let seconds = f64::from(STEPS) / 64.0;
        let at = vector(-2.0 + 0.5 * seconds, 1.0 - 0.25 * seconds);
        assert_eq!(world[0].position(), at, "{name}");
        let turns = Angle::turns(ratio(0.125 - 0.375 * seconds));
        assert_eq!(world[0].angle(), turns, "{name}");
    }
    assert_eq!(world[0].velocity(), vector(0.5, -0.25), "{name}");
    assert_eq!(world[0].spin(), scalar(-0.375), "{name}");
    assert_eq!(world[1].position(), vector(3.0, -1.0), "{name}");
    assert_eq!(world[1].angle(), Angle::turns(dec!(0.3)), "{name}");
    assert_ne!(world[2].velocity(), free[2].velocity(), "{name}");
}

/// Nothing turns a locked body: its spin is the one that it was given.
fn check_locked<C: Middle>(name: &str, exactly: bool, world: &[Rigid<C>], free: &[Rigid<C>]) {
    assert_ne!(world[3].velocity(), free[3].velocity(), "{name}");
    assert_eq!(world[3].spin(), scalar(0.25), "{name}");
    assert_eq!(world[3].angle(), free[3].angle(), "{name}");
    if exactly {
        let turns = Angle::turns(ratio(0.25 * f64::from(STEPS) / 64.0));
        assert_eq!(world[3].angle(), turns, "{name}");
    }
}

fn fly<C: Centre, F: Force<Rigid<C>>>(
    mut world: World<Rigid<C>, 4>,
    mut method: impl Method<Rigid<C>, 4>,
    mut forces: F,
) -> World<Rigid<C>, 4> {
    let step = Hz64::new().unwrap();
    (0..STEPS).for_each(|_| world.step(&mut method, &mut forces, &step));
    world
}

fn check<C: Middle>() {
    for scheme in ALL_SCHEMES {
        let (name, start) = (format!("{} {scheme:?}", C::S::name()), scene::<C>());
        let free = fly(start.clone(), scheme.method(), ());
        let pushed = fly(start.clone(), scheme.method(), forces(start.ids()));
        let exactly = scheme != Scheme::Pefrl;
        check_driven(&name, exactly, pushed.bodies(), free.bodies());
        check_locked(&name, exactly, pushed.bodies(), free.bodies());
        assert_ne!(pushed.bodies()[2].spin(), C::S::ZERO, "{name}");
    }
}

#[test]
fn no_force_moves_what_is_driven_or_turns_what_is_locked() {
    check::<Point<I16F16>>();
    check::<Carried<I8F24>>();
    check::<Point<f32>>();
    check::<Carried<f32>>();
}

/// Flows move bodies in place of their drift: not those.
fn check_flows<C: Middle>() {
    let start = scene::<C>();
    let [driven, wall, free, locked] = start.ids()[..] else {
        unreachable!()
    };
    let spring = |id| ExactSpring::new(id, vector(1.0, 0.5), 2, dec!(0.1)).unwrap();
    let springs = [driven, wall, free, locked].map(spring);
    let pair = |a, b| ExactPair::new([a, b], vector(0.8, 0.1), 2, dec!(0.1)).unwrap();
    // The first two do nothing.
    let pairs = [pair(driven, free), pair(wall, locked), pair(free, locked)];
    let air = || Ballistic::new(vector(0.3, -2.0), dec!(0.4)).unwrap();
    for scheme in [Scheme::SemiImplicitEuler, Scheme::Verlet] {
        let alone = fly(start.clone(), scheme.method(), ());
        let worlds = match scheme {
            Scheme::Verlet => [
                fly(start.clone(), fixstep::Verlet, springs),
                fly(start.clone(), fixstep::Verlet, pairs),
                fly(start.clone(), fixstep::Verlet, air()),
            ],
            _ => [
                fly(start.clone(), fixstep::SemiImplicitEuler, springs),
                fly(start.clone(), fixstep::SemiImplicitEuler, pairs),
                fly(start.clone(), fixstep::SemiImplicitEuler, air()),
            ],
        };
        for (world, flow) in worlds.iter().zip(["springs", "pairs", "air"]) {
            let name = format!("{} {scheme:?} {flow}", C::S::name());
            check_driven(&name, true, world.bodies(), alone.bodies());
            check_locked(&name, true, world.bodies(), alone.bodies());
        }
    }
}

#[test]
fn no_flow_moves_what_is_driven() {
    check_flows::<Point<I16F16>>();
    check_flows::<Carried<I8F24>>();
    check_flows::<Point<f32>>();
}
