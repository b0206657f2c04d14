//! Formulas as trees, without parentheses: these are a matter of the printer.

use super::name::Name;

/// A formula in the notation of the field.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Notation {
    /// A number that is not negative.
    Number(f64),
    /// An angle in degrees that is not negative.
    Degrees(f64),
    Pi,
    /// The imaginary unit.
    Imaginary,
    /// What would be too long to read.
    Dots,
    Name(Name),
    /// The time derivative of this order.
    Rate(Name, usize),
    /// Words between formulas.
    Words(&'static str),
    Negative(Box<Notation>),
    /// One of both signs.
    Either(Box<Notation>),
    Sum(Vec<Notation>),
    Product(Vec<Notation>),
    Dot(Box<Notation>, Box<Notation>),
    Cross(Box<Notation>, Box<Notation>),
    Quotient(Box<Notation>, Box<Notation>),
    Power(Box<Notation>, i32),
    /// The unit vector of an angle.
    Direction(Box<Notation>),
    Root(Box<Notation>),
    Norm(Box<Notation>),
    /// A function of the field, by its name in upright letters.
    Call(&'static str, Vec<Notation>),
    /// A quantity as a function of others.
    Function(Name, Vec<Notation>),
    Tuple(Vec<Notation>),
    /// A change of a quantity: a letter in front of its name, as in ∂f and Δx.
    Change(char, Name),
}

/// One line of a display: two formulas and the relation between them.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct DisplayLine {
    pub(super) left: Notation,
    pub(super) relation: &'static str,
    pub(super) right: Notation,
}

impl DisplayLine {
    /// `left = right`
    pub(super) const fn equation(left: Notation, right: Notation) -> Self {
        Self {
            left,
            relation: "=",
            right,
        }
    }
}

impl Notation {
    /// A number of either sign.
    pub(super) fn number(value: f64) -> Self {
        if value < 0.0 {
            Self::Negative(Box::new(Self::Number(-value)))
        } else {
            Self::Number(value)
        }
    }

    /// The opposite.
    pub(super) fn negative(self) -> Self {
        match self {
            Self::Negative(of) => *of,
            Self::Number(0.0) => self,
            other => Self::Negative(Box::new(other)),
        }
    }

    /// A sum. Sums among the terms become part of it.
    pub(super) fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        let mut flat = Vec::new();
        for term in terms {
            match term {
                Self::Sum(inner) => flat.extend(inner),
                Self::Number(0.0) => {}
                other => flat.push(other),
            }
        }
        match flat.len() {
            0 => Self::Number(0.0),
            1 => flat.remove(0),
            _ => Self::Sum(flat),
        }
    }

    /// A difference. A sum that is subtracted keeps its parentheses.
    pub(super) fn minus(self, other: Self) -> Self {
        Self::sum([self, other.negative()])
    }

    /// A product. Products among the factors become part of it, and signs are taken to the front.
    pub(super) fn product(factors: impl IntoIterator<Item = Self>) -> Self {
        let (mut flat, mut is_negative) = (Vec::new(), false);
        for factor in factors {
            let factor = match factor {
                Self::Negative(of) => {
                    is_negative = !is_negative;
                    *of
                }
                other => other,
            };
            match factor {
                Self::Product(inner) => flat.extend(inner),
                Self::Number(1.0) => {}
                other => flat.push(other),
            }
        }
        let product = match flat.len() {
            0 => Self::Number(1.0),
            1 => flat.remove(0),
            _ => Self::Product(flat),
        };
        if is_negative { product.negative() } else { product }
    }

    /// A quotient. Signs are taken to the front.
    pub(super) fn over(self, divisor: Self) -> Self {
        match (self, divisor) {
            (dividend, Self::Number(1.0)) => dividend,
            (Self::Negative(dividend), divisor) => dividend.over(divisor).negative(),
            (dividend, Self::Negative(divisor)) => dividend.over(*divisor).negative(),
            (dividend, divisor) => Self::Quotient(Box::new(dividend), Box::new(divisor)),
        }
    }

    /// A power with a whole exponent.
    pub(super) fn power(self, exponent: i32) -> Self {
        if exponent == 1 {
            self
        } else {
            Self::Power(Box::new(self), exponent)
        }
    }

    /// The square.
    pub(super) fn squared(self) -> Self {
        self.power(2)
    }

    pub(super) fn root(self) -> Self {
        Self::Root(Box::new(self))
    }

    pub(super) fn norm(self) -> Self {
        Self::Norm(Box::new(self))
    }

    /// The unit vector of an angle.
    pub(super) fn direction(angle: Self) -> Self {
        match angle {
            Self::Number(0.0) => Self::Number(1.0),
            angle => Self::Direction(Box::new(angle)),
        }
    }

    /// The number of leaves, counted to `limit`.
    pub(super) fn size(&self, limit: usize) -> usize {
        let of_all = |terms: &[Self]| {
            terms.iter().fold(
                0,
                |size, term| {
                    if size > limit { size } else { size + term.size(limit) }
                },
            )
        };
        match self {
            Self::Number(_)
            | Self::Degrees(_)
            | Self::Pi
            | Self::Imaginary
            | Self::Dots
            | Self::Name(_)
            | Self::Rate(..)
            | Self::Words(_)
            | Self::Change(..) => 1,
            Self::Negative(of)
            | Self::Either(of)
            | Self::Power(of, _)
            | Self::Direction(of)
            | Self::Root(of)
            | Self::Norm(of) => of.size(limit),
            Self::Dot(left, right) | Self::Cross(left, right) | Self::Quotient(left, right) => {
                left.size(limit) + right.size(limit)
            }
            Self::Sum(terms)
            | Self::Product(terms)
            | Self::Tuple(terms)
            | Self::Call(_, terms)
            | Self::Function(_, terms) => 1 + of_all(terms),
        }
    }
}
