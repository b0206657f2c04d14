//! Instructions: each reads its operands, and then writes its value, as the expression of generated code would.

use kin_compiler::tree::Operation;
use kin_compiler::{Function, ValueShape};
use kin_core::{Number, Plane, Rotation, Space};

use super::registers::Held;
use crate::elementary::Elementary;

/// An instruction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Instruction {
    pub(super) code: Code,
    /// The first register of the value.
    pub(super) to: usize,
    /// The first registers of the operands.
    pub(super) from: [usize; 3],
}

/// The calculation of an instruction. A shape is that of the first operand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Code {
    Number(f64),
    Negative(ValueShape),
    Power(i32),
    Plus(ValueShape),
    Minus(ValueShape),
    Times,
    Over,
    Scale(ValueShape),
    ScaleByInverse(ValueShape),
    ComplexTimes,
    RotationTimes,
    Rotate,
    /// The shape of a vector that is made of scalars is that of the vector.
    Call(Operation, ValueShape),
}

impl Instruction {
    pub(super) fn run<T: Number>(&self, registers: &mut [T]) {
        let [a, b, c] = self.from;
        let to = self.to;
        let scalar = |register: usize| T::at(registers, register);
        let plane = |register: usize| Plane::at(registers, register);
        let space = |register: usize| Space::at(registers, register);
        let rotation = |register: usize| Rotation::at(registers, register);
        let one = || T::constant(1.0);
        match self.code {
            Code::Number(value) => T::constant(value).put(registers, to),
            Code::Negative(ValueShape::Plane) => (-plane(a)).put(registers, to),
            Code::Negative(ValueShape::Space) => (-space(a)).put(registers, to),
            Code::Negative(_) => (-scalar(a)).put(registers, to),
            Code::Power(exponent) => scalar(a).powi(exponent).put(registers, to),
            Code::Plus(ValueShape::Plane) => (plane(a) + plane(b)).put(registers, to),
            Code::Plus(ValueShape::Space) => (space(a) + space(b)).put(registers, to),
            Code::Plus(_) => (scalar(a) + scalar(b)).put(registers, to),
            Code::Minus(ValueShape::Plane) => (plane(a) - plane(b)).put(registers, to),
            Code::Minus(ValueShape::Space) => (space(a) - space(b)).put(registers, to),
            Code::Minus(_) => (scalar(a) - scalar(b)).put(registers, to),
            Code::Times => (scalar(a) * scalar(b)).put(registers, to),
            Code::Over => (scalar(a) / scalar(b)).put(registers, to),
            Code::Scale(ValueShape::Space) => space(a).scale(scalar(b)).put(registers, to),
            Code::Scale(_) => plane(a).scale(scalar(b)).put(registers, to),
            Code::ScaleByInverse(ValueShape::Space) => space(a).scale(one() / scalar(b)).put(registers, to),
            Code::ScaleByInverse(_) => plane(a).scale(one() / scalar(b)).put(registers, to),
            Code::ComplexTimes => plane(a).times(plane(b)).put(registers, to),
            Code::RotationTimes => rotation(a).times(rotation(b)).put(registers, to),
            Code::Rotate => rotation(a).rotate(space(b)).put(registers, to),
            Code::Call(operation, shape) => match (operation, shape) {
                (Operation::Sine, _) => scalar(a).sin_cos().0.put(registers, to),
                (Operation::Cosine, _) => scalar(a).sin_cos().1.put(registers, to),
                (Operation::Tangent, _) => {
                    let (sine, cosine) = scalar(a).sin_cos();
                    (sine / cosine).put(registers, to);
                }
                (Operation::Method(function), _) => method(function, scalar(a), scalar(b)).put(registers, to),
                (Operation::Zero, ValueShape::Space) => Space::<T>::zero().put(registers, to),
                (Operation::Zero, _) => Plane::<T>::zero().put(registers, to),
                (Operation::Vector, ValueShape::Space) => {
                    Space::new(scalar(a), scalar(b), scalar(c)).put(registers, to);
                }
                (Operation::Vector, _) => Plane::new(scalar(a), scalar(b)).put(registers, to),
                (Operation::Lifted, ValueShape::Space) => {
                    Space::new(scalar(a), T::constant(0.0), T::constant(0.0)).put(registers, to);
                }
                (Operation::Lifted, _) => Plane::new(scalar(a), T::constant(0.0)).put(registers, to),
                (Operation::InSpace, _) => {
                    let plane = plane(a);
                    Space::new(plane.x, plane.y, T::constant(0.0)).put(registers, to);
                }
                (Operation::Cis, _) => Plane::cis(scalar(a)).put(registers, to),
                (Operation::Polar, _) => Plane::polar(scalar(a), scalar(b)).put(registers, to),
                (Operation::AboutX, _) => Rotation::about_x(scalar(a)).put(registers, to),
                (Operation::AboutY, _) => Rotation::about_y(scalar(a)).put(registers, to),
                (Operation::AboutZ, _) => Rotation::about_z(scalar(a)).put(registers, to),
                (Operation::About, _) => Rotation::about(space(a), scalar(b)).put(registers, to),
                (Operation::Dot, ValueShape::Space) => space(a).dot(space(b)).put(registers, to),
                (Operation::Dot, _) => plane(a).dot(plane(b)).put(registers, to),
                (Operation::Cross, ValueShape::Space) => space(a).cross(space(b)).put(registers, to),
                (Operation::Cross, _) => plane(a).cross(plane(b)).put(registers, to),
                (Operation::Norm, ValueShape::Space) => space(a).norm().put(registers, to),
                (Operation::Norm, _) => plane(a).norm().put(registers, to),
            },
        }
    }
}

fn method<T: Number>(function: Function, a: T, b: T) -> T {
    Elementary::declared(function).map_or_else(|| a.atan2(b), |own| own.of(a))
}
