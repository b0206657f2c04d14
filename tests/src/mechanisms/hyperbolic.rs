//! The hyperbolic functions and their inverses: each inverted, and all in explicit formulas.

use kin_core::prelude::*;

use super::cases::{Case, Visitor};
use super::sensitive;

mechanism! {
    /// The inverse of the hyperbolic sine.
    pub struct HyperbolicSineForm {
        a: Scalar,
    }
    input t: Scalar;
    unknown x: Scalar;

    a * sinh(2 * x + 1) == t;
}

mechanism! {
    /// The catenary: where a chain over the point b has the height t. The hyperbolic cosine has two such places.
    pub struct CatenaryForm {
        a: Length,
        b: Length,
    }
    input t: Length;
    unknown x: Length;

    a * cosh((x - b) / a) == t;
}

mechanism! {
    /// The same, with a range that picks the place on the right whatever the dimensions are.
    pub struct CatenaryWhere {
        a: Length,
    }
    input t: Length;
    unknown x: Length where x > 0;

    t == a * cosh(x / a);
}

mechanism! {
    /// The same, with a range of which only the solutions tell which of them lies in it.
    pub struct CatenaryRanged {
        a: Length,
        b: Length,
    }
    input t: Length;
    unknown x: Length in -2..0;

    a * cosh((x - b) / a) == t;
}

mechanism! {
    /// A coefficient of the unknown with a sign that only the parameter tells, behind another inverse.
    pub struct CoefficientInCosine {
        p: Scalar,
    }
    input t: Scalar;
    unknown x: Scalar;

    sqrt(cosh(p * x + 1 / 2)) == t;
}

mechanism! {
    /// The inverse of the hyperbolic tangent.
    pub struct HyperbolicTangentForm {
        a: Length,
    }
    input t: Length;
    unknown x: Scalar;

    a * tanh(x / 2) == t;
}

mechanism! {
    /// The inverse of the area hyperbolic sine.
    pub struct AreaSineForm {
        a: Length,
    }
    input t: Scalar;
    unknown x: Length;

    asinh(x / a) == t;
}

mechanism! {
    /// The inverse of the area hyperbolic cosine.
    pub struct AreaCosineForm {
        a: Length,
    }
    input t: Scalar;
    unknown x: Length;

    2 * acosh(x / a) == t;
}

mechanism! {
    /// The inverse of the area hyperbolic tangent.
    pub struct AreaTangentForm {
        a: Length,
    }
    input t: Scalar;
    unknown x: Length;

    atanh(x / a) == t;
}

mechanism! {
    /// Explicit formulas with each of the six, of the input and of each other, and their sensitivities.
    pub struct HyperbolicFunctions {
        a: Length,
        b: Length,
    }
    input t: Scalar;
    unknown u: Length, v: Scalar, w: Scalar;
    with sensitivities;

    u == a * cosh(t / 2) + b * sinh(t);
    v == asinh(u / a) - tanh(t - 1 / 4);
    w == acosh(2 + v * v) * atanh(sin(t) / 2);
    output length: Length = a * sinh(v / 4) * cosh(w / 4);
}

mechanism! {
    /// Both inverses with two solutions and one, and their sensitivities.
    pub struct HyperbolicSensitive {
        a: Length,
        b: Scalar,
    }
    input t: Length;
    unknown x: Length, y: Scalar;
    with sensitivities;

    a * cosh(x / a) == t;
    tanh(b * y) == x / (x * x / a + 2 * a);
}

mechanism! {
    /// Kepler's equation of a hyperbola, which no closed form fits.
    pub struct HyperbolicKepler {
        /// The eccentricity.
        pub e: Scalar,
    }
    input m: Scalar;
    unknown h: Scalar;

    e * sinh(h) - h == m;
}

macro_rules! cases {
    ($visitor:ident: $($mechanism:ident [$($parameter:expr),*] at [$low:expr, $high:expr];)+) => {
        $($visitor.visit::<$mechanism>(Case {
            parameters: &[$($parameter),*],
            inputs: &[($low, $high)],
        });)+
    };
}

/// All whose assemblies have names.
pub fn all(visitor: &mut impl Visitor) {
    cases! { visitor:
        HyperbolicSineForm [1.5] at [-4.0, 4.0];
        CatenaryForm [1.5, 0.4] at [1.7, 6.0];
        CatenaryWhere [1.5] at [1.7, 6.0];
        CatenaryRanged [0.9, 0.6] at [1.3, 3.0];
        CoefficientInCosine [0.7] at [1.1, 3.0];
        HyperbolicTangentForm [1.5] at [-1.3, 1.3];
        AreaSineForm [1.5] at [-3.0, 3.0];
        AreaCosineForm [1.5] at [0.2, 5.0];
        AreaTangentForm [1.5] at [-3.0, 3.0];
        HyperbolicFunctions [3.0, 1.0] at [-2.5, 2.5];
        HyperbolicSensitive [1.5, 0.8] at [1.7, 6.0];
    }
}

/// Those with sensitivities.
pub fn with_sensitivities(visitor: &mut impl sensitive::Visitor) {
    cases! { visitor:
        HyperbolicFunctions [3.0, 1.0] at [-2.5, 2.5];
        HyperbolicSensitive [1.5, 0.8] at [1.7, 6.0];
    }
}
