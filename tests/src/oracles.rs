//! The oracles of [`kin_core::verify`], as these tests use them: through snap, each on poses of its own choosing.

use kin_core::prelude::*;
use kin_core::verify::{self, allowed};

use crate::samples;
pub use kin_core::verify::{Gauge, Worst};

/// Motions of the unknowns through snap.
pub type Motions<M> = <M as Mechanism>::Unknowns<Motion<f64, 5>>;

/// How many units of error are allowed, order by order.
pub const ALLOWED: [f64; 5] = [allowed(0), allowed(1), allowed(2), allowed(3), allowed(4)];

/// The use that is made of the worst errors.
pub trait Reported {
    /// Prints the worst errors and asserts that they are small multiples of the unit.
    ///
    /// # Panics
    /// If one is not, or if there were hardly any poses.
    fn report(&self, name: &str);
}

impl Reported for verify::Worst {
    fn report(&self, name: &str) {
        println!("{name}, {} poses\n{self}", self.poses);
        assert!(self.poses > samples::of(50), "{name}: only {} poses", self.poses);
        assert!(self.is_allowed(), "{name}\n{self}\n{:?}", self.finding);
    }
}
