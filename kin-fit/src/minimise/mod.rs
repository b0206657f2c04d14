//! Minimisers between bounds. [basin](https://basin.rs) has the methods; this module gives them numbers from 0 to 1.

mod evolution;
mod least_squares;
mod starts;

pub use evolution::Evolution;
pub(crate) use evolution::evolve;
pub(crate) use least_squares::{Ending, Squares, levenberg_marquardt, polish, trust_region};
pub use starts::{Effort, Found, smallest, spread};

use basin::{BoxBounds, ConstraintDescription, ConstraintSet};

/// Bounds, and the cube of the shares between them.
#[derive(Clone, Debug)]
struct Cube<'b> {
    bounds: &'b [[f64; 2]],
    zeros: Vec<f64>,
    ones: Vec<f64>,
}

impl<'b> Cube<'b> {
    fn new(bounds: &'b [[f64; 2]]) -> Self {
        Self {
            bounds,
            zeros: vec![0.0; bounds.len()],
            ones: vec![1.0; bounds.len()],
        }
    }

    /// The numbers of a point of the cube.
    fn numbers(&self, shares: &[f64]) -> Vec<f64> {
        let bounds = self.bounds.iter().zip(shares);
        bounds.map(|([low, high], share)| low + (high - low) * share).collect()
    }

    /// The point of the cube that is nearest to numbers.
    fn shares(&self, numbers: &[f64]) -> Vec<f64> {
        let share = |([low, high], number): (&[f64; 2], &f64)| ((number - low) / (high - low)).clamp(0.0, 1.0);
        self.bounds.iter().zip(numbers).map(share).collect()
    }

    fn constraints(&self) -> <ConstraintSet<BoxBounds<Vec<f64>>> as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.zeros), Some(&self.ones)))
    }
}
