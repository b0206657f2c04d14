//! Formulas as they are calculated, operator by operator.
//!
//! Every decision has been taken: which function of a vector is called, where a scalar becomes a vector, what is built
//! upon what. So a program that follows a tree calculates what generated code calculates, to the last bit.

use crate::algebra::Function;
use crate::syntax::{Axis, ValueShape};

/// The methods of a mechanism that are translated from its syntax tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheets {
    /// `closure`: the residuals of the equations.
    pub closure: Sheet,
    /// `outputs_at`: the outputs, vectors part by part.
    pub outputs: Sheet,
    /// `skeleton_points`: the joints of the outline as vectors, then the directions of its slides.
    pub skeleton_points: Sheet,
    /// The parts of the picture.
    pub outline: Outline,
}

/// The picture of a mechanism: what `kin_core::Outline` says, with further names. Joints are numbered as the points
/// are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outline {
    /// Whether it is drawn in the plane or in space.
    pub shape: ValueShape,
    /// The number of its joints.
    pub joints: usize,
    /// The joints that stand still.
    pub ground: Vec<usize>,
    /// The rigid bodies that move.
    pub bodies: Vec<Body>,
    /// The joints that are guided along a line.
    pub slides: Vec<Slide>,
    /// The marked points, each with its joint.
    pub points: Vec<(String, usize)>,
    /// The equations that are no vectors, as that of a gear.
    pub scalar_equations: Vec<String>,
    /// The statements that would declare it, if it follows from the vector equations.
    pub guess: Option<String>,
}

/// A rigid body that moves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Body {
    /// The name as it was declared, or the length that the body is known by.
    pub name: String,
    /// Its joints.
    pub joints: Vec<usize>,
}

/// A joint that is guided along a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slide {
    /// The joint.
    pub joint: usize,
    /// The body that carries the line, `None` for the ground.
    pub guide: Option<usize>,
}

/// A method: local values, each made of those before it, and its results.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The local values, in the order in which they are calculated.
    pub bindings: Vec<Binding>,
    /// The results.
    pub results: Vec<Tree>,
}

/// A local value.
#[derive(Clone, Debug, PartialEq)]
pub struct Binding {
    /// What it is.
    pub local: Local,
    /// Its value.
    pub value: Tree,
}

/// The local values of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Local {
    /// An abbreviation, by its number among the `let` statements.
    Abbreviation(usize),
    /// The residual of a vector equation, by its number among the equations.
    Equation(usize),
    /// An output that is a vector, by its number among the outputs.
    Output(usize),
    /// A joint of the picture.
    Joint(usize),
}

/// A formula with the shape of its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Tree {
    /// The shape of its value.
    pub shape: ValueShape,
    /// How it is calculated.
    pub kind: TreeKind,
}

/// How a value is calculated.
#[derive(Clone, Debug, PartialEq)]
pub enum TreeKind {
    /// A number.
    Number(f64),
    /// π.
    Pi,
    /// A parameter, by the number of its first scalar.
    Parameter(usize),
    /// An input.
    Input(usize),
    /// An unknown.
    Unknown(usize),
    /// A value that has been calculated before.
    Local(Local),
    /// A value with a minus sign in front.
    Negative(Box<Tree>),
    /// A value that changes step by step. So a long sum is not a deep tree.
    Chain {
        /// The value before the steps.
        first: Box<Tree>,
        /// What happens to it.
        steps: Vec<Step>,
    },
    /// A function of as many arguments as it takes.
    Call(Operation, Vec<Tree>),
    /// `T::powi`.
    Power(Box<Tree>, i32),
    /// A part of a vector.
    Part(Box<Tree>, Axis),
}

/// What happens to the value of a chain.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// The text gives the value a name, so that it is not nested too deep.
    Named,
    /// The scalar becomes a vector of this shape along x.
    Lifted(ValueShape),
    /// Value plus operand.
    Plus(Tree),
    /// Value minus operand.
    Minus(Tree),
    /// Value times operand, both scalars.
    Times(Tree),
    /// Value by operand, both scalars.
    Over(Tree),
    /// `scale(value, operand)`: the value is a vector.
    ScaledBy(Tree),
    /// `scale(operand, value)`: the operand is a vector.
    Scaling(Tree),
    /// `scale(value, one / operand)`: the value is a vector.
    ScaledByInverse(Tree),
    /// `Plane::polar(value, operand)`: the value is a length, the operand an angle.
    LengthAt(Tree),
    /// `Plane::times(value, operand)`: the product of complex numbers.
    ComplexTimes(Tree),
    /// `Rotation::times(value, operand)`.
    RotationTimes(Tree),
    /// `Rotation::rotate(value, operand)`: the operand is a vector.
    Rotating(Tree),
}

/// A function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// `T::sin_cos(..).0`
    Sine,
    /// `T::sin_cos(..).1`
    Cosine,
    /// Sine by cosine of one `T::sin_cos`.
    Tangent,
    /// The method of `T` with the function's name.
    Method(Function),
    /// The zero vector.
    Zero,
    /// A vector of its parts.
    Vector,
    /// A vector along x, with a scalar as its first part.
    Lifted,
    /// A vector of the plane as one of space, in the plane of x and y.
    InSpace,
    /// `Plane::cis`
    Cis,
    /// `Plane::polar`
    Polar,
    /// `Rotation::about_x`
    AboutX,
    /// `Rotation::about_y`
    AboutY,
    /// `Rotation::about_z`
    AboutZ,
    /// `Rotation::about`
    About,
    /// `dot` of two vectors.
    Dot,
    /// `cross` of two vectors: a scalar in the plane, a vector in space.
    Cross,
    /// `norm` of a vector.
    Norm,
}

impl Step {
    /// The operand.
    #[must_use]
    pub fn operand(&self) -> Option<&Tree> {
        match self {
            Self::Named | Self::Lifted(_) => None,
            Self::Plus(operand)
            | Self::Minus(operand)
            | Self::Times(operand)
            | Self::Over(operand)
            | Self::ScaledBy(operand)
            | Self::Scaling(operand)
            | Self::ScaledByInverse(operand)
            | Self::LengthAt(operand)
            | Self::ComplexTimes(operand)
            | Self::RotationTimes(operand)
            | Self::Rotating(operand) => Some(operand),
        }
    }
}

impl Tree {
    pub(crate) fn new(shape: ValueShape, kind: TreeKind) -> Self {
        Self { shape, kind }
    }

    pub(crate) fn scalar(kind: TreeKind) -> Self {
        Self::new(ValueShape::Scalar, kind)
    }

    pub(crate) fn number(value: f64) -> Self {
        Self::scalar(TreeKind::Number(value))
    }

    pub(crate) fn call(shape: ValueShape, operation: Operation, arguments: Vec<Self>) -> Self {
        Self::new(shape, TreeKind::Call(operation, arguments))
    }

    pub(crate) fn local(shape: ValueShape, local: Local) -> Self {
        Self::new(shape, TreeKind::Local(local))
    }

    pub(crate) fn negated(self) -> Self {
        Self::new(self.shape, TreeKind::Negative(Box::new(self)))
    }

    /// The parts of a vector.
    pub(crate) fn parts(&self) -> impl Iterator<Item = Self> {
        let axes = self.shape.axes().iter();
        axes.map(|&axis| Self::scalar(TreeKind::Part(Box::new(self.clone()), axis)))
    }

    /// Calls `visit` on the tree and all trees in it.
    pub(crate) fn visit(&self, visit: &mut dyn FnMut(&Self)) {
        visit(self);
        match &self.kind {
            TreeKind::Number(_)
            | TreeKind::Pi
            | TreeKind::Parameter(_)
            | TreeKind::Input(_)
            | TreeKind::Unknown(_)
            | TreeKind::Local(_) => {}
            TreeKind::Negative(of) | TreeKind::Power(of, _) | TreeKind::Part(of, _) => of.visit(visit),
            TreeKind::Chain { first, steps } => {
                first.visit(visit);
                for operand in steps.iter().filter_map(Step::operand) {
                    operand.visit(visit);
                }
            }
            TreeKind::Call(_, arguments) => {
                for argument in arguments {
                    argument.visit(visit);
                }
            }
        }
    }
}

impl Sheet {
    /// Calls `visit` on all trees.
    pub(crate) fn visit(&self, visit: &mut dyn FnMut(&Tree)) {
        for tree in self.bindings.iter().map(|binding| &binding.value).chain(&self.results) {
            tree.visit(visit);
        }
    }
}
