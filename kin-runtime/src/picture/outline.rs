//! The parts of a picture that are known before the mechanism is put into a position.

/// Which joints belong together, whatever the position. Joints are named by their numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Outline<'d> {
    /// The joints that stand still. Those that a body shares are its fixed pivots.
    pub ground: &'d [usize],
    /// The rigid bodies that move.
    pub bodies: &'d [Body<'d>],
    /// The joints that are guided along a line.
    pub slides: &'d [Slide],
    /// The marked points, each with the number of its joint.
    pub points: &'d [(&'d str, usize)],
    /// The equations that are no vectors, as that of a gear, which the picture does not show.
    pub scalar_equations: &'d [&'d str],
    /// The statements that would declare it, if it was guessed from the vector equations:
    /// `body r2: 0, r2 * cis(theta2);` and so on, one in a line. `None` if the declaration states its bodies itself.
    pub guess: Option<&'d str>,
}

impl Outline<'_> {
    /// The outline of a mechanism of which nothing can be drawn.
    pub const NONE: Self = Self {
        ground: &[],
        bodies: &[],
        slides: &[],
        points: &[],
        scalar_equations: &[],
        guess: None,
    };
}

/// A rigid body that moves: its joints keep their distances.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Body<'d> {
    /// The name as it was declared, or the length that the body is known by.
    pub name: &'d str,
    /// The numbers of its joints.
    pub joints: &'d [usize],
}

impl<'d> Body<'d> {
    /// The body with these joints.
    #[must_use]
    pub const fn new(name: &'d str, joints: &'d [usize]) -> Self {
        Self { name, joints }
    }
}

/// A joint that slides along a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Slide {
    /// The number of the joint.
    pub joint: usize,
    /// The number of the body that carries the line, `None` if the line stands still.
    pub guide: Option<usize>,
}

impl Slide {
    /// The slide of a joint along a line of the ground.
    #[must_use]
    pub const fn on_ground(joint: usize) -> Self {
        Self { joint, guide: None }
    }

    /// The slide of a joint along a line that a body carries.
    #[must_use]
    pub const fn on_body(joint: usize, body: usize) -> Self {
        Self {
            joint,
            guide: Some(body),
        }
    }
}
