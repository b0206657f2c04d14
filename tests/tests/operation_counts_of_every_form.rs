//! The published operation counts of the test mechanisms: held in a table, and proved by running the solvers on numbers
//! that count.

use core::fmt::Write;

use kin_core::Operations;
use kin_core::count::{self, Counted};
use kin_core::prelude::*;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{self, Case, Visitor};
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
                let tally = count::of(|| closes = counting.solve_motion(counted, assembly).is_ok());
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
fn constants_are_what_is_carried_out() {
    let mut count = Count::default();
    cases::all(&mut count);
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
                let Ok(near) = mechanism.solve_position_near(values, guess) else {
                    continue;
                };
                let counted = <<M::With<S> as Mechanism>::Inputs<M::Motion<S>> as Row<_>>::from_fn(|index| {
                    <M::Motion<S> as Row<S>>::from_fn(|order| S::new(inputs[index].as_slice()[order]))
                });
                let counted_values =
                    <<M::With<S> as Mechanism>::Inputs<S> as Row<S>>::from_fn(|index| S::new(values[index]));
                let near = <<M::With<S> as Mechanism>::Unknowns<S> as Row<S>>::from_fn(|index| S::new(near[index]));
                let whole = kinds(&count::of(|| {
                    counting.solve_motion_near(counted, near).expect("it closes")
                }));
                let position = kinds(&count::of(|| {
                    counting.solve_position_near(counted_values, near).expect("so")
                }));
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
fn costs() {
    let mut table = Table(String::new());
    cases::all(&mut table);
    insta::assert_snapshot!(table.0);
}

/// However the four-bar linkage is typed, it costs no more than twice what the shortest typing costs.
#[test]
fn no_typing_is_punished() {
    struct Dearest(usize);
    impl Visitor for Dearest {
        fn visit<M: ThroughSnap>(&mut self, _: Case) {
            self.0 = self.0.max(published::<M>().arithmetic());
        }
    }
    let mut dearest = Dearest(0);
    cases::four_bars(&mut dearest);
    let plain = published::<kin_core::library::FourBar>().arithmetic();
    assert!(dearest.0 <= 2 * plain, "{} against {plain}", dearest.0);
}
