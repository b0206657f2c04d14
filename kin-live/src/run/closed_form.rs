//! The closed forms.

use kin_compiler::lowered::Returns;
use kin_core::__private::solve::{self, Root};
use kin_core::{Assembly, Failure, Plane, Scalar};

use super::{Run, Way};
use crate::code::{Argument, ClosedForm, Register};

/// The results of a closed form.
enum Found<T> {
    Scalar(T),
    Pair(T, T),
    Plane(Plane<T>),
    Root(Root<T>),
    PlaneAndRoot(Plane<T>, Root<T>),
    RootAndScalar(Root<T>, T),
    PlaneAndScalar(Plane<T>, T),
    ScalarAndPlane(T, Plane<T>),
}

impl<T: Scalar, W: Way<T>, const C: usize> Run<'_, '_, T, W, C> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn scalar(&self, argument: &Argument) -> T {
        match argument {
            Argument::Scalar(register) => self.get(*register),
            Argument::Known(number) => T::constant(*number),
            _ => unreachable!("the argument is a number"),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plane(&self, argument: &Argument) -> Plane<T> {
        let Argument::Plane([x, y]) = argument else {
            unreachable!("the argument is a vector");
        };
        Plane::new(self.get(*x), self.get(*y))
    }

    /// Solves a closed form.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn solve(
        &mut self,
        form: ClosedForm,
        arguments: &[Argument],
        assembly: Assembly,
        returns: Returns,
        results: &[Register],
    ) -> Result<(), Failure> {
        let found = match (form, arguments) {
            (ClosedForm::CircleCircle, [a, b, c]) => {
                let (a, b, c) = (self.scalar(a), self.scalar(b), self.plane(c));
                let (plane, root) = solve::circle_circle(a, b, c, assembly)?;
                Found::PlaneAndRoot(plane, root)
            }
            (ClosedForm::CircleCircleSquared, [a2, b2, c]) => {
                let (a2, b2, c) = (self.scalar(a2), self.scalar(b2), self.plane(c));
                Found::Plane(solve::circle_circle_squared(a2, b2, c, assembly)?)
            }
            (ClosedForm::CircleLine, [a2, along, c]) => {
                let (a2, along, c) = (self.scalar(a2), self.plane(along), self.plane(c));
                let (plane, scalar) = solve::circle_line(a2, along, c, assembly)?;
                Found::PlaneAndScalar(plane, scalar)
            }
            (ClosedForm::CircleLineX, [a2, c]) => {
                let (a2, c) = (self.scalar(a2), self.plane(c));
                let (root, scalar) = solve::circle_line_x(a2, c, assembly)?;
                Found::RootAndScalar(root, scalar)
            }
            (ClosedForm::CircleLineY, [a2, c]) => {
                let (a2, c) = (self.scalar(a2), self.plane(c));
                let (root, scalar) = solve::circle_line_y(a2, c, assembly)?;
                Found::RootAndScalar(root, scalar)
            }
            (ClosedForm::Polar, [c]) => Found::Root(solve::polar(self.plane(c), assembly)?),
            (ClosedForm::PolarOffset, [offset, c]) => {
                let (offset, c) = (self.plane(offset), self.plane(c));
                let (scalar, plane) = solve::polar_offset(offset, c, assembly)?;
                Found::ScalarAndPlane(scalar, plane)
            }
            (ClosedForm::CosineSine, [a, b, c, Argument::Known(size)]) => {
                let (a, b, c) = (self.scalar(a), self.scalar(b), self.scalar(c));
                let (plane, root) = solve::cosine_sine(a, b, c, *size, assembly)?;
                Found::PlaneAndRoot(plane, root)
            }
            (ClosedForm::InverseCosine, [width, radius]) => {
                let (width, radius) = (self.scalar(width), self.scalar(radius));
                Found::Root(solve::inverse_cosine(width, radius, assembly)?)
            }
            (ClosedForm::InverseSine, [height, radius]) => {
                let (height, radius) = (self.scalar(height), self.scalar(radius));
                Found::Root(solve::inverse_sine(height, radius, assembly)?)
            }
            (ClosedForm::InverseHyperbolicCosine, [value, growth]) => {
                let (value, growth) = (self.scalar(value), self.scalar(growth));
                Found::Scalar(solve::inverse_hyperbolic_cosine(value, growth, assembly)?)
            }
            (ClosedForm::Linear, [a, b]) => {
                let (a, b) = (self.scalar(a), self.scalar(b));
                Found::Scalar(solve::linear(a, b)?)
            }
            (ClosedForm::LinearPair, [Argument::Matrix(rows), Argument::Pair(right)]) => {
                let rows = [self.pair(rows[0]), self.pair(rows[1])];
                let (x, y) = solve::linear_pair(rows, self.pair(*right))?;
                Found::Pair(x, y)
            }
            (ClosedForm::Quadratic, [a, b, c]) => {
                let (a, b, c) = (self.scalar(a), self.scalar(b), self.scalar(c));
                Found::Scalar(solve::quadratic(a, b, c, assembly)?)
            }
            (ClosedForm::SquareRoot, [w]) => Found::Scalar(solve::square_root(self.scalar(w), assembly)?),
            (ClosedForm::Guard(guard), [v]) => {
                let v = self.scalar(v);
                Found::Scalar(guard.check(v)?)
            }
            _ => unreachable!("a closed form has its arguments"),
        };
        debug_assert_eq!(returns, found.shape());
        match (found, results) {
            (Found::Scalar(scalar), [to]) => self.set(*to, scalar),
            (Found::Pair(first, second), [to, to_2]) => {
                self.set(*to, first);
                self.set(*to_2, second);
            }
            (Found::Plane(plane), [x, y]) => {
                self.set(*x, plane.x);
                self.set(*y, plane.y);
            }
            (Found::Root(root), [value, square]) => {
                self.set(*value, root.value);
                self.set(*square, root.square);
            }
            (Found::PlaneAndRoot(plane, root), [x, y, value, square]) => {
                self.set(*x, plane.x);
                self.set(*y, plane.y);
                self.set(*value, root.value);
                self.set(*square, root.square);
            }
            (Found::RootAndScalar(root, scalar), [value, square, to]) => {
                self.set(*value, root.value);
                self.set(*square, root.square);
                self.set(*to, scalar);
            }
            (Found::PlaneAndScalar(plane, scalar), [x, y, to]) => {
                self.set(*x, plane.x);
                self.set(*y, plane.y);
                self.set(*to, scalar);
            }
            (Found::ScalarAndPlane(scalar, plane), [to, x, y]) => {
                self.set(*to, scalar);
                self.set(*x, plane.x);
                self.set(*y, plane.y);
            }
            _ => unreachable!("a closed form has its results"),
        }
        Ok(())
    }
}

impl<T> Found<T> {
    fn shape(&self) -> Returns {
        match self {
            Self::Scalar(_) => Returns::Scalar,
            Self::Pair(..) => Returns::Pair,
            Self::Plane(_) => Returns::Plane,
            Self::Root(_) => Returns::Root,
            Self::PlaneAndRoot(..) => Returns::PlaneAndRoot,
            Self::RootAndScalar(..) => Returns::RootAndScalar,
            Self::PlaneAndScalar(..) => Returns::PlaneAndScalar,
            Self::ScalarAndPlane(..) => Returns::ScalarAndPlane,
        }
    }
}
