//! Code from quantities to results.

use kin_compiler::lowered::{Component, Statement, Symbol};
use kin_core::Scalar;

use crate::code::{Assembler, Code, Labels, Register, TooLarge};
use crate::memory::{Lengths, Memory};
use crate::run::{Choice, Run};

/// The registers of quantities before a run.
#[derive(Debug, Default)]
pub(crate) struct Given {
    /// Parameters, each by its index.
    parameters: Box<[(usize, Register)]>,
    /// Inputs, each by its index and order.
    inputs: Box<[(usize, usize, Register)]>,
    /// Unknowns, each by its index.
    unknowns: Box<[(usize, Register)]>,
}

impl Given {
    /// The quantities that some code reads.
    pub(crate) fn of(assembler: &Assembler) -> Self {
        let (mut parameters, mut inputs, mut unknowns) = (Vec::new(), Vec::new(), Vec::new());
        for (symbol, register) in assembler.registers() {
            match symbol {
                Symbol::Parameter(index) => parameters.push((index, register)),
                Symbol::Input(index) => inputs.push((index, 0, register)),
                Symbol::InputRate(index, order) => inputs.push((index, order, register)),
                Symbol::Unknown(index) => unknowns.push((index, register)),
                _ => {}
            }
        }
        Self {
            parameters: parameters.into(),
            inputs: inputs.into(),
            unknowns: unknowns.into(),
        }
    }

    /// Writes the parameters and inputs of a chunk.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn write<T: Scalar, const C: usize>(
        &self,
        registers: &mut [[T; C]],
        chunk: usize,
        parameters: &[T],
        inputs: Inputs<'_, T>,
    ) {
        for (index, register) in &*self.parameters {
            registers[usize::from(*register)][chunk] = parameters[*index];
        }
        for (index, order, register) in &*self.inputs {
            if *order < inputs.orders {
                registers[usize::from(*register)][chunk] = inputs.motions[*index * inputs.orders + *order];
            }
        }
    }

    /// Writes unknowns.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn write_unknowns<T: Scalar>(&self, registers: &mut [[T; 1]], unknowns: &[T]) {
        for (index, register) in &*self.unknowns {
            registers[usize::from(*register)] = [unknowns[*index]];
        }
    }
}

/// The inputs with some of their orders, position first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs<'i, T> {
    pub(crate) motions: &'i [T],
    /// The number of orders.
    pub(crate) orders: usize,
}

impl<'i, T: Scalar> Inputs<'i, T> {
    /// Inputs without rates.
    pub(crate) fn positions(positions: &'i [T]) -> Self {
        Self {
            motions: positions,
            orders: 1,
        }
    }

    /// The motions of all inputs.
    pub(crate) fn each(self) -> impl Iterator<Item = &'i [T]> + Clone {
        self.motions.chunks_exact(self.orders)
    }
}

/// Straight-line code from quantities to results, which cannot fail.
#[derive(Debug)]
pub(crate) struct Routine {
    code: Code,
    given: Given,
    pub(crate) results: Box<[Register]>,
}

impl Routine {
    /// The code of some statements with their results.
    pub(crate) fn new(statements: &[Statement], results: &[Symbol], labels: &mut Labels<'_>) -> Result<Self, TooLarge> {
        let mut assembler = Assembler::of([statements].into_iter(), results.iter().copied(), labels);
        let results = results.iter().map(|&symbol| assembler.register(symbol)).collect();
        Self::finish(assembler, results)
    }

    /// The code of some statements, and then of components.
    pub(crate) fn of_components(
        statements: &[Statement],
        components: &[Component],
        labels: &mut Labels<'_>,
    ) -> Result<Self, TooLarge> {
        let symbols = components.iter().filter_map(|component| match component {
            Component::Parameter(index) => Some(Symbol::Parameter(*index)),
            Component::Value(symbol) => Some(*symbol),
            Component::Number(_) => None,
        });
        let mut assembler = Assembler::of([statements].into_iter(), symbols, labels);
        let results = components.iter().map(|component| match component {
            Component::Parameter(index) => assembler.register(Symbol::Parameter(*index)),
            Component::Value(symbol) => assembler.register(*symbol),
            Component::Number(number) => assembler.number(*number),
        });
        let results = results.collect();
        Self::finish(assembler, results)
    }

    fn finish(assembler: Assembler, results: Box<[Register]>) -> Result<Self, TooLarge> {
        let given = Given::of(&assembler);
        let code = assembler.finish()?;
        debug_assert!(code.calls.is_empty());
        Ok(Self { code, given, results })
    }

    /// The memory that a run takes.
    pub(crate) fn lengths(&self) -> Lengths {
        self.code.lengths
    }

    /// Calls a function with the results.
    pub(crate) fn run<T: Scalar, R>(
        &self,
        parameters: &[T],
        inputs: Inputs<'_, T>,
        unknowns: &[T],
        results: impl FnOnce(&dyn Fn(usize) -> T) -> R,
    ) -> R {
        self.lengths().lend([parameters, inputs.motions], |memory| {
            let found = self.run_in(memory, parameters, inputs, unknowns);
            results(&|index| found.at(index))
        })
    }

    /// The results, in memory that the caller lends.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn run_in<'r, T: Scalar>(
        &'r self,
        memory: Memory<'r, T, 1>,
        parameters: &[T],
        inputs: Inputs<'_, T>,
        unknowns: &[T],
    ) -> Results<'r, T> {
        self.given.write(memory.registers, 0, parameters, inputs);
        self.given.write_unknowns(memory.registers, unknowns);
        let mut run = Run::single(&self.code, memory, Choice::default());
        run.straight_line();
        Results {
            routine: self,
            registers: run.memory.registers,
        }
    }
}

/// The results of a routine.
pub(crate) struct Results<'r, T> {
    routine: &'r Routine,
    registers: &'r [[T; 1]],
}

impl<T: Scalar> Results<'_, T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn at(&self, index: usize) -> T {
        self.registers[usize::from(self.routine.results[index])][0]
    }
}
