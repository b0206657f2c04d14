//! The mechanisms of the campaign: chosen ones, and samples of random declarations.

use kin_core::library::{
    FourBar, GearedFiveBar, GeometricFourBar, OffsetSliderCrank, Rssr, SphericalFourBar, StephensonIII, WattI,
};

use super::topology::Topology;
use crate::trees::{TreeOfAllKinds, TreeOfDyads};
use kin_tests::mechanisms::chains::Chain4;
use kin_tests::mechanisms::coupled::{GearedPair, Kepler, StephensonThree, Triad};
use kin_tests::mechanisms::directions::DirectedRack;
use kin_tests::mechanisms::inverted_slider_crank_typings::{InvertedDrivenByCylinder, InvertedOffset};
use kin_tests::mechanisms::scalar_forms::{ExplicitFunctions, QuadraticForm};
use kin_tests::mechanisms::slider_crank_typings::SliderCrankDrivenAtSlider;

/// A mechanism as a topology.
macro_rules! of {
    ($mechanism:ty) => {
        crate::topology::Topology {
            solvers: kin_core::any::Of::<$mechanism>::FUNCTIONS,
            counted: kin_core::any::Of::<kin_tests::counting::Counting<$mechanism>>::FUNCTIONS,
            in_parallel: |problems, assemblies, vectors| {
                let assembly = assemblies[0]
                    .index()
                    .and_then(<$mechanism as kin_core::Mechanism>::assembly);
                crate::topology::poses::<$mechanism>(problems, assemblies).solve_in_parallel(assembly, vectors)
            },
        }
    };
}

#[allow(dead_code, missing_docs, reason = "nobody has written them")]
mod drawn {
    use super::Topology;

    type Found = Topology;
    type Find = fn() -> Found;

    include!(concat!(env!("OUT_DIR"), "/drawn.rs"));

    pub(super) fn all() -> impl Iterator<Item = Topology> {
        SAMPLE.iter().map(|(find, _)| find())
    }
}

/// All of them.
pub(crate) fn all() -> Vec<Topology> {
    let mut all = vec![
        of!(FourBar),
        of!(GeometricFourBar),
        of!(OffsetSliderCrank),
        of!(SliderCrankDrivenAtSlider),
        of!(InvertedOffset),
        of!(InvertedDrivenByCylinder),
        of!(GearedFiveBar),
        of!(WattI),
        of!(StephensonIII),
        of!(Chain4),
        of!(TreeOfDyads),
        of!(TreeOfAllKinds),
        of!(DirectedRack),
        of!(Rssr),
        of!(SphericalFourBar),
        of!(QuadraticForm),
        of!(ExplicitFunctions),
        of!(Triad),
        of!(StephensonThree),
        of!(GearedPair),
        of!(Kepler),
    ];
    all.extend(drawn::all());
    all
}
