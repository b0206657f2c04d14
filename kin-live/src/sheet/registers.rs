//! Values that stand in registers.

use kin_compiler::ValueShape;
use kin_core::{Number, Plane, Rotation, Space};

/// The number of registers that a value takes.
pub(super) fn length(shape: ValueShape) -> usize {
    match shape {
        ValueShape::Scalar => 1,
        ValueShape::Plane => 2,
        ValueShape::Space => 3,
        ValueShape::Rotation => 9,
    }
}

/// A value that stands in a row of registers, of which an index names the first.
pub(super) trait Held<T>: Copy {
    fn at(registers: &[T], first: usize) -> Self;

    fn put(self, registers: &mut [T], first: usize);
}

impl<T: Number> Held<T> for T {
    fn at(registers: &[T], first: usize) -> Self {
        registers[first]
    }

    fn put(self, registers: &mut [T], first: usize) {
        registers[first] = self;
    }
}

impl<T: Number> Held<T> for Plane<T> {
    fn at(registers: &[T], first: usize) -> Self {
        Self::new(registers[first], registers[first + 1])
    }

    fn put(self, registers: &mut [T], first: usize) {
        [registers[first], registers[first + 1]] = [self.x, self.y];
    }
}

impl<T: Number> Held<T> for Space<T> {
    fn at(registers: &[T], first: usize) -> Self {
        Self::new(registers[first], registers[first + 1], registers[first + 2])
    }

    fn put(self, registers: &mut [T], first: usize) {
        [registers[first], registers[first + 1], registers[first + 2]] = [self.x, self.y, self.z];
    }
}

impl<T: Number> Held<T> for Rotation<T> {
    fn at(registers: &[T], first: usize) -> Self {
        Self::from_rows([0, 3, 6].map(|row| Space::at(registers, first + row)))
    }

    fn put(self, registers: &mut [T], first: usize) {
        for (row, offset) in self.rows().into_iter().zip([0, 3, 6]) {
            row.put(registers, first + offset);
        }
    }
}
