//! What a solver in JavaScript or Python is given and finds, quantity by quantity, with names of the language.

use std::collections::BTreeMap;
use std::format;
use std::string::{String, ToString as _};
use std::vec;
use std::vec::Vec;

use crate::quantity::Dimension;
use crate::tape::structure::Tape;
use crate::tape::words::DistinctNames;
use crate::tape::{ResultOf, Role};

/// A quantity with its rates.
pub(super) struct SignatureEntry<'d> {
    /// Its name in the language.
    pub(super) name: String,
    /// Its name as declared.
    declared: String,
    dimension: Dimension,
    description: &'d str,
    /// The index of each order among the arguments or the results of the tape.
    pub(super) indices: Vec<usize>,
}

impl SignatureEntry<'_> {
    /// A line about the quantity: its description, its dimension and its rates.
    pub(super) fn text(&self) -> String {
        let mut text = self.description.trim().trim_end_matches('.').to_string();
        if text.is_empty() {
            text = format!("`{}`", self.declared);
        }
        text.push_str(match self.dimension {
            Dimension::Length => "; a length",
            Dimension::Angle => "; an angle in radians",
            Dimension::Scalar => "; a number",
        });
        let rates = ["", "", ", acceleration", ", jerk", ", snap"];
        if self.indices.len() > 1 {
            let last = self.indices.len().min(rates.len());
            text = format!("{text}: position, velocity{}", rates[..last].concat());
            if self.indices.len() > rates.len() {
                text.push_str(" and higher rates");
            }
        }
        text
    }
}

/// The quantities of a tape.
pub(super) struct Signature<'d> {
    pub(super) parameters: Vec<SignatureEntry<'d>>,
    pub(super) inputs: Vec<SignatureEntry<'d>>,
    /// The values near unknowns, of a mechanism with coupled blocks.
    pub(super) near: Vec<SignatureEntry<'d>>,
    pub(super) assemblies: Vec<SignatureEntry<'d>>,
    /// The unknowns, the outputs and the partial derivatives.
    pub(super) results: Vec<SignatureEntry<'d>>,
    /// The indices among the results of the coordinates of each joint.
    pub(super) joints: Vec<Vec<usize>>,
    /// The same of the direction of each slide.
    pub(super) slides: Vec<Vec<usize>>,
}

impl<'d> Signature<'d> {
    /// The entries that a motion may have: those through snap, and more if the mechanism goes on to higher orders.
    const ENTRIES: usize = 5;

    /// The text that checks arguments, with the largest number of entries of a motion.
    pub(super) fn argument_checks(&self, text: &str) -> String {
        let entries = self.inputs.iter().map(|input| input.indices.len());
        let most = entries.max().unwrap_or(0).max(Self::ENTRIES);
        text.replace("@ENTRIES@", &most.to_string())
    }

    /// The parts of the skeleton that are there.
    pub(super) fn picture(&self) -> impl Iterator<Item = (&'static str, &Vec<Vec<usize>>)> {
        let parts = [("joints", &self.joints), ("slides", &self.slides)];
        parts.into_iter().filter(|(_, list)| !list.is_empty())
    }

    /// The quantities with names that are none of `taken`. A quantity has one name wherever it occurs.
    pub(super) fn new(tape: &Tape<'d>, taken: &'static [&'static str]) -> Self {
        let mut names = DistinctNames::new(taken);
        let mut known = BTreeMap::new();
        let mut name = |declared: &str| -> String {
            let distinct = known
                .entry(declared.to_string())
                .or_insert_with(|| names.name(declared));
            distinct.clone()
        };
        let mut signature = Self {
            parameters: Vec::new(),
            inputs: Vec::new(),
            near: Vec::new(),
            assemblies: Vec::new(),
            results: Vec::new(),
            joints: Vec::new(),
            slides: Vec::new(),
        };
        for (index, argument) in tape.arguments.iter().enumerate() {
            let (list, order) = match argument.role {
                Role::Parameter(_) => (&mut signature.parameters, 0),
                Role::Input { order, .. } => (&mut signature.inputs, order),
                Role::Near(_) => (&mut signature.near, 0),
                Role::Assembly(_) => (&mut signature.assemblies, 0),
            };
            match list.last_mut() {
                Some(last) if order > 0 => last.indices.push(index),
                _ => list.push(SignatureEntry {
                    name: name(&argument.name),
                    declared: argument.name.clone(),
                    dimension: argument.dimension,
                    description: argument.description,
                    indices: vec![index],
                }),
            }
        }
        for (index, result) in tape.results.iter().enumerate() {
            let parameter = |parameter: usize| tape.description.parameters[parameter].name;
            let declared = match result.quantity {
                ResultOf::Joint { joint, .. } => {
                    signature
                        .joints
                        .resize(signature.joints.len().max(joint + 1), Vec::new());
                    signature.joints[joint].push(index);
                    continue;
                }
                ResultOf::Slide { slide, .. } => {
                    signature
                        .slides
                        .resize(signature.slides.len().max(slide + 1), Vec::new());
                    signature.slides[slide].push(index);
                    continue;
                }
                ResultOf::Unknown(_) | ResultOf::Output(_) => result.name.clone(),
                ResultOf::UnknownPartial { unknown, parameter: by } => {
                    format!("{}_by_{}", tape.description.unknowns[unknown].name, parameter(by))
                }
                ResultOf::OutputPartial { output, parameter: by } => {
                    format!("{}_by_{}", tape.description.outputs[output].name, parameter(by))
                }
            };
            match signature.results.last_mut() {
                Some(last) if result.order > 0 => last.indices.push(index),
                _ => signature.results.push(SignatureEntry {
                    name: name(&declared),
                    declared,
                    dimension: result.dimension,
                    description: result.description,
                    indices: vec![index],
                }),
            }
        }
        signature
    }
}

/// The lines at the head of a file: the mechanism, its equations, its dimensions if they are constants, the version and
/// the licence.
pub(super) fn head(tape: &Tape<'_>) -> Vec<String> {
    let description = &tape.description;
    let version = env!("CARGO_PKG_VERSION");
    let mut lines = Vec::new();
    lines.push(format!(
        "The solver of `{}` through order {}, written by kin {version}.",
        description.name, tape.order
    ));
    lines.push(String::new());
    lines.push("Equations:".to_string());
    lines.extend(description.equations.iter().map(|equation| format!("  {equation}")));
    if tape.folded.is_empty() {
        lines.push("The dimensions are arguments.".to_string());
    } else {
        lines.push("Dimensions:".to_string());
        let pairs = description.parameters.iter().zip(&tape.folded);
        lines.extend(pairs.map(|(parameter, value)| format!("  {} = {value:?}", parameter.name)));
    }
    lines.push("Blocks in the order of solution:".to_string());
    lines.extend(
        description
            .blocks
            .iter()
            .map(|block| format!("  {}: {}", block.unknowns, block.solution)),
    );
    lines.push(String::new());
    let licence = env!("CARGO_PKG_LICENSE");
    lines.push(format!(
        "The functions of kin in this file are licensed under {licence}, as you choose."
    ));
    lines
}
