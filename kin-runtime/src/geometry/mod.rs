//! Points, vectors and rotations.

mod numbers;
mod plane;
mod rotation;
mod space;

pub use plane::Plane;
pub use rotation::Rotation;
pub use space::Space;
