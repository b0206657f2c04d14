//! The program of the steps that lead to results, which runs for many poses at once.

use alloc::vec;
use alloc::vec::Vec;

use super::steps::{Step, Trace};
use super::traced::{Traced, trace_of};
use crate::batch::Kernel;
use crate::batch::lanes::Lanes;
use crate::number::Number;

/// Where a result stands: in a column, or nowhere because it is the same in all poses.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    Column(usize),
    Same(f64),
}

/// The steps that lead to results in many poses.
#[derive(Clone, Debug)]
pub(super) struct Program {
    /// The steps, each with the register of its result, and the column into which this is written.
    steps: Vec<(Step, u32, Option<u32>)>,
    /// The constants, each with its register.
    constants: Vec<(u32, f64)>,
    registers: usize,
    results: usize,
}

/// The poses for which a step is done at once. They fill two or more vectors.
const AT_ONCE: usize = 32;

impl Program {
    /// The program of what a function does with numbers, with the places of all numbers that it lists.
    pub(super) fn of<R>(trace: impl FnOnce() -> (R, Vec<Traced>)) -> (R, Self, Vec<Place>) {
        let ((result, wanted), trace) = trace_of(trace);
        let (program, places) = trace.program(&wanted);
        (result, program, places)
    }

    /// The number of columns of results.
    pub(super) fn results(&self) -> usize {
        self.results
    }
}

impl Trace {
    fn program(&self, wanted: &[Traced]) -> (Program, Vec<Place>) {
        const UNUSED: usize = usize::MAX;
        // the last step that needs each number
        let mut last = vec![UNUSED; self.steps.len()];
        let mut columns = vec![None; self.steps.len()];
        let mut results = 0;
        let places = wanted.iter().map(|number| {
            let Some(node) = number.node().map(|node| node as usize) else {
                return Place::Same(number.real());
            };
            last[node] = last[node].min(node);
            let column = *columns[node].get_or_insert_with(|| {
                results += 1;
                results - 1
            });
            Place::Column(column)
        });
        let places: Vec<Place> = places.collect();
        for (node, step) in self.steps.iter().enumerate().rev() {
            if last[node] == UNUSED && !step.is_guard() {
                continue;
            }
            let (operands, count) = step.operands();
            for operand in &operands[..count] {
                let last = &mut last[*operand as usize];
                if *last == UNUSED || *last < node {
                    *last = node;
                }
            }
        }
        let mut program = Program {
            steps: Vec::new(),
            constants: Vec::new(),
            registers: 0,
            results,
        };
        let mut registers = vec![0; self.steps.len()];
        let mut free: Vec<u32> = Vec::new();
        for (node, step) in self.steps.iter().enumerate() {
            if last[node] == UNUSED && !step.is_guard() {
                continue;
            }
            let mut take = || {
                free.pop().unwrap_or_else(|| {
                    program.registers += 1;
                    u32::try_from(program.registers - 1).unwrap_or(u32::MAX)
                })
            };
            if let Step::Constant(value) = step {
                // it stays there for all poses
                program.registers += 1;
                registers[node] = u32::try_from(program.registers - 1).unwrap_or(u32::MAX);
                program.constants.push((registers[node], *value));
                continue;
            }
            let (operands, count) = step.operands();
            let own = operands.map(|operand| registers[operand as usize]);
            // results never take the place of an operand, which could be read afterwards
            if !step.is_guard() {
                registers[node] = take();
            }
            let column = columns[node].map(|column| u32::try_from(column).unwrap_or(u32::MAX));
            program.steps.push((step.with(own), registers[node], column));
            for (index, operand) in operands[..count].iter().enumerate() {
                let operand = *operand as usize;
                let is_again = index == 1 && operands[0] == operands[1];
                let stays = matches!(self.steps[operand], Step::Constant(_));
                if last[operand] == node && !stays && !is_again {
                    free.push(registers[operand]);
                }
            }
            if !step.is_guard() && last[node] == node {
                free.push(registers[node]);
            }
        }
        (program, places)
    }
}

/// A program with the numbers of poses in columns, each of which has room for as many as are found at once.
pub(super) struct ProgramRun<'r> {
    pub(super) program: &'r Program,
    /// So many poses there are.
    pub(super) count: usize,
    /// The length of a column.
    pub(super) stride: usize,
    pub(super) given: &'r [f64],
    pub(super) results: &'r mut [f64],
    /// Finite for the poses that are solved.
    pub(super) kept: &'r mut [f64],
}

impl Kernel for ProgramRun<'_> {
    type Result = ();
    type Element = f64;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const BITS: usize>(self) {
        let groups = AT_ONCE / W;
        let zero = Lanes::<W, BITS>::constant(0.0);
        let mut registers = vec![zero; self.program.registers * groups];
        for (register, value) in &self.program.constants {
            registers[*register as usize * groups..][..groups].fill(Lanes([*value; W]));
        }
        let mut start = 0;
        while start < self.count {
            for group in 0..groups {
                self.kept[start + group * W..][..W].fill(0.0);
            }
            for (step, own, column) in &self.program.steps {
                let at = |register: u32, group: usize| register as usize * groups + group;
                // the kind of a step is looked up once for all groups
                macro_rules! each {
                    (|$group:ident| $value:expr) => {
                        for $group in 0..groups {
                            registers[at(*own, $group)] = $value;
                        }
                    };
                }
                match *step {
                    Step::Given(column) => each!(|group| {
                        let mut lanes = [0.0; W];
                        let first = column as usize * self.stride + start + group * W;
                        lanes.copy_from_slice(&self.given[first..][..W]);
                        Lanes(lanes)
                    }),
                    Step::Constant(value) => each!(|group| Lanes([value; W])),
                    Step::Sum([a, b]) => each!(|group| registers[at(a, group)] + registers[at(b, group)]),
                    Step::Difference([a, b]) => each!(|group| registers[at(a, group)] - registers[at(b, group)]),
                    Step::Product([a, b]) => each!(|group| registers[at(a, group)] * registers[at(b, group)]),
                    Step::Quotient([a, b]) => each!(|group| registers[at(a, group)] / registers[at(b, group)]),
                    Step::Opposite(a) => each!(|group| -registers[at(a, group)]),
                    Step::SquareRoot(a) => each!(|group| Number::sqrt(registers[at(a, group)])),
                    Step::Size(a) => each!(|group| {
                        let Lanes(a) = registers[at(a, group)];
                        Lanes::from_fn(|lane| a[lane].abs())
                    }),
                    Step::Larger([a, b]) => each!(|group| {
                        let (Lanes(a), Lanes(b)) = (registers[at(a, group)], registers[at(b, group)]);
                        Lanes::from_fn(|lane| if a[lane] > b[lane] { a[lane] } else { b[lane] })
                    }),
                    Step::Call(call, a) => each!(|group| {
                        let Lanes(a) = registers[at(a, group)];
                        Lanes::from_fn(|lane| call(a[lane]))
                    }),
                    Step::CallOfTwo(call, [a, b]) => each!(|group| {
                        let (Lanes(a), Lanes(b)) = (registers[at(a, group)], registers[at(b, group)]);
                        Lanes::from_fn(|lane| call(a[lane], b[lane]))
                    }),
                    Step::Exceeds([a, b], part, exceeds) => {
                        for group in 0..groups {
                            let (Lanes(a), Lanes(b)) = (registers[at(a, group)], registers[at(b, group)]);
                            let kept = &mut self.kept[start + group * W..][..W];
                            for lane in 0..W {
                                let agrees = (a[lane].abs() > part * b[lane].abs()) == exceeds;
                                kept[lane] = if agrees { kept[lane] } else { f64::NAN };
                            }
                        }
                    }
                    Step::Sign(a, is_negative) => {
                        for group in 0..groups {
                            let Lanes(a) = registers[at(a, group)];
                            let kept = &mut self.kept[start + group * W..][..W];
                            for lane in 0..W {
                                let agrees = (a[lane] < 0.0) == is_negative;
                                kept[lane] = if agrees { kept[lane] } else { f64::NAN };
                            }
                        }
                    }
                }
                let Some(column) = column else { continue };
                for group in 0..groups {
                    let (first, Lanes(value)) = (start + group * W, registers[at(*own, group)]);
                    self.results[*column as usize * self.stride + first..][..W].copy_from_slice(&value);
                    let kept = &mut self.kept[first..][..W];
                    for lane in 0..W {
                        // zero, unless it is not finite
                        kept[lane] += 0.0 * value[lane];
                    }
                }
            }
            start += AT_ONCE;
        }
    }
}

/// The length of columns for so many poses.
pub(super) const fn stride(poses: usize) -> usize {
    poses.next_multiple_of(AT_ONCE)
}
