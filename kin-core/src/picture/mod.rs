//! What is drawn of a mechanism, or read from its drawing.

mod outline;
mod places;
mod skeleton;
mod transmission;

pub use outline::{Body, Outline, Slide};
pub use places::{Place, Places};
pub use skeleton::Skeleton;
pub use transmission::TransmissionAngle;
