//! The algebra: a hash-consed graph of expressions in normal form, and their elementary functions.
//!
//! Equal expressions are one node, because every constructor brings its result into normal form before it looks the
//! node up. In normal form, sums are flat with numeric coefficients, products are flat with integer exponents, and
//! sines and cosines have their right angles and signs taken out. Nodes are numbered in the order of creation, and
//! nothing depends on the order of a hash table. So the same declaration gives the same graph, byte for byte.

mod amplitude;
mod construct;
mod content;
mod evaluate;
mod function;
mod graph;
mod harmonic;
mod hash;
mod linear_parts;
mod partial;
mod print;
mod probe;
mod substitute;
mod table;

pub use function::Function;
pub(crate) use function::{Calculation, Checked, Gives, Inverse, InverseFunction, Takes, WorkUnit};
pub use graph::Symbol;
pub(crate) use graph::{FiniteNumber, Graph, Misfit, Node, NodeKind, Variables};
pub(crate) use harmonic::{Angle, Expansion, Harmonic, Monomial, TrigonometricPolynomial};
pub(crate) use hash::HashMap;
pub(crate) use linear_parts::LinearParts;
pub(crate) use probe::Probe;
pub(crate) use table::{Index, IndexTable};
