//! Verification of any mechanism, by two independent oracles, in one line.
//!
//! [`mechanism`] draws random dimensions and motions, solves the mechanism in every assembly, and compares each result
//! with both oracles. Its [`Report`] prints the worst errors, order by order.
//!
//! - **Differentiation.** The position solution is run on numbers that carry time derivatives, along the Taylor
//!   polynomials of the inputs. The results are the derivatives of unknowns and outputs that the generated solvers
//!   should give. The numbers are the truncated Taylor series of [`series`](crate::series). With the feature `num-dual`
//!   they are nested dual numbers up to the fourth order, which share nothing with the second oracle. The report names
//!   them. See [`by_differentiation`].
//! - **Closure.** The generated motions are put into the equations as declared, as truncated Taylor series. The
//!   residuals must vanish at every order. See [`closure`].
//!
//! The two share only the declaration: the first does not use the generated derivatives, the second does not use the
//! closed forms. Errors are measured in the units of a [`Gauge`], which follow from the position and the motion.
//!
//! The derivatives of an output are compared with the derivatives of its value. The value itself is not checked,
//! because its formula has no second source.
//!
//! ```
//! use kin_core::prelude::*;
//! use kin_core::verify;
//!
//! mechanism! {
//!     /// A slider-crank, driven at its slider.
//!     pub struct Pump {
//!         /// Crank.
//!         pub crank: Length,
//!         /// Connecting rod.
//!         pub rod: Length,
//!     }
//!     input s: Length;
//!     unknown theta: Angle, phi: Angle;
//!
//!     crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
//! }
//!
//! // in a test: panics with the table if something is wrong
//! verify::mechanism::<Pump>().assert();
//!
//! // near given dimensions, and over a given range of the input
//! let pump: Pump = Pump { crank: 3.0, rod: 4.0 };
//! let report = verify::of(&pump, [(2.0, 6.0)]);
//! println!("{report}");
//! assert!(report.passed());
//! ```
//!
//! This module needs the feature `std`, which is on by default.

mod carrier;
mod closure;
mod differentiation;
mod divisors;
mod functions;
mod gauge;
mod gradients;
mod matrix_condition;
mod motions;
mod random;
mod report;
mod rounded;
mod sampling;
#[cfg(test)]
mod tests;
mod worst;

#[doc(hidden)]
pub use carrier::{Carrier, ThroughSnap};
pub use closure::closure;
pub use differentiation::{Differentiated, by_differentiation};
#[doc(hidden)]
pub use functions::{VerifiedFunctions, differentiated, left_over};
#[doc(hidden)]
pub use gauge::{Gauge, allowed};
#[doc(hidden)]
pub use random::Random;
pub use report::Report;
pub use sampling::Sampling;
pub use worst::{Finding, Oracle, Worst};

use crate::mechanism::Mechanism;

/// A motion for each input of a mechanism.
pub type Inputs<M> = <M as Mechanism>::Inputs<<M as Mechanism>::Motion<f64>>;

/// A motion for each unknown of a mechanism.
pub type Unknowns<M> = <M as Mechanism>::Unknowns<<M as Mechanism>::Motion<f64>>;

/// Verifies a mechanism over random dimensions and motions, in every assembly. This is [`Sampling::mechanism`] with the
/// default sampling.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::verify;
///
/// let report = verify::mechanism::<FourBar>();
/// println!("{report}");
/// report.assert();
/// ```
pub fn mechanism<M: Mechanism<Scalar = f64>>() -> Report {
    Sampling::default().mechanism::<M>()
}

/// Verifies a mechanism around given dimensions, with each input in its range from low to high. This is
/// [`Sampling::of`] with the default sampling. Use it for mechanisms that rarely close if all dimensions are drawn
/// independently.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::verify;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// verify::of(&linkage, [(-1.9, 1.9)]).assert();
/// ```
pub fn of<M: Mechanism<Scalar = f64>>(mechanism: &M, ranges: M::Inputs<(f64, f64)>) -> Report {
    Sampling::default().of(mechanism, ranges)
}
