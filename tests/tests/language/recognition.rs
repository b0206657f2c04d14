//! Recognition follows from the algebra, not from the typing: the same closed form, the same motion, and assemblies
//! that mean the same geometry.

use core::f64::consts::PI;
use core::fmt::Write;

use kin_core::library::{FourBar, InvertedSliderCrank, OffsetSliderCrank};
use kin_core::prelude::*;
use kin_tests::compare::assert_agree;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{self, Case, Visitor};
use kin_tests::mechanisms::four_bar_typings::*;
use kin_tests::mechanisms::inverted_slider_crank_typings::*;
use kin_tests::mechanisms::slider_crank_typings::*;
use kin_tests::oracles::{Gauge, Motions};
use kin_tests::random::Random;

type Angle = Motion<f64, 5>;

fn constant(value: f64) -> Angle {
    Motion::constant(value)
}

/// Solves a typing and a reference side by side, and compares every unknown.
///
/// `expected` makes a typing's unknowns of the reference's, in its order; `angles` says which of them are angles.
fn same<M, R>(expected: impl Fn(&Motions<R>) -> Vec<Angle>, angles: &[bool], parameters: &[&[f64]])
where
    M: ThroughSnap<Assembly = Assembly>,
    R: ThroughSnap<Assembly = Assembly>,
{
    same_with::<M, R>(expected, angles, parameters, |assembly| assembly);
}

/// The same, where the typing's assembly has another name.
fn same_with<M, R>(
    expected: impl Fn(&Motions<R>) -> Vec<Angle>,
    angles: &[bool],
    parameters: &[&[f64]],
    named: impl Fn(Assembly) -> Assembly,
) where
    M: ThroughSnap<Assembly = Assembly>,
    R: ThroughSnap<Assembly = Assembly>,
{
    let name = M::DESCRIPTION.name;
    let mut random = Random::new(11);
    let mut count = 0;
    for parameters in parameters {
        let typing = M::from_parameters(M::Parameters::from_fn(|index| parameters[index]));
        let reference = R::from_parameters(R::Parameters::from_fn(|index| parameters[index]));
        for step in 0..36 {
            let input = Motion::new(random.motion((f64::from(10 * step) - 177.3).to_radians()));
            for assembly in Assembly::BOTH {
                let inputs = R::Inputs::from_fn(|_| input);
                let Ok(pose) = reference.solve(inputs, assembly) else {
                    continue;
                };
                let theirs = pose.unknown_motions();
                let own_inputs = M::Inputs::from_fn(|_| input);
                let own = typing
                    .solve(own_inputs, named(assembly))
                    .unwrap_or_else(|error| panic!("{name}: {error}"))
                    .unknown_motions();
                let gauges = (
                    Gauge::new(&typing, &own_inputs, &own),
                    Gauge::new(&reference, &inputs, &theirs),
                );
                let expected = expected(&theirs);
                for (index, (own, expected)) in own.as_ref().iter().zip(expected).enumerate() {
                    let gauges = [(&gauges.0, index), (&gauges.1, 0), (&gauges.1, 1)];
                    assert_agree(name, *own, expected, angles[index], &gauges);
                }
                count += 1;
            }
        }
    }
    assert!(count > 40, "{name}: only {count} poses");
}

/// The linkage of the notes, a crank-rocker, and a drag link.
const FOUR_BARS: [&[f64]; 3] = [&[90.0, 30.0, 60.0, 45.0], &[4.0, 1.0, 3.0, 2.5], &[1.0, 3.0, 2.5, 3.0]];

macro_rules! typings_of_the_four_bar {
    ($($typing:ident: |$theta3:ident, $theta4:ident| $expected:expr;)+) => {
        $(
            same::<$typing, FourBar>(|&[$theta3, $theta4]| $expected.to_vec(), &[true, true], &FOUR_BARS);
            assert_eq!(<$typing>::DESCRIPTION.blocks, <FourBar>::DESCRIPTION.blocks, stringify!($typing));
        )+
    };
}

#[test]
fn four_bars_with_the_usual_angles() {
    typings_of_the_four_bar! {
        FourBarPlain: |a, b| [a, b];
        FourBarSidesSwapped: |a, b| [a, b];
        FourBarReordered: |a, b| [a, b];
        FourBarMovedAcross: |a, b| [a, b];
        FourBarSumToZero: |a, b| [a, b];
        FourBarZeroToSum: |a, b| [a, b];
        FourBarComponents: |a, b| [a, b];
        FourBarComponentsSwapped: |a, b| [a, b];
        FourBarNegatedComponent: |a, b| [a, b];
        FourBarMixedComponents: |a, b| [a, b];
        FourBarDoubled: |a, b| [a, b];
        FourBarScaledByGround: |a, b| [a, b];
        FourBarScaledApart: |a, b| [a, b];
        FourBarDivided: |a, b| [a, b];
        FourBarConjugate: |a, b| [a, b];
        FourBarTurned: |a, b| [a, b];
        FourBarInCrankFrame: |a, b| [a, b];
        FourBarPolar: |a, b| [a, b];
        FourBarCoordinates: |a, b| [a, b];
        FourBarProduct: |a, b| [a, b];
        FourBarHalfAngles: |a, b| [a, b];
        FourBarLets: |a, b| [a, b];
    }
    same::<FourBarRenamed, FourBar>(|unknowns| unknowns.to_vec(), &[true, true], &FOUR_BARS);
}

/// Angles measured elsewhere are shifted, and change neither the closed form nor the assembly.
#[test]
fn four_bars_with_other_angles() {
    typings_of_the_four_bar! {
        FourBarRockerFromPin: |a, b| [a, b - constant(PI)];
        FourBarCouplerFromRocker: |a, b| [a + constant(PI), b];
        FourBarRockerFromUpright: |a, b| [a, b - constant(PI / 2.0)];
        FourBarQuarterTurn: |a, b| [a, b - constant(PI / 2.0)];
        FourBarClockwiseRocker: |a, b| [a, -b];
        FourBarClockwiseCoupler: |a, b| [-a, b];
        FourBarRelativeRocker: |a, b| [a, b - a];
    }
}

/// Open means that the link of the second unknown turns clockwise from that of the first, so the order in which the
/// unknowns are declared names the assemblies.
#[test]
fn the_order_of_the_unknowns_names_the_assemblies() {
    same_with::<FourBarUnknownsSwapped, FourBar>(
        |&[theta3, theta4]| vec![theta4, theta3],
        &[true, true],
        &FOUR_BARS,
        Assembly::mirrored,
    );
    let blocks = <FourBarUnknownsSwapped>::DESCRIPTION.blocks;
    assert_eq!(blocks.len(), 1);
    assert_eq!(blocks[0].unknowns, "theta4, theta3");
    assert_eq!(blocks[0].solution, <FourBar>::DESCRIPTION.blocks[0].solution);
}

/// Crank, rod, and height of the slide; the second has a crank longer than its rod.
const SLIDER_CRANKS: [&[f64]; 3] = [&[1.0, 3.0, 0.4], &[1.0, 1.6, -0.5], &[2.0, 1.5, 0.3]];

macro_rules! typings_of_the_slider_crank {
    ($($typing:ident: |$phi:ident, $s:ident| $expected:expr;)+) => {
        $(same::<$typing, OffsetSliderCrank>(
            |&[$phi, $s]| $expected.to_vec(),
            &[true, false],
            &SLIDER_CRANKS,
        );)+
    };
}

/// The rod's angle is clockwise in the library.
#[test]
fn slider_cranks() {
    typings_of_the_slider_crank! {
        SliderCrankLoop: |phi, s| [-phi, s];
        SliderCrankSidesSwapped: |phi, s| [-phi, s];
        SliderCrankSumToZero: |phi, s| [-phi, s];
        SliderCrankComponents: |phi, s| [-phi, s];
        SliderCrankScaled: |phi, s| [-phi, s];
        SliderCrankTurned: |phi, s| [-phi, s];
        SliderCrankMixedComponents: |phi, s| [-phi, s];
        SliderCrankClockwise: |phi, s| [phi, s];
    }
    // which equation comes first is a matter of typing
    let solutions = |blocks: &[kin_core::Block]| {
        let blocks = blocks.iter();
        blocks.map(|block| (block.unknowns, block.solution)).collect::<Vec<_>>()
    };
    let plain = <SliderCrankLoop>::DESCRIPTION.blocks;
    for blocks in [
        <SliderCrankSidesSwapped>::DESCRIPTION.blocks,
        <SliderCrankSumToZero>::DESCRIPTION.blocks,
        <SliderCrankComponents>::DESCRIPTION.blocks,
        <SliderCrankScaled>::DESCRIPTION.blocks,
        <SliderCrankClockwise>::DESCRIPTION.blocks,
        <SliderCrankRodFromSlider>::DESCRIPTION.blocks,
        <SliderCrankBackwards>::DESCRIPTION.blocks,
    ] {
        assert_eq!(solutions(blocks), solutions(plain));
    }
    // where neither equation holds one unknown alone, the loop is solved as one
    for blocks in [
        <SliderCrankTurned>::DESCRIPTION.blocks,
        <SliderCrankMixedComponents>::DESCRIPTION.blocks,
        <SliderCrankInclined>::DESCRIPTION.blocks,
        <SliderCrankAlongVector>::DESCRIPTION.blocks,
    ] {
        assert_eq!(blocks.len(), 1);
        assert_eq!(blocks[0].solution, "circle meets line (RRP dyad)");
    }
}

/// Where the slide lies along an axis, the rod's angle alone is sought first: open is where it points along the slide.
#[test]
fn slider_cranks_with_a_rod_that_points_back() {
    same_with::<SliderCrankRodFromSlider, OffsetSliderCrank>(
        |&[phi, s]| vec![constant(PI) - phi, s],
        &[true, false],
        &SLIDER_CRANKS,
        Assembly::mirrored,
    );
    same::<SliderCrankBackwards, OffsetSliderCrank>(|&[phi, s]| vec![-phi, -s], &[true, false], &SLIDER_CRANKS);
}

/// An inclined slide is the same mechanism in a turned frame: the crank's angle is measured from the slide.
#[test]
fn inclined_slides() {
    let mut random = Random::new(12);
    let beta = 0.7;
    let inclined = SliderCrankInclined::<f64>::from_parameters([1.0, 3.0, 0.4, beta]);
    let (sine, cosine) = f64::sin_cos(beta);
    // a direction of length 2, so that its travel is half of the other
    let along =
        SliderCrankAlongVector::<f64>::from_parameters([1.0, 3.0, -0.4 * sine, 0.4 * cosine, 2.0 * cosine, 2.0 * sine]);
    let straight = OffsetSliderCrank { r: 1.0, l: 3.0, h: 0.4 };
    for step in 0..72 {
        let theta = Motion::new(random.motion((f64::from(5 * step) + 0.4).to_radians()));
        for assembly in Assembly::BOTH {
            let own = inclined.solve(theta, assembly).expect("it closes");
            let other = straight.solve(theta - constant(beta), assembly).expect("it closes");
            let third = along.solve(theta, assembly).expect("it closes");
            let gauge = Gauge::new(&inclined, &[theta], &own.unknown_motions());
            let (phi, s) = (constant(beta) - other.phi, other.s);
            assert_agree("inclined, phi", own.phi, phi, true, &[(&gauge, 0)]);
            assert_agree("inclined, s", own.s, s, false, &[(&gauge, 1)]);
            assert_agree("along a vector, phi", third.phi, phi, true, &[(&gauge, 0)]);
            assert_agree("along a vector, s", third.s.scale(2.0), s, false, &[(&gauge, 1)]);
        }
    }
}

/// The slider upright is the slider along x, turned by a right angle.
#[test]
fn upright_slides() {
    let mut random = Random::new(13);
    let upright = SliderCrankUpright::<f64>::from_parameters([1.0, 3.0, 0.4]);
    let level = OffsetSliderCrank {
        r: 1.0,
        l: 3.0,
        h: -0.4,
    };
    for step in 0..72 {
        let theta = Motion::new(random.motion((f64::from(5 * step) + 0.4).to_radians()));
        for assembly in Assembly::BOTH {
            let own = upright.solve(theta, assembly).expect("it closes");
            let other = level.solve(theta - constant(PI / 2.0), assembly).expect("it closes");
            let gauge = Gauge::new(&upright, &[theta], &own.unknown_motions());
            let phi = constant(PI / 2.0) - other.phi;
            assert_agree("upright, phi", own.phi, phi, true, &[(&gauge, 0)]);
            assert_agree("upright, s", own.s, other.s, false, &[(&gauge, 1)]);
        }
    }
}

/// Driven at the slider or by the rod: the motion that the crank would have to have, led back to where it came from.
#[test]
fn slider_cranks_driven_elsewhere() {
    let parameters = [1.0, 3.0, 0.4];
    let by_crank = SliderCrankLoop::<f64>::from_parameters(parameters);
    let by_slider = SliderCrankDrivenAtSlider::<f64>::from_parameters(parameters);
    let by_rod = SliderCrankDrivenByRod::<f64>::from_parameters(parameters);
    let mut random = Random::new(14);
    for step in 0..72 {
        let theta = Motion::new(random.motion((f64::from(5 * step) + 1.7).to_radians()));
        for assembly in Assembly::BOTH {
            let forward = by_crank.solve(theta, assembly).expect("it closes");
            let near = [theta.value(), forward.phi.value()];
            let back = by_slider.solve_near(forward.s, near).expect("it closes");
            let gauge = Gauge::new(&by_slider, &[forward.s], &back.unknown_motions());
            // what was lost on the way there is lost in the input of the way back
            let own = Gauge::new(&by_crank, &[theta], &forward.unknown_motions());
            assert_agree(
                "crank",
                back.theta,
                theta,
                false,
                &[(&gauge, 0), (&gauge, 1), (&own, 0)],
            );
            assert_agree(
                "rod",
                back.phi,
                forward.phi,
                false,
                &[(&gauge, 0), (&gauge, 1), (&own, 0)],
            );
            let near = [forward.s.value(), theta.value()];
            let back = by_rod.solve_near(forward.phi, near).expect("it closes");
            let gauge = Gauge::new(&by_rod, &[forward.phi], &back.unknown_motions());
            assert_agree(
                "crank",
                back.theta,
                theta,
                false,
                &[(&gauge, 1), (&gauge, 0), (&own, 0)],
            );
            assert_agree(
                "slider",
                back.s,
                forward.s,
                false,
                &[(&gauge, 0), (&gauge, 1), (&own, 1)],
            );
        }
    }
    assert_eq!(
        <SliderCrankDrivenAtSlider>::DESCRIPTION.blocks[0].solution,
        "circle meets circle (RRR dyad)"
    );
}

const LEVERS: [&[f64]; 2] = [&[2.0, 0.8], &[1.0, 1.7]];
const LEVERS_WITH_OFFSET: [&[f64]; 2] = [&[2.0, 0.8, 0.5], &[1.0, 1.7, -0.4]];

#[test]
fn inverted_slider_cranks() {
    macro_rules! typings {
        ($($typing:ident: |$r4:ident, $theta4:ident| $expected:expr;)+) => {
            $(
                same::<$typing, InvertedLoop>(|&[$r4, $theta4]| $expected.to_vec(), &[false, true], &LEVERS);
                assert_eq!(<$typing>::DESCRIPTION.blocks, <InvertedLoop>::DESCRIPTION.blocks);
            )+
        };
    }
    typings! {
        InvertedPolar: |r4, theta4| [r4, theta4];
        InvertedComponents: |r4, theta4| [r4, theta4];
        InvertedInCrankFrame: |r4, theta4| [r4, theta4];
        InvertedFromPin: |r4, theta4| [r4, theta4 + constant(PI)];
        InvertedClockwise: |r4, theta4| [r4, -theta4];
    }
    // the library's has its length positive, which is the open assembly
    let mut random = Random::new(15);
    for step in 0..72 {
        let theta2 = Motion::new(random.motion((f64::from(5 * step) + 0.4).to_radians()));
        let own = InvertedLoop::<f64>::from_parameters([2.0, 0.8]);
        let [open, crossed] = Assembly::BOTH.map(|assembly| own.solve(theta2, assembly).expect("it closes"));
        let library = InvertedSliderCrank { r1: 2.0, r2: 0.8 }
            .solve(theta2)
            .expect("it closes");
        assert_eq!(open.unknown_motions(), library.unknown_motions());
        let gauge = Gauge::new(&own, &[theta2], &open.unknown_motions());
        assert_agree("length", crossed.r4, -open.r4, false, &[(&gauge, 0)]);
        assert_agree(
            "angle",
            crossed.theta4,
            open.theta4 + constant(PI),
            true,
            &[(&gauge, 1)],
        );
    }
}

#[test]
fn inverted_slider_cranks_with_offset() {
    macro_rules! typings {
        ($($typing:ident)+) => {
            $(same::<$typing, InvertedOffset>(|unknowns| unknowns.to_vec(), &[false, true], &LEVERS_WITH_OFFSET);)+
        };
    }
    typings! { InvertedOffsetAtRightAngles InvertedOffsetComponents InvertedOffsetInLeverFrame }
    for blocks in [
        <InvertedOffsetAtRightAngles>::DESCRIPTION.blocks,
        <InvertedOffsetComponents>::DESCRIPTION.blocks,
    ] {
        assert_eq!(blocks, <InvertedOffset>::DESCRIPTION.blocks);
    }
    assert_eq!(
        <InvertedOffset>::DESCRIPTION.blocks[0].solution,
        "polar form with offset (RPR dyad)"
    );
}

/// Writes how each mechanism is solved.
struct ClosedForms(String);

impl Visitor for ClosedForms {
    fn visit<M: ThroughSnap>(&mut self, _: Case) {
        let blocks: Vec<String> = M::DESCRIPTION
            .blocks
            .iter()
            .map(|block| format!("{}: {}", block.unknowns, block.solution))
            .collect();
        writeln!(self.0, "{:28} {}", M::DESCRIPTION.name, blocks.join("; ")).expect("writing to a string succeeds");
    }
}

#[test]
fn closed_forms() {
    let mut forms = ClosedForms(String::new());
    cases::described(&mut forms);
    insta::assert_snapshot!(forms.0);
}
