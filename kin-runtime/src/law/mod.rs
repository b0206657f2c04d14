//! Motion laws: how an input moves over time, or over a driving angle.
//!
//! A law gives the value and the derivatives of any order at any time, `law.at(time)`, as the [`Motion`](crate::Motion)
//! that `solve` takes. The derivatives are closed formulas, so that they are exact up to rounding. Nothing allocates.
//!
//! | law | what it is |
//! |---|---|
//! | [`Dwell`] | rest |
//! | [`ConstantSpeed`] | constant speed |
//! | [`Rise`] with a [`Shape`] | from one rest to another in a given time: 3-4-5, 4-5-6-7 and 5-6-7-8-9 polynomials, cycloidal, simple harmonic, modified sine, modified trapezoid, [`Scca`] |
//! | [`SCurve`] | from one rest to another within [`Limits`] of velocity, acceleration, jerk and snap |
//! | [`Polynomial`] | between any two states, of any order |
//! | [`Fourier`] | a sum of harmonics |
//! | [`Sequence`] | laws one after the other |
//! | [`Repeated`] | a law again and again, as a cam repeats it |
//!
//! The variable of a law is called time here. It may as well be the angle of a cam: [`Law::driven`] then gives the
//! derivatives by time, from the motion of that angle.
//!
//! ```
//! use kin_core::law::{Dwell, Law, Rise, Sequence, Shape};
//! use kin_core::prelude::*;
//! use kin_core::library::SliderCrank;
//!
//! // a servo rotates the crank by 90 degrees in 0.4 s, and waits for 0.1 s
//! let rise = Rise::new(Shape::ModifiedSine, 0.0, 90_f64.to_radians(), 0.4)?;
//! let dwell = Dwell::new(90_f64.to_radians(), 0.1)?;
//! let servo = Sequence::new([&rise, &dwell])?;
//!
//! let press = SliderCrank { r: 0.1, l: 0.3 };
//! let pose = press.solve(servo.at(0.15), Assembly::Open)?;
//! println!("the slider's jerk: {} m/s³", pose.s.jerk());
//!
//! // where the law is not smooth
//! for joint in servo.joints::<5>() {
//!     println!("{joint}");
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Sources: R. L. Norton, *Cam Design and Manufacturing Handbook*, Industrial Press; VDI 2143 Blatt 1,
//! *Bewegungsgesetze für Kurvengetriebe, Theoretische Grundlagen*, VDI-Verlag 1980. The documentation of each law names
//! further ones.

mod constant;
mod continuity;
mod error;
mod fourier;
mod piecewise;
mod polynomial;
mod rise;
mod s_curve;
mod scca;
mod sequence;
#[cfg(test)]
mod tests;

pub use constant::{ConstantSpeed, Dwell};
pub use continuity::{LawJoint, LawJoints};
pub use error::LawError;
pub use fourier::Fourier;
#[cfg(feature = "alloc")]
pub(crate) use piecewise::approached;
pub use piecewise::{Law, Piecewise, Repeated, Side};
pub use polynomial::Polynomial;
pub use rise::{Rise, Shape};
pub use s_curve::{Limits, SCurve};
pub use scca::Scca;
#[doc(hidden)]
pub use sequence::LawRow;
pub use sequence::Sequence;
