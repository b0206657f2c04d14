//! The Jacobian of chosen results, and its singular values.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::error::Error;
use core::fmt;

use crate::failure::SolveError;
use crate::mechanism::Description;
use crate::number::series::Series;
use crate::number::{Number, singular_values};
use crate::quantity::Quantity;

/// Numbers whose matrices have singular values: `f64`, and series of it. A new version may add items.
#[doc(hidden)]
pub trait JacobianNumber: Number {
    /// The singular values of a matrix that is given in rows of so many columns, the largest first.
    #[doc(hidden)]
    fn singular_values(rows: &[Self], width: usize) -> Vec<Self>;
}

impl JacobianNumber for f64 {
    fn singular_values(rows: &[Self], width: usize) -> Vec<Self> {
        let rows: Vec<Series<1>> = rows.iter().copied().map(Series::constant).collect();
        singular_values(&rows, width).into_iter().map(Number::real).collect()
    }
}

impl<const N: usize> JacobianNumber for Series<N> {
    fn singular_values(rows: &[Self], width: usize) -> Vec<Self> {
        singular_values(rows, width)
    }
}

/// The partial derivatives of chosen unknowns or outputs with respect to all inputs: rows of the [Jacobian of a
/// pose](crate::Mechanism::jacobian), which has one for each of them.
///
/// If the root of the sum of squares of the inputs' speeds is 1, the hand of a robot has the speed of the largest
/// singular value in its fastest direction, and that of the smallest one in its slowest. Where the smallest one is
/// zero, the hand does not move at all in some direction. By the same factors errors of the inputs reach the hand, and
/// forces on the hand reach the drives. (T. Yoshikawa, *Manipulability of robotic mechanisms*, International Journal of
/// Robotics Research 4, no. 2 (1985), 3-9.)
///
/// Singular values compare rows with each other, and columns with each other. They mean something only if all rows have
/// one dimension, and all inputs have one; otherwise they would depend on the unit of length.
/// [`Mechanism::jacobian_of`] refuses to mix dimensions. Divide the rows of lengths by a length that you state, and
/// make a matrix [`from_rows`](Self::from_rows).
///
/// They say nothing about rounding errors: the [condition of a pose](crate::Mechanism::condition) does.
///
/// [`Mechanism::jacobian_of`]: crate::Mechanism::jacobian_of
#[derive(Clone, Debug, PartialEq)]
pub struct Jacobian<T> {
    /// Row after row.
    entries: Vec<T>,
    width: usize,
}

/// A number that measures how evenly a Jacobian converts velocities of the inputs into those of the results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum JacobianMeasure {
    /// The smallest singular value, in the unit of the results over that of the inputs.
    SmallestSingularValue,
    /// The largest singular value, in the same unit.
    LargestSingularValue,
    /// The largest singular value over the smallest one: 1 at an isotropic pose, infinite at a singular one.
    ConditionNumber,
    /// The smallest singular value over the largest one: 1 at an isotropic pose, 0 at a singular one. (C. Gosselin &
    /// J. Angeles, *A global performance index for the kinematic optimization of robotic manipulators*, Journal of
    /// Mechanical Design 113 (1991), 220-226, take its mean.)
    InverseConditionNumber,
    /// The product of all singular values, Yoshikawa's manipulability.
    Manipulability,
}

impl<T: Copy> Jacobian<T> {
    /// A matrix of your own, by its rows: for example rows of lengths that are divided by a length.
    ///
    /// ```
    /// use kin_core::Jacobian;
    ///
    /// let matrix = Jacobian::from_rows(&[[3.0, 0.0], [0.0, -2.0]]);
    /// assert_eq!(matrix.singular_values(), [3.0, 2.0]);
    /// assert_eq!(matrix.condition_number(), 1.5);
    /// ```
    #[must_use]
    pub fn from_rows<const INPUTS: usize>(rows: &[[T; INPUTS]]) -> Self {
        Self {
            entries: rows.as_flattened().to_vec(),
            width: INPUTS,
        }
    }

    /// The matrix with a number for each row and each column.
    pub(crate) fn from_fn(height: usize, width: usize, mut entry: impl FnMut(usize, usize) -> T) -> Self {
        let entries = (0..height * width).map(|index| (index / width, index % width));
        Self {
            entries: entries.map(|(row, column)| entry(row, column)).collect(),
            width,
        }
    }

    /// The rows, one for each result, with a number for each input.
    #[must_use]
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[T]> {
        // a row without numbers is no part of a slice
        self.entries.chunks_exact(self.width.max(1))
    }
}

impl<T: JacobianNumber> Jacobian<T> {
    /// The singular values, the largest first: as many as there are rows or columns, whichever are fewer. None is
    /// negative.
    ///
    /// Where two of them are equal, or where one is zero, series of them have a kink. They are those behind it, where
    /// the variable is larger.
    #[must_use]
    pub fn singular_values(&self) -> Vec<T> {
        T::singular_values(&self.entries, self.width)
    }

    /// One of the measures.
    #[must_use]
    pub fn measure(&self, measure: JacobianMeasure) -> T {
        let values = self.singular_values();
        let none = T::constant(f64::NAN);
        let largest = values.first().copied().unwrap_or(none);
        let smallest = values.last().copied().unwrap_or(none);
        match measure {
            JacobianMeasure::SmallestSingularValue => smallest,
            JacobianMeasure::LargestSingularValue => largest,
            JacobianMeasure::ConditionNumber => largest / smallest,
            JacobianMeasure::InverseConditionNumber => smallest / largest,
            JacobianMeasure::Manipulability => {
                let rest = values.iter().skip(1);
                rest.fold(largest, |product, value| product * *value)
            }
        }
    }

    /// The [largest singular value over the smallest one](JacobianMeasure::ConditionNumber), infinite for a singular
    /// matrix.
    #[must_use]
    pub fn condition_number(&self) -> T {
        self.measure(JacobianMeasure::ConditionNumber)
    }
}

/// The reason why results have no Jacobian with singular values.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum JacobianError {
    /// No unknown and no output has this name.
    NoSuchResult {
        /// The name.
        name: String,
        /// The names of all unknowns and outputs.
        results: Vec<String>,
    },
    /// There is no result, or no input.
    Empty,
    /// Two results, or two inputs, have different dimensions.
    MixedDimensions {
        /// A result or an input.
        one: String,
        /// Another one, of another dimension.
        other: String,
    },
    /// The pose is not one of the mechanism, or is too close to a singular position.
    Position(SolveError),
}

impl fmt::Display for JacobianError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchResult { name, results } => write!(
                formatter,
                "no unknown and no output is called `{name}`: there are {}",
                results.join(", ")
            ),
            Self::Empty => formatter.write_str("a Jacobian needs a result and an input: name an unknown or an output"),
            Self::MixedDimensions { one, other } => write!(
                formatter,
                "`{one}` and `{other}` have different dimensions, so that singular values would depend on the units: \
                 choose results of one dimension, or divide the rows of lengths by a length and make a \
                 `Jacobian::from_rows`"
            ),
            Self::Position(error) => write!(formatter, "{error}"),
        }
    }
}

crate::__debug_by_display!(JacobianError);

impl Error for JacobianError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Position(error) => Some(error),
            Self::NoSuchResult { .. } | Self::Empty | Self::MixedDimensions { .. } => None,
        }
    }
}

impl From<SolveError> for JacobianError {
    fn from(error: SolveError) -> Self {
        Self::Position(error)
    }
}

/// The rows of a pose's Jacobian that belong to results of these names: one for a scalar, and those of all coordinates
/// for a point.
pub(crate) fn rows_of(description: &Description<'_>, names: &[&str]) -> Result<Vec<usize>, JacobianError> {
    let results = || description.unknowns.iter().chain(description.outputs);
    let mut rows = Vec::new();
    for name in names {
        let is_meant = |result: &str| {
            let rest = result.strip_prefix(name);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        let meant = results().enumerate().filter(|(_, quantity)| is_meant(quantity.name));
        let before = rows.len();
        rows.extend(meant.map(|(row, _)| row));
        if rows.len() == before {
            return Err(JacobianError::NoSuchResult {
                name: name.to_string(),
                results: results().map(|quantity| quantity.name.to_string()).collect(),
            });
        }
    }
    check_dimension(rows.iter().filter_map(|row| results().nth(*row).copied()))?;
    check_dimension(description.inputs.iter().copied())?;
    Ok(rows)
}

/// Whether there are quantities, and all have one dimension.
fn check_dimension<'d>(mut quantities: impl Iterator<Item = Quantity<'d>>) -> Result<(), JacobianError> {
    let one = quantities.next().ok_or(JacobianError::Empty)?;
    match quantities.find(|other| other.dimension != one.dimension) {
        Some(other) => Err(JacobianError::MixedDimensions {
            one: one.name.to_string(),
            other: other.name.to_string(),
        }),
        None => Ok(()),
    }
}
