//! The picture of a mechanism: its vector loops as polylines.

/// A mechanism in one position as lines between its joints.
///
/// The closure is the picture: each side of an equation between vectors is a chain of links, which begins at the
/// origin, and whose joints are the partial sums of its terms. Both sides of an equation end in the same
/// joint. The outputs that were declared as a `Point` are there as well.
///
/// A mechanism makes its own skeleton, by a generated method. `V` is a point, `JOINTS` and `POINTS` are the numbers of
/// all joints, those of all polylines counted, and of all points. Nothing is allocated.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let position = linkage.position(std::f64::consts::FRAC_PI_2, Assembly::Open)?;
/// let skeleton = linkage.skeleton(&position);
///
/// let [left, right] = [0, 1].map(|side| skeleton.polylines().nth(side).unwrap());
/// assert_eq!(left.name, "r2 * cis(theta2) + r3 * cis(theta3)");
/// assert_eq!(left.links, ["r2 * cis(theta2)", "r3 * cis(theta3)"]);
/// assert_eq!(left.joints.len(), 3);
/// assert!((left.joints[1] - Plane::new(0.0, 30.0)).norm_squared() < 1e-28);
/// assert_eq!(right.joints[1], Plane::new(90.0, 0.0));
/// assert!((left.joints[2] - right.joints[2]).norm_squared() < 1e-26);
/// # Ok::<(), SolveError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Skeleton<V, const JOINTS: usize, const POINTS: usize> {
    chains: &'static [Chain],
    joints: [V; JOINTS],
    names: &'static [&'static str; POINTS],
    points: [V; POINTS],
}

/// What is known of a polyline before the mechanism is put into a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Chain {
    /// The side of the equation, as it was declared.
    pub name: &'static str,
    /// The number of the equation, in the order of the description.
    pub equation: usize,
    /// The terms, one for each link.
    pub links: &'static [&'static str],
}

/// One side of a vector equation: the links from the origin to the joint where the loop closes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polyline<'a, V> {
    /// The side of the equation, as it was declared.
    pub name: &'static str,
    /// The number of the equation, in the order of the mechanism's description.
    pub equation: usize,
    /// The joints, the origin first, one more than links; in the mechanism's unit of length.
    pub joints: &'a [V],
    /// The links from joint to joint: the terms of the sum, such as `r2 * cis(theta2)`.
    pub links: &'static [&'static str],
}

impl<'a, V: Copy> Polyline<'a, V> {
    /// Each link with the joints at its ends.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let position = linkage.position(1.0, Assembly::Open)?;
    /// for polyline in linkage.skeleton(&position).polylines() {
    ///     for (link, [from, to]) in polyline.segments() {
    ///         println!("{link} from ({}, {}) to ({}, {})", from.x, from.y, to.x, to.y);
    ///     }
    /// }
    /// # Ok::<(), SolveError>(())
    /// ```
    pub fn segments(&self) -> impl Iterator<Item = (&'static str, [V; 2])> + use<'a, V> {
        let ends = self.joints.iter().zip(self.joints.iter().skip(1));
        self.links
            .iter()
            .zip(ends)
            .map(|(&link, (&from, &to))| (link, [from, to]))
    }
}

impl<V: Copy, const JOINTS: usize, const POINTS: usize> Skeleton<V, JOINTS, POINTS> {
    /// From what is known of the chains, the joints of all of them one after another, and the points with their names.
    #[doc(hidden)]
    pub const fn new(
        chains: &'static [Chain],
        joints: [V; JOINTS],
        names: &'static [&'static str; POINTS],
        points: [V; POINTS],
    ) -> Self {
        Self {
            chains,
            joints,
            names,
            points,
        }
    }

    /// The sides of the vector equations, left before right, in the order in which they were declared. A side that is
    /// zero is left out.
    pub fn polylines(&self) -> impl Iterator<Item = Polyline<'_, V>> {
        let mut others = self.joints.as_slice();
        self.chains.iter().map_while(move |chain| {
            let (joints, rest) = others.split_at_checked(chain.links.len() + 1)?;
            others = rest;
            Some(Polyline {
                name: chain.name,
                equation: chain.equation,
                joints,
                links: chain.links,
            })
        })
    }

    /// The outputs that are points, with their names, in the order in which they were declared.
    pub fn points(&self) -> impl Iterator<Item = (&'static str, V)> {
        self.names.iter().copied().zip(self.points)
    }

    /// All joints of all polylines; the origin is among them, and others are more than once.
    pub fn joints(&self) -> &[V] {
        &self.joints
    }
}

#[cfg(test)]
mod tests {
    use super::{Chain, Skeleton};
    use std::vec::Vec;

    static CHAINS: [Chain; 2] = [
        Chain {
            name: "a + b",
            equation: 0,
            links: &["a", "b"],
        },
        Chain {
            name: "c",
            equation: 0,
            links: &["c"],
        },
    ];

    #[test]
    fn each_polyline_has_its_own_joints() {
        let skeleton = Skeleton::new(&CHAINS, [0, 1, 2, 0, 2], &["p"], [7]);
        let joints: Vec<&[i32]> = skeleton.polylines().map(|polyline| polyline.joints).collect();
        assert_eq!(joints, [&[0, 1, 2][..], &[0, 2]]);
        let segments: Vec<_> = skeleton.polylines().flat_map(|polyline| polyline.segments()).collect();
        assert_eq!(segments, [("a", [0, 1]), ("b", [1, 2]), ("c", [0, 2])]);
        assert_eq!(skeleton.points().collect::<Vec<_>>(), [("p", 7)]);
        assert_eq!(skeleton.joints().len(), 5);
    }
}
