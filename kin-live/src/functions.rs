//! The functions of a mechanism on slices.

use kin_compiler::lowered::{BlockKind, Component, Form, Symbol};
use kin_core::__private::length;
use kin_core::__private::live::{
    ChangedFunctions, Changing, PositionFunctions, READ, SearchMethod, SearchedFunctions, SweptMechanism,
};
use kin_core::any::ClosureTerm;
use kin_core::any::{
    AnyMechanism, AssemblyMotionOver, AssemblyOver, ClosureOver, ClosureTermsOver, Described, Description, FormsOver,
    Formulas, MotionNearOver, Name, NameKind, NearOver, Outline, OutputsOver, Pictured, PlacesOver, PositionChoice,
    TransmissionOver,
};
use kin_core::batch::{AnyBatch, GivenColumns, LengthMismatch, Outcome, Summary, Vectors, WantedColumns, solve_each};
use kin_core::linkage::LinkageFunctions;
use kin_core::series::Series;
use kin_core::verify::{Differentiated, ThroughSnap, VerifiedFunctions, differentiated, left_over};
use kin_core::{BlockForm, Failure, InputValues, Scalar, SolveError, TransmissionAngle};

use crate::mechanism::Mechanism;
use crate::routine::Inputs;
use crate::run::{Fault, Lengths};
use crate::sheet::SheetCode;

impl Mechanism {
    /// The error of a fault at the given inputs. If a parameter or an input is not finite, the failure names it.
    ///
    /// Of several poses, nobody reads the error.
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
        let mut parameters = parameters.iter();
        let parameter = parameters.position(|parameter| !parameter.real().is_finite());
        let mut positions = [0.0; InputValues::CAPACITY];
        let mut bad_input = None;
        for (index, motion) in inputs.each().enumerate() {
            let position = motion[0].real();
            if let Some(place) = positions.get_mut(index) {
                *place = position;
            }
            if !position.is_finite() {
                bad_input = bad_input.or(Some(index));
            }
        }
        let culprit = parameter.map(|index| (NameKind::Parameter, index));
        let culprit = culprit.or(bad_input.map(|index| (NameKind::Input, index)));
        let failure = culprit.map_or(fault.failure, |(kind, index)| Failure::NotFinite {
            quantity: Name::by_index(kind, index),
        });
        let count = inputs.each().count().min(InputValues::CAPACITY);
        failure.at(fault.label, InputValues::of(self.input_names(), &positions[..count]))
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
    fn motions<'i, T>(&self, motions: &'i [T]) -> Inputs<'i, T> {
        Inputs {
            motions,
            orders: self.motion.order + 1,
        }
    }
}

impl<T: Scalar> TransmissionOver<T> for Mechanism {
    fn angles_of_dyads(&self, parameters: &[T], inputs: &[T], unknowns: &[T], angles: &mut [TransmissionAngle<T>]) {
        self.transmission
            .run(parameters, Inputs::positions(inputs), unknowns, |result| {
                for (index, (place, name)) in angles.iter_mut().zip(&self.dyads).enumerate() {
                    *place = TransmissionAngle::of(*name, result(2 * index), result(2 * index + 1));
                }
            });
    }
}

impl<T: Scalar> FormsOver<T> for Mechanism {
    fn block_forms(&self, parameters: &[T], found: &mut dyn FnMut(BlockForm<T>)) {
        let none = Inputs::positions(&[]);
        self.lengths.run(parameters, none, &[], |result| {
            let mut next = 0;
            let mut component = || {
                next += 1;
                result(next - 1)
            };
            let mut length = |parts: [Component; 2]| match parts {
                [_, Component::Number(0.0)] | [Component::Number(0.0), _] => component(),
                _ => {
                    let (x, y) = (component(), component());
                    length(x, y)
                }
            };
            for form in &self.forms {
                found(block_form(form, &mut length));
            }
        });
    }
}

/// The components of some forms that are found while the mechanism runs, in the order in which `block_forms` reads them.
pub(crate) fn components(forms: &[Form]) -> Vec<Component> {
    let lengths = forms.iter().flat_map(|form| form.lengths.iter().flatten());
    lengths
        .flat_map(|parts| match parts {
            [only, Component::Number(0.0)] | [Component::Number(0.0), only] => vec![*only],
            both => both.to_vec(),
        })
        .collect()
}

fn block_form<T: Scalar>(form: &Form, length: &mut impl FnMut([Component; 2]) -> T) -> BlockForm<T> {
    let mut lengths = form.lengths.iter().map(|parts| parts.map(&mut *length));
    let mut next = || lengths.next().flatten();
    let Some(driver) = form.driver else {
        return match form.kind {
            BlockKind::TwoLinks => {
                let first = next();
                BlockForm::two_links(first, next())
            }
            BlockKind::LinkAndSlider => BlockForm::link_and_slider(next()),
            BlockKind::SliderOnLink => BlockForm::slider_on_link(next()),
            BlockKind::PlacedLink => BlockForm::PlacedLink,
            BlockKind::Linear => BlockForm::Linear,
            BlockKind::Quadratic => BlockForm::Quadratic,
            BlockKind::CosineSine => BlockForm::CosineSine,
            BlockKind::Inverse => BlockForm::Inverse,
            BlockKind::FourBar | BlockKind::SliderCrank | BlockKind::InvertedSliderCrank | BlockKind::Coupled => {
                BlockForm::Coupled
            }
        };
    };
    let driver = match driver {
        Symbol::Input(index) => Name::by_index(NameKind::Input, index),
        Symbol::Unknown(index) => Name::by_index(NameKind::Unknown, index),
        _ => unreachable!("only inputs and unknowns move"),
    };
    let mut known = || next().unwrap_or_else(|| unreachable!("a driven block has its lengths"));
    match form.kind {
        BlockKind::SliderCrank => BlockForm::slider_crank(driver, std::array::from_fn(|_| known())),
        BlockKind::InvertedSliderCrank => BlockForm::inverted_slider_crank(driver, std::array::from_fn(|_| known())),
        _ => BlockForm::four_bar(driver, std::array::from_fn(|_| known())),
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

impl AnyBatch for Mechanism {
    fn solve_batch(
        &self,
        given: GivenColumns<'_>,
        wanted: &mut WantedColumns<'_>,
        outcomes: &mut [Outcome],
        _: Vectors,
    ) -> Result<Summary, LengthMismatch> {
        solve_each(self, given, wanted, outcomes)
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
        code.run(parameters, inputs, unknowns, memory.registers, results);
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

impl<T: Scalar> PlacesOver<T> for Mechanism {
    fn places(&self, parameters: &[T], inputs: &[T], unknowns: &[T], found: &mut dyn FnMut(&[T])) {
        let Some(any) = inputs.first() else { return };
        // written over, as the memory of a run is
        let mut places = vec![*any; self.places.results()];
        run_sheet(&self.places, [parameters, inputs, unknowns], &mut places);
        places.chunks_exact(if self.is_space() { 3 } else { 2 }).for_each(found);
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
