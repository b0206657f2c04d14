//! The names that failures state.

use kin_compiler::lowered::{Description, Label};
use kin_core::any::{Name, NameKind};

/// The names that failures state. Unknowns that are no block, and outputs of several numbers, are groups: their names
/// are kept here, as the description of the mechanism needs them.
pub(crate) struct Labels<'d> {
    description: &'d Description,
    outputs: &'d [(String, usize)],
    pub(crate) groups: Vec<String>,
}

impl<'d> Labels<'d> {
    pub(crate) fn new(description: &'d Description, outputs: &'d [(String, usize)]) -> Self {
        Self {
            description,
            outputs,
            groups: Vec::new(),
        }
    }

    /// The name that a label stands for.
    pub(crate) fn name(&mut self, label: &Label) -> Name {
        match label {
            Label::Unknowns(unknowns) => self.unknowns(unknowns),
            Label::Output(output) => {
                let first: usize = self.outputs[..*output].iter().map(|(_, parts)| parts).sum();
                match &self.outputs[*output] {
                    (_, 1) => Name::by_index(NameKind::Output, first),
                    (name, _) => self.group(name.clone()),
                }
            }
            Label::Outputs => Name::new("the outputs"),
            Label::Rates => Name::new("the rates"),
        }
    }

    /// The name of some unknowns.
    pub(crate) fn unknowns(&mut self, unknowns: &[usize]) -> Name {
        let mut blocks = self.description.blocks.iter();
        if let Some(block) = blocks.position(|block| block.members == unknowns) {
            return Name::by_index(NameKind::Block, block);
        }
        if let [unknown] = unknowns {
            return Name::by_index(NameKind::Unknown, *unknown);
        }
        let names = unknowns
            .iter()
            .map(|&unknown| &*self.description.unknowns[unknown].name);
        self.group(names.collect::<Vec<_>>().join(", "))
    }

    fn group(&mut self, name: String) -> Name {
        let known = self.groups.iter().position(|group| *group == name);
        let index = known.unwrap_or_else(|| {
            self.groups.push(name);
            self.groups.len() - 1
        });
        Name::by_index(NameKind::Group, index)
    }
}
