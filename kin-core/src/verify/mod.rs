//! Verification of any mechanism, by two independent oracles, in one line.
//!
//! [`mechanism`] draws random dimensions and motions, solves the mechanism in every assembly, and holds each result
//! against both oracles. Its [`Report`] prints the worst errors, order by order.
//!
//! - **Differentiation.** The position solution is run on numbers that carry derivatives in time, along the inputs'
//!   Taylor polynomials: what it gives are the derivatives that the generated solvers should give, of the unknowns and of
//!   the outputs. The numbers are nested dual numbers (`num-dual`) through the fourth order, and the truncated Taylor series
//!   of [`series`](crate::series) beyond. See [`by_differentiation`].
//! - **Closure.** The generated motions are put back, as truncated Taylor series, into the equations as they were
//!   declared: what is left of them must vanish at every order. See [`closure`].
//!
//! The two share nothing but the declaration: the first knows of no generated derivative, the second of no closed form. Errors are
//! measured in the units of a [`Gauge`], which follow from the position and the motion.
//!
//! An output's derivatives are held against its position. The formula of its value has no second source, so that
//! nothing else is known of the value itself.
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
//! The feature `num-dual` has it. Who needs it for tests only writes `kin-core = { version = "…", features = ["num-dual"] }` under
//! `[dev-dependencies]`, beside the dependency proper.

mod carrier;
mod closure;
mod differentiation;
mod gauge;
mod gradients;
mod matrix_condition;
mod random;
mod report;
mod rounded;
mod sampling;
#[cfg(test)]
mod tests;
mod worst;

pub use closure::closure;
pub use differentiation::{Differentiated, by_differentiation};
pub use gauge::{Gauge, allowed};
pub use random::Random;
pub use report::Report;
pub use sampling::Sampling;
pub use worst::{Finding, Oracle, Worst};

use crate::mechanism::Mechanism;

/// A motion for each input of a mechanism.
pub type Inputs<M> = <M as Mechanism>::Inputs<<M as Mechanism>::Motion<f64>>;

/// A motion for each unknown of a mechanism.
pub type Unknowns<M> = <M as Mechanism>::Unknowns<<M as Mechanism>::Motion<f64>>;

/// Verifies a mechanism over random dimensions and motions, in every assembly: [`Sampling::mechanism`] with the default
/// sampling.
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

/// Verifies a mechanism about given dimensions, each input within its range from low to high: [`Sampling::of`] with the default
/// sampling. For mechanisms that hardly ever close when their dimensions are drawn without regard to each other.
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
