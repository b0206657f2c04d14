//! The names of a declaration and their meanings. All names share one namespace.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Ident;

use crate::mistakes::{Mistakes, nearest, suggestion};
use crate::model::value::Typed;
use crate::syntax::{Declaration, Statement, TypedFormula, form, is_keyword};
use crate::work;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NameRole {
    Parameter,
    Input,
    Unknown,
    Let,
    Output,
}

impl NameRole {
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Parameter => "parameter",
            Self::Input => "input",
            Self::Unknown => "unknown",
            Self::Let => "`let`",
            Self::Output => "output",
        }
    }
}

/// The meaning of a name in a formula.
pub(super) enum Meaning {
    Value(Typed),
    /// A `let` or an output that comes later.
    Later,
    /// A `let` or an output with a mistake in its formula, which has been reported.
    Broken,
}

pub(super) struct Entry {
    pub(super) name: Ident,
    pub(super) role: NameRole,
    pub(super) meaning: Meaning,
    pub(super) used: bool,
}

/// The namespace, in the order of declaration.
pub(super) struct Scope<'a> {
    pub(super) entries: Vec<Entry>,
    indices: BTreeMap<String, usize>,
    declaration: &'a Declaration,
    /// Names that a misspelt name was probably meant for. They count as used.
    meant: BTreeSet<String>,
    /// Names that are declared more than once. Which declaration is used cannot be said.
    twice: BTreeSet<String>,
    /// Whether a function has no arguments. The names that it would have used are unknown.
    lacks_arguments: bool,
}

impl<'a> Scope<'a> {
    pub(super) fn new(declaration: &'a Declaration) -> Self {
        Self {
            entries: Vec::new(),
            indices: BTreeMap::new(),
            declaration,
            meant: BTreeSet::new(),
            twice: BTreeSet::new(),
            lacks_arguments: false,
        }
    }

    /// Adds a name. A second declaration of a name is a mistake, and the first stays.
    pub(super) fn declare(&mut self, name: &Ident, role: NameRole, meaning: Meaning, mistakes: &mut Mistakes) {
        let word = name.to_string();
        if let Some(&index) = self.indices.get(&word) {
            let first = &self.entries[index];
            let mut error = syn::Error::new(
                name.span(),
                format!(
                    "`{word}` is declared twice: choose another name for this {}",
                    role.word()
                ),
            );
            error.combine(syn::Error::new(
                first.name.span(),
                format!("the first `{word}` is declared here, as {}", with_article(first.role)),
            ));
            mistakes.push(error);
            self.twice.insert(word);
            return;
        }
        self.indices.insert(word, self.entries.len());
        self.entries.push(Entry {
            name: name.clone(),
            role,
            meaning,
            used: false,
        });
    }

    /// Sets the meaning of a `let` or an output. A second one of the same name is ignored.
    pub(super) fn define(&mut self, name: &Ident, meaning: Meaning) {
        if let Some(&index) = self.indices.get(&name.to_string()) {
            let entry = &mut self.entries[index];
            if matches!(entry.meaning, Meaning::Later) {
                entry.meaning = meaning;
            }
        }
    }

    /// The value of a name in a formula; `None` after a mistake.
    pub(super) fn resolve(&mut self, name: &Ident, mistakes: &mut Mistakes) -> Option<Typed> {
        let word = name.to_string();
        let Some(&index) = self.indices.get(&word) else {
            // one of the names that are declared twice was probably meant to be this one
            if self.declaration.has_fields && !self.declaration.broken.contains(&word) && self.twice.is_empty() {
                mistakes.error(name, self.unknown_name(&word));
            }
            return None;
        };
        let entry = &mut self.entries[index];
        entry.used = true;
        match &entry.meaning {
            Meaning::Value(value) => return Some(value.clone()),
            Meaning::Broken => {}
            Meaning::Later => {
                let word = self.declaration.fresh.written(&word);
                let statement = match entry.role {
                    NameRole::Output => format!("output {word}: …"),
                    _ => format!("let {word} = …"),
                };
                mistakes.error(
                    name,
                    format!("`{word}` is used before it is known: move `{statement};` above this"),
                );
            }
        }
        None
    }

    fn unknown_name(&mut self, word: &str) -> String {
        if work::is_spent() {
            // nobody reads it, and each takes as long as there are names
            return String::new();
        }
        if is_keyword(word) {
            return format!("`{word}` is a keyword of Rust and cannot be a name; choose another one");
        }
        if let Some(form) = form(word) {
            self.lacks_arguments = true;
            return format!("`{word}` is a function: write its arguments, as in `{form}`");
        }
        if self.declaration.fresh.is_inner(word) {
            return format!("`{word}` is a name within a `for`, and known there alone: use it in its braces");
        }
        let broken = &self.declaration.broken;
        let usable: Vec<String> = self
            .entries
            .iter()
            .map(|entry| entry.name.to_string())
            .chain(broken.iter().filter(|name| !is_keyword(name)).cloned())
            .chain(["PI".to_owned()])
            .collect();
        let likely = nearest(word, usable.iter().map(String::as_str));
        let is_body = self.declaration.statements.iter().any(|statement| match statement {
            Statement::Body(body) => body.name == word,
            _ => false,
        });
        if is_body {
            return format!("`{word}` is a body and no quantity: write one of its points");
        }
        // any letter resembles any other
        let is_like_another = likely.is_some_and(|near| near.to_ascii_lowercase().contains(word));
        let near = if word == "π" {
            "; write `PI`".to_owned()
        } else if !is_like_another && matches!(word, "i" | "j") {
            "; a complex number is a vector here: write `vec2(x, y)`, or `cis(angle)` for a turn".to_owned()
        } else if !is_like_another && matches!(word, "t" | "time") {
            format!("; time is no quantity by itself: drive the mechanism by an input, `input {word}: Scalar;`")
        } else if word.eq_ignore_ascii_case("tau") {
            "; write `2 * PI` for the full turn".to_owned()
        } else if is_constant_of_rust(word) && likely.is_none_or(|near| !near.eq_ignore_ascii_case(word)) {
            ": constants of Rust are not seen here; make it a parameter, or write its value".to_owned()
        } else if likely.is_none()
            && let Some(axis) = axis(word)
        {
            format!(": declare it as one of these; the direction of this axis is `{axis}`")
        } else if likely.is_none() {
            ": declare it as one of these".to_owned()
        } else {
            suggestion(word, usable.iter().map(String::as_str))
        };
        self.meant.extend(likely.map(str::to_owned));
        format!("no parameter, input, unknown, `let` or output is called `{word}`{near}")
    }

    /// Counts a name in a wrong position as used, because the mistake there has been reported.
    pub(super) fn mean(&mut self, word: &str) {
        self.meant.insert(word.to_owned());
    }

    /// Counts the names in a formula as used that is not read, because a mistake before it has been reported.
    pub(super) fn mean_all(&mut self, formula: &TypedFormula) {
        formula.visit_names(&mut |name| self.mean(&name.to_string()));
    }

    /// Whether no parameter, input, unknown, `let` or output has this name.
    pub(super) fn is_free(&self, word: &str) -> bool {
        !self.indices.contains_key(word) && !self.declaration.broken.contains(word)
    }

    /// Whether a name is declared more than once.
    pub(super) fn has_twins(&self) -> bool {
        !self.twice.is_empty()
    }

    /// Whether a name counts as used, because a reported mistake is about it: a misspelt name was probably meant for
    /// it, it is declared twice, or a function lacks its arguments.
    pub(super) fn is_meant(&self, word: &str) -> bool {
        self.meant.contains(word) || self.twice.contains(word) || self.lacks_arguments
    }
}

/// The unit vector along the axis with this name.
fn axis(word: &str) -> Option<&'static str> {
    match word {
        "x" | "X" => Some("vec2(1, 0)"),
        "y" | "Y" => Some("vec2(0, 1)"),
        "z" | "Z" => Some("vec3(0, 0, 1)"),
        _ => None,
    }
}

/// Whether a word is spelt as Rust spells its constants: two capitals or more, and no small letter.
fn is_constant_of_rust(word: &str) -> bool {
    word.chars().filter(|letter| letter.is_uppercase()).count() > 1 && !word.chars().any(char::is_lowercase)
}

fn with_article(role: NameRole) -> String {
    let article = match role {
        NameRole::Input | NameRole::Unknown | NameRole::Output => "an",
        NameRole::Parameter | NameRole::Let => "a",
    };
    format!("{article} {}", role.word())
}
