//! A lander on the Moon: its engine reads the altitude, and frames take as long as they like.
//! `cargo run --example lander` prints the touchdown and draws what the player sees.
mod picture;

use fixstep::fixed::types::I16F16;
use fixstep::{Accumulator, Between, GravityY, PerBody, Point, Scalar, Step, Time};
use fixstep::{Vec2, Verlet, World, dec, vec2};
use picture::{BLUE, Picture, VERMILION};

pub const FRAMES: [u64; 5] = [16_200, 24_900, 8_400, 33_300, 11_000]; // µs, again and again
/// Time in s and altitude in m at each frame, with the engine off and on.
type Seen = [Vec<Vec2<f64>>; 2];
type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

/// Braking at 2 m/s² would no longer stop the lander above the ground: `v² > 2 a y`.
fn must_brake(lander: &Point<I16F16>) -> bool {
    let (y, v) = (lander.position().y, lander.velocity().y);
    v < 0 && v.times(v) > y.times(I16F16::lit("4"))
}

/// Speed at touchdown (m/s), steps made and dropped, and what the player sees.
pub fn land() -> Fallible<(f64, [u64; 2], Seen)> {
    let mut world = World::<Point<I16F16>, 1>::new();
    let id = world.add(Point::new(vec2(0, 150)?, vec2(0, -5)?, 100)?)?;
    let (off, on) = (Vec2::ZERO, vec2(0, 400)?);
    let engine = |_: Time, lander: &_| if must_brake(lander) { on } else { off };
    let mut forces = (GravityY::new(dec!(-1.62))?, PerBody(engine));
    let step = Step::<I16F16>::hz(60)?;
    let mut clock = Accumulator::new(1_000_000, step.seconds(), 4)?;
    let (mut before, mut i, mut time) = (world.clone(), 0, 0.0);
    let (mut steps, mut seen) = ([0; 2], Seen::default());
    while world.get(id)?.position().y > 0 {
        i += 1;
        let frame = if i == 300 { 400_000 } else { FRAMES[i % 5] };
        let due = clock.advance(frame);
        for _ in 0..due.steps {
            if world.get(id)?.position().y > 0 {
                before.clone_from(&world);
                world.step(&mut Verlet, &mut forces, &step);
                steps[0] += 1;
            }
        }
        time += frame as f64 * 1e-6;
        steps[1] += due.dropped;
        let part = Between::new(clock.fraction(), &step)?;
        for ((_, at), lander) in world.between(&before, &Verlet, &part).zip(world.bodies()) {
            seen[usize::from(must_brake(lander))].push(Vec2::new(time, at.y.to_f64()));
        }
    }
    Ok((-world.get(id)?.velocity().y.to_f64(), steps, seen))
}

fn main() -> Fallible<()> {
    let (speed, [made, dropped], [off, on]) = land()?;
    println!("touchdown at {speed:.2} m/s, {made} steps made and {dropped} dropped");
    let mut picture = Picture::new("Moon landing, with one stall", ["time, s", "altitude, m"]);
    picture.dots(BLUE, "engine off", &off);
    picture.dots(VERMILION, "engine on", &on);
    picture.save("lander")
}
