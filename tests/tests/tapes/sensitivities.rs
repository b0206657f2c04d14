//! Solvers with partial derivatives, in every language.

use kin_core::Sensitive;
use kin_core::prelude::*;
use kin_core::tape::{self, Options, Recorded, Tape};
use kin_tests::mechanisms::cases::{Case, ThroughSnap};
use kin_tests::mechanisms::coupled::{GearedPair, Kepler, RelativeDrive, Triad};

use crate::c;
use crate::languages::{Compared, Language};
use crate::poses::{Wanted, poses};

mechanism! {
    /// A four-bar linkage with a point of its coupler.
    #[allow(missing_docs)]
    pub struct Traced { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length, pub trace: Vector }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    let pin = r2 * cis(theta2);
    pin + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output point: Point = pin + trace * cis(theta3);
    with sensitivities;
}

/// The tape of a mechanism with its partial derivatives, and arguments in reach and out of reach.
fn recorded<M: ThroughSnap>(case: Case) -> (Tape, Vec<Vec<f64>>)
where
    M::With<Recorded<f64>>: Sensitive,
{
    let tape = tape::record_with_sensitivities::<M>(&Options::new().with_skeleton()).expect("it is recorded");
    let arguments = poses::<M>(case, 120).iter().map(Wanted::arguments).collect();
    (tape, arguments)
}

/// Closed forms and coupled blocks.
fn all() -> [(Tape, Vec<Vec<f64>>); 5] {
    const TURN: &[(f64, f64)] = &[(-3.0, 3.0)];
    let case = |parameters, inputs| Case { parameters, inputs };
    [
        recorded::<Traced>(case(&[90.0, 30.0, 60.0, 45.0, 20.0, 15.0], TURN)),
        recorded::<Kepler>(case(&[0.6], TURN)),
        recorded::<RelativeDrive>(case(&[90.0, 30.0, 60.0, 45.0], TURN)),
        recorded::<Triad>(case(&[0.5, 2.0, 2.2, 1.9, 1.5, 1.2, 0.7, 3.0, 0.4, 1.0, 2.8], TURN)),
        recorded::<GearedPair>(case(&[5.0, 1.5, 4.0, 2.5, 0.5, 0.3], TURN)),
    ]
}

fn compare(language: Language) {
    let mut compared = Compared::new(language);
    for (tape, arguments) in all() {
        compared.compare(&tape, &arguments);
    }
    compared.finish(5);
}

#[test]
#[ignore = "gcc"]
fn partial_derivatives_in_c_by_gcc() {
    let mut compared = c::Compared::default();
    for (tape, arguments) in all() {
        compared.compare(&tape, &arguments);
    }
    compared.finish(150);
}

#[test]
#[ignore = "node"]
fn partial_derivatives_in_java_script() {
    compare(Language::JavaScript);
}

#[test]
#[ignore = "numpy"]
fn partial_derivatives_in_numpy() {
    compare(Language::Python);
}
