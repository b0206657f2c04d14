//! Whether the statements of the picture name points, directions and bodies.

use std::collections::{BTreeMap, BTreeSet};

use super::ValueShape;
use super::dimension::{FormulaType, common};
use super::lower::Lowering;
use super::scope::{Meaning, Scope};
use super::value::Typed;
use crate::algebra::Graph;
use crate::mistakes::{Extent, Mistakes, suggestion};
use crate::syntax::{Declaration, FormulaKind, OutputStatement, Statement, TypedFormula};

/// The abbreviations that only the picture uses. The solvers shall not see them: what they cost depends on the order in
/// which formulas are met.
pub(super) fn abbreviations(declaration: &Declaration) -> BTreeSet<String> {
    let (mut solved, mut drawn) = (BTreeSet::new(), BTreeSet::new());
    let add = |formula: &TypedFormula, names: &mut BTreeSet<String>| {
        formula.visit_names(&mut |name| {
            names.insert(name.to_string());
        });
    };
    // an abbreviation stands after those that it uses
    for statement in &declaration.statements {
        match statement {
            Statement::Equation(equation) => {
                add(&equation.left, &mut solved);
                add(&equation.right, &mut solved);
            }
            Statement::Output(output) => add(&output.value, &mut solved),
            Statement::Body(body) => body.points.iter().for_each(|point| add(point, &mut drawn)),
            Statement::Ground(ground) => ground.points.iter().for_each(|point| add(point, &mut drawn)),
            Statement::Slide(slide) => {
                add(&slide.point, &mut drawn);
                add(&slide.direction, &mut drawn);
            }
            _ => {}
        }
    }
    for statement in declaration.statements.iter().rev() {
        if let Statement::Let(statement) = statement {
            let name = statement.name.to_string();
            for names in [&mut solved, &mut drawn] {
                if names.contains(&name) {
                    add(&statement.value, names);
                }
            }
        }
    }
    drawn.retain(|name| !solved.contains(name));
    drawn
}

/// Checks the statements. They add nothing to the model: the picture is translated from the syntax tree.
pub(super) fn check(declaration: &Declaration, graph: &Graph, scope: &mut Scope<'_>, mistakes: &mut Mistakes) {
    let is_picture = |statement: &&Statement| {
        matches!(
            statement,
            Statement::Body(_) | Statement::Ground(_) | Statement::Slide(_)
        )
    };
    if !declaration.statements.iter().any(|statement| is_picture(&statement)) {
        return;
    }
    let outputs = declaration.statements.iter().filter_map(|statement| match statement {
        Statement::Output(output) => Some((output.name.to_string(), output)),
        _ => None,
    });
    let mut points = Points {
        outputs: outputs.collect(),
        // the solvers shall not see what only the picture needs
        graph: graph.clone(),
        scope,
        mistakes,
        first: None,
    };
    let drawn = abbreviations(declaration);
    for statement in &declaration.statements {
        if let Statement::Let(statement) = statement
            && drawn.contains(&statement.name.to_string())
        {
            let typed = points.lowered(&statement.value);
            let meaning = typed.map_or(Meaning::Broken, Meaning::Value);
            points.scope.define(&statement.name, meaning);
        }
    }
    let mut bodies: Vec<String> = Vec::new();
    for statement in &declaration.statements {
        match statement {
            Statement::Body(body) => {
                let name = body.name.to_string();
                if bodies.contains(&name) {
                    points.mistakes.error(
                        &body.name,
                        format!(
                            "there is a body `{name}` already: list all of its points there, or choose another name"
                        ),
                    );
                }
                bodies.push(name);
                for point in &body.points {
                    points.point(point);
                }
                // a body of one point carries the line of a slide, or slides along one
                let slides = |only: &TypedFormula| {
                    declaration.statements.iter().any(|statement| {
                        matches!(statement, Statement::Slide(slide) if slide.guide.as_ref() == Some(&body.name)
                            || slide.point.to_string() == only.to_string())
                    })
                };
                if let [only] = body.points.as_slice()
                    && !slides(only)
                {
                    points.mistakes.error(
                        only.extent,
                        format!(
                            "one point is no body: name a second point of `{}`, or remove this statement",
                            body.name
                        ),
                    );
                }
            }
            Statement::Ground(ground) => {
                for point in &ground.points {
                    points.point(point);
                }
            }
            Statement::Slide(slide) => {
                points.point(&slide.point);
                points.direction(&slide.direction);
            }
            _ => {}
        }
    }
    for statement in &declaration.statements {
        match statement {
            Statement::Slide(slide) => {
                if let Some(guide) = &slide.guide
                    && !bodies.contains(&guide.to_string())
                {
                    let near = suggestion(&guide.to_string(), bodies.iter().map(String::as_str));
                    mistakes.error(
                        guide,
                        format!(
                            "no body is called `{guide}`: write the name of a body, or leave out `on` if the line \
                            stands still{near}"
                        ),
                    );
                }
            }
            Statement::Ground(ground) if bodies.is_empty() && declaration.complete => {
                mistakes.error_at(
                    ground.word,
                    "the picture has no body: the statements replace what follows from the equations, so state the \
                     bodies too, as in `body crank: 0, pin;`",
                );
            }
            _ => {}
        }
    }
}

struct Points<'a, 'b, 'c> {
    outputs: BTreeMap<String, &'a OutputStatement>,
    graph: Graph,
    scope: &'b mut Scope<'c>,
    mistakes: &'b mut Mistakes,
    /// The measure of all points, from the first that decides.
    first: Option<FormulaType>,
}

impl Points<'_, '_, '_> {
    fn point(&mut self, formula: &TypedFormula) {
        let Some(measure) = self.measure(formula) else { return };
        if measure.is_zero() {
            return;
        }
        if measure.shape == ValueShape::Scalar || measure.shape == ValueShape::Rotation {
            self.mistakes.error(
                formula.extent,
                format!(
                    "a point is a vector, but this is {measure}: write `vec2(x, y)` or `vec3(x, y, z)`, or `0` for \
                    the origin"
                ),
            );
            return;
        }
        let first = *self.first.get_or_insert(measure);
        if first.shape != measure.shape || common(first, measure).is_none() {
            self.mistakes.error(
                formula.extent,
                format!(
                    "this point is {measure}, but the first one of the picture is {first}: all points of a picture \
                    are of one kind"
                ),
            );
        }
    }

    fn direction(&mut self, formula: &TypedFormula) {
        let Some(measure) = self.measure(formula) else { return };
        if !matches!(measure.shape, ValueShape::Plane | ValueShape::Space) {
            self.mistakes.error(
                formula.extent,
                format!(
                    "a direction is a vector, but this is {measure}: write `vec2(1, 0)`, `cis(angle)` or `vec3(0, \
                    0, 1)`"
                ),
            );
        }
    }

    /// The value of a formula; an output may be used as a name for it.
    fn measure(&mut self, formula: &TypedFormula) -> Option<FormulaType> {
        if let FormulaKind::Name(name) = &formula.kind
            && let Some(output) = self.outputs.get(&name.to_string())
        {
            return Some(output.dimension.measure());
        }
        Some(self.lowered(formula)?.measure())
    }

    fn lowered(&mut self, formula: &TypedFormula) -> Option<Typed> {
        let mut extreme: Option<(f64, Extent)> = None;
        Lowering {
            graph: &mut self.graph,
            scope: self.scope,
            mistakes: self.mistakes,
            extreme: &mut extreme,
        }
        .formula(formula)
    }
}
