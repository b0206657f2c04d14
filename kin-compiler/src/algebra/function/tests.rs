use std::fs;
use std::path::{Path, PathBuf};

use super::facts::Domain;
use super::*;
use crate::algebra::Symbol;

/// Arguments in the domain of a function.
fn inside(function: Function) -> Vec<f64> {
    let candidates = [[0.37, 0.61], [1.7, 0.4]];
    let inside = candidates
        .into_iter()
        .find(|at| function.contains(&at[..function.arity()]));
    inside.expect("a function is defined somewhere")[..function.arity()].to_vec()
}

/// Numbers from the whole real line.
fn line() -> impl Iterator<Item = f64> {
    (-400..=400).map(|step| f64::from(step) / 40.0)
}

/// Each partial derivative agrees with a central difference of the value.
#[test]
fn partials_agree_with_differences() {
    for &function in Function::ALL {
        let mut graph = Graph::new();
        let arguments: Vec<Node> = (0..function.arity())
            .map(|index| graph.symbol(Symbol::Parameter(index)))
            .collect();
        let value = graph.call(function, &arguments);
        let partials = function.partials(&mut graph, &arguments, value);
        let at = inside(function);
        for (index, partial) in partials.into_iter().enumerate() {
            let exact = graph.evaluate(partial, &|symbol| match symbol {
                Symbol::Parameter(index) => at[index],
                _ => f64::NAN,
            });
            let step = 1e-5;
            let shifted = |by: f64| {
                let mut point = at.clone();
                point[index] += by;
                function.value(&point)
            };
            let difference = (shifted(step) - shifted(-step)) / (2.0 * step);
            assert!(
                (exact - difference).abs() < 1e-8,
                "{} by argument {index}: {exact} against {difference}",
                function.name()
            );
        }
    }
}

/// A form consists of the name and as many arguments as the function takes, and no two functions share a name.
#[test]
fn forms_have_the_name_and_the_arguments() {
    for &function in Function::ALL {
        let (name, form) = (function.name(), function.form());
        assert_eq!(Function::from_name(name), Some(function));
        let arguments = form.strip_prefix(name).expect("a form begins with the name");
        assert!(arguments.starts_with('(') && arguments.ends_with(')'), "{form}");
        assert_eq!(arguments.split(", ").count(), function.arity(), "{form}");
    }
}

/// The value is a number exactly where the domain contains the argument. It equals the value of the method of `f64`
/// with the same name.
#[test]
fn domains_are_where_values_are_numbers() {
    for &function in Function::ALL {
        let FunctionFacts { value, domain, .. } = function.facts();
        for x in line() {
            let at = [x, 0.0];
            let at = &at[..function.arity()];
            let is_number = value(at).is_finite() && (function.arity() == 1 || at != [0.0, 0.0]);
            assert_eq!(function.contains(at), is_number, "{} of {at:?}", function.name());
            assert_eq!(function.value(at).is_nan(), !is_number, "{} of {at:?}", function.name());
        }
        let has_text = match domain {
            Domain::Everywhere => false,
            Domain::Part { text, .. } | Domain::Between { text, .. } => !text.is_empty(),
        };
        assert_eq!(
            has_text,
            function.guard().is_some() || function.arity() == 2 || function == Function::Tan
        );
    }
}

/// A constant outside the domain is reported, whether the function or its divisor excludes it. Other arguments are not.
#[test]
fn constants_outside_of_a_domain_are_found() {
    let mut graph = Graph::new();
    let (symbol, pi) = (graph.symbol(Symbol::Parameter(0)), graph.pi());
    let quarter = graph.scale(0.5, pi);
    let mut left = |function: Function, node: Node| function.left_domain(&mut graph, &[node]);
    assert_eq!(left(Function::Tan, quarter), Some("excludes the odd quarter turns"));
    assert_eq!(left(Function::Asin, quarter), Some("goes from -1 to 1"));
    assert_eq!(
        left(Function::Atanh, quarter),
        Some("contains only numbers above -1 and below 1")
    );
    assert_eq!(left(Function::Acosh, quarter), None);
    for &function in Function::ALL.iter().filter(|function| function.arity() == 1) {
        assert_eq!(left(function, symbol), None);
    }
    let zero = graph.zero();
    assert_eq!(
        Function::Acosh.left_domain(&mut graph, &[zero]),
        Some("contains only numbers from 1 on")
    );
    assert_eq!(
        Function::Atan2.left_domain(&mut graph, &[zero, zero]),
        Some("excludes the point (0, 0)")
    );
}

/// A function has a guard if and only if its domain is stated as a part of the real line.
#[test]
fn parts_of_the_line_are_guarded() {
    for &function in Function::ALL.iter().filter(|function| function.arity() == 1) {
        let is_part = matches!(function.facts().domain, Domain::Part { .. });
        assert_eq!(function.guard().is_some(), is_part, "{}", function.name());
        // the sign of the argument decides if and only if the domain ends at zero
        if let Some(guard) = function.guard() {
            let ends_at_zero = function.contains(&[1e-300]) && !function.contains(&[-1e-300]);
            assert_eq!(guard.decides_by_sign, ends_at_zero, "{}", function.name());
            assert_eq!(guard.cost, function.cost(), "{}", function.name());
        }
    }
}

/// A function has a zero if and only if its facts say so.
#[test]
fn zeros_are_where_they_are_said_to_be() {
    for &function in Function::ALL {
        let values: Vec<f64> = line()
            .map(|x| function.value(&[x, 1.0][..function.arity()]))
            .filter(|value| value.is_finite())
            .collect();
        let changes_sign = values.windows(2).any(|pair| pair[0] * pair[1] < 0.0);
        let is_zero = values.contains(&0.0);
        assert_eq!(is_zero || changes_sign, function.has_zeros(), "{}", function.name());
    }
}

/// A function undoes its unchecked inverse, and an even function has the same value on both sides.
#[test]
fn inverses_undo_functions() {
    for &function in Function::ALL {
        let at = inside(function);
        match function.inverse() {
            Inverse::One(InverseFunction::Elementary(inverse)) => {
                assert!(
                    inverse.guard().is_none(),
                    "{} is not defined everywhere",
                    inverse.name()
                );
                let back = inverse.value(&[function.value(&at)]);
                assert!(
                    (back - at[0]).abs() <= 4.0 * f64::EPSILON,
                    "{}: {back}",
                    function.name()
                );
            }
            Inverse::One(InverseFunction::Checked(inverse)) => {
                assert!(!inverse.cost.is_empty());
                // there is only one solution
                let values: Vec<f64> = line()
                    .map(|x| function.value(&[x]))
                    .filter(|value| !value.is_nan())
                    .collect();
                let grows = values.windows(2).all(|pair| pair[0] <= pair[1]);
                let falls = values.windows(2).all(|pair| pair[0] >= pair[1]);
                assert!(grows || falls, "{}", function.name());
            }
            Inverse::Even(_) => {
                assert!(
                    line().all(|x| function.value(&[x]) == function.value(&[-x])),
                    "{}",
                    function.name()
                );
            }
            Inverse::None => {
                let is_circular = function.calculation() != Calculation::Method;
                assert!(
                    is_circular || function.arity() == 2,
                    "{} has one argument: its facts state the inverse",
                    function.name()
                );
            }
        }
    }
}

/// A function that is calculated from sine and cosine has their cost, and the partner of a partner is the function
/// itself.
#[test]
fn circular_functions_are_calculated_together() {
    for &function in Function::ALL {
        let (sine, cosine) = 0.7_f64.sin_cos();
        let expected = match function.calculation() {
            Calculation::Method => None,
            Calculation::Sine => Some(sine),
            Calculation::Cosine => Some(cosine),
            Calculation::Tangent => Some(sine / cosine),
        };
        if let Some(expected) = expected {
            assert!((function.value(&[0.7]) - expected).abs() < 1e-15, "{}", function.name());
        }
        assert_eq!(
            expected.is_some(),
            function.cost().contains(&WorkUnit::SineCosine),
            "{}",
            function.name()
        );
        let partner = function.partner();
        assert_eq!(partner.and_then(Function::partner), partner.map(|_| function));
    }
}

/// The square root gives the root of any dimension; every other function gives a number.
#[test]
fn only_the_square_root_has_a_dimension() {
    for &function in Function::ALL {
        let takes_anything = matches!(function.takes(), Takes::Anything);
        assert_eq!(takes_anything, function.gives() == Gives::Root, "{}", function.name());
        assert_eq!(takes_anything, function == Function::Sqrt);
        assert_eq!(
            matches!(function.takes(), Takes::Alike),
            function.arity() > 1,
            "{}",
            function.name()
        );
        if let Takes::Number {
            wanted,
            instead_of_length,
        } = function.takes()
        {
            assert!(wanted.starts_with('a'), "{wanted}");
            assert!(
                instead_of_length.starts_with("divide it by a length"),
                "{instead_of_length}"
            );
        }
    }
}

/// The source files below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    entries
        .flat_map(|entry| {
            let path = entry.expect("it can be read").path();
            if path.is_dir() { sources(&path) } else { vec![path] }
        })
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}

/// The other rooms name no function except those that vectors consist of: sine and cosine, which rotate vectors, and
/// the square root, which gives their length. So a new function needs no change there, and no default arm handles it.
#[test]
fn other_rooms_do_not_list_functions() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for path in sources(&root) {
        let is_of_tests = path.ends_with("tests.rs") || path.starts_with(root.join("testing"));
        if is_of_tests || path.starts_with(root.join("algebra")) {
            continue;
        }
        let text = fs::read_to_string(&path).expect("it is text");
        let text = text.split("#[cfg(test)]").next().unwrap_or_default();
        for (start, _) in text.match_indices("Function::") {
            let before = text[..start].chars().next_back();
            let name: String = text[start + "Function::".len()..]
                .chars()
                .take_while(|letter| letter.is_alphanumeric())
                .collect();
            let is_of_this_type = before.is_none_or(|letter| !letter.is_alphanumeric());
            let is_variant = Function::ALL.iter().any(|function| format!("{function:?}") == name);
            if is_of_this_type && is_variant {
                assert!(
                    ["Sin", "Cos", "Sqrt"].contains(&name.as_str()),
                    "{name} in {}",
                    path.display()
                );
            }
        }
    }
}

/// The grammar of the book and the words for editors have every function.
#[test]
fn functions_are_documented() {
    let grammar = include_str!("../../../../docs/grammar.md");
    let editor = include_str!("../../../../kin-runtime/src/editor.rs");
    for name in Function::ALL.iter().map(|function| function.name()) {
        let in_table = [format!("`{name}`"), format!("`{name}(")]
            .iter()
            .any(|word| grammar.contains(word));
        assert!(
            in_table && grammar.contains(&format!("\"{name}\"")),
            "docs/grammar.md lacks {name}"
        );
        assert!(
            editor.contains(&format!("`{name}(")),
            "kin-runtime/src/editor.rs lacks {name}"
        );
    }
}
