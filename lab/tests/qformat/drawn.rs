//! Scenes drawn by a seeded generator: one to three bodies under any of the forces.

use std::f64::consts::TAU;

use fixstep::Vec2;

use crate::described::{Described, Held, ROOM};
use crate::scene::Start;
use crate::support::Random;

/// Draws from a generator.
pub struct Draw(Random);

impl Draw {
    pub fn new(seed: u64) -> Draw {
        Draw(Random(seed))
    }

    /// From 0 to 1.
    fn part(&mut self) -> f64 {
        (self.0.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.part()
    }

    /// Each power of two as likely as any other.
    fn spread(&mut self, least: f64, most: f64) -> f64 {
        least * (most / least).powf(self.part())
    }

    fn chance(&mut self, of: f64) -> bool {
        self.part() < of
    }

    fn vector(&mut self, length: f64) -> Vec2<f64> {
        let (sin, cos) = (TAU * self.part()).sin_cos();
        let length = length * self.between(0.3, 1.0);
        Vec2::new(length * cos, length * sin)
    }

    /// A scene of a size between one and hundreds of metres.
    pub fn scene(&mut self) -> Described {
        let size = self.spread(1.0, 256.0);
        let bodies = 1 + (self.0.next() % ROOM as u64) as usize;
        let mut scene = Described::default();
        for _ in 0..bodies {
            scene.bodies.push(Start {
                position: self.vector(size),
                velocity: self.vector(0.2 * size),
                mass: self.spread(0.25, 4.0),
            });
        }
        if self.chance(0.4) {
            scene.gravity = Some(self.vector(9.81).map(|g| g * (size / 256.0)));
        }
        match self.0.next() % 3 {
            0 => scene.linear = Some(self.spread(0.02, 0.5)),
            1 => scene.quadratic = Some(self.spread(0.02, 2.0) / size),
            _ => {}
        }
        match self.0.next() % 4 {
            0 => self.anchors(&mut scene, size),
            1 if bodies > 1 => self.springs(&mut scene, size),
            2 if bodies > 1 => self.pull(&mut scene, size),
            _ => {}
        }
        scene
    }

    /// A spring of some hertz for a mass.
    fn held(&mut self, mass: f64) -> Held {
        let omega = TAU * self.spread(0.1, 2.0);
        let ratio = if self.chance(0.5) { self.part() } else { 0.0 };
        Held {
            stiffness: mass * omega * omega,
            damping: 2.0 * ratio * mass * omega,
        }
    }

    fn anchors(&mut self, scene: &mut Described, size: f64) {
        for i in 0..scene.bodies.len() {
            let held = self.held(scene.bodies[i].mass);
            let point = self.vector(0.5 * size);
            scene.anchors.push((i, point, held));
        }
    }

    fn springs(&mut self, scene: &mut Described, size: f64) {
        for i in 1..scene.bodies.len() {
            let held = self.held(scene.bodies[i].mass.min(scene.bodies[i - 1].mass));
            let rest = self.between(0.2, 1.5) * size;
            scene.springs.push(([i - 1, i], rest, held));
        }
    }

    /// As strong as turns a body of 1 kg about another at this distance in 4 to 32 seconds.
    fn pull(&mut self, scene: &mut Described, size: f64) {
        let omega = TAU / self.spread(4.0, 32.0);
        scene.pull = Some([
            omega * omega * size * size * size,
            size * self.spread(0.05, 0.5),
        ]);
    }
}
