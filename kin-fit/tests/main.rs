//! Fits and searches, in one program, because rustc compiles the mechanisms again for each program.

mod fit;
mod problems;
mod refine;
