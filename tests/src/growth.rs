//! Growth with the order and with the number of loops: operations of the generated solvers, and of nested
//! differentiation.
#![allow(missing_docs, reason = "the mechanisms are numbered")]

use kin_core::count::Counted;
use kin_core::{Mechanism, Operations, Row};

use crate::carrier::{self, Carrier};
use crate::mechanisms::chains::{self, Chain1, Chain2, Chain4, Chain8, Chain16};
use crate::nested::Nested;

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

/// A crank-rocker.
#[must_use]
pub fn four_bar<M: Mechanism<Scalar = f64>>() -> M {
    let dimensions = [4.0, 1.0, 3.0, 2.5];
    M::from_parameters(M::Parameters::from_fn(|index| dimensions[index]))
}

/// Additions, multiplications, divisions and changes of sign, from the position through the highest order.
#[derive(Clone, Copy, Debug)]
pub struct Counts {
    /// The highest order, or the number of loops.
    pub step: usize,
    /// Operations of the generated solvers.
    pub generated: usize,
    /// Operations of the position solver, run on nested dual numbers.
    pub nested: usize,
}

impl Counts {
    fn of<M: Mechanism<Scalar = f64>, S: Carrier>(step: usize, mechanism: &M) -> Self {
        // counts do not depend on the motion, but on the number of its derivatives
        let motion = [0.7, 0.5, -0.3, 0.2, 0.4, -0.1, 0.3, 0.6, -0.2, 0.1, 0.5];
        Self {
            step,
            generated: M::DESCRIPTION.operations.iter().map(Operations::arithmetic).sum(),
            nested: carrier::operations::<M, S>(mechanism, &motion),
        }
    }
}

type Nested1 = Nested<Counted>;
type Nested2 = Nested<Nested1>;
type Nested3 = Nested<Nested2>;
type Nested4 = Nested<Nested3>;
type Nested5 = Nested<Nested4>;
type Nested6 = Nested<Nested5>;
type Nested7 = Nested<Nested6>;
type Nested8 = Nested<Nested7>;
type Nested9 = Nested<Nested8>;
type Nested10 = Nested<Nested9>;

/// Of the four-bar linkage, by its order.
///
/// # Panics
/// If there is no memory for the stack: the numbers of the highest orders have a thousand parts.
#[must_use]
pub fn by_order() -> Vec<Counts> {
    std::thread::Builder::new()
        .stack_size(1 << 26)
        .spawn(through_each_order)
        .expect("a thread")
        .join()
        .expect("nothing panics")
}

fn through_each_order() -> Vec<Counts> {
    vec![
        Counts::of::<_, Nested1>(1, &four_bar::<FourBar1>()),
        Counts::of::<_, Nested2>(2, &four_bar::<FourBar2>()),
        Counts::of::<_, Nested3>(3, &four_bar::<FourBar3>()),
        Counts::of::<_, Nested4>(4, &four_bar::<FourBar4>()),
        Counts::of::<_, Nested5>(5, &four_bar::<FourBar5>()),
        Counts::of::<_, Nested6>(6, &four_bar::<FourBar6>()),
        Counts::of::<_, Nested7>(7, &four_bar::<FourBar7>()),
        Counts::of::<_, Nested8>(8, &four_bar::<FourBar8>()),
        Counts::of::<_, Nested9>(9, &four_bar::<FourBar9>()),
        Counts::of::<_, Nested10>(10, &four_bar::<FourBar10>()),
    ]
}

/// Of four-bar linkages in series through snap, by their number.
#[must_use]
pub fn by_loops() -> Vec<Counts> {
    vec![
        Counts::of::<_, Nested4>(1, &chains::chain::<Chain1>()),
        Counts::of::<_, Nested4>(2, &chains::chain::<Chain2>()),
        Counts::of::<_, Nested4>(4, &chains::chain::<Chain4>()),
        Counts::of::<_, Nested4>(8, &chains::chain::<Chain8>()),
        Counts::of::<_, Nested4>(16, &chains::chain::<Chain16>()),
    ]
}
