//! kin's solvers as functions of SQL.
//!
//! Every mechanism becomes some functions, made from its description. They have the name of its type in small letters:
//!
//! | function | gives, for each row |
//! |---|---|
//! | `four_bar(…)` | a pose: unknowns and outputs with their rates, `outcome`, `margin` |
//! | `four_bar_turn(…)` | a revolution: whether it closes, transmission, swings, peaks and where they are |
//! | `hoeken_linkage_line(…)` | how straight and how evenly a point moves over a part of a revolution |
//! | `hoeken_linkage_path_error(…)` | the distances of wanted points from the path of a point |
//!
//! A mechanism has a revolution if its first input is an angle and every block has a closed form; its other inputs
//! stand. A mechanism with coupled blocks has only poses, because its position is known from values nearby. Paths are
//! those of the first output in the plane.
//!
//! [`Functions`] is a list of functions. Those of the library are there from the beginning; a program adds its own
//! mechanisms, or declares others while it runs.

pub(crate) mod arguments;
mod assembly;
mod declaration;
mod line;
mod list;
mod names;
mod numbers;
mod path;
mod points;
mod pose;
mod search;
mod settings;
mod solver;
mod trace;
mod turn;
pub(crate) mod used;

#[cfg(feature = "cluster")]
pub(crate) use declaration::declaration_of;
pub use declaration::{DeclarationError, Owner};
pub use list::{Functions, functions, register};
pub(crate) use path::ENDING;
pub(crate) use points::{Points, text_of};
#[cfg(feature = "cluster")]
pub(crate) use pose::is_solver;
pub use settings::Settings;
pub(crate) use turn::TurnFunction;
