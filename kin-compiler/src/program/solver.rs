//! The closed forms of `kin_core::solve` that generated code calls: their names, arguments, results and costs.

use super::Cost;
use crate::algebra::Checked;

/// An argument of a closed form.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum FormArgument<E> {
    Scalar(E),
    Plane([E; 2]),
    Pair([E; 2]),
    Matrix([[E; 2]; 2]),
    /// A number that is known when the code is generated.
    Known(f64),
}

impl<E> FormArgument<E> {
    /// The expressions in the argument, in the order in which they are written.
    pub(crate) fn expressions(&self) -> Vec<&E> {
        match self {
            Self::Scalar(value) => vec![value],
            Self::Plane(pair) | Self::Pair(pair) => pair.iter().collect(),
            Self::Matrix(rows) => rows.iter().flatten().collect(),
            Self::Known(_) => Vec::new(),
        }
    }

    /// The same argument with other expressions.
    pub(crate) fn map<F>(&self, mut other: impl FnMut(&E) -> F) -> FormArgument<F> {
        match self {
            Self::Scalar(value) => FormArgument::Scalar(other(value)),
            Self::Plane(pair) => FormArgument::Plane(pair.each_ref().map(other)),
            Self::Pair(pair) => FormArgument::Pair(pair.each_ref().map(other)),
            Self::Matrix(rows) => FormArgument::Matrix(rows.each_ref().map(|row| row.each_ref().map(&mut other))),
            Self::Known(number) => FormArgument::Known(*number),
        }
    }
}

/// The shape of the results of a closed form.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Returns {
    /// A number.
    Scalar,
    /// Two numbers.
    Pair,
    /// A vector.
    Plane,
    /// A root and its square.
    Root,
    /// A vector, then a root and its square.
    PlaneAndRoot,
    /// A root and its square, then a number.
    RootAndScalar,
    /// A vector and a number.
    PlaneAndScalar,
    /// A number and a vector.
    ScalarAndPlane,
}

/// A closed form of `kin_core::solve`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Solver {
    CircleCircle,
    CircleCircleSquared,
    CircleLine,
    CircleLineX,
    CircleLineY,
    Polar,
    PolarOffset,
    CosineSine,
    InverseCosine,
    InverseSine,
    Linear,
    LinearPair,
    Quadratic,
    SquareRoot,
    /// The inverse of a function.
    Inverse(&'static Checked),
    /// The inverse of an even function. It takes the function's value and a number with the sign of the open assembly.
    EvenInverse(&'static Checked),
}

impl Solver {
    /// The name in `kin_core::solve`.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::CircleCircle => "circle_circle",
            Self::CircleCircleSquared => "circle_circle_squared",
            Self::CircleLine => "circle_line",
            Self::CircleLineX => "circle_line_x",
            Self::CircleLineY => "circle_line_y",
            Self::Polar => "polar",
            Self::PolarOffset => "polar_offset",
            Self::CosineSine => "cosine_sine",
            Self::InverseCosine => "inverse_cosine",
            Self::InverseSine => "inverse_sine",
            Self::Linear => "linear",
            Self::LinearPair => "linear_pair",
            Self::Quadratic => "quadratic",
            Self::SquareRoot => "square_root",
            Self::Inverse(function) | Self::EvenInverse(function) => function.name,
        }
    }

    /// Whether the closed form takes an assembly.
    pub(crate) const fn takes_assembly(self) -> bool {
        match self {
            Self::Linear | Self::LinearPair | Self::Inverse(_) => false,
            Self::CircleCircle
            | Self::CircleCircleSquared
            | Self::CircleLine
            | Self::CircleLineX
            | Self::CircleLineY
            | Self::Polar
            | Self::PolarOffset
            | Self::CosineSine
            | Self::InverseCosine
            | Self::InverseSine
            | Self::Quadratic
            | Self::SquareRoot
            | Self::EvenInverse(_) => true,
        }
    }

    /// Whether the closed form decides by the sign of an argument whose terms it does not know.
    pub(crate) const fn decides_on(self, index: usize) -> bool {
        match self {
            Self::Linear | Self::SquareRoot | Self::Quadratic | Self::Polar => index == 0,
            Self::Inverse(function) => index == 0 && function.decides_by_sign,
            Self::EvenInverse(function) => index > 0 || function.decides_by_sign,
            Self::CircleCircle
            | Self::CircleCircleSquared
            | Self::CircleLine
            | Self::CircleLineX
            | Self::CircleLineY
            | Self::PolarOffset
            | Self::CosineSine
            | Self::InverseCosine
            | Self::InverseSine
            | Self::LinearPair => false,
        }
    }

    pub(crate) const fn returns(self) -> Returns {
        match self {
            Self::CircleCircle | Self::CosineSine => Returns::PlaneAndRoot,
            Self::CircleCircleSquared => Returns::Plane,
            Self::CircleLine => Returns::PlaneAndScalar,
            Self::CircleLineX | Self::CircleLineY => Returns::RootAndScalar,
            Self::Polar | Self::InverseCosine | Self::InverseSine => Returns::Root,
            Self::PolarOffset => Returns::ScalarAndPlane,
            Self::LinearPair => Returns::Pair,
            Self::Linear | Self::Quadratic | Self::SquareRoot | Self::Inverse(_) | Self::EvenInverse(_) => {
                Returns::Scalar
            }
        }
    }

    /// The cost in the assembly that costs more.
    pub(crate) const fn dearest(self) -> Cost {
        let (cost_of_open, crossed) = (self.cost(true), self.cost(false));
        if cost_of_open.negations > crossed.negations {
            cost_of_open
        } else {
            crossed
        }
    }

    /// The cost in an assembly. A test runs every library mechanism with counting numbers and compares.
    pub(crate) const fn cost(self, is_open: bool) -> Cost {
        let work = match self {
            Self::CircleCircle => closed_form(8, 12, 1, 1),
            Self::CircleCircleSquared => closed_form(6, 11, 1, 1),
            Self::CircleLine => closed_form(7, 10, 1, 1),
            Self::CircleLineX | Self::CircleLineY => closed_form(2, 1, 0, 1),
            Self::Polar => closed_form(1, 2, 0, 1),
            Self::PolarOffset => closed_form(5, 9, 1, 1),
            Self::CosineSine => closed_form(4, 9, 1, 1),
            Self::InverseCosine | Self::InverseSine => closed_form(2, 1, 0, 1),
            Self::Linear => closed_form(0, 0, 1, 0),
            Self::LinearPair => closed_form(3, 8, 1, 0),
            Self::Quadratic => closed_form(2, 3, 1, 1),
            Self::SquareRoot => closed_form(0, 0, 0, 1),
            Self::Inverse(function) | Self::EvenInverse(function) => Cost::of(function.cost),
        };
        // one of the assemblies changes a sign
        let changes_sign = match self {
            Self::CircleLineX | Self::CircleLineY => is_open,
            Self::CircleCircle
            | Self::CircleCircleSquared
            | Self::Polar
            | Self::PolarOffset
            | Self::CosineSine
            | Self::InverseCosine
            | Self::InverseSine
            | Self::SquareRoot
            | Self::EvenInverse(_) => !is_open,
            Self::CircleLine | Self::Linear | Self::LinearPair | Self::Quadratic | Self::Inverse(_) => false,
        };
        let negations = if changes_sign { 1 } else { 0 };
        Cost { negations, ..work }
    }
}

/// The cost of a closed form in which only one of the assemblies adds an operation.
const fn closed_form(additions: usize, multiplications: usize, divisions: usize, square_roots: usize) -> Cost {
    Cost {
        additions,
        multiplications,
        divisions,
        square_roots,
        ..Cost::NONE
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::fs;

    use quote::ToTokens;

    use super::*;
    use crate::algebra::{Function, Inverse, InverseFunction};

    /// The functions of `kin_core::solve`: whether the last argument is an assembly, and the type in `Ok`.
    fn functions() -> BTreeMap<String, (bool, String)> {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../kin-runtime/src/solve");
        let rooms = ["forms", "check"].map(|room| fs::read_dir(format!("{folder}/{room}")));
        let mut functions = BTreeMap::new();
        for file in rooms.into_iter().flat_map(|room| room.expect("there are closed forms")) {
            let path = file.expect("it can be read").path();
            let text = fs::read_to_string(path).expect("it is text");
            for item in syn::parse_file(&text).expect("it is Rust").items {
                let syn::Item::Fn(function) = item else { continue };
                let signature = function.sig;
                let last = signature.inputs.last().map(|input| input.to_token_stream().to_string());
                let returned = signature.output.to_token_stream().to_string().replace(' ', "");
                let returned = returned
                    .trim_start_matches("->Result<")
                    .trim_end_matches(",Failure>")
                    .to_owned();
                functions.insert(
                    signature.ident.to_string(),
                    (last.is_some_and(|last| last == "assembly : Assembly"), returned),
                );
            }
        }
        functions
    }

    /// The calls in generated code match the declarations of the closed forms: names, arguments and results.
    #[test]
    fn solvers_are_what_is_declared_in_kin_core() {
        let functions = functions();
        let mut solvers = vec![
            Solver::CircleCircle,
            Solver::CircleCircleSquared,
            Solver::CircleLine,
            Solver::CircleLineX,
            Solver::CircleLineY,
            Solver::Polar,
            Solver::PolarOffset,
            Solver::CosineSine,
            Solver::InverseCosine,
            Solver::InverseSine,
            Solver::Linear,
            Solver::LinearPair,
            Solver::Quadratic,
            Solver::SquareRoot,
        ];
        for function in Function::ALL {
            solvers.extend(function.guard().map(Solver::Inverse));
            solvers.extend(match function.inverse() {
                Inverse::None | Inverse::One(InverseFunction::Elementary(_)) => None,
                Inverse::One(InverseFunction::Checked(inverse)) => Some(Solver::Inverse(inverse)),
                Inverse::Even(inverse) => Some(Solver::EvenInverse(inverse)),
            });
        }
        for solver in solvers {
            let (takes_assembly, returned) = &functions[solver.name()];
            assert_eq!(solver.takes_assembly(), *takes_assembly, "{solver:?}");
            let expected = match solver.returns() {
                Returns::Scalar => "T",
                Returns::Pair => "(T,T)",
                Returns::Plane => "Plane<T>",
                Returns::Root => "Root<T>",
                Returns::PlaneAndRoot => "(Plane<T>,Root<T>)",
                Returns::RootAndScalar => "(Root<T>,T)",
                Returns::PlaneAndScalar => "(Plane<T>,T)",
                Returns::ScalarAndPlane => "(T,Plane<T>)",
            };
            assert_eq!(returned, expected, "{solver:?}");
        }
    }
}
