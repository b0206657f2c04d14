//! A mechanism without its type: slices in and out.
//!
//! An answer that is written for [`AnyMechanism`] is compiled once, in the crate that gives it. For each mechanism only
//! its functions are compiled, and of those only the ones that the answer names: there is a trait for each of them,
//! with the number type as parameter. [`Of`] implements all of them for every declared mechanism.
//!
//! All slices have the lengths that the [`Description`] gives. Parameters are an argument, so that an answer can change
//! dimensions, or give them derivatives.
//!
//! ```
//! use kin_core::any::{AnyMechanism, Of, PositionChoice};
//! use kin_core::library::{FourBar, SliderCrank};
//!
//! /// The unknowns of the first assembly.
//! fn first(
//!     mechanism: &dyn AnyMechanism,
//!     parameters: &[f64],
//!     inputs: &[f64],
//! ) -> Result<Vec<f64>, kin_core::SolveError> {
//!     let mut unknowns = vec![0.0; mechanism.description().unknowns.len()];
//!     mechanism.position(parameters, inputs, PositionChoice::Assembly(0), &mut unknowns)?;
//!     Ok(unknowns)
//! }
//!
//! let angles = first(Of::<FourBar>::FUNCTIONS, &[90.0, 30.0, 60.0, 45.0], &[1.0])?;
//! let slide = first(Of::<SliderCrank>::FUNCTIONS, &[0.1, 0.3], &[0.0])?;
//! assert_eq!((angles.len(), slide[1]), (2, 0.4));
//! # Ok::<(), kin_core::SolveError>(())
//! ```

#[cfg(feature = "alloc")]
use alloc::vec::Vec;
use core::marker::PhantomData;

#[doc(hidden)]
pub use crate::failure::InputNames;
use crate::failure::SolveError;
use crate::mechanism::{BlockForm, Mechanism, Pose, PositionSearch};
use crate::number::Row;
use crate::picture::{PlaneOrSpace, PointArray, TransmissionAngle};
use crate::solve::Scalar;

pub use crate::mechanism::{Block, ClosureHarmonic, ClosureTerm, Description, Formula, Formulas, Named};
pub use crate::picture::{Body, Outline, Skeleton};
pub use crate::quantity::{Name, NameKind, Quantity};

/// Which of several positions is meant.
#[derive(Clone, Copy, Debug)]
pub enum PositionChoice<'n, T> {
    /// The one of an assembly, by its index.
    Assembly(usize),
    /// The one that is closest to values of the unknowns.
    Near(&'n [T]),
}

/// A choice of one of several positions that is kept.
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
#[derive(Clone, Debug, PartialEq)]
pub enum AssemblyChoice {
    /// The one of an assembly, by its index.
    Index(usize),
    /// The one that is closest to values of the unknowns.
    Near(Vec<f64>),
}

#[cfg(feature = "alloc")]
impl AssemblyChoice {
    /// The choice as the solvers take it.
    #[must_use]
    pub fn position(&self) -> PositionChoice<'_, f64> {
        match self {
            Self::Index(index) => PositionChoice::Assembly(*index),
            Self::Near(near) => PositionChoice::Near(near),
        }
    }

    /// The index of the assembly, unless it depends on the dimensions.
    #[must_use]
    pub fn index(&self) -> Option<usize> {
        match self {
            Self::Index(index) => Some(*index),
            Self::Near(_) => None,
        }
    }

    /// The choice of a typed assembly.
    #[must_use]
    pub fn of<M: Mechanism>(assembly: M::Assembly) -> Self {
        let near = || M::values_near(assembly).map_or_else(Vec::new, |near| near.as_ref().to_vec());
        index_of::<M>(assembly).map_or_else(|| Self::Near(near()), Self::Index)
    }
}

/// Positions of an assembly in numbers of one type.
#[doc(hidden)]
pub trait AssemblyOver<T> {
    /// Writes the unknowns of an assembly, which is given by its index.
    ///
    /// # Errors
    /// Those of [`Mechanism::position`].
    fn position_of_assembly(
        &self,
        parameters: &[T],
        inputs: &[T],
        assembly: usize,
        unknowns: &mut [T],
    ) -> Result<(), SolveError>;
}

/// Positions near others in numbers of one type.
#[doc(hidden)]
pub trait NearOver<T> {
    /// Writes the unknowns of the position that is closest to values of them.
    ///
    /// # Errors
    /// Those of [`Mechanism::position_near`].
    fn position_near(&self, parameters: &[T], inputs: &[T], near: &[T], unknowns: &mut [T]) -> Result<(), SolveError>;
}

/// Positions in numbers of one type, chosen in both ways. Each way is compiled by itself: name the trait of one way
/// where it is enough.
#[doc(hidden)]
pub trait PositionOver<T>: AssemblyOver<T> + NearOver<T> {
    /// Writes the unknowns of a position.
    ///
    /// # Errors
    /// Those of [`Mechanism::position`] and [`Mechanism::position_near`].
    fn position(
        &self,
        parameters: &[T],
        inputs: &[T],
        choice: PositionChoice<'_, T>,
        unknowns: &mut [T],
    ) -> Result<(), SolveError> {
        match choice {
            PositionChoice::Assembly(index) => self.position_of_assembly(parameters, inputs, index, unknowns),
            PositionChoice::Near(near) => self.position_near(parameters, inputs, near, unknowns),
        }
    }
}

impl<T, F: AssemblyOver<T> + NearOver<T>> PositionOver<T> for F {}

/// The closure in numbers of one type.
#[doc(hidden)]
pub trait ClosureOver<T> {
    /// Writes the residual of each scalar equation.
    fn closure(&self, parameters: &[T], inputs: &[T], unknowns: &[T], residuals: &mut [T]);
}

/// The closure as trigonometric polynomials, with coefficients in numbers of one type.
#[doc(hidden)]
pub trait ClosureTermsOver<T> {
    /// Passes on the terms and their coefficients, as [`Mechanism::closure_terms`] does.
    fn closure_terms(&self, parameters: &[T], found: &mut dyn FnMut(&[ClosureTerm<'_>], &[T]));
}

/// The outputs in numbers of one type.
#[doc(hidden)]
pub trait OutputsOver<T> {
    /// Writes the scalar outputs. An angle that an output finds itself is in -π ..= π.
    fn outputs(&self, parameters: &[T], inputs: &[T], unknowns: &[T], outputs: &mut [T]);
}

/// Positions of an assembly with all time derivatives.
#[doc(hidden)]
pub trait AssemblyMotionOver<T> {
    /// Writes the motions of unknowns and outputs, one after the other, each with all its orders. The inputs are given
    /// in the same way.
    ///
    /// # Errors
    /// Those of [`Mechanism::solve`].
    fn motion_of_assembly(
        &self,
        parameters: &[T],
        inputs: &[T],
        assembly: usize,
        unknowns: &mut [T],
        outputs: &mut [T],
    ) -> Result<(), SolveError>;
}

/// Positions near others with all time derivatives.
#[doc(hidden)]
pub trait MotionNearOver<T> {
    /// Writes the motions of unknowns and outputs as [`AssemblyMotionOver`] does. Outputs beyond the slice are left
    /// out.
    ///
    /// # Errors
    /// Those of [`Mechanism::solve_near`].
    fn motion_near(
        &self,
        parameters: &[T],
        inputs: &[T],
        near: &[T],
        unknowns: &mut [T],
        outputs: &mut [T],
    ) -> Result<(), SolveError>;
}

/// Positions with all time derivatives, chosen in both ways, as [`PositionOver`] chooses positions.
#[doc(hidden)]
pub trait MotionOver<T>: AssemblyMotionOver<T> + MotionNearOver<T> {
    /// Writes the motions of unknowns and outputs as [`AssemblyMotionOver`] does.
    ///
    /// # Errors
    /// Those of [`Mechanism::solve`] and [`Mechanism::solve_near`].
    fn motion(
        &self,
        parameters: &[T],
        inputs: &[T],
        choice: PositionChoice<'_, T>,
        unknowns: &mut [T],
        outputs: &mut [T],
    ) -> Result<(), SolveError> {
        match choice {
            PositionChoice::Assembly(index) => self.motion_of_assembly(parameters, inputs, index, unknowns, outputs),
            PositionChoice::Near(near) => self.motion_near(parameters, inputs, near, unknowns, outputs),
        }
    }
}

impl<T, F: AssemblyMotionOver<T> + MotionNearOver<T>> MotionOver<T> for F {}

/// The transmission angles of all dyads in numbers of one type.
#[doc(hidden)]
pub trait TransmissionOver<T> {
    /// Writes the transmission angle of every dyad, in the order in which the dyads are solved.
    fn angles_of_dyads(&self, parameters: &[T], inputs: &[T], unknowns: &[T], angles: &mut [TransmissionAngle<T>]);
}

/// The forms of the blocks in numbers of one type.
#[doc(hidden)]
pub trait FormsOver<T> {
    /// Passes on the form of each block, in the order in which they are solved.
    fn block_forms(&self, parameters: &[T], found: &mut dyn FnMut(BlockForm<T>));
}

/// The skeleton in numbers of one type.
#[doc(hidden)]
pub trait SkeletonOver<T> {
    /// Passes on the coordinates of each joint of the [`outline`](Pictured::outline), and then of the direction of each
    /// slide: two in the plane, three in space.
    fn skeleton_points(&self, parameters: &[T], inputs: &[T], unknowns: &[T], found: &mut dyn FnMut(&[T]));
}

/// What is shown of a mechanism beside its motion.
#[doc(hidden)]
pub trait Pictured {
    /// Which joints belong together, [`Outline::NONE`] if nothing can be drawn.
    fn outline(&self) -> Outline<'_>;

    /// Whether joints have three coordinates.
    fn is_space(&self) -> bool;

    /// The equations and their solution in the notation of textbooks.
    fn formulas(&self) -> Formulas<'_>;
}

/// A search for all positions at given inputs.
#[doc(hidden)]
pub trait EveryPosition {
    /// Passes on the unknowns of every regular position.
    ///
    /// # Errors
    /// Those of [`Mechanism::positions_at`].
    fn every_position(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        found: &mut dyn FnMut(&[f64]),
    ) -> Result<PositionSearch, SolveError>;
}

/// What a mechanism is.
pub trait Described {
    /// The names, dimensions and equations.
    fn description(&self) -> &Description<'_>;

    /// A name in an error. Only a declared mechanism has names that live long enough, see [`Name`].
    fn name(&self, of: NameKind, index: usize) -> Name {
        Name::by_index(of, index)
    }

    /// The names of the inputs in an error.
    #[doc(hidden)]
    fn input_names(&self) -> InputNames {
        InputNames::by_index(self.description().inputs)
    }

    /// The number of assemblies, or zero if it depends on the dimensions.
    fn assembly_count(&self) -> usize;

    /// The name of an assembly, as [`Mechanism::assembly_name`] gives it. It is empty if there is only one.
    #[cfg(feature = "alloc")]
    #[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
    fn assembly_name(&self, index: usize) -> Option<alloc::string::String>;

    /// The names of all assemblies: none if a position is chosen by values nearby, and an empty one if there is no
    /// choice.
    #[cfg(feature = "alloc")]
    #[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
    fn assembly_names(&self) -> Vec<alloc::string::String> {
        let indices = 0..self.assembly_count();
        indices.filter_map(|index| self.assembly_name(index)).collect()
    }

    /// The names of the choices between two assemblies: none if there is no choice, or if a position is chosen by
    /// values nearby.
    #[cfg(feature = "alloc")]
    #[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
    fn choices(&self) -> Vec<alloc::string::String>;

    /// The number of dyads.
    fn dyad_count(&self) -> usize;
}

/// A mechanism without its type, in double precision: what every answer needs.
pub trait AnyMechanism: Described + PositionOver<f64> + ClosureOver<f64> {
    /// The index of the assembly to which a position belongs, if there are assemblies.
    fn assembly_at(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Option<usize>;
}

/// The functions of a declared mechanism on slices.
#[derive(Clone, Copy, Debug)]
pub struct Of<M>(PhantomData<fn() -> M>);

impl<M: 'static> Of<M> {
    /// The functions.
    pub const FUNCTIONS: &'static Self = &Self(PhantomData);
}

/// The row of the numbers in a slice.
pub(crate) fn row<T: Copy, R: Row<T>>(values: &[T]) -> R {
    R::from_fn(|index| values[index])
}

/// The motions in a slice of numbers.
pub(crate) fn motions<T: Copy, N: Row<T>, R: Row<N>>(values: &[T]) -> R {
    R::from_fn(|index| N::from_fn(|order| values[index * N::LENGTH + order]))
}

pub(crate) fn write<T: Copy, N: Row<T>>(motions: &[N], values: &mut [T]) {
    for (motion, values) in motions.iter().zip(values.chunks_exact_mut(N::LENGTH)) {
        values.copy_from_slice(motion.as_ref());
    }
}

fn with<M: Mechanism, T: Scalar>(parameters: &[T]) -> M::With<T> {
    M::With::from_parameters(row(parameters))
}

/// The description of a declared mechanism.
pub(crate) const fn description<M: Mechanism>() -> &'static Description<'static> {
    const { &M::DESCRIPTION }
}

/// The names of the fields of an assembly structure, which is read as it shows itself:
/// `Name { first: Open, second: Open }`.
#[cfg(feature = "alloc")]
fn fields(shown: &str) -> Vec<alloc::string::String> {
    let fields = shown.split_once('{').map_or("", |(_, fields)| fields);
    let names = fields.split(',').filter_map(|field| field.split_once(':'));
    names.map(|(name, _)| name.trim().into()).collect()
}

/// The assembly of an index. An answer takes an index from the mechanism itself.
pub(crate) fn assembly<M: Mechanism>(index: usize) -> M::Assembly {
    M::assembly(index).unwrap_or_else(|| panic!("{} has {} assemblies", M::DESCRIPTION.name, M::ASSEMBLY_COUNT))
}

/// The index of an assembly, unless it depends on the dimensions.
pub(crate) fn index_of<M: Mechanism>(wanted: M::Assembly) -> Option<usize> {
    M::assemblies().position(|assembly| assembly == wanted)
}

impl<M: Mechanism, T: Scalar> AssemblyOver<T> for Of<M> {
    fn position_of_assembly(
        &self,
        parameters: &[T],
        inputs: &[T],
        index: usize,
        unknowns: &mut [T],
    ) -> Result<(), SolveError> {
        let found = with::<M, T>(parameters).position(row(inputs), assembly::<M>(index))?;
        unknowns.copy_from_slice(found.as_ref());
        Ok(())
    }
}

impl<M: Mechanism, T: Scalar> NearOver<T> for Of<M> {
    fn position_near(&self, parameters: &[T], inputs: &[T], near: &[T], unknowns: &mut [T]) -> Result<(), SolveError> {
        let found = with::<M, T>(parameters).position_near(row(inputs), row(near))?;
        unknowns.copy_from_slice(found.as_ref());
        Ok(())
    }
}

impl<M: Mechanism, T: Scalar> ClosureOver<T> for Of<M> {
    fn closure(&self, parameters: &[T], inputs: &[T], unknowns: &[T], residuals: &mut [T]) {
        let found = with::<M, T>(parameters).closure(row(inputs), row(unknowns));
        residuals.copy_from_slice(found.as_ref());
    }
}

impl<M: Mechanism, T: Scalar> ClosureTermsOver<T> for Of<M> {
    fn closure_terms(&self, parameters: &[T], found: &mut dyn FnMut(&[ClosureTerm<'_>], &[T])) {
        with::<M, T>(parameters).closure_terms(found);
    }
}

impl<M: Mechanism, T: Scalar> OutputsOver<T> for Of<M> {
    fn outputs(&self, parameters: &[T], inputs: &[T], unknowns: &[T], outputs: &mut [T]) {
        let found = with::<M, T>(parameters).outputs_at(row(inputs), row(unknowns));
        outputs.copy_from_slice(found.as_ref());
    }
}

impl<M: Mechanism, T: Scalar> AssemblyMotionOver<T> for Of<M> {
    fn motion_of_assembly(
        &self,
        parameters: &[T],
        inputs: &[T],
        index: usize,
        unknowns: &mut [T],
        outputs: &mut [T],
    ) -> Result<(), SolveError> {
        let pose = with::<M, T>(parameters).solve(motions(inputs), assembly::<M>(index))?;
        write(pose.unknown_motions().as_ref(), unknowns);
        write(pose.output_motions().as_ref(), outputs);
        Ok(())
    }
}

impl<M: Mechanism, T: Scalar> MotionNearOver<T> for Of<M> {
    fn motion_near(
        &self,
        parameters: &[T],
        inputs: &[T],
        near: &[T],
        unknowns: &mut [T],
        outputs: &mut [T],
    ) -> Result<(), SolveError> {
        let pose = with::<M, T>(parameters).solve_near(motions(inputs), row(near))?;
        write(pose.unknown_motions_near(row(near)).as_ref(), unknowns);
        write(pose.output_motions().as_ref(), outputs);
        Ok(())
    }
}

impl<M: Mechanism, T: Scalar> TransmissionOver<T> for Of<M> {
    fn angles_of_dyads(&self, parameters: &[T], inputs: &[T], unknowns: &[T], angles: &mut [TransmissionAngle<T>]) {
        let found = with::<M, T>(parameters).transmission_angles_at(row(inputs), row(unknowns));
        angles.copy_from_slice(found.as_ref());
    }
}

impl<M: Mechanism, T: Scalar> FormsOver<T> for Of<M> {
    fn block_forms(&self, parameters: &[T], found: &mut dyn FnMut(BlockForm<T>)) {
        let forms = with::<M, T>(parameters).block_forms();
        forms.as_ref().iter().copied().for_each(found);
    }
}

impl<M: Mechanism, T: Scalar> SkeletonOver<T> for Of<M> {
    fn skeleton_points(&self, parameters: &[T], inputs: &[T], unknowns: &[T], found: &mut dyn FnMut(&[T])) {
        let points = with::<M, T>(parameters).skeleton_points(row(inputs), row(unknowns));
        for point in points.as_slice() {
            let point = point.in_space();
            let count = if self.is_space() { 3 } else { 2 };
            found(&[point.x, point.y, point.z][..count]);
        }
    }
}

impl<M: Mechanism> Pictured for Of<M> {
    fn outline(&self) -> Outline<'_> {
        M::OUTLINE
    }

    fn is_space(&self) -> bool {
        !<<M::SkeletonPoints as PointArray>::Point as PlaneOrSpace>::IS_PLANE
    }

    fn formulas(&self) -> Formulas<'_> {
        M::FORMULAS
    }
}

impl<M: Mechanism<Scalar = f64>> EveryPosition for Of<M> {
    fn every_position(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        found: &mut dyn FnMut(&[f64]),
    ) -> Result<PositionSearch, SolveError> {
        let mechanism = M::from_parameters(row(parameters));
        mechanism.positions_at(row(inputs), |_, unknowns| found(unknowns.as_ref()))
    }
}

impl<M: Mechanism> Described for Of<M> {
    fn description(&self) -> &Description<'_> {
        description::<M>()
    }

    fn name(&self, of: NameKind, index: usize) -> Name {
        description::<M>().name_of(of, index).map_or(Name::NONE, Name::from)
    }

    fn input_names(&self) -> InputNames {
        InputNames::Declared(description::<M>().inputs)
    }

    fn assembly_count(&self) -> usize {
        M::ASSEMBLY_COUNT
    }

    #[cfg(feature = "alloc")]
    fn assembly_name(&self, index: usize) -> Option<alloc::string::String> {
        M::assembly(index).map(M::assembly_name)
    }

    #[cfg(feature = "alloc")]
    fn choices(&self) -> Vec<alloc::string::String> {
        match M::ASSEMBLY_COUNT {
            0 | 1 => Vec::new(),
            2 => alloc::vec!["assembly".into()],
            _ => M::assembly(0).map_or_else(Vec::new, |assembly| fields(&alloc::format!("{assembly:?}"))),
        }
    }

    fn dyad_count(&self) -> usize {
        <M::Dyads<f64> as Row<f64>>::LENGTH
    }
}

impl<M: Mechanism> AnyMechanism for Of<M> {
    fn assembly_at(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Option<usize> {
        index_of::<M>(with::<M, f64>(parameters).assembly_at(row(inputs), row(unknowns)))
    }
}
