//! The names of a declaration with their notation.

use std::collections::{BTreeMap, BTreeSet};

use super::name::{Base, Name};
use crate::algebra::Symbol;
use crate::model::{Model, ValueShape};
use crate::syntax::{Axis, Declaration, Statement, shape};

/// The notation of every name of a declaration, and the names that are still free.
pub(super) struct NotationNames {
    known: BTreeMap<String, (Name, ValueShape)>,
    /// Each scalar parameter: its vector's name and its axis, or its name.
    parameters: Vec<(Name, Option<Axis>)>,
    inputs: Vec<Name>,
    unknowns: Vec<Name>,
    taken: Vec<Name>,
}

impl NotationNames {
    pub(super) fn new(declaration: &Declaration, model: &Model) -> Self {
        let mut known: BTreeMap<String, (Name, ValueShape)> = BTreeMap::new();
        let mut seen: BTreeMap<String, usize> = BTreeMap::new();
        let identifiers = identifiers(declaration, model);
        let notation = |identifier: &str| Name::of_identifier(identifier);
        let printed = |name: &Name| format!("{:?}{:?}{}", name.base, name.indices, name.dots);
        for (identifier, _) in &identifiers {
            *seen.entry(printed(&notation(identifier))).or_default() += 1;
        }
        let bases: BTreeSet<String> = seen.keys().cloned().collect();
        for (identifier, shape) in identifiers {
            let name = notation(&identifier);
            // dots would be taken for a rate of the same name without them
            let is_rate = name.dots > 0
                && bases.contains(&printed(&Name {
                    dots: 0,
                    ..name.clone()
                }));
            let is_unique = seen[&printed(&name)] == 1 && !is_rate;
            let name = if is_unique { name } else { Name::verbatim(&identifier) };
            let is_vector = matches!(shape, ValueShape::Plane | ValueShape::Space);
            known.insert(identifier, (name.marked_as_vector(is_vector), shape));
        }
        let of = |identifier: &str| {
            let entry: Option<&(Name, ValueShape)> = known.get(identifier);
            entry.map_or_else(|| Name::verbatim(identifier), |(name, _)| name.clone())
        };
        let mut names = Self {
            parameters: Vec::new(),
            inputs: model.inputs.iter().map(|input| of(&input.name.to_string())).collect(),
            unknowns: model
                .unknowns
                .iter()
                .map(|unknown| of(&unknown.name.to_string()))
                .collect(),
            taken: known.values().map(|(name, _)| name.clone()).collect(),
            known: BTreeMap::new(),
        };
        for parameter in &model.parameters {
            let name = of(&parameter.name.to_string());
            let axes = parameter.dimension.shape().axes();
            if axes.is_empty() {
                names.parameters.push((name, None));
            } else {
                names
                    .parameters
                    .extend(axes.iter().map(|&axis| (name.clone(), Some(axis))));
            }
        }
        names.known = known;
        names
    }

    /// The notation and the shape of a declared name.
    pub(super) fn of(&self, identifier: &str) -> Option<&(Name, ValueShape)> {
        self.known.get(identifier)
    }

    pub(super) fn unknown(&self, index: usize) -> &Name {
        &self.unknowns[index]
    }

    /// The vector of which a symbol is the part along an axis.
    pub(super) fn part(&self, symbol: Symbol) -> Option<(&Name, Axis)> {
        match symbol {
            Symbol::Parameter(index) => {
                let (name, axis) = self.parameters.get(index)?;
                Some((name, (*axis)?))
            }
            _ => None,
        }
    }

    /// The notation of a parameter, an input or an unknown.
    pub(super) fn symbol(&self, symbol: Symbol) -> Option<Name> {
        Some(match symbol {
            Symbol::Parameter(index) => {
                let (name, axis) = self.parameters.get(index)?.clone();
                match axis {
                    Some(axis) => component(name, axis),
                    None => name,
                }
            }
            Symbol::Input(index) => self.inputs.get(index)?.clone(),
            Symbol::Unknown(index) => self.unknowns.get(index)?.clone(),
            _ => return None,
        })
    }

    /// A name of the formulas: the wanted letter or one instead of it, whichever no name of the declaration begins
    /// with. If all are taken, it is the wanted one with a prime.
    pub(super) fn fresh(&self, wanted: char) -> Name {
        let is_free = |letter: &char| !self.taken.iter().any(|taken| taken.base == Base::Letter(*letter));
        let others = INSTEAD
            .iter()
            .find(|(letter, _)| *letter == wanted)
            .map_or("", |(_, others)| others);
        let letter = [wanted].into_iter().chain(others.chars()).find(is_free);
        letter.map_or_else(
            || Name {
                primes: 1,
                ..Name::letter(wanted)
            },
            Name::letter,
        )
    }

    /// Whether a name looks like the base or the imaginary unit of e^(iθ).
    pub(super) fn look_complex(&self) -> bool {
        let looks = |name: &Name| matches!(name.base, Base::Letter('e' | 'i')) && name.indices.is_empty();
        self.taken.iter().any(looks)
    }
}

/// The letters instead of others that are taken. Those of one solution are different.
const INSTEAD: [(char, &str); 13] = [
    ('a', "pA"),
    ('b', "qB"),
    ('c', "sC"),
    ('d', "wD"),
    ('f', "F"),
    ('g', "G"),
    ('h', "H"),
    ('k', "mK"),
    ('u', "nU"),
    ('x', "qX"),
    ('y', "zY"),
    ('A', "MK"),
    ('e', "E"),
];

/// The part of a vector along an axis.
pub(super) fn component(name: Name, axis: Axis) -> Name {
    name.marked_as_vector(false).indexed(axis.to_string())
}

/// All declared names with their shapes, in the order of the declaration.
fn identifiers(declaration: &Declaration, model: &Model) -> Vec<(String, ValueShape)> {
    let mut all: Vec<(String, ValueShape)> = Vec::new();
    all.extend(
        model
            .parameters
            .iter()
            .map(|parameter| (parameter.name.to_string(), parameter.dimension.shape())),
    );
    all.extend(
        model
            .inputs
            .iter()
            .map(|input| (input.name.to_string(), ValueShape::Scalar)),
    );
    all.extend(
        model
            .unknowns
            .iter()
            .map(|unknown| (unknown.name.to_string(), ValueShape::Scalar)),
    );
    all.extend(
        model
            .outputs
            .iter()
            .map(|output| (output.name.to_string(), output.dimension.shape())),
    );
    let mut shapes: BTreeMap<String, ValueShape> = all.iter().cloned().collect();
    for statement in &declaration.statements {
        if let Statement::Let(statement) = statement {
            let name = statement.name.to_string();
            let shape = shape(&statement.value, &|name| shapes.get(name).copied());
            shapes.insert(name.clone(), shape);
            all.push((name, shape));
        }
    }
    all
}
