//! The names of symbols in generated code.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::Symbol;

/// The names that generated code needs for itself beside the names of a program.
pub(crate) const OWN_NAMES: [&str; 13] = [
    "assembly",
    "near",
    "failure",
    "pose",
    "position",
    "result",
    "candidate",
    "size",
    "first",
    "second",
    "decided",
    "choices",
    "values",
];

/// The names of symbols in generated code. No two are equal.
#[derive(Clone, Default)]
pub(crate) struct Names {
    by_symbol: BTreeMap<Symbol, String>,
    taken: BTreeSet<String>,
    /// The last number appended to each wish.
    last: BTreeMap<String, usize>,
    /// The number of values whose symbols were created with their names.
    values: usize,
}

impl Names {
    /// A free name that is as close to the wish as possible.
    pub(crate) fn unique(&mut self, wish: &str) -> String {
        if self.taken.insert(wish.to_owned()) {
            return wish.to_owned();
        }
        let last = self.last.entry(wish.to_owned()).or_insert(1);
        loop {
            *last += 1;
            let name = format!("{wish}_{last}");
            if self.taken.insert(name.clone()) {
                return name;
            }
        }
    }

    /// Makes a name unavailable.
    pub(crate) fn reserve(&mut self, name: &str) {
        self.taken.insert(name.to_owned());
    }

    /// Names a symbol.
    pub(crate) fn name(&mut self, symbol: Symbol, wish: &str) {
        let name = self.unique(wish);
        self.by_symbol.insert(symbol, name);
    }

    /// Gives a symbol exactly the name that it was declared with.
    pub(crate) fn name_exactly(&mut self, symbol: Symbol, name: &str) {
        self.reserve(name);
        self.by_symbol.insert(symbol, name.to_owned());
    }

    /// A new symbol, with a name that is as close to the wish as possible.
    pub(crate) fn value(&mut self, wish: &str) -> Symbol {
        let symbol = Symbol::Value(self.values);
        self.values += 1;
        self.name(symbol, wish);
        symbol
    }

    /// Takes over the names of an inner scope, which began as a copy of these. A name of that scope may be used again
    /// outside.
    pub(crate) fn adopt(&mut self, inner: Self) {
        self.values = inner.values;
        for (symbol, name) in inner.by_symbol {
            self.by_symbol.entry(symbol).or_insert(name);
        }
    }

    /// The name of a symbol, which must have one.
    pub(crate) fn of(&self, symbol: Symbol) -> &str {
        self.by_symbol.get(&symbol).map_or("unnamed", String::as_str)
    }
}
