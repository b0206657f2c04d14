//! Formulas that are nested deep, and names for names for names.

use super::{argument, equation, equation_of_numbers, repeated};
use crate::random::Random;

pub(super) fn parentheses(random: &mut Random, n: usize) -> String {
    let argument = argument(random);
    equation_of_numbers(&format!("{}{argument}{} + n", "(".repeat(n), ")".repeat(n)), "k")
}

pub(super) fn signs(random: &mut Random, n: usize) -> String {
    let argument = argument(random);
    equation_of_numbers(&format!("n + {}({argument})", "-".repeat(n)), "k")
}

pub(super) fn nested_functions(random: &mut Random, n: usize) -> String {
    let function = *random.pick(&["sin", "cos", "atan", "exp", "tan", "asin", "sqrt", "ln"]);
    let argument = argument(random);
    let between = *random.pick(&["", "t + ", "k * ", "2 * "]);
    let nested = format!(
        "{}{argument}{}",
        format!("{function}({between}").repeat(n),
        ")".repeat(n)
    );
    equation_of_numbers("n", &nested)
}

pub(super) fn nested_methods(random: &mut Random, n: usize) -> String {
    let function = *random.pick(&["sin", "cos", "atan", "exp"]);
    equation_of_numbers("n", &format!("t{}", format!(".{function}()").repeat(n)))
}

pub(super) fn nested_roots(random: &mut Random, n: usize) -> String {
    let between = *random.pick(&["1 + ", "t + ", "k + ", "n + ", "t * t + "]);
    equation_of_numbers(
        "n",
        &format!("{}2{}", format!("sqrt({between}").repeat(n), ")".repeat(n)),
    )
}

pub(super) fn nested_norms(random: &mut Random, n: usize) -> String {
    let part = *random.pick(&["a", "u", "a * t"]);
    let form = *random.pick(&[
        "norm(vec2(_, X))",
        "norm(cross(vec3(_, X, a), vec3(t, 1, 2)))",
        "dot(vec2(X, _), cis(t))",
    ]);
    let nested = (0..n).fold(part.to_owned(), |inner, _| form.replace('X', &inner).replace('_', part));
    equation("u", &nested)
}

pub(super) fn nested_fractions(random: &mut Random, n: usize) -> String {
    let part = *random.pick(&["t", "k", "n", "sin(t)", "1"]);
    let nested = format!("{}{part}{}", format!("1 / ({part} + ").repeat(n), ")".repeat(n));
    equation_of_numbers("n", &nested)
}

pub(super) fn squares_in_a_chain(random: &mut Random, n: usize) -> String {
    let start = *random.pick(&["t", "n", "sin(t)", "sin(n)"]);
    let step = *random.pick(&[
        "_ * _ + k * _",
        "_ * _ - k",
        "powi(_ + t, 3)",
        "_ * sin(_)",
        "_ / (1 + _ * _)",
    ]);
    let lets = repeated(n, "", |index| {
        let value = step.replace('_', &format!("y{index}"));
        format!("let y{} = {value};", index + 1)
    });
    format!("struct M {{ k: Scalar }} input t: Angle; unknown n: Scalar; let y0 = {start}; {lets} n == y{n} + t;")
}

pub(super) fn abbreviations_in_a_chain(random: &mut Random, n: usize) -> String {
    let step = *random.pick(&["_ + t", "k * _", "sin(_)", "_ + k * sin(t)", "-_"]);
    let lets = repeated(n, "", |index| {
        let value = step.replace('_', &format!("y{index}"));
        format!("let y{} = {value};", index + 1)
    });
    format!("struct M {{ k: Scalar }} input t: Angle; unknown n: Scalar; let y0 = k * t; {lets} n == y{n} + t;")
}

/// Bodies that carry one another, in one formula or each with a name.
pub(super) fn frames_in_a_row(random: &mut Random, n: usize) -> String {
    let link = *random.pick(&[
        "frame(vec3(a, 0, 0), rot_z(t) * rot_x(u))",
        "frame(0, rot_z(t))",
        "frame(a, t)",
    ]);
    let point = if link == "frame(a, t)" {
        "vec2(a, 0)"
    } else {
        "vec3(0, a, a)"
    };
    let (lets, arm) = if random.one_in(2) {
        (String::new(), repeated(n + 1, " * ", |_| "f0".to_owned()))
    } else {
        let lets = repeated(n, "", |index| format!("let f{} = f{index} * f0;", index + 1));
        (lets, format!("f{n}"))
    };
    format!(
        "struct M {{ a: Length }} input t: Angle; unknown u: Angle; let f0 = {link}; {lets} \
         a * sin(u) == ({arm} * {point}).x; "
    )
}

/// Sums and differences that double with each step if they are written out.
pub(super) fn abbreviations_used_twice(random: &mut Random, n: usize) -> String {
    let step = *random.pick(&["_ + _", "cis(t) * _ + _", "_ - 2 * _", "_ * cis(x) - _"]);
    let lets = repeated(n, "", |index| {
        let value = step.replace('_', &format!("y{index}"));
        format!("let y{} = {value};", index + 1)
    });
    format!(
        "struct M {{ a: Length }} input t: Angle; unknown x: Angle, y: Length; let y0 = a * cis(t); {lets} y{n} + a \
            * cis(x) == vec2(y, a);"
    )
}

pub(super) fn nested_groups(random: &mut Random, n: usize) -> String {
    let (open, close) = *random.pick(&[
        ("(", ")"),
        ("[", "]"),
        ("{", "}"),
        ("sin([", "])"),
        ("vec2(", ", 0)"),
        ("{;", ";}"),
    ]);
    let group = format!("{}1{}", open.repeat(n), close.repeat(n));
    match random.below(5) {
        0 => equation_of_numbers("n", &group),
        1 => format!("struct M {group} input t: Angle;"),
        2 => format!("struct M {{ a: {group} }} unknown b: Angle in {group}..1;"),
        3 => format!("{group} struct M {{ a: Length }}"),
        _ => format!("struct M {{ a: Length }} {group}; {group} == {group} input t: Angle;"),
    }
}
