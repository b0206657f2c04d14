//! The growth of time with the order and with the number of loops, beside automatic differentiation of the position
//! solution.
//!
//! `cargo bench -p kin-tests --bench growth` prints lines `ratio NAME VALUE`, from times taken in one run, and the
//! counts of operations. Nothing is asserted: the counts are, in the test of the same name. With `-- --plot` it draws
//! the figures of the book from what it has measured.
#![allow(missing_docs, reason = "a program")]

mod measure;
mod plot;

use core::hint::black_box;

use kin_core::prelude::*;
use kin_core::series::Series;
use kin_tests::carrier::Carrier;
use kin_tests::growth::{
    self, Counts, FourBar1, FourBar2, FourBar3, FourBar4, FourBar5, FourBar6, FourBar7, FourBar8, FourBar9, FourBar10,
    four_bar,
};
use kin_tests::mechanisms::chains::{self, Chain1, Chain2, Chain4, Chain8, Chain16};
use kin_tests::random::Random;
use measure::{Race, Times};
use num_dual::Dual;
use plot::{Curve, Panel, Scale};

const POSES: usize = 64;

type Dual1 = Dual<f64>;
type Dual2 = Dual<Dual1>;
type Dual3 = Dual<Dual2>;
type Dual4 = Dual<Dual3>;
type Dual5 = Dual<Dual4>;
type Dual6 = Dual<Dual5>;

/// Motions of the only input through the mechanism's order, all around, where it closes.
fn motions<M: Mechanism<Scalar = f64>>(mechanism: &M, assembly: M::Assembly) -> Vec<M::Motion<f64>> {
    let mut random = Random::new(7);
    let mut motions = Vec::new();
    while motions.len() < POSES {
        let mut motion = M::Motion::from_fn(|_| random.between(-2.0, 2.0));
        motion[0] = random.between(-3.1, 3.1);
        if mechanism.solve(M::Inputs::from_fn(|_| motion), assembly).is_ok() {
            motions.push(motion);
        }
    }
    motions
}

/// Enters the generated solvers.
fn enter<M: Mechanism<Scalar = f64> + 'static>(race: &mut Race<'_>, name: String, mechanism: M) {
    let assembly = M::assembly(0).expect("there are assemblies");
    race.enter(name, motions(&mechanism, assembly), move |motion| {
        black_box(mechanism).solve(M::Inputs::from_fn(|_| motion), assembly)
    });
}

/// Enters the position solver, run on numbers that carry derivatives through the mechanism's order.
fn enter_carried<M: Mechanism<Scalar = f64> + 'static, S: Carrier>(race: &mut Race<'_>, name: String, mechanism: M) {
    let assembly = M::assembly(0).expect("there are assemblies");
    let lifted = mechanism.convert(S::constant);
    let inputs = motions(&mechanism, assembly)
        .iter()
        .map(|motion| S::carry(motion.as_ref()))
        .collect();
    race.enter(name, inputs, move |input: S| {
        black_box(lifted).position(Row::from_fn(|_| input), assembly)
    });
}

/// The quantity along an axis: the orders, or the numbers of loops.
struct Growth {
    axis: &'static str,
    counts: Vec<Counts>,
    times: Times,
}

impl Growth {
    fn name(&self, step: usize, contender: &str) -> String {
        format!("{}_{step}.{contender}", self.axis)
    }

    fn print(&self) {
        for &Counts {
            step,
            generated,
            nested,
        } in &self.counts
        {
            println!("operations {} {generated}", self.name(step, "generated"));
            println!("operations {} {nested}", self.name(step, "nested_dual_numbers"));
        }
        let steps = || self.counts.iter().map(|counts| counts.step);
        for step in steps().skip(1) {
            self.times
                .ratio(&self.name(step, "generated"), &self.name(1, "generated"));
        }
        for other in ["series", "nested_dual_numbers"] {
            for name in steps().map(|step| (self.name(step, other), self.name(step, "generated"))) {
                if self.times.of(&name.0).is_some() {
                    self.times.ratio(&name.0, &name.1);
                }
            }
        }
    }

    /// Operations to the left, times to the right.
    fn panels(&self, title: &str, across: &'static str, scale: Scale) -> [Panel; 2] {
        #[allow(clippy::cast_precision_loss, reason = "there are millions at most")]
        let counts = |name, of: fn(&Counts) -> usize| Curve {
            name,
            points: self
                .counts
                .iter()
                .map(|counts| (counts.step, of(counts) as f64))
                .collect(),
        };
        let times = |name, contender| {
            let point = |counts: &Counts| Some((counts.step, self.times.of(&self.name(counts.step, contender))?));
            Curve {
                name,
                points: self.counts.iter().filter_map(point).collect(),
            }
        };
        let operations = vec![
            counts(plot::GENERATED, |counts| counts.generated),
            counts(plot::NESTED, |counts| counts.nested),
        ];
        let durations = vec![
            times(plot::GENERATED, "generated"),
            times(plot::SERIES, "series"),
            times(plot::NESTED, "nested_dual_numbers"),
        ];
        [("operations", operations), ("nanoseconds", durations)].map(|(up, curves)| Panel {
            title: title.to_owned(),
            across,
            up,
            scale,
            curves,
        })
    }
}

fn orders() -> Growth {
    let mut race = Race::new(POSES);
    macro_rules! contenders {
        ($($mechanism:ident $order:literal $length:literal $($dual:ident)?;)+) => {
            $(
                enter(&mut race, format!("order_{}.generated", $order), four_bar::<$mechanism>());
                enter_carried::<_, Series<$length>>(
                    &mut race, format!("order_{}.series", $order), four_bar::<$mechanism>());
                $(enter_carried::<_, $dual>(
                    &mut race, format!("order_{}.nested_dual_numbers", $order), four_bar::<$mechanism>());)?
            )+
        };
    }
    contenders! {
        FourBar1 1 2 Dual1;
        FourBar2 2 3 Dual2;
        FourBar3 3 4 Dual3;
        FourBar4 4 5 Dual4;
        FourBar5 5 6 Dual5;
        FourBar6 6 7 Dual6;
        FourBar7 7 8;
        FourBar8 8 9;
        FourBar9 9 10;
        FourBar10 10 11;
    }
    Growth {
        axis: "order",
        counts: growth::by_order(),
        times: race.run(),
    }
}

fn loops() -> Growth {
    let mut race = Race::new(POSES);
    macro_rules! contenders {
        ($($mechanism:ident $loops:literal;)+) => {
            $(
                enter(&mut race, format!("loops_{}.generated", $loops), chains::chain::<$mechanism>());
                enter_carried::<_, Series<5>>(
                    &mut race, format!("loops_{}.series", $loops), chains::chain::<$mechanism>());
                enter_carried::<_, Dual4>(
                    &mut race, format!("loops_{}.nested_dual_numbers", $loops), chains::chain::<$mechanism>());
            )+
        };
    }
    contenders! {
        Chain1 1;
        Chain2 2;
        Chain4 4;
        Chain8 8;
        Chain16 16;
    }
    Growth {
        axis: "loops",
        counts: growth::by_loops(),
        times: race.run(),
    }
}

fn main() {
    let (orders, loops) = (orders(), loops());
    orders.print();
    loops.print();
    if std::env::args().any(|argument| argument == "--plot") {
        plot::figure(
            "growth-by-order.svg",
            &orders.panels("Four-bar linkage", "highest order of the derivatives", Scale::Linear),
        );
        plot::figure(
            "growth-by-loops.svg",
            &loops.panels("Four-bar linkages in series, through snap", "loops", Scale::PowersOfTwo),
        );
    }
}
