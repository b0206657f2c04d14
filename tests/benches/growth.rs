//! What time grows with: the order, and the number of loops; beside automatic differentiation of the position solution.
//!
//! `cargo bench -p kin-tests --bench growth` prints lines `ratio NAME VALUE`, from times taken in one run, and the counts of
//! operations. Nothing is asserted: the counts are, in the test of the same name.
#![allow(missing_docs, reason = "a program")]

mod measure;

use core::hint::black_box;

use kin_core::Operations;
use kin_core::prelude::*;
use kin_core::series::Series;
use kin_tests::mechanisms::chains::{self, Chain1, Chain2, Chain4, Chain8, Chain16};
use kin_tests::random::Random;
use measure::Race;
use num_dual::{Dual, DualNum};

const POSES: usize = 64;

/// Four-bar linkages through every order.
macro_rules! four_bars {
    ($($name:ident through $order:tt;)+) => {
        $(kin_core::mechanism! {
            pub struct $name { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
            input theta2: Angle;
            unknown theta3: Angle, theta4: Angle;
            r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
            order = $order;
        })+
    };
}

four_bars! {
    FourBar1 through 1;
    FourBar2 through 2;
    FourBar3 through 3;
    FourBar4 through 4;
    FourBar5 through 5;
    FourBar6 through 6;
    FourBar7 through 7;
    FourBar8 through 8;
    FourBar9 through 9;
    FourBar10 through 10;
}

/// A number that carries time derivatives, made of a value and as many of them.
trait Carrier: Scalar {
    fn carry(derivatives: &[f64]) -> Self;
}

impl<const N: usize> Carrier for Series<N> {
    fn carry(derivatives: &[f64]) -> Self {
        Self::from_derivatives(core::array::from_fn(|order| derivatives[order]))
    }
}

impl Carrier for f64 {
    fn carry(derivatives: &[f64]) -> Self {
        derivatives[0]
    }
}

impl<T: Carrier + DualNum<Primitive = f64>> Carrier for Dual<T> {
    fn carry(derivatives: &[f64]) -> Self {
        Self::new(T::carry(derivatives), T::carry(&derivatives[1..]))
    }
}

type Nested1 = Dual<f64>;
type Nested2 = Dual<Nested1>;
type Nested3 = Dual<Nested2>;
type Nested4 = Dual<Nested3>;
type Nested5 = Dual<Nested4>;
type Nested6 = Dual<Nested5>;

/// Motions of the only input through the mechanism's order, all around, where it closes.
fn motions<M: Mechanism<Scalar = f64>>(mechanism: &M, assembly: M::Assembly) -> Vec<M::Motion<f64>> {
    let mut random = Random::new(7);
    let mut motions = Vec::new();
    while motions.len() < POSES {
        let mut motion = M::Motion::from_fn(|_| random.between(-2.0, 2.0));
        motion.as_mut()[0] = random.between(-3.1, 3.1);
        if mechanism.solve_motion(M::Inputs::from_fn(|_| motion), assembly).is_ok() {
            motions.push(motion);
        }
    }
    motions
}

/// A crank-rocker.
fn four_bar<M: Mechanism<Scalar = f64>>() -> M {
    let dimensions = [4.0, 1.0, 3.0, 2.5];
    M::from_parameters(M::Parameters::from_fn(|index| dimensions[index]))
}

/// Enters the generated solvers.
fn enter<M: Mechanism<Scalar = f64> + 'static>(race: &mut Race<'_>, name: String, mechanism: M) {
    let assembly = M::assembly(0).expect("there are assemblies");
    race.enter(name, motions(&mechanism, assembly), move |motion| {
        black_box(mechanism).solve_motion(M::Inputs::from_fn(|_| motion), assembly)
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
        black_box(lifted).solve_position(Row::from_fn(|_| input), assembly)
    });
}

fn operations<M: Mechanism>() -> usize {
    M::DESCRIPTION.operations.iter().map(Operations::arithmetic).sum()
}

fn orders() {
    let mut race = Race::new(POSES);
    macro_rules! generated {
        ($($mechanism:ident $order:literal $length:literal;)+) => {
            $(
                enter(&mut race, format!("order_{}.generated", $order), four_bar::<$mechanism>());
                enter_carried::<_, Series<$length>>(
                    &mut race, format!("order_{}.series", $order), four_bar::<$mechanism>());
                println!("operations order_{} {}", $order, operations::<$mechanism>());
            )+
        };
    }
    macro_rules! nested {
        ($($mechanism:ident $order:literal $number:ident;)+) => {
            $(enter_carried::<_, $number>(
                &mut race, format!("order_{}.nested_dual_numbers", $order), four_bar::<$mechanism>());)+
        };
    }
    generated! {
        FourBar1 1 2;
        FourBar2 2 3;
        FourBar3 3 4;
        FourBar4 4 5;
        FourBar5 5 6;
        FourBar6 6 7;
        FourBar7 7 8;
        FourBar8 8 9;
        FourBar9 9 10;
        FourBar10 10 11;
    }
    nested! {
        FourBar1 1 Nested1;
        FourBar2 2 Nested2;
        FourBar3 3 Nested3;
        FourBar4 4 Nested4;
        FourBar5 5 Nested5;
        FourBar6 6 Nested6;
    }
    let times = race.run();
    for order in 2..=10 {
        times.ratio(&format!("order_{order}.generated"), "order_1.generated");
    }
    for order in 1..=10 {
        times.ratio(&format!("order_{order}.series"), &format!("order_{order}.generated"));
    }
    for order in 1..=6 {
        times.ratio(
            &format!("order_{order}.nested_dual_numbers"),
            &format!("order_{order}.generated"),
        );
    }
}

fn loops() {
    let mut race = Race::new(POSES);
    macro_rules! chains {
        ($($mechanism:ident $loops:literal;)+) => {
            $(
                enter(&mut race, format!("loops_{}.generated", $loops), chains::chain::<$mechanism>());
                enter_carried::<_, Series<5>>(
                    &mut race, format!("loops_{}.series", $loops), chains::chain::<$mechanism>());
                enter_carried::<_, Nested4>(
                    &mut race, format!("loops_{}.nested_dual_numbers", $loops), chains::chain::<$mechanism>());
                println!("operations loops_{} {}", $loops, operations::<$mechanism>());
            )+
        };
    }
    chains! {
        Chain1 1;
        Chain2 2;
        Chain4 4;
        Chain8 8;
        Chain16 16;
    }
    let times = race.run();
    for loops in [2, 4, 8, 16] {
        times.ratio(&format!("loops_{loops}.generated"), "loops_1.generated");
    }
    for loops in [1, 2, 4, 8, 16] {
        for other in ["series", "nested_dual_numbers"] {
            times.ratio(&format!("loops_{loops}.{other}"), &format!("loops_{loops}.generated"));
        }
    }
}

fn main() {
    orders();
    loops();
}
