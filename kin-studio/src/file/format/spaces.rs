//! Where a blank stands between two atoms, and where a line may end.

use super::atoms::{Atom, Kind, LONG_SIGNS};
use super::is_documentation;

/// Words between operands.
const BETWEEN: [&str; 6] = ["in", "where", "along", "on", "at", "by"];

/// Whether an operand ends with an atom.
fn is_operand(atoms: &[Atom<'_>], index: usize) -> bool {
    let atom = &atoms[index];
    match atom.kind {
        Kind::Word => !is_between(atoms, index),
        Kind::Close => true,
        _ => false,
    }
}

fn is_between(atoms: &[Atom<'_>], index: usize) -> bool {
    let before = index.checked_sub(1).map(|before| atoms[before].kind);
    BETWEEN.contains(&atoms[index].text) && matches!(before, Some(Kind::Word | Kind::Close))
}

/// Whether a sign has a single operand.
fn is_unary(atoms: &[Atom<'_>], index: usize) -> bool {
    atoms[index].is("-") && (index == 0 || !is_operand(atoms, index - 1))
}

/// Whether an atom and the atom before it belong to one value, behind the `=` of its name.
fn is_in_value(atoms: &[Atom<'_>], index: usize) -> bool {
    let before = atoms[..index.saturating_sub(1)].iter().rev();
    before.take_while(|atom| !atom.is(";")).any(|atom| atom.is("="))
}

/// The text between an atom and the atom before it.
pub(super) fn space(atoms: &[Atom<'_>], index: usize, as_typed: bool) -> &'static str {
    let Some(before) = index.checked_sub(1).map(|before| &atoms[before]) else {
        return "";
    };
    let atom = &atoms[index];
    let text = atom.text;
    let together = format!("{}{text}", before.text);
    // together they would be another sign, or a comment
    let is_other = LONG_SIGNS.iter().chain(&["//", "/*"]).any(|other| *other == together);
    if before.kind == Kind::Sign && is_other {
        return " ";
    }
    if matches!(text, "," | ";" | ":") && atom.kind == Kind::Sign {
        return "";
    }
    if before.kind == Kind::Line || atom.kind == Kind::Line || before.is(";") {
        return " ";
    }
    if before.is("{") || atom.is("}") || atom.is("{") {
        let is_empty = before.is("{") && atom.is("}");
        return if is_empty { "" } else { " " };
    }
    if as_typed && is_in_value(atoms, index) {
        return if atom.is_apart { " " } else { "" };
    }
    if before.is(",") {
        return " ";
    }
    let is_tight = |atom: &Atom<'_>| matches!(atom.text, "." | ".." | "..=" | "::") && atom.kind == Kind::Sign;
    // `1.` before `..` would be another number; `'` is the beginning of a name
    let is_joined = is_tight(atom) && !before.text.ends_with('.') || is_tight(before) || before.is("'");
    let is_call = atom.is("(") && before.kind == Kind::Word && before.text != "for" && !is_between(atoms, index - 1);
    let is_inside = matches!(before.text, "(" | "[") || matches!(text, ")" | "]");
    if is_joined || is_call || is_inside || is_unary(atoms, index - 1) {
        ""
    } else {
        " "
    }
}

/// Whether a line may end before an atom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Break {
    Never,
    /// The less, the better.
    At(usize),
    Always,
}

impl Break {
    /// Behind a comma that is in no parentheses.
    pub(super) const BETWEEN_ELEMENTS: Self = Self::At(1);

    pub(super) fn level(self) -> Option<usize> {
        match self {
            Self::At(level) => Some(level),
            Self::Never | Self::Always => None,
        }
    }
}

/// The breaks before each of the atoms.
pub(super) fn breaks(atoms: &[Atom<'_>], as_typed: bool) -> Vec<Break> {
    let mut depth = 0_usize;
    let mut breaks = Vec::new();
    for (index, atom) in atoms.iter().enumerate() {
        if atom.kind == Kind::Close {
            depth = depth.saturating_sub(1);
        }
        let before = index.checked_sub(1).map(|before| &atoms[before]);
        let level = match (before, atom.text) {
            (None, _) => Break::Never,
            (Some(before), _) if before.kind == Kind::Line => Break::Always,
            _ if atom.kind == Kind::Line && (atom.lines_before > 0 || is_documentation(atom)) => Break::Always,
            _ if atom.kind == Kind::Line => Break::Never,
            _ if as_typed && is_in_value(atoms, index) => Break::Never,
            (Some(before), _) if before.is(",") || before.is(";") => Break::At(8 * depth + 1),
            (_, "==") => Break::At(8 * depth),
            (_, "+" | "-") if !is_unary(atoms, index) => Break::At(8 * depth + 2),
            (_, "*" | "/") => Break::At(8 * depth + 3),
            _ if is_between(atoms, index) => Break::At(8 * depth + 1),
            _ => Break::Never,
        };
        if atom.kind == Kind::Open {
            depth += 1;
        }
        breaks.push(level);
    }
    breaks
}
