//! Names in errors.

use core::fmt;

/// The name of a quantity or of a block in an error.
///
/// The names of a declared mechanism are constants of the program, and its errors hold them. A mechanism that is made
/// while the program runs may be dropped before its errors are. They hold an index instead, and
/// [`Named`](crate::any::Named) shows them with the names. So errors are small, can be copied, and outlive their
/// mechanism.
///
/// ```
/// use kin_core::any::{Name, NameKind};
///
/// let block = Name::from("theta3, theta4");
/// assert!(block == "theta3, theta4");
/// assert_eq!(block.to_string(), "theta3, theta4");
/// assert_eq!(Name::by_index(NameKind::Block, 1).to_string(), "‹block 1›");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Name(Source);

#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Source {
    Text(&'static str),
    Index(NameKind, u16),
}

/// The kind of the thing that a [`Name`] names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum NameKind {
    /// A scalar parameter.
    Parameter,
    /// An input.
    Input,
    /// An unknown.
    Unknown,
    /// A scalar output.
    Output,
    /// A block, whose name consists of its unknowns, separated by commas.
    Block,
    /// Several unknowns that are not a whole block, or an output of several numbers.
    Group,
}

impl NameKind {
    /// All kinds, each with its word.
    pub(crate) const ALL: [(Self, &'static str); 6] = [
        (Self::Parameter, "parameter"),
        (Self::Input, "input"),
        (Self::Unknown, "unknown"),
        (Self::Output, "output"),
        (Self::Block, "block"),
        (Self::Group, "group"),
    ];
}

impl Name {
    /// No name.
    pub const NONE: Self = Self::new("");

    /// The brackets around an index that stands for a name.
    pub(crate) const BRACKETS: [char; 2] = ['‹', '›'];

    /// A name that the program has.
    #[must_use]
    pub const fn new(text: &'static str) -> Self {
        Self(Source::Text(text))
    }

    /// The name that stands at an index of the description.
    #[must_use]
    pub fn by_index(of: NameKind, index: usize) -> Self {
        Self(Source::Index(of, u16::try_from(index).unwrap_or(u16::MAX)))
    }

    /// The text of the name, unless it is given by an index.
    #[must_use]
    pub const fn text(self) -> Option<&'static str> {
        match self.0 {
            Source::Text(text) => Some(text),
            Source::Index(..) => None,
        }
    }

    /// The index of the name in the description, unless it is given as a text.
    #[must_use]
    pub fn index(self) -> Option<(NameKind, usize)> {
        match self.0 {
            Source::Text(_) => None,
            Source::Index(of, index) => Some((of, index.into())),
        }
    }
}

impl Default for Name {
    fn default() -> Self {
        Self::NONE
    }
}

impl From<&'static str> for Name {
    fn from(text: &'static str) -> Self {
        Self::new(text)
    }
}

#[cfg(feature = "alloc")]
impl From<Name> for alloc::string::String {
    fn from(name: Name) -> Self {
        alloc::string::ToString::to_string(&name)
    }
}

impl PartialEq<str> for Name {
    fn eq(&self, text: &str) -> bool {
        self.text() == Some(text)
    }
}

impl PartialEq<&str> for Name {
    fn eq(&self, text: &&str) -> bool {
        self == *text
    }
}

impl fmt::Display for Name {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Source::Text(text) => formatter.pad(text),
            Source::Index(of, index) => {
                let [before, after] = Self::BRACKETS;
                let word = NameKind::ALL
                    .iter()
                    .find(|(kind, _)| *kind == of)
                    .map_or("", |(_, word)| word);
                write!(formatter, "{before}{word} {index}{after}")
            }
        }
    }
}

impl fmt::Debug for Name {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Source::Text(text) => write!(formatter, "{text:?}"),
            Source::Index(..) => write!(formatter, "{self}"),
        }
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Name {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
