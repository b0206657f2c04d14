//! The algebra: a hash-consed graph of expressions in normal form, and the elementary functions in them.
//!
//! Equal expressions are one node, because every constructor brings its result into a normal form before it looks
//! whether it is there already: sums are flat with numeric coefficients, products are flat with integer exponents,
//! sines and cosines have their quarter turns and signs taken out. Nodes are numbered in the order in which they are
//! made, and nothing depends on a hash's order, so the same declaration gives the same graph, byte for byte.

mod construct;
mod content;
mod evaluate;
mod function;
mod graph;
mod harmonic;
mod hash;
mod partial;
mod print;
mod probe;
mod substitute;

pub(crate) use function::{Calculation, Checked, Function, Gives, Inverse, InverseFunction, Takes, Work};
pub(crate) use graph::{Constant, Graph, Misfit, Node, NodeKind, Symbol, Variables};
pub(crate) use harmonic::{Angle, Expansion, Harmonic, Monomial, Polynomial};
pub(crate) use hash::HashMap;
pub(crate) use probe::Probe;
