//! Optional features: formats and types of other crates, one file each.

#[cfg(feature = "defmt")]
mod defmt;
#[cfg(feature = "mint")]
mod mint;
#[cfg(feature = "serde")]
mod serde;
