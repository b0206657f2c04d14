//! Declarations that once showed a defect.

use super::verdict::{Fragments, Subject, expansion};

const CASES: &[&str] = &[
    // constants that overflow or vanish, as typed or after multiplying out
    "struct M { a: Length } input t: Angle; unknown x: Length; x * 1e-320 == a * t;",
    "struct M { k: Scalar } input t: Angle; unknown n: Scalar; (n) * 1e-320 == k * t;",
    "struct M { k: Scalar } input t: Angle; unknown n: Scalar; (n * n + 1e200) * (n * n - 1e200) == k * t;",
    // an exponent that fits no integer type
    "struct M { k: Scalar } input t: Angle; unknown n: Scalar;
     n == t + powi(powi(powi(powi(powi(powi(powi(k + t, 51), 51), 51), 51), 51), 51), 51);",
    "struct M { k: Scalar } let order = 3; input t: Angle; unknown n: Scalar; n == k * t;",
    // unknowns that cancel
    "struct M { a: Length, j: Length } input t: Angle; unknown u: Direction, v: Scalar, w: Angle, s: Length;
     s + a * u == j; s / a - t == v; v == w; u * v == PI;",
    "struct M { a: Length, b: Length } input t: Angle; unknown u: Angle, w: Angle;
     (b + a * u) / a - u + w == t; u * u + w == t;",
    "struct M { a: Length, b: Length } input t: Angle; unknown u: Angle, w: Angle, v: Length;
     b + a * u == v; w + v / a - u == t; u * w == v / a + t;",
];

fn defect(case: &str) -> Option<String> {
    let subject = Subject {
        name: "case",
        declaration: case,
        fragments: Fragments::None,
        twice: true,
    };
    Some(format!("{case}\n{}", expansion(subject).err()?))
}

#[test]
fn what_was_found_stays_mended() {
    let defects: Vec<String> = CASES.iter().filter_map(|case| defect(case)).collect();
    assert!(defects.is_empty(), "{}", defects.join("\n\n"));
}

/// Signs and nested functions that are deeper than allowed, on the stack that rustc gives.
#[test]
fn depth_is_refused_on_the_compilers_stack() {
    let nested = [
        format!("n + {}t", "-".repeat(600)),
        format!("n + {}t{}", "(".repeat(600), ")".repeat(600)),
        format!("n + {}t{}", "sin(".repeat(600), ")".repeat(600)),
    ];
    for formula in nested {
        let case = format!("struct M {{ k: Scalar }} input t: Angle; unknown n: Scalar; {formula} == k;");
        assert_eq!(defect(&case), None);
    }
}
