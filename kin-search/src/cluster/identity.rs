//! What the processes of a cluster must share: the version and the functions.

use std::fmt;

use crate::function::Functions;

/// The version and the functions of a process.
///
/// Processes of one cluster must agree in both. Another version can round differently, and a function that is missing
/// fails in the middle of a search. Functions of declarations go with a query, and need not be there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Identity {
    fingerprint: String,
    functions: Vec<String>,
}

impl Identity {
    /// The identity of a process with these functions.
    #[must_use]
    pub fn of(functions: &Functions) -> Self {
        Self {
            fingerprint: functions.fingerprint(),
            functions: functions.list_of_program(),
        }
    }

    /// A short text that differs where anything of the identity differs: the version, and a digest of the functions.
    #[must_use]
    pub fn tag(&self) -> &str {
        &self.fingerprint
    }

    /// The names of the functions, in order.
    fn functions(&self) -> impl Iterator<Item = &str> {
        self.functions
            .iter()
            .map(|function| function.split('(').next().unwrap_or_default())
    }
}

/// One line, for messages: `kin-search 0.1.0-4f… with 2 functions: four_bar four_bar_turn`.
impl fmt::Display for Identity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "kin-search {} with {} functions:",
            self.fingerprint,
            self.functions.len()
        )?;
        self.functions().try_for_each(|function| write!(f, " {function}"))
    }
}

/// The name under which an executor registers: its tag, and what tells it from others.
pub(super) fn executor_name(identity: &Identity) -> String {
    let nanoseconds = std::time::SystemTime::now()
        .duration_since(std::time::UNIX_EPOCH)
        .map_or(0, |since| since.as_nanos());
    format!("{}_{:x}_{nanoseconds:x}", identity.tag(), std::process::id())
}

/// The tag in the name of an executor; the whole name, if it has another form.
pub(super) fn tag_of(executor: &str) -> &str {
    executor.split_once('_').map_or(executor, |(tag, _)| tag)
}
