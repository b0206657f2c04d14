//! One declaration of a mechanism yields exactly what a careful person derives by hand: position, velocity,
//! acceleration, jerk and snap.
//!
//! This binary proves that sentence. It begins with one table of three ways, [`three_ways`], which is the place to
//! start reading. The other files prove more: more mechanisms, more poses, more digits.

mod three_ways;

mod high_precision;
mod jacobians;
mod notes_are_consistent;
mod notes_formulas;
mod oracles;
mod outputs;
mod printed_values;
mod sensitivities;
mod series_of_many_digits;
mod verify;
