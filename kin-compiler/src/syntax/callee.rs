//! The names that can be called: the elementary functions, powers, and the functions of vectors.

use crate::algebra::Function;
use crate::syntax::Callee;

/// The function whose second argument is a whole number. This number is part of the form, not an argument.
pub(super) const POWER: &str = "powi";

/// The spelling of a call of that function.
pub(super) const FORM_OF_POWER: &str = "powi(x, 2)";

impl Callee {
    /// All functions that are not elementary.
    const OF_VECTORS: [Self; 11] = [
        Self::Cis,
        Self::Polar,
        Self::Vec2,
        Self::Vec3,
        Self::RotX,
        Self::RotY,
        Self::RotZ,
        Self::Rot,
        Self::Dot,
        Self::Cross,
        Self::Norm,
    ];

    /// The function with this name.
    pub(crate) fn from_name(name: &str) -> Option<Self> {
        Self::OF_VECTORS
            .into_iter()
            .find(|callee| callee.name() == name)
            .or_else(|| Function::from_name(name).map(Self::Elementary))
    }

    /// The spelling of a call, as messages show it.
    pub(crate) fn form(self) -> &'static str {
        match self {
            Self::Elementary(function) => function.form(),
            Self::Cis => "cis(angle)",
            Self::Polar => "polar(length, angle)",
            Self::Vec2 => "vec2(x, y)",
            Self::Vec3 => "vec3(x, y, z)",
            Self::RotX => "rot_x(angle)",
            Self::RotY => "rot_y(angle)",
            Self::RotZ => "rot_z(angle)",
            Self::Rot => "rot(axis, angle)",
            Self::Dot => "dot(a, b)",
            Self::Cross => "cross(a, b)",
            Self::Norm => "norm(v)",
        }
    }

    /// The number of arguments.
    pub(crate) fn arity(self) -> usize {
        match self {
            Self::Elementary(function) => function.arity(),
            Self::Cis | Self::RotX | Self::RotY | Self::RotZ | Self::Norm => 1,
            Self::Polar | Self::Vec2 | Self::Rot | Self::Dot | Self::Cross => 2,
            Self::Vec3 => 3,
        }
    }

    /// The name, as it is typed.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Elementary(function) => function.name(),
            Self::Cis => "cis",
            Self::Polar => "polar",
            Self::Vec2 => "vec2",
            Self::Vec3 => "vec3",
            Self::RotX => "rot_x",
            Self::RotY => "rot_y",
            Self::RotZ => "rot_z",
            Self::Rot => "rot",
            Self::Dot => "dot",
            Self::Cross => "cross",
            Self::Norm => "norm",
        }
    }
}

/// Every name that can be called, in the order in which messages list the names.
pub(crate) fn function_names() -> impl Iterator<Item = &'static str> {
    let elementary = Function::ALL.iter().map(|function| function.name());
    let of_vectors = Callee::OF_VECTORS.into_iter().map(Callee::name);
    elementary.chain([POWER]).chain(of_vectors)
}

/// Whether a name can be called.
pub(crate) fn is_function(name: &str) -> bool {
    form(name).is_some()
}

/// The spelling of a call of the function with this name.
pub(crate) fn form(name: &str) -> Option<&'static str> {
    if name == POWER {
        Some(FORM_OF_POWER)
    } else {
        Callee::from_name(name).map(Callee::form)
    }
}
