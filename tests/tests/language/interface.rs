//! The items that a declaration becomes: the steps and their signatures, assemblies, metadata, number types, errors.
#![allow(clippy::type_complexity, clippy::items_after_statements)]

use core::error::Error;

use kin_core::library::{
    FourBar, FourBarAcceleration, FourBarJerk, FourBarPosition, FourBarSnap, FourBarVelocity, GeometricFourBar,
    InvertedSliderCrank, SliderCrank,
};
use kin_core::prelude::*;
use kin_core::series::Series;
use kin_core::{Dimension, InputValues};
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{self, Case, Visitor};
use kin_tests::mechanisms::dyads::{FiveBar, FiveBarPosition, FiveBarVelocity, TwoLinkArm, TwoSlides};
use kin_tests::mechanisms::inverted_slider_crank_typings::{InvertedLoop, InvertedOffset};
use kin_tests::mechanisms::multi_loop::{
    FourBarsInSeries, FourBarsInSeriesAssembly, StephensonSixBar, ToggleOnCoupler, WattSixBar, Whitworth,
};
use kin_tests::mechanisms::outputs::FourBarOutputs;
use kin_tests::mechanisms::ranged::RangedCoupler;
use kin_tests::mechanisms::scalar_forms::{
    CircularForm, CosineForm, DistanceForm, ExplicitFunctions, LinearForm, LogarithmForm, QuadraticForm, SineForm,
    SquareForm, TangentForm,
};
use kin_tests::mechanisms::slider_crank_typings::{
    SliderCrankDrivenAtSlider, SliderCrankInclined, SliderCrankLoop, SliderCrankUpright,
};
use kin_tests::random::Random;
use num_dual::Dual64;

const SAMPLE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};
const MOTION: [f64; 5] = [0.6, -10.0, 2.0, -0.5, 0.3];

/// Each step takes the derivative of the inputs that its order adds, and nothing else.
#[test]
fn signatures() {
    let _: fn(&FourBar, f64, Assembly) -> Result<FourBarPosition, SolveError> = FourBar::position;
    let _: fn(&FourBarPosition, f64) -> FourBarVelocity = FourBarPosition::velocity;
    let _: fn(&FourBarVelocity, f64) -> FourBarAcceleration = FourBarVelocity::acceleration;
    let _: fn(&FourBarAcceleration, f64) -> FourBarJerk = FourBarAcceleration::jerk;
    let _: fn(&FourBarJerk, f64) -> FourBarSnap = FourBarJerk::snap;
    let _: fn(&FourBar, Motion<f64, 5>, Assembly) -> Result<FourBarSnap, SolveError> = FourBar::solve;
    let _: fn(&FourBar, f64, [f64; 2]) -> Result<FourBarPosition, SolveError> = FourBar::position_near;
    let _: fn(&FourBar, Motion<f64, 5>, [f64; 2]) -> Result<FourBarSnap, SolveError> = FourBar::solve_near;
    let _: fn(&FourBar, f64, [f64; 2]) -> Assembly = FourBar::assembly_at;
    // one argument for each input; no assembly where there is none to choose
    let _: fn(&FiveBar, f64, f64, Assembly) -> Result<FiveBarPosition, SolveError> = FiveBar::position;
    let _: fn(&FiveBarPosition, f64, f64) -> FiveBarVelocity = FiveBarPosition::velocity;
    let explicit = InvertedSliderCrank { r1: 2.0, r2: 1.0 };
    assert!(explicit.position(0.3).is_ok() && explicit.solve(Motion::new(MOTION)).is_ok());
    // the number type is a parameter everywhere
    let _: fn(&FourBarPosition<f32>, f32) -> FourBarVelocity<f32> = FourBarPosition::velocity;
}

/// The chain of the steps is the one call, bit for bit.
macro_rules! assert_chain_is_solve {
    ($($mechanism:ident $parameters:tt ($($input:expr),+) $(in $assembly:expr)?;)+) => {
        $({
            let mechanism = $mechanism::<f64>::from_parameters($parameters);
            let whole = mechanism.solve($(Motion::new($input),)+ $($assembly)?).expect("it closes");
            let steps = mechanism
                .position($($input[0],)+ $($assembly)?)
                .expect("it closes")
                .velocity($($input[1]),+)
                .acceleration($($input[2]),+)
                .jerk($($input[3]),+)
                .snap($($input[4]),+);
            assert_eq!(whole, steps, stringify!($mechanism));
            // what a step has found, later ones do not change
            let position = mechanism.position($($input[0],)+ $($assembly)?).expect("it closes");
            assert_eq!(position.unknowns(), whole.unknowns(), stringify!($mechanism));
            let velocity = position.velocity($($input[1]),+);
            assert_eq!(velocity.unknowns(), whole.unknowns(), stringify!($mechanism));
        })+
    };
}

#[test]
fn the_chain_is_the_whole() {
    const OTHER: [f64; 5] = [1.1, 0.4, -3.0, 5.0, 7.0];
    for assembly in Assembly::BOTH {
        assert_chain_is_solve! {
            FourBar [90.0, 30.0, 60.0, 45.0] (MOTION) in assembly;
            FourBarOutputs [90.0, 30.0, 60.0, 45.0, 25.0, 15.0] (MOTION) in assembly;
            SliderCrank [1.0, 3.0] (MOTION) in assembly;
            SliderCrankInclined [1.0, 3.0, 0.4, 0.7] (MOTION) in assembly;
            InvertedOffset [2.0, 0.8, 0.5] (MOTION) in assembly;
            TwoLinkArm [1.2, 0.9] (MOTION, OTHER) in assembly;
            FiveBar [2.0, 1.0, 2.0, 1.8, 1.1] (MOTION, OTHER) in assembly;
            Whitworth [0.5, 1.2, 1.5, 5.0, 0.3] (MOTION) in assembly;
            CircularForm [1.2, 0.8] (MOTION) in assembly;
            QuadraticForm [1.5, 2.0, 0.5] (MOTION) in assembly;
        }
    }
    for assembly in WattSixBar::ASSEMBLIES {
        assert_chain_is_solve! {
            WattSixBar [4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5] (MOTION) in assembly;
        }
    }
    assert_chain_is_solve! {
        InvertedSliderCrank [2.0, 0.8] (MOTION);
        TwoSlides [1.3, 0.4, 2.2] (MOTION);
        RangedCoupler [90.0, 30.0, 60.0, 45.0] (MOTION);
        ExplicitFunctions [3.0, 1.0] (MOTION);
        LinearForm [0.7, 1.3] (MOTION);
    }
}

/// The trait's ways give what the inherent ones give, and every row is as long as the description says.
#[test]
fn the_trait_is_the_inherent_interface() {
    let inherent = SAMPLE.solve(Motion::new(MOTION), Assembly::Crossed).expect("it closes");
    let by_trait = Mechanism::solve(&SAMPLE, [Motion::new(MOTION)], Assembly::Crossed).expect("it closes");
    assert_eq!(inherent, by_trait);
    assert_eq!(by_trait.unknown_motions(), [inherent.theta3, inherent.theta4]);
    let position = SAMPLE.position(0.6, Assembly::Crossed).expect("it closes");
    assert_eq!(
        Mechanism::position(&SAMPLE, [0.6], Assembly::Crossed),
        Ok(position.unknowns())
    );
    let residuals = SAMPLE.closure(0.6, [0.2, 0.3]);
    assert_eq!(Mechanism::closure(&SAMPLE, [0.6], [0.2, 0.3]), residuals);
    assert_eq!(SAMPLE.parameters(), [90.0, 30.0, 60.0, 45.0]);
    assert_eq!(FourBar::from_parameters([90.0, 30.0, 60.0, 45.0]), SAMPLE);

    struct Check;
    impl Visitor for Check {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            let description = M::DESCRIPTION;
            let name = description.name;
            assert_eq!(
                description.parameters.len(),
                <M::Parameters<f64> as Row<f64>>::LENGTH,
                "{name}"
            );
            assert_eq!(description.inputs.len(), <M::Inputs<f64> as Row<f64>>::LENGTH, "{name}");
            assert_eq!(
                description.unknowns.len(),
                <M::Unknowns<f64> as Row<f64>>::LENGTH,
                "{name}"
            );
            assert_eq!(
                description.unknowns.len(),
                <M::Residuals<f64> as Row<f64>>::LENGTH,
                "{name}"
            );
            assert_eq!(
                description.outputs.len(),
                <<M::Pose as Pose>::Outputs<f64> as Row<f64>>::LENGTH,
                "{name}"
            );
            assert_eq!((description.order, description.operations.len()), (4, 5), "{name}");
            assert!(
                !description.equations.is_empty() && !description.blocks.is_empty(),
                "{name}"
            );
            // every unknown is in one block
            let mut listed: Vec<&str> = description
                .blocks
                .iter()
                .flat_map(|block| block.unknowns.split(", "))
                .collect();
            let mut declared: Vec<&str> = description.unknowns.iter().map(|unknown| unknown.name).collect();
            listed.sort_unstable();
            declared.sort_unstable();
            assert_eq!(listed, declared, "{name}");

            let mechanism: M = case.mechanism();
            assert_eq!(mechanism.parameters().as_ref(), case.parameters, "{name}");
            assert_eq!(
                mechanism.convert(|value| 2.0 * value).parameters()[0],
                2.0 * case.parameters[0]
            );
            assert_eq!(M::assemblies().count(), M::ASSEMBLY_COUNT);
            for (first, one) in M::assemblies().enumerate() {
                assert!(M::assemblies().skip(first + 1).all(|other| one != other), "{name}");
                assert_eq!(M::assembly(first), Some(one), "{name}");
            }
            assert_eq!(M::assembly(M::ASSEMBLY_COUNT), None, "{name}");
            // where the unknowns are those of a solution, nothing is left of the equations
            let inputs = case.inputs::<M>(0.6, &mut Random::new(61));
            for assembly in M::assemblies() {
                let values = M::Inputs::from_fn(|index| inputs[index].value());
                if let (Ok(unknowns), Ok(pose)) =
                    (mechanism.position(values, assembly), mechanism.solve(inputs, assembly))
                {
                    let positions: Vec<f64> = pose.unknown_motions().as_ref().iter().map(Motion::value).collect();
                    assert_eq!(unknowns.as_ref(), positions, "{name}");
                    assert_eq!(mechanism.assembly_at(values, unknowns), assembly, "{name}");
                    let near = mechanism.position_near(values, unknowns).expect("it closes");
                    assert_eq!(near.as_ref(), positions, "{name}");
                    let near = mechanism.solve_near(inputs, unknowns).expect("it closes");
                    assert_eq!(
                        near.unknown_motions().as_ref(),
                        pose.unknown_motions().as_ref(),
                        "{name}"
                    );
                }
            }
        }
    }
    cases::all(&mut Check);
}

#[test]
fn descriptions() {
    let description = <FourBar>::DESCRIPTION;
    assert_eq!((description.name, description.order), ("FourBar", 4));
    let names: Vec<&str> = description.parameters.iter().map(|quantity| quantity.name).collect();
    assert_eq!(names, ["r1", "r2", "r3", "r4"]);
    assert!(
        description
            .parameters
            .iter()
            .all(|quantity| quantity.dimension == Dimension::Length)
    );
    assert_eq!(
        description.parameters[0].description,
        "Ground link, from the crank's pivot to the rocker's."
    );
    assert_eq!(
        (description.inputs[0].name, description.inputs[0].dimension),
        ("theta2", Dimension::Angle)
    );
    assert_eq!(description.unknowns[1].name, "theta4");
    assert_eq!(description.outputs.len(), 0);
    assert_eq!(
        description.equations,
        ["r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4)"]
    );
    assert_eq!(description.blocks.len(), 1);
    assert_eq!(description.blocks[0].unknowns, "theta3, theta4");
    assert_eq!(description.operations, FourBar::OPERATIONS);

    // a vector is two scalars, named by its parts
    let outputs = <FourBarOutputs>::DESCRIPTION.outputs;
    assert_eq!(
        (outputs[0].name, outputs[1].name),
        ("coupler_point.x", "coupler_point.y")
    );
    assert_eq!(outputs[0].dimension, Dimension::Length);
    assert_eq!(
        (outputs[4].name, outputs[4].dimension),
        ("transmission", Dimension::Angle)
    );
    assert_eq!((outputs[7].name, outputs[7].dimension), ("slope", Dimension::Scalar));
    let parameters = <FourBarOutputs>::DESCRIPTION.parameters;
    assert_eq!((parameters[4].name, parameters[5].name), ("trace.x", "trace.y"));
    assert_eq!(parameters[4].description, "A point of the coupler, in its frame.");
}

#[test]
fn assemblies() {
    assert_eq!(FourBar::ASSEMBLIES, [Assembly::Open, Assembly::Crossed]);
    assert_eq!(InvertedSliderCrank::ASSEMBLIES, [()]);
    assert_eq!(
        (GeometricFourBar::ASSEMBLIES.len(), <GeometricFourBar>::ASSEMBLY_COUNT),
        (8, 8)
    );
    // a field for each block with a choice, named after its unknowns
    let [first, second, third, fourth] = FourBarsInSeries::ASSEMBLIES;
    let of = |theta3_theta4, phi3_phi4| FourBarsInSeriesAssembly {
        theta3_theta4,
        phi3_phi4,
    };
    assert_eq!(first, of(Assembly::Open, Assembly::Open));
    assert_eq!(second, of(Assembly::Open, Assembly::Crossed));
    assert_eq!(third, of(Assembly::Crossed, Assembly::Open));
    assert_eq!(fourth, of(Assembly::Crossed, Assembly::Crossed));
    for (listed, by_trait) in FourBarsInSeries::ASSEMBLIES
        .into_iter()
        .zip(<FourBarsInSeries>::assemblies())
    {
        assert_eq!(listed, by_trait);
    }
}

/// A solution is recognised for what it is: its assembly is told from its unknowns, and it is found again from them.
macro_rules! assert_found_again {
    ($($mechanism:ident $parameters:tt ($($input:expr),+);)+) => {
        $({
            let mechanism = $mechanism::<f64>::from_parameters($parameters);
            for assembly in $mechanism::ASSEMBLIES {
                let position = mechanism.position($($input,)+ assembly).expect("it closes");
                let unknowns = position.unknowns();
                assert_eq!(mechanism.assembly_at($($input,)+ unknowns), assembly, stringify!($mechanism));
                let again = mechanism.position_near($($input,)+ unknowns).expect("it closes");
                assert_eq!(again.unknowns(), unknowns, stringify!($mechanism));
                // a little beside it, too
                let beside = unknowns.map(|value| value + 1e-3 * (1.0 + value.abs()));
                let again = mechanism.position_near($($input,)+ beside).expect("it closes");
                assert_eq!(again.unknowns(), unknowns, stringify!($mechanism));
            }
        })+
    };
}

#[test]
fn solutions_are_found_again() {
    assert_found_again! {
        FourBar [90.0, 30.0, 60.0, 45.0] (1.0);
        GeometricFourBar [90.0, 30.0, 60.0, 45.0] (1.0);
        SliderCrank [1.0, 3.0] (1.0);
        SliderCrankLoop [1.0, 3.0, 0.4] (1.0);
        SliderCrankInclined [1.0, 3.0, 0.4, 0.7] (1.0);
        SliderCrankUpright [1.0, 3.0, 0.4] (1.0);
        SliderCrankDrivenAtSlider [1.0, 3.0, 0.4] (3.0);
        InvertedLoop [2.0, 0.8] (1.0);
        InvertedOffset [2.0, 0.8, 0.5] (1.0);
        TwoLinkArm [1.2, 0.9] (0.9, 0.7);
        FiveBar [2.0, 1.0, 2.0, 1.8, 1.1] (1.0, 1.2);
        FourBarsInSeries [4.0, 1.0, 3.0, 2.5, 4.0, 4.5, 3.0] (1.0);
        WattSixBar [4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5] (1.0);
        StephensonSixBar [4.0, 1.0, 3.0, 2.5, 1.5, 1.0, 5.0, 3.0, 3.0, 2.5] (1.0);
        Whitworth [0.5, 1.2, 1.5, 5.0, 0.3] (1.0);
        ToggleOnCoupler [4.0, 1.0, 3.0, 2.5, 4.0, 0.4] (1.0);
        QuadraticForm [1.5, 2.0, 0.5] (1.0);
        SquareForm [1.2] (1.0);
        CircularForm [1.2, 0.8] (1.0);
        CosineForm [1.5] (1.0);
        SineForm [1.5] (1.0);
        TangentForm [1.5] (1.0);
        DistanceForm [1.5] (2.0);
        LogarithmForm [0.8] (1.0);
    }
}

/// Near a guess some turns away, the angles are on its turn, and everything else is the same.
#[test]
fn angles_on_the_turn_that_is_asked_for() {
    let turn = core::f64::consts::TAU;
    let plain = SAMPLE.solve(Motion::new(MOTION), Assembly::Open).expect("it closes");
    let [theta3, theta4] = plain.unknowns();
    let own = SAMPLE
        .solve_near(
            Motion::new(MOTION),
            [theta3 + 3.0 * turn + 0.5, theta4 - 2.0 * turn - 0.5],
        )
        .expect("it closes");
    assert_eq!(own.theta3.value(), theta3 + 3.0 * turn);
    assert_eq!(own.theta4.value(), theta4 - 2.0 * turn);
    assert_eq!(own.theta3.derivatives()[1..], plain.theta3.derivatives()[1..]);
    assert_eq!(own.theta4.derivatives()[1..], plain.theta4.derivatives()[1..]);
    // a guess that is no number asks for no turn
    let own = SAMPLE.position_near(0.6, [f64::NAN, 0.3]);
    assert!(own.is_ok_and(|position| position.theta3.value().abs() <= turn));
    // lengths have no turns
    let lever = InvertedLoop::<f64>::from_parameters([2.0, 0.8]);
    let own = lever.position_near(0.6, [100.0, 20.0]).expect("it closes");
    assert_eq!(own.r4, lever.position(0.6, Assembly::Open).expect("it closes").r4);
    assert!((own.theta4.value() - 20.0).abs() <= turn / 2.0);
}

#[test]
fn motions_have_names() {
    let pose = SAMPLE.solve(Motion::new(MOTION), Assembly::Open).expect("it closes");
    let [position, velocity, acceleration, jerk, snap] = pose.theta4.derivatives();
    assert_eq!(pose.theta4.position(), position);
    assert_eq!(pose.theta4.value(), position);
    assert_eq!(pose.theta4.velocity(), velocity);
    assert_eq!(pose.theta4.acceleration(), acceleration);
    assert_eq!(pose.theta4.jerk(), jerk);
    assert_eq!(pose.theta4.snap(), snap);
    assert_eq!(pose.theta4.derivative(3), Some(jerk));
    assert_eq!(pose.theta4.derivative(5), None);
    // the input is passed on
    assert_eq!(pose.theta2.derivatives(), MOTION);
}

/// One function for every number type.
fn rocker<S: Scalar>(theta2: S) -> S {
    let linkage = FourBar {
        r1: S::constant(90.0),
        r2: S::constant(30.0),
        r3: S::constant(60.0),
        r4: S::constant(45.0),
    };
    linkage
        .position(theta2, Assembly::Open)
        .expect("it closes")
        .theta4
        .value()
}

#[test]
fn number_types() {
    let pose = SAMPLE.solve(Motion::new(MOTION), Assembly::Open).expect("it closes");
    assert_eq!(rocker(0.6_f64), pose.theta4.value());
    assert!((f64::from(rocker(0.6_f32)) - pose.theta4.value()).abs() < 16.0 * f64::from(f32::EPSILON));
    let dual = rocker(Dual64::new(0.6, -10.0));
    assert_eq!(dual.re, pose.theta4.value());
    assert!((dual.eps - pose.theta4.velocity()).abs() < 1e-12);
    let series = rocker(Series::<5>::from_derivatives(MOTION)).derivatives();
    for (order, (a, b)) in series.into_iter().zip(pose.theta4.derivatives()).enumerate() {
        assert!(
            (a - b).abs() <= 1e-12 * b.abs().max(1.0),
            "order {order}: {a} against {b}"
        );
    }
    // single precision all the way
    let single = SAMPLE.convert(|value| {
        #[expect(clippy::cast_possible_truncation, reason = "the lengths are small integers")]
        let single = value as f32;
        single
    });
    assert_eq!(single.r3, 60.0_f32);
    let own: FourBarSnap<f32> = single
        .solve(Motion::new([0.6_f32, -10.0, 2.0, -0.5, 0.3]), Assembly::Open)
        .expect("it closes");
    assert!((f64::from(own.theta4.snap()) / pose.theta4.snap() - 1.0).abs() < 1e-4);
}

/// An error says which block, at which inputs, what is the matter and by how much; it is an [`Error`], and small.
#[test]
fn errors() {
    let error = SAMPLE.position(2.0, Assembly::Open).expect_err("out of reach");
    assert_eq!(error.block, "theta3, theta4");
    assert_eq!(
        error.inputs,
        InputValues::new(FourBar::<f64>::DESCRIPTION.inputs, &[2.0])
    );
    // the diagonal is longer than coupler and rocker together
    let diagonal = (90.0_f64.powi(2) + 30.0_f64.powi(2) - 2.0 * 90.0 * 30.0 * 2.0_f64.cos()).sqrt();
    let margin = error.margin().expect("it is a matter of reach");
    assert!((margin - (105.0 - diagonal)).abs() < 1e-12, "{margin}");
    let message = error.to_string();
    assert!(
        message.starts_with("theta3, theta4 cannot be found at theta2 = 2 rad (114.6°): out of reach by "),
        "{message}"
    );
    let boxed: Box<dyn Error + Send + Sync> = error.into();
    assert!(boxed.downcast_ref::<SolveError>().is_some());

    // both inputs are told, and the culprit of two
    let linkage = FiveBar::<f64>::from_parameters([20.0, 1.0, 2.0, 1.8, 1.1]);
    let error = linkage.position(0.3, 0.4, Assembly::Open).expect_err("out of reach");
    assert_eq!(
        error.inputs.iter().collect::<Vec<_>>(),
        [("alpha".into(), 0.3), ("beta".into(), 0.4)]
    );
    let near = FiveBar::<f64>::from_parameters([2.0, 1.0, 2.0, 1.8, 1.1]);
    let error = near.position(0.3, f64::NAN, Assembly::Open).expect_err("not a number");
    assert_eq!(
        error.failure,
        Failure::NotFinite {
            quantity: "beta".into()
        }
    );
    let motions = [Motion::new(MOTION), Motion::new([0.4, 0.0, f64::INFINITY, 0.0, 0.0])];
    let error = near
        .solve(motions[0], motions[1], Assembly::Open)
        .expect_err("infinite");
    assert_eq!(
        error.failure,
        Failure::NotFinite {
            quantity: "beta".into()
        }
    );
    // so it is where a block fails that the culprit does not enter by itself
    let series = FourBarsInSeries::<f64>::from_parameters([4.0, 1.0, 3.0, 2.5, 4.0, f64::NAN, 3.0]);
    let error = series
        .position(1.0, FourBarsInSeries::ASSEMBLIES[0])
        .expect_err("not a number");
    assert_eq!(error.failure, Failure::NotFinite { quantity: "s3".into() });
}

mechanism! {
    /// To the velocity alone.
    struct ThroughVelocity {
        order: Length,
    }
    input theta: Angle;
    unknown height: Length;
    order * sin(theta) == height;
    order = 1;
    output twice: Length = 2 * height;
}

mechanism! {
    /// As far as motions have names for their derivatives.
    struct ThroughTwelve {
        order: Length,
    }
    input theta: Angle;
    unknown height: Length;
    order = 12;
    order == height / sin(theta);
}

/// The chain of solvers is as long as the order that is declared, and `order` is a name like any other.
#[test]
fn the_order_is_declared() {
    let _: fn(&ThroughVelocityPosition, f64) -> ThroughVelocityVelocity = ThroughVelocityPosition::velocity;
    let _: fn(&ThroughVelocity, Motion<f64, 2>) -> Result<ThroughVelocityVelocity, SolveError> = ThroughVelocity::solve;
    let _: fn(&ThroughTwelveSnap, f64) -> ThroughTwelveCrackle = ThroughTwelveSnap::crackle;
    let _: fn(&ThroughTwelveCrackle, f64) -> ThroughTwelvePop = ThroughTwelveCrackle::pop;
    let _: fn(&ThroughTwelvePop, f64) -> ThroughTwelveDerivative7 = ThroughTwelvePop::derivative_7;
    let _: fn(&ThroughTwelve, Motion<f64, 13>) -> Result<ThroughTwelveDerivative12, SolveError> = ThroughTwelve::solve;
    assert_eq!(<ThroughVelocity as Mechanism>::DESCRIPTION.order, 1);
    assert_eq!(<ThroughTwelve as Mechanism>::DESCRIPTION.order, 12);

    // sine and its derivatives come round every four orders
    let pose = ThroughTwelve { order: 2.0 }
        .solve(Motion::at_constant_speed(0.3, 1.0))
        .expect("it is explicit");
    let cycle = [0.3_f64.sin(), 0.3_f64.cos(), -0.3_f64.sin(), -0.3_f64.cos()];
    for (order, own) in pose.height.derivatives().into_iter().enumerate() {
        let expected = 2.0 * cycle[order % 4];
        let terms = 2.0_f64.powi(i32::try_from(order).expect("orders are small"));
        // each term of the sum of 2^order terms may be rounded
        assert!(
            (own - expected).abs() <= f64::EPSILON * 4.0 * terms,
            "{order}: {own} {expected}"
        );
    }
    let short = ThroughVelocity { order: 2.0 }
        .solve(Motion::from([0.3, 1.0]))
        .expect("it is explicit");
    assert_eq!(short.height.velocity(), 2.0 * 0.3_f64.cos());
    assert_eq!(short.twice.velocity(), 4.0 * 0.3_f64.cos());
}
