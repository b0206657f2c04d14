//! The dimensions of quantities, and the shapes of values.

use proc_macro2::{Ident, TokenTree};
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};

use crate::mistakes::suggestion;
use crate::syntax::Axis;
use crate::syntax::elsewhere::instead_of_dimension;

/// The declared dimension of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// A length.
    Length,
    /// An angle, in radians.
    Angle,
    /// An angle that is returned as a unit vector. Only unknowns have this dimension.
    Direction,
    /// A plain number.
    Scalar,
    /// A point of the plane.
    Point,
    /// A vector of the plane, of lengths.
    Vector,
    /// A point of space.
    Point3,
    /// A vector of space, of lengths.
    Vector3,
}

/// The shape of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueShape {
    /// A single number.
    Scalar,
    /// A vector of the plane.
    Plane,
    /// A vector of space.
    Space,
    /// A rotation of space: the nine entries of its matrix, row by row.
    Rotation,
}

impl ValueShape {
    /// The axes along which a vector has its parts. Scalars and rotations have none.
    pub(crate) fn axes(self) -> &'static [Axis] {
        match self {
            Self::Scalar | Self::Rotation => &[],
            Self::Plane => &[Axis::X, Axis::Y],
            Self::Space => &[Axis::X, Axis::Y, Axis::Z],
        }
    }

    /// The names of the scalar parts of `name`: for example `p.x`, where `between` is the dot. A scalar is its own
    /// part.
    pub(crate) fn part_names(self, name: &str, between: &str) -> Vec<String> {
        if self == Self::Scalar {
            return vec![name.to_owned()];
        }
        self.axes()
            .iter()
            .map(|axis| format!("{name}{between}{axis}"))
            .collect()
    }
}

impl Dimension {
    const ALL: [Self; 8] = [
        Self::Length,
        Self::Angle,
        Self::Direction,
        Self::Scalar,
        Self::Point,
        Self::Vector,
        Self::Point3,
        Self::Vector3,
    ];

    /// The word for this dimension in a declaration.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Length => "Length",
            Self::Angle => "Angle",
            Self::Direction => "Direction",
            Self::Scalar => "Scalar",
            Self::Point => "Point",
            Self::Vector => "Vector",
            Self::Point3 => "Point3",
            Self::Vector3 => "Vector3",
        }
    }

    /// The shape of a quantity of this dimension.
    pub(crate) fn shape(self) -> ValueShape {
        match self {
            Self::Length | Self::Angle | Self::Direction | Self::Scalar => ValueShape::Scalar,
            Self::Point | Self::Vector => ValueShape::Plane,
            Self::Point3 | Self::Vector3 => ValueShape::Space,
        }
    }

    /// The dimension that other libraries call by this word.
    fn named_elsewhere(word: &str) -> Option<Self> {
        Some(match word.to_ascii_lowercase().as_str() {
            "vec2" | "vec2d" | "vector2" | "vector2d" | "vec" | "plane" | "complex" => Self::Vector,
            "vec3" | "vec3d" | "vector3d" | "space" => Self::Vector3,
            "point2" | "point2d" => Self::Point,
            "point3d" => Self::Point3,
            "f64" | "f32" | "float" | "double" | "real" | "number" | "ratio" => Self::Scalar,
            "distance" | "meter" | "meters" | "metre" | "metres" | "mm" | "millimeter" | "millimetre" => Self::Length,
            "rad" | "radian" | "radians" | "deg" | "degree" | "degrees" => Self::Angle,
            _ => return None,
        })
    }

    /// Whether a word is a dimension.
    pub(super) fn is_word(word: &str) -> bool {
        Self::ALL.iter().any(|dimension| dimension.word() == word)
    }

    /// Reads the dimension of a quantity other than an unknown. `what` names its kind in messages: `an input`.
    pub(crate) fn parse_of(input: ParseStream<'_>, what: &str, name: &Ident) -> Result<Self> {
        let at = input.span();
        let dimension = Self::parse(input)?;
        if dimension == Self::Direction {
            return Err(syn::Error::new(
                at,
                format!(
                    "only an unknown can be a `Direction`, which is found as a unit vector instead of an angle: \
                     declare {what} `{name}` an `Angle`"
                ),
            ));
        }
        Ok(dimension)
    }

    /// Reads a dimension. Any other word is an error at its first token.
    pub(crate) fn parse(input: ParseStream<'_>) -> Result<Self> {
        let wrong = |at: &TokenTree, word: &str, near: &str| {
            syn::Error::new(
                at.span(),
                format!(
                    "{word} is not a dimension: write `Length`, `Angle`, `Direction`, `Scalar`, `Point`, `Vector`, \
                     `Point3` or `Vector3`{near}"
                ),
            )
        };
        if !input.peek(Ident::peek_any) {
            let token: TokenTree = input.parse()?;
            return Err(wrong(&token, "this", ""));
        }
        let word = Ident::parse_any(input)?;
        let text = word.to_string();
        let known = Self::ALL.into_iter().find(|dimension| dimension.word() == text);
        match known {
            Some(dimension) if !input.peek(Token![::]) && !input.peek(Token![<]) => Ok(dimension),
            _ => {
                let near = match (known, instead_of_dimension(&text), Self::named_elsewhere(&text)) {
                    (Some(_), ..) => String::new(),
                    (None, Some(advice), _) => advice.to_owned(),
                    (None, None, Some(dimension)) => format!("; did you mean `{}`?", dimension.word()),
                    (None, None, None) => suggestion(&text, Self::ALL.map(Self::word)),
                };
                Err(wrong(&TokenTree::Ident(word), &format!("`{text}`"), &near))
            }
        }
    }
}
