//! Every test mechanism with dimensions and inputs for which it closes.

use kin_core::library;
use kin_core::prelude::*;

use super::{
    directions, dyads, four_bar_typings, hyperbolic, inverted_slider_crank_typings, multi_loop, outputs, ranged,
    scalar_forms, slider_crank_typings, space,
};
use crate::random::Random;

/// A mechanism in double precision, through snap.
pub trait ThroughSnap: Mechanism<Scalar = f64, Motion<f64> = Motion<f64, 5>> {}

impl<M: Mechanism<Scalar = f64, Motion<f64> = Motion<f64, 5>>> ThroughSnap for M {}

/// Motions of a mechanism's inputs.
pub type Inputs<M> = <M as Mechanism>::Inputs<Motion<f64, 5>>;

/// Dimensions of a mechanism, and the range of each of its inputs.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Scalar by scalar, in the order of declaration.
    pub parameters: &'static [f64],
    /// From where to where each input goes; the mechanism need not close everywhere between.
    pub inputs: &'static [(f64, f64)],
}

impl Case {
    /// The mechanism itself.
    #[must_use]
    pub fn mechanism<M: ThroughSnap>(&self) -> M {
        M::from_parameters(M::Parameters::from_fn(|index| self.parameters[index]))
    }

    /// The mechanism with its dimensions changed by up to a tenth.
    #[must_use]
    pub fn varied<M: ThroughSnap>(&self, random: &mut Random) -> M {
        M::from_parameters(M::Parameters::from_fn(|index| {
            self.parameters[index] * random.between(0.9, 1.1)
        }))
    }

    /// Inputs a fraction of their ranges from the start, each fraction the next multiple of the first, with random
    /// rates.
    #[must_use]
    pub fn inputs<M: ThroughSnap>(&self, fraction: f64, random: &mut Random) -> Inputs<M> {
        let mut own = 0.0;
        M::Inputs::from_fn(|index| {
            own += fraction;
            let (low, high) = self.inputs[index];
            Motion::new(random.motion(low + (high - low) * (own - own.floor())))
        })
    }
}

/// Something that is to be done with mechanisms of all kinds.
pub trait Visitor {
    /// Does it with one of them.
    fn visit<M: ThroughSnap>(&mut self, case: Case);
}

/// Dimensions as numbers, or by the name of a constant of the mechanism.
macro_rules! dimensions {
    ($mechanism:ty, [$($number:expr),*]) => {
        &[$($number),*]
    };
    ($mechanism:ty, $constant:ident) => {
        <$mechanism>::$constant.parameters().to_vec().leak()
    };
}

/// A function for each group of mechanisms, that leads a visitor through it. The mechanisms after `besides` are solved
/// as others of their group are, and are visited only with the feature `every-case`: each of them is compiled again for
/// each visitor.
macro_rules! groups {
    ($(
        $(#[$documentation:meta])*
        $group:ident of $module:ident { $($mechanism:ident $parameters:tt at $([$low:expr, $high:expr])+;)+ }
        $(+ besides { $($other:ident $numbers:tt at $([$from:expr, $to:expr])+;)+ })?
    )+) => {
        $(
            $(#[$documentation])*
            pub fn $group(visitor: &mut impl Visitor) {
                $(visitor.visit::<$module::$mechanism>(Case {
                    parameters: dimensions!($module::$mechanism, $parameters),
                    inputs: &[$(($low, $high)),+],
                });)+
                #[cfg(feature = "every-case")]
                others::$group(visitor);
            }
        )+

        /// The mechanisms that the groups leave out without the feature `every-case`.
        mod others {
            use super::*;

            $(
                #[allow(unused, reason = "a group may leave nothing out, and some groups are not described")]
                pub(super) fn $group(visitor: &mut impl Visitor) {
                    $($(visitor.visit::<$module::$other>(Case {
                        parameters: dimensions!($module::$other, $numbers),
                        inputs: &[$(($from, $to)),+],
                    });)+)?
                }
            )+
        }
    };
}

/// All whose assemblies have names, whatever the features: for visitors that only read descriptions, which cost nothing
/// to compile.
pub fn described(visitor: &mut impl Visitor) {
    macro_rules! whole {
        ($($group:ident)+) => {
            $(
                $group(visitor);
                if cfg!(not(feature = "every-case")) {
                    others::$group(visitor);
                }
            )+
        };
    }
    whole! { four_bars slider_cranks inverted_slider_cranks loops chains scalars }
    hyperbolic::all(visitor);
    whole! { ranges in_space with_outputs as_directions library_of_each_form library_besides }
}

/// The four-bar linkage in every typing, whatever the features.
pub fn four_bars_in_every_typing(visitor: &mut impl Visitor) {
    four_bars(visitor);
    if cfg!(not(feature = "every-case")) {
        others::four_bars(visitor);
    }
}

/// The library's mechanisms whose assemblies have names.
pub fn library(visitor: &mut impl Visitor) {
    library_of_each_form(visitor);
    library_besides(visitor);
}

/// The library, or without the feature `every-case` a mechanism of it for each closed form.
pub fn some_of_the_library(visitor: &mut impl Visitor) {
    library_of_each_form(visitor);
    #[cfg(feature = "every-case")]
    {
        library_besides(visitor);
        coupled_library(visitor);
    }
}

/// All whose assemblies have names.
pub fn all(visitor: &mut impl Visitor) {
    four_bars(visitor);
    slider_cranks(visitor);
    inverted_slider_cranks(visitor);
    loops(visitor);
    chains(visitor);
    scalars(visitor);
    hyperbolic::all(visitor);
    ranges(visitor);
    in_space(visitor);
    with_outputs(visitor);
    as_directions(visitor);
    library(visitor);
}

/// All with the feature `every-case`, and one of each form without it: for visitors that instantiate much code for
/// each.
pub fn of_each_form(visitor: &mut impl Visitor) {
    if cfg!(feature = "every-case") {
        all(visitor);
    } else {
        with_outputs(visitor);
        library_of_each_form(visitor);
    }
}

groups! {
    /// One four-bar linkage in many typings.
    four_bars of four_bar_typings {
        FourBarPlain [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarComponents [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarConjugate [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarHalfAngles [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarClockwiseRocker [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarRelativeRocker [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
    }
    + besides {
        FourBarSidesSwapped [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarReordered [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarMovedAcross [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarSumToZero [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarZeroToSum [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarComponentsSwapped [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarNegatedComponent [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarMixedComponents [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarDoubled [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarScaledByGround [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarScaledApart [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarDivided [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarTurned [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarInCrankFrame [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarPolar [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarCoordinates [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarProduct [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarLets [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarRockerFromPin [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarCouplerFromRocker [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarRockerFromUpright [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarQuarterTurn [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarClockwiseCoupler [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarUnknownsSwapped [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FourBarRenamed [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
    }

    /// One slider-crank in many typings, and driven elsewhere.
    slider_cranks of slider_crank_typings {
        SliderCrankLoop [1.0, 3.0, 0.4] at [-3.1, 3.1];
        SliderCrankClockwise [1.0, 3.0, 0.4] at [-3.1, 3.1];
        SliderCrankInclined [1.0, 3.0, 0.4, 0.7] at [-3.1, 3.1];
        SliderCrankAlongVector [1.0, 3.0, 0.2, -0.3, 1.5, 2.0] at [-3.1, 3.1];
        SliderCrankDrivenAtSlider [1.0, 3.0, 0.4] at [1.9, 4.1];
        SliderCrankDrivenByRod [1.0, 3.0, 0.4] at [-0.4, 0.6];
    }
    + besides {
        SliderCrankSidesSwapped [1.0, 3.0, 0.4] at [-3.1, 3.1];
        SliderCrankSumToZero [1.0, 3.0, 0.4] at [-3.1, 3.1];
        SliderCrankComponents [1.0, 3.0, 0.4] at [-3.1, 3.1];
        SliderCrankScaled [1.0, 3.0, 0.4] at [-3.1, 3.1];
        SliderCrankTurned [1.0, 3.0, 0.4] at [-3.1, 3.1];
        SliderCrankMixedComponents [1.0, 3.0, 0.4] at [-3.1, 3.1];
        SliderCrankRodFromSlider [1.0, 3.0, 0.4] at [-3.1, 3.1];
        SliderCrankBackwards [1.0, 3.0, 0.4] at [-3.1, 3.1];
        SliderCrankUpright [1.0, 3.0, 0.4] at [-3.1, 3.1];
    }

    /// One inverted slider-crank in many typings, with and without offset, and driven elsewhere.
    inverted_slider_cranks of inverted_slider_crank_typings {
        InvertedLoop [2.0, 0.8] at [-3.1, 3.1];
        InvertedInCrankFrame [2.0, 0.8] at [-3.1, 3.1];
        InvertedOffset [2.0, 0.8, 0.5] at [-3.1, 3.1];
        InvertedOffsetInLeverFrame [2.0, 0.8, 0.5] at [-3.1, 3.1];
        InvertedDrivenByCylinder [2.0, 0.8] at [1.1, 2.9];
    }
    + besides {
        InvertedPolar [2.0, 0.8] at [-3.1, 3.1];
        InvertedComponents [2.0, 0.8] at [-3.1, 3.1];
        InvertedFromPin [2.0, 0.8] at [-3.1, 3.1];
        InvertedClockwise [2.0, 0.8] at [-3.1, 3.1];
        InvertedOffsetAtRightAngles [2.0, 0.8, 0.5] at [-3.1, 3.1];
        InvertedOffsetComponents [2.0, 0.8, 0.5] at [-3.1, 3.1];
    }

    /// Single loops of other kinds.
    loops of dyads {
        TwoSlides [1.3, 0.4, 2.2] at [-3.1, 3.1];
        SwingingSlides [2.0, 1.2] at [-3.1, 3.1];
        TwoLinkArm [1.2, 0.9] at [-1.4, 1.4] [-1.3, 1.4];
        TwoLinkArmPolar [1.2, 0.9] at [0.2, 2.2] [-3.1, 3.1];
        OffsetAngles [90.0, 30.0, 60.0, 45.0, 0.3, 0.5] at [-1.9, 1.9];
        ComplexLinks [80.0, 20.0, 30.0, 55.0, 25.0, 40.0, 30.0] at [-3.1, 3.1];
        ComplexRod [1.0, 2.5, 0.8, 0.7] at [-3.1, 3.1];
        FiveBar [2.0, 1.0, 2.0, 1.8, 1.1] at [0.2, 2.9] [0.3, 3.0];
    }

    /// Several loops, one after the other.
    chains of multi_loop {
        FourBarsInSeries [4.0, 1.0, 3.0, 2.5, 4.0, 4.5, 3.0] at [-3.1, 3.1];
        ToggleOnCoupler [4.0, 1.0, 3.0, 2.5, 4.0, 0.4] at [-3.1, 3.1];
        GearedYoke [4.0, 1.0, 3.0, 2.5, 2.5, 0.7] at [-3.1, 3.1];
    }
    + besides {
        FourBarsInSeriesShuffled [4.0, 1.0, 3.0, 2.5, 4.0, 4.5, 3.0] at [-3.1, 3.1];
        WattSixBar [4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5] at [-3.1, 3.1];
        StephensonSixBar [4.0, 1.0, 3.0, 2.5, 1.5, 1.0, 5.0, 3.0, 3.0, 2.5] at [-3.1, 3.1];
        Whitworth [0.5, 1.2, 1.5, 5.0, 0.3] at [-3.1, 3.1];
    }

    /// One scalar equation after another.
    scalars of scalar_forms {
        LinearForm [0.7, 1.3] at [-1.5, 1.5];
        QuadraticForm [1.5, 2.0, 0.5] at [-3.0, 3.0];
        QuadraticWhere [4.0, 0.5] at [-0.5, 3.0];
        SquareForm [1.2] at [0.3, 3.0];
        SquareWhere [1.2] at [0.3, 3.0];
        SquareWhereNegative [1.2] at [0.3, 3.0];
        CircularForm [1.2, 0.8] at [-1.4, 1.4];
        CircularPhase [1.2, 0.8, 0.4] at [-1.4, 1.4];
        CosineForm [1.5] at [-1.3, 1.3];
        SineForm [1.5] at [-1.3, 1.3];
        TangentForm [1.5] at [-4.0, 4.0];
        RootForm [1.5] at [-1.2, 4.0];
        DistanceForm [1.5] at [1.8, 4.0];
        ArcSineForm [1.5] at [-1.4, 1.4];
        ArcCosineForm [1.5] at [0.3, 6.0];
        ArcTangentForm [1.5] at [-1.4, 1.4];
        ExponentialForm [1.5] at [0.2, 4.0];
        LogarithmForm [0.8] at [-2.0, 2.0];
        ExplicitFunctions [3.0, 1.0] at [-3.1, 3.1];
    }

    /// Unknowns with a range.
    ranges of ranged {
        RangedCoupler [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        RangedRocker [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        RangedAngle [2.0, 3.0] at [1.2, 4.8];
        RangedSine [1.5] at [-1.3, 1.3];
        RangedSlider [1.0, 3.0, 0.4] at [-3.1, 3.1];
        RangedLever [2.0, 0.8] at [-3.1, 3.1];
        RangedCircular [1.2, 0.8] at [-0.1, 1.1];
        RangedTwice [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        RangedIncline [1.0, 3.0, 0.4] at [-3.1, 3.1];
        RangedBetween [60.0, 45.0, 75.0, 95.0, 60.0, 100.0] at [-1.9, 1.9];
    }
    + besides {
        RangedAngleBelow [2.0, 3.0] at [1.2, 4.8];
        RangedSineObtuse [1.5] at [-1.3, 1.3];
        RangedLinear [1.5] at [0.1, 6.0];
    }

    /// Mechanisms of space, and products of vectors.
    in_space of space {
        RssrWithBall [1.0, 3.0, 0.5, 0.8, 0.2, 0.9, 0.3, 0.4, -0.3, 1.9, 3.3] at [-3.1, 3.1];
        RssrDrivenAtRocker [1.0, 3.0, 0.5, 0.8, 0.2, 0.9, 0.3, 0.4, -0.3, 1.9, 3.3] at [-1.2, 1.2];
        RsspWithBall [1.0, 1.5, 0.4, 0.3, 0.3, -0.4, 1.2, 3.0] at [-3.1, 3.1];
        UniversalJointByNormal [0.7] at [-3.1, 3.1];
        SphericalFourBarAboutAxis [1.4, 0.5, 1.2, 0.9] at [-3.1, 3.1];
        BennettByTripleProduct [2.0, 0.6, 1.3] at [-3.1, 3.1];
        PlaneProducts [1.0, 3.0] at [-3.1, 3.1];
    }
    + besides {
        Rssr [1.0, 3.0, 0.5, 0.8, 0.2, 0.9, 0.3, 0.4, -0.3, 1.9, 3.3] at [-3.1, 3.1];
        RssrByLength [1.0, 3.0, 0.5, 0.8, 0.2, 0.9, 0.3, 0.4, -0.3, 1.9, 3.3] at [-3.1, 3.1];
        Rssp [1.0, 1.5, 0.4, 0.3, 0.3, -0.4, 1.2, 3.0] at [-3.1, 3.1];
        RsspByLength [1.0, 1.5, 0.4, 0.3, 0.3, -0.4, 1.2, 3.0] at [-3.1, 3.1];
        UniversalJoint [0.7] at [-3.1, 3.1];
        SphericalFourBar [1.4, 0.5, 1.2, 0.9] at [-3.1, 3.1];
        StewartGoughLeg [1.0, 0.2, -0.3, 0.6, -0.5, 0.2]
            at [-0.5, 0.5] [-0.4, 0.6] [1.5, 2.5] [-0.7, 0.7] [-0.6, 0.8] [-3.1, 3.1];
        StewartGoughLegByLength [1.0, 0.2, -0.3, 0.6, -0.5, 0.2]
            at [-0.5, 0.5] [-0.4, 0.6] [1.5, 2.5] [-0.7, 0.7] [-0.6, 0.8] [-3.1, 3.1];
        Bennett [2.0, 0.6, 1.3] at [-3.1, 3.1];
        LegsOfFrames [
            1.0, 0.2, -0.3, -0.9, 0.4, 0.1, 0.6, -0.5, 0.2, -0.7, 0.3, 0.1, 0.4
        ] at [1.5, 2.5] [-3.1, 3.1] [-0.7, 0.7];
    }

    /// With outputs, and with functions that are not defined everywhere.
    with_outputs of outputs {
        FourBarOutputs [90.0, 30.0, 60.0, 45.0, 25.0, 15.0] at [-1.9, 1.9];
        OutputOutsideDomain [1.5] at [1.8, 5.0];
        ClosureOutsideDomain [1.5] at [0.3, 5.0];
    }
    + besides {
        OutputsOfFrames [90.0, 30.0, 60.0, 45.0, 25.0, 15.0, -10.0, 20.0] at [-1.9, 1.9];
        OutputsInFormulas [30.0, 80.0, 50.0, 160.0, 70.0] at [-3.1, 3.1];
    }

    /// Unknowns that are found as unit vectors.
    as_directions of directions {
        DirectedFourBar [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        DirectedRelative [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        DirectedTriangles [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        DirectedWithinRange [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        DirectedRack [90.0, 30.0, 60.0, 45.0, 10.0] at [-1.9, 1.9];
        DirectedSliderCrank [1.0, 3.0, 0.4] at [-3.1, 3.1];
        DirectedAtSlider [1.0, 3.0, 0.4] at [1.9, 4.1];
        DirectedOffsetLever [2.0, 0.8, 0.5] at [-3.1, 3.1];
        DirectedArm [1.2, 0.9] at [-1.4, 1.4] [-1.3, 1.4];
        DirectedSensitive [90.0, 30.0, 60.0, 45.0, 10.0] at [-1.9, 1.9];
        DirectedDrive [90.0, 30.0, 60.0, 45.0] at [-3.1, 3.1];
    }
    + besides {
        DirectedRocker [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        DirectedFreudenstein [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        DirectedByInverseSine [1.0, 3.0, 0.4] at [-3.1, 3.1];
        DirectedLever [2.0, 0.8] at [-3.1, 3.1];
        DirectedSeries [4.0, 1.0, 3.0, 2.5, 4.0, 4.5, 3.0] at [-3.1, 3.1];
        DirectedGears [1.5, 2.0] at [-3.1, 3.1];
        DirectedJoint [0.7] at [-3.1, 3.1];
    }

    /// A mechanism of the library for each closed form, with published dimensions where there are any.
    library_of_each_form of library {
        FourBar [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        FreudensteinFourBar [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        OffsetSliderCrank [1.0, 3.0, 0.4] at [-3.1, 3.1];
        InvertedSliderCrank [2.0, 0.8] at [-3.1, 3.1];
        ScotchYoke [2.0, 1.4] at [-3.1, 3.1];
        PeaucellierLinkage [2.0, 2.0, 6.0, 4.0] at [-1.8, 1.8];
        GearedFiveBar [2.0, 0.5, 2.5, 2.5, 0.5, -2.0, 0.7] at [-3.1, 3.1];
        KlannLeg PATENT at [-3.1, 3.1];
        Rssr [1.0, 3.0, 0.5, 0.8, 0.2, 0.9, 0.3, 0.4, -0.3, 1.9, 3.3] at [-3.1, 3.1];
        Rssp [1.0, 1.5, 0.4, 0.3, 0.3, -0.4, 1.2, 3.0] at [-3.1, 3.1];
        UniversalJoint [0.7] at [-3.1, 3.1];
        SphericalFourBar [1.4, 0.5, 1.2, 0.9] at [-3.1, 3.1];
        StewartGoughLeg [
            1.0, 0.2, -0.3, 0.6, -0.5, 0.2
        ] at [-0.5, 0.5] [-0.4, 0.6] [1.5, 2.5] [-0.7, 0.7] [-0.6, 0.8] [-3.1, 3.1];
        Bennett [2.0, 0.6, 1.3] at [-3.1, 3.1];
    }

    /// The other mechanisms of the library.
    library_besides of library {
        GeometricFourBar [90.0, 30.0, 60.0, 45.0] at [-1.9, 1.9];
        SliderCrank [1.0, 3.0] at [-3.1, 3.1];
        SliderCrankFirstApproximation [1.0, 3.5] at [-3.1, 3.1];
        SliderCrankHigherApproximation [1.0, 3.5] at [-3.1, 3.1];
        WhitworthQuickReturn [0.05, 0.12, 0.15, 0.5] at [-3.1, 3.1];
        ChebyshevLinkage PUBLISHED at [0.7, 1.7];
        HoekenLinkage PUBLISHED at [-3.1, 3.1];
        RobertsLinkage [1.0, 1.2] at [0.6, 1.4];
        Pantograph [2.0, 1.5, 2.5] at [0.5, 2.2] [-1.5, 1.5];
        FiveBar [2.0, 1.5, 2.0, 2.0, 1.5] at [0.2, 2.9] [0.3, 3.0];
        WattI [4.0, 1.0, 3.0, 2.5, 1.5, 0.8, 2.0, 1.5, 2.5, 2.0] at [-3.1, 3.1];
        WattII [4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5] at [-3.1, 3.1];
        StephensonI [4.0, 1.0, 3.0, 2.5, 0.5, 1.0, 1.5, 1.0, 2.5, 2.0] at [-3.1, 3.1];
        StephensonIIByElbow [4.0, 2.0, 1.5, 1.2, 3.0, 0.3, 1.0, 0.5, 1.6, 3.0] at [-3.1, 3.1];
        StephensonIII [4.0, 1.0, 3.0, 2.5, 1.5, 1.0, 3.0, 5.0, 3.0, 2.5] at [-3.1, 3.1];
        JansenLeg HOLY_NUMBERS at [-3.1, 3.1];
        AndrewsSqueezer PUBLISHED at [-1.0, 1.0];
    }

    /// The library's mechanisms with coupled blocks, the assemblies of which have no names.
    coupled_library of library {
        WattIByDyad [4.0, 1.0, 3.0, 2.5, 1.5, 0.8, 2.0, 1.5, 2.5, 2.0] at [-3.1, 3.1];
        WattIIByCouplers [4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5] at [-3.1, 3.1];
        StephensonIByDyad [4.0, 1.0, 3.0, 2.5, 0.5, 1.0, 1.5, 1.0, 2.5, 2.0] at [-3.1, 3.1];
        StephensonII [4.0, 2.0, 1.5, 1.2, 3.0, 0.3, 1.0, 0.5, 1.6, 3.0] at [-3.1, 3.1];
        StephensonIIIByDyad [4.0, 1.0, 3.0, 2.5, 1.5, 1.0, 3.0, 5.0, 3.0, 2.5] at [-3.1, 3.1];
        ClassThreeTriad [3.4, 0.2, 1.7, 3.1, 1.6, 0.1, 0.8, 1.4] at [1.8, 2.4] [1.8, 2.4] [1.8, 2.4];
    }
}
