//! The published operation counts of the test mechanisms: held in a table, and proved by running the solvers on numbers
//! that count.

use core::fmt::Write;

use kin_core::Operations;
use kin_core::count::{self, Counted};
use kin_core::prelude::*;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::cases::{self, Case, Visitor};
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
                <M::Motion<Counted> as Row<Counted>>::from_fn(|order| {
                    Counted::new(inputs.as_ref()[index].as_slice()[order])
                })
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
