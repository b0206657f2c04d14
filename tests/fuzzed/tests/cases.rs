//! Mechanisms that were found at random and solved wrongly once.
#![allow(missing_docs)]

use kin_core::prelude::*;
use kin_core::verify;

// the difference of the first equation's quotient and u holds no u once it is multiplied out
mechanism! {
    pub struct Cancelling { a: Length, b: Length }
    input t: Angle;
    unknown u: Angle, w: Angle;
    (b + a * u) / a - u + w == t;
    u * u + w == t;
}

// the same, after s has been replaced by what the first equation says of it
mechanism! {
    pub struct CancellingLater { a: Length, b: Length }
    input t: Angle;
    unknown u: Angle, w: Angle, s: Length;
    b + a * u == s;
    w + s / a - u == t;
    u * w == s / a + t;
}

// u stands in a quotient of its own equation, after s has been replaced
mechanism! {
    pub struct WithinItself { a: Length, b: Length }
    input t: Angle;
    unknown u: Direction, v: Scalar, w: Angle, s: Length;
    s + a * u == b;
    s / a - t == v;
    v == w;
    u * v == PI;
}

#[test]
fn unknowns_that_cancel_are_not_waited_for() {
    verify::mechanism::<Cancelling>().assert();
    verify::mechanism::<CancellingLater>().assert();
    verify::mechanism::<WithinItself>().assert();
}
