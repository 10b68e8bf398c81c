//! One pendulum, released at rest, and what is read off its swings.
//!
//! Swings are counted from one passage of the lowest point to the right to the next. There θ'' = 0, so that a chord
//! through two ticks is off by 0.064 h³ θ''' at most: 1e-9 of the period over a minute.

use fixstep::rigid::Centre;
use fixstep::{Angle, Error, GravityY, Point, Ratio, Rigid, Step, Vec2, Verlet, World, dec, vec2};

use crate::hinge::Hinge;

/// Gravity, m/s².
pub const FALL: Ratio = dec!(-9.81);
/// Half the length of the rod, from its centre to the pin, m.
pub const ARM: Ratio = dec!(0.5);
/// Of the rod, kg.
pub const MASS: Ratio = dec!(3);
/// `m l² / 12`, about its centre, kg m².
pub const INERTIA: Ratio = dec!(0.25);
/// `I m / (I + m l²/4)`, a quarter of the mass, kg.
pub const AT_THE_PIN: Ratio = dec!(0.75);
/// How long it swings, s.
pub const SECONDS: u32 = 60;

/// What is measured.
#[derive(Clone, Copy, Debug)]
pub struct Swing {
    /// The mean of all whole swings, s.
    pub period: f64,
    /// Mean energy of the last whole swing less that of the first, as a part of what the release gave.
    pub drift: f64,
}

/// The pendulum at a tick.
struct Sample {
    /// From -1/2 to 1/2.
    turns: f64,
    /// J.
    energy: f64,
}

/// Swings for [`SECONDS`] by `degrees` to both sides, at `rate` steps a second.
pub fn swing<C: Centre + From<Point<C::S>>>(degrees: u32, rate: u32) -> Result<Swing, Error> {
    let mut world = World::<Rigid<C>, 1>::new();
    let rod = C::from(Point::new(Vec2::ZERO, Vec2::ZERO, MASS)?);
    let tilt = Angle::degrees(degrees as i32);
    let rod = world.add(Rigid::new(rod, INERTIA)?.with_angle(tilt))?;
    let hinge = Hinge::new(rod, Vec2::ZERO, vec2(0, ARM)?, AT_THE_PIN)?;
    hinge.hold(world.get_mut(rod)?);
    let (mut forces, step) = ((GravityY::new(FALL)?, hinge), Step::hz(rate as i32)?);

    let mut samples = Vec::new();
    for _ in 0..SECONDS * rate {
        world.step(&mut Verlet, &mut forces, &step);
        samples.push(Sample {
            turns: world.get(rod)?.angle().to_f64(),
            energy: world.kinetic_energy() + world.potential_energy(&forces),
        });
    }
    let lift = ARM.to_f64() * (1.0 - f64::from(degrees).to_radians().cos());
    Ok(Swing {
        period: period(&samples) / f64::from(rate),
        drift: drift(&samples) / (-FALL.to_f64() * MASS.to_f64() * lift),
    })
}

/// Ticks behind which the rod passes its lowest point to the right, and the part of a step until then.
fn passages(samples: &[Sample]) -> Vec<(usize, f64)> {
    let pairs = samples.windows(2).enumerate();
    pairs
        .filter(|(_, ends)| ends[0].turns < 0.0 && ends[1].turns >= 0.0)
        .map(|(tick, ends)| (tick, ends[0].turns / (ends[0].turns - ends[1].turns)))
        .collect()
}

/// In ticks; NaN where there is no whole swing.
fn period(samples: &[Sample]) -> f64 {
    let passages = passages(samples);
    match passages[..] {
        [(first, after), .., (last, more)] => {
            ((last - first) as f64 + (more - after)) / (passages.len() - 1) as f64
        }
        _ => f64::NAN,
    }
}

/// J; NaN where there are no two swings. A mean takes the ripple out that Verlet's energy has in each
/// swing.
fn drift(samples: &[Sample]) -> f64 {
    let mean = |from: usize, to: usize| {
        let energies = samples[from..to].iter().map(|sample| sample.energy);
        energies.sum::<f64>() / (to - from) as f64
    };
    match passages(samples)[..] {
        [(a, _), (b, _), .., (y, _), (z, _)] => mean(y, z) - mean(a, b),
        _ => f64::NAN,
    }
}
