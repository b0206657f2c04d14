//! The run-time closed forms that generated code calls: their names and what they cost.

use std::ops::Add;

use crate::expr::Node;

/// Operations, by kind.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Cost {
    pub(crate) additions: usize,
    pub(crate) multiplications: usize,
    pub(crate) divisions: usize,
    pub(crate) negations: usize,
    pub(crate) square_roots: usize,
    pub(crate) sine_cosines: usize,
    pub(crate) arc_tangents: usize,
    pub(crate) others: usize,
}

impl Cost {
    /// Everything but roots, trigonometry and other functions.
    pub(crate) const fn arithmetic(self) -> usize {
        self.additions + self.multiplications + self.divisions + self.negations
    }

    /// All of it in operations, of which a function is worth many.
    pub(crate) const fn total(self) -> usize {
        self.arithmetic() + 20 * (self.square_roots + self.sine_cosines + self.arc_tangents + self.others)
    }
}

impl Cost {
    /// Of factoring a matrix of so many rows, see `kin_core::solve::factor`.
    pub(crate) const fn of_factors(size: usize) -> Self {
        let mut products = 0;
        let mut rows = 1;
        while rows < size {
            products += rows * rows;
            rows += 1;
        }
        // rows and columns are levelled by powers of two
        let levelling = 2 * size * size;
        Self {
            additions: products,
            multiplications: products + levelling,
            divisions: size * (size - 1) / 2,
            negations: 0,
            square_roots: 0,
            sine_cosines: 0,
            arc_tangents: 0,
            others: 0,
        }
    }

    /// Of solving by the factors of a matrix of so many rows, see `kin_core::solve::Factors::solve`.
    pub(crate) const fn of_substitution(size: usize) -> Self {
        Self {
            additions: size * (size - 1),
            multiplications: size * (size + 1),
            divisions: size,
            negations: 0,
            square_roots: 0,
            sine_cosines: 0,
            arc_tangents: 0,
            others: 0,
        }
    }
}

impl Add for Cost {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            additions: self.additions + other.additions,
            multiplications: self.multiplications + other.multiplications,
            divisions: self.divisions + other.divisions,
            negations: self.negations + other.negations,
            square_roots: self.square_roots + other.square_roots,
            sine_cosines: self.sine_cosines + other.sine_cosines,
            arc_tangents: self.arc_tangents + other.arc_tangents,
            others: self.others + other.others,
        }
    }
}

/// What is handed to a closed form.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Argument {
    Scalar(Node),
    Plane(Node, Node),
    Pair([Node; 2]),
    Matrix([[Node; 2]; 2]),
}

/// The shape of what is handed to a closed form.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Shape {
    Scalar,
    Plane,
    Pair,
    Matrix,
}

impl Argument {
    pub(crate) const fn shape(&self) -> Shape {
        match self {
            Self::Scalar(_) => Shape::Scalar,
            Self::Plane(..) => Shape::Plane,
            Self::Pair(_) => Shape::Pair,
            Self::Matrix(_) => Shape::Matrix,
        }
    }

    /// The expressions in it.
    pub(crate) fn nodes(&self) -> Vec<Node> {
        match *self {
            Self::Scalar(node) => vec![node],
            Self::Plane(x, y) => vec![x, y],
            Self::Pair(pair) => pair.to_vec(),
            Self::Matrix([first, second]) => [first, second].concat(),
        }
    }
}

/// The shape of what a closed form returns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Returns {
    Scalar,
    Pair,
    Plane,
    Root,
    PlaneAndRoot,
    RootAndScalar,
    PlaneAndScalar,
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
    SineOfArc,
    CosineOfArc,
    TangentOfArc,
    SquareOfRoot,
    Logarithm,
}

impl Solver {
    /// Its name in `kin_core::solve`.
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
            Self::SineOfArc => "sine_of_arc",
            Self::CosineOfArc => "cosine_of_arc",
            Self::TangentOfArc => "tangent_of_arc",
            Self::SquareOfRoot => "square_of_root",
            Self::Logarithm => "logarithm",
        }
    }

    /// Whether it takes an assembly.
    pub(crate) const fn takes_assembly(self) -> bool {
        !matches!(
            self,
            Self::Linear
                | Self::LinearPair
                | Self::SineOfArc
                | Self::CosineOfArc
                | Self::TangentOfArc
                | Self::SquareOfRoot
                | Self::Logarithm
        )
    }

    pub(crate) const fn returns(self) -> Returns {
        match self {
            Self::CircleCircle => Returns::PlaneAndRoot,
            Self::CircleCircleSquared | Self::CosineSine => Returns::Plane,
            Self::CircleLine => Returns::PlaneAndScalar,
            Self::CircleLineX | Self::CircleLineY => Returns::RootAndScalar,
            Self::Polar | Self::InverseCosine | Self::InverseSine => Returns::Root,
            Self::PolarOffset => Returns::ScalarAndPlane,
            Self::LinearPair => Returns::Pair,
            _ => Returns::Scalar,
        }
    }

    /// What it costs in the assembly that costs more.
    pub(crate) const fn dearest(self) -> Cost {
        let (open, crossed) = (self.cost(true), self.cost(false));
        if open.negations > crossed.negations {
            open
        } else {
            crossed
        }
    }

    /// What it costs in an assembly; a test runs every library mechanism with counting numbers and compares.
    pub(crate) const fn cost(self, is_open: bool) -> Cost {
        let (additions, multiplications, divisions, square_roots) = match self {
            Self::CircleCircle => (8, 12, 1, 1),
            Self::CircleCircleSquared => (6, 11, 1, 1),
            Self::CircleLine => (7, 10, 1, 1),
            Self::CircleLineX | Self::CircleLineY => (2, 1, 0, 1),
            Self::Polar => (1, 2, 0, 1),
            Self::PolarOffset => (5, 9, 1, 1),
            Self::CosineSine => (4, 9, 1, 1),
            Self::InverseCosine | Self::InverseSine => (2, 1, 0, 1),
            Self::Linear => (0, 0, 1, 0),
            Self::LinearPair => (3, 8, 1, 0),
            Self::Quadratic => (2, 3, 1, 1),
            Self::SquareRoot => (0, 0, 0, 1),
            Self::SquareOfRoot => (0, 1, 0, 0),
            Self::TangentOfArc => (0, 0, 1, 0),
            Self::SineOfArc | Self::CosineOfArc | Self::Logarithm => (0, 0, 0, 0),
        };
        // one of the assemblies changes a sign
        let changes_sign = match self {
            Self::CircleLineX | Self::CircleLineY => is_open,
            Self::CircleCircle
            | Self::CircleCircleSquared
            | Self::Polar
            | Self::PolarOffset
            | Self::InverseCosine
            | Self::InverseSine
            | Self::SquareRoot => !is_open,
            _ => false,
        };
        let negations = if changes_sign { 1 } else { 0 };
        let (sine_cosines, others) = match self {
            Self::SineOfArc | Self::CosineOfArc | Self::TangentOfArc => (1, 0),
            Self::Logarithm => (0, 1),
            _ => (0, 0),
        };
        Cost {
            additions,
            multiplications,
            divisions,
            negations,
            square_roots,
            sine_cosines,
            arc_tangents: 0,
            others,
        }
    }
}
