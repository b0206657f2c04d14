//! All positions at given inputs.

use kin_compiler::lowered::{self, Symbol, SystemForm};
use kin_core::__private::continuation::{AllSolutions, BodySystem, BorrowedSystem, BorrowedTerm};
use kin_core::__private::live::{Choices, every_in, is_same_position};
use kin_core::any::{AssemblyOver, Described, EveryPosition, NearOver};
use kin_core::{Assembly, Failure, PositionSearch, SolveError};

use crate::code::{Assembler, Code, Labels, Register, TooLarge};
use crate::mechanism::Mechanism;
use crate::routine::{Given, Inputs};
use crate::run::{Choice, Run, Way};

/// The largest number of paths of a system.
const MOST_PATHS: usize = 1024;

/// The search for all positions of a mechanism with coupled blocks.
#[derive(Debug)]
pub(crate) struct Every {
    code: Code,
    given: Given,
    unknowns: Box<[Register]>,
    /// The system of each coupled block, by the index of the block.
    systems: Vec<(usize, System)>,
    /// The numbers in which the solutions of all systems are kept.
    room: usize,
}

/// The equations of a coupled block.
#[derive(Debug)]
struct System {
    form: Form,
    variables: usize,
    paths: usize,
}

#[derive(Debug)]
enum Form {
    Terms(Vec<(u16, u16, Vec<(u16, u8)>)>),
    Body(BodySystem),
}

impl Every {
    pub(crate) fn new(
        every: &lowered::EveryPosition,
        unknowns: usize,
        labels: &mut Labels<'_>,
    ) -> Result<Self, TooLarge> {
        let mut assembler = Assembler::default();
        assembler.routine(&every.statements, labels);
        let given = Given::of(&assembler);
        let unknowns = (0..unknowns).map(|unknown| assembler.register(Symbol::Unknown(unknown)));
        let unknowns = unknowns.collect();
        let systems = every.statements.iter().filter_map(|statement| match statement {
            lowered::Statement::Every {
                block,
                form,
                paths,
                results,
                ..
            } => Some((*block, System::new(form, *paths, results.len()))),
            _ => None,
        });
        Ok(Self {
            systems: systems.collect(),
            code: assembler.finish()?,
            given,
            unknowns,
            room: every.room,
        })
    }
}

impl System {
    fn new(form: &SystemForm, paths: usize, variables: usize) -> Self {
        let small = |number: usize| u16::try_from(number).unwrap_or(u16::MAX);
        let form = match form {
            SystemForm::Body { axes } => Form::Body(BodySystem::new(*axes)),
            SystemForm::Terms(terms) => Form::Terms(
                terms
                    .iter()
                    .map(|term| {
                        let powers = term.powers.iter();
                        let powers =
                            powers.map(|&(variable, power)| (small(variable), u8::try_from(power).unwrap_or(u8::MAX)));
                        (small(term.equation), small(term.coefficient), powers.collect())
                    })
                    .collect(),
            ),
        };
        Self { form, variables, paths }
    }

    /// Passes each real solution to `found`, and returns the number of lost paths.
    fn solve(&self, coefficients: &[f64], found: &mut dyn FnMut(&[f64])) -> usize {
        let terms: Vec<BorrowedTerm<'_>> = match &self.form {
            Form::Body(system) => return solve::<9>(system, coefficients, found),
            Form::Terms(terms) => terms
                .iter()
                .map(|(equation, coefficient, powers)| BorrowedTerm::new(*equation, *coefficient, powers))
                .collect(),
        };
        macro_rules! by_size {
            ($($size:literal)+) => {
                match self.variables {
                    $($size => solve::<$size>(&BorrowedSystem::<$size>::new(&terms), coefficients, found),)+
                    // none of these paths can be followed
                    _ => self.paths,
                }
            };
        }
        by_size!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16)
    }
}

fn solve<const M: usize>(system: &impl AllSolutions<M>, coefficients: &[f64], found: &mut dyn FnMut(&[f64])) -> usize {
    let outcome = system.real_solutions::<MOST_PATHS>(coefficients, |solution| found(&solution.values));
    outcome.map_or(1, |outcome| outcome.lost)
}

/// The way through all positions.
struct AllPositions<'w, 'm> {
    every: &'w Every,
    choices: &'w mut Choices<'m>,
}

impl Way<f64> for AllPositions<'_, '_> {
    fn assembly(&mut self) -> Assembly {
        self.choices.assembly()
    }

    fn solution(&mut self, block: usize, coefficients: &[f64], solution: &mut [f64]) -> Result<(), Failure> {
        let mut systems = self.every.systems.iter();
        let Some((_, system)) = systems.find(|(own, _)| *own == block) else {
            unreachable!("the code names the blocks that have a system");
        };
        let all = |found: &mut dyn FnMut(&[f64])| system.solve(coefficients, found);
        let known = self.choices.solution_in(system.variables, system.paths, all)?;
        solution.copy_from_slice(known);
        Ok(())
    }
}

impl Mechanism {
    /// The positions in all assemblies.
    fn positions_by_assembly(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        found: &mut dyn FnMut(&[f64]),
    ) -> Result<PositionSearch, SolveError> {
        let mut search = PositionSearch::default();
        search.is_complete = self.assembly_count() > 0;
        let mut unknowns = vec![0.0; self.description().unknowns.len()];
        for assembly in 0..self.assembly_count() {
            match self.position_of_assembly(parameters, inputs, assembly, &mut unknowns) {
                Ok(()) => {
                    search.found += 1;
                    found(&unknowns);
                }
                Err(error) => match error.failure {
                    Failure::NotFinite { .. } => return Err(error),
                    Failure::Singular { .. } => search.singular += 1,
                    // a position exists, but the range does not choose it
                    Failure::Ambiguous { .. } => search.is_complete = false,
                    _ => {}
                },
            }
        }
        Ok(search)
    }

    /// A position, as the choices on the way say.
    fn one_of_all(
        &self,
        every: &Every,
        parameters: &[f64],
        inputs: &[f64],
        choices: &mut Choices<'_>,
        unknowns: &mut [f64],
    ) -> Result<(), SolveError> {
        let inputs = Inputs::positions(inputs);
        let result = every.code.lengths.lend([parameters, inputs.motions], |memory| {
            every.given.write(memory.registers, parameters, inputs);
            let mut run = Run {
                code: &every.code,
                memory,
                choice: Choice::default(),
                way: AllPositions { every, choices },
            };
            run.routine(0)?;
            for (place, register) in unknowns.iter_mut().zip(&every.unknowns) {
                *place = run.memory.registers[usize::from(*register)];
            }
            Ok(())
        });
        result.map_err(|fault| self.error(fault, parameters, inputs))
    }
}

impl EveryPosition for Mechanism {
    fn every_position(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        found: &mut dyn FnMut(&[f64]),
    ) -> Result<PositionSearch, SolveError> {
        let Some(every) = &self.every else {
            return self.positions_by_assembly(parameters, inputs, found);
        };
        let count = self.description().unknowns.len();
        let mut all: Vec<Vec<f64>> = Vec::new();
        let mut search = PositionSearch::default();
        let (mut near, mut position) = (vec![0.0; count], vec![0.0; count]);
        let lost = every_in(&mut vec![0.0; every.room], |choices| {
            self.one_of_all(every, parameters, inputs, choices, &mut near)?;
            match self.position_near(parameters, inputs, &near, &mut position) {
                Ok(()) if all.iter().any(|known| is_same_position(known, &position)) => {}
                Ok(()) => all.push(position.clone()),
                Err(_) => search.singular += 1,
            }
            Ok(())
        })?;
        search.is_complete = lost == 0;
        for near in &all {
            match self.position_near(parameters, inputs, near, &mut position) {
                Ok(()) => {
                    search.found += 1;
                    found(&position);
                }
                Err(_) => search.singular += 1,
            }
        }
        Ok(search)
    }
}
