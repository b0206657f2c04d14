//! Declarations that are written to take long, or much memory.

/// The bytes that are filled.
const SIZE: usize = 31_000;

/// As many parts as fit, by their index.
fn filled(each: impl Fn(usize) -> String) -> String {
    let mut text = String::new();
    for index in 0.. {
        let part = each(index);
        if text.len() + part.len() > SIZE {
            break;
        }
        text += &part;
    }
    text
}

fn repeated(count: usize, each: impl Fn(usize) -> String) -> String {
    (0..count).map(each).collect()
}

/// Linkages that drive each other, with two assemblies each.
pub(crate) fn four_bars_in_series(count: usize) -> String {
    let linkages = repeated(count, |index| {
        let next = index + 1;
        format!("unknown u{index}: Angle, v{next}: Angle; r*cis(v{index}) + c*cis(u{index}) == g + r*cis(v{next});")
    });
    format!("struct M {{ r: Length, c: Length, g: Length }} input v0: Angle; {linkages} order = 1;")
}

/// Each attack with its name.
pub(crate) fn all() -> Vec<(&'static str, String)> {
    let head = "struct M { k: Scalar } input t: Angle; unknown u: Scalar;";
    let ring = |count: usize| {
        let unknowns = repeated(count, |index| format!("unknown x{index}: Scalar;"));
        let equations = repeated(count, |index| format!("x{index}*x{}==k+t;", (index + 1) % count));
        format!("struct M {{ k: Scalar }} input t: Angle; {unknowns} {equations}")
    };
    vec![
        (
            "one equation many times",
            format!("{head} {}", filled(|_| "u == t;".to_owned())),
        ),
        (
            "many equations",
            format!("{head} {}", filled(|index| format!("u*u == {index}*t;"))),
        ),
        (
            "many unknowns",
            format!(
                "{head} u == t; {}",
                filled(|index| format!("unknown u{index}: Scalar;"))
            ),
        ),
        ("names that are near to each other", {
            let declared = repeated(1_000, |index| format!("let abcdef{index} = t;"));
            format!(
                "{head} {declared} u == t {};",
                repeated(900, |index| format!(" + bacdef{index}"))
            )
        }),
        ("a long name", format!("{head} u == {};", "a".repeat(SIZE))),
        ("open brackets", "(".repeat(SIZE)),
        (
            "pairs of brackets",
            format!("{head} u == {}t{};", "(".repeat(SIZE / 2), ")".repeat(SIZE / 2)),
        ),
        ("signs", format!("{head} u == {}t;", "-".repeat(SIZE))),
        ("references", format!("{head} u == {}t;", "&".repeat(SIZE))),
        ("generics", format!("{head} u == t::{}", "<a".repeat(SIZE / 2))),
        ("a large power", format!("{head} u == powi(t + k, 2000000000);")),
        ("powers of powers", {
            let lets = repeated(40, |index| format!("let a{} = a{index} * a{index};", index + 1));
            format!("{head} let a0 = t + k; {lets} u == a40;")
        }),
        ("sums of sums", {
            let lets = repeated(400, |index| {
                format!("let a{} = sin(a{index}) + cos(a{index});", index + 1)
            });
            format!("{head} let a0 = t + k; {lets} u == a400; order = 12;")
        }),
        ("four-bars in series", four_bars_in_series(14)),
        ("more assemblies than bits", four_bars_in_series(70)),
        ("a ring of equations", ring(61)),
        ("a long ring of equations", ring(701)),
        (
            "a long sum",
            format!(
                "{head} u == t {}; order = 12;",
                filled(|index| format!("+ sin({index}*t*k)"))
            ),
        ),
        (
            "a long product",
            format!(
                "{head} u == t {}; order = 12;",
                filled(|index| format!("* sin(t+{index})"))
            ),
        ),
        (
            "many outputs",
            format!(
                "{head} u == t*k; order = 12; {}",
                filled(|index| format!("output o{index}: Scalar = sin(u*{index});"))
            ),
        ),
        ("many sensitivities", {
            let fields = repeated(1_200, |index| format!("k{index}: Scalar,"));
            let sum = repeated(1_200, |index| format!("+sin(k{index})"));
            format!(
                "struct M {{ {fields} }} input t: Angle; unknown u: Scalar; u == t*({sum}); order = 12; with \
                    sensitivities;"
            )
        }),
        ("a power of a sum", {
            let sum = repeated(60, |index| format!("+ sin({index}*t*u)"));
            format!("{head} powi(u {sum}, 40) == t; order = 12; with sensitivities;")
        }),
    ]
}
