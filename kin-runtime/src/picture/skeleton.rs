//! The picture of a mechanism: its rigid bodies, and what joins them.

use super::{Outline, PlaneOrSpace, PointArray, Slide};

/// A mechanism in one position: joints, the bodies between them, and what stands still.
///
/// The closure is the picture. Terms of its vector equations that rotate together are one body, terms without any input
/// or unknown are the ground, and a joint at the end of a term of variable length slides along it. A declaration whose
/// equations do not determine that states its bodies itself, by `body`, `ground` and `slide`. Joints that coincide are
/// one joint. An output that is a point belongs to the body whose terms it continues.
///
/// A mechanism makes its skeleton, by a generated method; generic code calls
/// [`Mechanism::skeleton`](crate::Mechanism::skeleton). `P` is an array of [`Plane`](crate::Plane) or of
/// [`Space`](crate::Space): the joints, and behind them a direction for each slide. Nothing is allocated.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let position = linkage.position(std::f64::consts::FRAC_PI_2, Assembly::Open)?;
/// let skeleton = linkage.skeleton(&position);
///
/// let names: Vec<&str> = skeleton.bodies().map(|(name, _)| name).collect();
/// assert_eq!(names, ["r2", "r3", "r4"]);
/// let pivots: Vec<Plane> = skeleton.ground().collect();
/// assert_eq!(pivots, [Plane::new(0.0, 0.0), Plane::new(90.0, 0.0)]);
/// // the crank's joints: its pivot, and its pin that the coupler shares
/// let (_, crank) = skeleton.bodies().next().unwrap();
/// let crank: Vec<Plane> = crank.collect();
/// assert!((crank[1] - Plane::new(0.0, 30.0)).norm_squared() < 1e-28);
/// # Ok::<(), SolveError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Skeleton<'d, P> {
    outline: &'d Outline<'d>,
    points_and_directions: P,
}

impl<'d, P: PointArray> Skeleton<'d, P> {
    /// From the outline, and the joints with the directions of the slides behind them.
    #[doc(hidden)]
    pub const fn new(outline: &'d Outline<'d>, points_and_directions: P) -> Self {
        Self {
            outline,
            points_and_directions,
        }
    }

    /// Which joints belong together.
    pub fn outline(&self) -> &'d Outline<'d> {
        self.outline
    }

    /// The joints and marked points, each once, in the mechanism's unit of length.
    pub fn joints(&self) -> &[P::Point] {
        let points_and_directions = self.points_and_directions.as_slice();
        let count = points_and_directions.len().saturating_sub(self.outline.slides.len());
        points_and_directions.get(..count).unwrap_or_default()
    }

    /// The joints that stand still.
    pub fn ground(&self) -> impl Iterator<Item = P::Point> {
        self.joints_of(self.outline.ground)
    }

    /// The bodies that move, each with its name and its joints.
    pub fn bodies(&self) -> impl Iterator<Item = (&'d str, impl Iterator<Item = P::Point>)> {
        let bodies = self.outline.bodies.iter();
        bodies.map(|body| (body.name, self.joints_of(body.joints)))
    }

    /// The slides, each with its joint and the direction of its line. The direction may have any length but zero.
    pub fn slides(&self) -> impl Iterator<Item = (&'d Slide, [P::Point; 2])> {
        let joints = self.joints();
        let directions = self.points_and_directions.as_slice().iter().skip(joints.len());
        let slides = self.outline.slides.iter().zip(directions);
        slides.filter_map(|(slide, &direction)| Some((slide, [*joints.get(slide.joint)?, direction])))
    }

    /// The outputs that are points, with their names, in the order in which they were declared.
    pub fn points(&self) -> impl Iterator<Item = (&'d str, P::Point)> {
        let joints = self.joints();
        let points = self.outline.points.iter();
        points.filter_map(|&(name, joint)| Some((name, *joints.get(joint)?)))
    }

    /// Whether it lies in the plane.
    pub fn is_plane(&self) -> bool {
        P::Point::IS_PLANE
    }

    fn joints_of(&self, numbers: &'d [usize]) -> impl Iterator<Item = P::Point> {
        let joints = self.joints();
        numbers.iter().filter_map(|&number| joints.get(number).copied())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Body;
    use super::*;
    use crate::geometry::Plane;
    use std::vec::Vec;

    static OUTLINE: Outline<'static> = Outline {
        ground: &[0],
        bodies: &[Body::new("crank", &[0, 1]), Body::new("rod", &[1, 2])],
        slides: &[Slide::on_ground(2)],
        points: &[("pin", 1)],
        scalar_equations: &[],
        guess: None,
    };

    #[test]
    fn directions_stand_behind_the_joints() {
        let [pivot, pin, piston, along] =
            [(0.0, 0.0), (0.0, 1.0), (3.0, 0.0), (1.0, 0.0)].map(|(x, y)| Plane::new(x, y));
        let skeleton = Skeleton::new(&OUTLINE, [pivot, pin, piston, along]);
        assert_eq!(skeleton.joints(), [pivot, pin, piston]);
        assert_eq!(skeleton.ground().collect::<Vec<_>>(), [pivot]);
        let bodies: Vec<(&str, Vec<Plane>)> = skeleton
            .bodies()
            .map(|(name, joints)| (name, joints.collect()))
            .collect();
        assert_eq!(
            bodies,
            [("crank", [pivot, pin].to_vec()), ("rod", [pin, piston].to_vec())]
        );
        let slides: Vec<_> = skeleton.slides().collect();
        assert_eq!(slides, [(&Slide::on_ground(2), [piston, along])]);
        assert_eq!(skeleton.points().collect::<Vec<_>>(), [("pin", pin)]);
        assert!(skeleton.is_plane());
    }
}
