//! Read-outs: momentum, energy and a hash of the state.
//!
//! Sums are `f64` in any scalar: they are for tests and reports, no step calls them. A mass is the
//! inverse of the inverse mass that the body holds, so that conservation is judged by the masses
//! which the scene really has.

use crate::body::Body;
use crate::force::Force;
use crate::scalar::Factor;
use crate::vec2::Vec2;
use crate::world::World;
use crate::world::fnv::Fnv64;

impl<B: Body, const N: usize> World<B, N> {
    /// Total momentum `sum(m v)`, kg m/s, of velocities as they are seen; bodies that no force moves have none, and
    /// no energy. That of [`Carried`](crate::Carried) bodies with their remainders is the sum of
    /// [`Carried::momentum`](crate::Carried::momentum).
    #[must_use]
    pub fn momentum(&self) -> Vec2<f64> {
        self.bodies()
            .iter()
            .map(momentum)
            .fold(Vec2::ZERO, |sum, p| sum + p)
    }

    /// Total angular momentum about the point `about` (m), kg m²/s: `sum(m (x - about) × v)`, and what
    /// bodies have about their own centres.
    #[must_use]
    pub fn angular_momentum(&self, about: Vec2<f64>) -> f64 {
        let of = |body: &B| {
            let (arm, p) = (body.position().to_f64() - about, momentum(body));
            arm.x * p.y - arm.y * p.x + body.spin_momentum()
        };
        self.bodies().iter().map(of).sum()
    }

    /// Total kinetic energy `sum(m v²/2)`, J, and that of rotations.
    #[must_use]
    pub fn kinetic_energy(&self) -> f64 {
        let of = |body: &B| {
            let v = body.velocity().to_f64();
            if body.has_infinite_mass() {
                return 0.0;
            }
            0.5 * v.dot(v) / body.inv_mass().to_f64() + body.spin_energy()
        };
        self.bodies().iter().map(of).sum()
    }

    /// Total potential energy in `forces`, J.
    #[must_use]
    pub fn potential_energy(&self, forces: &impl Force<B>) -> f64 {
        forces.potential(self.ids(), self.bodies())
    }

    /// FNV-1a over the tick, the ids and the exact bits of every position, velocity, angle and spin: equal
    /// states have equal hashes on every target. Masses, which no step changes, are left out.
    #[must_use]
    pub fn state_hash(&self) -> u64 {
        let mut hash = Fnv64::new();
        hash.write(self.tick());
        for (id, body) in self.iter() {
            hash.write(id.serial() as u64);
            body.write_state(&mut |word| hash.write(word));
        }
        hash.0
    }
}

/// Momentum of a body, kg m/s; none of one that no force moves.
fn momentum<B: Body>(body: &B) -> Vec2<f64> {
    if body.has_infinite_mass() {
        return Vec2::ZERO;
    }
    let inv_mass = body.inv_mass().to_f64();
    body.velocity().to_f64().map(|v| v / inv_mass)
}
