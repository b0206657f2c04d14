//! The names of a declaration: each once.

use std::collections::BTreeSet;

/// The names that are taken.
#[derive(Default)]
pub(crate) struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// Takes a name, or the first of `name_2`, `name_3` … that is free.
    pub(crate) fn take(&mut self, name: &str) -> String {
        let others = (2..).map(|number| format!("{name}_{number}"));
        let free = std::iter::once(name.to_owned())
            .chain(others)
            .find(|name| !self.taken.contains(name))
            .expect("there are more numbers than names");
        self.taken.insert(free.clone());
        free
    }

    /// Takes a name as it is; `false` if it is taken.
    pub(crate) fn take_as_it_is(&mut self, name: &str) -> bool {
        self.taken.insert(name.to_owned())
    }
}
