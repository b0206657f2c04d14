//! The formulas of whole mechanisms, and formulas at random that are read back.

mod reading;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use proc_macro2::TokenStream;
use quote::quote;

use super::name::Name;
use super::print;
use super::term::{DisplayLine, Notation};
use super::{Formula, Formulas, formulas};
use crate::mistakes::Mistakes;
use crate::testing::library::library;
use crate::{expand, model, syntax};

/// The formulas of a declaration without mistakes.
fn formulas_of(declaration: TokenStream) -> Formulas {
    let mut mistakes = Mistakes::new();
    let declaration = syntax::parse(declaration, &mut mistakes).expect("there is a structure");
    let Some(model) = model::build(&declaration, &mut mistakes) else {
        panic!("{:?}", mistakes.into_messages());
    };
    let structure = expand::structure(&declaration, &model, &mut mistakes).expect("it can be solved");
    formulas(
        &declaration,
        &model,
        structure.graph,
        &structure.residuals,
        &structure.blocks,
    )
}

/// All formulas with the names of their parts.
fn parts(formulas: &Formulas) -> Vec<(&'static str, &Formula)> {
    let mut parts = vec![("closure", &formulas.closure), ("outputs", &formulas.outputs)];
    parts.extend(formulas.position.iter().map(|formula| ("position", formula)));
    parts.extend(formulas.velocity.iter().map(|formula| ("velocity", formula)));
    parts.push(("rates", &formulas.rates));
    parts.extend(formulas.higher.iter().map(|formula| ("higher", formula)));
    parts
}

/// All three forms of the formulas of a mechanism of the library.
fn shown(name: &str) -> String {
    let declared = library().into_iter().find(|declared| declared.name == name);
    let formulas = formulas_of(declared.expect("it is in the library").declaration);
    let mut shown = String::new();
    for (part, formula) in parts(&formulas) {
        let Formula { text, mathml, latex } = formula;
        // one row of the table on each line
        let mathml = mathml.replace("<mtr>", "\n<mtr>");
        let _ = writeln!(shown, "{part}\n\n{text}\n\n{mathml}\n\n{latex}\n");
    }
    shown
}

/// A mechanism for each kind of solution: two circles, a circle and a line, one after the other, Newton's method, a
/// space mechanism, a polar form, and a chain of scalar equations with ranges.
#[test]
fn mechanisms_look_as_in_a_book() {
    for name in [
        "FourBar",
        "SliderCrank",
        "ClassThreeTriad",
        "Rssr",
        "WhitworthQuickReturn",
        "GeometricFourBar",
    ] {
        insta::assert_snapshot!(name, shown(name));
    }
}

/// The forms of every formula of the library are whole: tags and braces are closed in the order of their opening, every
/// line has one relation to be aligned, and no letter has a meaning that is not meant.
#[test]
fn formulas_of_the_library_are_well_formed() {
    let mut count = 0;
    for declared in library() {
        for (part, formula) in parts(&formulas_of(declared.declaration)) {
            let location = format!("{}, {part}: {}", declared.name, formula.text);
            reading::assert_well_formed(&formula.mathml, &location);
            assert_eq!(
                formula.latex.matches('&').count(),
                formula.text.lines().count(),
                "{location}"
            );
            assert!(
                !formula.latex.contains('$') && !formula.mathml.contains('$'),
                "{location}"
            );
            let mut depth = 0_usize;
            for letter in formula.latex.chars() {
                match letter {
                    '{' => depth += 1,
                    '}' => depth = depth.checked_sub(1).expect("no brace closes before it opens"),
                    _ => {}
                }
            }
            assert_eq!(depth, 0, "{location}");
            count += 1;
        }
    }
    assert!(count > 300, "{count}");
}

/// Names that look alike are distinguished, and names with a meaning in MathML or LaTeX stay names.
#[test]
fn names_are_distinguished() {
    let formulas = formulas_of(quote! {
        struct Odd { r1: Length, r_1: Length, omega: Angle, omega_dot: Angle, e: Length, sin_in: Length }
        input theta: Angle;
        unknown x: Length, phi_: Angle;
        x == r1 * cos(omega) + r_1 * sin(omega_dot) + e * cos(theta) + sin_in;
        phi_ == theta;
    });
    assert_eq!(
        formulas.closure.text,
        "x = r1 cos(ω) + r_1 sin(omega_dot) + e cos(θ) + sin_in\nφ = θ"
    );
    assert!(
        formulas.closure.latex.contains("\\mathrm{r\\_1}"),
        "{}",
        formulas.closure.latex
    );
    // e is a length here
    let formulas = formulas_of(quote! {
        struct Link { e: Length }
        input theta: Angle;
        unknown x: Length, y: Length;
        e * cis(theta) == vec2(x, y);
    });
    assert_eq!(formulas.closure.text, "e cis(θ) = x + i y");
    assert!(
        formulas.closure.latex.contains("\\mathrm{e}^{\\mathrm{i}"),
        "{}",
        formulas.closure.latex
    );
}

/// A solution that is too long to be read names the result of an inverted function that it needs.
#[test]
fn long_solutions_name_what_they_depend_on() {
    let formulas = formulas_of(quote! {
        struct Rssr { crank: Length, pivot: Point3, axis: Vector3, arm: Vector3, factor: Length }
        input theta: Angle;
        unknown reach: Length;
        let coupler = pivot + rot(axis, theta) * arm - rot_z(theta) * vec3(crank, 0, 0);
        exp(reach * norm(coupler) * norm(cross(axis, coupler)) / powi(factor, 4)) == 2 + sin(theta);
    });
    let text = &formulas.position[0].text;
    assert_eq!(text, "y = ln(sin(θ) + 2)\nreach = h(θ, y)");
}

/// Parentheses stand where they are needed, and nowhere else.
#[test]
fn parentheses_stand_where_they_are_needed() {
    let formula = |equation: TokenStream| {
        let formulas = formulas_of(quote! {
            struct M { a: Length, b: Length, c: Scalar }
            input theta: Angle;
            unknown x: Length;
            #equation;
            output all: Length = c * (a + b) * theta;
        });
        let line = |text: &str| {
            text.split_once("= ")
                .map(|(_, right)| right.to_owned())
                .expect("an equation")
        };
        let latex = formulas.closure.latex.lines().nth(1).expect("a line").to_owned();
        (line(&formulas.closure.text), line(&latex))
    };
    let cases = [
        (quote!(x == a - (b - a)), "a − (b − a)", "a - (b - a)"),
        (quote!(x == (a + b) + a), "a + b + a", "a + b + a"),
        (quote!(x == c * (a + b)), "c (a + b)", "c (a + b)"),
        (quote!(x == a / (b * c) * b), "(a/(b c)) b", "\\frac{a}{b c} \\, b"),
        (quote!(x == a / b / c * b), "(a/b/c) b", "\\frac{\\frac{a}{b}}{c} \\, b"),
        (quote!(x == a / (b / a)), "a/(b/a)", "\\frac{a}{\\frac{b}{a}}"),
        (
            quote!(x == powi(a + b, 2) / a),
            "(a + b)²/a",
            "\\frac{{(a + b)}^{2}}{a}",
        ),
        (
            quote!(x == powi(a / b, 2) * a),
            "(a/b)² a",
            "{(\\frac{a}{b})}^{2} \\, a",
        ),
        (quote!(x == a * powi(powi(c, 2), 3)), "a (c²)³", "a {({c}^{2})}^{3}"),
        (quote!(x == a * powi(c, -2)), "a c⁻²", "a {c}^{-2}"),
        (quote!(x == -a * -b / a), "a b/a", "\\frac{a b}{a}"),
        (quote!(x == -powi(a, 2) / b), "−a²/b", "-\\frac{{a}^{2}}{b}"),
        (quote!(x == a * powi(-c, 2)), "a (−c)²", "a {(-c)}^{2}"),
        (quote!(x == a * 2 * 3), "a · 2 · 3", "a \\cdot 2 \\cdot 3"),
        (
            quote!(x == a * sin(theta) * c),
            "a sin(θ) c",
            "a \\, \\sin (\\theta ) \\, c",
        ),
        (quote!(x == a * c * sin(theta)), "a c sin(θ)", "a c \\, \\sin \\theta "),
        (quote!(x == a * sin(2 * theta)), "a sin(2 θ)", "a \\, \\sin 2 \\theta "),
        (
            quote!(x == a * sin(theta + c)),
            "a sin(θ + c)",
            "a \\, \\sin (\\theta  + c)",
        ),
        (
            quote!(x == a * powi(sin(theta), 2)),
            "a sin²(θ)",
            "a \\, {\\sin }^{2}\\theta ",
        ),
        (quote!(x == 1e-9 * a), "1 · 10⁻⁹ a", "1 \\cdot 10^{-9} a"),
        (quote!(x == a * sin(30deg)), "a sin(30°)", "a \\, \\sin 30^{\\circ}"),
        (quote!(x == sqrt(a * b) / 2), "√(a b)/2", "\\frac{\\sqrt{a b}}{2}"),
    ];
    for (equation, text, latex) in cases {
        assert_eq!(formula(equation), (text.to_owned(), latex.to_owned()));
    }
}

/// A generator of terms (D. H. Lehmer's, with the multiplier of S. K. Park & K. W. Miller, 1988).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        self.0 % limit
    }

    fn term(&mut self, depth: usize) -> Notation {
        let kind = if depth == 0 { self.below(3) } else { self.below(12) };
        let one = |random: &mut Self| random.term(depth - 1);
        let many = |random: &mut Self| -> Vec<Notation> {
            let count = 2 + random.below(2);
            (0..count).map(|_| random.term(depth - 1)).collect()
        };
        match kind {
            0 => Notation::Number([2.0, 3.0, 0.5, 2.5e-6][usize::try_from(self.below(4)).unwrap_or(0)]),
            1 => Notation::Name(Name::letter(
                ['a', 'b', 'c'][usize::try_from(self.below(3)).unwrap_or(0)],
            )),
            2 => Notation::Name(Name::of_identifier("theta3")),
            3 => one(self).negative(),
            4 | 5 => Notation::sum(many(self)),
            6 | 7 => Notation::product(many(self)),
            8 => one(self).over(one(self)),
            9 => one(self).power([-2, 2, 3][usize::try_from(self.below(3)).unwrap_or(0)]),
            10 => Notation::Call(
                ["sin", "cos", "arctan"][usize::try_from(self.below(3)).unwrap_or(0)],
                vec![one(self)],
            ),
            _ => one(self).norm(),
        }
    }
}

/// The value of a term, with 1.3 for a, 0.7 for b, 1.9 for c, and 0.4 for θ₃.
fn value(term: &Notation) -> f64 {
    match term {
        Notation::Number(value) => *value,
        Notation::Name(name) => match &name.base {
            super::name::Base::Letter('a') => 1.3,
            super::name::Base::Letter('b') => 0.7,
            super::name::Base::Letter('c') => 1.9,
            _ => 0.4,
        },
        Notation::Negative(of) => -value(of),
        Notation::Sum(terms) => terms.iter().map(value).sum(),
        Notation::Product(factors) => factors.iter().map(value).product(),
        Notation::Quotient(dividend, divisor) => value(dividend) / value(divisor),
        Notation::Power(base, exponent) => value(base).powi(*exponent),
        Notation::Norm(of) => value(of).abs(),
        // the sine of a large number has no accurate digits
        Notation::Call("sin" | "cos", arguments) if value(&arguments[0]).abs() > 1e3 => f64::NAN,
        Notation::Call("sin", arguments) => value(&arguments[0]).sin(),
        Notation::Call("cos", arguments) => value(&arguments[0]).cos(),
        Notation::Call(_, arguments) => value(&arguments[0]).atan(),
        other => panic!("{other:?} is not drawn"),
    }
}

/// Each form of a term, read by the rules of the notation alone, has the value of the term.
#[test]
fn terms_are_read_back_with_their_values() {
    let names: BTreeMap<&str, f64> = [("a", 1.3), ("b", 0.7), ("c", 1.9), ("θ", 0.4)].into();
    let (mut random, mut compared) = (Random(1), 0);
    for _ in 0..2000 {
        let term = random.term(4);
        let expected = value(&term);
        // rounding hides or magnifies mistakes in very large and very small values
        if !(1e-6..1e6).contains(&expected.abs()) {
            continue;
        }
        compared += 1;
        let formula = print::formula(&[DisplayLine::equation(Notation::Number(0.0), term)], false);
        for (form, tokens) in [
            (&formula.text, reading::text(&formula.text)),
            (&formula.mathml, reading::mathml(&formula.mathml)),
            (&formula.latex, reading::latex(&formula.latex)),
        ] {
            let found = reading::value(&tokens, &names);
            assert!(
                (found - expected).abs() <= 1e-9 * expected.abs().max(1.0),
                "{form}: {found} instead of {expected}, read as {tokens:?}"
            );
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// Prints the formulas of the library:
/// `cargo test -p kin-compiler formulas_of_the_library_in -- --ignored --nocapture`. With the name of a file in
/// `KIN_LATEX`, all LaTeX is written to it, separated by empty lines.
#[test]
#[ignore = "prints formulas"]
fn formulas_of_the_library_in_text() {
    let mut latex = String::new();
    for declared in library() {
        println!("\n{}", declared.name);
        for (name, formula) in parts(&formulas_of(declared.declaration)) {
            println!("  {name}\n{}", formula.text);
            let _ = writeln!(latex, "{}\n", formula.latex);
        }
    }
    if let Some(file) = std::env::var_os("KIN_LATEX") {
        std::fs::write(file, latex).expect("the file can be written");
    }
}
