//! A cannon ball in air: which elevation carries it farthest, in fixed point and in `f32`.
//! `cargo run --example cannon` prints ranges and draws the paths.
mod picture;

use fixstep::fixed::types::I16F16;
use fixstep::{GravityY, Point, QuadraticDrag, Ratio, Scalar, Step, Vec2, Verlet, World};
use fixstep::{dec, vec2};
use picture::{BLUE, GREY, Picture, VERMILION};

pub const SPEED: f64 = 100.0; // m/s
/// Half the density of air times the ball's cross-section times its drag coefficient, kg/m.
pub const AIR: Ratio = dec!(0.0031);
pub const VACUUM: Ratio = Ratio::ZERO;

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

/// From the muzzle to the first position below the ground.
pub fn fly<S: Scalar>(degrees: u32, drag: Ratio) -> Fallible<Vec<Vec2<f64>>> {
    let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
    let velocity = vec2(Ratio::from_f64(SPEED * cos)?, Ratio::from_f64(SPEED * sin)?)?;
    let mut world = World::<Point<S>, 1>::new();
    let ball = world.add(Point::new(Vec2::ZERO, velocity, dec!(5.4))?)?;
    let mut forces = (GravityY::new(dec!(-9.81))?, QuadraticDrag::new(drag)?);
    let step = Step::hz(60)?;

    let mut path = vec![Vec2::ZERO];
    while path.last().is_some_and(|at| at.y >= 0.0) {
        world.step(&mut Verlet, &mut forces, &step);
        path.push(world.get(ball)?.position().to_f64());
    }
    Ok(path)
}

/// How far it flies, m: to where the last piece of its path meets the ground.
pub fn range<S: Scalar>(degrees: u32, drag: Ratio) -> Fallible<f64> {
    let path = fly::<S>(degrees, drag)?;
    let (above, below) = (path[path.len() - 2], path[path.len() - 1]);
    Ok(above.x + (below.x - above.x) * above.y / (above.y - below.y))
}

fn main() -> Fallible<()> {
    let mut best = 1;
    while range::<I16F16>(best + 1, AIR)? > range::<I16F16>(best, AIR)? {
        best += 1;
    }
    let title = format!("100 m/s in air, at 15° to 75°: {best}° carry farthest");
    let mut picture = Picture::new(&title, ["distance, m", "height, m"]);
    println!("elevation   without air   in air, f32   in air, I16F16");
    for degrees in [15, 25, 35, best, 55, 65, 75] {
        let (vacuum, float) = (range::<f32>(degrees, VACUUM)?, range::<f32>(degrees, AIR)?);
        let fixed = range::<I16F16>(degrees, AIR)?;
        println!("{degrees:8}° {vacuum:11.2} m {float:11.2} m {fixed:14.2} m");
        let name = if degrees == best { "farthest" } else { "" };
        let color = if degrees == best { VERMILION } else { BLUE };
        picture.line(color, name, &fly::<I16F16>(degrees, AIR)?);
    }
    picture.dashes(GREY, "45° without air", &fly::<f32>(45, VACUUM)?);
    picture.save("cannon")
}
