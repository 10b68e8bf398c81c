//! The scene of `scene.c` without the C face: `check` compares the hashes.

use fixstep::fixed::types::I16F16;
use fixstep::{
    DyadicStep, Error, Gravity, LinearDrag, Point, Ratio, SemiImplicitEuler, World, vec2,
};

/// What `FIXSTEP` makes of a constant: the nearest of 1/65536.
fn of_16_bits(number: f64) -> Result<Ratio, Error> {
    Ok(Ratio::new((number * 65536.0).round() as i64, 65536)?)
}

fn main() -> Result<(), Error> {
    let mut world = World::<Point<I16F16>, 32>::new();
    for i in 0..32 {
        let mass = Ratio::new((2 + i).into(), 4)?;
        world.add(Point::new(vec2(i - 16, 60 + i)?, vec2(16 - i, 0)?, mass)?)?;
    }
    let mut forces = (
        Gravity::new(vec2(0, of_16_bits(-9.81)?)?),
        LinearDrag::new(of_16_bits(0.1)?)?,
    );
    let step = DyadicStep::<I16F16, 1, 6>::new()?;
    for _ in 0..600 {
        world.step(&mut SemiImplicitEuler, &mut forces, &step);
    }
    println!("{:016x}", world.state_hash());
    Ok(())
}
