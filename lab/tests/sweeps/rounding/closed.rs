//! Coarse orbits close. A step of Verlet is a permutation of the grid: each drift and each kick can be
//! taken back, to the bit. It is odd, and with v turned round it runs backwards. So an orbit that meets
//! its own mirror image, as where x or v is exactly zero, runs back along it, and one that does so
//! twice is closed: what rounding does to its energy goes round in a circle as well.

use fixstep::fixed::types::I16F16;
use fixstep::{DyadicStep, PerBody, Point, Time, Vec2, World};

use crate::rounding::duffing::{STARTS, force, start};
use crate::support::*;

const STEPS: u32 = 1_000_000;

/// Position and velocity of each start, in units.
fn states(world: &World<Point<I16F16>, 16>) -> [[i32; 2]; STARTS] {
    std::array::from_fn(|i| {
        let body = &world.bodies()[i / 2];
        [body.position(), body.velocity()].map(|pair| pair.array()[i % 2].units())
    })
}

/// For each start, the step at which it is back, on its own side or on the other.
fn returns() -> [Option<u32>; STARTS] {
    let body = |i: usize| {
        let ([x, vx], [y, vy]) = (start(2 * i), start(2 * i + 1));
        point([x, y], [vx, vy], 1.0)
    };
    let mut world: World<Point<I16F16>, 16> = world(std::array::from_fn(body));
    let starts = states(&world);
    let pull = |_: Time, body: &Point<I16F16>| -> Vec2<I16F16> { body.position().map(force) };
    let (mut method, mut force) = (Scheme::Verlet.method(), PerBody(pull));
    let step = DyadicStep::<I16F16, 1, 6>::new().unwrap();
    let mut back = [None; STARTS];
    for n in 1..=STEPS {
        world.step(&mut method, &mut force, &step);
        for ((state, start), back) in states(&world).iter().zip(&starts).zip(&mut back) {
            let returned = state == start || *state == start.map(|s| -s);
            *back = back.or(returned.then_some(n));
        }
    }
    back
}

/// v passes zero twice a period by about `h a` units, 1000 to 10000 of them, and x by `h v`: an orbit
/// meets a mirror image about once in 1000 to 10000 half periods of 100 steps, so that most have met
/// two of them in 10⁶ steps. An orbit of random steps would come back to one of 10¹⁰ states never.
#[test]
fn most_orbits_of_a_coarse_grid_return_to_the_bit() {
    let back = returns();
    let closed = back.iter().flatten().count();
    println!("{closed} of {STARTS} orbits closed: {back:?}");
    assert!(closed > STARTS / 2);
}
