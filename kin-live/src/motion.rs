//! The solver of a mechanism: position, and the rates of every order.

mod chunks;

use kin_compiler::lowered::{self, Label, Symbol};
use kin_core::__private::live::{agreeing_in, check_guesses_in, culprit_in};
use kin_core::Scalar;
use kin_core::any::{Name, NameKind};
use kin_core::{Assembly, Direction, Plane};

use crate::code::{Assembler, Code, Labels, Register, TooLarge};
use crate::memory::{Lengths, Memory};
use crate::routine::{Given, Inputs, Routine};
use crate::run::{Choice, Fault, Run};

/// The solver of a mechanism.
#[derive(Debug)]
pub(crate) struct Motion {
    code: Code,
    given: Given,
    unknowns: Box<[Unknown]>,
    /// For each output the registers of its parts: those of the position, then those of the velocity, ….
    outputs: Box<[Box<[Register]>]>,
    telltales: Box<[Register]>,
    /// The angles among the unknowns.
    angles: Box<[(Name, usize)]>,
    /// The sides on which values of the unknowns lie, one for each choice.
    orientations: Routine,
    pub(crate) is_coupled: bool,
    pub(crate) choices: usize,
    pub(crate) order: usize,
    output_names: Box<[Name]>,
    /// The unknowns, as the error of a guess names them.
    all_unknowns: Name,
}

/// The registers of an unknown.
#[derive(Debug)]
struct Unknown {
    value: Value,
    /// Cosine and sine, if it is returned as a unit vector.
    vector: Option<[Register; 2]>,
    rates: Box<[Register]>,
}

/// The value of an unknown.
#[derive(Clone, Copy, Debug)]
enum Value {
    /// A number.
    Number(Register),
    /// An angle of which only cosine and sine are known.
    Direction { cosine: Register, sine: Register },
}

impl Motion {
    pub(crate) fn new(mechanism: &lowered::Mechanism, labels: &mut Labels<'_>) -> Result<Self, TooLarge> {
        let order = mechanism.description.order;
        let routines = std::iter::once(&mechanism.position).chain(&mechanism.rates);
        let routines = routines.map(Vec::as_slice);
        let mut assembler = Assembler::of(routines, results(mechanism), labels);
        let given = Given::of(&assembler);
        let unknowns = mechanism
            .directions
            .iter()
            .enumerate()
            .map(|(index, direction)| Unknown {
                value: match direction {
                    None => Value::Number(assembler.register(Symbol::Unknown(index))),
                    Some(vector) => match vector.angle {
                        Some(angle) => Value::Number(assembler.register(angle)),
                        None => Value::Direction {
                            cosine: assembler.register(vector.cosine),
                            sine: assembler.register(vector.sine),
                        },
                    },
                },
                vector: direction.map(|vector| [vector.cosine, vector.sine].map(|symbol| assembler.register(symbol))),
                rates: (1..=order)
                    .map(|order| assembler.register(Symbol::UnknownRate(index, order)))
                    .collect(),
            });
        let unknowns = unknowns.collect();
        let mut first = 0;
        let outputs = mechanism.outputs.iter().map(|(_, parts)| {
            let range = first..first + parts;
            first += parts;
            (0..=order)
                .flat_map(|order| range.clone().map(move |part| Symbol::OutputRate(part, order)))
                .map(|symbol| assembler.register(symbol))
                .collect()
        });
        let outputs = outputs.collect();
        let telltales = mechanism.telltales.iter();
        let telltales = telltales.map(|&(unknown, order)| assembler.register(Symbol::UnknownRate(unknown, order)));
        let telltales = telltales.collect();
        let all: Vec<usize> = (0..mechanism.directions.len()).collect();
        let telltales: Box<[Register]> = telltales;
        let mut code = assembler.finish()?;
        code.lengths.row = code.lengths.row.max(telltales.len());
        Ok(Self {
            code,
            given,
            unknowns,
            outputs,
            telltales,
            angles: mechanism
                .angles
                .iter()
                .map(|&unknown| (Name::by_index(NameKind::Unknown, unknown), unknown))
                .collect(),
            orientations: Routine::new(
                &mechanism.orientations.statements,
                &mechanism.orientations.results,
                labels,
            )?,
            is_coupled: mechanism.is_coupled,
            choices: mechanism.choices.len(),
            order,
            output_names: (0..mechanism.outputs.len())
                .map(|output| labels.name(&Label::Output(output)))
                .collect(),
            all_unknowns: labels.unknowns(&all),
        })
    }
}

/// The symbols of everything that is read after a run.
fn results(mechanism: &lowered::Mechanism) -> impl Iterator<Item = Symbol> + '_ {
    let order = mechanism.description.order;
    let unknowns = (0..mechanism.directions.len()).flat_map(move |unknown| {
        let rates = (1..=order).map(move |order| Symbol::UnknownRate(unknown, order));
        rates.chain([Symbol::Unknown(unknown)])
    });
    let vectors = mechanism.directions.iter().flatten();
    let vectors = vectors.flat_map(|vector| [vector.cosine, vector.sine].into_iter().chain(vector.angle));
    let parts = mechanism.outputs.iter().map(|(_, parts)| parts).sum();
    let outputs = (0..parts).flat_map(move |part| (0..=order).map(move |order| Symbol::OutputRate(part, order)));
    unknowns.chain(vectors).chain(outputs)
}

/// The numbers that are found in a chunk, until their memory is given back.
pub(crate) struct FoundMotion<'f, T, const C: usize = 1> {
    motion: &'f Motion,
    registers: &'f [[T; C]],
    chunk: usize,
}

impl<T: Scalar, const C: usize> FoundMotion<'_, T, C> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at(&self, register: Register) -> T {
        self.registers[usize::from(register)][self.chunk]
    }

    /// The value of an unknown. An angle that is calculated here is near a given one, or in -π ..= π.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn value(&self, unknown: usize, near: Option<&[T]>) -> T {
        match self.motion.unknowns[unknown].value {
            Value::Number(register) => self.at(register),
            Value::Direction { cosine, sine } => {
                let direction = Direction::new(Plane::new(self.at(cosine), self.at(sine)), []);
                match near {
                    Some(near) => direction.angle_near(near[unknown]),
                    None => direction.angle(),
                }
            }
        }
    }

    /// Writes the unknowns.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn write_position(&self, near: Option<&[T]>, unknowns: &mut [T]) {
        for (index, slot) in unknowns.iter_mut().enumerate() {
            *slot = self.value(index, near);
        }
    }

    /// Writes the motions of the unknowns, each with all its orders.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn write_unknowns(&self, near: Option<&[T]>, unknowns: &mut [T]) {
        let orders = self.motion.order + 1;
        let of_each = unknowns.chunks_exact_mut(orders).zip(&self.motion.unknowns);
        for (index, (slots, unknown)) in of_each.enumerate() {
            slots[0] = self.value(index, near);
            for (slot, register) in slots[1..].iter_mut().zip(&unknown.rates) {
                *slot = self.at(*register);
            }
        }
    }

    /// Writes the motions of as many scalar outputs as the slice holds.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn write_outputs(&self, outputs: &mut [T]) {
        let orders = self.motion.order + 1;
        let mut slots = outputs.chunks_exact_mut(orders);
        for registers in &self.motion.outputs {
            let parts = registers.len() / orders;
            for part in 0..parts {
                let Some(slots) = slots.next() else { return };
                for (order, slot) in slots.iter_mut().enumerate() {
                    *slot = self.at(registers[order * parts + part]);
                }
            }
        }
    }

    /// Whether an output is finite with all its rates, which stand order by order.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn output_is_finite(&self, registers: &[Register]) -> bool {
        let parts = registers.len() / (self.motion.order + 1);
        registers.chunks_exact(parts).all(|registers| match *registers {
            [x, y] => T::are_finite(&[self.at(x), self.at(y)]),
            [x, y, z] => T::are_finite(&[self.at(x), self.at(y), self.at(z)]),
            _ => registers.iter().all(|register| self.at(*register).is_finite()),
        })
    }

    /// Whether all numbers are finite. If a rate were not finite, a telltale would not be finite either.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_finite(&self, row: &mut [T]) -> bool {
        let telltales = &self.motion.telltales;
        let rates_are_finite = telltales.is_empty() || {
            let rates = &mut row[..telltales.len()];
            for (slot, register) in rates.iter_mut().zip(telltales) {
                *slot = self.at(*register);
            }
            T::are_finite(rates)
        };
        rates_are_finite
            && self
                .motion
                .outputs
                .iter()
                .all(|registers| self.output_is_finite(registers))
    }

    /// Whether an unknown is finite with all its rates.
    fn unknown_is_finite(&self, unknown: &Unknown) -> bool {
        let value_is_finite = match unknown.value {
            Value::Number(register) => self.at(register).is_finite(),
            Value::Direction { cosine, sine } => self.at(cosine).is_finite() && self.at(sine).is_finite(),
        };
        value_is_finite && unknown.rates.iter().all(|register| self.at(*register).is_finite())
    }
}

impl Motion {
    /// Solves the position in an assembly, or near values of the unknowns, and then the rates through an order.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn solve<T: Scalar, R>(
        &self,
        parameters: &[T],
        inputs: Inputs<'_, T>,
        choice: Choice<'_, T>,
        found: impl FnOnce(FoundMotion<'_, T>) -> R,
    ) -> Result<R, Fault> {
        self.code.lengths.lend([parameters, inputs.motions], |memory| {
            self.solve_in(memory, parameters, inputs, choice, found)
        })
    }

    /// Solves in memory that the caller lends.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve_in<T: Scalar, R>(
        &self,
        memory: Memory<'_, T, 1>,
        parameters: &[T],
        inputs: Inputs<'_, T>,
        choice: Choice<'_, T>,
        found: impl FnOnce(FoundMotion<'_, T>) -> R,
    ) -> Result<R, Fault> {
        let mut run = Run::single(&self.code, memory, choice);
        self.given.write(run.memory.registers, 0, parameters, inputs);
        for order in 0..inputs.orders {
            run.routine(order, 1)?;
        }
        let Memory { registers, row, .. } = run.memory;
        let motion = FoundMotion {
            motion: self,
            registers,
            chunk: 0,
        };
        if inputs.orders > 1 && !motion.is_finite(row) {
            return Err(self.not_finite(&motion, inputs));
        }
        Ok(found(motion))
    }

    /// Names the first input that is not finite, or else the first such result.
    #[cold]
    fn not_finite<T: Scalar>(&self, motion: &FoundMotion<'_, T>, inputs: Inputs<'_, T>) -> Fault {
        let unknowns = self.unknowns.iter().enumerate();
        let unknowns = unknowns.map(|(index, unknown)| {
            let name = Name::by_index(NameKind::Unknown, index);
            (name, motion.unknown_is_finite(unknown))
        });
        let outputs = self.output_names.iter().zip(&self.outputs);
        let outputs = outputs.map(|(name, registers)| (*name, motion.output_is_finite(registers)));
        let inputs = inputs.each().enumerate().map(|(index, motion)| {
            let is_finite = motion.iter().all(|entry| entry.is_finite());
            (Name::by_index(NameKind::Input, index), is_finite)
        });
        let (failure, label) = culprit_in(unknowns.chain(outputs), inputs);
        Fault { failure, label }
    }

    /// Calls a function with the choice that values of the unknowns stand for.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn near<T: Scalar, R>(
        &self,
        parameters: &[T],
        inputs: Inputs<'_, T>,
        near: &[T],
        function: impl FnOnce(Choice<'_, T>) -> Result<R, Fault>,
    ) -> Result<R, Fault> {
        let orientations = self.orientations.lengths();
        let lengths = Lengths {
            row: self.near_length(),
            ..orientations
        };
        lengths.lend([parameters, inputs.motions], |memory| {
            let row = &mut *memory.row;
            let memory = Memory { row: &mut [], ..memory };
            let choice = self.near_in(row, memory, parameters, inputs, near)?;
            function(choice)
        })
    }

    /// The numbers that values nearby take.
    pub(crate) fn near_length(&self) -> usize {
        self.unknowns.len() + self.choices
    }

    /// The memory that the orientations take.
    pub(crate) fn lengths_of_orientations(&self) -> Lengths {
        self.orientations.lengths()
    }

    /// The choice that values of the unknowns stand for, in memory that the caller lends: for the choice, and for the
    /// run that finds it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn near_in<'m, T: Scalar>(
        &self,
        memory: &'m mut [T],
        run: Memory<'_, T, 1>,
        parameters: &[T],
        inputs: Inputs<'_, T>,
        near: &[T],
    ) -> Result<Choice<'m, T>, Fault> {
        let (values, orientations) = memory.split_at_mut(self.unknowns.len());
        let orientations = &mut orientations[..self.choices];
        values.copy_from_slice(&near[..values.len()]);
        if !self.angles.is_empty() {
            let label = self.all_unknowns;
            check_guesses_in(values, &self.angles).map_err(|failure| Fault { failure, label })?;
        }
        let mut assembly = 0;
        if self.choices > 0 {
            let found = self.orientations.run_in(run, parameters, inputs, values);
            for (index, slot) in orientations.iter_mut().enumerate() {
                *slot = found.at(index);
            }
            for orientation in &*orientations {
                assembly = 2 * assembly + usize::from(orientation.side() == Assembly::Crossed);
            }
            if self.is_coupled {
                agreeing_in(values, orientations);
            }
        }
        Ok(Choice {
            near: Some(values),
            unknowns: self.unknowns.len(),
            assembly,
            choices: self.choices,
        })
    }

    /// The index of the assembly to which values of the unknowns belong.
    pub(crate) fn assembly_at(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> usize {
        let inputs = Inputs::positions(inputs);
        self.orientations.run(parameters, inputs, unknowns, |result| {
            (0..self.choices).fold(0, |assembly, index| {
                2 * assembly + usize::from(result(index).side() == Assembly::Crossed)
            })
        })
    }

    /// The choice of an assembly.
    pub(crate) fn in_assembly<T>(&self, assembly: usize) -> Choice<'_, T> {
        Choice {
            near: None,
            unknowns: self.unknowns.len(),
            assembly,
            choices: self.choices,
        }
    }
}
