//! Limits to what the compilation of a text may cost.

use std::fmt;

use crate::text::Mistake;

/// What compiling a declaration may cost at most.
///
/// Others may have written the text. The depth of its formulas is limited to 256, and it is compiled with a stack of
/// 256 MB, of which only what is used becomes memory. All other memory is in proportion to the text and to the work: up
/// to 600 bytes for each unit, and two microseconds. The largest mechanism of the library takes 99 000 units.
///
/// ```
/// use kin_compiler::{Budget, Declaration, Refusal, Resource};
///
/// let text = "struct Lever { a: Length } input t: Angle; unknown h: Length; h == a * sin(t);";
/// let budget = Budget { work: 100_000, ..Budget::default() };
/// assert!(Declaration::parse_within(text, &budget).is_ok());
/// let Err(Refusal::TooLarge(excess)) = Declaration::parse_within(text, &Budget { work: 10, ..budget }) else {
///     panic!("its derivatives alone take more");
/// };
/// assert_eq!((excess.resource, excess.limit), (Resource::Work, 10));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// The bytes of the text.
    pub text: usize,
    /// The work: expressions that are looked up, and iterations of the other loops that may grow faster than the text.
    /// It is the same in every run on every machine.
    pub work: usize,
}

impl Default for Budget {
    /// 32 KiB of text, and 400 000 units of work.
    fn default() -> Self {
        Self {
            text: 32 << 10,
            work: 400_000,
        }
    }
}

/// A thing of which a declaration takes too much.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Resource {
    /// Bytes of text: [`Budget::text`].
    Text,
    /// Work of the compiler: [`Budget::work`].
    Work,
    /// Values of the machine that runs the solver.
    Values,
    /// Assemblies, among which the solver chooses.
    Assemblies,
}

/// A declaration that takes more of something than is allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct TooLarge {
    /// What it takes too much of.
    pub resource: Resource,
    /// How much is allowed.
    pub limit: usize,
}

impl TooLarge {
    /// More than the limit of something.
    #[must_use]
    pub const fn new(resource: Resource, limit: usize) -> Self {
        Self { resource, limit }
    }
}

impl fmt::Display for TooLarge {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let limit = self.limit;
        match self.resource {
            Resource::Text => write!(formatter, "this text has more than {limit} bytes"),
            Resource::Work => write!(
                formatter,
                "this mechanism takes more than {limit} units of work to compile: ask for a lower `order`, for fewer \
                 outputs or no sensitivities"
            ),
            Resource::Values => write!(formatter, "the solver of this mechanism has more than {limit} values"),
            Resource::Assemblies => write!(formatter, "this mechanism has more than {limit} assemblies"),
        }
    }
}

impl std::error::Error for TooLarge {}

/// The reason why a text is not compiled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The mistakes of the declaration, in the order of the text.
    Mistakes(Vec<Mistake>),
    /// The declaration costs more than the budget allows.
    TooLarge(TooLarge),
}

impl fmt::Display for Refusal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mistakes(mistakes) => {
                for (index, mistake) in mistakes.iter().enumerate() {
                    let separator = if index == 0 { "" } else { "\n" };
                    write!(formatter, "{separator}{mistake}")?;
                }
                Ok(())
            }
            Self::TooLarge(excess) => excess.fmt(formatter),
        }
    }
}

impl std::error::Error for Refusal {}
