//! Functions of mechanisms that are declared by a text, while the program runs.

use std::any::Any;
use std::error::Error;
use std::fmt;

use datafusion::execution::SessionStateDefaults;
use datafusion::logical_expr::ScalarUDF;
use kin_live::DeclareError;

use super::line::LineFunction;
use super::names::{of_order, plain};
use super::path::PathFunction;
use super::pose::PoseFunction;
use super::solver::{OfMechanism, SearchedMechanism};
use super::turn::TurnFunction;

/// The reason why a text gives no functions.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum DeclarationError {
    /// The text declares no mechanism.
    Declare(DeclareError),
    /// A function has this name already.
    Taken {
        /// The name of the mechanism.
        mechanism: String,
        /// The name of the function.
        function: String,
        /// Who has the function.
        owner: Owner,
    },
    /// Two arguments or two fields of a function would have the same name.
    Alike {
        /// The name of the function.
        function: String,
        /// The name of the arguments or fields.
        name: String,
    },
}

/// Who has a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Owner {
    /// The program: the library, or a mechanism that rustc compiled.
    Program,
    /// Another declaration.
    Declaration,
    /// SQL itself.
    Sql,
}

impl From<DeclareError> for DeclarationError {
    fn from(error: DeclareError) -> Self {
        Self::Declare(error)
    }
}

impl fmt::Display for DeclarationError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Declare(error) => error.fmt(formatter),
            Self::Taken {
                mechanism,
                function,
                owner,
            } => {
                let owner = match owner {
                    Owner::Program => "the library has",
                    Owner::Declaration => "another declaration has",
                    Owner::Sql => "SQL has",
                };
                write!(
                    formatter,
                    "the mechanism `{mechanism}` would have the function `{function}`, which {owner} already; give the \
                     structure another name"
                )
            }
            Self::Alike { function, name } => write!(
                formatter,
                "the function `{function}` would have `{name}` twice: names in SQL have small letters only, and `_` in \
                 the place of a point. Give the quantity another name"
            ),
        }
    }
}

impl Error for DeclarationError {}

/// The text that declares the mechanism of a function, if it has one.
pub(crate) fn declaration_of(function: &ScalarUDF) -> Option<&str> {
    fn of<F: OfMechanism + 'static>(function: &dyn Any) -> Option<&SearchedMechanism> {
        function.downcast_ref::<F>().map(F::mechanism)
    }
    let function: &dyn Any = function.inner().as_ref();
    of::<PoseFunction>(function)
        .or_else(|| of::<TurnFunction>(function))
        .or_else(|| of::<LineFunction>(function))
        .or_else(|| of::<PathFunction>(function))?
        .declaration()
}

/// Whether SQL has a function of this name.
pub(super) fn is_of_sql(name: &str) -> bool {
    let is_it = |own: &str, aliases: &[String]| own == name || aliases.iter().any(|alias| alias == name);
    let scalars = SessionStateDefaults::default_scalar_functions();
    let aggregates = SessionStateDefaults::default_aggregate_functions();
    let windows = SessionStateDefaults::default_window_functions();
    scalars
        .iter()
        .any(|function| is_it(function.name(), function.aliases()))
        || (aggregates.iter()).any(|function| is_it(function.name(), function.aliases()))
        || windows
            .iter()
            .any(|function| is_it(function.name(), function.aliases()))
}

/// The first name that a function would give to two of its arguments or fields.
pub(super) fn alike(mechanism: &SearchedMechanism, functions: &[&ScalarUDF]) -> Option<DeclarationError> {
    let description = mechanism.description();
    let found = description.unknowns.iter().chain(description.outputs);
    let fields = found.flat_map(|quantity| (0..=description.order).map(|order| of_order(&plain(quantity), order)));
    let fields = fields.chain(["outcome", "margin"].map(str::to_owned));
    let of_fields = repeated(fields).zip(functions.first().copied());
    let of_arguments = functions.iter().find_map(|function| {
        let names = function.signature().parameter_names.clone().unwrap_or_default();
        repeated(names).map(|name| (name, *function))
    });
    let (name, function) = of_arguments.or(of_fields)?;
    Some(DeclarationError::Alike {
        function: function.name().to_owned(),
        name,
    })
}

/// The first name that was there before.
fn repeated(names: impl IntoIterator<Item = String>) -> Option<String> {
    let mut seen = std::collections::BTreeSet::new();
    names.into_iter().find(|name| !seen.insert(name.clone()))
}
