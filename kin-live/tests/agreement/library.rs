//! Every mechanism of the library, by the text of its file.

use kin_agreement::{assert_agreement, declaration};

/// Compares the mechanisms of files.
macro_rules! compare {
    ($($file:literal: $($name:ident),+;)+) => {
        0 $($(+ {
            let file = include_str!(concat!("../../../kin-core/src/library/", $file, ".rs"));
            let text = declaration(file, stringify!($name));
            let [finite, solved, folded] = assert_agreement::<kin_core::library::$name>(text);
            println!("{}: {solved} positions", stringify!($name));
            assert!(finite > 0, "{} is never calculated", stringify!($name));
            folded
        })+)+
    };
}

#[test]
fn every_mechanism_of_the_library() {
    // by this mechanism and by that, since few random dimensions close everywhere
    let folded = compare! {
        "andrews_squeezer": AndrewsSqueezer;
        "approximate_slider_crank": SliderCrankFirstApproximation, SliderCrankHigherApproximation;
        "bennett": Bennett;
        "chebyshev_linkage": ChebyshevLinkage;
        "class_three_triad": ClassThreeTriad;
        "five_bar": FiveBar, GearedFiveBar;
        "four_bar": FourBar;
        "freudenstein_four_bar": FreudensteinFourBar;
        "geometric_four_bar": GeometricFourBar;
        "hoeken_linkage": HoekenLinkage;
        "inverted_slider_crank": InvertedSliderCrank;
        "jansen_leg": JansenLeg;
        "klann_leg": KlannLeg;
        "pantograph": Pantograph;
        "peaucellier_linkage": PeaucellierLinkage;
        "roberts_linkage": RobertsLinkage;
        "rssp": Rssp;
        "rssr": Rssr;
        "scotch_yoke": ScotchYoke;
        "slider_crank": SliderCrank, OffsetSliderCrank;
        "spherical_four_bar": SphericalFourBar;
        "stephenson_six_bars": StephensonI, StephensonIIByElbow, StephensonIII, StephensonIByDyad, StephensonII,
            StephensonIIIByDyad;
        "stewart_gough_leg": StewartGoughLeg;
        "universal_joint": UniversalJoint;
        "watt_six_bars": WattI, WattII, WattIByDyad, WattIIByCouplers;
        "whitworth_quick_return": WhitworthQuickReturn;
    };
    assert!(folded > 10_000, "{folded} numbers are summarised");
}
