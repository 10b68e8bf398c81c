//! A planet and two moons that pull each other: periods beside Kepler's, and the energy's drift.
//! `cargo run --example orbit` prints them and draws the orbits.
mod picture;

use fixstep::{AllPairs, Point, Pull, Step, Vec2, Verlet, World, dec, vec2};
use picture::{BLUE, GREEN, Picture, VERMILION};

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;
const RATE: i32 = 240; // Hz

/// The paths of the moons for 100 s, as seen from the planet, and what part the energy changes.
/// In `f32`: a moon of a gram gives the planet a unit or so of fixed point in a step.
pub fn orbit() -> Fallible<([Vec<Vec2<f64>>; 2], f64)> {
    let mut world = World::<Point<f32>, 3>::new();
    let planet = world.add(Point::new(Vec2::ZERO, Vec2::ZERO, 100)?)?;
    let circle = Point::new(vec2(3, 0)?, vec2(0, dec!(5.7735))?, dec!(0.001))?;
    let ellipse = Point::new(vec2(14, 0)?, vec2(0, dec!(2.0702))?, dec!(0.001))?;
    let moons = [world.add(circle)?, world.add(ellipse)?];
    let mut pull = AllPairs(Pull::new(1, dec!(0.001))?);
    let step = Step::hz(RATE)?;

    let before = world.kinetic_energy() + world.potential_energy(&pull);
    let mut paths = [vec![], vec![]];
    for _ in 0..100 * RATE {
        let centre = world.get(planet)?.position();
        for (path, moon) in paths.iter_mut().zip(moons) {
            path.push((world.get(moon)?.position() - centre).to_f64());
        }
        world.step(&mut Verlet, &mut pull, &step);
    }
    let after = world.kinetic_energy() + world.potential_energy(&pull);
    Ok((paths, after / before - 1.0))
}

/// The mean time of a turn, s: from the start on the x axis to the last passage upwards.
pub fn period(path: &[Vec2<f64>]) -> f64 {
    let (mut turns, mut ticks) = (0.0, 0.0);
    for (tick, ends) in path.windows(2).enumerate() {
        let (y0, y1) = (ends[0].y, ends[1].y);
        if y0 < 0.0 && y1 >= 0.0 {
            (turns, ticks) = (turns + 1.0, tick as f64 + y0 / (y0 - y1));
        }
    }
    ticks / turns / f64::from(RATE)
}

fn main() -> Fallible<()> {
    let ([circle, ellipse], change) = orbit()?;
    for (name, path, axis) in [("circle", &circle, 3.0_f64), ("ellipse", &ellipse, 10.0)] {
        let kepler = std::f64::consts::TAU * (axis.powi(3) / 100.0).sqrt();
        println!("{name:7}: {:.3} s, Kepler {kepler:.3} s", period(path));
    }
    println!("energy : {:+.1} millionths", change * 1e6);
    let axes = ["x, m", "y, m"];
    let mut picture = Picture::new("Two moons and their planet", axes).with_equal_axes();
    picture.line(BLUE, "circle", &circle);
    picture.line(GREEN, "ellipse", &ellipse);
    picture.dots(VERMILION, "planet", &[Vec2::ZERO]);
    picture.save("orbit")
}
