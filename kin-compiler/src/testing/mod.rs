//! The tests of the whole macro, and code that tests of several rooms share.

pub(crate) mod declarations;
pub(crate) mod definitions;
mod expansion;
mod families;
mod fuzz;
mod growth;
pub(crate) mod library;
mod limits;
mod mistakes;
mod optimiser;
mod written_out;

use proc_macro2::TokenStream;

use crate::mistakes::Mistakes;
use crate::model::{self, Model};
use crate::passes::Passes;
use crate::plan::{Task, plan};
use crate::program::Solvers;
use crate::structure::Structure;
use crate::{expand, syntax};

/// A declaration without mistakes.
pub(crate) struct Sound {
    model: Model,
    structure: Structure,
}

/// Reads a declaration without mistakes.
pub(crate) fn sound(declaration: TokenStream) -> Sound {
    let mut mistakes = Mistakes::new();
    let sound = syntax::parse(declaration, &mut mistakes).and_then(|declaration| {
        let model = model::build(&declaration, &mut mistakes)?;
        let structure = expand::structure(&declaration, &model, &mut mistakes)?;
        Some(Sound { model, structure })
    });
    assert!(mistakes.is_empty(), "the declaration has mistakes");
    sound.expect("there are no mistakes")
}

impl Sound {
    /// The task of planning its solvers.
    pub(crate) fn task(&self, passes: Passes) -> Task<'_> {
        Task::new(&self.model, &self.structure, passes)
    }

    /// Its solvers. The declaration must not be too large.
    pub(crate) fn solvers(&self, passes: Passes) -> Solvers {
        plan(&self.task(passes)).expect("it is small")
    }
}
