//! All positions at given inputs.

use kin_compiler::lowered::{self, Symbol, SystemForm};
use kin_core::__private::continuation::{AllSolutions, BodySystem, BorrowedSystem, BorrowedTerm};
use kin_core::__private::live::Choices;
use kin_core::{Assembly, Failure};

use crate::code::{Assembler, Code, Labels, Register, TooLarge};
use crate::routine::{Given, Inputs};
use crate::run::{Choice, Fault, Run, Way};

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
    pub(crate) room: usize,
    /// The largest number of positions.
    pub(crate) paths: usize,
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
    Terms(Vec<Term>),
    Body(BodySystem),
}

#[derive(Debug)]
struct Term {
    equation: u16,
    coefficient: u16,
    powers: Vec<(u16, u8)>,
}

impl Every {
    pub(crate) fn new(
        every: &lowered::EveryPosition,
        unknowns: usize,
        labels: &mut Labels<'_>,
    ) -> Result<Self, TooLarge> {
        let symbols = (0..unknowns).map(Symbol::Unknown);
        let mut assembler = Assembler::of([&*every.statements].into_iter(), symbols.clone(), labels);
        let given = Given::of(&assembler);
        let unknowns = symbols.map(|unknown| assembler.register(unknown)).collect();
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
            paths: every.paths,
        })
    }

    /// The position to which the choices on the way lead.
    pub(crate) fn one(
        &self,
        parameters: &[f64],
        inputs: Inputs<'_, f64>,
        choices: &mut Choices<'_>,
        unknowns: &mut [f64],
    ) -> Result<(), Fault> {
        self.code.lengths.lend([parameters, inputs.motions], |memory| {
            self.given.write(memory.registers, 0, parameters, inputs);
            let mut run = Run {
                code: &self.code,
                chunk: 0,
                memory,
                choice: Choice::default(),
                way: AllPositions { every: self, choices },
            };
            run.routine(0, 1)?;
            for (slot, register) in unknowns.iter_mut().zip(&self.unknowns) {
                *slot = run.memory.registers[usize::from(*register)][0];
            }
            Ok(())
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
                        Term {
                            equation: small(term.equation),
                            coefficient: small(term.coefficient),
                            powers: powers.collect(),
                        }
                    })
                    .collect(),
            ),
        };
        Self { form, variables, paths }
    }

    /// Passes each real solution to `found`, and returns the number of lost paths.
    fn solve(&self, coefficients: &[f64], found: &mut dyn FnMut(&[f64])) -> usize {
        let terms: Vec<BorrowedTerm<'_>> = match &self.form {
            Form::Body(system) => {
                let outcome = system.real_solutions::<MOST_PATHS>(coefficients, |solution| found(&solution.values));
                return outcome.map_or(1, |outcome| outcome.lost);
            }
            Form::Terms(terms) => terms
                .iter()
                .map(|term| BorrowedTerm::new(term.equation, term.coefficient, &term.powers))
                .collect(),
        };
        match self.variables {
            0..=8 => self.solve_terms::<8>(&terms, coefficients, found),
            9..=16 => self.solve_terms::<16>(&terms, coefficients, found),
            // none of these paths can be followed
            _ => self.paths,
        }
    }

    /// Solves a system with room for `M` variables.
    fn solve_terms<const M: usize>(
        &self,
        terms: &[BorrowedTerm<'_>],
        coefficients: &[f64],
        found: &mut dyn FnMut(&[f64]),
    ) -> usize {
        let system = BorrowedSystem::<M>::new(terms).with_variables(self.variables);
        let outcome = system.real_solutions::<MOST_PATHS>(coefficients, |solution| {
            found(&solution.values[..self.variables]);
        });
        outcome.map_or(1, |outcome| outcome.lost)
    }
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
        let Some((_, system)) = systems.find(|(index, _)| *index == block) else {
            unreachable!("the code names the blocks that have a system");
        };
        let all = |found: &mut dyn FnMut(&[f64])| system.solve(coefficients, found);
        let known = self.choices.solution_in(system.variables, system.paths, all)?;
        solution.copy_from_slice(known);
        Ok(())
    }
}
