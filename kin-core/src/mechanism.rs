//! What every mechanism has in common, so that sweeps, tables and verification are written once.

use core::fmt::Debug;

use crate::{Motion, Scalar, SolveError};

/// A declared mechanism, as the `mechanism!` macro implements it.
///
/// The associated rows are arrays; their lengths are the numbers of parameters, inputs, unknowns and scalar equations.
/// Points count as two scalars, x and y.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// /// The largest angular acceleration of any unknown over a turn of the (only) input, wherever the mechanism closes.
/// fn peak<M: Mechanism<Scalar = f64>>(mechanism: &M, assembly: M::Assembly, speed: f64) -> f64 {
///     let mut peak: f64 = 0.0;
///     for step in 0..360 {
///         let input = Motion::at_constant_speed(f64::from(step).to_radians(), speed);
///         let inputs = M::Inputs::from_fn(|_| input);
///         if let Ok(pose) = mechanism.solve_motion(inputs, assembly) {
///             for unknown in pose.unknown_motions().as_ref() {
///                 peak = peak.max(unknown.acceleration().abs());
///             }
///         }
///     }
///     peak
/// }
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// assert!(peak(&linkage, Assembly::Open, 10.0) > 50.0);
/// ```
pub trait Mechanism: Copy + Debug {
    /// The number type.
    type Scalar: Scalar;
    /// The same mechanism with another number type.
    type With<S: Scalar>: Mechanism<Scalar = S, Assembly = Self::Assembly>;
    /// Which of several solutions: [`Assembly`](crate::Assembly), a structure of them, or `()` if there is but one.
    type Assembly: Copy + Debug + PartialEq + 'static;
    /// Position and all time derivatives to snap.
    type Pose: Pose<Scalar = Self::Scalar, Unknowns<Motion<Self::Scalar, 5>> = Self::Unknowns<Motion<Self::Scalar, 5>>>;
    /// A value for each scalar parameter.
    type Parameters<V: Copy>: Row<V>;
    /// A value for each input.
    type Inputs<V: Copy>: Row<V>;
    /// A value for each unknown.
    type Unknowns<V: Copy>: Row<V>;
    /// A value for each scalar equation.
    type Residuals<V: Copy>: Row<V>;

    /// Names, dimensions, equations and how they are solved.
    const DESCRIPTION: Description;
    /// How many assemblies there are.
    const ASSEMBLY_COUNT: usize;

    /// The assembly of a number below [`ASSEMBLY_COUNT`](Self::ASSEMBLY_COUNT); higher ones count from the start again.
    fn assembly(index: usize) -> Self::Assembly;

    /// A mechanism of given parameters.
    fn from_parameters(parameters: Self::Parameters<Self::Scalar>) -> Self;

    /// Its parameters.
    fn parameters(&self) -> Self::Parameters<Self::Scalar>;

    /// The same mechanism with its parameters converted, to dual numbers for instance.
    fn convert<S: Scalar>(&self, convert: impl FnMut(Self::Scalar) -> S) -> Self::With<S>;

    /// Position and all time derivatives to snap, as the inherent `solve` gives them.
    ///
    /// # Errors
    /// As the inherent method.
    fn solve_motion(
        &self,
        inputs: Self::Inputs<Motion<Self::Scalar, 5>>,
        assembly: Self::Assembly,
    ) -> Result<Self::Pose, SolveError>;

    /// The position alone, as the inherent `position` gives it: the values of the unknowns.
    ///
    /// # Errors
    /// As the inherent method.
    fn solve_position(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        assembly: Self::Assembly,
    ) -> Result<Self::Unknowns<Self::Scalar>, SolveError>;

    /// What is left of each scalar equation, left side less right, for any values of inputs and unknowns.
    fn residuals(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        unknowns: Self::Unknowns<Self::Scalar>,
    ) -> Self::Residuals<Self::Scalar>;

    /// Every assembly.
    fn assemblies() -> impl Iterator<Item = Self::Assembly> {
        (0..Self::ASSEMBLY_COUNT).map(Self::assembly)
    }
}

/// The motion of a mechanism through snap.
pub trait Pose: Copy + Debug {
    /// The number type.
    type Scalar: Scalar;
    /// A value for each unknown.
    type Unknowns<V: Copy>: Row<V>;
    /// A value for each scalar output.
    type Outputs<V: Copy>: Row<V>;

    /// The unknowns, in the order in which they were declared.
    fn unknown_motions(&self) -> Self::Unknowns<Motion<Self::Scalar, 5>>;

    /// The outputs, in the order in which they were declared; a point is its x, then its y.
    fn output_motions(&self) -> Self::Outputs<Motion<Self::Scalar, 5>>;
}

/// An array of one value for each of some quantities.
pub trait Row<V>: Copy + AsRef<[V]> + AsMut<[V]> {
    /// How many there are.
    const LENGTH: usize;

    /// The values of a function of the index.
    fn from_fn(function: impl FnMut(usize) -> V) -> Self;
}

impl<V: Copy, const N: usize> Row<V> for [V; N] {
    const LENGTH: usize = N;

    fn from_fn(function: impl FnMut(usize) -> V) -> Self {
        core::array::from_fn(function)
    }
}

/// What a mechanism says of itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Description {
    /// The name of the structure.
    pub name: &'static str,
    /// Parameters, scalar by scalar.
    pub parameters: &'static [Quantity],
    /// Inputs.
    pub inputs: &'static [Quantity],
    /// Unknowns.
    pub unknowns: &'static [Quantity],
    /// Outputs, scalar by scalar.
    pub outputs: &'static [Quantity],
    /// The equations as they were declared.
    pub equations: &'static [&'static str],
    /// The blocks in the order in which they are solved.
    pub blocks: &'static [Block],
    /// The highest time derivative.
    pub order: usize,
    /// What each order costs, position first, in the assembly that costs most.
    pub operations: &'static [Operations],
}

/// A named quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its name; the parts of a point `p` are `p.x` and `p.y`.
    pub name: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    /// The first paragraph of its documentation, empty if it has none.
    pub description: &'static str,
}

/// What a quantity measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// A length, in the mechanism's own unit.
    Length,
    /// An angle, in radians.
    Angle,
    /// A plain number.
    Scalar,
}

/// Unknowns that are solved together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    /// Their names, separated by commas.
    pub unknowns: &'static str,
    /// The closed form.
    pub closed_form: &'static str,
}

/// How many operations something takes, by kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Hash)]
pub struct Operations {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Changes of sign.
    pub negations: usize,
    /// Square roots.
    pub square_roots: usize,
    /// Pairs of a sine and a cosine.
    pub sine_cosines: usize,
    /// Arctangents.
    pub arc_tangents: usize,
    /// Other functions.
    pub others: usize,
}

impl Operations {
    /// No operation at all.
    pub const NONE: Self = Self {
        additions: 0,
        multiplications: 0,
        divisions: 0,
        negations: 0,
        square_roots: 0,
        sine_cosines: 0,
        arc_tangents: 0,
        others: 0,
    };

    /// Additions, subtractions, multiplications, divisions and changes of sign together.
    #[must_use]
    pub const fn arithmetic(&self) -> usize {
        self.additions + self.multiplications + self.divisions + self.negations
    }

    /// The sum, kind by kind.
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        Self {
            additions: self.additions + other.additions,
            multiplications: self.multiplications + other.multiplications,
            divisions: self.divisions + other.divisions,
            negations: self.negations + other.negations,
            square_roots: self.square_roots + other.square_roots,
            sine_cosines: self.sine_cosines + other.sine_cosines,
            arc_tangents: self.arc_tangents + other.arc_tangents,
            others: self.others + other.others,
        }
    }
}
