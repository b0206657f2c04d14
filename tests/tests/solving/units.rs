//! Results do not depend on the units: another unit of length or of time scales them, and nothing else.

use std::f64::consts::TAU;

use kin_core::prelude::*;
use kin_core::{Dimension, Quantity};
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{self, Case, Visitor};
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;

/// Factors of length and time.
#[derive(Clone, Copy)]
struct Units {
    length: f64,
    rate: f64,
}

impl Units {
    fn value(self, quantity: Quantity, value: f64) -> f64 {
        if quantity.dimension == Dimension::Length {
            value * self.length
        } else {
            value
        }
    }

    fn motion(self, quantity: Quantity, motion: Motion<f64, 5>) -> Motion<f64, 5> {
        let mut rate = 1.0 / self.rate;
        motion.map(|derivative| {
            rate *= self.rate;
            self.value(quantity, derivative * rate)
        })
    }
}

/// Compares a mechanism in other units with what it is in its own.
struct Compare {
    units: Units,
    /// Powers of two change no digit of any number.
    exactly: bool,
    poses: usize,
}

impl Visitor for Compare {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let units = self.units;
        let mut random = Random::new(81);
        for step in 0..12 {
            let mechanism: M = case.varied(&mut random);
            let parameters = mechanism.parameters();
            let scaled = M::from_parameters(M::Parameters::from_fn(|index| {
                units.value(M::DESCRIPTION.parameters[index], parameters[index])
            }));
            let inputs = case.inputs::<M>(f64::from(step) / 12.0, &mut random);
            let scaled_inputs = M::Inputs::from_fn(|index| units.motion(M::DESCRIPTION.inputs[index], inputs[index]));
            for assembly in M::assemblies() {
                let (own, other) = match (scaled.solve(scaled_inputs, assembly), mechanism.solve(inputs, assembly)) {
                    (Ok(own), Ok(other)) => (own, other),
                    (Err(own), Err(other)) => {
                        let name = M::DESCRIPTION.name;
                        assert_eq!(
                            core::mem::discriminant(&own.failure),
                            core::mem::discriminant(&other.failure),
                            "{name}: {own} instead of {other}"
                        );
                        assert_eq!(own.block, other.block, "{name}");
                        continue;
                    }
                    (own, other) => panic!("{own:?} instead of {other:?}"),
                };
                self.poses += 1;
                let unknowns = other.unknown_motions();
                let gauge = Gauge::new(&mechanism, &inputs, &unknowns);
                assert_outputs_agree(&mechanism, &inputs, &other, &gauge);
                let pairs = own.unknown_motions();
                for (index, (own, other)) in pairs.as_ref().iter().zip(unknowns.as_ref()).enumerate() {
                    let quantity = M::DESCRIPTION.unknowns[index];
                    let expected = units.motion(quantity, *other);
                    let unit = Motion::new([0, 1, 2, 3, 4].map(|order| ALLOWED[order] * gauge.unknown(index, order)));
                    let allowed = units.motion(quantity, unit).derivatives();
                    for (order, (a, b)) in own.derivatives().into_iter().zip(expected.derivatives()).enumerate() {
                        let allowed = if self.exactly { 0.0 } else { allowed[order] };
                        assert!(
                            (a - b).abs() <= allowed,
                            "{} of {}, order {order}: {a} instead of {b}",
                            quantity.name,
                            M::DESCRIPTION.name
                        );
                    }
                }
            }
        }
    }
}

/// The outputs of a pose are those for its inputs and unknowns, which are evaluated as they were typed. Angles may
/// differ by turns.
fn assert_outputs_agree<M: ThroughSnap>(mechanism: &M, inputs: &cases::Inputs<M>, pose: &M::Pose, gauge: &Gauge) {
    let unknowns = pose.unknown_motions();
    let at = mechanism.outputs_at(
        M::Inputs::from_fn(|input| inputs[input][0]),
        M::Unknowns::from_fn(|unknown| unknowns[unknown][0]),
    );
    let allowed = ALLOWED[0] * f64::EPSILON * gauge.condition.max(1.0);
    for (index, (value, output)) in at.as_ref().iter().zip(pose.output_motions().as_ref()).enumerate() {
        let quantity = M::DESCRIPTION.outputs[index];
        let difference = value - output[0];
        let turns = match quantity.dimension {
            Dimension::Angle => TAU * (difference / TAU).round(),
            _ => 0.0,
        };
        assert!(
            (difference - turns).abs() <= allowed * output[0].abs().max(gauge.length).max(1.0),
            "{} of {}: {value} instead of {}",
            quantity.name,
            M::DESCRIPTION.name,
            output[0]
        );
    }
}

/// All but the mechanisms with a range, the ends of which are in the unit of the declaration.
fn compare(length: f64, rate: f64, exactly: bool) {
    let mut compare = Compare {
        units: Units { length, rate },
        exactly,
        poses: 0,
    };
    cases::four_bars(&mut compare);
    cases::slider_cranks(&mut compare);
    cases::inverted_slider_cranks(&mut compare);
    cases::loops(&mut compare);
    cases::chains(&mut compare);
    cases::with_outputs(&mut compare);
    cases::library(&mut compare);
    assert!(compare.poses > 1000, "{}", compare.poses);
}

#[test]
fn powers_of_two_change_no_digit() {
    for power in [-20, 20] {
        compare(2.0_f64.powi(power), 1.0, true);
    }
}

#[test]
fn from_micro_to_mega() {
    for power in [-6, -3, 3, 6] {
        compare(10.0_f64.powi(power), 1.0, false);
    }
}

/// A unit of time that is a power of two as well.
#[test]
fn slow_motion_is_the_same_motion() {
    for power in [-10, 10] {
        compare(1.0, 2.0_f64.powi(power), true);
    }
}
