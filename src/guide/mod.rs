//! Which method, which number type, which rate? Five minutes for a firmware author.
//!
//! The modules below are pages, each for one question. This page is the short way to a first choice.
//!
//! | question | page |
//! |---|---|
//! | How do I use it in a game or a firmware? | [`firmware`] |
//! | Which force, which spring, which drag? | [`springs_and_drags`] |
//! | How do bodies rotate? | [`rotation`] |
//! | Which number type fits my scene? | [`adviser`] |
//! | My numbers are not constants. | [`run_time_numbers`] |
//! | How do I save a world, or go back? | [`saving`] |
//! | What do I do with an error? | [`errors`] |
//! | What does it cost? How wrong is it? | [`costs`], [`accuracy`] |
//! | How does it compare with other engines? | [`comparison`] |
//! | Is there an example? | [`examples`] |
//!
//! # 1. The number type: what is the range, and is there an FPU?
//!
//! | your scene | take | why |
//! |---|---|---|
//! | pixels, or a wide world | `I16F16` | ±32768, 15 µm; the cheapest on a core without an FPU |
//! | a table-top, a plant, an orbit in units of its own | `I8F24` | ±128, 60 nm: finer than `f32` from 1 m on |
//! | between | `I12F20` | ±2048, 1 µm |
//! | an FPU, and the scene stays near the origin | `f32` | no range to choose; 24 bits, coarser with distance |
//!
//! Choose the type whose range is twice the largest position and the largest speed. On a core without an
//! FPU `f32` costs eight times as much as `I16F16`. If in doubt, ask the [`adviser`].
//!
//! # 2. The body: how long does it run?
//!
//! A [`Carried`](crate::Carried) body keeps what rounding loses and adds it later. Bytes, and instructions
//! per body and step of the gravity scene in [`costs`] with semi-implicit Euler:
//!
//! | body | bytes | M0+ 1/60 | M0+ 1/64 | M4F 1/60 | M4F 1/64 |
//! |---|---|---|---|---|---|
//! | `Point<I16F16>` | 20 | 64.6 | 29.0 | 15.1 | 18.4 |
//! | `Carried<I16F16>` | 32 | 119.8 | 47.0 | 32.1 | 31.3 |
//! | `Point<f32>` | 20 | 540.3 | | 11.8 | |
//! | `Carried<f32>` | 32 | 1468.6 | | 29.6 | |
//!
//! * **A game of minutes**: take `Point`. A player sees no error.
//! * **A plant, a recording of hours**: take `Carried`. After a cruise of 30 km its error is 6 µm, and zero at
//!   a dyadic rate. A point in `I16F16` has an error of 4 m.
//! * **On M0+** take a carried body at 1/64 s: it costs less than a point at 1/60 s.
//! * **On M4** it costs 1.7 to 2.1 times the instructions of a point, in `f32` 2.5 times.
//! * **Forces** cost it more: each product is kept with its remainder. [`costs`] has every force.
//!
//! # 3. The rate
//!
//! * **60 Hz**, `Step::hz(60)`: where the display sets the rate.
//! * **1/64 s**, `DyadicStep<_, 1, 6>`: where you may choose, above all on M0+ and ARM7. A *dyadic* step has a
//!   length of `NUM / 2^SHIFT` seconds. A frame of the Game Boy Advance is exactly `DyadicStep<_, 4389, 18>`.
//! * The fastest spring sets the lowest rate: `h ω < 2`, with a margin. At 60 Hz explicit springs go up to 19 Hz.
//!   `Verlet` runs ahead by `(h ω)²/24` of the phase, 0.2 % at 2 Hz. For faster springs take
//!   [`ExactSpring`](crate::ExactSpring), at any rate.
//! * An [`Accumulator`](crate::Accumulator) gives the steps due in a frame. Two steps a frame cost twice as much and
//!   divide the error of [`Verlet`](crate::Verlet) by four.
//!
//! # 4. The method
//!
//! A *kick* changes a velocity by a force. A *drift* changes a position by a velocity.
//!
//! | your scene | take |
//! |---|---|
//! | most | [`Verlet`](crate::Verlet): order 2, a fall is exact, springs keep their energy |
//! | contacts of your own between kick and drift | [`SemiImplicitEuler`](crate::SemiImplicitEuler) |
//! | forces that depend on velocity or time, few steps | [`Rk4`](crate::Rk4): order 4, four times the forces, loses energy slowly |
//! | orbits for long | [`Pefrl`](crate::Pefrl): order 4, keeps the energy, four times the forces |
//! | a lesson | [`Euler`](crate::Euler), [`ConstantAcceleration`](crate::ConstantAcceleration): springs explode |
//!
//! Take an orbit with e = 0.6, to 1 % after ten periods. It needs less than 24,000 calls of the force with `Verlet`,
//! 8,000 with `Rk4` and 4,800 with `Pefrl`. `lab/tests/sweeps/kepler.rs` checks these limits and prints the counts.
//!
//! # 5. Drag and springs
//!
//! | explicit | exact | the difference |
//! |---|---|---|
//! | [`LinearDrag`](crate::LinearDrag) | [`ExactDrag`](crate::ExactDrag) | no limit, bodies stop; with `SemiImplicitEuler` it costs about the same for points in fixed point, less on M0+ |
//! | [`QuadraticDrag`](crate::QuadraticDrag) | [`ExactQuadraticDrag`](crate::ExactQuadraticDrag) | no limit: explicit drag explodes from `c v h / m = 2` |
//! | gravity and linear drag | [`Ballistic`](crate::Ballistic) | exact in position too, at any step |
//! | [`Anchor`](crate::Anchor) | [`ExactSpring`](crate::ExactSpring) | given as hertz and damping ratio, no limit, hangs at the exact position |
//! | [`Spring`](crate::Spring) between two | [`ExactPair`](crate::ExactPair) | the same, if nothing else holds them and the spring does not rotate |
//!
//! The explicit ones are the forces of the article. They go with every method, and networks of springs need them.
//! The exact springs and [`Ballistic`](crate::Ballistic) go with `SemiImplicitEuler` and `Verlet`.
//! [`springs_and_drags`] has all limits.
//!
//! # 6. Bodies that turn
//!
//! * Take [`Rigid`](crate::Rigid) on a [`Point`](crate::Point), for 16 bytes more (12 in `f32`).
//! * Take it on a [`Carried`](crate::Carried), in fixed point, where angles must be exact for days or weak torques
//!   must add up.
//! * [`SpinDrag`](crate::rigid::torque::SpinDrag) has no limit.
//! * A stiff spring between points of bodies ([`Attached`](crate::rigid::torque::Attached)) limits the step as every
//!   explicit spring does. Tied to a wall across an arm r, the limit is `h² k (1/m + r²/I) < 4`.
//!
//! # 7. Going back
//!
//! For a replay, a rollback or a debugger take a clone of the world if memory allows. If not, take
//! [`World::step_back`](crate::World::step_back), in fixed point and without drag. [`saving`] has both.

pub mod accuracy;
pub mod adviser;
pub mod comparison;
pub mod costs;
pub mod errors;
pub mod examples;
pub mod firmware;
pub mod rotation;
pub mod run_time_numbers;
pub mod saving;
pub mod springs_and_drags;
