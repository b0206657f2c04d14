//! The outline as statements give it.

use std::collections::BTreeMap;

use super::closures::Chains;
use super::outline::Picture;
use super::terms::terms;
use super::{SkeletonNames, in_picture};
use crate::model::ValueShape;
use crate::syntax::{Declaration, FormulaKind, OutputStatement, Statement, TypedFormula};
use crate::translate::tree::{Body, Outline, Slide};

/// The picture of the statements, `None` if there are none. Outputs that are points are marked as well.
pub(super) fn picture<'a>(
    declaration: &'a Declaration,
    points: &[&'a OutputStatement],
    names: &SkeletonNames<'a>,
) -> Option<Picture<'a>> {
    let outputs: BTreeMap<String, &TypedFormula> = declaration
        .statements
        .iter()
        .filter_map(|statement| match statement {
            Statement::Output(output) => Some((output.name.to_string(), &output.value)),
            _ => None,
        })
        .collect();
    let behind = |formula: &'a TypedFormula| match &formula.kind {
        FormulaKind::Name(name) => outputs.get(&name.to_string()).copied().unwrap_or(formula),
        _ => formula,
    };
    let stated = |statement: &'a Statement| match statement {
        Statement::Body(body) => body.points.as_slice(),
        Statement::Ground(ground) => ground.points.as_slice(),
        Statement::Slide(slide) => std::slice::from_ref(&slide.point),
        _ => &[],
    };
    let all: Vec<&TypedFormula> = declaration.statements.iter().flat_map(stated).map(behind).collect();
    if all.is_empty() {
        return None;
    }
    let spatial = all.iter().any(|point| names.shape(point) == ValueShape::Space);
    let shape = if spatial { ValueShape::Space } else { ValueShape::Plane };
    let mut chains = Chains::new(shape, names);
    let mut shown: Vec<usize> = Vec::new();
    let mut index_of = |formula: &'a TypedFormula| {
        let joint = chains.chain(terms(formula, names));
        shown.iter().position(|&known| known == joint).unwrap_or_else(|| {
            shown.push(joint);
            shown.len() - 1
        })
    };
    let (mut ground, mut bodies, mut slides, mut directions) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for statement in &declaration.statements {
        match statement {
            Statement::Body(body) => bodies.push(Body {
                name: body.name.to_string(),
                joints: body.points.iter().map(|point| index_of(behind(point))).collect(),
            }),
            Statement::Ground(statement) => {
                ground.extend(statement.points.iter().map(|point| index_of(behind(point))));
            }
            Statement::Slide(slide) => {
                slides.push((index_of(behind(&slide.point)), slide.guide.as_ref()));
                directions.push(in_picture(names.tree(&slide.direction), shape));
            }
            _ => {}
        }
    }
    let points = points
        .iter()
        .map(|output| (output.name.to_string(), index_of(&output.value)))
        .collect();
    let number = |name: &proc_macro2::Ident| bodies.iter().position(|body: &Body| *name == body.name);
    let slides = slides.into_iter().map(|(joint, guide)| Slide {
        joint,
        guide: guide.and_then(number),
    });
    let outline = Outline {
        shape,
        joints: shown.len(),
        ground,
        slides: slides.collect(),
        bodies,
        points,
        scalar_equations: Vec::new(),
        guess: None,
    };
    Some(Picture {
        outline,
        joints: chains.into_joints(),
        shown,
        directions,
    })
}
