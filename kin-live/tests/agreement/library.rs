//! Every mechanism of the library, by the text of its file.

use kin_agreement::{assert_agreement, declaration};

/// A test that compares the mechanisms of files. Few random dimensions close everywhere, so that only the count of
/// summarised numbers in all mechanisms is tested.
macro_rules! agree {
    ($test:ident, $least:literal; $($file:literal: $($name:ident),+;)+) => {
        #[test]
        fn $test() {
            let mut summarised = 0;
            $($({
                let file = include_str!(concat!("../../../kin-core/src/library/", $file, ".rs"));
                let text = declaration(file, stringify!($name));
                let [finite, solved, folded] = assert_agreement::<kin_core::library::$name>(text);
                println!("{}: {solved} positions", stringify!($name));
                assert!(finite > 0, "{} is never calculated", stringify!($name));
                summarised += folded;
            })+)+
            assert!(summarised > $least, "{summarised} numbers are summarised");
        }
    };
}

// in two tests, which run beside each other
agree! {
    mechanisms_from_a_to_r, 7000;
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
}

agree! {
    mechanisms_from_s_to_w, 3000;
    "scotch_yoke": ScotchYoke;
    "slider_crank": SliderCrank, OffsetSliderCrank;
    "spherical_four_bar": SphericalFourBar;
    "stephenson_six_bars": StephensonI, StephensonIIByElbow, StephensonIII, StephensonIByDyad, StephensonII,
        StephensonIIIByDyad;
    "stewart_gough_leg": StewartGoughLeg;
    "universal_joint": UniversalJoint;
    "watt_six_bars": WattI, WattII, WattIByDyad, WattIIByCouplers;
    "whitworth_quick_return": WhitworthQuickReturn;
}
