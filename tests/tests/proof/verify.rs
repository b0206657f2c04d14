//! The verification that users run on their own mechanisms, run on all of ours: random dimensions, and given ones.
//!
//! The tables are printed: `cargo test -p kin-tests --test proof verify -- --nocapture`.

use kin_core::library::{
    FourBar, FreudensteinFourBar, GeometricFourBar, InvertedSliderCrank, OffsetSliderCrank, SliderCrank,
    SliderCrankFirstApproximation, SliderCrankHigherApproximation,
};
use kin_core::prelude::*;
use kin_core::verify;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{self, Case, Visitor};

/// Drawn without any hint.
struct AnyDimensions;

impl Visitor for AnyDimensions {
    fn visit<M: ThroughSnap>(&mut self, _: Case) {
        let report = verify::mechanism::<M>();
        println!("{report}\n");
        report.assert();
    }
}

/// Drawn about dimensions that are known to close.
struct AboutDimensions;

impl Visitor for AboutDimensions {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let report = verify::of(&case.mechanism::<M>(), M::Inputs::from_fn(|index| case.inputs[index]));
        println!("{report}\n");
        report.assert();
    }
}

#[test]
fn the_library() {
    for report in [
        verify::mechanism::<FourBar>(),
        verify::mechanism::<GeometricFourBar>(),
        verify::mechanism::<FreudensteinFourBar>(),
        verify::mechanism::<SliderCrank>(),
        verify::mechanism::<OffsetSliderCrank>(),
        verify::mechanism::<InvertedSliderCrank>(),
        verify::mechanism::<SliderCrankFirstApproximation>(),
        verify::mechanism::<SliderCrankHigherApproximation>(),
    ] {
        println!("{report}\n");
        report.assert();
    }
}

macro_rules! groups {
    ($($group:ident)+) => {
        $(
            #[test]
            fn $group() {
                cases::$group(&mut AnyDimensions);
                cases::$group(&mut AboutDimensions);
            }
        )+
    };
}

groups! { four_bars slider_cranks inverted_slider_cranks loops chains scalars ranges with_outputs as_directions }

/// Mechanisms of the library about the dimensions that are published.
#[test]
fn the_library_as_published() {
    cases::some_of_the_library(&mut AboutDimensions);
}
