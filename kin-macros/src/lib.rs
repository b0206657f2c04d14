//! The `mechanism!` macro of kin: loop closures in, motion out.
//!
//! This crate is the macro's machinery. Use it through `kin_core::mechanism!`, which is documented there with examples.
//!
//! # The grammar
//!
//! ```text
//! declaration = struct statement*
//! struct      = attribute* visibility "struct" NAME "{" field ("," field)* "}"
//! field       = attribute* visibility NAME ":" dimension
//! dimension   = "Length" | "Angle" | "Scalar" | "Point" | "Vector" | "Point3" | "Vector3"
//!
//! statement   = "input"   quantity ("," quantity)* ";"
//!             | "unknown" unknown  ("," unknown)* ";"
//!             | "let" NAME "=" expression ";"
//!             | "output" NAME ":" dimension "=" expression ";"
//!             | "order" "=" INTEGER ";"
//!             | expression "==" expression ";"
//!             | "with" request ("," request)* ";"
//! request     = "transmission_angles" | "sensitivities" | "test"
//! quantity    = NAME ":" ("Length" | "Angle" | "Scalar")
//! unknown     = NAME ":" ("Length" | "Angle" | "Scalar" | "Direction") range?
//! range       = "where" NAME ("<" | "<=" | ">" | ">=") constant
//!             | "in" constant (".." | "..=") constant
//!
//! expression  = product (("+" | "-") product)*
//! product     = unary (("*" | "/") unary)*
//! unary       = "-" unary | postfix
//! postfix     = operand ("." "x" | "." "y" | "." "z" | "." function "(" arguments ")")*
//! operand     = NUMBER | "PI" | NAME | function "(" arguments ")" | "(" expression ")"
//! function    = "sin" | "cos" | "tan" | "asin" | "acos" | "atan" | "atan2"
//!             | "sinh" | "cosh" | "tanh" | "asinh" | "acosh" | "atanh" | "sqrt" | "exp" | "ln"
//!             | "powi" | "cis" | "polar" | "vec2" | "vec3" | "rot_x" | "rot_y" | "rot_z" | "rot"
//!             | "dot" | "cross" | "norm"
//! ```
//!
//! A request asks for further generated items; `with` remains usable as a name. Statements come in any order, but a `let` before
//! its uses. Doc comments may stand before statements, and before each name of an
//! `input` or `unknown`. A constant is an expression without names.
//!
//! # Dimensions
//!
//! A formula is a scalar, a plane vector, a space vector or a rotation, and has a power of length. `+`, `-` and `==` join what
//! has the same power; a literal zero fits everywhere. `Angle`, `Direction` and `Scalar` are plain numbers, so the product of a radius and an angle is a length. A
//! `Direction`, which only an unknown can be, is an angle that is handed out as a unit vector. A scalar
//! added to a vector lies along x, as a real number does among complex ones; an equation of a vector and a scalar is a mistake.
//! The product of two plane vectors is that of complex numbers: `v * cis(a)` is v, turned by a.
//!
//! Plane and space do not mix, and no scalar is added to a space vector. A rotation is multiplied by the space vector that it turns, or
//! by another rotation, and by nothing else.
//!
//! | function | arguments | result |
//! |---|---|---|
//! | `sin`, `cos`, `tan` | angle | number |
//! | `asin`, `acos`, `atan`, `exp`, `ln` | number | angle or number |
//! | `sinh`, `cosh`, `tanh`, `asinh`, `acosh`, `atanh` | number | number |
//! | `atan2(y, x)` | two scalars of one dimension | angle |
//! | `sqrt(x)`, `powi(x, n)` | scalar; n an integer literal from -64 to 64 | scalar, the power of length halved or multiplied |
//! | `cis(angle)` | angle | unit vector of the plane |
//! | `polar(length, angle)` | scalar, angle | plane vector |
//! | `vec2(x, y)` | two scalars of one dimension | plane vector |
//! | `vec3(x, y, z)` | three scalars of one dimension | space vector |
//! | `rot_x(angle)`, `rot_y(angle)`, `rot_z(angle)` | angle | rotation |
//! | `rot(axis, angle)` | space vector, angle | rotation |
//! | `dot(a, b)`, `cross(a, b)` | two plane or two space vectors | scalar; `cross` in space a vector |
//! | `norm(v)` | vector | scalar of the same dimension |
//!
//! All of them may be written as methods of their first argument: `theta.cis()`, `y.atan2(x)`.

mod algebra;
mod assemble;
mod bug;
mod derive;
mod emit;
mod expand;
mod fallback;
mod mistakes;
mod model;
mod passes;
mod plan;
mod precedence;
mod program;
mod refuse;
mod room;
mod schedule;
mod structure;
mod syntax;
#[cfg(test)]
mod testing;
mod translate;
mod work;

/// `mechanism!`, called with the path of the crate that it belongs to in parentheses before the declaration.
#[doc(hidden)]
#[proc_macro]
pub fn mechanism_in(tokens: proc_macro::TokenStream) -> proc_macro::TokenStream {
    bug::expand_or_tell(tokens.into()).into()
}
