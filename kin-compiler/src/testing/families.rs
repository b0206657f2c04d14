//! Families of declarations of any size. Each is of a kind that could make an expansion grow faster than the
//! declaration.

use std::fmt::Display;

use proc_macro2::TokenStream;

/// A declaration of a family.
pub(crate) struct Member {
    pub(crate) name: String,
    declaration: String,
}

impl Member {
    fn new(name: impl Display, declaration: impl Into<String>) -> Self {
        Self {
            name: name.to_string(),
            declaration: declaration.into(),
        }
    }

    pub(crate) fn tokens(&self) -> TokenStream {
        self.declaration.parse().expect("a family's members are tokens")
    }
}

fn repeated<T: Display>(count: usize, separator: &str, item: impl Fn(usize) -> T) -> String {
    let items: Vec<String> = (0..count).map(|index| item(index).to_string()).collect();
    items.join(separator)
}

/// A declaration with the parameter `a` and the input `t`.
fn scalars(unknowns: &str, statements: &str) -> String {
    format!("struct Family {{ a: Scalar }} input t: Scalar; unknown {unknowns}; {statements}")
}

/// The tip of a serial arm by its joint angles.
pub(crate) fn arm(joints: usize, request: &str) -> Member {
    let axis = |joint: usize| ["z", "x", "y"][joint % 3];
    let offsets = repeated(joints, ", ", |joint| format!("p{joint}: Vector3"));
    let inputs = repeated(joints, ", ", |joint| format!("q{joint}: Angle"));
    let rotations = repeated(joints, " ", |joint| match joint {
        0 => "let r0 = rot_z(q0);".to_owned(),
        _ => format!("let r{joint} = r{} * rot_{}(q{joint});", joint - 1, axis(joint)),
    });
    let tip = repeated(joints, " + ", |joint| format!("r{joint} * p{joint}"));
    Member::new(
        format_args!("arm of {joints} joints {request}"),
        format!(
            "struct Arm {{ {offsets} }} input {inputs}; unknown x: Length, y: Length, z: Length; {rotations} \
             vec3(x, y, z) == {tip}; {request}"
        ),
    )
}

/// A point rotated again and again by one angle.
pub(crate) fn rotations(count: usize) -> Member {
    let product = repeated(count, " * ", |index| {
        ["rot(vec3(1, 2, 3), q)", "rot_x(q)", "rot_y(q)"][index % 3]
    });
    Member::new(
        format_args!("{count} rotations by one angle"),
        format!(
            "struct Family {{ p: Vector3 }} input q: Angle; unknown z: Length; dot(vec3(0, 0, 1), {product} * p) == z;"
        ),
    )
}

/// Each `let` contains the square of the one before.
pub(crate) fn squares(count: usize) -> Member {
    let lets = repeated(count, " ", |index| {
        format!("let y{} = y{index} * y{index} + a * y{index};", index + 1)
    });
    Member::new(
        format_args!("{count} squares in a chain"),
        scalars("x: Scalar", &format!("let y0 = t; {lets} x == y{count};")),
    )
}

/// Each `let` is a cross product with the one before.
pub(crate) fn cross_products(count: usize) -> Member {
    let inputs = repeated(count, ", ", |index| format!("q{index}: Angle"));
    let lets = repeated(count, " ", |index| {
        format!(
            "let v{} = cross(v{index}, vec3(a, y, sin(q{index}))) + v{index};",
            index + 1
        )
    });
    Member::new(
        format_args!("{count} cross products in a chain"),
        format!(
            "struct Family {{ a: Scalar }} input {inputs}, y: Scalar; unknown x: Scalar; let v0 = vec3(a, 1, y); \
             {lets} x == norm(v{count});"
        ),
    )
}

/// t · t · …
pub(crate) fn factors(count: usize) -> Member {
    let product = repeated(count, " * ", |_| "t");
    Member::new(
        format_args!("{count} factors"),
        scalars("x: Scalar", &format!("x == a + {product};")),
    )
}

/// (x + t) (x + t + 1) …
pub(crate) fn linear_factors(count: usize) -> Member {
    let product = repeated(count, " * ", |index| format!("(x + t + {index})"));
    Member::new(
        format_args!("{count} linear factors"),
        scalars("x: Scalar", &format!("{product} == a;")),
    )
}

/// A function of itself, nested `count` times. `step` has `{}` for the argument.
pub(crate) fn nested(count: usize, step: &str) -> Member {
    let formula = (0..count).fold("t".to_owned(), |inner, _| step.replace("{}", &inner));
    Member::new(
        format_args!("{count} times {step}"),
        scalars("x: Scalar", &format!("x == a + {formula};")),
    )
}

/// A sum of `count` terms.
pub(crate) fn terms(count: usize) -> Member {
    let sum = repeated(count, " + ", |index| format!("a * sin({index} * t)"));
    Member::new(
        format_args!("sum of {count} terms"),
        scalars("x: Scalar", &format!("x == {sum};")),
    )
}

/// cis(x + y) cis(x + y) …
pub(crate) fn directions(count: usize) -> Member {
    let product = repeated(count, " * ", |_| "cis(x + y)");
    Member::new(
        format_args!("{count} directions of a sum"),
        format!(
            "struct Family {{ a: Length }} input t: Angle; unknown x: Angle, y: Angle; \
             a * {product} == a * cis(t + y) * cis(y);"
        ),
    )
}

/// Powers of high exponents.
pub(crate) fn powers() -> [Member; 2] {
    [
        Member::new(
            "powers to order 12",
            scalars("x: Scalar", "order = 12; x == a * powi(t, 7) + powi(t, -7);"),
        ),
        Member::new(
            "64th power of a sum",
            "struct Family { a: Scalar, b: Scalar, c: Scalar, d: Scalar } input t: Scalar; unknown x: Scalar; \
             powi(x + a + b + c + d + t, 64) == 1;",
        ),
    ]
}

/// Coupled equations, each with the unknown of the next one.
pub(crate) fn ring(count: usize) -> Member {
    let unknowns = repeated(count, ", ", |index| format!("x{index}: Scalar"));
    let equations = repeated(count, " ", |index| {
        format!("x{index} * x{} + x{index} == a + t + {index};", (index + 1) % count)
    });
    Member::new(format_args!("ring of {count} products"), scalars(&unknowns, &equations))
}

/// A four-bar linkage with points on its coupler.
pub(crate) fn outputs(count: usize) -> Member {
    let outputs = repeated(count, " ", |index| {
        format!(
            "output p{index}: Point = r2 * cis(theta2) + r3 / {} * cis(theta3);",
            index + 2
        )
    });
    Member::new(
        format_args!("{count} outputs"),
        format!(
            "struct Family {{ r1: Length, r2: Length, r3: Length, r4: Length }} input theta2: Angle; \
             unknown theta3: Angle, theta4: Angle; r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4); \
             {outputs}"
        ),
    )
}

/// Independent four-bar linkages to the twelfth order, with sensitivities.
pub(crate) fn four_bars(count: usize) -> Member {
    let fields = repeated(count, ", ", |i| {
        format!("a{i}: Length, b{i}: Length, c{i}: Length, d{i}: Length")
    });
    let unknowns = repeated(count, ", ", |i| format!("x{i}: Angle, y{i}: Angle"));
    let equations = repeated(count, " ", |i| {
        format!("b{i} * cis(t) + c{i} * cis(x{i}) == a{i} + d{i} * cis(y{i});")
    });
    Member::new(
        format_args!("{count} four-bars to order 12 with sensitivities"),
        format!(
            "struct Family {{ {fields} }} input t: Angle; unknown {unknowns}; order = 12; {equations} \
             with sensitivities;"
        ),
    )
}
