//! The words of a declaration, as editors complete and explain them. No build sees this module or the code that names
//! it.
//!
//! An editor reads a declaration as the arguments and the operands of a dead function. So the types here have no
//! operators, and a function takes anything.

#![allow(missing_docs, non_upper_case_globals, clippy::missing_docs_in_private_items)]

/// A scalar of a `let` or of an expression in parentheses, or a vector with its parts.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    pub x: Scalar,
    pub y: Scalar,
    pub z: Scalar,
}

macro_rules! scalars {
    ($($(#[$attributes:meta])* $name:ident),* $(,)?) => {
        $($(#[$attributes])* #[derive(Clone, Copy, Debug)] pub struct $name;)*
    };
}

scalars! {
    /// A length, in any unit, the same for all lengths.
    Length,
    /// An angle in radians, counter-clockwise. `30deg` is one in degrees.
    Angle,
    /// An unknown angle that is returned as a unit vector.
    Direction,
    /// A plain number.
    Scalar,
    /// A rotation of space, which rotates the vector behind it: `rotation * vector`.
    Rotation,
}

macro_rules! vectors {
    ($($(#[$attributes:meta])* $name:ident { $($part:ident),* })*) => {
        $(
            $(#[$attributes])*
            #[derive(Clone, Copy, Debug)]
            pub struct $name {
                $(pub $part: Length,)*
            }
        )*
    };
}

vectors! {
    /// A point of the plane.
    Point { x, y }
    /// A vector of the plane.
    Vector { x, y }
    /// A point in space.
    Point3 { x, y, z }
    /// A vector in space.
    Vector3 { x, y, z }
}

/// The number π.
pub const PI: Scalar = Scalar;

/// `input theta: Angle;` declares what is given.
pub const input: () = ();
/// `unknown phi: Angle;` declares what is to be found.
pub const unknown: () = ();
/// `output tip: Point = …;` declares a result with derivatives.
pub const output: () = ();

/// A name that the declaration does not declare.
#[doc(hidden)]
pub const UNDECLARED: Quantity = Quantity {
    x: Scalar,
    y: Scalar,
    z: Scalar,
};

/// The value of an expression, made of its operands.
#[doc(hidden)]
pub fn formula<Operands, Value>(_: Operands) -> Value {
    unreachable!()
}

/// `frame(origin, rotation)` in space, `frame(origin, angle)` in the plane: where a rigid body is. `frame * point` is
/// the position of a point of the body.
pub fn frame<Arguments>(_: Arguments) -> Quantity {
    unreachable!()
}

/// The items that `with` asks for.
pub mod requests {
    /// The partial derivatives of unknowns and outputs by every parameter.
    pub mod sensitivities {}
    /// The transmission angle of every dyad.
    pub mod transmission_angles {}
    /// A test that verifies the mechanism.
    pub mod test {}
}

macro_rules! functions {
    ($($(#[$attributes:meta])* $name:ident -> $value:ty;)*) => {
        $(
            $(#[$attributes])*
            pub fn $name<Arguments>(_: Arguments) -> $value {
                unreachable!()
            }
        )*

        /// The functions as methods of their first argument.
        pub trait Methods: Sized {
            $(
                $(#[$attributes])*
                fn $name<Arguments>(self, _: Arguments) -> $value {
                    unreachable!()
                }
            )*
        }
    };
}

// the arguments are one tuple, so that their number, which the macro checks, is no error here
functions! {
    /// `sin(angle)`: the sine.
    sin -> Scalar;
    /// `cos(angle)`: the cosine.
    cos -> Scalar;
    /// `tan(angle)`: the tangent.
    tan -> Scalar;
    /// `asin(x)`: the angle with the sine x.
    asin -> Angle;
    /// `acos(x)`: the angle with the cosine x.
    acos -> Angle;
    /// `atan(x)`: the angle with the tangent x.
    atan -> Angle;
    /// `atan2(y, x)`: the angle of the vector (x, y).
    atan2 -> Angle;
    /// `sinh(x)`: the hyperbolic sine.
    sinh -> Scalar;
    /// `cosh(x)`: the hyperbolic cosine.
    cosh -> Scalar;
    /// `tanh(x)`: the hyperbolic tangent.
    tanh -> Scalar;
    /// `asinh(x)`: the number with the hyperbolic sine x.
    asinh -> Scalar;
    /// `acosh(x)`: the number with the hyperbolic cosine x.
    acosh -> Scalar;
    /// `atanh(x)`: the number with the hyperbolic tangent x.
    atanh -> Scalar;
    /// `sqrt(x)`: the square root, with half the power of length.
    sqrt -> Scalar;
    /// `exp(x)`: the exponential.
    exp -> Scalar;
    /// `ln(x)`: the natural logarithm.
    ln -> Scalar;
    /// `powi(x, 2)`: the power with a whole exponent, which is written out.
    powi -> Scalar;
    /// `cis(angle)`: the unit vector of the plane at an angle.
    cis -> Vector;
    /// `polar(length, angle)`: the plane vector of a length at an angle.
    polar -> Vector;
    /// `vec2(x, y)`: a plane vector.
    vec2 -> Vector;
    /// `vec3(x, y, z)`: a space vector.
    vec3 -> Vector3;
    /// `rot_x(angle)`: the rotation about the x axis.
    rot_x -> Rotation;
    /// `rot_y(angle)`: the rotation about the y axis.
    rot_y -> Rotation;
    /// `rot_z(angle)`: the rotation about the z axis.
    rot_z -> Rotation;
    /// `rot(axis, angle)`: the rotation about a space vector.
    rot -> Rotation;
    /// `dot(a, b)`: the inner product of two vectors of one kind.
    dot -> Scalar;
    /// `cross(a, b)`: the cross product of two vectors, a scalar in the plane and a vector in space.
    cross -> Quantity;
    /// `norm(v)`: the length of a vector.
    norm -> Scalar;
}

impl Methods for Length {}
impl Methods for Angle {}
impl Methods for Direction {}
impl Methods for Scalar {}
impl Methods for Rotation {}
impl Methods for Point {}
impl Methods for Vector {}
impl Methods for Point3 {}
impl Methods for Vector3 {}
impl Methods for Quantity {}
