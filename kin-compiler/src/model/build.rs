//! The model of a declaration, statement by statement.

use super::dimension::{Exponent, common};
use super::length::PathLengths;
use super::lower::Lowering;
use super::scope::{Meaning, NameRole, Scope};
use super::usage::{missing_statements, unknowns_in_equations, unused_names};
use super::value::{FormulaValue, Typed};
use super::{
    DeclaredParameter, Equation, Model, Output, Quantity, Unknown, ValueShape, angles, order, picture, range, request,
};
use crate::algebra::{Graph, Symbol};
use crate::mistakes::{Extent, Mistakes};
use crate::syntax::{self, Declaration, Statement};

/// Builds the model. Mistakes are added to `mistakes`; if there is one, the model is `None`.
pub(crate) fn build(declaration: &Declaration, mistakes: &mut Mistakes) -> Option<Model> {
    let mut graph = Graph::new();
    let mut scope = Scope::new(declaration);
    let parameters = parameters(declaration, &mut graph, &mut scope, mistakes);
    let (inputs, unknowns) = quantities(declaration, &mut graph, &mut scope, mistakes);
    let mut extreme = None;
    let (equations, outputs) = formulas(declaration, &mut graph, &mut scope, mistakes, &mut extreme);
    angles::check(declaration, mistakes);
    picture::check(declaration, &graph, &mut scope, mistakes);
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

fn parameters(
    declaration: &Declaration,
    graph: &mut Graph,
    scope: &mut Scope<'_>,
    mistakes: &mut Mistakes,
) -> Vec<DeclaredParameter> {
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
            ValueShape::Plane => FormulaValue::plane(next(), next()),
            ValueShape::Space => FormulaValue::space([next(), next(), next()]),
            ValueShape::Scalar | ValueShape::Rotation => FormulaValue::scalar(next()),
        };
        let typed = Typed {
            value,
            exponent: Some(exponent),
        };
        scope.declare(&field.name, NameRole::Parameter, Meaning::Value(typed), mistakes);
        parameters.push(DeclaredParameter {
            name: field.name.clone(),
            visibility: field.visibility.clone(),
            attributes: field.attributes.clone(),
            dimension,
        });
    }
    parameters
}

/// Declares every name of the statements. Their order matters only for the use of a `let`.
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
                    scope.declare(&item.name, NameRole::Input, Meaning::Value(typed), mistakes);
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
                    scope.declare(&quantity.name, NameRole::Unknown, Meaning::Value(typed), mistakes);
                    unknowns.push(Unknown {
                        name: quantity.name.clone(),
                        documentation: quantity.documentation.clone(),
                        dimension: quantity.dimension,
                        range: range.as_ref().and_then(|clause| {
                            range::range(clause, &quantity.name, quantity.dimension, declaration, scope, mistakes)
                        }),
                    });
                }
            }
            Statement::Let(statement) => {
                scope.declare(&statement.name, NameRole::Let, Meaning::Later, mistakes);
            }
            Statement::Output(statement) => {
                scope.declare(&statement.name, NameRole::Output, Meaning::Later, mistakes);
            }
            _ => {}
        }
    }
    (inputs, unknowns)
}

/// Lowers every formula. An equation with a mistake becomes `None`.
fn formulas(
    declaration: &Declaration,
    graph: &mut Graph,
    scope: &mut Scope<'_>,
    mistakes: &mut Mistakes,
    extreme: &mut Option<(f64, Extent)>,
) -> (Vec<Option<Equation>>, Vec<Output>) {
    let mut equations = Vec::new();
    let mut outputs = Vec::new();
    let mut lengths = PathLengths::default();
    let drawn = picture::abbreviations(declaration);
    // what is made of elements with a mistake has no further ones
    let mut is_spoilt = false;
    for statement in &declaration.statements {
        let mut lowering = Lowering {
            graph,
            scope,
            mistakes,
            extreme,
        };
        match statement {
            Statement::Repeats(columns) => {
                let spoilt = columns.iter().filter(|column| !lowering.are_alike(column, &drawn));
                is_spoilt = spoilt.count() > 0;
            }
            Statement::Repeated => is_spoilt = false,
            Statement::Let(statement) if is_spoilt => {
                scope.mean_all(&statement.value);
                scope.define(&statement.name, Meaning::Broken);
            }
            Statement::Equation(statement) if is_spoilt => {
                scope.mean_all(&statement.left);
                scope.mean_all(&statement.right);
                equations.push(None);
            }
            Statement::Output(statement) if is_spoilt => {
                scope.mean_all(&statement.value);
                scope.define(&statement.name, Meaning::Broken);
            }
            Statement::Let(statement) if !drawn.contains(&statement.name.to_string()) => {
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
                    is_copy: statement.is_copy,
                }));
            }
            Statement::Output(statement) => {
                let typed = lowering
                    .formula(&statement.value)
                    .filter(|typed| lengths.allow(graph, &typed.value.nodes(), statement.value.extent, mistakes));
                if let Some(typed) = &typed {
                    outputs.extend(output(statement, typed, graph, mistakes));
                }
                scope.define(&statement.name, typed.map_or(Meaning::Broken, Meaning::Value));
            }
            _ => {}
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
            (ValueShape::Rotation, _) => "write the vector that it turns, `rotation * vec3(x, y, z)`",
            (ValueShape::Scalar, Some(Exponent::LENGTH)) => "declare it `Length`",
            (ValueShape::Scalar, Some(Exponent::NUMBER)) => "declare it `Angle` or `Scalar`",
            (ValueShape::Plane, Some(Exponent::LENGTH)) => "declare it `Point` or `Vector`",
            (ValueShape::Space, Some(Exponent::LENGTH)) => "declare it `Point3` or `Vector3`",
            (ValueShape::Plane | ValueShape::Space, Some(Exponent::NUMBER)) => "multiply it by a length",
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
