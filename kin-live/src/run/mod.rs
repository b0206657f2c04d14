//! The machine: it runs code over any number with which a mechanism is solved.
//!
//! The machine calls the functions of `kin_core::solve` that the generated code of a declared mechanism calls, in the
//! same order, so its numbers are the same to the last bit. For several numbers at once the machine is inlined, because
//! a batch compiles it for the vectors of each processor. For every other type of number the machine is compiled once.

mod closed_form;
mod newton;

use std::cell::Cell;

use kin_compiler::lowered::Selection;
use kin_core::__private::live::{
    SolutionInRange, choose_in, decisive_in, decisive_vector_in, factor_in, substitute_in, unwrap_near,
};
use kin_core::__private::solve::{check_angle, check_value, direction, directions, finite, regular};
use kin_core::any::Name;
use kin_core::{Assembly, Failure, Plane, Scalar};

use crate::code::{Call, Code, Operation, Range, Register};
use crate::memory::Memory;

/// A failure, and the name of what has failed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fault {
    pub(crate) failure: Failure,
    pub(crate) label: Name,
}

/// The choices of a run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Choice<'n, T> {
    /// The values of the unknowns of all chunks to which angles are unwrapped, and from which Newton's method starts.
    pub(crate) near: Option<&'n [T]>,
    /// The number of unknowns.
    pub(crate) unknowns: usize,
    /// The index of the assembly. The choice of the first block changes slowest.
    pub(crate) assembly: usize,
    /// The number of choices.
    pub(crate) choices: usize,
}

impl<T> Default for Choice<'_, T> {
    fn default() -> Self {
        Self {
            near: None,
            unknowns: 0,
            assembly: 0,
            choices: 0,
        }
    }
}

/// The way through all positions.
pub(crate) trait Way<T> {
    /// The next solution of a block with a closed form.
    fn assembly(&mut self) -> Assembly;

    /// Writes the next solution of a block without one.
    fn solution(&mut self, block: usize, coefficients: &[T], solution: &mut [T]) -> Result<(), Failure>;
}

/// No way: the run leads to a single position.
pub(crate) struct SinglePosition;

impl<T> Way<T> for SinglePosition {
    #[inline(always)]
    fn assembly(&mut self) -> Assembly {
        Assembly::Open
    }

    #[inline(always)]
    fn solution(&mut self, _: usize, _: &[T], _: &mut [T]) -> Result<(), Failure> {
        Ok(())
    }
}

/// A run of code, over at most `C` chunks of poses side by side.
pub(crate) struct Run<'r, 'm, T, W, const C: usize> {
    pub(crate) code: &'r Code,
    /// The chunk at hand.
    pub(crate) chunk: usize,
    pub(crate) memory: Memory<'m, T, C>,
    pub(crate) choice: Choice<'r, T>,
    pub(crate) way: W,
}

impl<'r, 'm, T, const C: usize> Run<'r, 'm, T, SinglePosition, C> {
    /// A run that leads to a single position, from its first chunk on.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn single(code: &'r Code, memory: Memory<'m, T, C>, choice: Choice<'r, T>) -> Self {
        Self {
            code,
            chunk: 0,
            memory,
            choice,
            way: SinglePosition,
        }
    }
}

impl<T: Scalar, W: Way<T>, const C: usize> Run<'_, '_, T, W, C> {
    /// Runs a routine.
    ///
    /// For numbers of several poses it is inlined, so that it is compiled for the vectors of the processor. For numbers
    /// of one pose it is compiled once.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn routine(&mut self, index: usize, chunks: usize) -> Result<(), Fault> {
        if const { T::DOUBT > 0.0 } {
            self.run(index, chunks)
        } else {
            self.run_alone(index)
        }
    }

    /// Runs a routine without calls, which cannot fail.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn straight_line(&mut self) {
        if const { T::DOUBT > 0.0 } {
            for operation in &*self.code.routines[0] {
                arithmetic(self.memory.registers, 0..1, &self.code.constants, *operation);
            }
        } else {
            let done = self.run_alone(0);
            debug_assert!(done.is_ok(), "only a call fails");
        }
    }

    #[inline(never)]
    fn run_alone(&mut self, index: usize) -> Result<(), Fault> {
        self.run(index, 1)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run(&mut self, index: usize, chunks: usize) -> Result<(), Fault> {
        let code = self.code;
        let operations = &*code.routines[index];
        let mut candidate = Assembly::Open;
        let mut next = 0;
        while let Some(operation) = operations.get(next) {
            next += 1;
            match *operation {
                Operation::Call(index) => {
                    let call = &code.calls[usize::from(index)];
                    let before = (candidate, next);
                    // all chunks go the same way
                    for chunk in 0..chunks {
                        self.chunk = chunk;
                        (candidate, next) = before;
                        self.call(call, &mut candidate, &mut next)?;
                    }
                }
                Operation::Doubt { skip } if T::DOUBT == 0.0 => next += usize::from(skip),
                operation => arithmetic(self.memory.registers, 0..chunks, &code.constants, operation),
            }
        }
        Ok(())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn get(&self, register: Register) -> T {
        self.memory.registers[usize::from(register)][self.chunk]
    }

    /// The numbers of two registers.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn pair(&self, [one, other]: [Register; 2]) -> [T; 2] {
        [self.get(one), self.get(other)]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn set(&mut self, register: Register, value: T) {
        self.memory.registers[usize::from(register)][self.chunk] = value;
    }

    /// Copies registers side by side.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn row(&mut self, registers: &[Register]) -> &[T] {
        let Memory {
            registers: values, row, ..
        } = &mut self.memory;
        for (slot, register) in row.iter_mut().zip(registers) {
            *slot = values[usize::from(*register)][self.chunk];
        }
        &row[..registers.len()]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn selected(&mut self, selection: Selection, candidate: Assembly) -> Assembly {
        match selection {
            Selection::Fixed { is_open: true } => Assembly::Open,
            Selection::Fixed { is_open: false } => Assembly::Crossed,
            Selection::Choice(index) => {
                let Choice { assembly, choices, .. } = self.choice;
                Assembly::BOTH[(assembly >> (choices - 1 - index)) & 1]
            }
            Selection::Candidate => candidate,
            Selection::Next => self.way.assembly(),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn call(&mut self, call: &Call, candidate: &mut Assembly, next: &mut usize) -> Result<(), Fault> {
        let at = |label: &Name| {
            let label = *label;
            move |failure: Failure| Fault { failure, label }
        };
        match call {
            Call::Finite { to, a, label } => {
                let value = finite(*label, self.get(*a)).map_err(at(label))?;
                self.set(*to, value);
            }
            Call::Check {
                to,
                guard,
                argument,
                label,
            } => {
                let value = guard.check(self.get(*argument)).map_err(at(label))?;
                self.set(*to, value);
            }
            Call::Solve {
                form,
                arguments,
                selection,
                returns,
                results,
                label,
            } => {
                let assembly = selection.map_or(Assembly::Open, |selection| self.selected(selection, *candidate));
                self.solve(*form, arguments, assembly, *returns, results)
                    .map_err(at(label))?;
            }
            Call::Angle { to, y, x, length } => {
                let (y, x) = (self.get(*y), self.get(*x));
                let angle = match length {
                    Some(length) => direction(y, x, self.get(*length)),
                    None => T::atan2(y, x),
                };
                self.set(*to, angle);
            }
            Call::TwoAngles { to, y, x, lengths } => {
                let (y, x) = (self.pair(*y), self.pair(*x));
                let [first, second] = match lengths {
                    Some(lengths) => directions(y, x, self.pair(*lengths)),
                    None => T::atan2_of_two(y, x),
                };
                self.set(to[0], first);
                self.set(to[1], second);
            }
            Call::InRange {
                unknown,
                name,
                is_periodic,
                range: [low, high],
                label,
            } => {
                let value = self.get(*unknown);
                let value = if *is_periodic {
                    check_angle(*name, value, *low, *high)
                } else {
                    check_value(*name, value, *low, *high)
                };
                self.set(*unknown, value.map_err(at(label))?);
            }
            Call::Unwrap { unknown, index } => {
                let index = self.chunk * self.choice.unknowns + index;
                if let Some(guess) = self.choice.near.and_then(|near| near.get(index)) {
                    let angle = unwrap_near(self.get(*unknown), *guess);
                    self.set(*unknown, angle);
                }
            }
            Call::Decisive { to, terms } => {
                let value = self.get(*to);
                let value = decisive_in(value, self.row(terms));
                self.set(*to, value);
            }
            Call::DecisiveVector { to: [x, y], terms } => {
                let vector = Plane::new(self.get(*x), self.get(*y));
                let vector = decisive_vector_in(vector, self.row(terms));
                self.set(*x, vector.x);
                self.set(*y, vector.y);
            }
            Call::Candidate => *candidate = Assembly::Open,
            Call::Choose {
                back,
                kept,
                candidates,
                ranges,
                label,
            } => {
                let row = usize::from(candidates[usize::from(*candidate == Assembly::Crossed)]);
                for (position, register) in kept.iter().enumerate() {
                    self.memory.registers[row + position][self.chunk] = self.get(*register);
                }
                if *candidate == Assembly::Open {
                    *candidate = Assembly::Crossed;
                    // this call itself has been passed
                    *next -= back + 1;
                    return Ok(());
                }
                let chosen = self.chosen(ranges, *candidates).map_err(at(label))?;
                for (position, register) in kept.iter().enumerate() {
                    let [open, crossed] = self.candidates(*candidates, position);
                    self.set(*register, T::assembled(chosen, || open, || crossed));
                }
            }
            Call::Newton { label, .. } => self.newton(call).map_err(at(label))?,
            Call::Every {
                block,
                coefficients,
                results,
                label,
            } => {
                self.row(coefficients);
                let (given, solution) = self.memory.row.split_at_mut(coefficients.len());
                let solution = &mut solution[..results.len()];
                self.way.solution(*block, given, solution).map_err(at(label))?;
                for (register, value) in results.iter().zip(solution) {
                    self.memory.registers[usize::from(*register)][self.chunk] = *value;
                }
            }
            Call::Factor {
                factors,
                size,
                matrix,
                label,
            } => {
                let [first_entry, first_row] = self.kept(*factors);
                let Memory {
                    registers,
                    entries,
                    rows,
                    ..
                } = &mut self.memory;
                let entries = &mut entries[first_entry..first_entry + size * size];
                for (entry, register) in entries.iter_mut().zip(matrix) {
                    *entry = registers[usize::from(*register)][self.chunk];
                }
                factor_in(entries, &mut rows[first_row..first_row + size]).map_err(at(label))?;
            }
            Call::Substitute {
                factors,
                right,
                results,
            } => {
                let size = right.len();
                let [first_entry, first_row] = self.kept(*factors);
                self.row(right);
                let Memory {
                    registers,
                    entries,
                    row,
                    rows,
                    ..
                } = &mut self.memory;
                let (right, solution) = row.split_at_mut(size);
                let entries = &entries[first_entry..first_entry + size * size];
                let rows = &rows[first_row..first_row + size];
                substitute_in(entries, rows, right, &mut solution[..size]);
                for (register, value) in results.iter().zip(solution) {
                    registers[usize::from(*register)][self.chunk] = *value;
                }
            }
            Call::Regular { to, value, label } => {
                let value = regular(self.get(*value)).map_err(at(label))?;
                self.set(*to, value);
            }
        }
        Ok(())
    }

    /// The first entry and the first row of factors, in the chunk at hand.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn kept(&self, factors: usize) -> [usize; 2] {
        let (kept, lengths) = (self.code.factors[factors], self.code.lengths);
        [
            self.chunk * lengths.entries + kept.first_entry,
            self.chunk * lengths.rows + kept.first_row,
        ]
    }

    /// A kept value of both candidates.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn candidates(&self, candidates: [Register; 2], position: usize) -> [T; 2] {
        let of = |first: Register| self.memory.registers[usize::from(first) + position][self.chunk];
        [of(candidates[0]), of(candidates[1])]
    }

    /// The choice between the candidates by ranges.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn chosen(&self, ranges: &[Range], candidates: [Register; 2]) -> Result<Assembly, Failure> {
        let range = |range: &Range| {
            let solutions = self.candidates(candidates, range.kept);
            let [low, high] = range.bounds;
            if range.is_periodic {
                SolutionInRange::angle(range.name, solutions, low, high)
            } else {
                SolutionInRange::value(range.name, solutions, low, high)
            }
        };
        // a part with a closed form has one unknown, or two
        match ranges {
            [first, second, ..] => choose_in(&[range(first), range(second)]),
            [first] => choose_in(&[range(first)]),
            [] => unreachable!("a range chooses"),
        }
    }
}

/// A step of arithmetic, in some of the chunks.
#[cfg_attr(not(debug_assertions), inline(always))]
fn arithmetic<T: Scalar, const C: usize>(
    registers: &mut [[T; C]],
    chunks: core::ops::Range<usize>,
    constants: &[f64],
    operation: Operation,
) {
    // Each register is looked up once for all chunks. Cells may be read between writes: a copy of all chunks of an
    // operand would have to pass through memory once more.
    macro_rules! each {
        ($to:ident = |$($operand:ident),*| $value:expr) => {{
            let cells = Cell::from_mut(&mut *registers).as_slice_of_cells();
            $(let $operand = numbers(&cells[usize::from($operand)]);)*
            let to = numbers(&cells[usize::from($to)]);
            if chunks.len() == C {
                for chunk in 0..C {
                    $(let $operand = $operand[chunk].get();)*
                    to[chunk].set($value);
                }
            } else {
                for chunk in chunks {
                    $(let $operand = $operand[chunk].get();)*
                    to[chunk].set($value);
                }
            }
        }};
    }
    match operation {
        Operation::Constant { to, value } => {
            let value = T::constant(constants[usize::from(value)]);
            registers[usize::from(to)][chunks].fill(value);
        }
        Operation::Copy { to, a } => each!(to = |a| a),
        Operation::Add { to, a, b } => each!(to = |a, b| a + b),
        Operation::Subtract { to, a, b } => each!(to = |a, b| a - b),
        Operation::Multiply { to, a, b } => each!(to = |a, b| a * b),
        Operation::Divide { to, a, b } => each!(to = |a, b| a / b),
        Operation::Negate { to, a } => each!(to = |a| -a),
        Operation::PlusProduct { to, rest, a, b } => each!(to = |rest, a, b| rest.plus_product(a, b)),
        Operation::MinusProduct { to, rest, a, b } => each!(to = |rest, a, b| rest.minus_product(a, b)),
        Operation::SumOfProducts { to, a, b, c, d } => each!(to = |a, b, c, d| (a * b).plus_product(c, d)),
        Operation::DifferenceOfProducts { to, a, b, c, d } => each!(to = |a, b, c, d| (a * b).minus_product(c, d)),
        Operation::PlusProducts { to, rest, a, b, c, d } => {
            each!(to = |rest, a, b, c, d| rest.plus_product(a, b).plus_product(c, d));
        }
        Operation::PlusMinusProducts { to, rest, a, b, c, d } => {
            each!(to = |rest, a, b, c, d| rest.plus_product(a, b).minus_product(c, d));
        }
        Operation::MinusProducts { to, rest, a, b, c, d } => {
            each!(to = |rest, a, b, c, d| rest.minus_product(a, b).minus_product(c, d));
        }
        Operation::SineCosine { sine, cosine, angle } => {
            for chunk in chunks {
                let angle = registers[usize::from(angle)][chunk];
                let (sine_value, cosine_value) = T::sin_cos(angle);
                registers[usize::from(sine)][chunk] = sine_value;
                registers[usize::from(cosine)][chunk] = cosine_value;
            }
        }
        // Their code is long, so it is there once.
        Operation::Function { function, to, a } => {
            for chunk in chunks {
                registers[usize::from(to)][chunk] = function.of(registers[usize::from(a)][chunk]);
            }
        }
        Operation::ArcTangent { to, y, x } => {
            for chunk in chunks {
                registers[usize::from(to)][chunk] =
                    registers[usize::from(y)][chunk].atan2(registers[usize::from(x)][chunk]);
            }
        }
        // calls are taken elsewhere, and terms are not skipped here
        Operation::Call(_) | Operation::Doubt { .. } => {}
    }
}

/// The numbers of a register.
#[inline(always)]
fn numbers<T, const C: usize>(register: &Cell<[T; C]>) -> &[Cell<T>] {
    let numbers: &Cell<[T]> = register;
    numbers.as_slice_of_cells()
}
