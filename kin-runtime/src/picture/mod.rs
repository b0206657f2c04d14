//! The drawing of a mechanism, and the angles that are read from it.

mod outline;
mod points;
mod skeleton;
mod transmission;

pub use outline::{Body, Outline, Slide};
pub use points::{PlaneOrSpace, PointArray};
pub use skeleton::Skeleton;
pub use transmission::TransmissionAngle;
