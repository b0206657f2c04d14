//! Operation counts of a solver, measured by running it.

use core::cell::Cell;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::number::{Number, Operations};

std::thread_local! {
    static TALLY: Cell<Operations> = const { Cell::new(Operations::NONE) };
}

#[derive(Clone, Copy)]
enum Tallied {
    Addition,
    Multiplication,
    Division,
    Negation,
    SquareRoot,
    SineCosine,
    ArcTangent,
    Other,
}

/// Adds one operation to the count of this thread.
fn note(kind: Tallied) {
    let mut tally = TALLY.get();
    *match kind {
        Tallied::Addition => &mut tally.additions,
        Tallied::Multiplication => &mut tally.multiplications,
        Tallied::Division => &mut tally.divisions,
        Tallied::Negation => &mut tally.negations,
        Tallied::SquareRoot => &mut tally.square_roots,
        Tallied::SineCosine => &mut tally.sine_cosines,
        Tallied::ArcTangent => &mut tally.arc_tangents,
        Tallied::Other => &mut tally.others,
    } += 1;
    TALLY.set(tally);
}

/// Returns the number of operations on [`Counted`] numbers that this thread carries out while it runs `work`. The
/// result of `work` is dropped.
///
/// ```
/// use kin_core::count::{self, Counted};
///
/// let tally = count::of(|| Counted::new(3.0) * Counted::new(4.0) - Counted::new(1.0));
/// assert_eq!((tally.multiplications, tally.additions), (1, 1));
/// assert_eq!(tally.arithmetic(), 2);
/// ```
pub fn of<R>(work: impl FnOnce() -> R) -> Operations {
    let before = TALLY.get();
    drop(work());
    since(TALLY.get(), before)
}

/// The operations counted since an earlier tally.
const fn since(now: Operations, earlier: Operations) -> Operations {
    Operations {
        additions: now.additions - earlier.additions,
        multiplications: now.multiplications - earlier.multiplications,
        divisions: now.divisions - earlier.divisions,
        negations: now.negations - earlier.negations,
        square_roots: now.square_roots - earlier.square_roots,
        sine_cosines: now.sine_cosines - earlier.sine_cosines,
        arc_tangents: now.arc_tangents - earlier.arc_tangents,
        others: now.others - earlier.others,
    }
}

/// A double-precision number that counts the operations on it; see [`of`].
///
/// Constants, comparisons and copies count nothing.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Counted(f64);

impl Counted {
    /// The number `value`.
    #[must_use]
    pub const fn new(value: f64) -> Self {
        Self(value)
    }

    /// The number itself.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }
}

impl From<f64> for Counted {
    fn from(value: f64) -> Self {
        Self(value)
    }
}

impl Add for Counted {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        note(Tallied::Addition);
        Self(self.0 + other.0)
    }
}

impl Sub for Counted {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        note(Tallied::Addition);
        Self(self.0 - other.0)
    }
}

impl Mul for Counted {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        note(Tallied::Multiplication);
        Self(self.0 * other.0)
    }
}

impl Div for Counted {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        note(Tallied::Division);
        Self(self.0 / other.0)
    }
}

impl Neg for Counted {
    type Output = Self;

    fn neg(self) -> Self {
        note(Tallied::Negation);
        Self(-self.0)
    }
}

impl Number for Counted {
    const EPSILON: f64 = f64::EPSILON;

    fn constant(value: f64) -> Self {
        Self(value)
    }

    fn real(self) -> f64 {
        self.0
    }

    fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    fn sqrt(self) -> Self {
        note(Tallied::SquareRoot);
        Self(self.0.sqrt())
    }

    fn sin_cos(self) -> (Self, Self) {
        note(Tallied::SineCosine);
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }

    fn asin(self) -> Self {
        note(Tallied::Other);
        Self(self.0.asin())
    }

    fn acos(self) -> Self {
        note(Tallied::Other);
        Self(self.0.acos())
    }

    fn atan(self) -> Self {
        note(Tallied::ArcTangent);
        Self(self.0.atan())
    }

    fn atan2(self, x: Self) -> Self {
        note(Tallied::ArcTangent);
        Self(self.0.atan2(x.0))
    }

    fn sinh(self) -> Self {
        note(Tallied::Other);
        Self(Number::sinh(self.0))
    }

    fn cosh(self) -> Self {
        note(Tallied::Other);
        Self(Number::cosh(self.0))
    }

    fn tanh(self) -> Self {
        note(Tallied::Other);
        Self(Number::tanh(self.0))
    }

    fn asinh(self) -> Self {
        note(Tallied::Other);
        Self(Number::asinh(self.0))
    }

    fn acosh(self) -> Self {
        note(Tallied::Other);
        Self(Number::acosh(self.0))
    }

    fn atanh(self) -> Self {
        note(Tallied::Other);
        Self(Number::atanh(self.0))
    }

    fn exp(self) -> Self {
        note(Tallied::Other);
        Self(self.0.exp())
    }

    fn ln(self) -> Self {
        note(Tallied::Other);
        Self(self.0.ln())
    }
}

#[cfg(test)]
mod tests {
    use super::{Counted, of};
    use crate::number::{Number, Operations};

    #[test]
    fn every_operation_counts_once() {
        let tally = of(|| {
            let x = Counted::new(0.5);
            let (sine, cosine) = x.sin_cos();
            let _ = -(sine + cosine - x * x / x);
            let _ = (x.sqrt(), x.atan(), x.atan2(x));
            let _ = (x.asin(), x.acos(), x.exp(), x.ln());
            let _ = (x.sinh(), x.cosh(), x.tanh(), x.asinh(), x.acosh(), x.atanh());
        });
        let expected = Operations {
            additions: 2,
            multiplications: 1,
            divisions: 1,
            negations: 1,
            square_roots: 1,
            sine_cosines: 1,
            arc_tangents: 2,
            others: 10,
        };
        assert_eq!(tally, expected);
        assert_eq!(tally.arithmetic(), 5);
    }

    #[test]
    fn counts_nest() {
        let x = Counted::new(0.5);
        let outer = of(|| {
            let _ = x + x;
            assert_eq!(of(|| x * x).arithmetic(), 1);
        });
        assert_eq!(outer.arithmetic(), 2);
    }
}
