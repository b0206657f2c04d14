//! Syntax tree to model: names are what they stand for, dimensions fit, and vectors are scalars along their axes, each with
//! its place in the source.

mod dimension;
mod equations;
mod length;
mod lower;
mod order;
mod range;
mod request;
mod scope;
mod value;

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, TokenStream};
use syn::{Attribute, Visibility};

use crate::algebra::{Graph, Node, Symbol};
use crate::mistakes::{Extent, Mistakes};
use crate::syntax::{self, Declaration, Formula, Statement};

use dimension::{Exponent, Measure, common};
use length::Lengths;
use lower::Lowering;
use scope::{Meaning, Role, Scope};

pub(crate) use crate::syntax::{Dimension, Request, Shape};
pub(crate) use equations::Origin;
use request::Requested;
use value::Typed;
pub(crate) use value::Value;

/// A mechanism as it was declared, free of mistakes in itself. Whether it can be solved is the next pass's question.
pub(crate) struct Model {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) name: Ident,
    pub(crate) parameters: Vec<Parameter>,
    pub(crate) inputs: Vec<Quantity>,
    pub(crate) unknowns: Vec<Unknown>,
    pub(crate) equations: Vec<Equation>,
    pub(crate) outputs: Vec<Output>,
    /// The highest time derivative that is solved for.
    pub(crate) order: usize,
    /// What is to be generated besides the solvers.
    pub(crate) requests: Vec<Requested>,
    /// The constant that is farthest from 1.
    pub(crate) extreme_constant: Option<Extent>,
    pub(crate) graph: Graph,
}

/// A field of the struct.
pub(crate) struct Parameter {
    pub(crate) name: Ident,
    pub(crate) visibility: Visibility,
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) dimension: Dimension,
}

/// An input.
pub(crate) struct Quantity {
    pub(crate) name: Ident,
    pub(crate) documentation: Vec<Attribute>,
    pub(crate) dimension: Dimension,
}

/// What is to be found.
pub(crate) struct Unknown {
    pub(crate) name: Ident,
    pub(crate) documentation: Vec<Attribute>,
    pub(crate) dimension: Dimension,
    pub(crate) range: Option<Range>,
}

/// Where an unknown is to be found. An end may be infinite.
pub(crate) struct Range {
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// `e > 0`
    pub(crate) text: String,
}

pub(crate) struct Equation {
    /// The left side less the right.
    pub(crate) residual: Value,
    /// The whole equation, for errors that span it.
    pub(crate) tokens: TokenStream,
    pub(crate) text: String,
}

/// A quantity that is computed from the others and carried to the same order.
pub(crate) struct Output {
    pub(crate) name: Ident,
    pub(crate) documentation: Vec<Attribute>,
    pub(crate) dimension: Dimension,
    pub(crate) value: Value,
    pub(crate) text: String,
}

/// Builds the model. Mistakes are added to `mistakes`. After one the model is `None`.
pub(crate) fn build(declaration: &Declaration, mistakes: &mut Mistakes) -> Option<Model> {
    let mut graph = Graph::new();
    let mut scope = Scope::new(declaration);
    let parameters = parameters(declaration, &mut graph, &mut scope, mistakes);
    let (inputs, unknowns) = quantities(declaration, &mut graph, &mut scope, mistakes);
    let mut extreme = None;
    let (equations, outputs) = formulas(declaration, &mut graph, &mut scope, mistakes, &mut extreme);
    let order = order::order(declaration, mistakes);
    let requests = request::requests(declaration, mistakes);

    if declaration.complete {
        missing_statements(declaration, mistakes);
    }
    if !equations.is_empty() && !declaration.breaks_off {
        unused_names(declaration, &scope, mistakes);
    }
    let sound = unknowns_in_equations(declaration, &unknowns, &equations, &graph, &scope, mistakes);
    if !declaration.complete || !sound || !mistakes.is_empty() {
        return None;
    }
    Some(Model {
        attributes: declaration.attributes.clone(),
        visibility: declaration.visibility.clone(),
        name: declaration.name.clone(),
        parameters,
        inputs,
        unknowns,
        equations: equations.into_iter().collect::<Option<_>>()?,
        outputs,
        order,
        requests,
        extreme_constant: extreme.map(|(_, extent)| extent),
        graph,
    })
}

impl Dimension {
    fn exponent(self) -> Exponent {
        match self {
            Self::Length | Self::Point | Self::Vector | Self::Point3 | Self::Vector3 => Exponent::LENGTH,
            Self::Angle | Self::Direction | Self::Scalar => Exponent::NUMBER,
        }
    }

    fn measure(self) -> Measure {
        Measure {
            shape: self.shape(),
            exponent: Some(self.exponent()),
        }
    }
}

fn parameters(
    declaration: &Declaration,
    graph: &mut Graph,
    scope: &mut Scope<'_>,
    mistakes: &mut Mistakes,
) -> Vec<Parameter> {
    let mut parameters = Vec::new();
    let mut count = 0;
    for field in &declaration.parameters {
        let Some(dimension) = field.dimension else {
            continue;
        };
        let mut next = || {
            count += 1;
            graph.symbol(Symbol::Parameter(count - 1))
        };
        let exponent = dimension.exponent();
        let value = match dimension.shape() {
            Shape::Plane => Value::plane(next(), next()),
            Shape::Space => Value::space([next(), next(), next()]),
            Shape::Scalar | Shape::Rotation => Value::scalar(next()),
        };
        let typed = Typed {
            value,
            exponent: Some(exponent),
        };
        scope.declare(&field.name, Role::Parameter, Meaning::Value(typed), mistakes);
        parameters.push(Parameter {
            name: field.name.clone(),
            visibility: field.visibility.clone(),
            attributes: field.attributes.clone(),
            dimension,
        });
    }
    parameters
}

/// Declares every name of the statements. Where they stand does not matter, except for the use of a `let`.
fn quantities(
    declaration: &Declaration,
    graph: &mut Graph,
    scope: &mut Scope<'_>,
    mistakes: &mut Mistakes,
) -> (Vec<Quantity>, Vec<Unknown>) {
    let mut inputs: Vec<Quantity> = Vec::new();
    let mut unknowns: Vec<Unknown> = Vec::new();
    for statement in &declaration.statements {
        match statement {
            Statement::Inputs(items) => {
                for item in items {
                    let node = graph.symbol(Symbol::Input(inputs.len()));
                    let typed = Typed::scalar(node, item.dimension.exponent());
                    scope.declare(&item.name, Role::Input, Meaning::Value(typed), mistakes);
                    inputs.push(Quantity {
                        name: item.name.clone(),
                        documentation: item.documentation.clone(),
                        dimension: item.dimension,
                    });
                }
            }
            Statement::Unknowns(items) => {
                for syntax::UnknownItem { quantity, range } in items {
                    let node = graph.symbol(Symbol::Unknown(unknowns.len()));
                    let typed = Typed::scalar(node, quantity.dimension.exponent());
                    scope.declare(&quantity.name, Role::Unknown, Meaning::Value(typed), mistakes);
                    unknowns.push(Unknown {
                        name: quantity.name.clone(),
                        documentation: quantity.documentation.clone(),
                        dimension: quantity.dimension,
                        range: range
                            .as_ref()
                            .and_then(|clause| range::range(clause, &quantity.name, declaration, mistakes)),
                    });
                }
            }
            Statement::Let(statement) => {
                scope.declare(&statement.name, Role::Let, Meaning::Later, mistakes);
            }
            Statement::Output(statement) => {
                scope.declare(&statement.name, Role::Output, Meaning::Result, mistakes);
            }
            Statement::Equation(_) | Statement::Order(_) | Statement::Requests(_) => {}
        }
    }
    (inputs, unknowns)
}

/// Lowers every formula. An equation with a mistake leaves `None` in its place.
fn formulas(
    declaration: &Declaration,
    graph: &mut Graph,
    scope: &mut Scope<'_>,
    mistakes: &mut Mistakes,
    extreme: &mut Option<(f64, Extent)>,
) -> (Vec<Option<Equation>>, Vec<Output>) {
    let mut equations = Vec::new();
    let mut outputs = Vec::new();
    let mut lengths = Lengths::default();
    for statement in &declaration.statements {
        let mut lowering = Lowering {
            graph,
            scope,
            mistakes,
            extreme,
        };
        match statement {
            Statement::Let(statement) => {
                let typed = lowering
                    .formula(&statement.value)
                    .filter(|typed| lengths.allow(graph, &typed.value.nodes(), statement.value.extent, mistakes));
                scope.define(&statement.name, typed.map_or(Meaning::Broken, Meaning::Value));
            }
            Statement::Equation(statement) => {
                let residual = lowering
                    .residual(statement)
                    .filter(|residual| lengths.allow(graph, &residual.nodes(), statement.operator, mistakes));
                equations.push(residual.map(|residual| Equation {
                    residual,
                    tokens: statement.tokens.clone(),
                    text: statement.to_string(),
                }));
            }
            Statement::Output(statement) => {
                let typed = lowering
                    .formula(&statement.value)
                    .filter(|typed| lengths.allow(graph, &typed.value.nodes(), statement.value.extent, mistakes));
                if let Some(typed) = typed {
                    outputs.extend(output(statement, &typed, graph, mistakes));
                }
            }
            Statement::Inputs(_) | Statement::Unknowns(_) | Statement::Order(_) | Statement::Requests(_) => {}
        }
    }
    (equations, outputs)
}

fn output(
    statement: &syntax::OutputStatement,
    typed: &Typed,
    graph: &mut Graph,
    mistakes: &mut Mistakes,
) -> Option<Output> {
    let declared = statement.dimension.measure();
    let actual = typed.measure();
    let fits = (declared.shape == actual.shape || actual.is_zero()) && common(declared, actual).is_some();
    if !fits {
        let remedy = match (actual.shape, actual.exponent) {
            (Shape::Rotation, _) => "write the vector that it turns, `rotation * vec3(x, y, z)`",
            (Shape::Scalar, Some(Exponent::LENGTH)) => "declare it `Length`",
            (Shape::Scalar, Some(Exponent::NUMBER)) => "declare it `Angle` or `Scalar`",
            (Shape::Plane, Some(Exponent::LENGTH)) => "declare it `Point` or `Vector`",
            (Shape::Space, Some(Exponent::LENGTH)) => "declare it `Point3` or `Vector3`",
            (Shape::Plane | Shape::Space, Some(Exponent::NUMBER)) => "multiply it by a length",
            _ => "divide or multiply it by lengths until it is one",
        };
        mistakes.error(
            statement.value.extent,
            format!(
                "output `{}` is declared `{}`, but this is {actual}: {remedy}",
                statement.name,
                statement.dimension.word()
            ),
        );
        return None;
    }
    Some(Output {
        name: statement.name.clone(),
        documentation: statement.documentation.clone(),
        dimension: statement.dimension,
        value: typed.value.lifted(graph, declared.shape),
        text: statement.value.to_string(),
    })
}

/// A mechanism has inputs, unknowns and equations.
fn missing_statements(declaration: &Declaration, mistakes: &mut Mistakes) {
    let name = &declaration.name;
    if declaration.statements.is_empty() {
        mistakes.error(
            name,
            format!(
                "nothing is said of `{name}` but its parameters: declare an `input`, the `unknown`s and the equations after the struct"
            ),
        );
        return;
    }
    let some = |kind: fn(&Statement) -> bool| declaration.statements.iter().any(kind);
    if !some(|statement| matches!(statement, Statement::Inputs(_))) {
        mistakes.error(
            name,
            format!("`{name}` has no input, so nothing moves it: declare one, as in `input theta2: Angle;`"),
        );
    }
    if !some(|statement| matches!(statement, Statement::Unknowns(_))) {
        mistakes.error(
            name,
            format!("`{name}` has no unknown to solve for: declare one, as in `unknown theta3: Angle;`"),
        );
    }
    if !some(|statement| matches!(statement, Statement::Equation(_))) {
        mistakes.error(
            name,
            format!("`{name}` has no equation: write its loop closure, as in `a * cis(theta) == b;`"),
        );
    }
}

/// What is declared is used, or is a mistake of its own.
fn unused_names(declaration: &Declaration, scope: &Scope<'_>, mistakes: &mut Mistakes) {
    for entry in &scope.entries {
        let word = entry.name.to_string();
        if entry.used || declaration.mentioned.contains(&word) || scope.is_meant(&word) {
            continue;
        }
        let complaint = match entry.role {
            Role::Parameter | Role::Input => format!(
                "{} `{word}` is used by no equation and no output: use it, or remove it",
                entry.role.word()
            ),
            Role::Let => format!("`let {word}` is never used: use it, or remove it"),
            Role::Unknown | Role::Output => continue,
        };
        mistakes.error(&entry.name, complaint);
    }
}

/// Every unknown stands in an equation, and every scalar equation contains an unknown. False if one was found that does not.
fn unknowns_in_equations(
    declaration: &Declaration,
    unknowns: &[Unknown],
    equations: &[Option<Equation>],
    graph: &Graph,
    scope: &Scope<'_>,
    mistakes: &mut Mistakes,
) -> bool {
    let before = mistakes.is_empty();
    let mut found: BTreeSet<usize> = BTreeSet::new();
    for equation in equations.iter().flatten() {
        let residual = &equation.residual;
        let axes = residual.shape().axes();
        let parts: Vec<(Node, String)> = residual
            .nodes()
            .into_iter()
            .enumerate()
            .map(|(part, node)| match axes.get(part) {
                None => (node, "this equation".to_owned()),
                Some(axis) => (node, format!("the {axis} part of this equation")),
            })
            .collect();
        let mut idle: Vec<&(Node, String)> = Vec::new();
        for part in &parts {
            let contained: Vec<usize> = graph.unknowns(part.0).collect();
            if contained.is_empty() {
                idle.push(part);
            }
            found.extend(contained);
        }
        if unknowns.is_empty() || idle.is_empty() {
            continue;
        }
        let whole = idle.len() == parts.len();
        for (node, subject) in idle.iter().take(if whole { 1 } else { parts.len() }) {
            let subject = if whole { "this equation" } else { subject.as_str() };
            let remedy = if whole {
                "remove it"
            } else {
                match axes {
                    [_, _] => "write the other part alone, by `.x` or `.y`",
                    _ => "write the other parts alone, by `.x`, `.y` and `.z`",
                }
            };
            let complaint = match graph.constant_value(*node) {
                Some(0.0) => format!("{subject} is always true and says nothing: {remedy}"),
                Some(_) => {
                    format!("{subject} is never true, whatever the unknowns are: correct it")
                }
                None => format!("{subject} contains no unknown, so it can only restrict what is given: {remedy}"),
            };
            mistakes.error(&equation.tokens, complaint);
        }
    }
    let mut written = None;
    for (index, unknown) in unknowns.iter().enumerate() {
        let word = unknown.name.to_string();
        if found.contains(&index) || declaration.mentioned.contains(&word) || scope.is_meant(&word) {
            continue;
        }
        let written = written.get_or_insert_with(|| written_names(declaration));
        let cancelled = declaration_mentions(written, equations, &word);
        match cancelled {
            Mention::InBroken => {}
            Mention::InSound => mistakes.error(
                &unknown.name,
                format!("unknown `{word}` cancels out of every equation: nothing determines it"),
            ),
            Mention::Nowhere => {
                if !equations.is_empty() && !declaration.breaks_off {
                    mistakes.error(
                        &unknown.name,
                        format!("no equation contains the unknown `{word}`: write one, or remove it"),
                    );
                }
            }
        }
    }
    before == mistakes.is_empty()
}

enum Mention {
    Nowhere,
    /// In equations without a mistake only.
    InSound,
    /// In an equation with a mistake.
    InBroken,
}

fn declaration_mentions(written: &[BTreeSet<String>], equations: &[Option<Equation>], word: &str) -> Mention {
    let mut mention = Mention::Nowhere;
    for (names, equation) in written.iter().zip(equations) {
        if names.contains(word) {
            if equation.is_none() {
                return Mention::InBroken;
            }
            mention = Mention::InSound;
        }
    }
    mention
}

/// The names written in each equation, those within its abbreviations included.
fn written_names(declaration: &Declaration) -> Vec<BTreeSet<String>> {
    let names_of = |expressions: &[&Formula]| {
        let mut names = BTreeSet::new();
        for expression in expressions {
            expression.visit_names(&mut |name| {
                names.insert(name.to_string());
            });
        }
        names
    };
    let mut abbreviations: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut equations = Vec::new();
    for statement in &declaration.statements {
        match statement {
            Statement::Let(statement) => {
                abbreviations.insert(statement.name.to_string(), names_of(&[&statement.value]));
            }
            Statement::Equation(statement) => equations.push(names_of(&[&statement.left, &statement.right])),
            Statement::Inputs(_)
            | Statement::Unknowns(_)
            | Statement::Output(_)
            | Statement::Order(_)
            | Statement::Requests(_) => {}
        }
    }
    for names in &mut equations {
        let mut open: Vec<String> = names.iter().cloned().collect();
        while let Some(name) = open.pop() {
            for inner in abbreviations.get(&name).into_iter().flatten() {
                if names.insert(inner.clone()) {
                    open.push(inner.clone());
                }
            }
        }
    }
    equations
}

#[cfg(test)]
#[allow(clippy::needless_pass_by_value, reason = "formulas are quoted where they are passed")]
mod tests {
    use quote::quote;

    use super::*;

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

    /// The mistakes of one formula.
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
    fn what_does_not_fit_is_told_once() {
        for (wrong, told) in [
            (quote!(a + t), "cannot add a length and an angle"),
            (quote!(a - 1), "cannot subtract an angle or plain number from a length"),
            (quote!(a * b + a), "cannot add an area (length^2) and a length"),
            (quote!(p + t), "cannot add a plane vector of lengths and an angle"),
            (quote!(sin(a)), "`sin` takes an angle"),
            (quote!(cos(p)), "`cos` takes scalars"),
            (quote!(asin(a)), "`asin` takes a ratio"),
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
            (quote!(sqrt(-2)), "outside of the domain of `sqrt`"),
            (quote!(asin(2)), "outside of the domain of `asin`"),
            (quote!(ln(0)), "outside of the domain of `ln`"),
            (quote!(atan2(0, 0)), "outside of the domain of `atan2`"),
            (quote!(powi(0, -1)), "negative exponent"),
            (quote!(exp(1000)), "too large for an `f64`"),
            (quote!(exp(-1000)), "too small for an `f64`"),
            (quote!(1e300 * 1e300), "too large for an `f64`"),
            (quote!(1e-300 * a * 1e-20), "too small for an `f64`"),
            (quote!(a * 1e-320), "too small for an `f64`"),
            (quote!(a * 0.0e-400 + 1e-400), "too small for an `f64`"),
            (quote!(powi(powi(t, 64), 17)), "powers end at 1024"),
            (quote!(o * 2), "is an output"),
            (quote!(later), "is called `later`"),
            (quote!(formula + a), "used before it is known"),
            (quote!(tau), "2 * PI"),
            (quote!(pi), "did you mean `PI`"),
        ] {
            let messages = formula(wrong.clone());
            assert_eq!(messages.len(), 1, "{wrong}: {messages:#?}");
            assert!(messages[0].contains(told), "{wrong}: {messages:#?}");
        }
    }

    /// The mistakes of one formula among vectors of space.
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
    fn what_does_not_fit_in_space_is_told_once() {
        for (wrong, told) in [
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
            (quote!(q * q), "`dot(a, b)` and `cross(a, b)`"),
            (quote!(q * p), "`vec3(v.x, v.y, 0)` for the plane vector"),
            (quote!(q * r), "write `rotation * vector`"),
            (quote!(r * p), "`v * cis(angle)` to turn it in the plane"),
            (quote!(r * a), "write `s * (rotation * vector)`"),
            (quote!(2 * r), "write `s * (rotation * vector)`"),
            (quote!(r / 2), "write `rotation * vector / s`"),
            (quote!(q / r), "turn back by that of the opposite angle"),
            (quote!(a / q), "divide by its length, `norm(v)`"),
            (quote!(-r), "a rotation has no negative"),
            (quote!(r + r), "a rotation only turns"),
            (quote!(r - 0), "a rotation only turns"),
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
            assert!(messages[0].contains(told), "{wrong}: {messages:#?}");
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
        for (wrong, told) in [
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
            assert!(messages[0].contains(told), "{wrong}: {messages:#?}");
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
        for (idle, told) in [
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
            assert!(messages[0].contains(told), "{idle}: {messages:#?}");
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
        for (bad, told) in [
            (quote!(where a > 0), "the range of `e` speaks of `e` alone"),
            (quote!(where e > a), "`a` is neither"),
            (quote!(in 1..0), "this range is empty"),
            (quote!(in 0..0), "this range is empty"),
            (quote!(in 0..cis(1)), "a plane vector"),
            (quote!(where e > 0 && e < 1), "one comparison"),
            (quote!(where e == 1), "compares by"),
        ] {
            let messages = range(bad.clone());
            assert_eq!(messages.len(), 1, "{bad}: {messages:#?}");
            assert!(messages[0].contains(told), "{bad}: {messages:#?}");
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
                "`transmission_angle` is nothing that can be generated: write `transmission_angles`, `sensitivities` or \
                 `test`; did you mean `transmission_angles`?",
                "`tests` is nothing that can be generated: write `transmission_angles`, `sensitivities` or `test`; did \
                 you mean `test`?",
                "`gears` is nothing that can be generated: write `transmission_angles`, `sensitivities` or `test`",
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
}
