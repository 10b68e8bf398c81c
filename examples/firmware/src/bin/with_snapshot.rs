//! The gravity scene, saved and loaded.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use fixstep_firmware::weigh::{self, Scene};

#[entry]
fn main() -> ! {
    weigh::end(weigh::steps(
        || Ok(600),
        |world| {
            let mut bytes = [0; Scene::SNAPSHOT];
            let _ = black_box(world.save(&mut bytes));
            if let Ok(again) = Scene::load(black_box(&bytes)) {
                *world = again;
            }
        },
    ))
}
