//! The checks of the sign of a number.

use crate::solve::Scalar;
use crate::solve::check::{Check, Real};

macro_rules! sign {
    ($(#[doc = $doc:literal] $visibility:vis $name:ident, $words:literal: |$number:ident| $holds:expr, $margin:expr;)+) => {
        $(
            #[doc = $doc]
            #[derive(Clone, Copy, Debug)]
            $visibility struct $name<T>(pub T);

            impl<T: Scalar> Check<T, 1, 1> for $name<T> {
                fn name(&self) -> &'static str {
                    $words
                }

                #[cfg_attr(not(debug_assertions), inline(always))]
                fn operands(&self) -> [T; 1] {
                    [self.0]
                }

                #[cfg_attr(not(debug_assertions), inline(always))]
                fn holds<R: Real>(&self, [$number]: [R; 1]) -> [R::Truth; 1] {
                    [$holds]
                }

                fn margin(&self) -> T {
                    let $number = self.0;
                    $margin
                }
            }
        )+
    };
}

sign! {
    /// Whether a number is less than zero.
    pub Negative, "negative number": |number| number.is_below(R::of(0.0)), -number;
    /// Whether a number is zero or more.
    pub(in crate::solve) NotNegative, "number that is not negative": |number| number.is_at_least(R::of(0.0)), number;
    /// Whether a number is zero.
    pub(in crate::solve) Zero, "zero": |number| number.equals(R::of(0.0)), crate::solve::doubt::size(number) * T::constant(-1.0);
}
