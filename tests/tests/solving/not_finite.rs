//! Every test mechanism with every parameter and every input in turn not a number, or infinite: the culprit is named.

use kin_core::prelude::*;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{self, Case, Visitor};
use kin_tests::random::Random;

const NONSENSE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// The cases that do not end as they should.
#[derive(Default)]
struct Wrong(Vec<String>);

/// Parameters in turn.
#[derive(Default)]
struct Parameters(Wrong);

/// Inputs in turn, at every order.
#[derive(Default)]
struct Inputs(Wrong);

impl Wrong {
    /// Notes a result that does not name the culprit.
    fn check<T: core::fmt::Debug>(&mut self, mechanism: &str, culprit: &str, result: Result<T, SolveError>) {
        match result {
            Err(SolveError {
                failure: Failure::NotFinite { quantity },
                ..
            }) if quantity == culprit => {}
            Err(error) => self.0.push(format!("{mechanism}, {culprit}: {error}")),
            Ok(found) => self.0.push(format!("{mechanism}, {culprit}: {found:?}")),
        }
    }
}

/// A mechanism, inputs and an assembly that fit together.
fn closing<M: ThroughSnap>(case: Case) -> (M, M::Inputs<Motion<f64, 5>>, M::Assembly) {
    let mechanism: M = case.mechanism();
    let mut random = Random::new(71);
    for step in 0..60 {
        let inputs = case.inputs::<M>(f64::from(step) / 60.0, &mut random);
        // where assemblies have no names, a guess will do
        let values = M::Inputs::from_fn(|index| inputs[index].value());
        let guess = M::Unknowns::from_fn(|_| random.between(-3.0, 3.0));
        let near = mechanism.position_near(values, guess).ok();
        let guessed = near
            .filter(|_| M::ASSEMBLY_COUNT == 0)
            .map(|near| mechanism.assembly_at(values, near));
        for assembly in M::assemblies().chain(guessed) {
            if mechanism.solve(inputs, assembly).is_ok() {
                return (mechanism, inputs, assembly);
            }
        }
    }
    panic!("{} does not close", M::DESCRIPTION.name);
}

impl Visitor for Parameters {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let (mechanism, inputs, assembly) = closing::<M>(case);
        for (place, quantity) in M::DESCRIPTION.parameters.iter().enumerate() {
            for nonsense in NONSENSE {
                let mut parameters = mechanism.parameters();
                parameters[place] = nonsense;
                let result = M::from_parameters(parameters).solve(inputs, assembly);
                self.0.check(M::DESCRIPTION.name, quantity.name, result);
            }
        }
    }
}

impl Visitor for Inputs {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let (mechanism, inputs, assembly) = closing::<M>(case);
        for (place, quantity) in M::DESCRIPTION.inputs.iter().enumerate() {
            for nonsense in NONSENSE {
                for order in 0..5 {
                    let mut inputs = inputs;
                    let mut derivatives = inputs[place].derivatives();
                    derivatives[order] = nonsense;
                    inputs[place] = Motion::new(derivatives);
                    let result = mechanism.solve(inputs, assembly);
                    self.0.check(M::DESCRIPTION.name, quantity.name, result);
                }
            }
        }
    }
}

#[test]
fn parameters() {
    let mut parameters = Parameters::default();
    cases::of_each_form(&mut parameters);
    cases::coupled_library(&mut parameters);
    assert!(parameters.0.0.is_empty(), "{:#?}", parameters.0.0);
}

#[test]
fn inputs_and_their_rates() {
    let mut inputs = Inputs::default();
    cases::of_each_form(&mut inputs);
    cases::coupled_library(&mut inputs);
    assert!(inputs.0.0.is_empty(), "{:#?}", inputs.0.0);
}

/// Numbers that are finite and far beyond sense give finite results or errors.
#[test]
fn extremes() {
    struct Extremes;
    impl Visitor for Extremes {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            let (mechanism, inputs, assembly) = closing::<M>(case);
            for extreme in [0.0, 1e-320, -1e-200, 1e-160, -1e160, 1e200, f64::MAX, f64::MIN_POSITIVE] {
                for place in 0..M::DESCRIPTION.parameters.len() {
                    let mut parameters = mechanism.parameters();
                    parameters[place] = extreme;
                    let mechanism = M::from_parameters(parameters);
                    for assembly in M::assemblies().chain([assembly]) {
                        check::<M>(mechanism.solve(inputs, assembly), extreme);
                    }
                }
                for order in 0..5 {
                    let mut inputs = inputs;
                    let mut derivatives = inputs[0].derivatives();
                    derivatives[order] = extreme;
                    inputs[0] = Motion::new(derivatives);
                    check::<M>(mechanism.solve(inputs, assembly), extreme);
                }
            }
        }
    }
    fn check<M: ThroughSnap>(result: Result<M::Pose, SolveError>, extreme: f64) {
        if let Ok(pose) = result {
            let finite = |motions: &[Motion<f64, 5>]| motions.iter().all(Motion::<f64, 5>::is_finite);
            assert!(
                finite(pose.unknown_motions().as_ref()) && finite(pose.output_motions().as_ref()),
                "{}, {extreme}: {pose:?}",
                M::DESCRIPTION.name
            );
        }
    }
    cases::of_each_form(&mut Extremes);
    cases::coupled_library(&mut Extremes);
}
