//! Colour and health of bodies: an array of your own beside the world, kept in step with it.
//! `cargo run --example tags`
use fixstep::fixed::types::I16F16;
use fixstep::{BodyId, Full, GravityY, Point, Stale, Step, Vec2, Verlet, World};
use fixstep::{dec, heapless, vec2};

type Ball = Point<I16F16>;

/// Bodies and their tags. Tag `i` belongs to body `i` of `world.bodies()`, whose id is
/// `world.ids()[i]`: a new body comes last, and behind one that goes the others move up.
#[derive(Default)]
pub struct Tagged<T, const N: usize> {
    pub world: World<Ball, N>,
    pub tags: heapless::Vec<T, N>,
}

impl<T, const N: usize> Tagged<T, N> {
    pub fn add(&mut self, ball: Ball, tag: T) -> Result<BodyId, Full<Ball>> {
        let id = self.world.add(ball)?;
        let _ = self.tags.push(tag); // there is as much room as in the world
        Ok(id)
    }

    pub fn remove(&mut self, id: BodyId) -> Result<(Ball, T), Stale> {
        let place = self.world.index_of(id)?;
        Ok((self.world.remove(id)?, self.tags.remove(place)))
    }

    pub fn tag(&mut self, id: BodyId) -> Result<&mut T, Stale> {
        let place = self.world.index_of(id)?;
        self.tags.get_mut(place).ok_or(Stale(id))
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut scene = Tagged::<(&str, u32), 3>::default();
    let ball = |x| Ball::new(vec2(x, 10)?, Vec2::ZERO, 1);
    let red = scene.add(ball(1)?, ("red", 3))?;
    let green = scene.add(ball(2)?, ("green", 3))?;
    scene.add(ball(3)?, ("blue", 3))?;
    scene.tag(green)?.1 -= 1;
    scene.remove(red)?;
    scene.add(ball(4)?, ("yellow", 9))?;
    let (mut gravity, step) = (GravityY::new(dec!(-9.81))?, Step::hz(60)?);
    scene.world.step(&mut Verlet, &mut gravity, &step);

    for ((id, ball), (colour, health)) in scene.world.iter().zip(&scene.tags) {
        let (serial, height) = (id.serial(), ball.position().y);
        println!("body {serial}: {colour:6} health {health}, at {height:.4} m");
    }
    if let Err(stale) = scene.tag(red) {
        println!("{stale}, though another body has its place");
    }
    Ok(())
}
