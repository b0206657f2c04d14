//! A mechanism whose names belong to the running program answers like a declared one.

use std::f64::consts::TAU;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::{AnyLinkage, LinkageFunctions};
use crate::any::{
    AnyMechanism, AssemblyChoice, AssemblyMotionOver, AssemblyOver, Block, ClosureOver, ClosureTerm, ClosureTermsOver,
    Described, Description, EveryPosition, FormsOver, Formulas, MotionNearOver, Name, NameKind, Named, NearOver, Of,
    Outline, OutputsOver, Pictured, PositionChoice, Quantity, SkeletonOver, TransmissionOver,
};
use crate::batch::{AnyBatch, GivenColumns, LengthMismatch, Outcome, Summary, Vectors, WantedColumns};
use crate::curve::LimitKind;
use crate::cycle::{SearchMethod, SearchedFunctions};
use crate::extremes::{ChangedFunctions, PositionFunctions};
use crate::failure::{InputValues, SolveError};
use crate::library::FourBar;
use crate::mechanism::{BlockForm, PositionSearch};
use crate::number::{Changing, series::Series};
use crate::picture::TransmissionAngle;
use crate::solve::Scalar;
use crate::sweep::{READ, SweptMechanism};

const INNER: &Of<FourBar> = Of::<FourBar>::FUNCTIONS;

/// A four-bar under other names.
#[derive(Debug)]
struct Made<'d>(Description<'d>);

impl Made<'_> {
    /// The error of the declared four-bar, without its names.
    fn unnamed<R>(&self, result: Result<R, SolveError>, inputs: &[f64]) -> Result<R, SolveError> {
        result.map_err(|error| {
            let inputs = InputValues::of(self.input_names(), inputs);
            error.failure.at(Name::by_index(NameKind::Block, 0), inputs)
        })
    }
}

impl Described for Made<'_> {
    fn description(&self) -> &Description<'_> {
        &self.0
    }

    fn assembly_count(&self) -> usize {
        INNER.assembly_count()
    }

    fn assembly_name(&self, index: usize) -> Option<String> {
        INNER.assembly_name(index)
    }

    fn choices(&self) -> Vec<String> {
        INNER.choices()
    }

    fn dyad_count(&self) -> usize {
        INNER.dyad_count()
    }
}

fn real<T: Scalar>(values: &[T]) -> Vec<f64> {
    values.iter().map(|value| value.real()).collect()
}

impl<T: Scalar> AssemblyOver<T> for Made<'_> {
    fn position_of_assembly(
        &self,
        parameters: &[T],
        inputs: &[T],
        assembly: usize,
        unknowns: &mut [T],
    ) -> Result<(), SolveError> {
        let found = INNER.position_of_assembly(parameters, inputs, assembly, unknowns);
        self.unnamed(found, &real(inputs))
    }
}

impl<T: Scalar> NearOver<T> for Made<'_> {
    fn position_near(&self, parameters: &[T], inputs: &[T], near: &[T], unknowns: &mut [T]) -> Result<(), SolveError> {
        let found = INNER.position_near(parameters, inputs, near, unknowns);
        self.unnamed(found, &real(inputs))
    }
}

impl<T: Scalar> ClosureOver<T> for Made<'_> {
    fn closure(&self, parameters: &[T], inputs: &[T], unknowns: &[T], residuals: &mut [T]) {
        INNER.closure(parameters, inputs, unknowns, residuals);
    }
}

impl<T: Scalar> ClosureTermsOver<T> for Made<'_> {
    fn closure_terms(&self, parameters: &[T], found: &mut dyn FnMut(&[ClosureTerm<'_>], &[T])) {
        INNER.closure_terms(parameters, found);
    }
}

impl<T: Scalar> OutputsOver<T> for Made<'_> {
    fn outputs(&self, parameters: &[T], inputs: &[T], unknowns: &[T], outputs: &mut [T]) {
        INNER.outputs(parameters, inputs, unknowns, outputs);
    }
}

impl<T: Scalar> SkeletonOver<T> for Made<'_> {
    fn skeleton_points(&self, parameters: &[T], inputs: &[T], unknowns: &[T], found: &mut dyn FnMut(&[T])) {
        INNER.skeleton_points(parameters, inputs, unknowns, found);
    }
}

impl Pictured for Made<'_> {
    fn outline(&self) -> Outline<'_> {
        INNER.outline()
    }

    fn is_space(&self) -> bool {
        INNER.is_space()
    }

    fn formulas(&self) -> Formulas<'_> {
        INNER.formulas()
    }
}

impl AssemblyMotionOver<f64> for Made<'_> {
    fn motion_of_assembly(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        assembly: usize,
        unknowns: &mut [f64],
        outputs: &mut [f64],
    ) -> Result<(), SolveError> {
        let found = INNER.motion_of_assembly(parameters, inputs, assembly, unknowns, outputs);
        self.unnamed(found, &inputs[..1])
    }
}

impl MotionNearOver<f64> for Made<'_> {
    fn motion_near(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        near: &[f64],
        unknowns: &mut [f64],
        outputs: &mut [f64],
    ) -> Result<(), SolveError> {
        let found = INNER.motion_near(parameters, inputs, near, unknowns, outputs);
        self.unnamed(found, &inputs[..1])
    }
}

impl<T: Scalar> TransmissionOver<T> for Made<'_> {
    fn angles_of_dyads(&self, parameters: &[T], inputs: &[T], unknowns: &[T], angles: &mut [TransmissionAngle<T>]) {
        INNER.angles_of_dyads(parameters, inputs, unknowns, angles);
        for angle in angles {
            angle.block = Name::by_index(NameKind::Block, 0);
        }
    }
}

impl<T: Scalar> FormsOver<T> for Made<'_> {
    fn block_forms(&self, parameters: &[T], found: &mut dyn FnMut(BlockForm<T>)) {
        INNER.block_forms(parameters, found);
    }
}

impl EveryPosition for Made<'_> {
    fn every_position(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        found: &mut dyn FnMut(&[f64]),
    ) -> Result<PositionSearch, SolveError> {
        self.unnamed(INNER.every_position(parameters, inputs, found), inputs)
    }
}

impl AnyMechanism for Made<'_> {
    fn assembly_at(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Option<usize> {
        INNER.assembly_at(parameters, inputs, unknowns)
    }
}

impl SweptMechanism for Made<'_> {}

impl AnyBatch for Made<'_> {
    fn solve_batch(
        &self,
        given: GivenColumns<'_>,
        wanted: &mut WantedColumns<'_>,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Result<Summary, LengthMismatch> {
        INNER.solve_batch(given, wanted, outcomes, vectors)
    }
}

impl ChangedFunctions for Made<'_> {
    fn above_snap(&self) -> Option<&dyn PositionFunctions<Changing<Series<READ>>>> {
        None
    }
}

impl SearchedFunctions for Made<'_> {
    fn method(&self) -> SearchMethod<'_> {
        SearchMethod::Closed(self)
    }
}

impl LinkageFunctions for Made<'_> {}

/// The names of the inputs, the unknowns and the block.
const NAMES: [[&str; 2]; 4] = [
    ["theta2", "lever_turn"],
    ["theta3, theta4", "lever_coupler, lever_swing"],
    ["theta3", "lever_coupler"],
    ["theta4", "lever_swing"],
];

/// The answers to some questions, or their errors, as texts. The last unknown bears a name.
fn answers(functions: &dyn LinkageFunctions, parameters: &[f64], swing: &str) -> Vec<String> {
    fn text<V: ToString, E: ToString>(result: Result<V, E>) -> String {
        result.map_or_else(|error| error.to_string(), |value| value.to_string())
    }
    let linkage = AnyLinkage::new(functions, parameters);
    let position = |at: f64| linkage.position(&[at], PositionChoice::Assembly(0));
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.0], &[TAU], 37)
        .speed(2.0);
    let cycle = linkage.cycle_along(&[0.0], &[1.0]).unwrap();
    let worst = cycle.along(0).worst_transmission().unwrap();
    let track = linkage.track(&[0.5], &position(0.5).unwrap(), &[3.0]);
    [
        text(position(2.5).map(|found| format!("{found:?}"))),
        text(track.map(|found| format!("{found:?}"))),
        text(sweep.of(&format!("{swing}_jerk")).peak()),
        text(sweep.of("margin").lowest()),
        text(sweep.of_transmission_angle(0).lowest()),
        format!("{} {} {}", worst.block, worst.angle, worst.input),
        format!("{:?} {:?}", cycle.circuits(), cycle.along(0).of(swing).stroke()),
    ]
    .into()
}

/// A mechanism under names of its own gives the answers and the messages of the declared one.
#[test]
fn a_mechanism_with_names_of_its_own() {
    let [turn, pair, coupler, swing] = NAMES.map(|[_, own]| own);
    let (inputs, unknowns) = (
        [Quantity::angle(turn, "")],
        [coupler, swing].map(|angle| Quantity::angle(angle, "")),
    );
    let blocks = [Block {
        unknowns: pair,
        ..INNER.description().blocks[0]
    }];
    let made = Made(Description {
        name: "Lever",
        inputs: &inputs,
        unknowns: &unknowns,
        blocks: &blocks,
        ..*INNER.description()
    });
    for parameters in [[90.0, 30.0, 70.0, 60.0], [90.0, 30.0, 60.0, 45.0]] {
        let declared = answers(INNER, &parameters, "theta4");
        let own = answers(&made, &parameters, swing);
        for (declared, own) in declared.into_iter().zip(own) {
            let renamed = NAMES
                .iter()
                .fold(declared, |text, [one, other]| text.replace(one, other));
            assert_eq!(Named::new(own, &made.0).to_string(), renamed);
        }
    }
}

/// The errors of a mechanism outlive it.
#[test]
fn errors_hold_indices() {
    let error = {
        let made = Made(Description {
            name: "short",
            ..*INNER.description()
        });
        let linkage = AnyLinkage::new(&made, &[90.0, 30.0, 60.0, 45.0]);
        linkage.position(&[2.5], PositionChoice::Assembly(0)).unwrap_err()
    };
    assert_eq!(error.block.index(), Some((NameKind::Block, 0)));
    assert!(
        error
            .to_string()
            .starts_with("‹block 0› cannot be found at ‹input 0› = 2.5 rad (143.2°): out of reach by")
    );
    let limits = {
        let made = Made(*INNER.description());
        let linkage = AnyLinkage::new(&made, &[90.0, 30.0, 60.0, 45.0]);
        linkage.cycle_along(&[0.0], &[1.0]).unwrap().branches()[0].clone()
    };
    for end in limits.ends() {
        assert_eq!(end.limit(), Some(LimitKind::TurningPoint));
        assert_eq!(end.block.index(), Some((NameKind::Block, 0)));
    }
}
