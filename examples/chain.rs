//! A chain of springs swings down from a hook and comes to rest.
//! `cargo run --example chain` prints how far its links stretch and draws it on its way.

mod picture;

use fixstep::fixed::types::I8F24;
use fixstep::{Anchor, BodyId, GravityY, LinearDrag, Pairs, Point, Ratio, Spring, Step};
use fixstep::{Vec2, Verlet, World, dec, heapless::Vec as List, vec2};
use picture::{BLUE, Picture, VERMILION};

pub const BEADS: usize = 16;
type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

/// Where the beads are every quarter second for two minutes, from the hook on.
pub fn swing() -> Fallible<Vec<Vec<Vec2<f64>>>> {
    let mut world = World::<Point<I8F24>, BEADS>::new();
    let mut links = List::<[BodyId; 2], BEADS>::new();
    for i in 0..BEADS as i64 {
        let at = vec2(Ratio::new(i, 2)?, 0)?;
        let bead = world.add(Point::new(at, Vec2::ZERO, dec!(0.5))?)?;
        if let [.., above, _] = *world.ids() {
            links.push([above, bead]).map_err(|_| "no room")?;
        }
    }
    let hook = Anchor::new(world.ids()[0], Vec2::ZERO, 2000, 0)?;
    let springs = Pairs::new(Spring::new(dec!(0.5), 2000, 0)?, links);
    let (gravity, drag) = (GravityY::new(dec!(-9.81))?, LinearDrag::new(dec!(0.1))?);
    let (mut forces, step) = ((gravity, drag, hook, springs), Step::hz(240)?);
    let mut shapes = vec![];
    for tick in 0..120 * 240 {
        if tick % 60 == 0 {
            let beads = world.bodies().iter();
            shapes.push(beads.map(|bead| bead.position().to_f64()).collect());
        }
        world.step(&mut Verlet, &mut forces, &step);
    }
    Ok(shapes)
}

fn main() -> Fallible<()> {
    let shapes = swing()?;
    let (axes, title) = (["x, m", "y, m"], "A chain swings down, drawn every 0.25 s");
    let mut picture = Picture::new(title, axes).with_equal_axes();
    println!("link   stretched   weight below / stiffness");
    for (link, ends) in (1..BEADS).zip(shapes[shapes.len() - 1].windows(2)) {
        let stretch = ((ends[1] - ends[0]).length() - 0.5) * 1e3;
        let statics = (BEADS - link) as f64 * 0.5 * 9.81 / 2000.0 * 1e3;
        println!("{link:4} {stretch:8.1} mm {statics:12.1} mm");
    }
    for beads in shapes.iter().take(10) {
        picture.line(BLUE, "", beads);
    }
    picture.line(VERMILION, "at rest", &shapes[shapes.len() - 1]);
    picture.save("chain")
}
