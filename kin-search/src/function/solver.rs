//! A mechanism of any origin, with its columns by index.

use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

use kin_core::batch::{AnyBatch, AnyFold};

/// What the functions of SQL need of a mechanism.
pub(crate) trait Solver: AnyBatch + AnyFold + Send + Sync {}

impl<F: AnyBatch + AnyFold + Send + Sync> Solver for F {}

/// A mechanism whose functions are called in SQL. Copies share it.
#[derive(Clone)]
pub(crate) struct SearchedMechanism(Arc<Inner>);

struct Inner {
    solver: Box<dyn Solver>,
    declaration: Option<String>,
}

impl SearchedMechanism {
    /// A mechanism that the program has before it reads declarations.
    pub(crate) fn of_program(solver: impl Solver + 'static) -> Self {
        Self(Arc::new(Inner {
            solver: Box::new(solver),
            declaration: None,
        }))
    }

    /// A mechanism of a declaration, and the text of that declaration, which goes with a query.
    pub(crate) fn declared(solver: impl Solver + 'static, declaration: &str) -> Self {
        Self(Arc::new(Inner {
            solver: Box::new(solver),
            declaration: Some(declaration.to_owned()),
        }))
    }

    /// The text that goes with a query, unless every program has the mechanism.
    pub(crate) fn declaration(&self) -> Option<&str> {
        self.0.declaration.as_deref()
    }
}

/// A function of a mechanism.
pub(crate) trait OfMechanism {
    fn mechanism(&self) -> &SearchedMechanism;
}

impl Deref for SearchedMechanism {
    type Target = dyn Solver;

    fn deref(&self) -> &Self::Target {
        &*self.0.solver
    }
}

impl fmt::Debug for SearchedMechanism {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.description().name)
    }
}
