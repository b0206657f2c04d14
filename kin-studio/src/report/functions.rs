//! What a report needs of a mechanism beside its answers.

use kin_core::any::Of;
use kin_core::linkage::LinkageFunctions;
use kin_core::tape::{self, Options, RecordError, Tape};
use kin_core::{Formulas, Mechanism, Outline, PlaneOrSpace, PointArray};

/// The functions of a mechanism for its report. They are compiled for each mechanism; all else is compiled once, in
/// this crate.
pub(crate) trait ReportFunctions: LinkageFunctions {
    /// The solver as data.
    fn record(&self, options: &Options) -> Result<Tape, RecordError>;

    /// The equations and their solution.
    fn formulas(&self) -> Formulas;

    /// Which joints belong together.
    fn outline(&self) -> Outline;

    /// Whether joints have three coordinates.
    fn is_space(&self) -> bool;

    /// The coordinates of all joints, and then the directions of all slides.
    fn places(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Vec<[f64; 3]>;
}

impl<M: Mechanism<Scalar = f64>> ReportFunctions for Of<M> {
    fn record(&self, options: &Options) -> Result<Tape, RecordError> {
        tape::record::<M>(options)
    }

    fn formulas(&self) -> Formulas {
        M::FORMULAS
    }

    fn outline(&self) -> Outline {
        M::OUTLINE
    }

    fn is_space(&self) -> bool {
        !<<M::Places as PointArray>::Point as PlaneOrSpace>::IS_PLANE
    }

    fn places(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Vec<[f64; 3]> {
        let mechanism = M::from_parameters(row(parameters));
        let places = mechanism.places(row(inputs), row(unknowns));
        let points = places.as_slice().iter().map(|place| (*place).in_space());
        points.map(|point| [point.x, point.y, point.z]).collect()
    }
}

fn row<R: kin_core::Row<f64>>(values: &[f64]) -> R {
    R::from_fn(|index| values[index])
}
