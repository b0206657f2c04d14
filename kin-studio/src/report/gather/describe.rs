//! The content of the declaration: names, equations, blocks, costs and the outline.

use kin_core::any::Description;
use kin_core::{Dimension, Operations};

use crate::names::symbol;
use crate::report::model::{self, Block, Body, Cost, Outline, Point, Slide};

/// Quantities with their names in the solver, and with their values where they are known.
pub(super) fn quantities(
    quantities: &[kin_core::any::Quantity<'_>],
    keys: &[String],
    value: impl Fn(usize) -> Option<f64>,
) -> Vec<model::Quantity> {
    let entry = |(index, quantity): (usize, &kin_core::any::Quantity<'_>)| model::Quantity {
        name: quantity.name.to_owned(),
        key: keys
            .get(index)
            .cloned()
            .unwrap_or_else(|| quantity.name.replace('.', "_")),
        text: symbol(quantity.name),
        documentation: quantity.description.trim().to_owned(),
        dimension: match quantity.dimension {
            Dimension::Length => model::Dimension::Length,
            Dimension::Angle => model::Dimension::Angle,
            Dimension::Scalar => model::Dimension::Number,
        },
        value: value(index),
    };
    quantities.iter().enumerate().map(entry).collect()
}

/// The equations and their solution.
pub(super) fn formulas(formulas: &kin_core::any::Formulas<'_>) -> model::Formulas {
    let formula = |formula: &kin_core::any::Formula<'_>| model::Formula {
        text: formula.text.to_owned(),
        mathml: formula.mathml.to_owned(),
    };
    model::Formulas {
        closure: formula(&formulas.closure),
        position: formulas.position.iter().map(formula).collect(),
        velocity: formulas.velocity.iter().map(formula).collect(),
        rates: formula(&formulas.rates),
        outputs: formula(&formulas.outputs),
    }
}

/// The solutions of the blocks.
pub(super) fn blocks(description: &Description<'_>) -> Vec<Block> {
    let blocks = description.blocks.iter();
    let block = |block: &kin_core::any::Block<'_>| Block {
        unknowns: block.unknowns.to_owned(),
        solution: block.solution.to_owned(),
    };
    blocks.map(block).collect()
}

/// The cost of each order.
pub(super) fn operations(description: &Description<'_>) -> Vec<Cost> {
    let orders = description.operations.iter().enumerate();
    orders
        .map(|(order, cost)| Cost {
            order,
            total: cost.arithmetic(),
            text: in_words(cost),
        })
        .collect()
}

fn in_words(cost: &Operations) -> String {
    let kinds = [
        (cost.arithmetic(), "operation", "operations"),
        (cost.square_roots, "square root", "square roots"),
        (cost.sine_cosines, "sine-cosine pair", "sine-cosine pairs"),
        (cost.arc_tangents, "arctangent", "arctangents"),
        (cost.others, "other function", "other functions"),
    ];
    let there = kinds.iter().filter(|(count, ..)| *count > 0);
    let words: Vec<String> = there
        .map(|(count, one, more)| format!("{count} {}", if *count == 1 { one } else { more }))
        .collect();
    if words.is_empty() {
        "nothing".to_owned()
    } else {
        words.join(", ")
    }
}

/// The joints of the ground, of bodies and of slides.
pub(super) fn outline(outline: &kin_core::any::Outline<'_>) -> Outline {
    Outline {
        ground: outline.ground.to_vec(),
        bodies: outline
            .bodies
            .iter()
            .map(|body| Body {
                name: body.name.to_owned(),
                joints: body.joints.to_vec(),
            })
            .collect(),
        slides: outline
            .slides
            .iter()
            .map(|slide| Slide {
                joint: slide.joint,
                guide: slide.guide,
            })
            .collect(),
        points: outline
            .points
            .iter()
            .map(|&(name, joint)| Point {
                name: name.to_owned(),
                joint,
            })
            .collect(),
    }
}
