//! Serialising with serde: vectors, ids, points, carried and range-checked bodies, worlds. `rigid.rs` has
//! angles and rigid bodies.
//!
//! A world reads and writes as `{ tick, next, ids, bodies }`. A point is `{ position, velocity, inv_mass }` with the
//! bits of its inverse mass. So a round trip is exact wherever the format keeps numbers exactly. A *carried* body, which
//! keeps what rounding loses, is `{ fine, velocity, inv_mass, remainder }`. Its fine position and its remainder have the
//! bits of a [snapshot](crate::world::snapshot). Input is checked as a snapshot is, and a missing or unknown field is
//! refused. The number type is that of the target and is not written.

mod rigid;

use serde::de::{Deserialize, Deserializer, Error};
use serde::ser::{Serialize, SerializeStruct, Serializer};

use crate::body::id::BodyId;
use crate::body::{Body, Carried, Point, RangeChecked};
use crate::scalar::{Carry, Scalar, Stored};
use crate::vec2::Vec2;
use crate::world::World;

impl<S: Serialize> Serialize for Vec2<S> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let mut fields = serializer.serialize_struct("Vec2", 2)?;
        fields.serialize_field("x", &self.x)?;
        fields.serialize_field("y", &self.y)?;
        fields.end()
    }
}

impl<'de, S: Deserialize<'de>> Deserialize<'de> for Vec2<S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "Vec2", deny_unknown_fields)]
        struct Fields<S> {
            x: S,
            y: S,
        }
        let Fields { x, y } = Fields::deserialize(deserializer)?;
        Ok(Vec2 { x, y })
    }
}

impl Serialize for BodyId {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        self.serial().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for BodyId {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        u32::deserialize(deserializer).map(BodyId::from_serial)
    }
}

impl<S: Scalar<InvMass: Stored> + Serialize> Serialize for Point<S> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let mut fields = serializer.serialize_struct("Point", 3)?;
        fields.serialize_field("position", &self.position())?;
        fields.serialize_field("velocity", &self.velocity())?;
        fields.serialize_field("inv_mass", &self.inv_mass().store())?;
        fields.end()
    }
}

impl<'de, S: Scalar<InvMass: Stored> + Deserialize<'de>> Deserialize<'de> for Point<S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "Point", deny_unknown_fields)]
        struct Fields<S> {
            position: Vec2<S>,
            velocity: Vec2<S>,
            inv_mass: u64,
        }
        let fields = Fields::deserialize(deserializer)?;
        S::InvMass::restore(fields.inv_mass)
            .and_then(|inv_mass| Point::from_parts(fields.position, fields.velocity, inv_mass))
            .ok_or_else(|| D::Error::custom("inv_mass is not that of a point"))
    }
}

impl<S: Carry + Scalar<InvMass: Stored> + Serialize> Serialize for Carried<S> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let mut fields = serializer.serialize_struct("Carried", 4)?;
        fields.serialize_field("fine", &self.fine_position().map(S::halves))?;
        fields.serialize_field("velocity", &self.velocity())?;
        fields.serialize_field("inv_mass", &self.inv_mass().store())?;
        fields.serialize_field("remainder", &self.remainder().map(S::remainder_bits))?;
        fields.end()
    }
}

impl<'de, S: Carry + Scalar<InvMass: Stored> + Deserialize<'de>> Deserialize<'de> for Carried<S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "Carried", deny_unknown_fields)]
        struct Fields<S> {
            fine: [[u64; 2]; 2],
            velocity: Vec2<S>,
            inv_mass: u64,
            remainder: [u64; 2],
        }
        let fields = Fields::<S>::deserialize(deserializer)?;
        let body = || {
            let ([x, y], [u, v]) = (fields.fine, fields.remainder);
            let fine = [S::from_halves(x)?, S::from_halves(y)?];
            let remainder = [S::from_remainder_bits(u)?, S::from_remainder_bits(v)?];
            let inv_mass = S::InvMass::restore(fields.inv_mass)?;
            Carried::from_parts(fine, fields.velocity, inv_mass, remainder)
        };
        body().ok_or_else(|| D::Error::custom("fine, inv_mass or remainder is not that of a body"))
    }
}

impl<B: Body + Serialize> Serialize for RangeChecked<B> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let mut fields = serializer.serialize_struct("RangeChecked", 2)?;
        fields.serialize_field("body", self.body())?;
        fields.serialize_field("was_outside", &self.was_outside())?;
        fields.end()
    }
}

impl<'de, B: Body + Deserialize<'de>> Deserialize<'de> for RangeChecked<B> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "RangeChecked", deny_unknown_fields)]
        struct Fields<B> {
            body: B,
            was_outside: bool,
        }
        let Fields { body, was_outside } = Fields::deserialize(deserializer)?;
        Ok(RangeChecked::marked(body, was_outside))
    }
}

impl<B: Body + Serialize, const N: usize> Serialize for World<B, N> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let mut fields = serializer.serialize_struct("World", 4)?;
        fields.serialize_field("tick", &self.tick())?;
        fields.serialize_field("next", &self.next_id())?;
        fields.serialize_field("ids", self.ids())?;
        fields.serialize_field("bodies", self.bodies())?;
        fields.end()
    }
}

impl<'de, B: Body + Deserialize<'de>, const N: usize> Deserialize<'de> for World<B, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "World", bound = "B: Deserialize<'de>", deny_unknown_fields)]
        struct Fields<B, const N: usize> {
            tick: u64,
            // Explicit, since a missing option would be `None`: a world without ids.
            #[serde(deserialize_with = "Option::deserialize")]
            next: Option<BodyId>,
            ids: heapless::Vec<BodyId, N>,
            bodies: heapless::Vec<B, N>,
        }
        let fields = Fields::<B, N>::deserialize(deserializer)?;
        let state = || D::Error::custom("ids do not rise, or there is not one for each body");
        if fields.ids.len() != fields.bodies.len() {
            return Err(state());
        }
        let mut world = World::new();
        for (&id, &body) in fields.ids.iter().zip(&fields.bodies) {
            world.put_back(id, body).ok_or_else(state)?;
        }
        world
            .go_on_from(fields.tick, fields.next)
            .ok_or_else(state)?;
        Ok(world)
    }
}
