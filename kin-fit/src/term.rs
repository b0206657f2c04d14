//! Terms beside the targets, to which a design is to keep.

use std::fmt;
use std::sync::Arc;

use kin_core::{BlockForm, Number as _};
use serde::Deserialize;

use crate::functions::{Change, Posed};

/// A term beside the targets. Each adds rows to the sum of squares.
///
/// A weight is in the unit of the targets' errors over the unit of the term: with the weight 0.1 a deficit of 10 counts
/// as much as an error of 1.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Term {
    /// The sum of the sizes of all lengths among the parameters, which is to be small. A coordinate is a length too.
    Lengths {
        /// The weight.
        weight: f64,
    },
    /// The box around all joints, along the axes of the frame of the mechanism: how far its width and height exceed
    /// these bounds.
    Box {
        /// The width that is free of charge.
        width: f64,
        /// The height that is free of charge.
        height: f64,
        /// The weight.
        weight: f64,
    },
    /// Grashof's margin of each four-bar: both middle links less the shortest and the longest link. Its deficit from
    /// `aim` counts; a result in which it is not positive is dropped. (F. Grashof, *Theoretische Maschinenlehre* 2,
    /// 1883.)
    Grashof {
        /// The margin that is wanted.
        aim: f64,
        /// The weight.
        weight: f64,
    },
    /// The margin by which the driver of each four-bar, slider-crank and inverted slider-crank turns fully: how much
    /// shorter one of its links could be before the driver no longer turns. Its deficit from `aim` counts; a result in
    /// which it is not positive is dropped.
    DriverTurns {
        /// The margin that is wanted.
        aim: f64,
        /// The weight.
        weight: f64,
    },
    /// The transmission angle of the worst dyad, folded to at most a right angle, at 24 samples of the travel. Its
    /// deficit from `aim` counts. A result whose smallest angle over the exact travel lies below `floor` is dropped. An
    /// aim a little above the floor lets the result keep to it.
    Transmission {
        /// The angle that is wanted, rad.
        aim: f64,
        /// The angle below which a result is dropped, rad.
        floor: f64,
        /// The weight, for each radian.
        weight: f64,
    },
}

/// The part of the motion that must close, stay in its branch, and keep to the terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Travel {
    /// From the first target to the last.
    #[default]
    Targets,
    /// The full revolution of the input.
    #[serde(rename = "turn")]
    Revolution,
}

/// The direction of the input in which the targets follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Sense {
    /// With a growing input, or with a falling input.
    #[default]
    Either,
    /// With a growing input.
    Forward,
    /// With a falling input.
    Backward,
}

/// A term that a user has written.
#[derive(Clone)]
pub(crate) struct CustomTerm {
    pub(crate) count: usize,
    pub(crate) rows: Arc<OwnRows>,
}

type OwnRows = dyn Fn(&TermAt<'_>) -> Option<Vec<Change>> + Send + Sync;

impl fmt::Debug for CustomTerm {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "CustomTerm({} rows)", self.count)
    }
}

/// A design at which a custom term is evaluated, in numbers that carry derivatives.
pub struct TermAt<'t> {
    pub(crate) posed: &'t Posed<'t>,
}

impl fmt::Debug for TermAt<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.parameters()).finish()
    }
}

impl TermAt<'_> {
    /// The scalar parameters.
    #[must_use]
    pub fn parameters(&self) -> &[Change] {
        self.posed.parameters()
    }

    /// The form of each block, with the lengths of its links.
    #[must_use]
    pub fn block_forms(&self) -> Vec<BlockForm<Change>> {
        self.posed.forms()
    }

    /// The unknowns and the scalar outputs at some inputs, in the order of the declaration, or `None` where the
    /// mechanism does not close.
    #[must_use]
    pub fn position(&self, inputs: &[f64]) -> Option<[Vec<Change>; 2]> {
        let solved = self
            .posed
            .solve(inputs.iter().copied().map(Change::constant).collect())?;
        let outputs = self.posed.outputs(&solved);
        Some([solved.unknowns, outputs])
    }
}
