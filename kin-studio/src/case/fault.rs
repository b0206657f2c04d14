//! The reasons why the program does not do what it was asked, each with the code that it ends with.

use std::fmt;
use std::process::ExitCode;

/// A reason, in words for the person at the terminal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// The mechanism does not close where it is asked for, or a fit ended before a minimum. The code is 1.
    Failed(String),
    /// The program cannot use an argument or a file. The code is 2.
    Wrong(String),
}

impl Fault {
    /// A mistake of the person who typed.
    pub(crate) fn wrong(message: impl fmt::Display) -> Self {
        Self::Wrong(message.to_string())
    }

    /// A mechanism that does not close, or another result that was asked for and is not there.
    pub(crate) fn failed(message: impl fmt::Display) -> Self {
        Self::Failed(message.to_string())
    }

    /// The same reason in other words.
    pub(crate) fn map(self, words: impl FnOnce(String) -> String) -> Self {
        match self {
            Self::Failed(message) => Self::Failed(words(message)),
            Self::Wrong(message) => Self::Wrong(words(message)),
        }
    }

    /// The code that the program ends with.
    pub(crate) fn code(&self) -> ExitCode {
        ExitCode::from(match self {
            Self::Failed(_) => 1,
            Self::Wrong(_) => 2,
        })
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Self::Failed(message) | Self::Wrong(message)) = self;
        formatter.write_str(message)
    }
}

/// `did you mean ..?`, or all names if none is similar.
pub(crate) fn similar<'n>(wanted: &str, names: impl IntoIterator<Item = &'n str>) -> String {
    let names: Vec<&str> = names.into_iter().collect();
    let plain = |name: &str| name.replace(['_', '-'], "").to_lowercase();
    let likeness = |name: &str| strsim::jaro_winkler(&plain(wanted), &plain(name));
    let best = names
        .iter()
        .map(|name| (likeness(name), *name))
        .max_by(|one, other| one.0.total_cmp(&other.0));
    match best {
        Some((likeness, name)) if likeness > 0.8 => format!("did you mean `{name}`?"),
        _ if names.is_empty() => "there is none".to_owned(),
        _ => format!("there is {}", listed(&names)),
    }
}

/// Names between commas, with the marks of names.
pub(crate) fn listed(names: &[&str]) -> String {
    let marked: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match marked.as_slice() {
        [] => String::new(),
        [only] => only.clone(),
        [some @ .., last] => format!("{} and {last}", some.join(", ")),
    }
}
