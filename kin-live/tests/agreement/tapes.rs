//! Tapes: what is recorded of a text, printed in all languages, byte by byte.

use kin_core::Mechanism;
use kin_core::any::Of;
use kin_core::library::{
    FourBar, JansenLeg, OffsetSliderCrank, PeaucellierLinkage, Rssr, StephensonI, StewartGoughLeg, WattIByDyad,
};
use kin_core::tape::{Options, RecordedFunctions, record_any};

use kin_agreement::declaration;

/// All files that are printed of the solver of a mechanism.
fn printed(mechanism: &dyn RecordedFunctions<f64>, options: &Options) -> [String; 6] {
    let tape = record_any(mechanism, options).unwrap_or_else(|error| panic!("{error}"));
    let c = tape.c();
    [
        c.header,
        c.source,
        c.example,
        tape.java_script(),
        tape.python(),
        tape.to_string(),
    ]
}

fn assert_same_tapes<M: Mechanism<Scalar = f64>>(file: &str) {
    let live = kin_live::Mechanism::declare(declaration(file, M::DESCRIPTION.name)).expect("there is no mistake");
    for options in [Options::new().with_skeleton(), Options::new().up_to(1)] {
        let (found, expected) = (printed(&live, &options), printed(Of::<M>::FUNCTIONS, &options));
        for (found, expected) in found.iter().zip(&expected) {
            let mut lines = found.lines().zip(expected.lines());
            let other = lines.find(|(found, expected)| found != expected);
            assert_eq!((other, found.len()), (None, expected.len()), "{}", M::DESCRIPTION.name);
        }
    }
}

macro_rules! library {
    ($name:literal) => {
        include_str!(concat!("../../../kin-core/src/library/", $name, ".rs"))
    };
}

#[test]
fn of_mechanisms_of_every_kind() {
    assert_same_tapes::<FourBar>(library!("four_bar"));
    assert_same_tapes::<OffsetSliderCrank>(library!("slider_crank"));
    assert_same_tapes::<PeaucellierLinkage>(library!("peaucellier_linkage"));
    assert_same_tapes::<JansenLeg>(library!("jansen_leg"));
    assert_same_tapes::<StephensonI>(library!("stephenson_six_bars"));
    assert_same_tapes::<WattIByDyad>(library!("watt_six_bars"));
    assert_same_tapes::<Rssr>(library!("rssr"));
    assert_same_tapes::<StewartGoughLeg>(library!("stewart_gough_leg"));
}
