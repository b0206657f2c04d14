//! The formulas of a mechanism, to be read.

use core::fmt::{self, Display, Formatter};

/// A formula, or several below each other, in three forms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Formula<'d> {
    /// Text in Unicode, one formula on each line.
    pub text: &'d str,
    /// MathML, which browsers show: a `<math>` element with a table.
    pub mathml: &'d str,
    /// LaTeX for the mathematical mode: an `aligned` environment of the package `amsmath`.
    pub latex: &'d str,
}

/// The equations of a mechanism and their solution, in the notation of textbooks.
///
/// Names become letters with indices: `theta3` is θ₃. Points and vectors are bold. A vector of the plane is a complex
/// number, so `cis(theta)` is e^(iθ), and `vec2(x, y)` is x + i y. If the declaration has a quantity `e` or `i`, the
/// text has cis(θ) instead.
///
/// A solution may introduce further letters. They hold for one block, and have a prime where the declaration uses the
/// same letter. An expression that is too long to be read is written as a function h of the inputs and unknowns that it
/// contains, and a typed formula as dots.
///
/// ```
/// use kin_core::library::SliderCrank;
///
/// let formulas = SliderCrank::FORMULAS;
/// assert_eq!(formulas.closure.text, "r sin(θ) = l sin(φ)\ns = r cos(θ) + l cos(φ)");
/// println!("{}", formulas.position[0].latex);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Formulas<'d> {
    /// The abbreviations that the equations use, the equations, and the ranges of the unknowns.
    pub closure: Formula<'d>,
    /// The solution of each block of [`Description::blocks`](crate::Description::blocks). For a block that Newton's
    /// method solves, these are the linear equations of a step Δ.
    pub position: &'d [Formula<'d>],
    /// The linear equations of each block's velocities. The rates of the block's unknowns are on the left.
    pub velocity: &'d [Formula<'d>],
    /// The linear equations of all higher orders, where **A** ẋ = **b** are those of a block's velocities. Each order
    /// has the same matrix **A**.
    pub rates: Formula<'d>,
    /// The abbreviations that the outputs use, and the outputs.
    pub outputs: Formula<'d>,
}

impl<'d> Formula<'d> {
    /// The formula in its three forms.
    #[doc(hidden)]
    #[must_use]
    pub const fn new(text: &'d str, mathml: &'d str, latex: &'d str) -> Self {
        Self { text, mathml, latex }
    }
}

impl<'d> Formulas<'d> {
    /// The formulas of a mechanism, part by part.
    #[doc(hidden)]
    #[must_use]
    pub const fn new(
        closure: Formula<'d>,
        position: &'d [Formula<'d>],
        velocity: &'d [Formula<'d>],
        rates: Formula<'d>,
        outputs: Formula<'d>,
    ) -> Self {
        Self {
            closure,
            position,
            velocity,
            rates,
            outputs,
        }
    }
}

/// Writes the text.
impl Display for Formula<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self.text)
    }
}
