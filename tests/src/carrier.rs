//! Numbers that carry time derivatives through a position solver.

use kin_core::count::{self, Counted};
use kin_core::series::Series;
use kin_core::{Mechanism, Row, Scalar};
use num_dual::{Dual, DualNum};

use crate::nested::Nested;

/// A number made of a value and as many time derivatives as it carries.
pub trait Carrier: Scalar {
    /// From a value and its derivatives, in ascending order; there may be more than are needed.
    fn carry(derivatives: &[f64]) -> Self;
}

impl Carrier for f64 {
    fn carry(derivatives: &[f64]) -> Self {
        derivatives[0]
    }
}

impl Carrier for Counted {
    fn carry(derivatives: &[f64]) -> Self {
        Self::new(derivatives[0])
    }
}

impl<const N: usize> Carrier for Series<N> {
    fn carry(derivatives: &[f64]) -> Self {
        Self::from_derivatives(core::array::from_fn(|order| derivatives[order]))
    }
}

impl<T: Carrier + DualNum<Primitive = f64>> Carrier for Dual<T> {
    fn carry(derivatives: &[f64]) -> Self {
        Self::new(T::carry(derivatives), T::carry(&derivatives[1..]))
    }
}

impl<T: Carrier> Carrier for Nested<T> {
    fn carry(derivatives: &[f64]) -> Self {
        Self::new(T::carry(derivatives), T::carry(&derivatives[1..]))
    }
}

/// The additions, multiplications, divisions and changes of sign by which a position solver carries derivatives of the
/// only input along, in the first assembly.
///
/// # Panics
/// Where the mechanism does not close.
#[must_use]
pub fn operations<M: Mechanism<Scalar = f64>, S: Carrier>(mechanism: &M, input: &[f64]) -> usize {
    let assembly = M::assembly(0).expect("there are assemblies");
    let (lifted, input) = (mechanism.convert(S::constant), S::carry(input));
    let solve = || {
        let pose = lifted.position(Row::from_fn(|_| input), assembly);
        assert!(pose.is_ok(), "{} does not close", M::DESCRIPTION.name);
    };
    count::of(solve).arithmetic()
}
