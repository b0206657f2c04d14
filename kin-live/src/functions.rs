//! The functions of a mechanism on slices.

use kin_core::__private::live::{
    ChangedFunctions, Changing, PositionFunctions, READ, SearchMethod, SearchedFunctions, SweptMechanism, every_in,
    failed_in, is_same_position,
};
use kin_core::any::{
    AnyMechanism, AssemblyMotionOver, AssemblyOver, ClosureOver, ClosureTerm, ClosureTermsOver, Described, Description,
    EveryPosition, FormsOver, Formulas, MotionNearOver, Name, NearOver, Outline, OutputsOver, Pictured, PositionChoice,
    SkeletonOver, TransmissionOver,
};
use kin_core::linkage::LinkageFunctions;
use kin_core::series::Series;
use kin_core::verify::{Differentiated, ThroughSnap, VerifiedFunctions, differentiated, left_over};
use kin_core::{BlockForm, Failure, InputValues, PositionSearch, Scalar, SolveError, TransmissionAngle};

use crate::mechanism::Mechanism;
use crate::memory::{Lengths, Memory};
use crate::routine::Inputs;
use crate::run::Fault;
use crate::sheet::SheetCode;

impl Mechanism {
    /// The error of a fault at the given inputs. If a parameter or an input is not finite, the failure names it.
    ///
    /// Nobody reads the error of several poses.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn error<T: Scalar>(&self, fault: Fault, parameters: &[T], inputs: Inputs<'_, T>) -> SolveError {
        if T::DOUBT > 0.0 {
            return fault.failure.at(fault.label, InputValues::NONE);
        }
        self.error_of_one(fault, parameters, inputs)
    }

    #[cold]
    #[inline(never)]
    fn error_of_one<T: Scalar>(&self, fault: Fault, parameters: &[T], inputs: Inputs<'_, T>) -> SolveError {
        let parameters = parameters.iter().map(|parameter| parameter.real());
        let positions = inputs.each().map(|motion| motion[0].real());
        let names = self.input_names();
        failed_in(fault.failure, fault.label, Name::by_index, parameters, names, positions)
    }
}

impl Described for Mechanism {
    fn description(&self) -> &Description<'_> {
        self.names.get()
    }

    fn assembly_count(&self) -> usize {
        if self.motion.is_coupled {
            0
        } else {
            1 << self.motion.choices
        }
    }

    fn assembly_name(&self, index: usize) -> Option<String> {
        (index < self.assembly_count()).then(|| self.name_of_assembly(index))
    }

    fn choices(&self) -> Vec<String> {
        match self.choices.len() {
            _ if self.motion.is_coupled => Vec::new(),
            1 => vec!["assembly".to_owned()],
            _ => self.choices.clone(),
        }
    }

    fn dyad_count(&self) -> usize {
        self.dyads.len()
    }
}

impl<T: Scalar> AssemblyOver<T> for Mechanism {
    fn position_of_assembly(
        &self,
        parameters: &[T],
        inputs: &[T],
        assembly: usize,
        unknowns: &mut [T],
    ) -> Result<(), SolveError> {
        let inputs = Inputs::positions(inputs);
        let choice = self.motion.in_assembly(assembly);
        let found = self
            .motion
            .solve(parameters, inputs, choice, |found| found.write_position(None, unknowns));
        found.map_err(|fault| self.error(fault, parameters, inputs))
    }
}

impl<T: Scalar> NearOver<T> for Mechanism {
    fn position_near(&self, parameters: &[T], inputs: &[T], near: &[T], unknowns: &mut [T]) -> Result<(), SolveError> {
        let inputs = Inputs::positions(inputs);
        let found = self.motion.near(parameters, inputs, near, |choice| {
            let write = |found: crate::motion::FoundMotion<'_, T>| found.write_position(Some(near), unknowns);
            self.motion.solve(parameters, inputs, choice, write)
        });
        found.map_err(|fault| self.error(fault, parameters, inputs))
    }
}

impl<T: Scalar> AssemblyMotionOver<T> for Mechanism {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn motion_of_assembly(
        &self,
        parameters: &[T],
        inputs: &[T],
        assembly: usize,
        unknowns: &mut [T],
        outputs: &mut [T],
    ) -> Result<(), SolveError> {
        let inputs = self.motions(inputs);
        let choice = self.motion.in_assembly(assembly);
        let found = self.motion.solve(parameters, inputs, choice, |found| {
            found.write_unknowns(None, unknowns);
            found.write_outputs(outputs);
        });
        found.map_err(|fault| self.error(fault, parameters, inputs))
    }
}

impl<T: Scalar> MotionNearOver<T> for Mechanism {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn motion_near(
        &self,
        parameters: &[T],
        inputs: &[T],
        near: &[T],
        unknowns: &mut [T],
        outputs: &mut [T],
    ) -> Result<(), SolveError> {
        let inputs = self.motions(inputs);
        let found = self.motion.near(parameters, inputs, near, |choice| {
            self.motion.solve(parameters, inputs, choice, |found| {
                found.write_unknowns(Some(near), unknowns);
                found.write_outputs(outputs);
            })
        });
        found.map_err(|fault| self.error(fault, parameters, inputs))
    }
}

impl Mechanism {
    pub(crate) fn motions<'i, T>(&self, motions: &'i [T]) -> Inputs<'i, T> {
        Inputs {
            motions,
            orders: self.motion.order + 1,
        }
    }
}

impl<T: Scalar> TransmissionOver<T> for Mechanism {
    fn angles_of_dyads(&self, parameters: &[T], inputs: &[T], unknowns: &[T], angles: &mut [TransmissionAngle<T>]) {
        let inputs = Inputs::positions(inputs);
        self.transmission
            .lengths()
            .lend([parameters, inputs.motions], |memory| {
                self.angles_of_dyads_in(memory, parameters, inputs, unknowns, angles);
            });
    }
}

impl Mechanism {
    /// Writes the transmission angles, in memory that the caller lends.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn angles_of_dyads_in<T: Scalar>(
        &self,
        memory: Memory<'_, T, 1>,
        parameters: &[T],
        inputs: Inputs<'_, T>,
        unknowns: &[T],
        angles: &mut [TransmissionAngle<T>],
    ) {
        let found = self.transmission.run_in(memory, parameters, inputs, unknowns);
        for (index, (slot, name)) in angles.iter_mut().zip(&self.dyads).enumerate() {
            *slot = TransmissionAngle::of(*name, found.at(2 * index), found.at(2 * index + 1));
        }
    }
}

impl<T: Scalar> FormsOver<T> for Mechanism {
    fn block_forms(&self, parameters: &[T], found: &mut dyn FnMut(BlockForm<T>)) {
        self.forms.each(parameters, found);
    }
}

impl<T: Scalar> ClosureTermsOver<T> for Mechanism {
    fn closure_terms(&self, parameters: &[T], found: &mut dyn FnMut(&[ClosureTerm<'_>], &[T])) {
        let Some(closure) = &self.closure_terms else { return };
        let terms: Vec<ClosureTerm<'_>> = closure
            .terms
            .iter()
            .map(|term| {
                let (equation, factor, coefficient) = (term.equation, term.factor, term.coefficient);
                match &term.harmonic {
                    None => ClosureTerm::__one(equation, factor, coefficient, &term.powers),
                    Some((false, angle)) => ClosureTerm::__cosine(equation, factor, coefficient, &term.powers, angle),
                    Some((true, angle)) => ClosureTerm::__sine(equation, factor, coefficient, &term.powers, angle),
                }
            })
            .collect();
        let coefficients = &closure.coefficients;
        coefficients.run(parameters, Inputs::positions(&[]), &[], |result| {
            let numbers: Vec<T> = (0..coefficients.results.len()).map(result).collect();
            found(&terms, &numbers);
        });
    }
}

impl AnyMechanism for Mechanism {
    fn assembly_at(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Option<usize> {
        if self.motion.is_coupled {
            return None;
        }
        Some(self.motion.assembly_at(parameters, inputs, unknowns))
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
}

impl EveryPosition for Mechanism {
    fn every_position(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        found: &mut dyn FnMut(&[f64]),
    ) -> Result<PositionSearch, SolveError> {
        let paths = self.every.as_ref().map_or(self.assembly_count(), |every| every.paths);
        if paths > self.most_paths {
            // neither found nor complete
            return Ok(PositionSearch::default());
        }
        let Some(every) = &self.every else {
            return self.positions_by_assembly(parameters, inputs, found);
        };
        let given = Inputs::positions(inputs);
        let count = self.description().unknowns.len();
        let mut all: Vec<Vec<f64>> = Vec::new();
        let mut search = PositionSearch::default();
        let (mut near, mut position) = (vec![0.0; count], vec![0.0; count]);
        let lost = every_in(&mut vec![0.0; every.room], |choices| {
            every
                .one(parameters, given, choices, &mut near)
                .map_err(|fault| self.error(fault, parameters, given))?;
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

impl Pictured for Mechanism {
    fn outline(&self) -> Outline<'_> {
        self.names.outline()
    }

    fn is_space(&self) -> bool {
        self.names.is_space()
    }

    fn formulas(&self) -> Formulas<'_> {
        self.formulas().get()
    }
}

/// Runs the code of a translated method.
fn run_sheet<T: Scalar>(code: &SheetCode, given: [&[T]; 3], results: &mut [T]) {
    let [parameters, inputs, unknowns] = given;
    let lengths = Lengths {
        registers: code.registers(),
        ..Lengths::default()
    };
    lengths.lend([parameters, inputs], |memory| {
        code.run(
            parameters,
            inputs,
            unknowns,
            memory.registers.as_flattened_mut(),
            results,
        );
    });
}

impl<T: Scalar> ClosureOver<T> for Mechanism {
    fn closure(&self, parameters: &[T], inputs: &[T], unknowns: &[T], residuals: &mut [T]) {
        run_sheet(&self.closure, [parameters, inputs, unknowns], residuals);
    }
}

impl<T: Scalar> OutputsOver<T> for Mechanism {
    fn outputs(&self, parameters: &[T], inputs: &[T], unknowns: &[T], outputs: &mut [T]) {
        run_sheet(&self.outputs, [parameters, inputs, unknowns], outputs);
    }
}

impl<T: Scalar> SkeletonOver<T> for Mechanism {
    fn skeleton_points(&self, parameters: &[T], inputs: &[T], unknowns: &[T], found: &mut dyn FnMut(&[T])) {
        let Some(any) = inputs.first() else { return };
        // any number fills the vector, which the run overwrites
        let mut coordinates = vec![*any; self.skeleton_points.results()];
        run_sheet(&self.skeleton_points, [parameters, inputs, unknowns], &mut coordinates);
        coordinates
            .chunks_exact(if self.is_space() { 3 } else { 2 })
            .for_each(found);
    }
}

impl SweptMechanism for Mechanism {}

impl ChangedFunctions for Mechanism {
    fn above_snap(&self) -> Option<&dyn PositionFunctions<Changing<Series<READ>>>> {
        // above the fourth derivative
        (self.motion.order > 4).then_some(self as _)
    }
}

impl SearchedFunctions for Mechanism {
    fn method(&self) -> SearchMethod<'_> {
        if self.motion.is_coupled {
            SearchMethod::Coupled(self)
        } else {
            SearchMethod::Closed(self)
        }
    }
}

impl LinkageFunctions for Mechanism {}

impl VerifiedFunctions for Mechanism {
    fn left_over(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Vec<Vec<f64>> {
        match self.motion.order {
            ..=4 => left_over::<Series<5>>(self, parameters, inputs, unknowns),
            5..=8 => left_over::<Series<9>>(self, parameters, inputs, unknowns),
            _ => left_over::<Series<17>>(self, parameters, inputs, unknowns),
        }
    }

    fn differentiated(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        choice: PositionChoice<'_, f64>,
    ) -> Result<Differentiated, SolveError> {
        match self.motion.order {
            ..=4 => differentiated::<ThroughSnap>(self, parameters, inputs, choice),
            5..=8 => differentiated::<Series<9>>(self, parameters, inputs, choice),
            _ => differentiated::<Series<17>>(self, parameters, inputs, choice),
        }
    }
}
