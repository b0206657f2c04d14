//! The kinds of loads, and their list.

use crate::geometry::Space;
use crate::load::coordinate::{Coordinate, cross, difference, dot};
use crate::load::totals::Totals;
use crate::load::{Change, LoadError, LoadedSystem, VaryingNumber, VaryingVector};
use crate::number::Number;

/// A load of the mechanism `M`, or a list of loads.
///
/// Functions that take any loads name it: `fn peak(loads: &Loads<FourBar, impl Load<FourBar>>)`. Do not implement it: a
/// new version may add items.
pub trait Load<M: LoadedSystem>: Copy {
    /// The number of loads.
    #[doc(hidden)]
    const COUNT: usize;

    /// Adds its part to the sums.
    #[doc(hidden)]
    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError>;
}

/// No load.
impl<M: LoadedSystem> Load<M> for () {
    const COUNT: usize = 0;

    fn add(&self, _: &mut Totals<M>) -> Result<(), LoadError> {
        Ok(())
    }
}

/// A list of loads, and one more.
impl<M: LoadedSystem, L: Load<M>, H: Load<M>> Load<M> for (L, H) {
    const COUNT: usize = L::COUNT + H::COUNT;

    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        self.0.add(totals)?;
        totals.load = Self::COUNT;
        self.1.add(totals)
    }
}

/// A mass at a point.
#[derive(Clone, Copy)]
pub struct Mass<F> {
    pub(super) mass: f64,
    pub(super) point: F,
}

impl<M: LoadedSystem, P: VaryingVector<Change<M::Scalar>>, F: Fn(M::Moving) -> P + Copy> Load<M> for Mass<F> {
    const COUNT: usize = 1;

    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        let point = Coordinate::of_point(&totals.poses, self.point);
        add_mass(totals, self.mass, &point)
    }
}

/// Refuses what no body has.
pub(crate) fn not_negative(load: usize, quantity: &'static str, value: f64) -> Result<(), LoadError> {
    if value < 0.0 {
        return Err(LoadError::Negative { load, quantity, value });
    }
    Ok(())
}

pub(super) fn add_mass<M: LoadedSystem>(
    totals: &mut Totals<M>,
    mass: f64,
    point: &[Coordinate<M>; 3],
) -> Result<(), LoadError> {
    not_negative(totals.load, "mass", mass)?;
    for coordinate in point {
        totals.inertia(mass, coordinate, coordinate);
    }
    totals.shaking(mass, point);
    let Space { x, y, z } = totals.gravity;
    let along = [x, y, z].map(|part| M::Scalar::constant(-mass * part));
    totals.potential(&(point[0].scale(along[0]) + point[1].scale(along[1]) + point[2].scale(along[2])));
    Ok(())
}

/// A moment of inertia about an axis of fixed direction.
#[derive(Clone, Copy)]
pub struct Inertia<F> {
    pub(super) moment: f64,
    pub(super) axis: Space<f64>,
    pub(super) angle: F,
}

impl<M: LoadedSystem, P: VaryingNumber<Change<M::Scalar>>, F: Fn(M::Moving) -> P + Copy> Load<M> for Inertia<F> {
    const COUNT: usize = 1;

    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        not_negative(totals.load, "moment of inertia", self.moment)?;
        let angle = Coordinate::of_number(&totals.poses, self.angle);
        totals.inertia(self.moment, &angle, &angle);
        let Space { x, y, z } = self.axis;
        for (sum, direction) in totals.shaking_moment.iter_mut().zip([x, y, z]) {
            for order in 0..Totals::<M>::effort_entries() {
                sum[order] = sum[order] - M::Scalar::constant(self.moment * direction) * angle.motion[order + 2];
            }
        }
        Ok(())
    }
}

/// The mass properties of a rigid body in space.
///
/// They are given in a frame that is fixed to the body by three of its points a, b and c: the origin is a, the first
/// axis points to b, the second lies in the plane of the points, on the side of c, and the third is at right angles to
/// both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid {
    /// The mass.
    pub mass: f64,
    /// The centre of mass, in the frame of the three points.
    pub centre: Space<f64>,
    /// The tensor of inertia about the centre of mass, along the axes of that frame: moments of inertia on the
    /// diagonal, negative products of inertia beside it. It is symmetric; the mean of both sides of the diagonal
    /// counts.
    pub inertia: [[f64; 3]; 3],
}

impl Solid {
    /// Refuses what no body has.
    pub(crate) fn check(&self, load: usize) -> Result<(), LoadError> {
        for (axis, row) in self.inertia.iter().enumerate() {
            not_negative(load, "moment of inertia about an axis of the body", row[axis])?;
        }
        Ok(())
    }
}

/// A rigid body in space.
#[derive(Clone, Copy)]
pub struct SpaceBody<F> {
    pub(super) solid: Solid,
    pub(super) points: F,
}

impl<M: LoadedSystem, P: VaryingVector<Change<M::Scalar>>, F: Fn(M::Moving) -> [P; 3] + Copy> Load<M> for SpaceBody<F> {
    const COUNT: usize = 1;

    // With the arms ξ from the centre of mass along unit vectors e fixed to the body, the velocity of a mass element is
    // that of the centre plus the sum of ξ e'. So the kinetic energy is that of the centre plus half the sum of P e' ·
    // e', with the second moments P = ∫ ξ ξ dm. They follow from the moments of inertia: P = tr(I) / 2 - I.
    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        let load = totals.load;
        let [a, b, c] = [0, 1, 2].map(|corner| Coordinate::of_point(&totals.poses, |pose| (self.points)(pose)[corner]));
        let (along, across) = (difference(&b, &a), difference(&c, &a));
        for (one, two) in [(&along, &along), (&along, &across), (&across, &across)] {
            rigid(one, two).map_err(|rate| LoadError::NotRigid { load, rate })?;
        }
        let normal = cross(&along, &across);
        // The lengths are constant, because the body is rigid.
        let length = |vector: &[Coordinate<M>; 3]| dot(vector, vector).motion[0].sqrt();
        let (base, area) = (length(&along), length(&normal));
        // Below this ratio the orientation has fewer than half of the digits.
        if area.real() <= Number::sqrt(f64::EPSILON) * (base * length(&across)).real() {
            return Err(LoadError::Collinear { load });
        }
        let one = M::Scalar::constant(1.0);
        let first = along.map(|coordinate| coordinate.scale(one / base));
        let third = normal.map(|coordinate| coordinate.scale(one / area));
        let axes = [first, cross(&third, &first), third];

        let Solid { mass, centre, inertia } = self.solid;
        let arms = [centre.x, centre.y, centre.z];
        let point = [0, 1, 2].map(|coordinate| {
            let steps = axes
                .iter()
                .zip(arms)
                .map(|(axis, arm)| axis[coordinate].scale(M::Scalar::constant(arm)));
            steps.fold(a[coordinate], |sum, step| sum + step)
        });
        add_mass(totals, mass, &point)?;
        self.solid.check(load)?;
        let half_trace = 0.5 * (inertia[0][0] + inertia[1][1] + inertia[2][2]);
        for row in 0..3 {
            for column in 0..3 {
                let mean = 0.5 * (inertia[row][column] + inertia[column][row]);
                let second_moment = if row == column { half_trace - mean } else { -mean };
                for (one, two) in axes[row].iter().zip(&axes[column]) {
                    totals.inertia(second_moment, one, two);
                }
                totals.spin(second_moment, &axes[row], &axes[column]);
            }
        }
        Ok(())
    }
}

/// By so many roundings of its size the scalar product of two vectors may change: its factors come from places that are
/// rounded.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;

/// Whether the scalar product of two vectors is constant up to half of the digits, otherwise its rate.
pub(super) fn rigid<M: LoadedSystem>(one: &[Coordinate<M>; 3], two: &[Coordinate<M>; 3]) -> Result<(), f64> {
    let product = dot(one, two);
    let size = |vector: &[Coordinate<M>; 3]| {
        let square = |coordinate: &Coordinate<M>| coordinate.motion[0].real() * coordinate.motion[0].real();
        Number::sqrt(vector.iter().map(square).sum::<f64>())
    };
    // where the vectors stand for a moment, their rates are rounding alone
    let size = size(one) * size(two);
    let rounding = ROUNDINGS * (size + Number::sqrt(size));
    for (input, influence) in product.influence.as_ref().iter().enumerate() {
        let part = |a: &Coordinate<M>, b: &Coordinate<M>| (a.motion[0] * b.influence[input][0]).real().abs();
        let terms = one.iter().zip(two).map(|(a, b)| part(a, b) + part(b, a));
        let rate = influence[0].real();
        if rate.abs() > Number::sqrt(f64::EPSILON) * terms.sum::<f64>() + rounding {
            return Err(rate);
        }
    }
    Ok(())
}

/// A force at a point.
#[derive(Clone, Copy)]
pub struct Force<V, F> {
    pub(super) force: V,
    pub(super) point: F,
}

impl<M, V, P, F> Load<M> for Force<V, F>
where
    M: LoadedSystem,
    V: VaryingVector<M::Scalar>,
    P: VaryingVector<Change<M::Scalar>>,
    F: Fn(M::Moving) -> P + Copy,
{
    const COUNT: usize = 1;

    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        let [x, y, z] = Coordinate::of_point(&totals.poses, self.point);
        totals.force(|order| self.force.entry(order).x, &x);
        totals.force(|order| self.force.entry(order).y, &y);
        totals.force(|order| self.force.entry(order).z, &z);
        Ok(())
    }
}

/// A torque on an angle, or a force along a distance.
#[derive(Clone, Copy)]
pub struct Torque<V, F> {
    pub(super) torque: V,
    pub(super) angle: F,
}

impl<M, V, P, F> Load<M> for Torque<V, F>
where
    M: LoadedSystem,
    V: VaryingNumber<M::Scalar>,
    P: VaryingNumber<Change<M::Scalar>>,
    F: Fn(M::Moving) -> P + Copy,
{
    const COUNT: usize = 1;

    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        let angle = Coordinate::of_number(&totals.poses, self.angle);
        totals.force(|order| self.torque.entry(order), &angle);
        Ok(())
    }
}

/// A spring or a damper between two points.
#[derive(Clone, Copy)]
pub struct BetweenPoints<K, F, G> {
    pub(super) kind: K,
    pub(super) from: F,
    pub(super) to: G,
}

/// A spring or a damper on an angle.
#[derive(Clone, Copy)]
pub struct OnAngle<K, F> {
    pub(super) kind: K,
    pub(super) angle: F,
}

/// The stiffness of a spring and its length at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    pub(crate) stiffness: f64,
    pub(crate) rest: f64,
}

/// The constant of a damper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damper {
    pub(crate) damping: f64,
}

/// The square of the distance of two points.
fn square<M, P, Q>(totals: &Totals<M>, from: impl Fn(M::Moving) -> P, to: impl Fn(M::Moving) -> Q) -> Coordinate<M>
where
    M: LoadedSystem,
    P: VaryingVector<Change<M::Scalar>>,
    Q: VaryingVector<Change<M::Scalar>>,
{
    let (from, to) = (
        Coordinate::of_point(&totals.poses, from),
        Coordinate::of_point(&totals.poses, to),
    );
    let between = difference(&to, &from);
    dot(&between, &between)
}

/// The distance, from its square.
fn distance<M: LoadedSystem>(square: Coordinate<M>, load: usize) -> Result<Coordinate<M>, LoadError> {
    if square.motion[0].real() > M::Scalar::SMALLEST_DIVISOR {
        Ok(square.sqrt())
    } else {
        Err(LoadError::NoDirection { load })
    }
}

impl<M, P, Q, F, G> Load<M> for BetweenPoints<Spring, F, G>
where
    M: LoadedSystem,
    P: VaryingVector<Change<M::Scalar>>,
    Q: VaryingVector<Change<M::Scalar>>,
    F: Fn(M::Moving) -> P + Copy,
    G: Fn(M::Moving) -> Q + Copy,
{
    const COUNT: usize = 1;

    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        let Spring { stiffness, rest } = self.kind;
        let square = square(totals, self.from, self.to);
        // Without a length at rest, the energy is regular where both ends meet.
        let squared_stretch = if rest == 0.0 {
            square
        } else {
            let stretch = distance(square, totals.load)? - Coordinate::constant(rest);
            stretch * stretch
        };
        totals.potential(&squared_stretch.scale(M::Scalar::constant(0.5 * stiffness)));
        Ok(())
    }
}

impl<M, P, Q, F, G> Load<M> for BetweenPoints<Damper, F, G>
where
    M: LoadedSystem,
    P: VaryingVector<Change<M::Scalar>>,
    Q: VaryingVector<Change<M::Scalar>>,
    F: Fn(M::Moving) -> P + Copy,
    G: Fn(M::Moving) -> Q + Copy,
{
    const COUNT: usize = 1;

    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        let distance = distance(square(totals, self.from, self.to), totals.load)?;
        totals.damper(self.kind.damping, &distance);
        Ok(())
    }
}

impl<M: LoadedSystem, P: VaryingNumber<Change<M::Scalar>>, F: Fn(M::Moving) -> P + Copy> Load<M>
    for OnAngle<Spring, F>
{
    const COUNT: usize = 1;

    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        let Spring { stiffness, rest } = self.kind;
        let twist = Coordinate::of_number(&totals.poses, self.angle) - Coordinate::constant(rest);
        totals.potential(&(twist * twist).scale(M::Scalar::constant(0.5 * stiffness)));
        Ok(())
    }
}

impl<M: LoadedSystem, P: VaryingNumber<Change<M::Scalar>>, F: Fn(M::Moving) -> P + Copy> Load<M>
    for OnAngle<Damper, F>
{
    const COUNT: usize = 1;

    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        let angle = Coordinate::of_number(&totals.poses, self.angle);
        totals.damper(self.kind.damping, &angle);
        Ok(())
    }
}
