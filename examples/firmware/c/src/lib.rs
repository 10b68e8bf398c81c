//! A C face of one kind of scene: up to 32 points in `I16F16`, gravity, linear drag, semi-implicit Euler
//! at 64 Hz.
//!
//! | file | what it holds |
//! |---|---|
//! | `lib.rs` | the functions that C calls |
//! | `body.rs` | a point as C sees it, and numbers |
//! | `storage.rs` | the world as C sees it, and all of the `unsafe` code |
//! | `status.rs` | what a function answers |
//!
//! A pointer is `Option<&T>`: null is `None`, and to be valid otherwise is asked of the caller, as of
//! every C function. The comments here are those of `include/fixstep.h`.
#![no_std]

#[cfg(not(target_os = "none"))]
extern crate std;

mod body;
mod status;
mod storage;

use core::mem::MaybeUninit;

use fixstep::fixed::types::I16F16;
use fixstep::{DyadicStep, Gravity, LinearDrag, Point, SemiImplicitEuler};

pub use body::Body;
use body::{number, vector};
pub use status::Status;
pub use storage::{FIXSTEP_WORDS, Storage};
use storage::{named, scene, scene_mut};

/// How many points a world holds.
pub const FIXSTEP_CAPACITY: usize = 32;

/// Steps a second, exactly: each is 1/64 s, which cores without a long multiply take as a shift.
pub const FIXSTEP_HZ: u32 = 64;

/// What the step of the library is.
type Step = DyadicStep<I16F16, 1, { FIXSTEP_HZ.trailing_zeros() }>;

/// Makes an empty world, also of one that was used before.
///
/// `gravity_x` and `gravity_y` are an acceleration, m/s^2; `drag` is the force at 1 m/s, kg/s, not
/// negative. A point is stable while drag < 2 FIXSTEP_HZ mass.
#[unsafe(no_mangle)]
pub extern "C" fn fixstep_init(
    world: Option<&mut Storage>,
    gravity_x: i32,
    gravity_y: i32,
    drag: i32,
) -> Status {
    Status::of(|| {
        let world = world.ok_or(Status::Null)?;
        let gravity = Gravity::new(vector(gravity_x, gravity_y));
        let drag = LinearDrag::new(number(drag)?)?;
        storage::put(world, (gravity, drag));
        Ok(())
    })
}

/// Adds a point of `mass`, from 0.5 g, and writes its id to `id`. Ids are never given twice.
#[unsafe(no_mangle)]
pub extern "C" fn fixstep_add(
    world: Option<&mut Storage>,
    body: Option<&Body>,
    mass: i32,
    id: Option<&mut MaybeUninit<u32>>,
) -> Status {
    Status::of(|| {
        let (scene, body) = (scene_mut(world)?, body.ok_or(Status::Null)?);
        let id = id.ok_or(Status::Null)?;
        let (position, velocity) = body.parts();
        let point = Point::new(position, velocity, number(mass)?)?;
        id.write(scene.world.add(point)?.serial());
        Ok(())
    })
}

/// Makes one step.
#[unsafe(no_mangle)]
pub extern "C" fn fixstep_step(world: Option<&mut Storage>) -> Status {
    Status::of(|| {
        let scene = scene_mut(world)?;
        let step = Step::new()?;
        scene
            .world
            .step(&mut SemiImplicitEuler, &mut scene.forces, &step);
        Ok(())
    })
}

/// Writes where the point of that id is to `body`.
#[unsafe(no_mangle)]
pub extern "C" fn fixstep_get(
    world: Option<&Storage>,
    id: u32,
    body: Option<&mut MaybeUninit<Body>>,
) -> Status {
    Status::of(|| {
        let (scene, body) = (scene(world)?, body.ok_or(Status::Null)?);
        let point = scene.world.get(named(scene, id)?)?;
        body.write(Body::of(point));
        Ok(())
    })
}

/// Puts the point of that id elsewhere, with another velocity: for walls and controls of your own.
#[unsafe(no_mangle)]
pub extern "C" fn fixstep_set(world: Option<&mut Storage>, id: u32, body: Option<&Body>) -> Status {
    Status::of(|| {
        let (scene, body) = (scene_mut(world)?, body.ok_or(Status::Null)?);
        let id = named(scene, id)?;
        let point = scene.world.get_mut(id)?;
        let (position, velocity) = body.parts();
        point.teleport(position)?;
        point.set_velocity(velocity)?;
        Ok(())
    })
}

/// Takes the point of that id out; the others keep their ids.
#[unsafe(no_mangle)]
pub extern "C" fn fixstep_remove(world: Option<&mut Storage>, id: u32) -> Status {
    Status::of(|| {
        let scene = scene_mut(world)?;
        let id = named(scene, id)?;
        scene.world.remove(id)?;
        Ok(())
    })
}

/// Writes a hash of the step count, the ids and the exact bits of the points to `hash`.
#[unsafe(no_mangle)]
pub extern "C" fn fixstep_hash(
    world: Option<&Storage>,
    hash: Option<&mut MaybeUninit<u64>>,
) -> Status {
    Status::of(|| {
        let (scene, hash) = (scene(world)?, hash.ok_or(Status::Null)?);
        hash.write(scene.world.state_hash());
        Ok(())
    })
}
