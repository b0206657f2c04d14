//! Dimensions of mechanisms by least squares and by search.
//!
//! An [`Objective`] holds the task: path, function or motion generation, or measured rows. [`polish`] takes
//! candidates through an evolution strategy and through least squares, and checks the results over the full cycle;
//! [`Fit`] finds the dimensions that meet measured rows; [`smallest`] minimises any cost from many starts. Mechanisms
//! are taken without their types, by [`Of::<M>::FUNCTIONS`](kin_core::any::Of::FUNCTIONS).
//!
//! ```
//! use kin_core::any::Of;
//! use kin_core::prelude::*;
//! use kin_fit::{Candidate, Objective};
//!
//! mechanism! {
//!     /// A four-bar linkage with a point of its coupler.
//!     struct Coupler { r1: Length, r2: Length, r3: Length, r4: Length, along: Length, beside: Length }
//!     input theta2: Angle;
//!     unknown theta3: Angle, theta4: Angle;
//!     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
//!     output point: Point = r2 * cis(theta2) + vec2(along, beside) * cis(theta3);
//! }
//!
//! let objective = Objective::path(Of::<Coupler>::FUNCTIONS, "point", [[0.4, 1.1], [0.0, 1.3], [-0.6, 1.2]])?
//!     .prescribed([0.5, 1.0, 1.5])?
//!     .bounds("r2", 0.1..=0.6)?
//!     .bounds("r3", 1.0..=3.0)?;
//! let linkage = Coupler { r1: 2.0, r2: 0.5, r3: 1.8, r4: 1.5, along: 0.4, beside: 0.9 };
//! let design = objective.design(&Candidate::new(&linkage, Assembly::Open))?;
//! let misfit = objective.misfit(&design).expect("it closes at all targets");
//! assert!(misfit.largest < 1.0);
//! # Ok::<(), kin_fit::ObjectiveError>(())
//! ```
//!
//! # Where the mechanism does not close
//!
//! One rule holds. A row of the sum of squares whose position does not exist is as large as an error of a hundred
//! spreads of the targets, and has the derivative zero. Where a full revolution is wanted and does not close, all rows
//! are of this kind. So least squares refuse a step after which a position no longer closes, and a start with positions
//! that do not close improves by its other positions. A search compares designs by [`penalised`] costs, whose limit
//! belongs to the same size: a design that closes is better than every design that does not.

mod adjustable;
mod design;
mod error;
mod functions;
mod job;
mod margins;
mod measured;
mod minimise;
mod objective;
mod order;
mod quantity;
mod refine;
mod rows;
mod table;
mod term;
mod threads;
mod traced_four_bar;

pub use adjustable::Adjustable;
pub use design::{Candidate, Design, Misfit, penalised};
pub use error::ObjectiveError;
pub use functions::{Change, Choice, FitFunctions};
pub use job::{Job, JobError};
pub use measured::{Deviation, Fit, FitError, Fitted, Measured, usual_bounds};
pub use minimise::{Effort, Evolution, Found, smallest, spread};
pub use objective::Objective;
pub use refine::{Defect, DefectKind, Dropped, Figures, Least, Range, Refined, Refinement, Settings, check, polish};
pub use table::read as read_candidates;
pub use term::{Sense, Term, TermAt, Travel};
pub use traced_four_bar::TracedFourBar;

#[doc(hidden)]
pub use functions::PointWay;
