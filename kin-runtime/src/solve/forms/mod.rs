//! The closed forms, one per file.

mod circle_circle;
mod circle_line;
mod cosine_sine;
mod inverse;
mod inverse_hyperbolic;
mod linear;
mod polar;
mod quadratic;
mod refusal;
mod root;
mod square_root;

pub use circle_circle::{circle_circle, circle_circle_squared};
pub use circle_line::{circle_line, circle_line_x, circle_line_y};
pub use cosine_sine::cosine_sine;
pub use inverse::{inverse_cosine, inverse_sine};
pub use inverse_hyperbolic::inverse_hyperbolic_cosine;
pub use linear::{linear, linear_pair};
pub use polar::{polar, polar_offset};
pub use quadratic::quadratic;
pub use root::Root;
pub use square_root::square_root;
