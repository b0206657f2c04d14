//! Vectors of series, for the closures that are written by hand.

use super::taylor::Taylor;

/// A vector of the plane.
#[derive(Clone, Copy)]
pub(super) struct Flat(pub(super) [Taylor; 2]);

/// A vector of space.
#[derive(Clone, Copy)]
pub(super) struct Spatial(pub(super) [Taylor; 3]);

/// The vector of a length in a direction.
pub(super) fn polar(length: Taylor, angle: Taylor) -> Flat {
    let (sine, cosine) = angle.sin_cos();
    Flat([length * cosine, length * sine])
}

impl Flat {
    pub(super) fn new(parts: &[Taylor]) -> Self {
        Self([parts[0], parts[1]])
    }

    /// A vector along the x axis.
    pub(super) fn along(x: Taylor) -> Self {
        Self([x, Taylor::constant(0.0)])
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self([self.0[0] + other.0[0], self.0[1] + other.0[1]])
    }

    pub(super) fn minus(self, other: Self) -> Self {
        Self([self.0[0] - other.0[0], self.0[1] - other.0[1]])
    }

    /// The vector turned by an angle.
    pub(super) fn turned(self, angle: Taylor) -> Self {
        let ([x, y], (sine, cosine)) = (self.0, angle.sin_cos());
        Self([x * cosine - y * sine, x * sine + y * cosine])
    }
}

impl Spatial {
    /// A vector of the plane z = 0.
    pub(super) fn flat(vector: Flat) -> Self {
        Self([vector.0[0], vector.0[1], Taylor::constant(0.0)])
    }

    pub(super) fn new(parts: &[Taylor]) -> Self {
        Self([parts[0], parts[1], parts[2]])
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self([0, 1, 2].map(|axis| self.0[axis] + other.0[axis]))
    }

    pub(super) fn minus(self, other: Self) -> Self {
        Self([0, 1, 2].map(|axis| self.0[axis] - other.0[axis]))
    }

    pub(super) fn scaled(self, factor: Taylor) -> Self {
        Self(self.0.map(|part| part * factor))
    }

    pub(super) fn dot(self, other: Self) -> Taylor {
        self.0[0] * other.0[0] + self.0[1] * other.0[1] + self.0[2] * other.0[2]
    }

    pub(super) fn cross(self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self([
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ])
    }

    /// The vector turned about an axis of any length, by Rodrigues' formula.
    pub(super) fn turned(self, axis: Self, angle: Taylor) -> Self {
        let unit = axis.scaled(Taylor::constant(1.0) / axis.dot(axis).sqrt());
        let (sine, cosine) = angle.sin_cos();
        let along = unit.dot(self) * (Taylor::constant(1.0) - cosine);
        self.scaled(cosine)
            .plus(unit.cross(self).scaled(sine))
            .plus(unit.scaled(along))
    }
}
