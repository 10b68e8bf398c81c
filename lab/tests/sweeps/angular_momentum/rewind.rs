//! Bodies that turn, on undamped springs off their centres, and back: to the bit.

use fixstep::{GravityY, Pefrl, RangeChecked, Rewinds, SemiImplicitEuler};

use super::*;

const STEPS: u64 = 10_000;

type Flyer = RangeChecked<Rigid<Point<I16F16>>>;

/// Three bodies and a wall.
fn scene() -> World<Flyer, 4> {
    let body = |i: usize| {
        let (x, y) = (1.5 * i as f64 - 1.0, 2.0 * spread(i));
        let centre: Point<I16F16> = point([x, y], [0.3, 1.0 - y], 0.8 + 0.7 * i as f64);
        let body = Rigid::new(centre, ratio(0.2 + 0.3 * i as f64)).unwrap();
        let body = body.with_angle(Angle::turns(ratio(spread(i + 5))));
        RangeChecked::new(body.with_spin(ratio(0.9 - spread(i + 9))).unwrap())
    };
    let wall = RangeChecked::new(Rigid::static_at(vector(1.0, 4.0)).unwrap());
    world([body(0), body(1), body(2), wall])
}

fn there_and_back(name: &str, mut method: impl Rewinds<Flyer, 4>) {
    let mut world = scene();
    let [a, b, c, wall] = world.ids()[..] else {
        unreachable!()
    };
    let attached = |length, k, at: [[f64; 2]; 2]| Attached {
        spring: Spring::new(ratio(length), ratio(k), 0).unwrap(),
        at: at.map(|[x, y]| vector(x, y)),
    };
    let mut forces = (
        Pairs::new(
            attached(1.1, 17.0, [[0.4, 0.2], [-0.3, 0.5]]),
            [[a, b], [b, c], [c, a]],
        ),
        Pairs::new(
            attached(2.0, 9.0, [[0.0, 0.6], [0.2, 0.1]]),
            [[a, wall], [c, wall]],
        ),
        GravityY::new(ratio(-9.81)).unwrap(),
    );
    let step = Step::hz(60).unwrap();
    let (start, mut kept) = (world.bodies().to_vec(), Vec::new());
    for tick in 0..STEPS {
        if tick % 100 == 0 {
            kept.push(world.bodies().to_vec());
        }
        world.step(&mut method, &mut forces, &step);
    }
    // Turned, and not by a few units.
    let turned = |i: usize| {
        (world.bodies()[i].angle() - start[i].angle())
            .to_f64()
            .abs()
    };
    assert!((0..3).all(|i| turned(i) >= 1e-3), "{name}: nothing turns");
    for tick in (0..STEPS).rev() {
        world.step_back(&mut method, &mut forces, &step).unwrap();
        if tick % 100 == 0 {
            assert_eq!(
                Some(world.bodies()),
                kept.pop().as_deref(),
                "{name}: {tick}"
            );
        }
    }
    assert!(world.tick() == 0 && kept.is_empty());
}

#[test]
fn bodies_that_turn_go_back() {
    there_and_back("Verlet", Verlet);
    there_and_back("SemiImplicitEuler", SemiImplicitEuler);
    there_and_back("Pefrl", Pefrl::new());
}
