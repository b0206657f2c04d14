//! The mechanisms of kin-tests, compiled by rustc and declared from their texts: both give the same numbers.
#![allow(dead_code, missing_docs, unreachable_pub, reason = "the files belong to kin-tests")]

#[path = "../../../tests/src/mechanisms/mod.rs"]
mod mechanisms;
#[path = "../../../tests/src/random.rs"]
mod random;

use kin_agreement::{assert_agreement, declaration, declarations};

/// Compares all mechanisms of files that are declared outside of macros.
macro_rules! compare {
    ($($file:ident: $($name:ident),+;)+) => {
        $(
            #[test]
            fn $file() {
                let file = include_str!(concat!("../../../tests/src/mechanisms/", stringify!($file), ".rs"));
                let names = [$(stringify!($name)),+];
                assert_eq!(declarations(file).len(), names.len(), "the file declares others");
                $({
                    let text = declaration(file, stringify!($name));
                    let [finite, solved, _] = assert_agreement::<mechanisms::$file::$name>(text);
                    println!("{}: {finite} results, {solved} positions", stringify!($name));
                    assert!(finite > 0, "{} is never calculated", stringify!($name));
                })+
            }
        )+
    };
}

compare! {
    coupled: Kepler, RelativeDrive, Triad, StephensonThree, GearedPair, SixCoupled, SixInChain;
    directions: DirectedFourBar, DirectedRocker, DirectedRelative, DirectedFreudenstein, DirectedTriangles,
        DirectedWithinRange, DirectedRack, DirectedSliderCrank, DirectedByInverseSine, DirectedAtSlider,
        DirectedLever, DirectedOffsetLever, DirectedArm, DirectedSeries, DirectedGears, DirectedJoint,
        DirectedFarther, DirectedSensitive, DirectedDrive, DirectedKepler, DirectedTriad;
    dyads: TwoSlides, SwingingSlides, TwoLinkArm, TwoLinkArmPolar, OffsetAngles, ComplexLinks, ComplexRod,
        FiveBar, FourBarOnGround;
    four_bar_typings: FourBarUnknownsSwapped, FourBarRenamed;
    hyperbolic: HyperbolicSineForm, CatenaryForm, CatenaryWhere, CatenaryRanged, CoefficientInCosine,
        HyperbolicTangentForm, AreaSineForm, AreaCosineForm, AreaTangentForm, HyperbolicFunctions,
        HyperbolicSensitive, HyperbolicKepler;
    inverted_slider_crank_typings: InvertedDrivenByCylinder;
    multi_loop: FourBarsInSeries, FourBarsInSeriesShuffled, WattSixBar, StephensonSixBar, Whitworth,
        ToggleOnCoupler, GearedYoke, TwoDyads;
    outputs: FourBarOutputs, OutputOutsideDomain, ClosureOutsideDomain, OutputsOfFrames,
        OutputsInFormulas;
    ranged: RangedCoupler, RangedRocker, RangedAngle, RangedAngleBelow, RangedSine, RangedSineObtuse,
        RangedSlider, RangedLever, RangedCircular, RangedLinear, RangedTwice, RangedIncline, RangedBetween;
    scalar_forms: LinearForm, QuadraticForm, QuadraticWhere, SquareForm, SquareWhere, SquareWhereNegative,
        CircularForm, CircularPhase, CosineForm, SineForm, TangentForm, RootForm, DistanceForm, ArcSineForm,
        ArcCosineForm, ArcTangentForm, ExponentialForm, LogarithmForm, ExplicitFunctions;
    sensitive: SensitiveFourBarDivided, SensitiveFreudenstein, SensitiveGeometric, SensitiveSeries,
        SensitiveOutputs, SensitiveTernary, SensitiveRssr, SensitiveRssp, SensitiveFourBar, SensitiveRanged,
        SensitiveSlider, SensitivePump, SensitiveSlides, SensitiveWatt, SensitiveLogarithm, SensitiveFunctions;
    slider_crank_typings: SliderCrankInclined, SliderCrankAlongVector, SliderCrankDrivenAtSlider,
        SliderCrankDrivenByRod;
    space: RssrByLength, RssrWithBall, RssrDrivenAtRocker, RsspByLength, RsspWithBall, UniversalJointByNormal,
        SphericalFourBarAboutAxis, StewartGoughLegByLength, LegsOfFrames, BennettByTripleProduct, PlaneProducts;
}
