//! The failures of a solver, and where they occurred.

use core::error::Error;
use core::fmt;

use crate::failure::InputValues;
use crate::quantity::{Digits, Name, WithUnit};

/// The reason why a solver found no position.
///
/// Lengths are in the mechanism's units, angles in radians.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Failure {
    /// The links do not reach: the loop closure has no solution.
    OutOfReach {
        /// The missing length, as a negative number in the unit of the quantity that is missing. It goes to zero at the
        /// limit of the range.
        margin: f64,
    },
    /// The Jacobian of the block is singular: a limit position or dead point, with links on one line. A position may
    /// exist there; rates do not.
    Singular {
        /// The determinant, which is zero up to rounding.
        determinant: f64,
    },
    /// A solution exists, but it lies outside the range declared for the unknown.
    OutOfRange {
        /// The name of the unknown.
        unknown: Name,
        /// The solution nearest to the range.
        value: f64,
        /// The lower end of the range.
        low: f64,
        /// The upper end of the range.
        high: f64,
        /// Whether the unknown is an angle, so that these numbers are in radians.
        is_angle: bool,
    },
    /// Both solutions lie in the range declared for the unknown.
    Ambiguous {
        /// The name of the unknown.
        unknown: Name,
        /// One solution.
        first: f64,
        /// The other solution.
        second: f64,
        /// Whether the unknown is an angle, so that both are in radians.
        is_angle: bool,
    },
    /// An argument lies outside the domain of a function in the declaration.
    OutsideDomain {
        /// The function, as written in a declaration.
        function: &'static str,
        /// The argument of the function.
        argument: f64,
    },
    /// The iteration for a block without closed form found no root from its guess.
    NotConverged {
        /// The largest residual where the iteration gave up, in the unit of its equation.
        residual: f64,
        /// The number of steps taken.
        iterations: u32,
        /// The condition number of the Jacobian where the iteration gave up, in the maximum norm after scaling.
        condition: f64,
    },
    /// The guess for an angle has so many revolutions that neighbouring numbers are more than a degree apart. No angle
    /// of that size is a solution.
    TooManyRevolutions {
        /// The name of the unknown.
        unknown: Name,
        /// The guess near which the unknown was to be solved.
        guess: f64,
        /// The distance between neighbouring numbers of this size.
        spacing: f64,
    },
    /// A parameter, an input or a result is not finite: NaN, infinite, or beyond the range of the number type.
    NotFinite {
        /// The quantity that is not finite, in a few words.
        quantity: Name,
    },
}

impl Failure {
    /// The failure with the block where it occurred: the unknowns of the block, separated by commas, and the inputs of
    /// the solver.
    #[cold]
    #[must_use]
    pub fn at(self, block: impl Into<Name>, inputs: InputValues) -> SolveError {
        SolveError {
            failure: self,
            block: block.into(),
            inputs,
        }
    }

    /// The failure of a quantity that is not finite, in a few words.
    pub(crate) fn not_finite(quantity: impl Into<Name>) -> Self {
        Self::NotFinite {
            quantity: quantity.into(),
        }
    }

    /// The failure, unless one of the given quantities is not finite. That quantity is then the cause, and the first
    /// such quantity is named.
    ///
    /// ```
    /// use kin_core::Failure;
    ///
    /// let failure = Failure::OutOfReach { margin: -1.0 };
    /// assert_eq!(failure.traced(&[("r1", 90.0), ("r2", 30.0)]), failure);
    /// assert_eq!(
    ///     failure.traced(&[("r1", 90.0), ("r2", f64::INFINITY)]),
    ///     Failure::NotFinite { quantity: "r2".into() }
    /// );
    /// ```
    #[cold]
    #[must_use]
    pub fn traced(self, quantities: &[(&'static str, f64)]) -> Self {
        quantities
            .iter()
            .find(|(_, value)| !value.is_finite())
            .map_or(self, |(quantity, _)| Self::not_finite(*quantity))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::OutOfReach { margin } => write!(
                formatter,
                "out of reach by {} (in the mechanism's own units); \
                 change the dimensions, or keep the inputs within the range over which the loop closes",
                Digits(-margin)
            ),
            Self::Singular { determinant } => write!(
                formatter,
                "singular position, a dead point or the limit of the range, where the two assemblies meet and rates \
                 are not defined (determinant {}); stop short of it, or drive the mechanism by another input",
                Digits(determinant)
            ),
            Self::OutOfRange {
                unknown,
                value,
                low,
                high,
                is_angle,
            } => {
                let [value, low, high] = [value, low, high].map(|value| WithUnit { value, is_angle });
                write!(
                    formatter,
                    "{unknown} = {value} lies outside its declared range from {low} to {high}; \
                     widen the range, or change dimensions or inputs"
                )
            }
            Self::Ambiguous {
                unknown,
                first,
                second,
                is_angle,
            } => {
                let [first, second] = [first, second].map(|value| WithUnit { value, is_angle });
                write!(
                    formatter,
                    "the declared range of {unknown} holds both solutions, {first} and {second}; \
                     narrow it until one is left"
                )
            }
            Self::OutsideDomain { function, argument } => write!(
                formatter,
                "{function} is not defined for {}; change dimensions or inputs",
                Digits(argument)
            ),
            Self::NotConverged {
                residual,
                iterations,
                condition,
            } => write!(
                formatter,
                "no solution found near the guess, a residual of {} is left after {iterations} steps \
                 (condition of the Jacobian {}); start from a better guess, track from a known pose, or bring the \
                 inputs back within reach",
                Digits(residual),
                Digits(condition)
            ),
            Self::TooManyRevolutions {
                unknown,
                guess,
                spacing,
            } => write!(
                formatter,
                "the guess for {unknown} is {}, where neighbouring numbers are {} apart and define no direction; \
                 subtract whole turns from the guess",
                WithUnit {
                    value: guess,
                    is_angle: true
                },
                WithUnit {
                    value: spacing,
                    is_angle: true
                }
            ),
            Self::NotFinite { quantity } => write!(
                formatter,
                "{quantity}: not finite, that is NaN, infinite, or too large or too small for the number type; \
                 check parameters and inputs"
            ),
        }
    }
}

crate::__debug_by_display!(Failure);

impl Error for Failure {}

/// The reason why a solver found no position, and where.
///
/// ```
/// use kin_core::{Failure, InputValues, Quantity};
///
/// const INPUTS: [Quantity; 1] = [Quantity::angle("theta2", "crank")];
/// let inputs = InputValues::new(&INPUTS, &[1.956]);
/// let error = Failure::OutOfReach { margin: -0.0123 }.at("theta3, theta4", inputs);
/// assert!(error.to_string().starts_with(
///     "theta3, theta4 cannot be found at theta2 = 1.956 rad (112.1°): out of reach by 0.0123"
/// ));
/// assert_eq!(error.margin(), Some(-0.0123));
/// ```
///
/// `Debug` prints the same sentence, because that is what `unwrap` and a `main` that returns the error show.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SolveError {
    /// The reason.
    pub failure: Failure,
    /// The unknowns of the block, separated by commas.
    pub block: Name,
    /// The inputs of the solver.
    pub inputs: InputValues,
}

impl SolveError {
    /// The missing length when the mechanism is out of reach, as a negative number in its units; zero in a singular
    /// position. `None` if the failure is of another kind.
    #[must_use]
    pub fn margin(&self) -> Option<f64> {
        match self.failure {
            Failure::OutOfReach { margin } => Some(margin),
            Failure::Singular { .. } => Some(0.0),
            _ => None,
        }
    }
}

impl fmt::Display for SolveError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} cannot be found", self.block)?;
        if self.inputs.iter().next().is_some() {
            write!(formatter, " at {}", self.inputs)?;
        }
        write!(formatter, ": {}", self.failure)
    }
}

crate::__debug_by_display!(SolveError);

impl Error for SolveError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        // The message already contains the message of the failure.
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{Failure, SolveError};
    use crate::failure::InputValues;
    use crate::quantity::Quantity;
    use std::{format, string::ToString};

    #[test]
    fn a_result_stays_small_enough_to_return() {
        // Above 128 bytes, common lints warn users of every function that returns the error.
        assert!(size_of::<SolveError>() < 128);
    }

    #[test]
    fn messages_say_what_where_and_what_to_do() {
        const INPUTS: [Quantity<'_>; 2] = [Quantity::angle("theta2", ""), Quantity::length("x", "")];
        let inputs = InputValues::new(&INPUTS, &[1.954, 3.0]);
        for (failure, message) in [
            (
                Failure::Singular { determinant: 0.0 },
                "theta3 cannot be found at theta2 = 1.954 rad (112.0°), x = 3: singular position, a dead point or the \
                 limit of the range, where the two assemblies meet and rates are not defined (determinant 0); \
                 stop short of it, or drive the mechanism by another input",
            ),
            (
                Failure::OutOfRange {
                    unknown: "theta3".into(),
                    value: 4.0,
                    low: 0.0,
                    high: core::f64::consts::PI,
                    is_angle: true,
                },
                "theta3 cannot be found at theta2 = 1.954 rad (112.0°), x = 3: theta3 = 4 rad (229.2°) lies outside \
                 its declared range from 0 rad (0.0°) to 3.141593 rad (180.0°); widen the range, or change dimensions \
                 or inputs",
            ),
            (
                Failure::Ambiguous {
                    unknown: "theta3".into(),
                    first: -1.0,
                    second: 1.0,
                    is_angle: false,
                },
                "theta3 cannot be found at theta2 = 1.954 rad (112.0°), x = 3: the declared range of theta3 holds both \
                 solutions, -1 and 1; narrow it until one is left",
            ),
            (
                Failure::OutsideDomain {
                    function: "asin",
                    argument: 1.25,
                },
                "theta3 cannot be found at theta2 = 1.954 rad (112.0°), x = 3: asin is not defined for 1.25; \
                 change dimensions or inputs",
            ),
            (
                Failure::NotConverged {
                    residual: 0.25,
                    iterations: 12,
                    condition: 3.5e9,
                },
                "theta3 cannot be found at theta2 = 1.954 rad (112.0°), x = 3: no solution found near the guess, a \
                 residual of 0.25 is left after 12 steps (condition of the Jacobian 3.5e9); start from a better guess, \
                 track from a known pose, or bring the inputs back within reach",
            ),
            (
                Failure::TooManyRevolutions {
                    unknown: "theta3".into(),
                    guess: 1e15,
                    spacing: 0.125,
                },
                "theta3 cannot be found at theta2 = 1.954 rad (112.0°), x = 3: the guess for theta3 is 1e15 rad, where \
                 neighbouring numbers are 0.125 rad (7.2°) apart and define no direction; subtract whole turns from \
                 the guess",
            ),
            (
                Failure::not_finite("r1"),
                "theta3 cannot be found at theta2 = 1.954 rad (112.0°), x = 3: r1: not finite, that is NaN, infinite, \
                 or too large or too small for the number type; check parameters and inputs",
            ),
        ] {
            let error = failure.at("theta3", inputs);
            assert_eq!(error.to_string(), message);
            assert_eq!(format!("{error:?}"), message, "what a `main` that fails prints");
        }
    }

    #[test]
    fn without_inputs_none_are_mentioned() {
        let error = Failure::OutOfReach { margin: -2.0 }.at("x", InputValues::new(&[], &[]));
        assert!(error.to_string().starts_with("x cannot be found: out of reach by 2 "));
    }
}
