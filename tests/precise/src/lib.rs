//! Numbers of 77 digits, for the reference that kin is held against.
//!
//! A crate of its own, as the arithmetic underneath is generic: it is compiled here, once, with optimisation even where
//! the tests are compiled without.

use std::cell::RefCell;
use std::collections::HashMap;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_float::round::mode::HalfEven;
use dashu_float::{ConstCache, Context, FBig};

type Float = FBig<HalfEven, 2>;

/// The precision in binary digits.
pub const BITS: usize = 256;

const CONTEXT: Context<HalfEven> = Context::new(BITS);

/// How many angles are remembered with their sine and cosine.
const REMEMBERED: usize = 4096;

/// A key that is the same for two angles only if every digit is.
type Digits = String;

thread_local! {
    static CONSTANTS: RefCell<ConstCache> = const { RefCell::new(ConstCache::new()) };
    static SINES: RefCell<HashMap<Digits, (Number, Number)>> = RefCell::new(HashMap::new());
}

/// A real number, rounded to [`BITS`] binary digits after every operation.
#[derive(Clone, PartialEq)]
pub struct Number(Float);

impl Number {
    /// Zero.
    #[must_use]
    pub fn zero() -> Self {
        Self::exactly(0.0)
    }

    /// The number itself: every finite `f64` is one.
    ///
    /// # Panics
    /// If it is infinite or not a number.
    #[must_use]
    pub fn exactly(value: f64) -> Self {
        let value = Float::try_from(value).expect("a finite number");
        Self(value.with_precision(BITS).value())
    }

    /// The ratio of the circle's circumference to its diameter.
    #[must_use]
    pub fn pi() -> Self {
        Self(
            CONSTANTS
                .with_borrow_mut(|constants| CONTEXT.pi(Some(constants)))
                .value(),
        )
    }

    /// The nearest `f64`.
    #[must_use]
    pub fn nearest(&self) -> f64 {
        self.0.to_f64().value()
    }

    /// The number times a power of two, exactly.
    #[must_use]
    pub fn doubled(&self, times: i16) -> Self {
        let times = isize::from(times);
        let own = self.0.clone();
        Self(if times < 0 { own >> -times } else { own << times })
    }

    /// Without its sign.
    #[must_use]
    pub fn abs(&self) -> Self {
        if self.0 < Float::ZERO { -self } else { self.clone() }
    }

    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0.repr().is_pos_zero() || self.0.repr().is_neg_zero()
    }

    /// The non-negative square root.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        Self(self.0.sqrt())
    }

    /// Sine and cosine, in this order.
    ///
    /// # Panics
    /// Never for a finite angle.
    #[must_use]
    pub fn sin_cos(&self) -> (Self, Self) {
        if self.is_zero() {
            return (Self::zero(), Self::exactly(1.0));
        }
        let key = format!("{:?}", self.0.repr());
        if let Some(known) = SINES.with_borrow(|known| known.get(&key).cloned()) {
            return known;
        }
        let (sine, cosine) = CONSTANTS.with_borrow_mut(|constants| CONTEXT.sin_cos(self.0.repr(), Some(constants)));
        let both = (
            Self(sine.expect("a finite angle").value()),
            Self(cosine.expect("a finite angle").value()),
        );
        SINES.with_borrow_mut(|known| {
            if known.len() >= REMEMBERED {
                known.clear();
            }
            known.insert(key, both.clone());
        });
        both
    }

    /// The angle of the point (`x`, `self`).
    ///
    /// # Panics
    /// If both are zero.
    #[must_use]
    pub fn atan2(&self, x: &Self) -> Self {
        let angle = CONSTANTS.with_borrow_mut(|constants| CONTEXT.atan2(self.0.repr(), x.0.repr(), Some(constants)));
        Self(angle.expect("a point beside the origin").value())
    }

    /// Hyperbolic sine and cosine, in this order.
    #[must_use]
    pub fn sinh_cosh(&self) -> (Self, Self) {
        let (sine, cosine) = self.0.sinh_cosh();
        (Self(sine), Self(cosine))
    }

    /// The hyperbolic tangent.
    #[must_use]
    pub fn tanh(&self) -> Self {
        Self(self.0.tanh())
    }

    /// The number with this hyperbolic sine.
    #[must_use]
    pub fn asinh(&self) -> Self {
        Self(self.0.asinh())
    }

    /// The number from 0 on with this hyperbolic cosine.
    ///
    /// # Panics
    /// Below 1.
    #[must_use]
    pub fn acosh(&self) -> Self {
        Self(self.0.acosh())
    }

    /// The number with this hyperbolic tangent.
    ///
    /// # Panics
    /// If it does not lie between -1 and 1.
    #[must_use]
    pub fn atanh(&self) -> Self {
        Self(self.0.atanh())
    }

    /// The exponential function.
    #[must_use]
    pub fn exp(&self) -> Self {
        Self(self.0.exp())
    }

    /// The natural logarithm.
    #[must_use]
    pub fn ln(&self) -> Self {
        Self(self.0.ln())
    }
}

impl fmt::Debug for Number {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}", self.0.to_decimal().value())
    }
}

impl Neg for &Number {
    type Output = Number;

    fn neg(self) -> Number {
        Number(-&self.0)
    }
}

macro_rules! operation {
    ($trait:ident $method:ident) => {
        impl $trait for &Number {
            type Output = Number;

            fn $method(self, other: Self) -> Number {
                Number($trait::$method(&self.0, &other.0))
            }
        }
    };
}

operation!(Add add);
operation!(Sub sub);
operation!(Mul mul);
operation!(Div div);

#[cfg(test)]
mod tests {
    use super::Number;

    fn digits(number: &Number, expected: &str) {
        let found = format!("{number:?}");
        assert!(found.starts_with(expected), "{found}\n{expected}");
    }

    fn same(one: &Number, other: &Number) {
        let difference = (one - other).nearest();
        assert!(difference.abs() < 1e-74, "{one:?} {other:?}");
    }

    /// Fifty digits of constants, from the On-Line Encyclopedia of Integer Sequences: A000796, A049469, A049470,
    /// A002193, A001113, A002162, A073742, A073743, A073744, A091648.
    #[test]
    fn constants() {
        let one = Number::exactly(1.0);
        let two = Number::exactly(2.0);
        digits(&Number::pi(), "3.14159265358979323846264338327950288419716939937510");
        digits(&one.sin_cos().0, "0.84147098480789650665250232163029899962256306079837");
        digits(&one.sin_cos().1, "0.54030230586813971740093660744297660373231042061792");
        digits(&two.sqrt(), "1.41421356237309504880168872420969807856967187537694");
        digits(&one.exp(), "2.71828182845904523536028747135266249775724709369995");
        digits(
            &one.sinh_cosh().0,
            "1.17520119364380145688238185059560081515571798133409",
        );
        digits(
            &one.sinh_cosh().1,
            "1.54308063481524377847790562075706168260152911236586",
        );
        digits(&one.tanh(), "0.76159415595576488811945828260479359041276859725793");
        digits(&one.asinh(), "0.88137358701954302523260932497979230902816032826163");
        digits(&two.ln(), "0.69314718055994530941723212145817656807550013436025");
    }

    #[test]
    fn identities() {
        for value in [1e-9, 0.1, 1.0, 2.5, -3.0, 1e6] {
            let angle = Number::exactly(value);
            let (sine, cosine) = angle.sin_cos();
            same(&(&(&sine * &sine) + &(&cosine * &cosine)), &Number::exactly(1.0));
            // an angle of half a turn at most comes back
            if value.abs() < 3.1 {
                same(&sine.atan2(&cosine), &angle);
            }
        }
        let quarter = Number::exactly(3.0).atan2(&Number::exactly(3.0));
        same(&quarter.doubled(2), &Number::pi());
        same(&Number::zero().atan2(&Number::exactly(-2.0)), &Number::pi());
        assert_eq!(Number::exactly(0.1).nearest(), 0.1);
        assert_eq!(Number::exactly(-3.0).abs().doubled(-1).nearest(), 1.5);
        assert!((&Number::exactly(0.1) - &Number::exactly(0.1)).is_zero());
    }

    /// The hyperbolic functions are those of the exponential function, which lose digits near zero only.
    #[test]
    fn hyperbolic_identities() {
        for value in [1e-9, 0.1, 1.0, 2.5, -3.0, 20.0] {
            let argument = Number::exactly(value);
            let (sine, cosine) = argument.sinh_cosh();
            let (growth, decay) = (argument.exp(), (-&argument).exp());
            let size = growth.nearest().max(decay.nearest()).powi(2);
            let near = |one: &Number, other: &Number, condition: f64| {
                let difference = (one - other).nearest();
                assert!(
                    difference.abs() < 1e-74 * size * condition,
                    "{value}: {one:?} {other:?}"
                );
            };
            let same = |one: &Number, other: &Number| near(one, other, 1.0);
            same(&sine, &(&growth - &decay).doubled(-1));
            same(&cosine, &(&growth + &decay).doubled(-1));
            same(&(&argument.tanh() * &cosine), &sine);
            same(&sine.asinh(), &argument);
            // a change of the cosine is divided by the sine
            near(&cosine.acosh(), &argument.abs(), 1.0 / sine.nearest().abs().min(1.0));
            same(&argument.tanh().atanh(), &argument);
        }
        // the cube of a small number, all digits of it
        let small = Number::exactly(1e-20);
        let cube = &(&small * &small) * &small;
        let rest = &(&small.sinh_cosh().0 - &small) * &Number::exactly(6.0);
        assert!(((&rest / &cube).nearest() - 1.0).abs() < 1e-15);
    }

    /// A tenth, a power that underflows an `f64`, and nothing lost.
    #[test]
    fn small_numbers_stay() {
        let small = Number::exactly(1e-300);
        let smaller = &small * &small;
        assert!(!smaller.is_zero());
        same(&(&smaller / &small).doubled(0), &small);
    }
}
