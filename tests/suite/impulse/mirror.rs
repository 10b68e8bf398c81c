//! A scene in a mirror: x, angles and spins with the other sign. To the bit, with every method.

use fixstep::rigid::torque::{Attached, SpinDrag, Torque};
use fixstep::{
    Angle, BodyId, Decay, DyadicStep, ExactDrag, Force, GravityY, LinearDrag, Pairs, Spring, Step,
    TimeStep, World,
};

use super::*;

const STEPS: u32 = 900;

/// `x -> -x` or not.
#[derive(Clone, Copy)]
struct Mirror(bool);

impl Mirror {
    fn vector<S: Scalar>(self, x: f64, y: f64) -> Vec2<S> {
        vector(self.value(x), y)
    }

    fn value(self, value: f64) -> f64 {
        if self.0 { -value } else { value }
    }
}

/// Two bodies that fly and turn, and a wall.
fn scene<C: Middle>(mirror: Mirror) -> World<Rigid<C>, 3> {
    let body = |x: f64, spin: f64, mass: f64| {
        let (at, velocity) = (mirror.vector(x, 0.3 * x), mirror.vector(0.7, 2.0 - x));
        let centre = Point::new(at, velocity, ratio(mass)).unwrap();
        let body = Rigid::new(C::from(centre), ratio(0.37 * mass)).unwrap();
        let body = body.with_angle(Angle::turns(ratio(mirror.value(0.1 * x))));
        body.with_spin(ratio(mirror.value(spin))).unwrap()
    };
    let wall = Rigid::static_at(mirror.vector(-1.3, 2.1)).unwrap();
    world([body(1.0, 1.7, 0.9), body(3.1, -0.6, 2.3), wall])
}

fn forces<B: Rotating<S: Decay>>(mirror: Mirror, ids: &[BodyId]) -> impl Force<B> + use<B> {
    let [a, b, wall] = ids[..] else {
        unreachable!()
    };
    let attached = |length, at: [[f64; 2]; 2]| Attached {
        spring: Spring::new(ratio(length), ratio(11.0), ratio(1.3)).unwrap(),
        at: at.map(|[x, y]| mirror.vector(x, y)),
    };
    let torque = scalar(mirror.value(2.7));
    (
        GravityY::new(ratio(-3.7)).unwrap(),
        ExactDrag::new(ratio(0.2)).unwrap(),
        LinearDrag::new(ratio(0.1)).unwrap(),
        SpinDrag::new(ratio(0.05)).unwrap(),
        Pairs::new(attached(1.1, [[0.4, 0.2], [-0.5, 0.1]]), [[a, b]]),
        (
            Pairs::new(attached(0.7, [[0.3, -0.6], [0.2, 0.0]]), [[b, wall]]),
            Torque { body: b, torque },
        ),
    )
}

/// All that is seen of a body.
type Seen<C> = (
    Vec2<<C as Body>::S>,
    Vec2<<C as Body>::S>,
    Angle<<C as Body>::S>,
    <C as Body>::S,
);

fn mirrored<C: Centre>(body: &Rigid<C>) -> Seen<C> {
    let across = |v: Vec2<C::S>| Vec2::new(v.x.negated(), v.y);
    let (angle, spin) = (-body.angle(), body.spin().negated());
    (
        across(body.position()),
        across(body.velocity()),
        angle,
        spin,
    )
}

/// A blow on the first body, off its centre.
fn hit<C: Middle>(world: &mut World<Rigid<C>, 3>, mirror: Mirror) {
    let (arm, impulse) = (mirror.vector(0.37, 0.81), mirror.vector(-0.53, 0.29));
    let first = world.ids()[0];
    world.get_mut(first).unwrap().push_off(arm, impulse);
}

fn check<C: Middle>(what: &str) {
    check_with::<C>(what, &Step::hz(60).unwrap());
    check_with::<C>(what, &DyadicStep::<_, 1, 6>::new().unwrap());
}

fn check_with<C: Middle>(what: &str, step: &impl TimeStep<C::S>) {
    for scheme in ALL_SCHEMES {
        let name = format!("{} {what} {scheme:?}", C::S::name());
        let [mut plain, mut other] = [false, true].map(|side| scene::<C>(Mirror(side)));
        let mut left = forces::<Rigid<C>>(Mirror(false), plain.ids());
        let mut right = forces::<Rigid<C>>(Mirror(true), other.ids());
        let [mut here, mut there] = [scheme.method(), scheme.method()];
        let mut turns = 0.0;
        for tick in 0..STEPS {
            if tick % 97 == 0 {
                hit(&mut plain, Mirror(false));
                hit(&mut other, Mirror(true));
            }
            plain.step(&mut here, &mut left, step);
            other.step(&mut there, &mut right, step);
            for (a, b) in plain.bodies().iter().zip(other.bodies()) {
                let seen = (b.position(), b.velocity(), b.angle(), b.spin());
                assert_eq!(mirrored(a), seen, "{name}, tick {tick}");
            }
            turns += plain.bodies()[0].spin().to_f64().abs() / 60.0;
        }
        println!("{name}: {turns:.1} turns alike");
        assert!((2.0..=1e3).contains(&turns), "{name}: {turns} turns");
    }
}

#[test]
fn a_scene_in_a_mirror_is_mirrored() {
    check::<Point<I16F16>>("Point");
    check::<Carried<I8F24>>("Carried");
    check::<Point<f32>>("Point");
    check::<Carried<f32>>("Carried");
    check::<Point<f64>>("Point");
}
