//! The functions of a mechanism that a curve needs.

use crate::any::{AnyMechanism, ClosureOver, MotionNearOver};
use crate::mechanism::{First, Second};

/// The functions of a mechanism that a curve needs.
#[doc(hidden)]
pub trait CurveFunctions: AnyMechanism + MotionNearOver<f64> + ClosureOver<First> + ClosureOver<Second> {}

impl<F: AnyMechanism + MotionNearOver<f64> + ClosureOver<First> + ClosureOver<Second>> CurveFunctions for F {}
