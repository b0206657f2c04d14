//! Methods that are translated from the syntax tree instead of the graph.
//!
//! The closure is an oracle: a verification compares the solvers' results with it. So it shares no code with the
//! algebra that derives the solvers, and the residuals at a solution are an independent check. The skeleton is drawn
//! from the same vectors, as they were typed.

mod closure;
mod formula;
mod names;
mod outputs;
mod sheet;
mod skeleton;
pub mod tree;

use crate::model::Model;
use crate::syntax::Declaration;
use names::Names;
use tree::Sheets;

/// All translated methods of a declaration.
pub(crate) fn sheets(declaration: &Declaration, model: &Model) -> Sheets {
    let names = Names::new(declaration, model);
    let (outline, skeleton_points) = skeleton::outline(declaration, model, &names);
    Sheets {
        closure: closure::sheet(declaration, &names),
        outputs: outputs::sheet(declaration, &names),
        skeleton_points,
        outline,
    }
}
