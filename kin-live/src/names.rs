//! The description of a mechanism, which owns its names.

use kin_compiler::Dimension;
use kin_compiler::lowered;
use kin_core::Operations;
use kin_core::any::{Block, Description, Quantity};
use self_cell::self_cell;

/// What a description borrows from.
pub(crate) struct Names {
    pub(crate) description: lowered::Description,
    /// The names of groups in errors.
    pub(crate) groups: Vec<String>,
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
}

fn tables(names: &Names) -> Tables<'_> {
    let description = &names.description;
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
    }
}

fn quantity(quantity: &lowered::DescribedQuantity) -> Quantity<'_> {
    let (name, text) = (quantity.name.as_str(), quantity.text.as_str());
    let described = match quantity.dimension {
        Dimension::Angle => Quantity::angle(name, text),
        Dimension::Scalar => Quantity::scalar(name, text),
        _ => Quantity::length(name, text),
    };
    if quantity.has_range {
        described.with_range()
    } else {
        described
    }
}

impl std::fmt::Debug for OwnedDescription {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.get().fmt(formatter)
    }
}
