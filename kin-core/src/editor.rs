//! The words of a declaration, as editors complete and explain them. No build sees this module or the code that names it.
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
    /// A rotation of space, which turns the vector behind it: `rotation * vector`.
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
    ($($(#[$attributes:meta])* $name:ident($first:ident $(, $argument:ident: $kind:ident)*) -> $value:ty;)*) => {
        $(
            $(#[$attributes])*
            pub fn $name<$first, $($kind),*>(_: $first $(, $argument: $kind)*) -> $value {
                $(let _ = $argument;)*
                unreachable!()
            }
        )*

        /// The functions as methods of their first argument.
        pub trait Methods: Sized {
            $(
                $(#[$attributes])*
                fn $name<$($kind),*>(self $(, $argument: $kind)*) -> $value {
                    $(let _ = $argument;)*
                    unreachable!()
                }
            )*
        }
    };
}

functions! {
    /// The sine of an angle.
    sin(Of) -> Scalar;
    /// The cosine of an angle.
    cos(Of) -> Scalar;
    /// The tangent of an angle.
    tan(Of) -> Scalar;
    /// The angle with this sine.
    asin(Of) -> Angle;
    /// The angle with this cosine.
    acos(Of) -> Angle;
    /// The angle with this tangent.
    atan(Of) -> Angle;
    /// `atan2(y, x)`: the angle of the vector (x, y).
    atan2(Of, x: X) -> Angle;
    /// The hyperbolic sine of a number.
    sinh(Of) -> Scalar;
    /// The hyperbolic cosine of a number.
    cosh(Of) -> Scalar;
    /// The hyperbolic tangent of a number.
    tanh(Of) -> Scalar;
    /// The number with this hyperbolic sine.
    asinh(Of) -> Scalar;
    /// The number with this hyperbolic cosine.
    acosh(Of) -> Scalar;
    /// The number with this hyperbolic tangent.
    atanh(Of) -> Scalar;
    /// The square root of a scalar, with half the power of length.
    sqrt(Of) -> Scalar;
    /// The exponential of a number.
    exp(Of) -> Scalar;
    /// The natural logarithm of a number.
    ln(Of) -> Scalar;
    /// `powi(x, 2)`: the power of a scalar with a whole exponent, written out.
    powi(Of, exponent: Exponent) -> Scalar;
    /// The unit vector of the plane at an angle.
    cis(Of) -> Vector;
    /// `polar(length, angle)`: the plane vector of a length at an angle.
    polar(Of, angle: Angle) -> Vector;
    /// `vec2(x, y)`: a plane vector.
    vec2(Of, y: Y) -> Vector;
    /// `vec3(x, y, z)`: a space vector.
    vec3(Of, y: Y, z: Z) -> Vector3;
    /// The rotation by an angle about the x axis.
    rot_x(Of) -> Rotation;
    /// The rotation by an angle about the y axis.
    rot_y(Of) -> Rotation;
    /// The rotation by an angle about the z axis.
    rot_z(Of) -> Rotation;
    /// `rot(axis, angle)`: the rotation by an angle about a space vector.
    rot(Of, angle: Angle) -> Rotation;
    /// The inner product of two vectors of one kind.
    dot(Of, other: Other) -> Scalar;
    /// The cross product of two vectors: a scalar in the plane, a vector in space.
    cross(Of, other: Other) -> Quantity;
    /// The length of a vector.
    norm(Of) -> Scalar;
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
