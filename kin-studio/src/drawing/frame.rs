//! From the coordinates of the mechanism to those of the picture.

use kin_core::{Plane, Space};

/// cos 30°, by which the axes x and y of an isometric picture lean.
const LEAN: f64 = 0.866_025_403_784_438_6;

/// A scale and an offset; mechanisms of space are seen isometrically.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    is_plane: bool,
    scale: f64,
    offset: Plane,
}

impl Frame {
    /// The frame in which some points fill a rectangle as far as its proportions allow.
    pub(super) fn around(points: &[Space], is_plane: bool, low: Plane, high: Plane) -> Self {
        let flat: Vec<Plane> = points.iter().map(|&point| flat(point, is_plane)).collect();
        let bound = |of: fn(&Plane) -> f64| {
            let values = flat.iter().map(of);
            (
                values.clone().fold(f64::INFINITY, f64::min),
                values.fold(f64::NEG_INFINITY, f64::max),
            )
        };
        let ((left, right), (top, bottom)) = (bound(|point| point.x), bound(|point| point.y));
        let room = high - low;
        let scale = (room.x / (right - left).max(1e-12)).min(room.y / (bottom - top).max(1e-12));
        let middle = Plane::new(0.5 * (left + right), 0.5 * (top + bottom));
        let offset = (low + high).scale(0.5) - middle.scale(scale);
        Self {
            is_plane,
            scale,
            offset,
        }
    }

    pub(super) fn point(&self, point: Space) -> Plane {
        flat(point, self.is_plane).scale(self.scale) + self.offset
    }

    pub(super) fn direction(&self, direction: Space) -> Plane {
        flat(direction, self.is_plane)
    }

    pub(super) fn is_plane(&self) -> bool {
        self.is_plane
    }
}

/// Without a scale; y of the picture points down.
fn flat(point: Space, is_plane: bool) -> Plane {
    if is_plane {
        Plane::new(point.x, -point.y)
    } else {
        Plane::new((point.y - point.x) * LEAN, 0.5 * (point.x + point.y) - point.z)
    }
}
