//! A coordinate with its motion and its influence coefficients.

use core::ops::{Add, Mul, Sub};

use crate::load::{Change, LoadedSystem, VaryingNumber, VaryingVector};
use crate::motion::leibniz;
use crate::number::{Number, Row};

/// The number of entries of a motion of the mechanism: the value, and a derivative for each order.
pub(super) const fn entries<M: LoadedSystem>() -> usize {
    <M::Motion<M::Scalar> as Row<M::Scalar>>::LENGTH
}

/// A coordinate of a point, an angle or a distance: its motion, and its influence coefficients as motions.
///
/// The influence coefficient of an input is the partial derivative of the coordinate with respect to that input. Entry
/// n of its motion is its n-th derivative by time. Sums and products follow the product rule.
#[derive(Clone, Copy)]
pub(super) struct Coordinate<M: LoadedSystem> {
    pub(super) motion: M::Motion<M::Scalar>,
    pub(super) influence: M::Inputs<M::Motion<M::Scalar>>,
}

impl<M: LoadedSystem> Coordinate<M> {
    /// The coordinates of a selected point, x, y and z.
    pub(super) fn of_point<P: VaryingVector<Change<M::Scalar>>>(
        poses: &M::Inputs<M::Moving>,
        point: impl Fn(M::Moving) -> P,
    ) -> [Self; 3] {
        const {
            assert!(
                P::ENTRIES >= entries::<M>(),
                "a load needs all derivatives of its point"
            );
        };
        let points = poses.as_ref().iter().map(|pose| point(*pose));
        [
            Self::gathered(points.clone().map(|point| move |order| point.entry(order).x)),
            Self::gathered(points.clone().map(|point| move |order| point.entry(order).y)),
            Self::gathered(points.map(|point| move |order| point.entry(order).z)),
        ]
    }

    /// A selected angle, or another coordinate that is a number.
    pub(super) fn of_number<P: VaryingNumber<Change<M::Scalar>>>(
        poses: &M::Inputs<M::Moving>,
        number: impl Fn(M::Moving) -> P,
    ) -> Self {
        const {
            assert!(
                P::ENTRIES >= entries::<M>(),
                "a load needs all derivatives of its coordinate"
            );
        };
        let numbers = poses.as_ref().iter().map(|pose| number(*pose));
        Self::gathered(numbers.map(|number| move |order| number.entry(order)))
    }

    /// Each item holds the same motion, with its change along one input.
    fn gathered<E: Fn(usize) -> Change<M::Scalar>>(items: impl Iterator<Item = E>) -> Self {
        let mut gathered = Self::constant(0.0);
        for (input, entry) in items.enumerate() {
            for order in 0..entries::<M>() {
                let Change { value, change } = entry(order);
                gathered.motion[order] = value;
                gathered.influence[input][order] = change;
            }
        }
        gathered
    }

    pub(super) fn constant(value: f64) -> Self {
        let number = M::Scalar::constant;
        let zero = M::Motion::splat(number(0.0));
        Self {
            motion: M::Motion::from_fn(|order| number(if order == 0 { value } else { 0.0 })),
            influence: M::Inputs::splat(zero),
        }
    }

    pub(super) fn scale(self, factor: M::Scalar) -> Self {
        self.map(|entry| factor * entry)
    }

    /// The square root. The value must be positive.
    pub(super) fn sqrt(self) -> Self {
        let number = M::Scalar::constant;
        let mut root = M::Motion::splat(number(0.0));
        root[0] = self.motion[0].sqrt();
        for order in 1..entries::<M>() {
            // the entry of this order is still zero
            let known = leibniz(&root.as_ref()[..=order], &root.as_ref()[..=order]);
            root[order] = (self.motion[order] - known) / (number(2.0) * root[0]);
        }
        let influence = |input| {
            let change: &M::Motion<M::Scalar> = &self.influence[input];
            let mut quotient = M::Motion::splat(number(0.0));
            for order in 0..entries::<M>() {
                let known = leibniz(&quotient.as_ref()[..=order], &root.as_ref()[..=order]);
                quotient[order] = (number(0.5) * change[order] - known) / root[0];
            }
            quotient
        };
        Self {
            motion: root,
            influence: M::Inputs::from_fn(influence),
        }
    }

    fn map(self, function: impl Fn(M::Scalar) -> M::Scalar) -> Self {
        Self {
            motion: M::Motion::from_fn(|order| function(self.motion[order])),
            influence: M::Inputs::from_fn(|input| {
                let own: M::Motion<M::Scalar> = self.influence[input];
                M::Motion::from_fn(|order| function(own[order]))
            }),
        }
    }

    fn with(self, other: Self, function: impl Fn(M::Scalar, M::Scalar) -> M::Scalar) -> Self {
        Self {
            motion: M::Motion::from_fn(|order| function(self.motion[order], other.motion[order])),
            influence: M::Inputs::from_fn(|input| {
                let (one, two): (M::Motion<M::Scalar>, M::Motion<M::Scalar>) =
                    (self.influence[input], other.influence[input]);
                M::Motion::from_fn(|order| function(one[order], two[order]))
            }),
        }
    }
}

impl<M: LoadedSystem> Add for Coordinate<M> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.with(other, |one, two| one + two)
    }
}

impl<M: LoadedSystem> Sub for Coordinate<M> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.with(other, |one, two| one - two)
    }
}

impl<M: LoadedSystem> Mul for Coordinate<M> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = |one: &M::Motion<M::Scalar>, two: &M::Motion<M::Scalar>, order: usize| {
            leibniz(&one.as_ref()[..=order], &two.as_ref()[..=order])
        };
        Self {
            motion: M::Motion::from_fn(|order| product(&self.motion, &other.motion, order)),
            influence: M::Inputs::from_fn(|input| {
                M::Motion::from_fn(|order| {
                    product(&self.influence[input], &other.motion, order)
                        + product(&self.motion, &other.influence[input], order)
                })
            }),
        }
    }
}

/// The scalar product.
pub(super) fn dot<M: LoadedSystem>(a: &[Coordinate<M>; 3], b: &[Coordinate<M>; 3]) -> Coordinate<M> {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product.
pub(super) fn cross<M: LoadedSystem>(a: &[Coordinate<M>; 3], b: &[Coordinate<M>; 3]) -> [Coordinate<M>; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(super) fn difference<M: LoadedSystem>(a: &[Coordinate<M>; 3], b: &[Coordinate<M>; 3]) -> [Coordinate<M>; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
