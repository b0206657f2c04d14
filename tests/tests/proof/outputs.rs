//! Outputs, which are carried along with the unknowns: points, angles, lengths, and functions of them, each through
//! snap.

use core::f64::consts::TAU;

use kin_core::prelude::*;
use kin_core::series::Series;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{self, Case, Visitor};
use kin_tests::mechanisms::dyads::FiveBar;
use kin_tests::mechanisms::outputs::{ClosureOutsideDomain, FourBarOutputs, OutputOutsideDomain, OutputsInFormulas};
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;
use kin_tests::samples;
use num_dual::{HyperDual, HyperDual64};

/// A number that holds the first four derivatives in time.
type Nested = HyperDual<HyperDual64>;

fn derivatives(number: Nested) -> [f64; 5] {
    [
        number.re.re,
        number.re.eps1,
        number.re.eps1eps2,
        number.eps1.eps1eps2,
        number.eps1eps2.eps1eps2,
    ]
}

/// A motion as such a number.
fn nested(motion: Motion<f64, 5>) -> Nested {
    let d = motion.derivatives();
    // of two steps inside and two outside, every subset of k steps holds the k-th derivative
    let inner = |k: usize| HyperDual64::new(d[k], d[k + 1], d[k + 1], d[k + 2]);
    HyperDual::new(inner(0), inner(1), inner(1), inner(2))
}

/// The rate at which a quantity of a given size changes, as a frequency.
fn frequency(motion: Motion<f64, 5>, size: f64) -> f64 {
    motion
        .derivatives()
        .into_iter()
        .zip(0_i32..)
        .skip(1)
        .fold(0.0, |largest, (rate, order)| {
            largest.max((rate.abs() / size).powf(1.0 / f64::from(order)))
        })
}

/// Asserts that an output's own derivatives are the expected ones to a few units ε wⁿ of its size, times `condition`.
#[track_caller]
fn assert_agree(name: &str, own: Motion<f64, 5>, expected: [f64; 5], size: f64, w: f64, condition: f64) {
    let w = w.max(frequency(own, size));
    for (order, (a, b)) in own.derivatives().into_iter().zip(expected).enumerate() {
        let power = i32::try_from(order).expect("orders are small");
        let allowed = ALLOWED[order] * f64::EPSILON * condition * w.powi(power) * size;
        assert!(
            (a - b).abs() <= allowed,
            "{name}, order {order}: {a} against {b} at rates {w}, condition {condition}"
        );
    }
}

/// Every output of mechanisms of every form, by dual numbers through the position.
#[test]
fn outputs_by_differentiation() {
    struct Prove(usize);
    impl Visitor for Prove {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            type Pose<M> = <<M as Mechanism>::With<Nested> as Mechanism>::Pose;
            // Known when it is compiled, so that nothing below is compiled for a mechanism without outputs.
            if const { M::DESCRIPTION.outputs.is_empty() } {
                return;
            }
            let mut random = Random::new(51);
            let every = 64 / samples::of(64);
            for step in (0..64).step_by(every) {
                let mechanism: M = case.varied(&mut random);
                let inputs = case.inputs::<M>(f64::from(step) / 64.0, &mut random);
                for assembly in M::assemblies() {
                    let Ok(pose) = mechanism.solve(inputs, assembly) else {
                        continue;
                    };
                    let unknowns = pose.unknown_motions();
                    let gauge = Gauge::new(&mechanism, &inputs, &unknowns);
                    let lifted = mechanism.convert(<Nested as Number>::constant);
                    let still =
                        <<M::With<Nested> as Mechanism>::Inputs<M::Motion<Nested>> as Row<_>>::from_fn(|index| {
                            let value = nested(inputs[index]);
                            let zero = <Nested as Number>::constant(0.0);
                            <M::Motion<Nested> as Row<Nested>>::from_fn(|order| if order == 0 { value } else { zero })
                        });
                    let lifted: Pose<M> = lifted.solve(still, assembly).expect("it closes on dual numbers");
                    // lengths are as large as the largest, and so are the terms that make up an output
                    let largest = mechanism
                        .parameters()
                        .as_ref()
                        .iter()
                        .fold(1.0, |a: f64, b| a.max(b.abs()));
                    let w = gauge.frequency.max(gauge.condition * gauge.driving);
                    let outputs = (pose.output_motions(), lifted.output_motions());
                    for (index, (own, expected)) in outputs.0.as_ref().iter().zip(outputs.1.as_ref()).enumerate() {
                        let quantity = M::DESCRIPTION.outputs[index];
                        let size = match quantity.dimension {
                            kin_core::Dimension::Length => largest.max(own.value().abs()),
                            _ => own.value().abs().max(1.0),
                        };
                        let condition = gauge.condition * gauge.condition;
                        assert_agree(quantity.name, *own, derivatives(expected[0]), size, w, condition);
                        self.0 += 1;
                    }
                }
            }
        }
    }
    let mut prove = Prove(0);
    cases::of_each_form(&mut prove);
    assert!(prove.0 > 50 * samples::of(64), "{}", prove.0);
}

/// The outputs of [`FourBarOutputs`] by their formulas, on numbers of any kind.
fn formulas<S: Scalar>(parameters: [f64; 6], theta2: S, theta3: S, theta4: S) -> Vec<(&'static str, S)> {
    let [r1, r2, r3, r4, trace_x, trace_y] = parameters.map(S::constant);
    let [one, two] = [1.0, 2.0].map(S::constant);
    let (cis2, cis3, cis4) = {
        let cis = |angle: S| {
            let (sine, cosine) = angle.sin_cos();
            Plane::new(cosine, sine)
        };
        (cis(theta2), cis(theta3), cis(theta4))
    };
    let pin = cis2.scale(r2);
    let coupler_point = pin + Plane::new(trace_x, trace_y).times(cis3);
    let midpoint = (pin + Plane::new(r1, S::constant(0.0)) + cis4.scale(r4)).scale(S::constant(0.5));
    let third = (theta3 - theta4).sin_cos().0 / (theta3 - theta2).sin_cos().0;
    // not as one over the tangent, the series of which is useless where it is large
    let cotangent = {
        let (sine, cosine) = (theta3 + two).sin_cos();
        cosine / sine
    };
    let turned = pin.times(cis4);
    vec![
        ("coupler_point.x", coupler_point.x),
        ("coupler_point.y", coupler_point.y),
        ("midpoint.x", midpoint.x),
        ("midpoint.y", midpoint.y),
        ("transmission", theta4 - theta3),
        ("diagonal", (r1 * r1 + r2 * r2 - two * r1 * pin.x).sqrt()),
        ("bearing", (pin.y + trace_x * cis3.y).atan2(pin.x - r1)),
        ("slope", (pin.y + r3 / two * cis3.y) / (pin.x + r3 / two * cis3.x)),
        ("advantage", third),
        (
            "decay",
            (-theta3 * theta3 / two).exp() * (one + theta4 * theta4).ln() + theta2.atan() * cotangent,
        ),
        ("turned.x", turned.x),
        ("turned.y", turned.y),
    ]
}

/// The same unknowns put into the formulas as Taylor series: nothing of the closure takes part, so its condition does
/// not either.
#[test]
fn outputs_by_series() {
    let parameters = [90.0, 30.0, 60.0, 45.0, 25.0, 15.0];
    let linkage = FourBarOutputs::<f64>::from_parameters(parameters);
    let mut random = Random::new(52);
    let mut count = 0;
    for step in 0..190 {
        let theta2 = Motion::new(random.motion(-1.9 + 0.02 * f64::from(step)));
        for assembly in Assembly::BOTH {
            let Ok(pose) = linkage.solve(theta2, assembly) else {
                continue;
            };
            let series = |motion: Motion<f64, 5>| Series::<5>::from_derivatives(motion.derivatives());
            let expected = formulas(parameters, series(theta2), series(pose.theta3), series(pose.theta4));
            let w = [theta2, pose.theta3, pose.theta4]
                .into_iter()
                .fold(0.0, |largest: f64, angle| largest.max(frequency(angle, 1.0)));
            let outputs = pose.output_motions();
            assert_eq!(outputs.len(), expected.len());
            for (index, (name, expected)) in expected.into_iter().enumerate() {
                assert_eq!(FourBarOutputs::<f64>::DESCRIPTION.outputs[index].name, name);
                let own = outputs[index];
                let is_length =
                    FourBarOutputs::<f64>::DESCRIPTION.outputs[index].dimension == kin_core::Dimension::Length;
                let size = if is_length { 120.0 } else { own.value().abs().max(1.0) };
                // a quotient changes as fast as its denominator is small, exp(-x²/2) as fast as x is large
                let steepness = match name {
                    "slope" => {
                        let run = theta2.value().cos() + pose.theta3.value().cos();
                        2.0 / run.abs()
                    }
                    "advantage" => 1.0 / (pose.theta3.value() - theta2.value()).sin().abs(),
                    "decay" => 1.0 / (pose.theta3.value() + 2.0).sin().abs() + pose.theta3.value().abs(),
                    _ => 1.0,
                };
                let steepness = steepness.max(1.0);
                assert_agree(name, own, expected.derivatives(), size, w * steepness, steepness);
            }
            count += 1;
        }
    }
    assert!(count > 200, "{count}");
}

/// Points are vectors with their derivatives, and have coordinates with theirs.
#[test]
fn points_have_coordinates() {
    let parameters = [90.0, 30.0, 60.0, 45.0, 25.0, 15.0];
    let linkage = FourBarOutputs::<f64>::from_parameters(parameters);
    let theta2 = Motion::from((1.0, -10.0, 2.0, -0.5, 0.3));
    let pose = linkage.solve(theta2, Assembly::Open).expect("it closes");
    let outputs = pose.output_motions();
    assert_eq!(pose.coupler_point.x(), outputs[0]);
    assert_eq!(pose.coupler_point.y(), outputs[1]);
    assert_eq!(
        pose.coupler_point.jerk(),
        Plane::new(outputs[0].jerk(), outputs[1].jerk())
    );
    assert_eq!(pose.transmission, outputs[4]);
    // each step carries them as far as it goes
    let velocity = linkage
        .position(1.0, Assembly::Open)
        .expect("it closes")
        .velocity(-10.0);
    assert_eq!(velocity.coupler_point, pose.coupler_point.truncate::<2>());
    assert_eq!(velocity.decay, pose.decay.truncate::<2>());
}

/// A hand that two cranks carry: its position is on both rods.
#[test]
fn a_point_of_two_inputs() {
    let linkage = FiveBar::<f64>::from_parameters([2.0, 1.0, 2.0, 1.8, 1.1]);
    for step in 0..24 {
        let (alpha, beta) = (0.4 + 0.1 * f64::from(step), TAU / 8.0);
        let Ok(pose) = linkage.position(alpha, beta, Assembly::Open) else {
            continue;
        };
        let hand = pose.hand.value();
        let pins = [
            (f64::cos(alpha), f64::sin(alpha), 2.0),
            (2.0 + 1.1 * f64::cos(beta), 1.1 * f64::sin(beta), 1.8),
        ];
        for (x, y, rod) in pins {
            assert!(((hand.x - x).hypot(hand.y - y) - rod).abs() < 1e-14);
        }
    }
}

/// An output that is not defined is an error, not a NaN.
#[test]
fn outside_of_a_domain() {
    let mechanism = OutputOutsideDomain::<f64>::from_parameters([1.5]);
    let pose = mechanism
        .solve(Motion::at_constant_speed(3.0, 1.0))
        .expect("the root is defined");
    assert!((pose.root.value() - 1.5).abs() < 1e-15);
    let error = mechanism.position(1.0).expect_err("a root of a negative number");
    assert_eq!(
        error.failure,
        Failure::OutsideDomain {
            function: "sqrt",
            argument: -0.75
        }
    );
    let closure = ClosureOutsideDomain::<f64>::from_parameters([1.5]);
    let error = closure
        .position(-2.0)
        .expect_err("a root and a logarithm of negative numbers");
    assert!(
        matches!(error.failure, Failure::OutsideDomain { function: "sqrt" | "ln", argument } if argument < 0.0),
        "{error}"
    );
    let error = closure.position(0.0).expect_err("the logarithm of zero");
    assert!(
        matches!(error.failure, Failure::OutsideDomain { function: "ln", .. }),
        "{error}"
    );
}

/// An output that a formula uses has the value that is returned, with all rates.
#[test]
fn formulas_use_outputs() {
    let press = OutputsInFormulas::<f64>::from_parameters([30.0, 80.0, 50.0, 160.0, 70.0]);
    for step in -30..=30 {
        let theta = Motion::from((0.1 * f64::from(step), 2.0, -1.0, 3.0, 0.5));
        for assembly in OutputsInFormulas::<f64>::ASSEMBLIES {
            let pose = press.solve(theta, assembly).expect("it closes");
            for order in 0..=4 {
                let [bend, twice, phi, psi] = [pose.bend, pose.twice, pose.phi, pose.psi].map(|one| one[order]);
                assert!(bend == psi - phi && twice == 2.0 * bend, "{theta:?}, {assembly:?}");
            }
            let (pin, knee, middle) = (pose.pin.position(), pose.knee.position(), pose.middle.position());
            let middles = (middle - (pin + knee) / 2.0).norm();
            let links = (Plane::new(70.0, pose.lift.position()) - knee).norm() - 160.0;
            assert!(middles < 1e-13 && links.abs() < 1e-12, "{middles} and {links}");
        }
    }
}
