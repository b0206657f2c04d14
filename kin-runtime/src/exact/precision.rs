//! What an exact table shall hold, and how well.

use super::ExactTableError;
use super::piece::MOST_NUMBERS;
use crate::mechanism::Description;

/// The largest number of rows unless another one is given.
const MOST_ROWS: usize = 100_000;

/// The tolerances of an exact table, one for each order, and the largest number of its rows.
///
/// A tolerance is a part of the *size* of each column in that order. For the values of an angle the size is one radian,
/// for those of lengths and numbers the largest magnitude in the table. For a derivative it is the largest magnitude of
/// the column in that order or in a lower one, which is taken per 1/2π of the range of the parameter: for a full
/// revolution per radian.
///
/// One number is the tolerance of all orders: `1e-7.into()`. An array is a tolerance for each order, and the table ends
/// with the last of them: `[1e-13, 1e-11, 1e-9].into()` makes a table of value, velocity and acceleration. Each
/// derivative loses about two digits, so tolerances that grow by a hundred from order to order take the fewest rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Precision {
    tolerances: [f64; MOST_NUMBERS],
    order: usize,
    most_rows: usize,
}

impl Precision {
    /// The same tables, with no order above this one. Every table has a derivative: order 0 is refused with
    /// [`ExactTableError::Order`].
    #[must_use]
    pub fn up_to(mut self, order: usize) -> Self {
        self.order = self.order.min(order);
        self
    }

    /// The same tables with at most this number of rows, instead of 100 000.
    #[must_use]
    pub fn most_rows(mut self, rows: usize) -> Self {
        self.most_rows = rows;
        self
    }

    /// The tolerances of all orders.
    #[must_use]
    pub fn tolerances(&self) -> &[f64] {
        &self.tolerances[..=self.order]
    }

    /// The order of the tables of a mechanism.
    pub(super) fn order_of(&self, description: &Description<'_>) -> Result<usize, ExactTableError> {
        match description.order.min(self.order) {
            0 => Err(ExactTableError::Order { asked: self.order }),
            order => Ok(order),
        }
    }

    pub(super) fn rows(&self) -> usize {
        self.most_rows
    }
}

impl From<f64> for Precision {
    fn from(tolerance: f64) -> Self {
        [tolerance; MOST_NUMBERS].into()
    }
}

impl<const N: usize> From<[f64; N]> for Precision {
    fn from(given: [f64; N]) -> Self {
        const {
            assert!(
                N > 1 && N <= MOST_NUMBERS,
                "a table has from two to five orders: the value and up to four derivatives"
            );
        };
        Self {
            tolerances: core::array::from_fn(|order| given.get(order).copied().unwrap_or(0.0)),
            order: N - 1,
            most_rows: MOST_ROWS,
        }
    }
}
