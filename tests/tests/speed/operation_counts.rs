//! The cost of the solvers: the published constants of the library and of the test mechanisms, held in snapshots and
//! proved by running the solvers on numbers that count.

use core::fmt::Write;

use kin_core::Operations;
use kin_core::count::{self, Counted};
use kin_core::library::{
    Bennett, FourBar, FreudensteinFourBar, GeometricFourBar, InvertedSliderCrank, OffsetSliderCrank, Rssp, Rssr,
    SliderCrank, SliderCrankFirstApproximation, SliderCrankHigherApproximation, SphericalFourBar, StewartGoughLeg,
    UniversalJoint,
};
use kin_core::prelude::*;
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::mechanisms::coupled::SixInChain;
use kin_tests::random::Random;

fn kinds(operations: &Operations) -> [usize; 8] {
    [
        operations.additions,
        operations.multiplications,
        operations.divisions,
        operations.negations,
        operations.square_roots,
        operations.sine_cosines,
        operations.arc_tangents,
        operations.others,
    ]
}

/// The place of changes of sign among the kinds.
const NEGATIONS: usize = 3;

fn published<M: Mechanism>() -> Operations {
    M::DESCRIPTION
        .operations
        .iter()
        .fold(Operations::NONE, |sum, order| sum.plus(*order))
}

/// Runs mechanisms on counting numbers, and notes what does not agree.
#[derive(Default)]
struct Count {
    wrong: Vec<String>,
}

impl Visitor for Count {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let mut random = Random::new(7);
        let mechanism: M = case.mechanism();
        let counting = mechanism.convert(Counted::new);
        let mut dearest = [0; 8];
        for step in 0..24 {
            let inputs = case.inputs::<M>(f64::from(step) / 24.0, &mut random);
            let counted = <<M::With<Counted> as Mechanism>::Inputs<M::Motion<Counted>> as Row<_>>::from_fn(|index| {
                <M::Motion<Counted> as Row<Counted>>::from_fn(|order| Counted::new(inputs[index].as_slice()[order]))
            });
            for assembly in M::assemblies() {
                let mut closes = false;
                let tally = count::of(|| closes = counting.solve(counted, assembly).is_ok());
                if closes {
                    for (most, own) in dearest.iter_mut().zip(kinds(&tally)) {
                        *most = own.max(*most);
                    }
                }
            }
        }
        let published = kinds(&published::<M>());
        // A sign is changed in the crossed assembly of a dyad, and where there are several not all are crossed at once.
        let choices = M::assemblies().count().ilog2() as usize;
        let idle = published[NEGATIONS].saturating_sub(dearest[NEGATIONS]);
        if idle < choices {
            dearest[NEGATIONS] += idle;
        }
        if dearest != published {
            let name = M::DESCRIPTION.name;
            self.wrong
                .push(format!("{name}: {dearest:?} carried out, {published:?} published"));
        }
    }
}

#[test]
fn every_form_costs_what_is_published() {
    let mut count = Count::default();
    cases::of_each_form(&mut count);
    assert!(count.wrong.is_empty(), "{:#?}", count.wrong);
}

/// With coupled blocks the position costs what the guess is worth, the rates what is published.
#[test]
fn rates_of_coupled_blocks_cost_what_is_published() {
    struct Rates;
    impl Visitor for Rates {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            type S = Counted;
            let mut random = Random::new(8);
            let mechanism: M = case.mechanism();
            let counting = mechanism.convert(S::new);
            let mut poses = 0;
            for step in 0..240 {
                let inputs = case.inputs::<M>(f64::from(step) / 240.0, &mut random);
                let values = M::Inputs::from_fn(|index| inputs[index].value());
                let guess = M::Unknowns::from_fn(|_| random.between(-3.0, 3.0));
                let Ok(near) = mechanism.position_near(values, guess) else {
                    continue;
                };
                let counted = <<M::With<S> as Mechanism>::Inputs<M::Motion<S>> as Row<_>>::from_fn(|index| {
                    <M::Motion<S> as Row<S>>::from_fn(|order| S::new(inputs[index].as_slice()[order]))
                });
                let counted_values =
                    <<M::With<S> as Mechanism>::Inputs<S> as Row<S>>::from_fn(|index| S::new(values[index]));
                let near = <<M::With<S> as Mechanism>::Unknowns<S> as Row<S>>::from_fn(|index| S::new(near[index]));
                let whole = kinds(&count::of(|| counting.solve_near(counted, near).expect("it closes")));
                let position = kinds(&count::of(|| counting.position_near(counted_values, near).expect("so")));
                let rates = M::DESCRIPTION.operations[1..]
                    .iter()
                    .fold(Operations::NONE, |sum, order| sum.plus(*order));
                for ((whole, position), rates) in whole.into_iter().zip(position).zip(kinds(&rates)) {
                    assert_eq!(whole - position, rates, "{}", M::DESCRIPTION.name);
                }
                poses += 1;
            }
            assert!(poses > 20, "{}: {poses}", M::DESCRIPTION.name);
        }
    }
    cases::coupled_library(&mut Rates);
    // the only one with factors
    Rates.visit::<SixInChain>(Case {
        parameters: &[0.5, 2.5, 1.0, 1.5, 1.2, 0.7],
        inputs: &[(-0.2, 0.2)],
    });
}

/// Writes what a mechanism costs, order by order.
struct Table(String);

impl Visitor for Table {
    fn visit<M: ThroughSnap>(&mut self, _: Case) {
        let orders: Vec<usize> = M::DESCRIPTION.operations.iter().map(Operations::arithmetic).collect();
        let sum = published::<M>();
        writeln!(
            self.0,
            "{:28} {orders:3?} = {:3}, {} sine-cosine pairs, {} roots, {} arctangents, {} others",
            M::DESCRIPTION.name,
            sum.arithmetic(),
            sum.sine_cosines,
            sum.square_roots,
            sum.arc_tangents,
            sum.others,
        )
        .expect("writing to a string succeeds");
    }
}

#[test]
fn costs_of_every_form() {
    let mut table = Table(String::new());
    cases::described(&mut table);
    insta::assert_snapshot!(table.0);
}

/// However the four-bar linkage is typed, it costs no more than twice what the shortest typing costs.
#[test]
fn no_typing_is_punished() {
    struct Dearest(usize);
    impl Visitor for Dearest {
        fn visit<M: ThroughSnap>(&mut self, _: Case) {
            let name = M::DESCRIPTION.name;
            if name.starts_with("FourBar") && !name.contains("Series") && name != "FourBarOutputs" {
                self.0 = self.0.max(published::<M>().arithmetic());
            }
        }
    }
    let mut dearest = Dearest(0);
    cases::described(&mut dearest);
    let plain = published::<kin_core::library::FourBar>().arithmetic();
    assert!(dearest.0 <= 2 * plain, "{} against {plain}", dearest.0);
}

/// Parameters for which every library mechanism closes at the angle below.
const PARAMETERS: [f64; 4] = [2.0, 5.0, 4.0, 3.5];
const ANGLE: f64 = 1.1;

/// The largest number of each kind of operation.
fn larger(a: Operations, b: Operations) -> Operations {
    let mut larger = a;
    larger.additions = a.additions.max(b.additions);
    larger.multiplications = a.multiplications.max(b.multiplications);
    larger.divisions = a.divisions.max(b.divisions);
    larger.negations = a.negations.max(b.negations);
    larger.square_roots = a.square_roots.max(b.square_roots);
    larger.sine_cosines = a.sine_cosines.max(b.sine_cosines);
    larger.arc_tangents = a.arc_tangents.max(b.arc_tangents);
    larger.others = a.others.max(b.others);
    larger
}

/// Runs a mechanism on counting numbers in every assembly, and compares the dearest with what was declared.
fn prove<M: Mechanism<Scalar = Counted>>() {
    let mechanism = M::from_parameters(M::Parameters::from_fn(|index| Counted::new(PARAMETERS[index])));
    let inputs = M::Inputs::from_fn(|_| M::Motion::from_fn(|order| Counted::new([ANGLE, 1.0, 2.0, 3.0, 4.0][order])));
    let mut measured = Operations::default();
    let mut count_of_poses = 0;
    for assembly in M::assemblies() {
        let mut solved = false;
        let own = count::of(|| solved = mechanism.solve(inputs, assembly).is_ok());
        if solved {
            measured = larger(measured, own);
            count_of_poses += 1;
        }
    }
    assert!(count_of_poses > 0, "{} does not close", M::DESCRIPTION.name);
    assert_eq!(measured, published::<M>(), "{}", M::DESCRIPTION.name);
}

#[test]
fn the_library_costs_what_is_published() {
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
    let cost = published::<FourBar>();
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
