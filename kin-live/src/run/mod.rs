//! The machine: it runs code over any number with which a mechanism is solved.
//!
//! It calls the functions of `kin_core::solve` that the generated code of a declared mechanism calls, in the same order,
//! so its numbers are the same to the last bit. For several numbers at once all of it is inlined, because a batch
//! compiles it for the vectors of each machine. For each other number it is compiled once.

mod closed_form;
mod memory;
mod newton;

use kin_compiler::lowered::Selection;
use kin_core::__private::live::{SolutionInRange, choose_in, decisive_in, factor_in, nearest_turn, substitute_in};
use kin_core::__private::solve::{check_angle, check_value, direction, directions, finite, regular};
use kin_core::any::Name;
use kin_core::{Assembly, Failure, Scalar};

pub(crate) use memory::{Lengths, Memory};

use crate::code::{Call, Code, Decisive, Operation, Register, Terms};

/// A failure and its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fault {
    pub(crate) failure: Failure,
    pub(crate) label: Name,
}

/// The choices of a run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Choice<'n, T> {
    /// The values of the unknowns to which angles are turned, and from which Newton's method starts.
    pub(crate) near: Option<&'n [T]>,
    /// The index of the assembly. The choice of the first block changes slowest.
    pub(crate) assembly: usize,
    /// The number of choices.
    pub(crate) choices: usize,
}

impl<T> Default for Choice<'_, T> {
    fn default() -> Self {
        Self {
            near: None,
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

/// A run of code.
pub(crate) struct Run<'r, 'm, T, W> {
    pub(crate) code: &'r Code,
    pub(crate) memory: Memory<'m, T>,
    pub(crate) choice: Choice<'r, T>,
    pub(crate) way: W,
}

impl<T: Scalar, W: Way<T>> Run<'_, '_, T, W> {
    /// Runs a routine.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn routine(&mut self, index: usize) -> Result<(), Fault> {
        if T::DOUBT > 0.0 {
            self.routine_inlined(index)
        } else {
            self.routine_called(index)
        }
    }

    #[inline(never)]
    fn routine_called(&mut self, index: usize) -> Result<(), Fault> {
        self.routine_inlined(index)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn routine_inlined(&mut self, index: usize) -> Result<(), Fault> {
        let code = self.code;
        self.operations::<true>(&code.routines[index], Assembly::Open)
    }

    /// Runs operations. Only those that are not `INNER` ones have candidates, Newton's method, and all solutions.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operations<const OUTER: bool>(&mut self, operations: &[Operation], candidate: Assembly) -> Result<(), Fault> {
        for operation in operations {
            if let Operation::Call(index) = *operation {
                let code = self.code;
                self.call::<OUTER>(&code.calls[usize::from(index)], candidate)?;
            } else {
                arithmetic(self.memory.registers, &self.code.constants, *operation);
            }
        }
        Ok(())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn get(&self, register: Register) -> T {
        self.memory.registers[usize::from(register)]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn set(&mut self, register: Register, value: T) {
        self.memory.registers[usize::from(register)] = value;
    }

    /// A number that decides.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn decisive(&mut self, decisive: &Decisive) -> T {
        let value = self.get(decisive.value);
        if T::DOUBT == 0.0 || decisive.terms.registers.is_empty() {
            return value;
        }
        let terms = self.terms(&decisive.terms);
        decisive_in(value, terms)
    }

    /// The terms of a decisive number. They stand in memory that Newton's method takes at other times.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn terms(&mut self, terms: &Terms) -> &[T] {
        for operation in &*terms.operations {
            arithmetic(self.memory.registers, &self.code.constants, *operation);
        }
        self.row(&terms.registers)
    }

    /// Copies registers side by side.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn row(&mut self, registers: &[Register]) -> &[T] {
        let Memory {
            registers: values, row, ..
        } = &mut self.memory;
        for (place, register) in row.iter_mut().zip(registers) {
            *place = values[usize::from(*register)];
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
    fn call<const OUTER: bool>(&mut self, call: &Call, candidate: Assembly) -> Result<(), Fault> {
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
                let argument = self.decisive(argument);
                let value = guard.check(argument).map_err(at(label))?;
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
                let assembly = selection.map_or(Assembly::Open, |selection| self.selected(selection, candidate));
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
                let (y, x) = (y.map(|y| self.get(y)), x.map(|x| self.get(x)));
                let [first, second] = match lengths {
                    Some(lengths) => directions(y, x, lengths.map(|length| self.get(length))),
                    None => T::atan2_of_two(y, x),
                };
                self.set(to[0], first);
                self.set(to[1], second);
            }
            Call::InRange {
                unknown,
                name,
                turns,
                range: [low, high],
                label,
            } => {
                let value = self.get(*unknown);
                let value = if *turns {
                    check_angle(*name, value, *low, *high)
                } else {
                    check_value(*name, value, *low, *high)
                };
                self.set(*unknown, value.map_err(at(label))?);
            }
            Call::OnTurn { unknown, index } => {
                if let Some(guess) = self.choice.near.and_then(|near| near.get(*index)) {
                    let angle = nearest_turn(self.get(*unknown), *guess);
                    self.set(*unknown, angle);
                }
            }
            Call::Candidates {
                body,
                kept,
                candidates,
                ranges,
                label,
            } => {
                if OUTER {
                    for (assembly, first) in Assembly::BOTH.into_iter().zip(candidates) {
                        self.operations::<false>(body, assembly)?;
                        for (place, register) in kept.iter().enumerate() {
                            self.memory.registers[usize::from(*first) + place] = self.get(*register);
                        }
                    }
                    let of = |run: &Self, which: usize, place: usize| {
                        run.memory.registers[usize::from(candidates[which]) + place]
                    };
                    let mut own = [None; MOST_RANGES];
                    for (place, range) in own.iter_mut().zip(ranges) {
                        let solutions = [0, 1].map(|which| of(self, which, range.kept));
                        let [low, high] = range.range;
                        *place = Some(if range.turns {
                            SolutionInRange::angle(range.name, solutions, low, high)
                        } else {
                            SolutionInRange::value(range.name, solutions, low, high)
                        });
                    }
                    // a part with a closed form has one unknown, or two
                    let chosen = match own {
                        [Some(first), Some(second)] => choose_in(&[first, second]),
                        [Some(first), None] => choose_in(&[first]),
                        [None, _] => unreachable!("a range chooses"),
                    };
                    let chosen = chosen.map_err(at(label))?;
                    for (place, register) in kept.iter().enumerate() {
                        let [value] = T::all_assembled(chosen, [of(self, 0, place)], [of(self, 1, place)]);
                        self.set(*register, value);
                    }
                }
            }
            Call::Newton { label, .. } => {
                if OUTER {
                    self.newton(call).map_err(at(label))?;
                }
            }
            Call::Every {
                block,
                coefficients,
                results,
                label,
            } => {
                if OUTER {
                    self.row(coefficients);
                    let (given, solution) = self.memory.row.split_at_mut(coefficients.len());
                    let solution = &mut solution[..results.len()];
                    self.way.solution(*block, given, solution).map_err(at(label))?;
                    for (register, value) in results.iter().zip(solution) {
                        self.memory.registers[usize::from(*register)] = *value;
                    }
                }
            }
            Call::Factor {
                factors,
                size,
                matrix,
                label,
            } => {
                let lengths = self.code.factors[*factors];
                let entries = lengths.first_entry..lengths.first_entry + size * size;
                for (place, register) in entries.clone().zip(matrix) {
                    self.memory.registers[place] = self.get(*register);
                }
                let rows = &mut self.memory.rows[lengths.first_row..lengths.first_row + size];
                factor_in(&mut self.memory.registers[entries], rows).map_err(at(label))?;
            }
            Call::Substitute {
                factors,
                right,
                results,
            } => {
                let size = right.len();
                let lengths = self.code.factors[*factors];
                self.row(right);
                let Memory {
                    registers, row, rows, ..
                } = &mut self.memory;
                let (right, solution) = row.split_at_mut(size);
                let entries = &registers[lengths.first_entry..lengths.first_entry + size * size];
                let rows = &rows[lengths.first_row..lengths.first_row + size];
                substitute_in(entries, rows, right, &mut solution[..size]);
                for (register, value) in results.iter().zip(solution) {
                    registers[usize::from(*register)] = *value;
                }
            }
            Call::Regular { to, value, label } => {
                let value = self.decisive(value);
                let value = regular(value).map_err(at(label))?;
                self.set(*to, value);
            }
        }
        Ok(())
    }
}

/// The largest number of ranges of a part with a closed form.
const MOST_RANGES: usize = 2;

/// A step of arithmetic.
#[cfg_attr(not(debug_assertions), inline(always))]
fn arithmetic<T: Scalar>(registers: &mut [T], constants: &[f64], operation: Operation) {
    macro_rules! at {
        ($register:expr) => {
            registers[usize::from($register)]
        };
    }
    match operation {
        Operation::Constant { to, value } => at!(to) = T::constant(constants[usize::from(value)]),
        Operation::Copy { to, a } => at!(to) = at!(a),
        Operation::Add { to, a, b } => at!(to) = at!(a) + at!(b),
        Operation::Subtract { to, a, b } => at!(to) = at!(a) - at!(b),
        Operation::Multiply { to, a, b } => at!(to) = at!(a) * at!(b),
        Operation::Divide { to, a, b } => at!(to) = at!(a) / at!(b),
        Operation::Negate { to, a } => at!(to) = -at!(a),
        Operation::PlusProduct { to, rest, a, b } => at!(to) = at!(rest).plus_product(at!(a), at!(b)),
        Operation::MinusProduct { to, rest, a, b } => at!(to) = at!(rest).minus_product(at!(a), at!(b)),
        Operation::SineCosine { sine, cosine, angle } => {
            let (sine_value, cosine_value) = T::sin_cos(at!(angle));
            at!(sine) = sine_value;
            at!(cosine) = cosine_value;
        }
        Operation::Function { function, to, a } => at!(to) = function.of(at!(a)),
        Operation::ArcTangent { to, y, x } => at!(to) = at!(y).atan2(at!(x)),
        // calls are taken elsewhere
        Operation::Call(_) => {}
    }
}
