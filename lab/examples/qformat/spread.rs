//! Whether an error can be told at all: how far the scene itself spreads a small change.
//!
//! A change dv of a velocity moves a free body by `dv T` in the time T. Springs and drags spread it less, an
//! orbit about three times as far. A scene that spreads it far more than free motion stretches each
//! rounding on its way too, and most along one direction: which way the first roundings went then
//! decides the end, and no median speaks for a single run. From [`TOO_FAR`] on no error is stated. Of
//! the 100 scenes drawn in the tests six are such scenes; that many are allowed to be ten.

use std::f64::consts::TAU;

use fixstep::{Body, Error, Force, Step, Vec2, World};

use crate::flight::{ARM, Plan, Track};
use crate::noted::Noted;
use crate::recorded::Recorded;

/// The spread from which on the error is anyone's guess.
pub const TOO_FAR: f64 = 32.0;

/// How many times as far as free motion the scene spreads a change of any velocity, `change` m/s.
pub fn spread<F: Force<Noted>, const N: usize>(
    build: &impl Fn(&mut World<Noted, N>) -> Result<F, Error>,
    plan: &Plan,
    change: f64,
) -> Result<f64, Error> {
    let fly = |place: usize, [x, y, spin]: [f64; 3]| -> Result<(Track, Vec<bool>), Error> {
        let mut world = World::new();
        let mut forces = build(&mut world)?;
        if let Some((_, body)) = world.iter_mut().nth(place) {
            body.kick(Vec2::new(x, y).map(Recorded));
            body.twist(Recorded(spin));
        }
        let turns = world.bodies().iter().map(Noted::can_turn).collect();
        let track = plan.fly(&mut world, &mut forces, &Step::hz(plan.rate)?)?;
        Ok((track, turns))
    };
    let (unchanged, turns) = fly(0, [0.0; 3])?;
    let mut most = 0.0_f64;
    // At the arm a spin is as fast as the speeds.
    let spin = change / (TAU * ARM);
    let changes = [[change, 0.0, 0.0], [0.0, change, 0.0], [0.0, 0.0, spin]];
    for (place, turns) in turns.into_iter().enumerate() {
        for by in changes.into_iter().take(2 + usize::from(turns)) {
            let (changed, _) = fly(place, by)?;
            most = most.max(plan.apart(&changed, &unchanged));
        }
    }
    // Nothing moves and nothing is anywhere: nothing spreads.
    Ok(if most == 0.0 {
        0.0
    } else {
        most / (change * plan.seconds)
    })
}
