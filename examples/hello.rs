//! The scene of the README: a ball thrown into drag, in fixed point.

use fixstep::fixed::types::I16F16;
use fixstep::{GravityY, LinearDrag, Point, Step, Verlet, World, dec, vec2};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut world = World::<Point<I16F16>, 8>::new();
    let ball = world.add(Point::new(vec2(0, 2)?, vec2(12, 9)?, dec!(0.45))?)?;
    let mut forces = (GravityY::new(dec!(-9.81))?, LinearDrag::new(dec!(0.1))?);
    let step = Step::hz(60)?;

    for tick in 0..=60 {
        if tick % 15 == 0 {
            let at = world.get(ball)?.position();
            println!(
                "{:.2} s: {:5.2} m, {:5.2} m",
                tick as f32 / 60.0,
                at.x,
                at.y
            );
        }
        world.step(&mut Verlet, &mut forces, &step);
    }
    Ok(())
}
