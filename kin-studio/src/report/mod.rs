//! Pages on which a mechanism moves: one file each, without network.
//!
//! A [`Report`] holds what a page shows: motion, limits, peaks, equations, and the solver in JavaScript. [`report`]
//! makes it, and the page is a function of it alone.
//!
//! ```
//! use kin_core::library::FourBar;
//! use kin_studio::report;
//!
//! let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
//! let page = report(&linkage).speed(10.0).units("mm", "s").html()?;
//! assert!(page.starts_with("<!doctype html>"));
//! # Ok::<(), kin_studio::report::ReportError>(())
//! ```

mod draft;
mod error;
mod functions;
mod gather;
mod html;
mod model;
mod read;

pub use draft::{Draft, Untyped};
#[cfg(feature = "case")]
pub(crate) use draft::{WayWished, WishedLoads, Wishes};
pub use error::ReportError;
pub use functions::ReportFunctions;
pub use model::*;

use kin_core::{Mechanism, in_small_letters};

/// A report of a mechanism, to which wishes are added: its assembly, the motion of its inputs, units.
///
/// Without any wish the first input moves at the speed 1, as far as the mechanism closes, and all others stand at zero.
///
/// ```
/// use kin_core::library::FiveBar;
/// use kin_studio::report;
///
/// let robot = FiveBar { ground: 2.0, left: 0.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
/// let page = report(&robot).at([0.0, 1.0]).moving("alpha").speed(6.0).title("Robot").report()?;
/// assert_eq!(page.range, [0.0, std::f64::consts::TAU]);
/// # Ok::<(), kin_studio::report::ReportError>(())
/// ```
pub fn report<'l, M: Mechanism<Scalar = f64>>(mechanism: &M) -> Draft<'l, M> {
    Draft::new(mechanism)
}

/// Begins a report about a mechanism of any origin, with its scalar parameters in the order of the declaration.
///
/// ```
/// use kin_core::any::Of;
/// use kin_core::library::SliderCrank;
///
/// let page = kin_studio::report::of(Of::<SliderCrank>::FUNCTIONS, &[0.1, 0.3]).assembly(1).report()?;
/// assert_eq!(page.range[0], 0.0);
/// # Ok::<(), kin_studio::report::ReportError>(())
/// ```
pub fn of<'l>(functions: &'l dyn ReportFunctions, parameters: &[f64]) -> Draft<'l, Untyped> {
    Draft::of(functions, parameters)
}

/// The name of a mechanism's page without its ending: `FourBar` has `four-bar`.
#[must_use]
pub fn file_name(mechanism: &str) -> String {
    in_small_letters(mechanism, '-')
}
