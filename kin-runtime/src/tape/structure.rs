//! What a [`Tape`] consists of, for printers of other languages.

use std::collections::BTreeSet;
use std::string::String;
use std::vec::Vec;

use crate::mechanism::{Description, Named};
use crate::picture::Outline;
use crate::quantity::{Dimension, Name};

pub use super::node::{Comparison, Constant, Function, Operator, TapeNode, Value};

/// A solver as straight-line code: arguments, operations, checks, results.
///
/// The [nodes](Self::nodes) stand behind their operands. The [steps](Self::steps) say what is done, one after the
/// other: a node is computed, a check made, a search run. [`Tape::run`] does just that and is the shortest complete
/// reading of this structure.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Tape<'d> {
    /// The description of the mechanism: its name, equations and blocks.
    pub description: Description<'d>,
    /// Which of the joints among the results belong together. It is [`Outline::NONE`] unless the skeleton was asked
    /// for.
    pub outline: Outline<'d>,
    /// The number type for which the tape was recorded. Its ε and its smallest number are in the constants.
    pub precision: NumberType,
    /// The highest time derivative among the results.
    pub order: usize,
    /// The dimensions that were folded in as constants: all of them in the order of the description, or none.
    pub folded: Vec<f64>,
    /// What the function is given, in the order of their indices.
    pub arguments: Vec<Argument<'d>>,
    /// The operations. Every node is used, directly or indirectly, by a result or by a check.
    pub nodes: Vec<TapeNode>,
    /// What is done, in this order.
    pub steps: Vec<TapeStep>,
    /// What is found, position by position: all orders of a quantity follow each other.
    pub results: Vec<TapeResult<'d>>,
    /// The decisions. If one fails, there is no pose.
    pub checks: Vec<TapeCheck>,
    /// The blocks that Newton's method solves.
    pub searches: Vec<NewtonSearch>,
    /// The linear systems whose pivots are chosen at run time.
    pub systems: Vec<System>,
    /// The solutions of those systems.
    pub solutions: Vec<LinearSolution>,
}

impl Tape<'_> {
    /// The block of a check, with its name.
    pub(super) fn block_of(&self, check: &TapeCheck) -> Named<'_, Name> {
        Named::new(check.block, &self.description)
    }

    /// The nodes outside of a search, and no constants, that its equations need, in ascending order.
    pub(super) fn given(&self, search: usize) -> Vec<Value> {
        let sought = &self.searches[search];
        let mut given = BTreeSet::new();
        let mut need = |value: Value| {
            let is_plain = matches!(
                self.nodes[value.index()],
                TapeNode::Constant(_) | TapeNode::Certain(_) | TapeNode::Unknown { .. }
            );
            if !is_plain && !sought.body.contains(&value) {
                given.insert(value);
            }
        };
        for value in &sought.body {
            self.nodes[value.index()].operands(&mut need);
        }
        let equations = sought.residuals.iter().chain(sought.jacobian.iter().flatten());
        equations.copied().for_each(&mut need);
        given.into_iter().collect()
    }
}

/// A number type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NumberType {
    /// `f32`, the `float` of C.
    Single,
    /// `f64`, the `double` of C.
    Double,
}

/// A number that a tape is given.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Argument<'d> {
    /// The quantity to which it belongs.
    pub role: Role,
    /// The name of the quantity as declared. The parts of a point `p` are `p.x`, `p.y` and, in space, `p.z`. That of an
    /// assembly is the field of the assembly structure, or `assembly` if there is only one choice.
    pub name: String,
    /// The dimension of the quantity. An input of order n has this over the n-th power of time.
    pub dimension: Dimension,
    /// The first paragraph of its documentation, or an empty string.
    pub description: &'d str,
}

/// The quantity that a number belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Role {
    /// The dimension with this index: a parameter of the mechanism.
    Parameter(usize),
    /// A time derivative of an input.
    Input {
        /// The index of the input.
        input: usize,
        /// The order of the derivative; 0 is the position.
        order: usize,
    },
    /// A value near the unknown with this index. A mechanism with coupled blocks has one for each unknown.
    Near(usize),
    /// The assembly of the choice with this index: 1 for open, -1 for crossed.
    Assembly(usize),
}

/// A number that a tape finds.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct TapeResult<'d> {
    /// The quantity to which it belongs.
    pub quantity: ResultOf,
    /// The order of its time derivative; 0 is the position.
    pub order: usize,
    /// The name of the quantity as declared. The coordinates of a joint are `joints.0.x`, `joints.0.y` and so on, the
    /// direction of a slide is `slides.0.x` and so on.
    pub name: String,
    /// The dimension of the quantity. One of order n has this over the n-th power of time, and a partial derivative the
    /// dimension over that of its parameter.
    pub dimension: Dimension,
    /// The first paragraph of its documentation, or an empty string.
    pub description: &'d str,
    /// The node that finds it.
    pub value: Value,
}

/// The quantity that a result belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ResultOf {
    /// The unknown with this index.
    Unknown(usize),
    /// The scalar output with this index.
    Output(usize),
    /// A coordinate of a joint of the skeleton.
    Joint {
        /// The index of the joint.
        joint: usize,
        /// 0 for x, 1 for y, 2 for z.
        axis: usize,
    },
    /// A coordinate of the direction of a slide of the skeleton.
    Slide {
        /// The index of the slide.
        slide: usize,
        /// 0 for x, 1 for y, 2 for z.
        axis: usize,
    },
    /// The partial derivative of an unknown with respect to a parameter.
    UnknownPartial {
        /// The index of the unknown.
        unknown: usize,
        /// The index of the parameter.
        parameter: usize,
    },
    /// The partial derivative of a scalar output with respect to a parameter.
    OutputPartial {
        /// The index of the output.
        output: usize,
        /// The index of the parameter.
        parameter: usize,
    },
}

/// Something that is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TapeStep {
    /// The node is computed. Constants and arguments have no step.
    Compute(Value),
    /// The check with this index is made.
    Check(usize),
    /// The search with this index is run. Its check follows.
    Search(usize),
    /// The linear system with this index is factored. Its check follows.
    Factor(usize),
    /// The solution with this index is found.
    Solve(usize),
}

/// A decision. If it fails, there is no pose: the function returns the index of the check and the margin.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct TapeCheck {
    /// The subject of the check, in a few words.
    pub name: &'static str,
    /// The unknowns of the block in which it is made, separated by commas, as in the error of `solve`. [`Named`] shows
    /// an index with its name.
    pub block: Name,
    /// The lowest order that needs it: 0 if the position does.
    pub order: usize,
    /// What must hold.
    pub condition: Condition,
    /// The steps for the margin, if the check fails. No other step uses their nodes.
    pub cold: Vec<Value>,
    /// The distance from failing. It is negative if something is out of reach by that much, about zero in a singular
    /// position, and not finite if a number is not. For a search or a system it is `None`: the run time gives the
    /// largest residual of the search where it stopped, or the determinant of the system.
    pub margin: Option<Value>,
}

/// What must hold in a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Condition {
    /// The node is true.
    Holds(Value),
    /// The search with this index has found a root.
    Found(usize),
    /// The linear system with this index is not singular.
    Regular(usize),
}

/// A block of coupled equations, solved by Newton's method from a guess. See [`solve::newton`](crate::solve::newton())
/// for the method.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct NewtonSearch {
    /// The guess of each unknown.
    pub guess: Vec<Value>,
    /// The natural size of each unknown.
    pub sizes: Vec<Value>,
    /// The nodes of residuals and Jacobian that depend on the [unknowns](TapeNode::Unknown), in the order in which they
    /// are computed.
    pub body: Vec<Value>,
    /// The residual of each equation.
    pub residuals: Vec<Value>,
    /// The Jacobian, one row of partial derivatives for each equation.
    pub jacobian: Vec<Vec<Value>>,
}

/// A linear system. See [`solve::factor`](crate::solve::factor()) for the method.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct System {
    /// The rows of the matrix.
    pub rows: Vec<Vec<Value>>,
}

/// The solution of a linear system for one right-hand side.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct LinearSolution {
    /// The index of the system.
    pub system: usize,
    /// The right-hand side.
    pub right: Vec<Value>,
}
