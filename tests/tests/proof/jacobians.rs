//! The Jacobians of poses against dual numbers, one input after another.

use kin_core::prelude::*;
use kin_core::verify::by_differentiation;
use kin_tests::mechanisms::cases::{self, Case, Inputs, ThroughSnap, Visitor};
use kin_tests::mechanisms::coupled::{Built, Triad};
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;

/// Compares each column with the velocities at a unit velocity of its input. Returns whether the mechanism closes.
fn check<M: ThroughSnap>(mechanism: &M, at: Inputs<M>, assembly: M::Assembly) -> bool {
    let Ok(pose) = mechanism.solve(at, assembly) else {
        return false;
    };
    let name = M::DESCRIPTION.name;
    let values = M::Inputs::from_fn(|input| at[input].value());
    let near = M::Unknowns::from_fn(|unknown| pose.unknown_motions()[unknown].value());
    let jacobian = mechanism.jacobian_near(values, near).expect("it closes");
    for column in 0..M::DESCRIPTION.inputs.len() {
        let inputs = M::Inputs::from_fn(|input| {
            let rate = if input == column { 1.0 } else { 0.0 };
            Motion::at_constant_speed(values[input], rate)
        });
        let unit = mechanism.solve(inputs, assembly).expect("it closes");
        let (unknowns, outputs) = (unit.unknown_motions(), unit.output_motions());
        let gauge = Gauge::new(mechanism, &inputs, &unknowns);
        let expected = by_differentiation(mechanism, &inputs, assembly).expect("it closes on dual numbers, too");
        let rows = jacobian.as_ref();
        assert_eq!(rows.len(), expected.unknowns.len() + expected.outputs.len(), "{name}");
        for (index, expected) in expected.unknowns.iter().enumerate() {
            let error = (rows[index][column] - expected[1]).abs() / gauge.unknown(index, 1);
            assert!(error <= ALLOWED[1], "{name}, unknown {index}: {error} units");
        }
        for (index, expected) in expected.outputs.iter().enumerate() {
            let quantity = M::DESCRIPTION.outputs[index];
            let unit = gauge.output(&quantity, &outputs[index].derivatives(), 1);
            let row = rows[M::DESCRIPTION.unknowns.len() + index];
            let error = (row[column] - expected[1]).abs() / unit;
            assert!(error <= ALLOWED[1], "{name}, output {index}: {error} units");
        }
    }
    true
}

/// Every kind of mechanism in every assembly.
#[test]
fn columns_are_derivatives() {
    struct Prove;
    impl Visitor for Prove {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            let mut random = Random::new(M::DESCRIPTION.name.bytes().map(u64::from).sum());
            let mut poses = 0;
            for step in 0..24 {
                let fraction = (f64::from(step) + random.between(0.0, 1.0)) / 24.0;
                let mechanism: M = case.varied(&mut random);
                let inputs = case.inputs::<M>(fraction, &mut random);
                for assembly in M::assemblies() {
                    poses += usize::from(check(&mechanism, inputs, assembly));
                }
            }
            assert!(poses > 8, "{}: only {poses} poses", M::DESCRIPTION.name);
        }
    }
    cases::of_each_form(&mut Prove);
}

#[test]
fn columns_of_coupled_blocks_are_derivatives() {
    let mut random = Random::new(7);
    for _ in 0..50 {
        let Built {
            mechanism,
            input,
            unknowns,
        } = Triad::built(&mut random);
        assert!(check(&mechanism, [Motion::new(random.motion(input))], Near(unknowns)));
    }
}
