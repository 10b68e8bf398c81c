//! Serialising with serde: angles and rigid bodies.
//!
//! ```text
//! { centre, driven, angle, spin, inv_inertia }           angle: its count
//! { centre, driven, angle, spin, inv_inertia, remainder }     of a carried one; angle: two halves of its count
//! ```
//!
//! `driven` is true for a kinematic or static body. Its centre is written with a mass of 1 kg, as in a snapshot.
//! `inv_inertia` and `remainder` have the bits of a snapshot.

use serde::de::{Deserialize, Deserializer, Error};
use serde::ser::{Serialize, SerializeStruct, Serializer};

use crate::body::{Carried, Point};
use crate::rigid::{Angle, CarriedRotor, PlainRotor, Rigid, Rotor};
use crate::scalar::{Angular, CarryAngular, Stored, Turns};

impl<S: Angular> Serialize for Angle<S> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        self.count().bits().serialize(serializer)
    }
}

impl<'de, S: Angular> Deserialize<'de> for Angle<S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        S::Turns::from_bits(u64::deserialize(deserializer)?)
            .map(Angle::from_count)
            .ok_or_else(|| D::Error::custom("angle has more bits than one"))
    }
}

impl<S> Serialize for Rigid<Point<S>>
where
    S: Angular<InvMass: Stored, Coef: Stored> + Serialize,
{
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let (driven, centre, rotor) = self.parts();
        let mut fields = serializer.serialize_struct("Rigid", 5)?;
        fields.serialize_field("centre", &centre)?;
        fields.serialize_field("driven", &driven)?;
        fields.serialize_field("angle", &rotor.angle())?;
        fields.serialize_field("spin", &rotor.spin())?;
        fields.serialize_field("inv_inertia", &rotor.inv_inertia().store())?;
        fields.end()
    }
}

impl<'de, S> Deserialize<'de> for Rigid<Point<S>>
where
    S: Angular<InvMass: Stored, Coef: Stored> + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "Rigid", deny_unknown_fields)]
        struct Fields<C, A, S> {
            centre: C,
            driven: bool,
            angle: A,
            spin: S,
            inv_inertia: u64,
        }
        let fields = Fields::<Point<S>, Angle<S>, S>::deserialize(deserializer)?;
        let body = || {
            let inv_inertia = S::Coef::restore(fields.inv_inertia)?;
            let rotor = PlainRotor::from_parts(fields.angle, fields.spin, inv_inertia)?;
            Rigid::from_parts(fields.driven, fields.centre, rotor)
        };
        body().ok_or_else(|| D::Error::custom("driven or inv_inertia is not that of a body"))
    }
}

impl<S> Serialize for Rigid<Carried<S>>
where
    S: CarryAngular<InvMass: Stored, Coef: Stored> + Serialize,
{
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let (driven, centre, rotor) = self.parts();
        let (angle, remainder) = rotor.parts();
        let mut fields = serializer.serialize_struct("Rigid", 6)?;
        fields.serialize_field("centre", &centre)?;
        fields.serialize_field("driven", &driven)?;
        fields.serialize_field("angle", &S::fine_halves(angle))?;
        fields.serialize_field("spin", &rotor.spin())?;
        fields.serialize_field("inv_inertia", &rotor.inv_inertia().store())?;
        fields.serialize_field("remainder", &S::remainder_bits(remainder))?;
        fields.end()
    }
}

impl<'de, S> Deserialize<'de> for Rigid<Carried<S>>
where
    S: CarryAngular<InvMass: Stored, Coef: Stored> + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        #[serde(rename = "Rigid", deny_unknown_fields)]
        struct Fields<C, S> {
            centre: C,
            driven: bool,
            angle: [u64; 2],
            spin: S,
            inv_inertia: u64,
            remainder: u64,
        }
        let fields = Fields::<Carried<S>, S>::deserialize(deserializer)?;
        let body = || {
            let angle = S::from_fine_halves(fields.angle)?;
            let kept = (fields.spin, S::from_remainder_bits(fields.remainder)?);
            let inv_inertia = S::Coef::restore(fields.inv_inertia)?;
            let rotor = CarriedRotor::from_parts(angle, kept, inv_inertia)?;
            Rigid::from_parts(fields.driven, fields.centre, rotor)
        };
        let why = "driven, angle, inv_inertia or remainder is not that of a body";
        body().ok_or_else(|| D::Error::custom(why))
    }
}
