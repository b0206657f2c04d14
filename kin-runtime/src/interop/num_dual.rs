//! The dual numbers of num-dual as scalars: derivatives of any order by automatic differentiation.

use num_dual::{Dual, Dual2, Dual3, DualNum, DualNumFloat, HyperDual, HyperHyperDual};

use crate::number::Number;
use crate::solve::Scalar;

macro_rules! dual_scalar {
    ($($dual:ident: $order:literal, $($part:ident)+;)+) => {
        $(
            impl<T, F> Number for $dual<T>
            where
                T: Number + DualNum<Primitive = F>,
                F: DualNumFloat,
            {
                const EPSILON: f64 = T::EPSILON;
                const SMALLEST_DIVISOR: f64 = T::SMALLEST_DIVISOR;
                const ORDER: usize = $order + T::ORDER;

                #[inline]
                fn constant(value: f64) -> Self {
                    Self::from_re(T::constant(value))
                }

                #[inline]
                fn real(self) -> f64 {
                    self.re.real()
                }

                #[inline]
                fn is_finite(self) -> bool {
                    Number::is_finite(self.re) $(&& Number::is_finite(self.$part))+
                }

                #[inline]
                fn sqrt(self) -> Self {
                    DualNum::sqrt(&self)
                }

                #[inline]
                fn sin_cos(self) -> (Self, Self) {
                    DualNum::sin_cos(&self)
                }

                #[inline]
                fn asin(self) -> Self {
                    DualNum::asin(&self)
                }

                #[inline]
                fn acos(self) -> Self {
                    DualNum::acos(&self)
                }

                #[inline]
                fn atan(self) -> Self {
                    DualNum::atan(&self)
                }

                // num-dual divides by `x` for the derivatives, so they are NaN on the y axis. The angle from the nearer
                // axis has the same derivatives; only its real part must be corrected.
                #[inline]
                fn atan2(self, x: Self) -> Self {
                    let y = self;
                    let mut angle = if Number::real(y).abs() <= Number::real(x).abs() {
                        DualNum::atan(&(y / x))
                    } else {
                        -DualNum::atan(&(x / y))
                    };
                    angle.re = Number::atan2(y.re, x.re);
                    angle
                }

                #[inline]
                fn sinh(self) -> Self {
                    DualNum::sinh(&self)
                }

                #[inline]
                fn cosh(self) -> Self {
                    DualNum::cosh(&self)
                }

                // num-dual divides the hyperbolic sine by the cosine, and it calls the inverses of the standard
                // library, which lose digits. Only the real parts must be corrected.
                #[inline]
                fn tanh(self) -> Self {
                    Self { re: Number::tanh(self.re), ..DualNum::tanh(&self) }
                }

                #[inline]
                fn asinh(self) -> Self {
                    DualNum::asinh(&self)
                }

                #[inline]
                fn acosh(self) -> Self {
                    Self { re: Number::acosh(self.re), ..DualNum::acosh(&self) }
                }

                #[inline]
                fn atanh(self) -> Self {
                    Self { re: Number::atanh(self.re), ..DualNum::atanh(&self) }
                }

                #[inline]
                fn exp(self) -> Self {
                    DualNum::exp(&self)
                }

                #[inline]
                fn ln(self) -> Self {
                    DualNum::ln(&self)
                }
            }

            impl<T, F> Scalar for $dual<T>
            where
                T: Scalar + DualNum<Primitive = F>,
                F: DualNumFloat,
            {
            }
        )+
    };
}

dual_scalar! {
    Dual: 1, eps;
    Dual2: 2, v1 v2;
    Dual3: 3, v1 v2 v3;
    HyperDual: 2, eps1 eps2 eps1eps2;
    HyperHyperDual: 3, eps1 eps2 eps3 eps1eps2 eps1eps3 eps2eps3 eps1eps2eps3;
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use super::{Dual, Dual2, Dual3, HyperDual, HyperHyperDual};
    use crate::assembly::Assembly;
    use crate::geometry::Plane;
    use crate::number::{Number, series::Series};
    use crate::solve::{self, Scalar};

    type Nested = HyperDual<HyperDual<f64>>;
    type Mixed = Dual<Dual3<f64>>;

    /// A function of time as each number type represents it, from its value and four derivatives.
    fn nested(d: [f64; 5]) -> Nested {
        // With two steps e1, e2 inside and two f1, f2 outside, every subset of k steps holds the k-th derivative.
        let inner = |k: usize| HyperDual::new(d[k], d[k + 1], d[k + 1], d[k + 2]);
        HyperDual::new(inner(0), inner(1), inner(1), inner(2))
    }

    fn mixed(d: [f64; 5]) -> Mixed {
        Dual::new(Dual3::new(d[0], d[1], d[2], d[3]), Dual3::new(d[1], d[2], d[3], d[4]))
    }

    fn check(name: &str, actual: [f64; 5], expected: [f64; 5]) {
        for (order, (actual, expected)) in actual.into_iter().zip(expected).enumerate() {
            assert!(
                (actual - expected).abs() <= 1e-11 * (1.0 + expected.abs()),
                "{name}, order {order}: {actual} instead of {expected}"
            );
        }
    }

    /// The same program run on series and on nested duals must give the same derivatives.
    macro_rules! agree {
        ($name:expr, $function:expr, $($argument:expr),+) => {{
            let expected = $function($(Series::from_derivatives($argument)),+).derivatives();
            let n: Nested = $function($(nested($argument)),+);
            check(
                concat!($name, " nested"),
                [n.re.re, n.re.eps2, n.eps1.eps1, n.eps1.eps1eps2, n.eps1eps2.eps1eps2],
                expected,
            );
            let m: Mixed = $function($(mixed($argument)),+);
            check(
                concat!($name, " mixed"),
                [m.re.re, m.re.v1, m.re.v2, m.eps.v2, m.eps.v3],
                expected,
            );
            assert!(Number::is_finite(n) && Number::is_finite(m));
        }};
    }

    const X: [f64; 5] = [0.4, -0.7, 1.3, 0.2, -2.1];
    const Y: [f64; 5] = [0.9, 0.3, -0.4, 1.1, 0.5];

    #[test]
    fn arithmetic_and_functions_agree_with_series() {
        agree!("product", |x, y| x * y, X, Y);
        agree!("quotient", |x, y| x / y, X, Y);
        agree!("sqrt", Number::sqrt, X);
        agree!("sin", |x| Number::sin_cos(x).0, X);
        agree!("cos", |x| Number::sin_cos(x).1, X);
        agree!("asin", Number::asin, X);
        agree!("acos", Number::acos, X);
        agree!("atan", Number::atan, X);
        agree!("sinh", Number::sinh, X);
        agree!("cosh", Number::cosh, X);
        agree!("tanh", Number::tanh, X);
        agree!("asinh", Number::asinh, X);
        agree!("acosh", Number::acosh, [1.4, -0.7, 1.3, 0.2, -2.1]);
        agree!("atanh", Number::atanh, X);
        agree!("exp", Number::exp, X);
        agree!("ln", Number::ln, X);
    }

    #[test]
    fn exact_zeros_have_derivatives() {
        let zero = [0.0, 0.3, -0.4, 1.1, 0.5];
        agree!("product", |x, y| x * y, zero, zero);
        agree!("quotient", |x, y| x / y, zero, X);
        agree!("sin", |x| Number::sin_cos(x).0, zero);
        agree!("asin", Number::asin, zero);
        agree!("acos", Number::acos, zero);
        agree!("atan", Number::atan, zero);
        agree!("sinh", Number::sinh, zero);
        agree!("cosh", Number::cosh, zero);
        agree!("tanh", Number::tanh, zero);
        agree!("asinh", Number::asinh, zero);
        agree!("atanh", Number::atanh, zero);
        agree!("exp", Number::exp, zero);
    }

    #[test]
    fn arc_tangents_in_every_quadrant_and_on_the_axes() {
        let with = |value: f64, mut rates: [f64; 5]| {
            rates[0] = value;
            rates
        };
        for y in [-2.0, -0.5, 0.0, 0.5, 2.0] {
            for x in [-1.0, 0.0, 1.0] {
                if (x, y) != (0.0, 0.0) {
                    agree!("atan2", Number::atan2, with(y, Y), with(x, X));
                }
            }
        }
        // The fourth derivative of atan2(sin t, cos t) = t.
        let angle = Number::atan2(nested([0.0, -1.0, 0.0, 1.0, 0.0]), nested([-1.0, 0.0, 1.0, 0.0, -1.0]));
        check(
            "half a revolution",
            [
                angle.re.re,
                angle.re.eps1,
                angle.re.eps1eps2,
                angle.eps1.eps1eps2,
                angle.eps1eps2.eps1eps2,
            ],
            [PI, 1.0, 0.0, 0.0, 0.0],
        );
    }

    #[test]
    fn every_kind_of_dual_number_is_a_scalar() {
        // The derivatives of exp(sin t) at 0 are 1, 1, 1, 0.
        fn program<T: Scalar>(t: T) -> T {
            t.sin_cos().0.exp()
        }
        let dual = program(Dual::new(0.0, 1.0));
        assert_eq!((dual.re, dual.eps), (1.0, 1.0));
        let second = program(Dual2::new(0.0, 1.0, 0.0));
        assert_eq!(second.v2, 1.0);
        let third = program(Dual3::new(0.0, 1.0, 0.0, 0.0));
        assert_eq!(third.v3, 0.0);
        let hyper = program(HyperDual::new(0.0, 1.0, 1.0, 0.0));
        assert_eq!(hyper.eps1eps2, 1.0);
        let hyper = program(HyperHyperDual::new(0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0));
        assert_eq!(hyper.eps1eps2eps3, 0.0);
        assert_eq!(<Dual<f32> as Number>::EPSILON, f64::from(f32::EPSILON));
    }

    #[test]
    fn orders_add_up() {
        assert_eq!(<Dual<f64> as Number>::ORDER, 1);
        assert_eq!(<Dual2<f64> as Number>::ORDER, 2);
        assert_eq!(<Dual3<f64> as Number>::ORDER, 3);
        assert_eq!(<HyperDual<f32> as Number>::ORDER, 2);
        assert_eq!(<HyperHyperDual<f64> as Number>::ORDER, 3);
        assert_eq!(<Nested as Number>::ORDER, 4);
        assert_eq!(<Mixed as Number>::ORDER, 4);
    }

    #[test]
    fn newton_steps_differentiate() {
        fn angle<T: Scalar>(t: T) -> T {
            let half = T::constant(0.5);
            let root = solve::newton([T::constant(1.0)], [T::constant(1.0)], |[x]: [T; 1]| {
                let (sine, cosine) = x.sin_cos();
                ([x + half * sine - t], [[T::constant(1.0) + half * cosine]])
            });
            root.unwrap()[0]
        }
        agree!("x + sin(x) / 2 = t", angle, X);
        // Computing t from x restores the motion of t.
        let motion = nested(X);
        let [x] = solve::newton([Nested::constant(0.3)], [Number::constant(1.0)], |[x]: [Nested; 1]| {
            (
                [x * x * x + x - motion],
                [[x * x * Nested::constant(3.0) + Nested::constant(1.0)]],
            )
        })
        .unwrap();
        let back = x * x * x + x;
        check(
            "cubic",
            [
                back.re.re,
                back.re.eps2,
                back.eps1.eps1,
                back.eps1.eps1eps2,
                back.eps1eps2.eps1eps2,
            ],
            X,
        );
    }

    #[test]
    fn closed_forms_differentiate() {
        let x = [4.0, 0.5, -0.3, 0.2, 0.7];
        let y = [3.0, -0.2, 0.4, 0.1, -0.6];
        for assembly in Assembly::BOTH {
            agree!(
                "circle_circle",
                |x, y| {
                    let c = Plane::new(x, y);
                    let (first, _) =
                        solve::circle_circle(Number::constant(3.0), Number::constant(4.0), c, assembly).unwrap();
                    first.x * (c - first).y
                },
                x,
                y
            );
            agree!(
                "polar",
                |x, y| {
                    let s = solve::polar(Plane::new(x, y), assembly).unwrap().value;
                    Number::atan2(y / s, x / s) * s
                },
                x,
                y
            );
            agree!(
                "quadratic",
                |x, y| solve::quadratic(y, x, Number::constant(0.7), assembly).unwrap(),
                x,
                y
            );
        }
    }

    #[test]
    fn roots_of_zero_have_no_derivatives() {
        assert!(solve::square_root_of(Dual::new(0.0, 1.0)).is_err());
        assert!(solve::square_root_of(Dual::new(4.0, 1.0)).is_ok());
    }
}
