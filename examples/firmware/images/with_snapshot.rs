//! The gravity scene, saved and loaded.
#![no_std]
#![no_main]

use core::hint::black_box;

use measure::weigh::{self, Scene};

board::image!(|_| weigh::steps(
    || Ok(600),
    |world| {
        let mut bytes = [0; Scene::SNAPSHOT];
        let _ = black_box(world.save(&mut bytes));
        if let Ok(again) = Scene::load(black_box(&bytes)) {
            *world = again;
        }
    },
));
