//! How each language spells functions and operators. What else the languages differ in, their printers know.

use std::vec::Vec;

use crate::tape::expression::Code;
use crate::tape::{Comparison, Function, Operator, TapeNode, Value};

/// A language, by its column in the table.
#[derive(Clone, Copy)]
pub(super) enum Target {
    C,
    JavaScript,
    Python,
}

/// The spellings of an operation in C, JavaScript and Python: an operator, or the name of a function.
const fn spellings(node: &TapeNode) -> [&'static str; 3] {
    match node {
        TapeNode::Call(function, _) => match function {
            Function::Negate => ["-"; 3],
            Function::Magnitude => ["fabs", "Math.abs", "np.abs"],
            Function::SquareRoot => ["sqrt", "Math.sqrt", "np.sqrt"],
            Function::Sine => ["sin", "Math.sin", "np.sin"],
            Function::Cosine => ["cos", "Math.cos", "np.cos"],
            Function::ArcSine => ["asin", "Math.asin", "np.arcsin"],
            Function::ArcCosine => ["acos", "Math.acos", "np.arccos"],
            Function::ArcTangent => ["atan", "Math.atan", "np.arctan"],
            Function::HyperbolicSine => ["sinh", "Math.sinh", "np.sinh"],
            Function::HyperbolicCosine => ["cosh", "Math.cosh", "np.cosh"],
            Function::HyperbolicTangent => ["tanh", "Math.tanh", "np.tanh"],
            Function::AreaHyperbolicSine => ["asinh", "Math.asinh", "np.arcsinh"],
            Function::AreaHyperbolicCosine => ["acosh", "Math.acosh", "np.arccosh"],
            Function::AreaHyperbolicTangent => ["atanh", "Math.atanh", "np.arctanh"],
            Function::Exponential => ["exp", "Math.exp", "np.exp"],
            Function::Logarithm => ["log", "Math.log", "np.log"],
            // `Math.round` and `np.round` do not round halves away from zero.
            Function::Round => ["round", "kinRound", "_round"],
            Function::Raise => ["ceil", "Math.ceil", "np.ceil"],
        },
        TapeNode::Binary(operator, ..) => match operator {
            Operator::Add => ["+"; 3],
            Operator::Subtract => ["-"; 3],
            Operator::Multiply => ["*"; 3],
            // The numbers of Python, which constants are, refuse to be divided by zero.
            Operator::Divide => ["/", "/", "np.divide"],
            Operator::ArcTangent => ["kin_atan2", "kinAtan2", "_atan2"],
        },
        TapeNode::PlusProduct(..) => ["+"; 3],
        TapeNode::MinusProduct(..) => ["-"; 3],
        TapeNode::Select(..) => ["?", "?", "np.where"],
        TapeNode::Compare(Comparison::AtLeast, ..) => [">="; 3],
        TapeNode::Compare(Comparison::Exceeds, ..) => [">"; 3],
        TapeNode::Compare(Comparison::Equals, ..) => ["=="; 3],
        // C compares with the largest number of the type, which its printer knows.
        TapeNode::IsFinite(_) => ["", "Number.isFinite", "np.isfinite"],
        TapeNode::Both(..) => ["&&", "&&", "np.logical_and"],
        TapeNode::Either(..) => ["||", "||", "np.logical_or"],
        TapeNode::Not(_) => ["!", "!", "np.logical_not"],
        // These have names, or are literals.
        TapeNode::Argument(_)
        | TapeNode::Constant(_)
        | TapeNode::Certain(_)
        | TapeNode::Unknown { .. }
        | TapeNode::Root { .. }
        | TapeNode::Solution { .. } => [""; 3],
    }
}

impl TapeNode {
    /// How a language spells the operation.
    pub(super) const fn spelling(&self, target: Target) -> &'static str {
        spellings(self)[target as usize]
    }

    /// The operation in a language, with operands as they are written there.
    pub(super) fn written(&self, target: Target, mut operand: impl FnMut(Value) -> Code) -> Code {
        let mut operands = Vec::new();
        self.operands(|value| operands.push(operand(value)));
        let spelling = self.spelling(target);
        match (spelling, operands.as_slice()) {
            ("-", [one]) => one.negated(),
            ("!", [truth]) => truth.not(),
            ("+" | "-", [one, other]) => one.sum(spelling, other),
            ("+" | "-", [sum, one, other]) => sum.sum(spelling, &one.product("*", other)),
            ("*" | "/", [one, other]) => one.product(spelling, other),
            (">=" | ">" | "==", [one, other]) => one.compared(spelling, other),
            ("&&", [one, other]) => one.both(other),
            ("||", [one, other]) => one.either(other),
            ("?", [truth, one, other]) => truth.select(one, other),
            (name, operands) => Code::call(name, operands),
        }
    }
}
