//! Mistakes in formulas and statements, each reported once.

use quote::quote;

use proc_macro2::TokenStream;

use super::build;
use crate::algebra::Symbol;
use crate::mistakes::Mistakes;
use crate::syntax;

fn mistakes(body: TokenStream) -> Vec<String> {
    let mut mistakes = Mistakes::new();
    let tokens = quote! {
        struct M { a: Length, b: Length, k: Scalar, p: Point, v: Vector }
        #body
    };
    let declaration = syntax::parse(tokens, &mut mistakes);
    let model = declaration.and_then(|declaration| build(&declaration, &mut mistakes));
    assert_eq!(model.is_some(), mistakes.is_empty());
    mistakes.into_messages()
}

/// The messages about one formula.
fn formula(formula: TokenStream) -> Vec<String> {
    mistakes(quote! {
        input t: Angle;
        unknown e: Length;
        let all = k * (p + v + a + b);
        all.x == e * t;
        let formula = #formula;
        let used = formula;
        output o: Point = all * used * used;
    })
    .into_iter()
    .filter(|message| !message.contains("output `o`"))
    .collect()
}

#[test]
fn what_fits_fits() {
    for fitting in [
        quote!(a + b - 2 * e),
        quote!(a + 0),
        quote!(0 - a),
        quote!(t + 1 + PI),
        quote!(p + a),
        quote!(a - v),
        quote!(p + 0),
        quote!(p * cis(t)),
        quote!(sin(a / b)),
        quote!(sqrt(a * b) + e),
        quote!(sqrt(a) * sqrt(b) + e),
        quote!(powi(a, 2) + b * e),
        quote!(powi(a, -1) * b + t),
        quote!(powi(a, 0) + t),
        quote!(atan2(a, b) + t),
        quote!(atan2(0, b)),
        quote!(vec2(0, a) + p),
        quote!(vec2(0, 0) + p),
        quote!(polar(a, t).y + b),
        quote!(polar(a / b, 0)),
        quote!(exp(k) * ln(k) + asin(0.5) + acos(a / b) + atan(t)),
        quote!(p / a * b),
        quote!(-p + v),
        quote!((a * t) + b),
        quote!(0 * a + t),
    ] {
        let messages = formula(fitting.clone());
        assert!(messages.is_empty(), "{fitting}: {messages:#?}");
    }
}

#[test]
fn what_does_not_fit_is_reported_once() {
    for (wrong, expected) in [
        (quote!(a + t), "cannot add a length and an angle"),
        (quote!(a - 1), "cannot subtract an angle or plain number from a length"),
        (quote!(a * b + a), "cannot add an area (length^2) and a length"),
        (quote!(p + t), "cannot add a plane vector of lengths and an angle"),
        (quote!(sin(a)), "`sin` takes an angle"),
        (quote!(cos(p)), "`cos` takes scalars"),
        (quote!(asin(a)), "`asin` takes a ratio"),
        (quote!(sinh(a)), "`sinh` takes a plain number"),
        (
            quote!(acosh(a)),
            "`acosh` takes a ratio, but this is a length: divide it by a length",
        ),
        (quote!(atan(a)), "`atan2(y, x)`"),
        (quote!(exp(a)), "`exp` takes a plain number"),
        (quote!(cis(a)), "`cis` takes an angle"),
        (quote!(polar(t, a)), "`polar` takes an angle as its second argument"),
        (quote!(atan2(a, t)), "same dimension"),
        (quote!(vec2(a, t)), "same dimension"),
        (quote!(vec2(p, a)), "`vec2` takes scalars"),
        (quote!(a / p), "cis(-angle)"),
        (quote!(a / 0), "this divisor is zero"),
        (quote!(a / (1 - 1)), "this divisor is zero"),
        (quote!(a.x), "only a vector has a part `x`"),
        (quote!(sqrt(-2)), "outside the domain of `sqrt`"),
        (quote!(asin(2)), "outside the domain of `asin`"),
        (
            quote!(acosh(0.5)),
            "outside the domain of `acosh`, which contains only numbers from 1 on",
        ),
        (
            quote!(atanh(-1)),
            "outside the domain of `atanh`, which contains only numbers above -1 and below 1",
        ),
        (quote!(ln(0)), "outside the domain of `ln`"),
        (quote!(atan2(0, 0)), "outside the domain of `atan2`"),
        (quote!(powi(0, -1)), "negative exponent"),
        (quote!(exp(1000)), "too large for an `f64`"),
        (quote!(exp(-1000)), "too small for an `f64`"),
        (quote!(1e300 * 1e300), "too large for an `f64`"),
        (quote!(1e-300 * a * 1e-20), "too small for an `f64`"),
        (quote!(a * 1e-320), "too small for an `f64`"),
        (quote!(a * 0.0e-400 + 1e-400), "too small for an `f64`"),
        (quote!(powi(powi(t, 64), 17)), "1024 is the largest"),
        (quote!(o * 2), "move `output o: …;` above this"),
        (quote!(later), "is called `later`"),
        (quote!(formula + a), "used before it is known"),
        (quote!(tau), "2 * PI"),
        (quote!(pi), "did you mean `PI`"),
    ] {
        let messages = formula(wrong.clone());
        assert_eq!(messages.len(), 1, "{wrong}: {messages:#?}");
        assert!(messages[0].contains(expected), "{wrong}: {messages:#?}");
    }
}

/// The messages about one formula with vectors of space.
fn in_space(formula: TokenStream) -> Vec<String> {
    mistakes(quote! {
        input t: Angle;
        unknown e: Length;
        let q = vec3(a, b, p.x);
        let r = rot_x(t) * rot(q, k);
        (q + r * q).z + v.x == e * t;
        let formula = #formula;
        let used = formula;
        output o: Point3 = q + 0 * used;
    })
    .into_iter()
    .filter(|message| !message.contains("output `o`"))
    .collect()
}

#[test]
fn what_fits_in_space_fits() {
    for fitting in [
        quote!(q + r * q),
        quote!(q + 0),
        quote!(0 - q),
        quote!(-q / 2 + t * q),
        quote!(r * r * q - rot_y(t) * rot_z(t) * q),
        quote!(cross(q, q) / a + q),
        quote!(q.cross(q) / norm(q) + q),
        quote!(q * norm(q) / a + q),
        quote!(vec3(sqrt(dot(q, q)), norm(q), norm(p))),
        quote!(vec3(cross(p, v) / a, dot(p, v) / b, q.y)),
        quote!(vec3(0, 0, a) + q),
        quote!(rot(vec3(0, 0, 2), t) * q),
        quote!(vec3(norm(q / a), 0, k) * a + q),
    ] {
        let messages = in_space(fitting.clone());
        assert!(messages.is_empty(), "{fitting}: {messages:#?}");
    }
}

#[test]
fn what_does_not_fit_in_space_is_reported_once() {
    for (wrong, expected) in [
        (
            quote!(q + p),
            "cannot add a space vector of lengths and a plane vector of lengths: write `vec3(v.x, v.y, 0)`",
        ),
        (quote!(p - q), "write `vec3(v.x, v.y, 0)`"),
        (quote!(q + a), "write `vec3(s, 0, 0)`"),
        (quote!(a - q), "write `vec3(s, 0, 0)`"),
        (
            quote!(q + q / a),
            "a space vector of plain numbers: multiply the number by a length",
        ),
        (quote!(q * q), "`dot(a, b)` or `cross(a, b)`"),
        (quote!(q * p), "`vec3(v.x, v.y, 0)` for the plane vector"),
        (quote!(q * r), "write `rotation * vector`"),
        (quote!(r * p), "`v * cis(angle)` to turn it in the plane"),
        (quote!(r * a), "write `s * (rotation * vector)`"),
        (quote!(2 * r), "write `s * (rotation * vector)`"),
        (quote!(r / 2), "write `rotation * vector / s`"),
        (quote!(q / r), "turn by the opposite angle"),
        (quote!(a / q), "divide by its length, `norm(v)`"),
        (quote!(-r), "a rotation cannot be negated"),
        (quote!(r + r), "write `rotation * vector` on both sides"),
        (quote!(r - 0), "write `rotation * vector` on both sides"),
        (quote!(r.x), "write a vector that it turns, as in `(r * v).x`"),
        (quote!(p.z), "has no part `z`: write `vec3(v.x, v.y, 0)`"),
        (quote!(a.z), "only a vector has a part `z`"),
        (quote!(sin(r)), "write the angle itself"),
        (quote!(sqrt(q)), "write its part `.x`, `.y` or `.z`"),
        (quote!(norm(a)), "`norm` takes a vector here"),
        (quote!(dot(q, a)), "`dot` takes a vector here"),
        (quote!(cross(r, q)), "write a vector that it turns"),
        (quote!(dot(q, p)), "two plane vectors or two space vectors"),
        (
            quote!(vec3(a, b, t)),
            "all arguments of `vec3` must have the same dimension, but they are a length, a length and an angle",
        ),
        (quote!(vec3(a, b, q)), "`vec3` takes scalars"),
        (quote!(rot_x(a)), "`rot_x` takes an angle"),
        (quote!(rot(q, a)), "write `rot(axis, angle)`"),
        (quote!(rot(t, t)), "`rot` takes a vector here"),
        (quote!(rot(p, t)), "the axis of a rotation is a space vector"),
        (quote!(rot(vec3(0, 0, 0), t)), "this axis is zero"),
        (quote!(rot(q, q)), "`rot` takes an angle as its second argument"),
    ] {
        let messages = in_space(wrong.clone());
        assert_eq!(messages.len(), 1, "{wrong}: {messages:#?}");
        assert!(messages[0].contains(expected), "{wrong}: {messages:#?}");
    }
}

#[test]
fn equations_in_space_have_three_parts() {
    let equation = |equation: TokenStream| {
        mistakes(quote! {
            input t: Angle;
            unknown e: Length;
            output all: Point = k * t * (p + v + a + b);
            e == a;
            #equation;
        })
    };
    assert!(equation(quote!(vec3(e, e, e) == 0)).is_empty());
    for (wrong, expected) in [
        (
            quote!(vec3(e, e, 0) == vec3(a, b, 0)),
            "the z part of this equation is always true",
        ),
        (
            quote!(vec3(e, e, e) == p),
            "the left side is a space vector, the right side a plane vector",
        ),
        (
            quote!(e == vec3(e, e, e)),
            "the left side is a scalar, the right side a space vector: write `vec3(s, 0, 0)`",
        ),
        (
            quote!(rot_x(t) == rot_y(t)),
            "the left side is a rotation, the right side a rotation",
        ),
        (quote!(rot_x(t) == 0), "the left side is a rotation"),
    ] {
        let messages = equation(wrong.clone());
        assert_eq!(messages.len(), 1, "{wrong}: {messages:#?}");
        assert!(messages[0].contains(expected), "{wrong}: {messages:#?}");
    }
}

#[test]
fn a_mistake_has_no_followers() {
    let messages = mistakes(quote! {
        input type: Angle, t: Angle;
        unknown e: Lenght;
        unknown f: Length where f > g;
        let half = a / p;
        k * half + e == b * sin(type) * t + f;
        v == if p {};
    });
    assert_eq!(messages.len(), 5, "{messages:#?}");
}

#[test]
fn equations_say_something() {
    let equation = |equation: TokenStream| {
        mistakes(quote! {
            input t: Angle;
            unknown e: Length;
            output all: Point = k * t * (p + v + a + b);
            e == a;
            #equation;
        })
    };
    assert!(equation(quote!(p == vec2(e, e))).is_empty());
    assert!(equation(quote!(p - vec2(e, e) == 0)).is_empty());
    for (idle, expected) in [
        (quote!(e == e), "is always true"),
        (quote!(a + 0 == a), "is always true"),
        (quote!(t == t + 1), "is never true"),
        (quote!(a == b), "contains no unknown"),
        (quote!(p == v), "this equation contains no unknown"),
        (
            quote!(vec2(e, 0) == vec2(a, 0)),
            "the y part of this equation is always true",
        ),
        (
            quote!(vec2(a, e) == p),
            "the x part of this equation contains no unknown",
        ),
        (quote!(p == e), "the left side is a plane vector"),
        (quote!(e == p), "the left side is a scalar"),
        (quote!(e == t), "the left side is a length"),
    ] {
        let messages = equation(idle.clone());
        assert_eq!(messages.len(), 1, "{idle}: {messages:#?}");
        assert!(messages[0].contains(expected), "{idle}: {messages:#?}");
    }
}

#[test]
fn ranges_are_constant_and_hold_something() {
    let range = |range: TokenStream| {
        mistakes(quote! {
            input t: Angle;
            unknown e: Length #range;
            e == a * t;
            output all: Point = k * (p + v + b);
        })
    };
    for good in [
        quote!(where e > 0),
        quote!(where e <= -2 * PI),
        quote!(in 0..1),
        quote!(in -PI..=sqrt(2)),
    ] {
        let messages = range(good.clone());
        assert!(messages.is_empty(), "{good}: {messages:#?}");
    }
    for (bad, expected) in [
        (quote!(where a > 0), "the range of `e` can only compare `e`"),
        (quote!(where e > a), "only numbers and `PI`, not `a`"),
        (quote!(in 1..0), "this range is empty"),
        (quote!(in 0..0), "this range is empty"),
        (quote!(in 0..cis(1)), "a plane vector"),
        (quote!(where e > 0 && e < 1), "one comparison"),
        (quote!(where e == 1), "a range needs"),
    ] {
        let messages = range(bad.clone());
        assert_eq!(messages.len(), 1, "{bad}: {messages:#?}");
        assert!(messages[0].contains(expected), "{bad}: {messages:#?}");
    }
}

#[test]
fn requests_are_known_and_made_once() {
    let requested = |requests: TokenStream| {
        mistakes(quote! {
            input t: Angle;
            unknown e: Length, with: Length;
            e == a * t;
            with == e;
            output all: Point = k * (p + v + b);
            #requests
        })
    };
    assert!(requested(quote!(with test, transmission_angles; with sensitivities;)).is_empty());
    assert_eq!(
        requested(quote!(with transmission_angle, tests, gears;)),
        [
            "`transmission_angle` cannot be requested: write `transmission_angles`, `sensitivities` or \
             `test`; did you mean `transmission_angles`?",
            "`tests` cannot be requested: write `transmission_angles`, `sensitivities` or `test`; did \
             you mean `test`?",
            "`gears` cannot be requested: write `transmission_angles`, `sensitivities` or `test`",
        ]
    );
    assert_eq!(
        requested(quote!(with test; with test;)),
        [
            "`test` is requested twice: remove this one",
            "the first `test` is requested here"
        ]
    );
}

#[test]
fn points_take_two_symbols() {
    let mut mistakes = Mistakes::new();
    let tokens = quote! {
        struct M { a: Length, p: Point, b: Length }
        input t: Angle;
        unknown e: Length;
        e * cis(t) == p + a + b;
    };
    let declaration = syntax::parse(tokens, &mut mistakes);
    let model = declaration.and_then(|declaration| build(&declaration, &mut mistakes));
    let Some(model) = model else {
        panic!("{:?}", mistakes.into_messages());
    };
    let [_, y] = model.equations[0].residual.nodes()[..] else {
        panic!("an equation of vectors has two parts");
    };
    // the point's y is the third scalar, and the lengths lie along x
    let has = |parameter| model.graph.contains(y, Symbol::Parameter(parameter));
    assert!(has(2) && !has(1) && !has(3));
    assert_eq!(model.equations[0].text, "e * cis(t) == p + a + b");
}

/// A number beyond a revolution is no angle in radians, wherever an angle stands.
#[test]
fn degrees_are_not_taken_for_radians() {
    let messages_of = |equation: TokenStream| {
        mistakes(quote! {
            input t: Angle, n: Scalar;
            unknown u: Angle, e: Length;
            let all = k * (p + v + a + b);
            let shift = 45;
            let used = t + shift / 100 + n;
            #equation
            output o: Point = all * used * e * u / a;
        })
    };
    let advice = |at: &str| format!("angles are in radians: write {at}");
    for (equation, remedies) in [
        (quote!(u == t + 30; e == a;), vec!["`30deg` or `PI / 6` for 30 degrees"]),
        (quote!(u == 90; e == a * t;), vec!["`90deg` or `PI / 2` for 90 degrees"]),
        (
            quote!(u == t; e == a * sin(n + 45);),
            vec!["`45deg` or `PI / 4` for 45 degrees"],
        ),
        (
            quote!(u == 2 * t - shift; e == a;),
            vec!["`45deg` or `PI / 4` for 45 degrees"],
        ),
        (
            quote!(u == n * t - (100 - 10.5); e == a;),
            vec!["`89.5deg` for 89.5 degrees"],
        ),
        (
            quote!(u == t; e * cis(u) == a * cis(270);),
            vec!["`270deg` or `3 * PI / 2` for 270 degrees"],
        ),
        (
            quote!(u - 60 == t + 120; e == a;),
            vec![
                "`60deg` or `PI / 3` for 60 degrees",
                "`120deg` or `2 * PI / 3` for 120 degrees",
            ],
        ),
        (
            quote!(u == t; e == polar(a, -360).x;),
            vec!["`360deg` or `2 * PI` for 360 degrees"],
        ),
    ] {
        let expected: Vec<String> = remedies.into_iter().map(advice).collect();
        let messages: Vec<String> = messages_of(equation.clone())
            .into_iter()
            .filter(|message| message.contains("radians"))
            .collect();
        assert_eq!(messages, expected, "{equation}");
    }
    for equation in [
        quote!(u == t + 30deg; e == a;),
        quote!(u == t - 6.2832; e == a;),
        quote!(u == t + 100 * PI / 180; e == a * sin(n / 45);),
        quote!(u == atan2(30 * a, 7 * b) + 2 * PI; e == a + 30 * b;),
        quote!(u == 12.5 * t; e == 40 * a * cos(t);),
    ] {
        assert_eq!(messages_of(equation.clone()), Vec::<String>::new(), "{equation}");
    }
}

#[test]
fn angles_are_not_converted() {
    let messages_of = |equation: TokenStream| {
        mistakes(quote! {
            input t: Angle, degrees: Scalar;
            unknown u: Angle, e: Length;
            let all = k * (p + v + a + b);
            let used = t + degrees / 100;
            #equation
            output o: Point = all * used * e * u / a;
        })
    };
    let is_in_radians = "an angle is in radians already";
    let is_to_stay = "angles are in radians";
    for (equation, says) in [
        (quote!(u == t * PI / 180; e == a;), is_in_radians),
        (quote!(u == t; e == a * sin(PI / 180 * t);), is_in_radians),
        (quote!(u == t; e == a * cos(0.0174533 * t + 1);), is_in_radians),
        (
            quote!(let rad = PI / 180; let turned = t * rad; u == turned; e == a;),
            is_in_radians,
        ),
        (quote!(u == t * 180 / PI; e == a;), is_to_stay),
        (quote!(u == t; e == a; output l: Angle = (57.29578 * u);), is_to_stay),
        (quote!(u == t; e == a; output l: Angle = -u * (180 / PI);), is_to_stay),
    ] {
        let messages = messages_of(equation.clone());
        assert_eq!(messages.len(), 1, "{equation}: {messages:?}");
        assert!(messages[0].starts_with(says), "{equation}: {messages:?}");
    }
    for equation in [
        quote!(u == degrees * PI / 180; e == a;),
        quote!(u == t; e == a; output l: Scalar = u * 180 / PI;),
        quote!(u == t; e == a * (u * 180 / PI) / 360;),
        quote!(u == t * PI / 18; e == a;),
    ] {
        assert_eq!(messages_of(equation.clone()), Vec::<String>::new(), "{equation}");
    }
}

#[test]
fn ranges_of_angles_are_in_radians() {
    let messages_of = |range: TokenStream| {
        mistakes(quote! {
            input t: Angle;
            unknown u: Angle #range, e: Length;
            k * cos(u) == cos(t);
            e == a + b;
            output o: Point = p + v;
        })
    };
    for range in [
        quote!(in 0..PI),
        quote!(in -30deg..90deg),
        quote!(where u > -1.5),
        quote!(in -PI..180deg),
    ] {
        assert_eq!(messages_of(range.clone()), Vec::<String>::new(), "{range}");
    }
    for (range, count, says) in [
        (quote!(in 0..180), 1, "write `180deg` or `PI` for 180 degrees"),
        (quote!(in -90..90), 2, "write `90deg` or `PI / 2` for 90 degrees"),
        (quote!(where u < 45), 1, "write `45deg` or `PI / 4` for 45 degrees"),
        (quote!(in 0deg..720deg), 1, "the range of an angle is at most a turn"),
    ] {
        let messages = messages_of(range.clone());
        assert_eq!(messages.len(), count, "{range}: {messages:?}");
        assert!(
            messages.iter().all(|message| message.contains(says)),
            "{range}: {messages:?}"
        );
    }
}
