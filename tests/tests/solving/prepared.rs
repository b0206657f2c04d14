//! What is prepared for many poses of a mechanism changes no bit of any of them.
#![allow(clippy::cast_precision_loss, reason = "there are hundreds of poses")]

use kin_core::Prepared;
use kin_core::prelude::*;
use kin_tests::batches::{Poses, vectors};
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap};
use kin_tests::random::Random;

/// Poses in a batch: several chunks in all vectors, and no multiple of lanes.
const POSES: usize = 53;

#[derive(Default)]
struct Compare {
    /// The mechanisms of which anything is prepared.
    prepared: usize,
    solved: usize,
    failed: usize,
}

/// All numbers of a pose, as they are printed: NaN is like NaN, and zero is not like negative zero.
fn numbers<M: ThroughSnap>(pose: Result<M::Pose, SolveError>) -> String {
    pose.map_or_else(
        |error| format!("{error:?}"),
        |pose| {
            let (unknowns, sines, outputs) = (pose.unknown_columns(), pose.unknown_sines(), pose.output_motions());
            format!("{:?} {:?} {:?}", unknowns.as_ref(), sines.as_ref(), outputs.as_ref())
        },
    )
}

impl Compare {
    fn check<M: ThroughSnap>(&mut self, mechanism: M, inputs: &[M::Inputs<M::Motion<f64>>]) {
        let name = M::DESCRIPTION.name;
        let prepared = Prepared::of(mechanism);
        assert_eq!(format!("{:?}", prepared.mechanism()), format!("{mechanism:?}"));
        let poses = Poses {
            mechanisms: vec![mechanism; inputs.len()],
            inputs: inputs.to_vec(),
            near: Vec::new(),
        };
        for assembly in M::assemblies() {
            for inputs in inputs {
                let found = prepared.solve(*inputs, assembly);
                let expected = mechanism.solve(*inputs, assembly);
                *(if expected.is_ok() {
                    &mut self.solved
                } else {
                    &mut self.failed
                }) += 1;
                assert_eq!(numbers::<M>(found), numbers::<M>(expected), "{name} {mechanism:?}");
            }
            for vectors in vectors() {
                let in_columns = format!("{:?}", poses.solve(Some(assembly), vectors));
                let prepared = format!("{:?}", poses.solve_as_one_mechanism(assembly, vectors));
                assert_eq!(prepared, in_columns, "{name} {mechanism:?} {vectors:?}");
            }
        }
    }
}

impl cases::Visitor for Compare {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        self.prepared += usize::from(size_of::<M::Prepared>() > 0);
        let mut random = Random::new(M::DESCRIPTION.name.len() as u64);
        let inputs: Vec<_> = (0..POSES)
            .map(|index| case.inputs::<M>((index as f64 + 0.5) / POSES as f64, &mut random))
            .collect();
        let mechanism: M = case.varied(&mut random);
        self.check(mechanism, &inputs);
        // links that cannot be assembled in any position, and numbers that are none
        for place in 0..M::DESCRIPTION.parameters.len() {
            for value in [0.0, 30.0 * mechanism.parameters().as_ref()[place], f64::NAN] {
                let mut parameters = mechanism.parameters();
                parameters.as_mut()[place] = value;
                self.check(M::from_parameters(parameters), &inputs[..19]);
            }
        }
    }
}

#[test]
fn what_is_prepared_changes_no_bit() {
    let mut compare = Compare::default();
    cases::of_each_form(&mut compare);
    let Compare {
        prepared,
        solved,
        failed,
    } = compare;
    println!("{prepared} mechanisms are prepared; {solved} poses, {failed} failures");
    assert!(
        prepared > 3 && solved > 4_000 && failed > 5_000,
        "{prepared} {solved} {failed}"
    );
}
