//! Steps with a decision in them.

use kin_compiler::lowered::{Returns, Selection};
use kin_core::any::Name;

use kin_core::__private::live::NewtonMemory;

use super::{Operations, Register};
use crate::memory::Lengths;

/// A step with a decision in it. Its arguments stand in registers.
#[derive(Debug)]
pub(crate) enum Call {
    Finite {
        to: Register,
        a: Register,
        label: Name,
    },
    /// A decisive number with its terms.
    Decisive {
        to: Register,
        terms: Box<[Register]>,
    },
    /// A vector with the terms that decide whether it is zero.
    DecisiveVector {
        to: [Register; 2],
        terms: Box<[Register]>,
    },
    Check {
        to: Register,
        guard: Guard,
        argument: Register,
        label: Name,
    },
    Solve {
        form: ClosedForm,
        arguments: Box<[Argument]>,
        selection: Option<Selection>,
        returns: Returns,
        results: Box<[Register]>,
        label: Name,
    },
    /// One direction: y, x and length.
    Angle {
        to: Register,
        y: Register,
        x: Register,
        length: Option<Register>,
    },
    /// Two directions in one call.
    TwoAngles {
        to: [Register; 2],
        y: [Register; 2],
        x: [Register; 2],
        lengths: Option<[Register; 2]>,
    },
    InRange {
        unknown: Register,
        name: Name,
        is_periodic: bool,
        range: [f64; 2],
        label: Name,
    },
    Unwrap {
        unknown: Register,
        index: usize,
    },
    /// The beginning of a part of the code that is run for both solutions.
    Candidate,
    /// The end of such a part, from which the run goes back for the second solution.
    Choose {
        /// The number of operations from the beginning.
        back: usize,
        /// The values that are kept, and two sets of registers for those of the candidates.
        kept: Box<[Register]>,
        candidates: [Register; 2],
        ranges: Box<[Range]>,
        label: Name,
    },
    Newton {
        /// The indices of the unknowns.
        unknowns: Box<[usize]>,
        registers: Box<[Register]>,
        are_lengths: Box<[bool]>,
        lengths: Box<[Register]>,
        body: Operations,
        residuals: Box<[Register]>,
        /// Row by row.
        jacobian: Box<[Register]>,
        label: Name,
    },
    Every {
        block: usize,
        coefficients: Box<[Register]>,
        results: Box<[Register]>,
        label: Name,
    },
    Factor {
        /// The index of the factors.
        factors: usize,
        size: usize,
        /// Row by row.
        matrix: Box<[Register]>,
        label: Name,
    },
    Substitute {
        factors: usize,
        right: Box<[Register]>,
        results: Box<[Register]>,
    },
    Regular {
        to: Register,
        value: Register,
        label: Name,
    },
}

impl Call {
    /// The memory beside registers that the call takes.
    pub(crate) fn lengths(&self) -> Lengths {
        let row = |row| Lengths {
            row,
            ..Lengths::default()
        };
        match self {
            Self::Decisive { terms, .. } | Self::DecisiveVector { terms, .. } => row(terms.len()),
            Self::Newton {
                unknowns,
                lengths: sizes,
                ..
            } => {
                let [numbers, reals, rows] = NewtonMemory::<f64>::lengths(unknowns.len());
                Lengths {
                    row: sizes.len().max(2 * unknowns.len() + numbers),
                    reals,
                    rows,
                    ..Lengths::default()
                }
            }
            Self::Every {
                coefficients, results, ..
            } => row(coefficients.len() + results.len()),
            Self::Substitute { right, .. } => row(2 * right.len()),
            _ => Lengths::default(),
        }
    }
}

/// An argument of a closed form.
#[derive(Debug)]
pub(crate) enum Argument {
    Scalar(Register),
    Plane([Register; 2]),
    Pair([Register; 2]),
    Matrix([[Register; 2]; 2]),
    Known(f64),
}

/// A range that decides between two candidates.
#[derive(Debug)]
pub(crate) struct Range {
    /// The index of the unknown among the values that are kept.
    pub(crate) kept: usize,
    pub(crate) name: Name,
    pub(crate) is_periodic: bool,
    pub(crate) bounds: [f64; 2],
}

macro_rules! guards {
    ($($variant:ident $function:ident)+) => {
        /// A function of `kin_core::solve` that checks its argument.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum Guard {
            $($variant,)+
        }

        impl Guard {
            /// The guard of a name.
            pub(crate) fn named(name: &str) -> Option<Self> {
                match name {
                    $(stringify!($function) => Some(Self::$variant),)+
                    _ => None,
                }
            }

            #[inline(always)]
            pub(crate) fn check<T: kin_core::Scalar>(self, argument: T) -> Result<T, kin_core::Failure> {
                match self {
                    $(Self::$variant => kin_core::__private::solve::$function(argument),)+
                }
            }
        }
    };
}

guards! {
    ArcSine arc_sine
    ArcCosine arc_cosine
    AreaHyperbolicCosine area_hyperbolic_cosine
    AreaHyperbolicTangent area_hyperbolic_tangent
    Logarithm logarithm
    SquareRootOf square_root_of
    SineOfArc sine_of_arc
    CosineOfArc cosine_of_arc
    TangentOfArc tangent_of_arc
    HyperbolicCosineOfArea hyperbolic_cosine_of_area
    SquareOfRoot square_of_root
}

macro_rules! closed_forms {
    ($($variant:ident $function:ident)+) => {
        /// A closed form of `kin_core::solve`, apart from the guards.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum ClosedForm {
            $($variant,)+
            Guard(Guard),
        }

        impl ClosedForm {
            /// The closed form of a name.
            pub(crate) fn named(name: &str) -> Option<Self> {
                match name {
                    $(stringify!($function) => Some(Self::$variant),)+
                    _ => Guard::named(name).map(Self::Guard),
                }
            }
        }
    };
}

closed_forms! {
    CircleCircle circle_circle
    CircleCircleSquared circle_circle_squared
    CircleLine circle_line
    CircleLineX circle_line_x
    CircleLineY circle_line_y
    Polar polar
    PolarOffset polar_offset
    CosineSine cosine_sine
    InverseCosine inverse_cosine
    InverseSine inverse_sine
    InverseHyperbolicCosine inverse_hyperbolic_cosine
    Linear linear
    LinearPair linear_pair
    Quadratic quadratic
    SquareRoot square_root
}
