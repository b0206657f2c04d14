//! The comparison of a declaration's text with the mechanism that rustc compiled.

use kin_core::Mechanism;
use kin_core::series::Series;

use crate::{batches, sheets, solvers};

/// The positions, possible or not, at which everything is compared.
pub(crate) const SAMPLES: usize = 200;

/// Compares a mechanism with its text in several kinds of numbers. Returns how many results of its translated methods
/// were finite, and how many positions were solved.
pub(crate) fn assert_agreement<M: Mechanism<Scalar = f64>>(text: &str) -> [usize; 2] {
    let live = kin_live::Mechanism::declare(text).unwrap_or_else(|error| panic!("{error}"));
    let declaration = live.declaration();
    assert_eq!(declaration.name(), M::DESCRIPTION.name);
    sheets::assert_same_outline::<M>(&declaration.sheets().outline);
    let finite = sheets::agreeing::<M, f64>(declaration)
        + sheets::agreeing::<M, f32>(declaration)
        + sheets::agreeing::<M, Series<4>>(declaration);
    solvers::assert_same_description::<M>(&live);
    solvers::assert_same_positions::<M>(&live);
    let solved = solvers::agreeing::<M, f64>(&live)
        + solvers::agreeing::<M, f32>(&live)
        + solvers::agreeing::<M, Series<4>>(&live)
        + batches::agreeing::<M>(&live);
    [finite, solved]
}
