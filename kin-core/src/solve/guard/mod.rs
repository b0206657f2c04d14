//! Tests before a solver continues: domains of functions, declared ranges, determinants, whole turns.

mod domain;
mod range;
mod regular;
mod turn;

pub use domain::{
    arc_cosine, arc_sine, area_hyperbolic_cosine, area_hyperbolic_tangent, cosine_of_arc, hyperbolic_cosine_of_area,
    logarithm, sine_of_arc, square_of_root, square_root_of, tangent_of_arc,
};
pub use range::{check_angle, check_value, choose};
pub use regular::{finite, regular};
pub use turn::{agreeing, nearest_turn, on_turn, within_turns};
