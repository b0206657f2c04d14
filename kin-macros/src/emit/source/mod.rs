//! Methods that are translated from the syntax tree, and not from the graph.
//!
//! The closure is an oracle: a verification compares what the solvers find with it. So it shares no code with the algebra that derives the
//! solvers. The skeleton is drawn from the same vectors as they were typed.

pub(super) mod closure;
pub(super) mod skeleton;
