//! One scalar equation for one unknown, in every form that is known.

use kin_core::mechanism;

mechanism! {
    /// Linear, the unknown on both sides.
    pub struct LinearForm {
        a: Scalar,
        b: Length,
    }
    input t: Scalar;
    unknown x: Length;

    3 * x + a * t * b == t.powi(2) * x - (x - b) / 2;
}

mechanism! {
    /// Quadratic, typed as a product.
    pub struct QuadraticForm {
        a: Scalar,
        b: Length,
        c: Length,
    }
    input t: Length;
    unknown x: Length;

    (a * x + t) * (x - b) == -c * t;
    with sensitivities;
}

mechanism! {
    /// Quadratic, its constant term and its leading coefficient of one sign; the larger root is asked for.
    pub struct QuadraticWhere {
        b: Length,
        c: Length,
    }
    input t: Length;
    unknown x: Length where x > 2;

    x.powi(2) + b * c == (t + b) * x;
}

mechanism! {
    /// The square of an unknown.
    pub struct SquareForm {
        a: Length,
    }
    input t: Length;
    unknown x: Length;

    x * x - t.powi(2) == a * t;
}

mechanism! {
    /// The same, with the range that picks the positive root.
    pub struct SquareWhere {
        a: Length,
    }
    input t: Length;
    unknown x: Length where x > 0;

    x.powi(2) - t * t == a * t;
}

mechanism! {
    /// The same, with the range that picks the negative root.
    pub struct SquareWhereNegative {
        a: Length,
    }
    input t: Length;
    unknown x: Length where x < 0;

    x.powi(2) - t * t == a * t;
}

mechanism! {
    /// a cos x + b sin x = c.
    pub struct CircularForm {
        a: Length,
        b: Length,
    }
    input t: Length;
    unknown x: Angle;

    a * cos(x) + b * sin(x) == t;
}

mechanism! {
    /// The same, upside down and with the phase of another angle.
    pub struct CircularPhase {
        a: Length,
        b: Length,
        phase: Angle,
    }
    input t: Length;
    unknown x: Angle;

    -t == -a * cos(x - phase) - b * sin(x);
}

mechanism! {
    /// The cosine alone.
    pub struct CosineForm {
        a: Length,
    }
    input t: Length;
    unknown x: Angle;

    a * cos(x) == t;
}

mechanism! {
    /// The sine alone.
    pub struct SineForm {
        a: Length,
    }
    input t: Length;
    unknown x: Angle;

    t - a * sin(x) == 0;
}

mechanism! {
    /// The tangent: an angle between two lengths.
    pub struct TangentForm {
        a: Length,
    }
    input t: Length;
    unknown x: Angle;

    a * tan(x) == t;
}

mechanism! {
    /// The inverse of the square root.
    pub struct RootForm {
        a: Length,
    }
    input t: Length;
    unknown x: Scalar;

    a * sqrt(x) == t + a;
}

mechanism! {
    /// The inverse of the square root, then a square.
    pub struct DistanceForm {
        a: Length,
    }
    input t: Length;
    unknown x: Length;

    sqrt(a.powi(2) + x.powi(2)) == t;
}

mechanism! {
    /// The inverse of the arc sine.
    pub struct ArcSineForm {
        a: Length,
    }
    input t: Angle;
    unknown x: Length;

    asin(x / a) == t;
}

mechanism! {
    /// The inverse of the arc cosine.
    pub struct ArcCosineForm {
        a: Length,
    }
    input t: Angle;
    unknown x: Length;

    2 * acos(x / a) == t;
}

mechanism! {
    /// The inverse of the arctangent.
    pub struct ArcTangentForm {
        a: Length,
    }
    input t: Angle;
    unknown x: Length;

    atan(x / a) == t;
}

mechanism! {
    /// The inverse of the exponential function.
    pub struct ExponentialForm {
        a: Scalar,
    }
    input t: Scalar;
    unknown x: Scalar;

    a * exp(2 * x) == t;
}

mechanism! {
    /// The inverse of the logarithm, then a quadratic equation.
    pub struct LogarithmForm {
        a: Scalar,
    }
    input t: Scalar;
    unknown x: Scalar;

    ln(x * (x + a)) == t;
}

mechanism! {
    /// Explicit formulas with every function, of the input and of each other.
    pub struct ExplicitFunctions {
        a: Length,
        b: Length,
    }
    input t: Angle;
    unknown u: Length, v: Angle, w: Scalar, z: Angle;

    u == sqrt(a.powi(2) + b.powi(2) - 2 * a * b * cos(t));
    v == atan2(b * sin(t), a - b * cos(t));
    w == exp(sin(t)) / ln(2 + u / a) + tan(t / 3);
    z == asin(b * sin(t) / (2 * u)) - acos(cos(t) / 2) + atan(w);
}
