//! Read-outs: momentum, energy and a hash of the state.
//!
//! Sums are `f64` for any scalar. They are for tests and reports; no step calls them. A mass here is
//! the inverse of the stored inverse mass. So conservation is measured with the masses that the
//! steps use.

use crate::body::Body;
use crate::force::Force;
use crate::scalar::Factor;
use crate::vec2::Vec2;
use crate::world::World;
use crate::world::fnv::Fnv64;

impl<B: Body, const N: usize> World<B, N> {
    /// Total momentum `sum(m v)`, kg m/s, from rounded velocities. Kinematic and static bodies count zero,
    /// here and in the energies. For [`Carried`](crate::Carried) bodies with their remainders add up
    /// [`Carried::momentum`](crate::Carried::momentum).
    #[must_use]
    pub fn momentum(&self) -> Vec2<f64> {
        self.bodies()
            .iter()
            .map(momentum)
            .fold(Vec2::ZERO, |sum, p| sum + p)
    }

    /// Total angular momentum about the point `about` (m), kg m²/s. It is `sum(m (x - about) × v)` plus
    /// the angular momentum of each body about its own centre.
    #[must_use]
    pub fn angular_momentum(&self, about: Vec2<f64>) -> f64 {
        let of = |body: &B| {
            let (arm, p) = (body.position().to_f64() - about, momentum(body));
            arm.x * p.y - arm.y * p.x + body.spin_momentum()
        };
        self.bodies().iter().map(of).sum()
    }

    /// Total kinetic energy, J: `sum(m v²/2)` plus the energy of rotation.
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

    /// Total potential energy of `forces`, J.
    #[must_use]
    pub fn potential_energy(&self, forces: &impl Force<B>) -> f64 {
        forces.potential(self.ids(), self.bodies())
    }

    /// A hash of the state: equal states have equal hashes on every target.
    ///
    /// It is FNV-1a over the tick, the ids and the exact bits of every position, velocity, angle and spin.
    /// Masses are not part of it, because no step changes them.
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

/// Momentum of a body, kg m/s; zero for a kinematic or static one.
fn momentum<B: Body>(body: &B) -> Vec2<f64> {
    if body.has_infinite_mass() {
        return Vec2::ZERO;
    }
    let inv_mass = body.inv_mass().to_f64();
    body.velocity().to_f64().map(|v| v / inv_mass)
}
