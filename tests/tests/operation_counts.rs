//! What the solvers cost: the published constants, held in a snapshot and proved by running the solvers on numbers that
//! count.

use core::fmt::Write;

use kin_core::Operations;
use kin_core::count::{self, Counted};
use kin_core::library::{
    Bennett, FourBar, FreudensteinFourBar, GeometricFourBar, InvertedSliderCrank, OffsetSliderCrank, Rssp, Rssr,
    SliderCrank, SliderCrankFirstApproximation, SliderCrankHigherApproximation, SphericalFourBar, StewartGoughLeg,
    UniversalJoint,
};
use kin_core::prelude::*;

/// Parameters for which every library mechanism closes at the angle below.
const PARAMETERS: [f64; 4] = [2.0, 5.0, 4.0, 3.5];
const ANGLE: f64 = 1.1;

/// The largest number of each kind of operation.
fn larger(a: Operations, b: Operations) -> Operations {
    Operations {
        additions: a.additions.max(b.additions),
        multiplications: a.multiplications.max(b.multiplications),
        divisions: a.divisions.max(b.divisions),
        negations: a.negations.max(b.negations),
        square_roots: a.square_roots.max(b.square_roots),
        sine_cosines: a.sine_cosines.max(b.sine_cosines),
        arc_tangents: a.arc_tangents.max(b.arc_tangents),
        others: a.others.max(b.others),
    }
}

fn declared<M: Mechanism>() -> Operations {
    M::DESCRIPTION
        .operations
        .iter()
        .fold(Operations::default(), |sum, order| sum.plus(*order))
}

/// Runs a mechanism on counting numbers in every assembly, and compares the dearest with what was declared.
fn prove<M: Mechanism<Scalar = Counted>>() {
    let mechanism = M::from_parameters(M::Parameters::from_fn(|index| Counted::new(PARAMETERS[index])));
    let inputs = M::Inputs::from_fn(|_| M::Motion::from_fn(|order| Counted::new([ANGLE, 1.0, 2.0, 3.0, 4.0][order])));
    let mut measured = Operations::default();
    let mut count_of_poses = 0;
    for assembly in M::assemblies() {
        let mut solved = false;
        let own = count::of(|| solved = mechanism.solve_motion(inputs, assembly).is_ok());
        if solved {
            measured = larger(measured, own);
            count_of_poses += 1;
        }
    }
    assert!(count_of_poses > 0, "{} does not close", M::DESCRIPTION.name);
    assert_eq!(measured, declared::<M>(), "{}", M::DESCRIPTION.name);
}

#[test]
fn constants_are_what_is_carried_out() {
    prove::<FourBar<Counted>>();
    prove::<GeometricFourBar<Counted>>();
    prove::<FreudensteinFourBar<Counted>>();
    prove::<SliderCrank<Counted>>();
    prove::<OffsetSliderCrank<Counted>>();
    prove::<InvertedSliderCrank<Counted>>();
    prove::<SliderCrankFirstApproximation<Counted>>();
    prove::<SliderCrankHigherApproximation<Counted>>();
}

/// Each order on its own, for the four-bar.
#[test]
fn each_order_costs_only_its_own_work() {
    let counted = Counted::new;
    let linkage = FourBar {
        r1: counted(5.0),
        r2: counted(2.0),
        r3: counted(4.0),
        r4: counted(3.5),
    };
    // the assembly that costs a change of sign more
    let position = linkage.position(counted(ANGLE), Assembly::Crossed).expect("it closes");
    let velocity = position.velocity(counted(1.0));
    let acceleration = velocity.acceleration(counted(2.0));
    let jerk = acceleration.jerk(counted(3.0));
    let measured = [
        count::of(|| linkage.position(counted(ANGLE), Assembly::Crossed)),
        count::of(|| position.velocity(counted(1.0))),
        count::of(|| velocity.acceleration(counted(2.0))),
        count::of(|| acceleration.jerk(counted(3.0))),
        count::of(|| jerk.snap(counted(4.0))),
    ];
    assert_eq!(measured, FourBar::OPERATIONS);
}

/// 197 operations is what a best-practice pipeline by hand through a computer algebra system came to.
#[test]
fn the_four_bar_beats_the_hand_made_figure() {
    let cost = declared::<FourBar>();
    assert!(cost.arithmetic() <= 197, "{}", cost.arithmetic());
    assert_eq!(
        (cost.sine_cosines, cost.square_roots, cost.arc_tangents, cost.others),
        (1, 1, 2, 0)
    );
}

#[test]
fn library_costs() {
    let mut table = String::new();
    let mut line = |description: kin_core::Description| {
        let orders: Vec<usize> = description.operations.iter().map(Operations::arithmetic).collect();
        let sum = description
            .operations
            .iter()
            .fold(Operations::default(), |sum, order| sum.plus(*order));
        writeln!(
            table,
            "{:32} {orders:3?} = {:3}, {} sine-cosine pairs, {} roots, {} arctangents",
            description.name,
            sum.arithmetic(),
            sum.sine_cosines,
            sum.square_roots,
            sum.arc_tangents
        )
        .expect("writing to a string succeeds");
    };
    line(<FourBar>::DESCRIPTION);
    line(<GeometricFourBar>::DESCRIPTION);
    line(<FreudensteinFourBar>::DESCRIPTION);
    line(<SliderCrank>::DESCRIPTION);
    line(<OffsetSliderCrank>::DESCRIPTION);
    line(<InvertedSliderCrank>::DESCRIPTION);
    line(<SliderCrankFirstApproximation>::DESCRIPTION);
    line(<SliderCrankHigherApproximation>::DESCRIPTION);
    line(<Rssr>::DESCRIPTION);
    line(<Rssp>::DESCRIPTION);
    line(<UniversalJoint>::DESCRIPTION);
    line(<SphericalFourBar>::DESCRIPTION);
    line(<StewartGoughLeg>::DESCRIPTION);
    line(<Bennett>::DESCRIPTION);
    insta::assert_snapshot!(table);
}
