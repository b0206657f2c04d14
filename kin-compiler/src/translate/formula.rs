//! Formulas of the declaration as trees, operator by operator.

use super::names::Names;
use super::tree::{Operation, Step, Tree, TreeKind};
use crate::algebra::{Calculation, Function};
use crate::model::ValueShape;
use crate::syntax::{ArithmeticOperator, Callee, FormulaKind, Operand, TypedFormula};

/// The number of operands in a row after which the result gets a name. Each operand nests the text one level deeper.
const LONGEST: usize = 256;

impl Names {
    pub(super) fn formula(&self, formula: &TypedFormula) -> Tree {
        match &formula.kind {
            FormulaKind::Number { value, .. } => Tree::number(*value),
            FormulaKind::Degrees { value, .. } => Tree::number(value / 180.0 * std::f64::consts::PI),
            FormulaKind::Pi => Tree::scalar(TreeKind::Pi),
            FormulaKind::Name(name) => self.named(name),
            FormulaKind::Parenthesis(inner) => self.formula(inner),
            FormulaKind::Negate(of) => self.formula(of).negated(),
            FormulaKind::Sum { first, rest } | FormulaKind::Product { first, rest } => self.chain(first, rest),
            FormulaKind::Call { callee, arguments, .. } => self.call(*callee, arguments),
            FormulaKind::Power { base, exponent, .. } => {
                Tree::scalar(TreeKind::Power(Box::new(self.formula(base)), *exponent))
            }
            FormulaKind::Part { of, axis } => Tree::scalar(TreeKind::Part(Box::new(self.formula(of)), *axis)),
        }
    }

    fn chain(&self, first: &TypedFormula, rest: &[Operand]) -> Tree {
        let mut chain = Chain::of(self.formula(first));
        for (index, operand) in rest.iter().enumerate() {
            if index > 0 && index % LONGEST == 0 {
                chain.steps.push(Step::Named);
            }
            let right = self.formula(&operand.formula);
            match operand.operator {
                ArithmeticOperator::Add => chain.add(Step::Plus, right),
                ArithmeticOperator::Subtract => chain.add(Step::Minus, right),
                ArithmeticOperator::Multiply => chain.multiply(right),
                ArithmeticOperator::Divide => chain.divide(right),
            }
        }
        chain.into_tree()
    }

    fn call(&self, callee: Callee, arguments: &[TypedFormula]) -> Tree {
        let arguments: Vec<Tree> = arguments.iter().map(|argument| self.formula(argument)).collect();
        let taken = arguments.first().map_or(ValueShape::Scalar, |first| first.shape);
        let (shape, operation) = match callee {
            Callee::Elementary(function) => (ValueShape::Scalar, elementary(function)),
            Callee::Cis => (ValueShape::Plane, Operation::Cis),
            Callee::Polar => (ValueShape::Plane, Operation::Polar),
            Callee::Vec2 => (ValueShape::Plane, Operation::Vector),
            Callee::Vec3 => (ValueShape::Space, Operation::Vector),
            Callee::RotX => (ValueShape::Rotation, Operation::AboutX),
            Callee::RotY => (ValueShape::Rotation, Operation::AboutY),
            Callee::RotZ => (ValueShape::Rotation, Operation::AboutZ),
            Callee::Rot => (ValueShape::Rotation, Operation::About),
            Callee::Dot => (ValueShape::Scalar, Operation::Dot),
            Callee::Cross if taken == ValueShape::Space => (ValueShape::Space, Operation::Cross),
            Callee::Cross => (ValueShape::Scalar, Operation::Cross),
            Callee::Norm => (ValueShape::Scalar, Operation::Norm),
        };
        Tree::call(shape, operation, arguments)
    }
}

/// `left - right`
pub(super) fn difference(left: Tree, right: Tree) -> Tree {
    let mut chain = Chain::of(left);
    chain.add(Step::Minus, right);
    chain.into_tree()
}

/// `left + right`
pub(super) fn sum(left: Tree, right: Tree) -> Tree {
    let mut chain = Chain::of(left);
    chain.add(Step::Plus, right);
    chain.into_tree()
}

/// `left * right`
pub(super) fn product(left: Tree, right: Tree) -> Tree {
    let mut chain = Chain::of(left);
    chain.multiply(right);
    chain.into_tree()
}

/// The formula as a vector; a scalar lies along x.
pub(super) fn lifted(of: Tree, shape: ValueShape) -> Tree {
    if of.shape == ValueShape::Scalar && shape != ValueShape::Scalar {
        Tree::call(shape, Operation::Lifted, vec![of])
    } else {
        of
    }
}

/// The angle of a unit vector that was typed as `cis(angle)`.
fn angle(of: &Tree) -> Option<&Tree> {
    match &of.kind {
        TreeKind::Call(Operation::Cis, arguments) => arguments.first(),
        _ => None,
    }
}

fn elementary(function: Function) -> Operation {
    match function.calculation() {
        Calculation::Sine => Operation::Sine,
        Calculation::Cosine => Operation::Cosine,
        Calculation::Tangent => Operation::Tangent,
        Calculation::Method => Operation::Method(function),
    }
}

/// A value that changes step by step.
struct Chain {
    shape: ValueShape,
    first: Tree,
    steps: Vec<Step>,
}

impl Chain {
    fn of(first: Tree) -> Self {
        Self {
            shape: first.shape,
            first,
            steps: Vec::new(),
        }
    }

    fn into_tree(self) -> Tree {
        let first = Box::new(self.first);
        if self.steps.is_empty() {
            return *first;
        }
        let steps = self.steps;
        Tree::new(self.shape, TreeKind::Chain { first, steps })
    }

    fn step(&mut self, shape: ValueShape, step: Step) {
        self.shape = shape;
        self.steps.push(step);
    }

    fn add(&mut self, step: fn(Tree) -> Step, right: Tree) {
        let right = lifted(right, self.shape);
        if self.shape == ValueShape::Scalar && right.shape != ValueShape::Scalar {
            self.step(right.shape, Step::Lifted(right.shape));
        }
        self.step(self.shape, step(right));
    }

    fn multiply(&mut self, right: Tree) {
        use ValueShape::{Plane, Rotation, Scalar};
        match (self.shape, right.shape) {
            (Scalar, Scalar) => self.step(Scalar, Step::Times(right)),
            // r cis(theta) is the vector that a person draws
            (Plane, Scalar) if self.steps.is_empty() && angle(&self.first).is_some() => {
                if let TreeKind::Call(operation, arguments) = &mut self.first.kind {
                    *operation = Operation::Polar;
                    arguments.insert(0, right);
                }
            }
            (Scalar, Plane) if angle(&right).is_some() => {
                if let TreeKind::Call(_, arguments) = right.kind {
                    self.shape = Plane;
                    self.steps.extend(arguments.into_iter().map(Step::LengthAt));
                }
            }
            (shape, Scalar) => self.step(shape, Step::ScaledBy(right)),
            (Scalar, shape) => self.step(shape, Step::Scaling(right)),
            (Rotation, Rotation) => self.step(Rotation, Step::RotationTimes(right)),
            (Rotation, shape) => self.step(shape, Step::Rotating(right)),
            (_, _) => self.step(Plane, Step::ComplexTimes(right)),
        }
    }

    fn divide(&mut self, right: Tree) {
        let step = if self.shape == ValueShape::Scalar {
            Step::Over
        } else {
            Step::ScaledByInverse
        };
        self.step(self.shape, step(right));
    }
}
