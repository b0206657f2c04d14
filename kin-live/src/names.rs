//! The description and the picture of a mechanism, which own their names.

use kin_compiler::{Dimension, ValueShape, lowered, tree};
use kin_core::any::{Block, Body, Description, Outline, Quantity};
use kin_core::{Operations, Slide};
use self_cell::self_cell;

/// The names that a description borrows.
pub(crate) struct Names {
    pub(crate) description: lowered::Description,
    /// The names of groups in errors.
    pub(crate) groups: Vec<String>,
    pub(crate) outline: tree::Outline,
}

/// Quantities and blocks, whose names are borrowed.
struct Tables<'n> {
    parameters: Vec<Quantity<'n>>,
    inputs: Vec<Quantity<'n>>,
    unknowns: Vec<Quantity<'n>>,
    outputs: Vec<Quantity<'n>>,
    equations: Vec<&'n str>,
    blocks: Vec<Block<'n>>,
    operations: Vec<Operations>,
    groups: Vec<&'n str>,
    bodies: Vec<Body<'n>>,
    slides: Vec<Slide>,
    points: Vec<(&'n str, usize)>,
    scalar_equations: Vec<&'n str>,
}

self_cell!(
    struct TablesWithNames {
        owner: Names,

        #[covariant]
        dependent: Tables,
    }
);

self_cell!(
    /// A description with its names.
    pub(crate) struct OwnedDescription {
        owner: TablesWithNames,

        #[covariant]
        dependent: Description,
    }
);

impl OwnedDescription {
    pub(crate) fn of(names: Names) -> Self {
        let tables = TablesWithNames::new(names, tables);
        Self::new(tables, |tables| {
            let name = &tables.borrow_owner().description.name;
            let order = tables.borrow_owner().description.order;
            let tables = tables.borrow_dependent();
            let description = Description::__new(
                name,
                &tables.parameters,
                &tables.inputs,
                &tables.unknowns,
                &tables.outputs,
                &tables.equations,
                &tables.blocks,
                order,
                &tables.operations,
            );
            description.__with_groups(&tables.groups)
        })
    }

    /// The description.
    pub(crate) fn get(&self) -> &Description<'_> {
        self.borrow_dependent()
    }

    /// Whether the picture is one in space.
    pub(crate) fn is_space(&self) -> bool {
        self.borrow_owner().borrow_owner().outline.shape == ValueShape::Space
    }

    /// The joints of the ground, of bodies and of slides.
    pub(crate) fn outline(&self) -> Outline<'_> {
        let tables = self.borrow_owner();
        let Tables {
            bodies,
            slides,
            points,
            scalar_equations,
            ..
        } = tables.borrow_dependent();
        Outline {
            ground: &tables.borrow_owner().outline.ground,
            bodies,
            slides,
            points,
            scalar_equations,
            guess: tables.borrow_owner().outline.guess.as_deref(),
        }
    }
}

fn tables(names: &Names) -> Tables<'_> {
    let Names {
        description, outline, ..
    } = names;
    Tables {
        parameters: description.parameters.iter().map(quantity).collect(),
        inputs: description.inputs.iter().map(quantity).collect(),
        unknowns: description.unknowns.iter().map(quantity).collect(),
        outputs: description.outputs.iter().map(quantity).collect(),
        equations: description.equations.iter().map(String::as_str).collect(),
        blocks: description
            .blocks
            .iter()
            .map(|block| Block::__new(&block.unknowns, &block.solution, &block.members, &block.equations))
            .collect(),
        operations: description.operations.iter().copied().map(Operations::__of).collect(),
        groups: names.groups.iter().map(String::as_str).collect(),
        bodies: outline
            .bodies
            .iter()
            .map(|body| Body::new(&body.name, &body.joints))
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
            .map(|(name, joint)| (name.as_str(), *joint))
            .collect(),
        scalar_equations: outline.scalar_equations.iter().map(String::as_str).collect(),
    }
}

fn quantity(quantity: &lowered::DescribedQuantity) -> Quantity<'_> {
    let (name, text) = (quantity.name.as_str(), quantity.text.as_str());
    let mut described = match quantity.dimension {
        Dimension::Angle => Quantity::angle(name, text),
        Dimension::Scalar => Quantity::scalar(name, text),
        _ => Quantity::length(name, text),
    };
    described.has_range = quantity.has_range;
    described.is_direction = quantity.is_direction;
    described
}

impl std::fmt::Debug for OwnedDescription {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.get().fmt(formatter)
    }
}
