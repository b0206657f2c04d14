//! Trees as instructions.
//!
//! Temporary values stand on a stack behind those that are kept. An instruction writes where its operands began.

use std::collections::BTreeMap;

use kin_compiler::ValueShape;
use kin_compiler::tree::{Local, Operation, Sheet, Step, Tree, TreeKind};

use super::SheetCode;
use super::instruction::{Code, Instruction};
use super::registers::length;

/// The code of a method, for so many parameters, inputs and unknowns.
pub(super) fn compiled(sheet: &Sheet, given: [usize; 3]) -> Option<SheetCode> {
    let top = given.iter().sum();
    let mut compiler = Compiler {
        given,
        locals: BTreeMap::new(),
        instructions: Vec::new(),
        top,
        registers: top,
    };
    for binding in &sheet.bindings {
        let register = compiler.value(&binding.value)?;
        compiler.locals.insert(binding.local, register);
    }
    let mut results = Vec::new();
    for result in &sheet.results {
        let first = compiler.value(result)?;
        results.extend(first..first + length(result.shape));
    }
    Some(SheetCode {
        given,
        instructions: compiler.instructions,
        registers: compiler.registers,
        results,
    })
}

struct Compiler {
    given: [usize; 3],
    /// The registers of the local values.
    locals: BTreeMap<Local, usize>,
    instructions: Vec<Instruction>,
    /// The first register that is free.
    top: usize,
    /// The number of registers that have been in use.
    registers: usize,
}

impl Compiler {
    /// Adds the instructions for a value, and returns its first register.
    fn value(&mut self, tree: &Tree) -> Option<usize> {
        let begin = self.top;
        let [parameters, inputs, unknowns] = self.given;
        let within = |index: usize, count: usize| (index < count).then_some(index);
        Some(match &tree.kind {
            TreeKind::Number(value) => self.add(begin, Code::Number(*value), &[], tree.shape),
            TreeKind::Pi => self.add(begin, Code::Number(std::f64::consts::PI), &[], tree.shape),
            TreeKind::Parameter(index) => {
                within(index + length(tree.shape) - 1, parameters)?;
                *index
            }
            TreeKind::Input(index) => parameters + within(*index, inputs)?,
            TreeKind::Unknown(index) => parameters + inputs + within(*index, unknowns)?,
            TreeKind::Local(local) => *self.locals.get(local)?,
            TreeKind::Negative(of) => {
                let operand = self.value(of)?;
                self.add(begin, Code::Negative(of.shape), &[operand], tree.shape)
            }
            TreeKind::Chain { first, steps } => self.chain(first, steps)?,
            TreeKind::Call(operation, arguments) => {
                let operands: Vec<usize> = arguments
                    .iter()
                    .map(|argument| self.value(argument))
                    .collect::<Option<_>>()?;
                let made = matches!(operation, Operation::Zero | Operation::Vector | Operation::Lifted);
                let shape = arguments
                    .first()
                    .filter(|_| !made)
                    .map_or(tree.shape, |first| first.shape);
                self.add(begin, Code::Call(*operation, shape), &operands, tree.shape)
            }
            TreeKind::Power(base, exponent) => {
                let base = self.value(base)?;
                self.add(begin, Code::Power(*exponent), &[base], tree.shape)
            }
            TreeKind::Part(of, axis) => self.value(of)? + *axis as usize,
        })
    }

    fn chain(&mut self, first: &Tree, steps: &[Step]) -> Option<usize> {
        use ValueShape::{Plane, Rotation, Scalar, Space};
        let begin = self.top;
        let (mut value, mut shape) = (self.value(first)?, first.shape);
        for step in steps {
            let operand = match step.operand() {
                Some(operand) => self.value(operand)?,
                None => value,
            };
            let both = [value, operand];
            let (code, from, becomes) = match step {
                Step::Named => continue,
                Step::Lifted(to) => (Code::Call(Operation::Lifted, *to), both, *to),
                Step::Plus(_) => (Code::Plus(shape), both, shape),
                Step::Minus(_) => (Code::Minus(shape), both, shape),
                Step::Times(_) => (Code::Times, both, Scalar),
                Step::Over(_) => (Code::Over, both, Scalar),
                Step::ScaledBy(_) => (Code::Scale(shape), both, shape),
                Step::Scaling(vector) => (Code::Scale(vector.shape), [operand, value], vector.shape),
                Step::ScaledByInverse(_) => (Code::ScaleByInverse(shape), both, shape),
                Step::LengthAt(_) => (Code::Call(Operation::Polar, Scalar), both, Plane),
                Step::ComplexTimes(_) => (Code::ComplexTimes, both, Plane),
                Step::RotationTimes(_) => (Code::RotationTimes, both, Rotation),
                Step::Rotating(_) => (Code::Rotate, both, Space),
            };
            (value, shape) = (self.add(begin, code, &from, becomes), becomes);
        }
        Some(value)
    }

    /// Adds an instruction that writes its value from the register `to` on, and frees all registers behind the value.
    fn add(&mut self, to: usize, code: Code, operands: &[usize], shape: ValueShape) -> usize {
        let mut from = [0; 3];
        for (from, operand) in from.iter_mut().zip(operands) {
            *from = *operand;
        }
        self.instructions.push(Instruction { code, to, from });
        self.top = to + length(shape);
        self.registers = self.registers.max(self.top);
        to
    }
}
