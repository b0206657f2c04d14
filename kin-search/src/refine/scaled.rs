//! A design as a point of a cube, in which all numbers that are sought run from 0 to 1.

use basin::{BoxBounds, ConstraintDescription, ConstraintSet};
use kin_core::Mechanism;

use crate::objective::{Design, Objective};

/// The numbers that are sought, and the cube of their shares between their bounds.
#[derive(Clone)]
pub(crate) struct Scaled<'o, M: Mechanism<Scalar = f64>> {
    pub(crate) objective: &'o Objective<M>,
    pub(crate) design: Design<M>,
    pub(crate) sought: Vec<(usize, [f64; 2])>,
    lower: Vec<f64>,
    upper: Vec<f64>,
}

impl<'o, M: Mechanism<Scalar = f64>> Scaled<'o, M> {
    pub(crate) fn new(objective: &'o Objective<M>, design: &Design<M>, sought: Vec<(usize, [f64; 2])>) -> Self {
        Self {
            objective,
            design: design.clone(),
            lower: vec![0.0; sought.len()],
            upper: vec![1.0; sought.len()],
            sought,
        }
    }

    /// The point of the design itself.
    pub(crate) fn point(&self) -> Vec<f64> {
        let share = |(place, [low, high]): &(usize, [f64; 2])| {
            ((self.design.values[*place] - low) / (high - low)).clamp(0.0, 1.0)
        };
        self.sought.iter().map(share).collect()
    }

    /// The design of a point.
    pub(crate) fn at(&self, point: &[f64]) -> Design<M> {
        let mut design = self.design.clone();
        for ((place, [low, high]), share) in self.sought.iter().zip(point) {
            design.values[*place] = low + (high - low) * share;
        }
        design
    }

    pub(crate) fn bounds(&self) -> <ConstraintSet<BoxBounds<Vec<f64>>> as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.lower), Some(&self.upper)))
    }
}
