//! The picture: which joints belong together, from the vector equations or from statements, and where they are.
//!
//! Like the closure, the joints are translated from the syntax tree.

mod closures;
mod groups;
mod guess;
mod names;
mod outline;
mod statements;
mod terms;
mod turning;

use std::collections::BTreeSet;

use super::formula::{difference, lifted, sum};
use super::names::Names;
use super::tree::{Binding, Local, Operation, Outline, Sheet, Tree};
use crate::model::{Dimension, Model, ValueShape};
use crate::syntax::{Declaration, EquationStatement, OutputStatement, Statement};
use names::SkeletonNames;
use outline::Picture;

/// The outline of a declaration, and the method `skeleton_points`: its joints, and the directions of its slides behind
/// them.
pub(super) fn outline(declaration: &Declaration, model: &Model, names: &Names) -> (Outline, Sheet) {
    let mut picture = picture(declaration, model, names);
    let equations = equations(declaration, model);
    let scalar = equations.filter(|(_, shape)| *shape == ValueShape::Scalar);
    picture.outline.scalar_equations = scalar.map(|(equation, _)| equation.to_string()).collect();
    let sheet = skeleton_points(&picture, names);
    (picture.outline, sheet)
}

/// The equations with the shapes of their sides.
fn equations<'a>(
    declaration: &'a Declaration,
    model: &Model,
) -> impl Iterator<Item = (&'a EquationStatement, ValueShape)> {
    let equations = declaration.statements.iter().filter_map(|statement| match statement {
        Statement::Equation(equation) => Some(equation),
        _ => None,
    });
    equations
        .zip(&model.equations)
        .map(|(equation, declared)| (equation, declared.residual.shape()))
}

fn picture<'a>(declaration: &'a Declaration, model: &Model, names: &'a Names) -> Picture<'a> {
    let names = &SkeletonNames::new(declaration, model, names);
    let (equations, shapes): (Vec<&EquationStatement>, Vec<ValueShape>) = equations(declaration, model)
        .filter(|(_, shape)| matches!(shape, ValueShape::Plane | ValueShape::Space))
        .unzip();
    let points: Vec<&OutputStatement> = declaration
        .statements
        .iter()
        .filter_map(|statement| match statement {
            Statement::Output(output) if matches!(output.dimension, Dimension::Point | Dimension::Point3) => {
                Some(output)
            }
            _ => None,
        })
        .collect();
    if let Some(picture) = statements::picture(declaration, &points, names) {
        return picture;
    }
    // a plane chain beside one of space lies in the plane of x and y
    let spatial =
        shapes.contains(&ValueShape::Space) || points.iter().any(|output| output.dimension == Dimension::Point3);
    let shape = if spatial { ValueShape::Space } else { ValueShape::Plane };
    closures::picture(&equations, &points, shape, names)
}

/// The joints that are shown, each built upon those before it, and the directions of the slides.
fn skeleton_points(picture: &Picture<'_>, names: &Names) -> Sheet {
    let shape = picture.outline.shape;
    let joint = |joint: usize| Tree::local(shape, Local::Joint(joint));
    let mut needed: BTreeSet<usize> = BTreeSet::new();
    for &shown in &picture.shown {
        let mut next = Some(shown);
        while let Some(joint) = next {
            needed.insert(joint);
            next = picture.joints[joint].before;
        }
    }
    let bindings = needed.into_iter().map(|needed| {
        let known = &picture.joints[needed];
        let value = match known.term {
            None => Tree::call(shape, Operation::Zero, Vec::new()),
            Some(term) => {
                let value = in_picture(names.formula(term.formula), shape);
                match (known.before.map(joint), term.negative) {
                    (Some(before), true) => difference(before, value),
                    (Some(before), false) => sum(before, value),
                    (None, true) => value.negated(),
                    (None, false) => value,
                }
            }
        };
        let local = Local::Joint(needed);
        Binding { local, value }
    });
    let shown = picture.shown.iter().map(|&shown| joint(shown));
    let results = shown.chain(picture.directions.iter().cloned());
    names.sheet(bindings.collect(), results.collect())
}

/// A term as a vector of the shape of the whole picture.
fn in_picture(term: Tree, shape: ValueShape) -> Tree {
    if (term.shape, shape) == (ValueShape::Plane, ValueShape::Space) {
        Tree::call(shape, Operation::InSpace, vec![term])
    } else {
        lifted(term, shape)
    }
}

#[cfg(test)]
mod tests;
