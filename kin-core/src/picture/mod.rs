//! What is drawn of a mechanism, or read from its drawing.

mod skeleton;
mod transmission;

pub use skeleton::{Chain, Polyline, Skeleton};
pub use transmission::TransmissionAngle;
