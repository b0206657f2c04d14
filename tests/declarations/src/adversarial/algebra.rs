//! Formulas that grow when they are multiplied out.

use super::{equation, equation_of_numbers, repeated};
use crate::random::Random;

pub(super) fn terms(random: &mut Random, n: usize) -> String {
    let kind = random.below(6);
    let signs = [" + ", " - "];
    let between = *random.pick(&signs);
    let sum = repeated(n, between, |index| match kind {
        0 => "t".to_owned(),
        1 => format!("k * sin({index} * t)"),
        2 => format!("powi(t, {})", index % 65),
        3 => format!("{index} * n"),
        4 => format!("sin(n + {index})"),
        _ => format!("{index}"),
    });
    equation_of_numbers("n", &sum)
}

pub(super) fn factors(random: &mut Random, n: usize) -> String {
    let kind = random.below(6);
    let product = repeated(n, " * ", |index| match kind {
        0 => format!("sin({} * t)", index + 1),
        1 => format!("(t + {index})"),
        2 => format!("cos(n + {index})"),
        3 => format!("(2 + sin(k + {index}))"),
        4 => "(1 + k * t)".to_owned(),
        _ => format!("exp(t / {})", index + 1),
    });
    equation_of_numbers("n", &product)
}

pub(super) fn powers_of_one_factor(random: &mut Random, n: usize) -> String {
    let (between, factor) = (
        *random.pick(&[" * ", " / "]),
        *random.pick(&["t", "n", "k", "1.5", "1e10", "1e-10"]),
    );
    equation_of_numbers("n + t", &repeated(n, between, |_| factor.to_owned()))
}

pub(super) fn linear_factors(random: &mut Random, n: usize) -> String {
    let symbol = *random.pick(&["n", "t", "k"]);
    let right = *random.pick(&["1", "t", "k * t", "n"]);
    equation_of_numbers(&repeated(n, " * ", |index| format!("({symbol} - {index} - k)")), right)
}

pub(super) fn unit_vectors(random: &mut Random, n: usize) -> String {
    let kind = random.below(3);
    let product = repeated(n, " * ", |index| match kind {
        0 => "cis(x + t)".to_owned(),
        1 => format!("cis({} * x)", index + 1),
        _ => format!("cis(x + {index} * t)"),
    });
    format!(
        "struct M {{ a: Length }} input t: Angle; unknown x: Angle, y: Length; a * {product} == vec2(y, a * sin(t));"
    )
}

pub(super) fn power_of_a_sum(random: &mut Random, n: usize) -> String {
    let sum = *random.pick(&[
        "n + k + t",
        "n + sin(t) + cos(t) + k + 1",
        "sin(n) + cos(n)",
        "k + t",
        "n",
        "1 + 1 / n",
    ]);
    let sign = *random.pick(&["", "-"]);
    equation_of_numbers(&format!("powi({sum}, {sign}{n})"), "1 + n * t")
}

pub(super) fn powers_of_powers(random: &mut Random, n: usize) -> String {
    let (start, power) = (*random.pick(&["t", "n", "k + t", "2", "0.5"]), random.between(2, 64));
    let nested = (0..n).fold(start.to_owned(), |inner, _| format!("powi({inner}, {power})"));
    equation_of_numbers("n", &format!("t + {nested}"))
}

pub(super) fn powers_of_length(random: &mut Random, n: usize) -> String {
    let start = *random.pick(&["a", "u", "a * a"]);
    let up = (0..n).fold(start.to_owned(), |inner, _| format!("sqrt({inner})"));
    let down = (0..n).fold(up, |inner, _| format!("powi({inner}, 2)"));
    equation("u", &down)
}

pub(super) fn rotations_in_a_product(random: &mut Random, n: usize) -> String {
    let sought = random.below(n);
    let product = repeated(n, " * ", |index| {
        let angle = if index == sought {
            "u".to_owned()
        } else {
            format!("(t + {index} * d)")
        };
        match index % 4 {
            0 => format!("rot(vec3(1, 2, 3), {angle})"),
            1 => format!("rot_x({angle})"),
            2 => format!("rot(w, {angle})"),
            _ => format!("rot_z({angle})"),
        }
    });
    format!(
        "struct M {{ w: Vector3, p: Point3, d: Angle, a: Length }} input t: Angle; unknown u: Angle; dot(vec3(0, 0, \
            1), {product} * p) == a + dot(w, vec3(d, 0, 0));"
    )
}

pub(super) fn angles_in_a_sum(random: &mut Random, n: usize) -> String {
    let function = *random.pick(&["cis", "cis", "polar"]);
    let sum = repeated(n, " + ", |index| format!("d{index}"));
    let fields = repeated(n, ", ", |index| format!("d{index}: Angle"));
    let link = match function {
        "cis" => format!("a * cis(u + t + {sum})"),
        _ => format!("polar(a, u - t - ({sum}))"),
    };
    format!(
        "struct M {{ a: Length, b: Length, {fields} }} input t: Angle; unknown u: Angle, s: Length; {link} + b * \
            cis(t + {sum}) == vec2(s, 0);"
    )
}

pub(super) fn multiples_of_an_angle(random: &mut Random, n: usize) -> String {
    let factor = *random.pick(&["1", "1.5", "1e10", "1e300", "0.1", "1e-300"]);
    let function = *random.pick(&["sin", "cos", "tan"]);
    equation_of_numbers(
        &format!("{function}({n} * n) + {function}({factor} * {n} * n)"),
        &format!("k * {function}({n} * t) * {function}({factor} * t)"),
    )
}

/// Equations that hold whatever the unknowns are, or never, when they are multiplied out.
pub(super) fn identities(random: &mut Random, n: usize) -> String {
    let forms = [
        "sin(n) * sin(n) + cos(n) * cos(n) == 1",
        "powi(sin(n), 2) + powi(cos(n), 2) == t",
        "(n + t) * (n - t) == n * n - t * t",
        "n - n == 0",
        "0 * n == 0",
        "0 * n == k",
        "n / n == 1",
        "n / n == k",
        "sin(2 * n) == 2 * sin(n) * cos(n)",
        "cos(n + t) == cos(n) * cos(t) - sin(n) * sin(t)",
        "exp(ln(n)) == n",
        "sqrt(n * n) == n",
        "norm(cis(n)) == 1",
        "norm(n * cis(t)) == k",
        "dot(cis(n), cis(t)) == cos(n - t)",
        "(rot_x(n) * rot_x(-n) * vec3(1, 2, 3)).y == 2",
        "tan(n) * cos(n) == sin(n)",
        "atan2(sin(n), cos(n)) == n",
        "powi(n, 0) == 1",
        "n == n + t",
        "n * n * n - n * n * n == t",
        "(n + 1) * (n + 1) - n * n - 2 * n == 1",
        "cross(vec2(n, k), vec2(n, k)) == 0",
        "n * 1e-300 * 1e-300 == t",
    ];
    let equations = repeated(n.div_ceil(6), "; ", |_| (*random.pick(&forms)).to_owned());
    format!(
        "struct M {{ a: Length, k: Scalar }} input t: Angle; unknown n: Scalar; {equations}; output o: Length = a * \
            (k + t + n);"
    )
}
