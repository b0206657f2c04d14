//! Mechanisms of many parts, and of high order.

use super::{equation, repeated};
use crate::random::Random;

pub(super) fn serial_arm(random: &mut Random, n: usize) -> String {
    let order = random.between(1, 4);
    let sensitivities = if random.one_in(4) { "with sensitivities;" } else { "" };
    let turns = ["rot_z", "rot_x", "rot_y"];
    let inputs = repeated(n, ", ", |index| format!("q{index}: Angle"));
    let fields = repeated(n, ", ", |index| format!("p{index}: Point3"));
    let lets = repeated(n, "", |index| {
        let before = if index == 0 {
            String::new()
        } else {
            format!("r{} * ", index - 1)
        };
        format!("let r{index} = {before}{}(q{index});", turns[index % 3])
    });
    let sum = repeated(n, " + ", |index| format!("r{index} * p{index}"));
    format!(
        "struct M {{ {fields} }} input {inputs}; unknown x: Length, y: Length, z: Length; {lets} vec3(x, y, z) == \
            {sum}; order = {order}; {sensitivities}"
    )
}

pub(super) fn four_bars_in_series(random: &mut Random, n: usize) -> String {
    let order = random.between(1, if n > 4 { 4 } else { 12 });
    let sensitivities = if n < 6 && random.one_in(3) {
        "with sensitivities;"
    } else {
        ""
    };
    let fields = repeated(n, ", ", |index| {
        format!("g{index}: Length, c{index}: Length, r{}: Length", index + 1)
    });
    let unknowns = repeated(n, ", ", |index| format!("u{index}: Angle, v{}: Angle", index + 1));
    let loops = repeated(n, "", |index| {
        let next = index + 1;
        format!("r{index} * cis(v{index}) + c{index} * cis(u{index}) == g{index} + r{next} * cis(v{next});")
    });
    format!(
        "struct M {{ r0: Length, {fields} }} input v0: Angle; unknown {unknowns}; {loops} order = {order}; \
            {sensitivities}"
    )
}

pub(super) fn ring_of_products(random: &mut Random, n: usize) -> String {
    let n = n.max(2);
    let form = *random.pick(&["X * Y", "X * Y + X", "powi(X, 2) + Y", "X * sin(Y)", "X / Y"]);
    let unknowns = repeated(n, ", ", |index| format!("x{index}: Scalar"));
    let equations = repeated(n, "", |index| {
        let product = form
            .replace('X', &format!("x{index}"))
            .replace('Y', &format!("x{}", (index + 1) % n));
        format!("{product} == k + {index} * t;")
    });
    format!("struct M {{ k: Scalar }} input t: Angle; unknown {unknowns}; {equations}")
}

pub(super) fn dense_linear_equations(random: &mut Random, n: usize) -> String {
    let kind = random.below(3);
    let fields = if kind == 0 {
        let all = repeated(n, ", ", |row| {
            repeated(n, ", ", |column| format!("k{row}_{column}: Scalar"))
        });
        format!("a: Length, {all}")
    } else {
        "a: Length".to_owned()
    };
    let unknowns = repeated(n, ", ", |index| format!("x{index}: Length"));
    let equations = repeated(n, "", |row| {
        let sum = repeated(n, " + ", |column| match kind {
            0 => format!("k{row}_{column} * x{column}"),
            1 => format!("{} * x{column}", (row * 7 + column * column * 3) % 11 + 1),
            _ => format!("sin({} * t) * x{column}", row * n + column + 1),
        });
        format!("{sum} == {} * a * cos(t);", row + 1)
    });
    format!("struct M {{ {fields} }} input t: Angle; unknown {unknowns}; {equations}")
}

pub(super) fn dense_equations(random: &mut Random, n: usize) -> String {
    let function = *random.pick(&["sin", "exp", "cos", "atan"]);
    let unknowns = repeated(n, ", ", |index| format!("x{index}: Angle"));
    let equations = repeated(n, "", |row| {
        let sum = repeated(n, " + ", |column| {
            format!("{function}({} * x{column} + {row} * t)", row + column + 1)
        });
        format!("x{row} + k * ({sum}) == t;")
    });
    format!("struct M {{ k: Scalar }} input t: Angle; unknown {unknowns}; {equations}")
}

/// A polygon of links with one angle known: most of its angles cannot be determined, or as many are given.
pub(super) fn polygon(random: &mut Random, n: usize) -> String {
    let free = random.between(1, 3);
    let links = repeated(n + free, " + ", |index| {
        let angle = if index < n {
            format!("t{index}")
        } else {
            format!("u{index}")
        };
        format!("a{index} * cis({angle})")
    });
    let fields = repeated(n + free, ", ", |index| format!("a{index}: Length"));
    let inputs = repeated(n, ", ", |index| format!("t{index}: Angle"));
    let unknowns = repeated(free, ", ", |index| format!("u{}: Angle", n + index));
    format!("struct M {{ {fields} }} input {inputs}; unknown {unknowns}; {links} == 0;")
}

pub(super) fn many_inputs(random: &mut Random, n: usize) -> String {
    let order = random.between(1, 6);
    let inputs = repeated(n, ", ", |index| format!("t{index}: Angle"));
    let sum = repeated(n, " + ", |index| format!("a * sin(t{index} * t{})", (index + 1) % n));
    format!("struct M {{ a: Length }} input {inputs}; unknown u: Length; u == {sum}; order = {order};")
}

pub(super) fn many_outputs(random: &mut Random, n: usize) -> String {
    let kind = random.below(3);
    let outputs = repeated(n, "", |index| match kind {
        0 => format!(
            "output o{index}: Point = a * cis(t) + {} * b * cis(u + {index});",
            index + 1
        ),
        1 => format!("output o{index}: Scalar = sin(u) / {};", index + 1),
        _ => format!("output o{index}: Point3 = rot_x(u + {index}) * vec3(a, b, s);"),
    });
    format!(
        "struct M {{ a: Length, b: Length }} input t: Angle; unknown u: Angle, s: Length; a * cis(t) + b * cis(u) == \
            vec2(s, 0); {outputs}"
    )
}

pub(super) fn many_parameters(random: &mut Random, n: usize) -> String {
    let sensitivities = if n < 40 && random.one_in(3) {
        "with sensitivities;"
    } else {
        ""
    };
    let fields = repeated(n, ", ", |index| format!("pub a{index}: Length"));
    let sum = repeated(n, " + ", |index| format!("a{index}"));
    format!("struct M {{ {fields}, }} input t: Angle; unknown u: Length; u == ({sum}) * cos(t); {sensitivities}")
}

/// As many copies of as many statements.
pub(super) fn copies(random: &mut Random, n: usize) -> String {
    let unknowns = repeated(n, ", ", |index| format!("x{index}: Scalar"));
    let list = repeated(n, ", ", |index| format!("(x{index}, {index} + k)"));
    let step = *random.pick(&["_ + t", "b * _", "sin(_)", "_ * _"]);
    let lets = repeated(n, "", |index| {
        format!("let y{} = {};", index + 1, step.replace('_', &format!("y{index}")))
    });
    format!(
        "struct M {{ k: Scalar }} input t: Angle; unknown {unknowns}; \
         for (x, b) in [{list}] {{ let y0 = b * t; {lets} x == y{n} + b; }}"
    )
}

pub(super) fn many_unknowns(random: &mut Random, n: usize) -> String {
    let kind = random.below(4);
    let unknowns = repeated(n, ", ", |index| format!("x{index}: Scalar"));
    let mut equations: Vec<String> = (0..n)
        .map(|index| {
            let before = if index == 0 {
                "t".to_owned()
            } else {
                format!("x{}", index - 1)
            };
            match kind {
                0 => format!("x{index} == k * {before};"),
                1 => format!("x{index} == k * sin({before});"),
                2 => format!("exp(x{index}) + x{index} == {before};"),
                _ => format!("x{index} + {before} == x{};", (index + 1) % n),
            }
        })
        .collect();
    random.shuffle(&mut equations);
    format!(
        "struct M {{ k: Scalar }} input t: Angle; unknown {unknowns}; {} output o: Scalar = k * t;",
        equations.concat()
    )
}

pub(super) fn too_many_equations(random: &mut Random, n: usize) -> String {
    let same = random.one_in(2);
    let equations = repeated(n + 1, "", |index| {
        let factor = if same { 1 } else { index + 1 };
        format!("u * cis(x) == {factor} * a * cis(t);")
    });
    format!("struct M {{ a: Length }} input t: Angle; unknown u: Length, x: Angle; {equations}")
}

pub(super) fn high_order(random: &mut Random, n: usize) -> String {
    let right = *random.pick(&[
        "a * powi(t, 7) + a * powi(t, -7)",
        "a * sin(t) * cos(t) * exp(t)",
        "a * sqrt(1 + t * t) / (2 + sin(t))",
        "a * atan2(sin(t), 2 + cos(t))",
        "a / (1 + t * t)",
        "a * exp(sin(t) * ln(2 + t * t))",
    ]);
    let left = *random.pick(&["u", "u + a * sin(u / a)", "u * u / a", "sqrt(u * a)"]);
    equation(left, right) + &format!("order = {n};")
}

pub(super) fn sensitivities_of_all_orders(random: &mut Random, n: usize) -> String {
    let closure = *random.pick(&[
        "a * cis(t) + b * cis(u) == vec2(s, c)",
        "a * cis(t) + s * cis(u) == vec2(b, c)",
        "b * sin(u) == a * sin(t); s == a * cos(t) + b * cos(u) + c",
    ]);
    format!(
        "struct M {{ a: Length, b: Length, c: Length }} input t: Angle; unknown u: Angle, s: Length; {closure}; \
            order = {n}; with sensitivities;"
    )
}
