//! What rounding alone does, the method's error taken away: how it grows where a frequency depends on
//! the energy, where it stops a motion, and that it has no direction of its own.

#[path = "rounding/bias.rs"]
mod bias;
#[path = "rounding/closed.rs"]
mod closed;
#[path = "rounding/dead_zones.rs"]
mod dead_zones;
#[path = "rounding/duffing.rs"]
mod duffing;
#[path = "rounding/growth.rs"]
mod growth;
#[path = "rounding/no_zones.rs"]
mod no_zones;
#[path = "rounding/noise.rs"]
mod noise;
#[path = "rounding/zones.rs"]
mod zones;
