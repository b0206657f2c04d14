//! The partial derivatives by the parameters, of every closed form and in every assembly, held against both oracles.
//!
//! The worst errors per order and the costs are printed: `cargo test -p kin-tests --test proof sensitivities --
//! --nocapture`.

use kin_core::count::{self, Counted};
use kin_core::prelude::*;
use kin_core::verify::allowed;
use kin_core::{Dimension, Operations};
use kin_tests::mechanisms::cases::Case;
use kin_tests::mechanisms::coupled::{
    Built, GearedPair, Kepler, SixCoupled, SixInChain, SixInChainPartials, StephensonThree, Triad,
};
use kin_tests::mechanisms::multi_loop::{GearedYoke, Whitworth};
use kin_tests::mechanisms::sensitive::{
    self, SensitiveFourBar, SensitiveGeometric, SensitiveOutputs, SensitiveSlider, SensitiveThroughSnap, SensitiveWatt,
    Visitor,
};
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;
use kin_tests::samples;
use kin_tests::sensitivities::{Worst, at_run_time, generated};

/// A grid of inputs with random rates; dimensions vary.
fn grid<M: SensitiveThroughSnap>(case: Case, mut look: impl FnMut(&M, M::Inputs<Motion<f64, 5>>, M::Assembly)) {
    let mut random = Random::new(M::DESCRIPTION.name.bytes().map(u64::from).sum());
    for _ in 0..samples::of(8) {
        let mechanism: M = case.varied(&mut random);
        for step in 0..16 {
            let fraction = (f64::from(step) + random.between(0.0, 1.0)) / 16.0;
            let inputs = case.inputs::<M>(fraction, &mut random);
            for assembly in M::assemblies() {
                look(&mechanism, inputs, assembly);
            }
        }
    }
}

#[test]
fn both_oracles() {
    struct Prove;
    impl Visitor for Prove {
        fn visit<M: SensitiveThroughSnap>(&mut self, case: Case) {
            let mut worst = Worst::default();
            grid(case, |mechanism: &M, inputs, assembly| {
                worst.check(mechanism, inputs, assembly, |pose| generated(mechanism, pose));
            });
            worst.report(M::DESCRIPTION.name);
        }
    }
    sensitive::all(&mut Prove);
}

/// Without a request, at run time, to the same tolerance.
#[test]
fn both_oracles_of_those_at_run_time() {
    struct Prove;
    impl Visitor for Prove {
        fn visit<M: SensitiveThroughSnap>(&mut self, case: Case) {
            let mut worst = Worst::default();
            grid(case, |mechanism: &M, inputs, assembly| {
                worst.check(mechanism, inputs, assembly, |_| {
                    at_run_time(mechanism, &inputs, assembly)
                });
            });
            worst.report(M::DESCRIPTION.name);
        }
    }
    sensitive::all(&mut Prove);
}

/// Two hundred mechanisms with coupled blocks, each at the position that it was built around.
fn coupled<M, const UNKNOWNS: usize>(built: impl Fn(&mut Random) -> Built<M, UNKNOWNS>)
where
    M: SensitiveThroughSnap + Mechanism<Assembly = Near<UNKNOWNS>>,
{
    let mut random = Random::new(M::DESCRIPTION.name.bytes().map(u64::from).sum());
    let (mut worst, mut worst_at_run_time) = (Worst::default(), Worst::default());
    for _ in 0..samples::of(200) {
        let Built {
            mechanism,
            input,
            unknowns,
        } = built(&mut random);
        let inputs = M::Inputs::from_fn(|_| Motion::new(random.motion(input)));
        worst.check(&mechanism, inputs, Near(unknowns), |pose| generated(&mechanism, pose));
        worst_at_run_time.check(&mechanism, inputs, Near(unknowns), |_| {
            at_run_time(&mechanism, &inputs, Near(unknowns))
        });
    }
    worst.report(M::DESCRIPTION.name);
    worst_at_run_time.report(M::DESCRIPTION.name);
}

/// Of one unknown; reduced to two by turns, or by what stands alone; of six, by the factors that the position leaves.
#[test]
fn both_oracles_of_coupled_blocks() {
    coupled(Kepler::built);
    coupled(Triad::built);
    coupled(StephensonThree::built);
    coupled(GearedPair::built);
    coupled(SixCoupled::built);
    coupled(SixInChain::built);
}

/// The blocks before and after a block of six have no part in it, and its factors do not change that.
#[test]
fn what_does_not_depend_has_none_beside_factors() {
    let Built {
        mechanism,
        input,
        unknowns,
    } = SixInChain::built(&mut Random::new(1));
    let drive = Motion::from((input, -10.0, 2.0, -0.5, 0.3));
    let pose = mechanism.solve_near(drive, unknowns).expect("it was built there");
    let by = mechanism.sensitivities(&pose);
    let still = Motion::new([0.0; 5]);
    let of_six = |by: &SixInChainPartials| [by.a, by.b, by.c, by.d, by.e, by.f];
    assert_eq!(of_six(&by.throw), [still; 6]);
    assert_eq!(by.throw.middle, Motion::new([Plane::new(0.0, 0.0); 5]));
    assert_eq!(by.side.theta, still);
    assert_eq!(by.ratio.theta, drive);
    assert!(of_six(&by.ratio).iter().all(|motion| motion.snap() != 0.0));
    assert!(by.leg.yoke.snap() != 0.0);
}

/// A mechanism of which everything is scaled moves as before, with its lengths scaled: by Euler's theorem on
/// homogeneous functions Σ p ∂q/∂p over its lengths is q for a length and 0 for an angle or a number, at every order.
#[test]
fn scaling_all_lengths_scales_the_motion() {
    struct Prove(usize);
    impl Visitor for Prove {
        fn visit<M: SensitiveThroughSnap>(&mut self, case: Case) {
            let is_length = |dimension| dimension == Dimension::Length;
            if M::DESCRIPTION.inputs.iter().any(|input| is_length(input.dimension)) {
                return;
            }
            grid(case, |mechanism: &M, inputs, assembly| {
                let Ok(pose) = mechanism.solve(inputs, assembly) else {
                    return;
                };
                let unknowns = pose.unknown_motions();
                let gauge = Gauge::new(mechanism, &inputs, &unknowns);
                let columns = generated(mechanism, &pose);
                for (unknown, motion) in unknowns.as_ref().iter().enumerate() {
                    for (order, terms) in ALLOWED.into_iter().enumerate() {
                        let (mut sum, mut largest) = (0.0, 1.0_f64);
                        for (parameter, column) in columns.iter().enumerate() {
                            if is_length(M::DESCRIPTION.parameters[parameter].dimension) {
                                let term = mechanism.parameters()[parameter] * column.unknowns[unknown][order];
                                sum += term;
                            }
                            for (k, own) in column.unknowns[unknown][..=order].iter().enumerate() {
                                let power = i32::try_from(k).expect("orders are small");
                                let size = gauge.sizes[unknown] * gauge.frequency.max(1.0).powi(power);
                                let relative = mechanism.parameters()[parameter] * own / size;
                                largest = largest.max(relative.abs());
                            }
                        }
                        let expected = if is_length(M::DESCRIPTION.unknowns[unknown].dimension) {
                            motion.derivatives()[order]
                        } else {
                            0.0
                        };
                        let allowed = terms * gauge.unknown(unknown, order) * largest;
                        assert!(
                            (sum - expected).abs() <= allowed,
                            "{}, unknown {unknown}, order {order}: {sum} instead of {expected}, {allowed} allowed",
                            M::DESCRIPTION.name
                        );
                        self.0 += 1;
                    }
                }
            });
        }
    }
    let mut prove = Prove(0);
    sensitive::all(&mut prove);
    assert!(prove.0 > 10_000, "{}", prove.0);
}

/// A quantity that does not depend on a parameter has the derivative zero exactly; the parameter itself has one.
#[test]
fn what_does_not_depend_has_none() {
    let linkage = SensitiveOutputs::<f64>::from_parameters([90.0, 30.0, 60.0, 45.0, 25.0, 15.0]);
    let crank = Motion::from((1.0, -10.0, 2.0, -0.5, 0.3));
    for assembly in Assembly::BOTH {
        let pose = linkage.solve(crank, assembly).expect("it closes");
        let by = linkage.sensitivities(&pose);
        let still = Motion::new([0.0; 5]);
        assert_eq!(by.r1.longest, Motion::new([1.0, 0.0, 0.0, 0.0, 0.0]));
        assert_eq!(by.r2.longest, still);
        assert_eq!((by.r1.still, by.trace.x.still), (still, still));
        assert_eq!((by.trace.x.theta3, by.trace.y.theta4), (still, still));
        assert_eq!((by.r3.diagonal, by.r4.diagonal), (still, still));
        // a point of the coupler moves along the coupler's axes as its own coordinates change
        let (sine, cosine) = Number::sin_cos(pose.theta3.value());
        let rounding = 4.0 * f64::EPSILON;
        assert!((by.trace.x.coupler_point.value().x - cosine).abs() < rounding);
        assert!((by.trace.y.coupler_point.value().x + sine).abs() < rounding);
    }
    // the second loop does not act back on the first
    let six_bar = SensitiveWatt::<f64>::from_parameters([4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5]);
    let assembly = SensitiveWatt::<f64>::ASSEMBLIES[0];
    let pose = six_bar.solve(crank, assembly).expect("it closes");
    let by = six_bar.sensitivities(&pose);
    assert_eq!(by.r6.theta4, Motion::new([0.0; 5]));
    assert_eq!(by.pivot.y.theta3, Motion::new([0.0; 5]));
    assert!(by.r3.theta6.snap() != 0.0);
}

/// The rows of the trait are the fields of the structure.
#[test]
fn rows_are_fields() {
    let linkage = SensitiveOutputs::<f64>::from_parameters([90.0, 30.0, 60.0, 45.0, 25.0, 15.0]);
    let pose = linkage
        .solve(Motion::from((1.0, -10.0, 2.0, -0.5, 0.3)), Assembly::Open)
        .expect("it closes");
    let by = linkage.sensitivities(&pose);
    let rows = linkage.sensitivities_of(&pose);
    assert_eq!(rows, [by.r1, by.r2, by.r3, by.r4, by.trace.x, by.trace.y]);
    assert_eq!(by.r3.unknown_partials(), [by.r3.theta3, by.r3.theta4]);
    let outputs = by.r3.output_partials();
    assert_eq!(outputs[0], by.r3.coupler_point.x());
    assert_eq!(outputs[1], by.r3.coupler_point.y());
    assert_eq!(outputs[2], by.r3.transmission);
}

/// On dual numbers the sensitivities have derivatives of their own: second derivatives by two parameters, which do not
/// depend on the order of the two.
#[test]
fn second_derivatives_are_symmetric() {
    use num_dual::Dual64;
    let parameters = [90.0, 30.0, 60.0, 45.0];
    let crank = [1.0, -10.0, 2.0, -0.5, 0.3].map(<Dual64 as Number>::constant);
    for assembly in Assembly::BOTH {
        let second: Vec<Vec<[f64; 5]>> = (0..4)
            .map(|seeded| {
                let number = |index: usize| Dual64::new(parameters[index], if index == seeded { 1.0 } else { 0.0 });
                let linkage = SensitiveFourBar::from_parameters(core::array::from_fn(number));
                let pose = linkage.solve(Motion::new(crank), assembly).expect("it closes");
                linkage
                    .sensitivities_of(&pose)
                    .iter()
                    .map(|by| by.theta4.derivatives().map(|derivative| derivative.eps))
                    .collect()
            })
            .collect();
        let largest = |order: usize| second.iter().flatten().map(|by| by[order].abs()).fold(0.0, f64::max);
        for (a, row) in second.iter().enumerate() {
            for (b, by) in row.iter().enumerate() {
                for (order, own) in by.iter().enumerate() {
                    // the Jacobian's condition is about 2 here
                    let allowed = 8.0 * ALLOWED[order] * f64::EPSILON * largest(order);
                    let other = second[b][a][order];
                    assert!((own - other).abs() <= allowed, "order {order}: {own} and {other}");
                }
            }
        }
    }
}

mechanism! {
    /// Names that generated code might like for itself, and a root of a parameter alone.
    struct Named {
        pose: Length,
        found: Length,
        inverse_determinant: Length,
        entry_1_x_velocity: Angle,
        x_position_by_pose: Length,
    }
    input near: Length;
    unknown x: Length, theta3: Angle;
    x + pose == near * cos(entry_1_x_velocity) + x_position_by_pose;
    found * sin(theta3) == x;
    output assembly: Length = sqrt(inverse_determinant * pose);
    output t: Length = x - pose;
    with sensitivities;
}

#[test]
fn any_name_goes() {
    let named: Named = Named {
        pose: 2.0,
        found: 3.0,
        inverse_determinant: 8.0,
        entry_1_x_velocity: 0.0,
        x_position_by_pose: 0.5,
    };
    let near = Motion::at_constant_speed(1.5, 1.0);
    let pose = named.solve(near, Assembly::Open).expect("it closes");
    let by = named.sensitivities(&pose);
    assert_eq!(by.pose.x.value(), -1.0);
    assert_eq!(by.pose.t.value(), -2.0);
    assert_eq!(by.inverse_determinant.assembly.value(), 0.25);
    // x is zero here, and theta3 a multiple of a half turn: theta3' = x' / (found cos theta3)
    assert_eq!(by.found.theta3.value(), 0.0);
    let rate = pose.theta3.velocity();
    assert!((by.found.theta3.velocity() + rate / 3.0).abs() <= 4.0 * f64::EPSILON * rate.abs());
}

/// A root of a parameter alone has no derivative where it vanishes: such a position is refused, so that no
/// sensitivity is infinite.
#[test]
fn where_a_function_of_parameters_has_no_derivative() {
    let named: Named = Named {
        pose: 2.0,
        found: 3.0,
        inverse_determinant: 0.0,
        entry_1_x_velocity: 0.0,
        x_position_by_pose: 0.5,
    };
    let error = named.position(1.5, Assembly::Open).expect_err("no derivative");
    assert!(matches!(error.failure, Failure::Singular { .. }), "{error}");
}

/// Declared costs are what is carried out, and all partial derivatives together cost less than a solution for each
/// parameter.
fn cost<M: Sensitive<Scalar = Counted>>(parameters: &[f64], angle: f64) {
    let name = M::DESCRIPTION.name;
    let mechanism = M::from_parameters(M::Parameters::from_fn(|index| Counted::new(parameters[index])));
    let inputs = M::Inputs::from_fn(|_| M::Motion::from_fn(|order| Counted::new([angle, 1.0, 2.0, 3.0, 4.0][order])));
    let poses: Vec<M::Pose> = M::assemblies()
        .filter_map(|assembly| mechanism.solve(inputs, assembly).ok())
        .collect();
    assert!(!poses.is_empty(), "{name} does not close");
    cost_at(&mechanism, &poses);
}

fn cost_at<M: Sensitive<Scalar = Counted>>(mechanism: &M, poses: &[M::Pose]) {
    let name = M::DESCRIPTION.name;
    for pose in poses {
        let measured = count::of(|| {
            mechanism.sensitivities_of(pose);
        });
        assert_eq!(measured, M::SENSITIVITY_OPERATIONS, "{name}");
    }
    let parameters = M::DESCRIPTION.parameters.len();
    let solution = M::DESCRIPTION
        .operations
        .iter()
        .fold(Operations::NONE, |sum, order| sum.plus(*order));
    // a function is taken for twenty operations, as the macro does
    let total = |cost: Operations| {
        cost.arithmetic() + 20 * (cost.square_roots + cost.sine_cosines + cost.arc_tangents + cost.others)
    };
    let (own, one) = (total(M::SENSITIVITY_OPERATIONS), total(solution));
    println!("{name:22} solution {one:4} operations, sensitivities {own:4} by {parameters:2} parameters");
    assert!(own < one * parameters, "{name}");
}

#[test]
fn costs() {
    cost::<SensitiveFourBar<Counted>>(&[5.0, 2.0, 4.0, 3.5], 1.1);
    cost::<SensitiveOutputs<Counted>>(&[5.0, 2.0, 4.0, 3.5, 1.0, 0.5], 1.1);
    cost::<SensitiveGeometric<Counted>>(&[5.0, 2.0, 4.0, 3.5], 1.1);
    cost::<SensitiveSlider<Counted>>(&[1.0, 3.0, 0.4, 0.7], 1.1);
    cost::<Whitworth<Counted>>(&[0.5, 1.2, 1.5, 5.0, 0.3], 1.1);
    cost::<GearedYoke<Counted>>(&[4.0, 1.0, 3.0, 2.5, 2.5, 0.7], 1.1);
    cost::<SensitiveWatt<Counted>>(&[4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5], 1.1);
    let Built {
        mechanism,
        input,
        unknowns,
    } = SixInChain::built(&mut Random::new(1));
    let counted = mechanism.convert(Counted::new);
    let drive = Motion::new([input, 1.0, 2.0, 3.0, 4.0].map(Counted::new));
    let pose = counted
        .solve_near(drive, unknowns.map(Counted::new))
        .expect("it was built there");
    cost_at(&counted, &[pose]);
}

mechanism! {
    /// A four-bar linkage through the sixth derivative, with two requests.
    struct SensitiveThroughPop {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    order = 6;
    with transmission_angles, sensitivities;
}

/// The sensitivities go to the order of the declaration.
#[test]
fn of_any_order() {
    use num_dual::Dual64;
    let parameters = [90.0, 30.0, 60.0, 45.0];
    let crank = [1.0, -1.0, 2.0, -0.5, 0.3, -0.7, 1.1];
    for assembly in Assembly::BOTH {
        let linkage = SensitiveThroughPop::from_parameters(parameters);
        let pose = linkage.solve(Motion::new(crank), assembly).expect("it closes");
        for (parameter, by) in linkage.sensitivities_of(&pose).iter().enumerate() {
            let number = |index: usize| Dual64::new(parameters[index], if index == parameter { 1.0 } else { 0.0 });
            let lifted = SensitiveThroughPop::from_parameters(core::array::from_fn(number));
            let pose = lifted
                .solve(Motion::new(crank.map(<Dual64 as Number>::constant)), assembly)
                .expect("it closes");
            for (own, other) in by.unknown_partials().iter().zip(pose.unknown_motions()) {
                let (own, other) = (own.derivatives(), other.derivatives());
                let largest = other.iter().map(|number| number.eps.abs()).fold(0.0, f64::max);
                for (order, (own, other)) in own.iter().zip(other).enumerate() {
                    // the Jacobian's condition is about 2 here
                    let allowed = 8.0 * allowed(order) * f64::EPSILON * largest;
                    assert!(
                        (own - other.eps).abs() <= allowed,
                        "order {order}: {own} and {}",
                        other.eps
                    );
                }
            }
        }
    }
}
