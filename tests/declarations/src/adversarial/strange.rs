//! Numbers, names and tokens that nobody should write.

use super::{equation_of_numbers, repeated};
use crate::names;
use crate::numbers;
use crate::random::Random;

pub(super) fn extreme_numbers(random: &mut Random, n: usize) -> String {
    let mut side = || {
        let mut text = random.word("t n k").to_owned();
        for _ in 0..n {
            let operator = random.word("* / + -");
            let number = numbers::extreme(random);
            let operand = match random.below(20) {
                0..=3 => format!("{}({number})", random.word("sqrt exp ln sin asin")),
                4 => format!("powi({number}, -3)"),
                5..=8 => random.word("t n k").to_owned(),
                _ => number,
            };
            text = format!("{text} {operator} {operand}");
        }
        text
    };
    let (left, right) = (side(), side());
    equation_of_numbers(&left, &right)
}

/// Products and powers of numbers that overflow or vanish when they are multiplied out.
pub(super) fn numbers_that_vanish(random: &mut Random, n: usize) -> String {
    let number = *random.pick(&["1e-200", "1e200", "1e-320", "1e308", "5e-324", "1e-50", "1e50"]);
    let form = *random.pick(&[
        "X * N",
        "X / N",
        "powi(X * N, 7)",
        "(X + N) * (X - N)",
        "sin(X * N) * N",
        "cis(X).x * N + cis(X).y / N",
        "sqrt(X * N)",
        "(N * X + t) * (N * X + k)",
    ]);
    let left = (0..n).fold("n".to_owned(), |inner, _| {
        form.replace('N', number).replace('X', &format!("({inner})"))
    });
    equation_of_numbers(&left, "k * t")
}

pub(super) fn extreme_ranges(random: &mut Random, n: usize) -> String {
    let ranges = repeated(n, ", ", |index| {
        let (low, high) = (numbers::extreme(random), numbers::extreme(random));
        let sign = *random.pick(&["", "-", "--"]);
        match random.below(4) {
            0 => format!("u{index}: Angle in {sign}{low}..={high}"),
            1 => format!("u{index}: Angle in {sign}{low}..{low} + PI"),
            2 => format!("u{index}: Scalar where u{index} > {sign}{low}"),
            _ => format!("u{index}: Scalar where u{index} < {low} * {high}"),
        }
    });
    let form = *random.pick(&[
        "sin(U) == k * sin(t)",
        "U * U == k + t",
        "U == t + k",
        "cos(U) == k * t",
        "U * U * U == k + t",
    ]);
    let equations = repeated(n, ";", |index| form.replace('U', &format!("u{index}")));
    format!("struct M {{ k: Scalar }} input t: Angle; unknown {ranges}; {equations};")
}

pub(super) fn odd_literals(random: &mut Random, n: usize) -> String {
    let sum = repeated(n, " + ", |_| format!("t * {}", numbers::odd(random)));
    equation_of_numbers("n", &sum)
}

pub(super) fn unusual_names(random: &mut Random, n: usize) -> String {
    let mut given = vec!["M".to_owned()];
    while given.len() < n + 5 {
        let name = names::unusual(random);
        if !given.contains(&name) {
            given.push(name);
        }
    }
    if random.one_in(3) {
        given[0] = names::unusual(random);
    }
    let [mechanism, t, u, s, a, others @ ..] = given.as_slice() else {
        return String::new();
    };
    let fields = repeated(others.len(), ", ", |index| format!("{}: Length", others[index]));
    let sum = repeated(others.len(), " + ", |index| others[index].clone());
    let last = if others.is_empty() { a.clone() } else { sum };
    format!(
        "pub struct {mechanism} {{ pub {a}: Length{}{fields} }} input {t}: Angle; unknown {u}: Angle, {s}: Length; \
            {a} * cis({t}) + ({last}) * cis({u}) == vec2({s}, 0);",
        if fields.is_empty() { "" } else { ", " }
    )
}

pub(super) fn forbidden_names(random: &mut Random, n: usize) -> String {
    let [mut mechanism, mut t, mut u, mut s, mut a] = ["M", "t", "u", "s", "a"].map(str::to_owned);
    for _ in 0..n {
        let name = [&mut mechanism, &mut t, &mut u, &mut s, &mut a];
        let place = random.below(name.len());
        *name[place] = names::forbidden(random);
    }
    format!(
        "struct {mechanism} {{ {a}: Length }} input {t}: Angle; unknown {u}: Angle, {s}: Length; let l = {a} * \
            cis({t}); l + {a} * cis({u}) == vec2({s}, 0); output {u}: Length = {s};"
    )
}

pub(super) fn nothing_said(random: &mut Random, n: usize) -> String {
    let statements = [
        "",
        ";",
        "input",
        "unknown",
        "let",
        "output",
        "order",
        "with",
        "struct",
        "struct M {}",
        "struct M { a: Length }",
        "==",
    ];
    repeated(n, " ", |_| {
        format!("{}{}", random.pick(&statements), random.pick(&[";", "", ";;;"]))
    })
}

const TOKENS: &str = "for for frame {a==b;} [(a,b)] (a,b) struct M a b t u Length Angle Point input unknown let \
    output order with test where in ; ; ; , , : : = == == + - \
    * / < > .. ..= . :: # ! & ? | sin cis vec3 rot powi PI x 1 2.5 1e308 'a \"s\" () (a) {} []";

pub(super) fn tokens_at_random(random: &mut Random, n: usize) -> String {
    let head = *random.pick(&[
        "",
        "struct M { a: Length } ",
        "struct M { a: Length } input t: Angle; unknown u: Length; ",
    ]);
    head.to_owned() + &repeated(n, " ", |_| random.word(TOKENS).to_owned())
}

pub(super) fn statements_at_random(random: &mut Random, n: usize) -> String {
    let statements = [
        "input t: Angle",
        "input t: Length",
        "input s: Scalar",
        "unknown u: Angle",
        "unknown u: Length",
        "unknown v: Scalar",
        "unknown w: Direction",
        "unknown p: Point",
        "let l = a * cis(t)",
        "let l = l",
        "let m = l + 1",
        "let k = u * a",
        "output o: Point = a * cis(u)",
        "output u: Length = a",
        "output q: Angle = o",
        "output r: Vector3 = vec3(a, a, u * a)",
        "order = 1",
        "order = 12",
        "order = 13",
        "order == 3",
        "with test",
        "with sensitivities",
        "with transmission_angles",
        "with with",
        "with",
        "u == a * t",
        "a * cis(t) == a * cis(u)",
        "u == v",
        "v == t",
        "l == vec2(a, u * a)",
        "a == 1",
        "a == a",
        "0 == 0",
        "u == u",
        "let = 3",
        "input : Angle",
        "unknown u Angle",
        "u = a",
        "u + == a",
        "output o = 1",
        "input t: Angle, t: Angle",
        "unknown u: Angle where u",
        "unknown u: Angle in 1..0",
        "w == t + u",
        "for (x, y) in [(u, a), (v, t), (u, l)] { x == y; let z = x; y + z == 0; }",
        "for x in [u] { x == a * sin(t); }",
        "for o in [o1, o2] { output o: Length = a; body o: 0, f * 0; }",
        "for (x) in [a] { for y in [x] { x == y; } }",
        "for x in [] { u == a; }",
        "for u in [a, f] { u == g * l; }",
        "let f = frame(vec2(a, 0), t)",
        "let f = frame(0, rot_z(t))",
        "let g = f * f",
        "let g = frame(f * l, u)",
        "l == f * vec2(u, 0)",
        "output g: Point3 = f * g * vec3(a, 0, 0)",
        "norm(l) == a",
        "rot_x(u) == rot_x(t)",
        "rot_x(u) * vec3(a, 0, 0) == vec3(a, 0, 0)",
        "(u, v) == (a, t)",
        "u == a == t",
        "",
    ];
    let statements = repeated(n, "; ", |_| (*random.pick(&statements)).to_owned());
    let end = *random.pick(&[";", ""]);
    format!("struct M {{ a: Length }} {statements}{end}")
}

pub(super) fn documentation_and_attributes(random: &mut Random, n: usize) -> String {
    let marks = [
        "/// documentation\n",
        "//! inner\n",
        "/** block */",
        "/*! inner block */",
        "#[doc = \"text\"]",
        "#[doc(hidden)]",
        "#![allow(unused)]",
        "#[cfg(test)]",
        "#[cfg(any())]",
        "#[deprecated]",
        "#[derive(Debug)]",
        "#[must_use]",
        "#[allow(x::y)]",
        "#",
        "#[]",
        "#[=]",
        "#[a b c]",
        "#[doc]",
        "#[doc = 5]",
        "#[doc = concat!(\"a\", \"b\")]",
        "pub",
        "pub(crate)",
        "pub(in a::b)",
        "pub(super)",
        "crate",
    ];
    let mut marks = || {
        let count = random.below(n.min(4) + 1);
        repeated(count, " ", |_| (*random.pick(&marks)).to_owned())
    };
    let [a, b, c, d, e, f, g] = std::array::from_fn(|_| marks());
    format!(
        "{a} struct M {{ {b} a: Length, {c} }} {d} input {e} t: Angle; unknown u: {f} Length; u == a * sin(t); {g} \
            output o: Length = u;"
    )
}

pub(super) fn one_name_for_all(random: &mut Random, n: usize) -> String {
    let mut text = "struct M { a: Length, b: Length } input t: Angle; unknown u: Length, v: Length; let l = a * t; u \
        == l + b; v == u; output o: Length = v;"
        .to_owned();
    let names = ["a", "b", "t", "u", "v", "l", "o", "M"];
    for _ in 0..n {
        let (old, new) = (*random.pick(&names), *random.pick(&names));
        let words: Vec<&str> = text.split_inclusive(|letter: char| !letter.is_alphanumeric()).collect();
        text = words
            .into_iter()
            .map(|word| {
                let name = word.trim_end_matches(|letter: char| !letter.is_alphanumeric());
                if name == old {
                    word.replacen(old, new, 1)
                } else {
                    word.to_owned()
                }
            })
            .collect();
    }
    text
}
