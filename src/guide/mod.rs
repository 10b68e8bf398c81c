//! Which method, which number type, which rate? Five minutes for a firmware author.
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
//! FPU `f32` costs eight times as much as `I16F16`.
//!
//! # 2. The body: how long does it run?
//!
//! Bytes, and instructions per body and step of the README's gravity scene by semi-implicit Euler:
//!
//! | body | bytes | M0+ 1/60 | M0+ 1/64 | M4F 1/60 | M4F 1/64 |
//! |---|---|---|---|---|---|
//! | `Point<I16F16>` | 20 | 64.6 | 29.0 | 15.1 | 18.4 |
//! | `Carried<I16F16>` | 32 | 119.8 | 47.0 | 32.1 | 31.3 |
//! | `Point<f32>` | 20 | 540.3 | | 11.8 | |
//! | `Carried<f32>` | 32 | 1468.6 | | 29.6 | |
//!
//! * **A game of minutes**: `Point`. Nothing that a player sees.
//! * **A plant, a recording of hours**: `Carried`. A cruise of 30 km is off by 6 µm where a point in
//!   `I16F16` is off by 4 m, and by nothing at a dyadic rate.
//! * **On M0+** take a carried body at 1/64 s: it costs less than a point at 1/60 s.
//! * **On M4** it costs 1.7 to 2.1 times the instructions of a point, 2.5 in `f32`.
//! * **Kicks** cost it more: each product is kept with its remainder. The README has the price of each force.
//!
//! # 3. The rate
//!
//! * **60 Hz** (`Step::hz(60)`) where the picture sets the pace; **1/64 s** (`DyadicStep<_, 1, 6>`) where you
//!   may choose, above all on M0+ and ARM7; a Game Boy's frame is `DyadicStep<_, 4389, 18>`, exactly.
//! * The fastest spring sets the least rate: `h ω < 2`, with room. 60 Hz carries explicit springs up to
//!   19 Hz; `Verlet` is ahead by `(h ω)²/24` of the phase, 0.2 % at 2 Hz. Faster ones: [`ExactSpring`](crate::ExactSpring), at any rate.
//! * Steps due in a frame: [`Accumulator`](crate::Accumulator). Two steps a frame cost twice, and divide the
//!   error of [`Verlet`](crate::Verlet) by four.
//!
//! # 4. The method
//!
//! | your scene | take |
//! |---|---|
//! | most | [`Verlet`](crate::Verlet): order 2, a fall is exact, springs keep their energy |
//! | contacts of your own between kick and drift | [`SemiImplicitEuler`](crate::SemiImplicitEuler) |
//! | forces that depend on velocity or time, few steps | [`Rk4`](crate::Rk4): order 4, four times the forces, loses energy slowly |
//! | orbits for long | [`Pefrl`](crate::Pefrl): order 4, energy for ever, four times the forces |
//! | a lesson | [`Euler`](crate::Euler), [`ConstantAcceleration`](crate::ConstantAcceleration): springs explode |
//!
//! An orbit of e = 0.6 to 1 % after ten turns takes less than 24,000 calls of the force by `Verlet`, 8,000 by
//! `Rk4` and 4,800 by `Pefrl`: `tests/kepler.rs` holds them to it and prints what it takes.
//!
//! # 5. Drag and springs
//!
//! | explicit | exact | the difference |
//! |---|---|---|
//! | [`LinearDrag`](crate::LinearDrag) | [`ExactDrag`](crate::ExactDrag) | no limit, comes to rest; by `SemiImplicitEuler` about as dear for points in fixed point, cheaper on M0+ |
//! | [`QuadraticDrag`](crate::QuadraticDrag) | [`ExactQuadraticDrag`](crate::ExactQuadraticDrag) | no limit: explicit drag explodes from `c v h / m = 2` |
//! | gravity and linear drag | [`Ballistic`](crate::Ballistic) | exact in position too, at any step |
//! | [`Anchor`](crate::Anchor) | [`ExactSpring`](crate::ExactSpring) | given as hertz and damping ratio, no limit, hangs where it should |
//! | [`Spring`](crate::Spring) between two | [`ExactPair`](crate::ExactPair) | the same, if nothing else holds them and the spring does not turn |
//!
//! The explicit ones are forces of the article and go with every method; networks of springs need them. The
//! exact springs and [`Ballistic`](crate::Ballistic) go with `SemiImplicitEuler` and `Verlet`.
//!
//! # 6. What turns
//!
//! [`Rigid`](crate::Rigid) on a [`Point`](crate::Point), for 16 bytes more (12 in `f32`); in fixed point on a
//! [`Carried`](crate::Carried) where angles must be exact for days, or weak torques must add up. The README has the prices. [`SpinDrag`](crate::rigid::torque::SpinDrag) has no limit.
//! A spring between points of bodies ([`Attached`](crate::rigid::torque::Attached)) that is stiff for their inertia limits the step as
//! any explicit spring does: tied to a wall across an arm r, `h² k (1/m + r²/I) < 4`.
//!
//! # 7. Going back
//!
//! A replay, a rollback, a debugger: a clone of the world if memory allows, else
//! [`World::step_back`](crate::World::step_back) in fixed point, without drag.
