//! The poses of a fold.

use super::folded::count;

/// The poses of a fold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Poses {
    /// As many poses, all given by the columns.
    Columns(usize),
    /// Evenly spaced values of an input. The columns give all other numbers. What they give for the position of this
    /// input is not read.
    Grid(InputGrid),
}

/// Evenly spaced values of an input: of the angle of a crank, or of the length of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputGrid {
    /// The index of the input.
    pub input: usize,
    /// The number of poses.
    pub poses: usize,
    /// The value in the first pose.
    pub start: f64,
    /// The distance from one pose to the next.
    pub step: f64,
}

impl InputGrid {
    /// A revolution of an input that is an angle, from 0. The last pose lies a step before 2π.
    ///
    /// ```
    /// use kin_core::batch::InputGrid;
    ///
    /// let grid = InputGrid::revolution(0, 360);
    /// assert!((grid.value(90) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn revolution(input: usize, poses: usize) -> Self {
        Self {
            input,
            poses,
            start: 0.0,
            step: core::f64::consts::TAU / count(poses),
        }
    }

    /// The values from one to another. Both ends are poses, the second up to rounding. A single pose is the first end.
    #[must_use]
    pub fn between(input: usize, from: f64, to: f64, poses: usize) -> Self {
        Self {
            input,
            poses,
            start: from,
            step: if poses > 1 { (to - from) / count(poses - 1) } else { 0.0 },
        }
    }

    /// The value in a pose: `start + index * step`, rounded twice.
    #[inline]
    #[must_use]
    pub fn value(&self, index: usize) -> f64 {
        self.start + count(index) * self.step
    }

    /// The values from a pose on.
    pub(super) fn fill(&self, first: usize, values: &mut [f64]) {
        let first = count(first);
        // The offsets count in 32 bits, which vectors convert.
        for (offset, value) in (0_i32..).zip(values) {
            *value = self.start + (first + f64::from(offset)) * self.step;
        }
    }
}

impl Poses {
    /// The number of poses.
    pub(super) const fn count(&self) -> usize {
        match self {
            Self::Columns(count) => *count,
            Self::Grid(grid) => grid.poses,
        }
    }
}

impl From<usize> for Poses {
    fn from(count: usize) -> Self {
        Self::Columns(count)
    }
}

impl From<InputGrid> for Poses {
    fn from(grid: InputGrid) -> Self {
        Self::Grid(grid)
    }
}
