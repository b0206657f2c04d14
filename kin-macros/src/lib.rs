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
//! A request asks for further generated items; `with` remains usable as a name. Statements may come in any order,
//! except that a `let` comes before its uses. Doc comments may precede statements, and each name of an `input` or
//! `unknown`. A constant is an expression without names.
//!
//! # Dimensions
//!
//! A formula is a scalar, a plane vector, a space vector or a rotation, and has a power of length. The operands of `+`,
//! `-` and `==` have the same power; a literal zero fits every power. `Angle`, `Direction` and `Scalar` are plain
//! numbers, so the product of a radius and an angle is a length. A `Direction`, which only an unknown can be, is an
//! angle that is returned as a unit vector. A scalar added to a plane vector lies along x, as a real number does among
//! complex ones. An equation between a vector and a scalar is a mistake. Two plane vectors are multiplied as complex
//! numbers: `v * cis(a)` is v, turned by a.
//!
//! Plane vectors and space vectors do not mix, and a scalar cannot be added to a space vector. A rotation can only be
//! multiplied by the space vector that it turns, or by another rotation.
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
//! Each function may be written as a method of its first argument: `theta.cis()`, `y.atan2(x)`.

mod algebra;
mod assemble;
mod bug;
mod derive;
mod editor;
mod emit;
mod expand;
mod fallback;
mod formulas;
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

/// Expands a declaration of `mechanism!`, after the path of `kin_core` in parentheses.
#[doc(hidden)]
#[proc_macro]
pub fn mechanism_in(tokens: proc_macro::TokenStream) -> proc_macro::TokenStream {
    bug::expand_or_tell(tokens.into()).into()
}
