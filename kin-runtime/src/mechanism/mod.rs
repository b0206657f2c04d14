//! The common interface of all mechanisms, so that sweeps, tables and verification are written once.

mod block_form;
mod closure_term;
pub(crate) mod condition;
mod description;
mod failed;
mod formulas;
#[doc(hidden)]
pub mod guessed;
#[cfg(feature = "alloc")]
mod jacobian;
mod memory;
mod named;
mod one_input;
mod pose_of;
mod position_search;
mod prepared;
mod sensitive;
mod sensitivities;
mod shown;
mod sizes;

pub use block_form::BlockForm;
#[doc(hidden)]
pub use block_form::length;
pub use closure_term::{ClosureHarmonic, ClosureTerm};
pub use description::{Block, Description};
#[doc(hidden)]
pub use failed::{culprit, culprit_in, failed, failed_in};
pub use formulas::{Formula, Formulas};
#[cfg(feature = "alloc")]
pub(crate) use jacobian::rows_of;
#[cfg(feature = "alloc")]
pub use jacobian::{Jacobian, JacobianError, JacobianMeasure, JacobianNumber};
#[cfg(feature = "alloc")]
pub(crate) use memory::HeapMemory;
#[doc(hidden)]
pub use memory::{First, Lent, Memory, Second};
pub use named::Named;
pub use one_input::OneInput;
pub use pose_of::PoseOf;
pub use position_search::PositionSearch;
pub use prepared::{Preparation, Prepared};
pub use sensitive::{Partials, Sensitive};
pub use sensitivities::PartialMotions;
#[doc(hidden)]
pub use shown::{Shown, fmt_pose};
pub(crate) use sizes::Sizes;

use core::fmt::Debug;

#[cfg(feature = "alloc")]
use crate::assembly::assembly_name;
use crate::failure::SolveError;
#[cfg(feature = "alloc")]
use crate::number::Number;
use crate::number::Row;
use crate::picture::{Outline, PlaneOrSpace, PointArray, Skeleton, TransmissionAngle};
use crate::solve::Scalar;

/// A declared mechanism.
///
/// Only `mechanism!` implements this trait. A new version may add items without a default.
///
/// The solvers have the names of the inherent methods that `mechanism!` makes for each structure, and take the inputs
/// as one row. On a structure itself the inherent method is called; `Mechanism::position(&linkage, [1.0], assembly)`
/// calls that of the trait. The errors are the same.
///
/// The associated rows are arrays. Their lengths are the numbers of scalar parameters, inputs, unknowns and scalar
/// equations. A point in the plane counts as two scalars, x and y, a point in space as three.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// /// The largest angular acceleration of any unknown over a revolution of the only input, where the mechanism closes.
/// fn peak<M: Mechanism<Scalar = f64>>(mechanism: &M, assembly: M::Assembly, speed: f64) -> f64 {
///     let mut peak: f64 = 0.0;
///     for step in 0..360 {
///         let rates = [f64::from(step).to_radians(), speed];
///         let inputs = M::Inputs::from_fn(|_| M::Motion::from_fn(|order| rates.get(order).copied().unwrap_or(0.0)));
///         if let Ok(pose) = mechanism.solve(inputs, assembly) {
///             for unknown in pose.unknown_motions().as_ref() {
///                 peak = peak.max(unknown[2].abs());
///             }
///         }
///     }
///     peak
/// }
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// assert!(peak(&linkage, Assembly::Open, 10.0) > 50.0);
/// ```
pub trait Mechanism: Copy + Debug + 'static {
    /// The number type.
    type Scalar: Scalar;
    /// The same mechanism with another number type.
    type With<S: Scalar>: Mechanism<Scalar = S, Assembly = Self::Assembly, Motion<S> = Self::Motion<S>>;
    /// The choice among several solutions: [`Assembly`](crate::Assembly), a structure of assemblies, `()` if there is
    /// only one solution, or [`Near`](crate::Near) values of the unknowns if a block of coupled equations has no closed
    /// form.
    type Assembly: Copy + Debug + PartialEq + 'static;
    /// A value with all its time derivatives up to the mechanism's order, [`Motion<V, 5>`](crate::Motion) up to snap.
    type Motion<V: Copy>: Row<V>;
    /// The position and all time derivatives up to the mechanism's order.
    type Pose: Pose<
            Scalar = Self::Scalar,
            Motion = Self::Motion<Self::Scalar>,
            Unknowns<Self::Motion<Self::Scalar>> = Self::Unknowns<Self::Motion<Self::Scalar>>,
        >;
    /// A value for each scalar parameter.
    type Parameters<V: Copy>: Row<V>;
    /// A value for each input.
    type Inputs<V: Copy>: Row<V>;
    /// A value for each unknown.
    type Unknowns<V: Copy>: Row<V>;
    /// A value for each unknown, then for each scalar output.
    type Results<V: Copy>: Row<V>;
    /// A value for each scalar equation.
    type Residuals<V: Copy>: Row<V>;
    /// What the solvers find from the parameters alone, see [`Prepared`].
    #[doc(hidden)]
    type Prepared: Copy + Debug;
    /// A value for each block, in the order of [`DESCRIPTION.blocks`](Description::blocks).
    type Blocks<V: Copy>: Row<V>;
    /// A value for each dyad of two links, or of a link and a slider.
    type Dyads<V: Copy>: Row<V>;
    /// The joints of the skeleton and the directions of its slides: an array of points of the plane or of space.
    type SkeletonPoints: PointArray<Point: PlaneOrSpace<Scalar = Self::Scalar>>;

    /// The names, dimensions and equations, and the methods that solve them.
    const DESCRIPTION: Description<'static>;
    /// The equations and their solution in the notation of textbooks, as text, MathML and LaTeX.
    const FORMULAS: Formulas<'static>;
    /// The number of assemblies, or zero if it depends on the dimensions.
    const ASSEMBLY_COUNT: usize;
    /// Which joints of the skeleton belong together, [`Outline::NONE`] if nothing can be drawn.
    const OUTLINE: Outline<'static>;

    /// The assembly with a given index, if the index is below [`ASSEMBLY_COUNT`](Self::ASSEMBLY_COUNT).
    fn assembly(index: usize) -> Option<Self::Assembly>;

    /// The assembly to which the given values of the unknowns belong.
    fn assembly_at(&self, inputs: Self::Inputs<Self::Scalar>, near: Self::Unknowns<Self::Scalar>) -> Self::Assembly;

    /// The values of the unknowns that stand for an assembly of coupled blocks. Other assemblies have an index.
    #[doc(hidden)]
    #[must_use]
    fn values_near(assembly: Self::Assembly) -> Option<Self::Unknowns<f64>> {
        let _ = assembly;
        None
    }

    /// The mechanism with the given parameters.
    fn from_parameters(parameters: Self::Parameters<Self::Scalar>) -> Self;

    /// The parameters of this mechanism.
    fn parameters(&self) -> Self::Parameters<Self::Scalar>;

    /// This mechanism with its parameters converted, for example to dual numbers.
    fn convert<S: Scalar>(&self, convert: impl FnMut(Self::Scalar) -> S) -> Self::With<S>;

    /// The position and all time derivatives.
    ///
    /// # Errors
    /// A [`SolveError`] if the mechanism does not close in this assembly, or if a number is not finite.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve(
        &self,
        inputs: Self::Inputs<Self::Motion<Self::Scalar>>,
        assembly: Self::Assembly,
    ) -> Result<Self::Pose, SolveError> {
        self.solve_prepared(&self.prepare(), inputs, assembly)
    }

    /// What the solvers find from the parameters alone.
    #[doc(hidden)]
    fn prepare(&self) -> Self::Prepared;

    /// [`solve`](Self::solve) with what is prepared.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    #[doc(hidden)]
    fn solve_prepared(
        &self,
        prepared: &Self::Prepared,
        inputs: Self::Inputs<Self::Motion<Self::Scalar>>,
        assembly: Self::Assembly,
    ) -> Result<Self::Pose, SolveError>;

    /// The position and all time derivatives closest to values of the unknowns.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    fn solve_near(
        &self,
        inputs: Self::Inputs<Self::Motion<Self::Scalar>>,
        near: Self::Unknowns<Self::Scalar>,
    ) -> Result<Self::Pose, SolveError>;

    /// The position alone: the values of the unknowns.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    fn position(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        assembly: Self::Assembly,
    ) -> Result<Self::Unknowns<Self::Scalar>, SolveError>;

    /// The position closest to values of the unknowns, with angles nearest to them. The method of a mechanism with the
    /// same name takes a pose, too, such as that of the last step:
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// // a double crank: the ground is the shortest link
    /// let linkage: FourBar = FourBar { r1: 20.0, r2: 50.0, r3: 45.0, r4: 55.0 };
    /// let mut pose = linkage.position(0.0, Assembly::Open)?;
    /// let start = pose.theta4.position();
    /// for step in 1..=720 {
    ///     pose = linkage.position_near(f64::from(step).to_radians(), pose)?;
    /// }
    /// // after two revolutions of the crank the rocker has made two as well
    /// assert!((pose.theta4.position() - start - 4.0 * std::f64::consts::PI).abs() < 1e-12);
    /// # Ok::<(), SolveError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    fn position_near(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        near: Self::Unknowns<Self::Scalar>,
    ) -> Result<Self::Unknowns<Self::Scalar>, SolveError>;

    /// The residual of each scalar equation, left side minus right side, for any values of inputs and unknowns.
    fn closure(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        unknowns: Self::Unknowns<Self::Scalar>,
    ) -> Self::Residuals<Self::Scalar>;

    /// Calls `found` with the closure as trigonometric polynomials of inputs and unknowns: the terms of the scalar
    /// equations, whose sums are the residuals of [`closure`](Self::closure), and the coefficients of these terms.
    ///
    /// Only a mechanism with a coupled block has them, if its closure is algebraic: then angles occur in sines and
    /// cosines only, and nothing that moves stands in a denominator. Otherwise `found` is not called.
    fn closure_terms(&self, found: impl FnOnce(&'static [ClosureTerm<'static>], &[Self::Scalar])) {
        let _ = found;
    }

    /// The inherent method of this name exists `with sensitivities;` only. Without it this one is found instead, and
    /// the compiler names the request that is missing.
    #[doc(hidden)]
    fn sensitivities(&self, pose: &Self::Pose) -> Self::Parameters<<Self as Sensitive>::Partials>
    where
        Self: Sensitive,
    {
        self.sensitivities_of(pose)
    }

    /// The partial derivatives of the motion at given inputs with respect to each scalar parameter, in all its orders.
    ///
    /// The mechanism is solved once for each parameter, with numbers that carry the derivative with respect to it. So
    /// no mechanism has to request them, and they are exact but for rounding. A mechanism that is declared
    /// `with sensitivities;` has straight-line code for them: see [`Sensitive`], which is several times faster.
    ///
    /// Entry n of a motion is the derivative of the n-th time derivative, in the unit of the unknown or output over the
    /// unit of the parameter and over the n-th power of the unit of time.
    ///
    /// # Errors
    /// The errors of [`solve`](Self::solve) at these inputs and in this assembly.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let crank = Motion::at_constant_speed(1.1, 10.0);
    /// let by = linkage.sensitivities_at([crank], Assembly::Open)?;
    /// // of the rocker's angular velocity, with respect to the length of the coupler
    /// let [_, theta4] = by[2].unknown_partials();
    /// let longer = FourBar { r3: 60.001, ..linkage };
    /// let change = longer.solve(crank, Assembly::Open)?.theta4 - linkage.solve(crank, Assembly::Open)?.theta4;
    /// assert!((theta4.velocity() - change.velocity() / 0.001).abs() < 1e-4);
    /// # Ok::<(), SolveError>(())
    /// ```
    fn sensitivities_at(
        &self,
        inputs: Self::Inputs<Self::Motion<f64>>,
        assembly: Self::Assembly,
    ) -> Result<Self::Parameters<PartialMotions<Self>>, SolveError>
    where
        Self: Mechanism<Scalar = f64>,
    {
        sensitivities::sensitivities_at(self, inputs, assembly)
    }

    /// The joints of the skeleton and the directions of its slides, for any values of inputs and unknowns.
    fn skeleton_points(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        unknowns: Self::Unknowns<Self::Scalar>,
    ) -> Self::SkeletonPoints;

    /// The scalar outputs, for any values of inputs and unknowns. An angle that an output finds itself is in -π ..= π.
    fn outputs_at(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        unknowns: Self::Unknowns<Self::Scalar>,
    ) -> <Self::Pose as Pose>::Outputs<Self::Scalar>;

    /// The skeleton of a pose of any order, as the inherent `skeleton` gives it.
    fn skeleton(&self, pose: &impl PoseOf<Self>) -> Skeleton<'static, Self::SkeletonPoints> {
        let (inputs, unknowns) = pose.values();
        Skeleton::new(&Self::OUTLINE, self.skeleton_points(inputs, unknowns))
    }

    /// The form of each block, with the lengths of its links as numbers from the parameters. See [`BlockForm`].
    fn block_forms(&self) -> Self::Blocks<BlockForm<Self::Scalar>>;

    /// The transmission angle of every dyad, in the order in which the dyads are solved, for any values of inputs and
    /// unknowns.
    fn transmission_angles_at(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        unknowns: Self::Unknowns<Self::Scalar>,
    ) -> Self::Dyads<TransmissionAngle<Self::Scalar>>;

    /// The transmission angle of every dyad in a pose of any order. The request `with transmission_angles;` makes the
    /// same method inherent.
    fn transmission_angles(&self, pose: &impl PoseOf<Self>) -> Self::Dyads<TransmissionAngle<Self::Scalar>> {
        let (inputs, unknowns) = pose.values();
        self.transmission_angles_at(inputs, unknowns)
    }

    /// The Jacobian of a pose of any order: the partial derivatives of the unknowns, then of the scalar outputs, with
    /// respect to the inputs.
    ///
    /// It has a row for each unknown and then for each scalar output, and in each row a number for each input, all in
    /// the order in which they were declared. A point has a row for x, a row for y and, in space, a row for z. An entry
    /// has the unit of its unknown or output over that of its input: radians per radian, lengths per radian, and so on.
    /// A row times the velocities of the inputs is the velocity of its unknown or output, and the transposed rows
    /// convert forces into the efforts of the inputs.
    ///
    /// It does not depend on the velocity of the pose, and never divides by it: the position is solved again from the
    /// unknowns of the pose, and the velocity once for each input.
    ///
    /// # Errors
    /// Returns the errors of `position_near`: the pose is not one of this mechanism, or so close to a singular position
    /// that rounding decides whether it closes.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage: FourBar = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let pose = linkage.solve(Motion::at_constant_speed(1.1, 10.0), Assembly::Open)?;
    /// let [[theta3], [theta4]] = linkage.jacobian(&pose)?;
    /// assert!((10.0 * theta3 - pose.theta3.velocity()).abs() < 1e-13);
    /// assert!((10.0 * theta4 - pose.theta4.velocity()).abs() < 1e-13);
    /// # Ok::<(), SolveError>(())
    /// ```
    fn jacobian(&self, pose: &impl PoseOf<Self>) -> Result<Self::Results<Self::Inputs<Self::Scalar>>, SolveError> {
        let (inputs, unknowns) = pose.values();
        self.jacobian_near(inputs, unknowns)
    }

    /// The rows of the [`jacobian`](Self::jacobian) for unknowns or outputs of these names, with their singular values.
    /// A point has a row for each of its coordinates.
    ///
    /// All of these results must have one dimension, and all inputs must have one: see [`Jacobian`](crate::Jacobian),
    /// which says what singular values mean. Along a sweep, [`of_jacobian`](crate::sweep::Sweep::of_jacobian) finds
    /// where they are smallest.
    ///
    /// ```
    /// use kin_core::library::FiveBar;
    /// use kin_core::prelude::*;
    ///
    /// let robot = FiveBar { ground: 2.0, left: 1.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
    /// let pose = robot.position(2.2, 0.9, Assembly::Open)?;
    /// // lengths of the hand's way for each radian of the cranks
    /// let values = robot.jacobian_of(&pose, &["hand"])?.singular_values();
    /// assert!(values[0] > values[1] && values[1] > 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`JacobianError`](crate::JacobianError) for names that no result has, for mixed dimensions, and with the errors
    /// of [`jacobian`](Self::jacobian).
    #[cfg(feature = "alloc")]
    #[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
    fn jacobian_of(&self, pose: &impl PoseOf<Self>, results: &[&str]) -> Result<Jacobian<f64>, JacobianError> {
        let rows = rows_of(&Self::DESCRIPTION, results)?;
        let jacobian = self.jacobian(pose)?;
        let entry = |row: usize, column: usize| jacobian[rows[row]][column].real();
        Ok(Jacobian::from_fn(rows.len(), Self::DESCRIPTION.inputs.len(), entry))
    }

    /// The condition of each unknown of a pose, in the unit of the unknown: rounding changes its value by about this
    /// times ε, the [distance](crate::Number::EPSILON) from 1 to the next number.
    ///
    /// The condition is the sum of the first-order changes of the unknown that are caused by changing each of the
    /// following alone by a part ε of itself: every parameter and every input; the term of every unknown in every
    /// equation, where the term of an angle is the term of one radian; and the unknown itself. It is calculated in
    /// double precision for any number type, from the closure at the position and its derivatives alone. This takes one
    /// evaluation of the closure per parameter, input and unknown, and the factors of a matrix.
    ///
    /// The condition is infinite if the Jacobian is singular to all digits. If ε times its square is not small, it is
    /// only a warning, because the first order is not sufficient there: above about 10⁷ in double precision, next to a
    /// limit position, only half of the digits are right.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let position = linkage.position(1.0, Assembly::Open)?;
    /// let [theta3, theta4] = linkage.conditions(&position);
    /// assert!(theta3 < 10.0 && theta4 < 10.0);
    ///
    /// let near_the_limit = linkage.position(1.955, Assembly::Open)?;
    /// let [_, theta4] = linkage.conditions(&near_the_limit);
    /// println!("{} ± {:e} rad", near_the_limit.theta4.position(), f64::EPSILON * theta4);
    /// assert!(theta4 > 1e2);
    /// # Ok::<(), SolveError>(())
    /// ```
    fn conditions(&self, pose: &impl PoseOf<Self>) -> Self::Unknowns<f64> {
        let (inputs, unknowns) = pose.values();
        condition::conditions(self, &inputs, &unknowns)
    }

    /// The largest of the [conditions](Self::conditions), with angles measured in radians, lengths relative to the
    /// longest length of the mechanism, and plain numbers relative to their size if that is larger than 1. From 1/ε
    /// on, no digit of the position is reliable.
    fn condition(&self, pose: &impl PoseOf<Self>) -> f64 {
        let (inputs, unknowns) = pose.values();
        condition::condition(self, &inputs, &unknowns)
    }

    /// The Jacobian at the position closest to values of the unknowns: a row for each unknown and then for each scalar
    /// output, with its derivative with respect to each input. [`jacobian`](Self::jacobian) returns that of a pose.
    ///
    /// # Errors
    /// Returns the errors of [`position_near`](Self::position_near).
    fn jacobian_near(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        near: Self::Unknowns<Self::Scalar>,
    ) -> Result<Self::Results<Self::Inputs<Self::Scalar>>, SolveError>;

    /// Calls `found` with every regular position at given inputs: its assembly, and the values of the unknowns.
    ///
    /// Where every block has a closed form, these are the assemblies in which the mechanism closes. Otherwise they are
    /// the positions that the inherent method `assemblies_at` finds, in double precision, each refined in the
    /// mechanism's numbers. There is no such method where the coupled equations are not algebraic in the unknowns,
    /// their sines and cosines, or where the product of their degrees is above 1024, as for the angles of several
    /// bodies in space. Then nothing is found, and the search is not complete. A single body on six legs has the
    /// method.
    ///
    /// # Errors
    /// Returns an error if a parameter or an input is not finite.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let mut rocker = 0.0;
    /// let search = linkage.positions_at([1.0], |_, [_, theta4]| rocker += theta4)?;
    /// assert_eq!(search.found, 2);
    /// assert!(search.is_complete);
    /// # Ok::<(), SolveError>(())
    /// ```
    fn positions_at(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        found: impl FnMut(Self::Assembly, Self::Unknowns<Self::Scalar>),
    ) -> Result<PositionSearch, SolveError> {
        position_search::by_assembly(self, inputs, found)
    }

    /// Calls a function with the memory of a track, which allocates none.
    #[doc(hidden)]
    fn lend<R>(use_of_it: impl FnOnce(Lent<'_>) -> R) -> R;

    /// All assemblies; none if their number depends on the dimensions.
    ///
    /// A declared mechanism stands in angle brackets, which give it numbers of double precision. Without them rustc
    /// asks which numbers are meant, by its error E0283.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// assert_eq!(<FourBar>::assemblies().count(), 2);
    /// ```
    fn assemblies() -> impl Iterator<Item = Self::Assembly> {
        (0..Self::ASSEMBLY_COUNT).filter_map(Self::assembly)
    }

    /// The name of an assembly, as programs and tables write it: `open`, or `knee=open,foot=crossed` where several
    /// dyads have one each. It is empty if there is no choice.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// assert_eq!(FourBar::<f64>::assembly_name(Assembly::Crossed), "crossed");
    /// ```
    #[cfg(feature = "alloc")]
    #[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
    #[must_use]
    fn assembly_name(assembly: Self::Assembly) -> alloc::string::String {
        assembly_name(&assembly)
    }
}

/// The motion of a mechanism in all its orders.
///
/// Only `mechanism!` implements it. A new version may add items.
pub trait Pose: Copy + Debug {
    /// The number type.
    type Scalar: Scalar;
    /// A value with its time derivatives.
    type Motion: Row<Self::Scalar>;
    /// A value for each unknown.
    type Unknowns<V: Copy>: Row<V>;
    /// A value for each scalar output.
    type Outputs<V: Copy>: Row<V>;

    /// The motions of the unknowns, in the order in which they were declared.
    ///
    /// The angle of a [`Direction`](crate::Direction) is calculated here, in -π ..= π, unless another part of the
    /// mechanism has needed it.
    fn unknown_motions(&self) -> Self::Unknowns<Self::Motion>;

    /// The motions of the unknowns, with the angles that are calculated here unwrapped to the given values.
    /// [`solve_near`](Mechanism::solve_near) puts all other angles there.
    fn unknown_motions_near(&self, near: Self::Unknowns<Self::Scalar>) -> Self::Unknowns<Self::Motion> {
        let _ = near;
        self.unknown_motions()
    }

    /// The unknowns as the pose stores them: a direction has its cosine instead of its angle.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn unknown_columns(&self) -> Self::Unknowns<Self::Motion> {
        self.unknown_motions()
    }

    /// The sines of the unknowns that are directions.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn unknown_sines(&self) -> Self::Unknowns<Option<Self::Scalar>> {
        Row::splat(None)
    }

    /// The motions of the outputs, in the order in which they were declared. A point is its x, its y and, in space, its
    /// z.
    fn output_motions(&self) -> Self::Outputs<Self::Motion>;
}
