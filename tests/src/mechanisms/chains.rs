//! Four-bar linkages in series, of 1 to 16 loops: what grows with the number of loops is measured on them.
#![allow(missing_docs, reason = "the names are numbered")]

use kin_core::prelude::*;

/// Four-bar linkages in series: the rocker of each is the crank of the next.
macro_rules! chain {
    ($name:ident: $crank:ident $theta:ident;
        $(($ground:ident $coupler:ident $rocker:ident $phi:ident $psi:ident))+) => {
        chain! { @loops $name $crank $theta [$($ground $coupler $rocker)+] [$($phi $psi)+] [] $crank $theta;
            $(($ground $coupler $rocker $phi $psi))+ }
    };
    (@loops $name:ident $crank:ident $theta:ident [$($parameter:ident)+] [$($unknown:ident)+] [$($equation:tt)*]
        $before:ident $angle:ident;
        ($ground:ident $coupler:ident $rocker:ident $phi:ident $psi:ident) $($rest:tt)*) => {
        chain! { @loops $name $crank $theta [$($parameter)+] [$($unknown)+] [
            $($equation)*
            $before * cis($angle) + $coupler * cis($phi) == $ground + $rocker * cis($psi);
        ] $rocker $psi; $($rest)* }
    };
    (@loops $name:ident $crank:ident $theta:ident [$($parameter:ident)+] [$($unknown:ident)+] [$($equation:tt)*]
        $before:ident $angle:ident;) => {
        kin_core::mechanism! {
            pub struct $name { pub $crank: Length, $(pub $parameter: Length),+ }
            input $theta: Angle;
            unknown $($unknown: Angle),+;
            $($equation)*
        }
    };
}

chain! {
    Chain1: crank theta;
    (g1 c1 r1 p1 q1)
}

chain! {
    Chain2: crank theta;
    (g1 c1 r1 p1 q1) (g2 c2 r2 p2 q2)
}

chain! {
    Chain4: crank theta;
    (g1 c1 r1 p1 q1) (g2 c2 r2 p2 q2) (g3 c3 r3 p3 q3) (g4 c4 r4 p4 q4)
}

chain! {
    Chain8: crank theta;
    (g1 c1 r1 p1 q1) (g2 c2 r2 p2 q2) (g3 c3 r3 p3 q3) (g4 c4 r4 p4 q4)
    (g5 c5 r5 p5 q5) (g6 c6 r6 p6 q6) (g7 c7 r7 p7 q7) (g8 c8 r8 p8 q8)
}

chain! {
    Chain16: crank theta;
    (g1 c1 r1 p1 q1) (g2 c2 r2 p2 q2) (g3 c3 r3 p3 q3) (g4 c4 r4 p4 q4)
    (g5 c5 r5 p5 q5) (g6 c6 r6 p6 q6) (g7 c7 r7 p7 q7) (g8 c8 r8 p8 q8)
    (g9 c9 r9 p9 q9) (g10 c10 r10 p10 q10) (g11 c11 r11 p11 q11) (g12 c12 r12 p12 q12)
    (g13 c13 r13 p13 q13) (g14 c14 r14 p14 q14) (g15 c15 r15 p15 q15) (g16 c16 r16 p16 q16)
}

/// The first crank.
pub const CRANK: f64 = 1.0;

/// Ground, coupler and rocker of a loop: first a crank and a rocker that swings by less than a turn; then rockers that
/// drive rockers, turn about a little ahead and behind.
#[must_use]
pub const fn dimensions(index: usize) -> [f64; 3] {
    match index {
        0 => [4.0, 3.0, 2.5],
        _ if index.is_multiple_of(2) => [4.0, 3.9, 2.5],
        _ => [4.0, 4.1, 2.5],
    }
}

/// A chain of these dimensions.
#[must_use]
pub fn chain<M: Mechanism<Scalar = f64>>() -> M {
    M::from_parameters(M::Parameters::from_fn(|index| match index {
        0 => CRANK,
        _ => dimensions((index - 1) / 3)[(index - 1) % 3],
    }))
}
