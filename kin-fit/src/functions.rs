//! What a mechanism must be able to do so that it can be fitted.

use std::f64::consts::TAU;

use kin_core::any::{AssemblyOver, FormsOver, NearOver, Of, OutputsOver, PositionChoice, TransmissionOver};
use kin_core::extremes::{At, ExtremesError, Peak};
use kin_core::linkage::{AnyLinkage, LinkageFunctions};
use kin_core::sweep::{Local, Sweep as _};
use kin_core::{
    BlockForm, Changing, Mechanism, Number, PlaneOrSpace as _, PointArray as _, Row, Scalar, TransmissionAngle,
};

use crate::quantity::Place;

/// A number and its derivative with respect to one of the numbers that are sought.
pub type Change = Changing<f64>;

/// Joints of the skeleton in numbers of one type.
pub trait JointsOver<T> {
    /// Passes on x and y of every joint of the skeleton, in the mechanism's own frame.
    fn joints(&self, parameters: &[T], inputs: &[T], unknowns: &[T], found: &mut dyn FnMut([T; 2]));
}

/// The functions of a mechanism in numbers of one type.
pub trait FitOver<T>:
    AssemblyOver<T> + NearOver<T> + OutputsOver<T> + FormsOver<T> + TransmissionOver<T> + JointsOver<T>
{
}

impl<T, F> FitOver<T> for F where
    F: AssemblyOver<T> + NearOver<T> + OutputsOver<T> + FormsOver<T> + TransmissionOver<T> + JointsOver<T>
{
}

/// The functions of a mechanism from which it is fitted: `Of::<M>::FUNCTIONS` has them for every declared mechanism.
pub trait FitFunctions: LinkageFunctions + FitOver<f64> + FitOver<Change> {
    /// The largest length of a derivative of a point, over a line of inputs on which the moving one has the speed 1.
    ///
    /// # Errors
    /// Those of [`QuantityAlong::highest`](kin_core::extremes::QuantityAlong::highest).
    #[doc(hidden)]
    fn peak_of_point(&self, way: &PointWay<'_>) -> Result<Peak, ExtremesError>;
}

/// A derivative of a point along a line of inputs.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct PointWay<'w> {
    pub(crate) parameters: &'w [f64],
    pub(crate) assembly: usize,
    pub(crate) ends: [&'w [f64]; 2],
    pub(crate) rows: usize,
    pub(crate) speed: f64,
    pub(crate) place: [Place; 2],
    pub(crate) order: usize,
}

fn row<T: Copy, R: Row<T>>(values: &[T]) -> R {
    R::from_fn(|index| values[index])
}

impl<M: Mechanism, T: Scalar> JointsOver<T> for Of<M> {
    fn joints(&self, parameters: &[T], inputs: &[T], unknowns: &[T], found: &mut dyn FnMut([T; 2])) {
        let own: M::With<T> = M::With::from_parameters(row(parameters));
        for joint in own.places(row(inputs), row(unknowns)).as_slice() {
            let joint = joint.in_space();
            found([joint.x, joint.y]);
        }
    }
}

impl<M: Mechanism<Scalar = f64>> FitFunctions for Of<M> {
    fn peak_of_point(&self, way: &PointWay<'_>) -> Result<Peak, ExtremesError> {
        let own = M::from_parameters(row(way.parameters));
        let assembly = M::assembly(way.assembly).ok_or(ExtremesError::Gap { at: f64::NAN })?;
        let [from, to] = way.ends.map(row);
        let sweep = own.sweep(assembly).between(from, to, way.rows).speed(way.speed);
        // The square of the length has derivatives where the point stands still.
        let square = |at: &At<M>| {
            let [x, y] = way.place.map(|place| {
                let value = match place {
                    Place::Unknown(index) => at.unknown(index, way.order),
                    Place::Output(index) => at.output(index, way.order),
                };
                value.unwrap_or(Local::constant(f64::NAN))
            });
            x * x + y * y
        };
        let highest = sweep.of_expression(square).highest()?;
        Ok(Peak {
            value: highest.value.sqrt(),
            ..highest
        })
    }
}

/// Which of several positions of a mechanism is meant, for all dimensions.
#[derive(Clone, Debug, PartialEq)]
pub enum Choice {
    /// The one of an assembly, by its index.
    Assembly(usize),
    /// The one to which the mechanism moves from a known position, as its inputs go along a straight line.
    From {
        /// The inputs of the known position.
        inputs: Vec<f64>,
        /// Values near its unknowns.
        near: Vec<f64>,
    },
}

impl Choice {
    /// The choice of a typed assembly. `inputs` are those at which a coupled mechanism is known; assemblies with closed forms need none.
    #[must_use]
    pub fn of<M: Mechanism>(assembly: M::Assembly, inputs: &[f64]) -> Self {
        match kin_core::any::AssemblyChoice::of::<M>(assembly) {
            kin_core::any::AssemblyChoice::Index(index) => Self::Assembly(index),
            kin_core::any::AssemblyChoice::Near(near) => Self::From {
                inputs: inputs.to_vec(),
                near,
            },
        }
    }

    /// The index of the assembly, if it holds for all dimensions.
    #[must_use]
    pub fn index(&self) -> Option<usize> {
        match self {
            Self::Assembly(index) => Some(*index),
            Self::From { .. } => None,
        }
    }
}

/// A position.
#[derive(Clone, Debug)]
pub(crate) struct Solved<T> {
    pub(crate) inputs: Vec<T>,
    pub(crate) unknowns: Vec<T>,
}

/// A mechanism with its dimensions and its choice of a position, in numbers of one type.
#[derive(Clone, Copy)]
pub(crate) struct Posed<'p, T: 'static> {
    pub(crate) functions: &'static dyn FitFunctions,
    pub(crate) over: &'static dyn FitOver<T>,
    pub(crate) parameters: &'p [T],
    pub(crate) choice: &'p Choice,
}

impl<T: Scalar> Posed<'_, T> {
    /// The position at these inputs, or `None` where the mechanism does not close.
    pub(crate) fn solve(&self, inputs: Vec<T>) -> Option<Solved<T>> {
        let mut unknowns = vec![T::constant(0.0); self.functions.description().unknowns.len()];
        match self.choice {
            Choice::Assembly(index) => {
                self.over
                    .position_of_assembly(self.parameters, &inputs, *index, &mut unknowns)
                    .ok()?;
            }
            Choice::From { inputs: known, near } => {
                let real = |values: &[T]| values.iter().map(|value| value.real()).collect::<Vec<f64>>();
                let linkage = AnyLinkage::new(self.functions, &real(self.parameters));
                let start = linkage.position(known, PositionChoice::Near(near)).ok()?;
                let to = real(&inputs);
                let there = linkage.track(known, &start, &to).ok()?;
                let near: Vec<T> = there.into_iter().map(T::constant).collect();
                self.over
                    .position_near(self.parameters, &inputs, &near, &mut unknowns)
                    .ok()?;
            }
        }
        Some(Solved { inputs, unknowns })
    }

    pub(crate) fn outputs(&self, at: &Solved<T>) -> Vec<T> {
        let mut outputs = vec![T::constant(0.0); self.functions.description().outputs.len()];
        self.over
            .outputs(self.parameters, &at.inputs, &at.unknowns, &mut outputs);
        outputs
    }

    /// The smallest transmission angle, folded to at most a right angle.
    pub(crate) fn transmission(&self, at: &Solved<T>) -> Option<T> {
        let mut angles =
            vec![TransmissionAngle::of("", T::constant(0.0), T::constant(1.0)); self.functions.dyad_count()];
        self.over
            .angles_of_dyads(self.parameters, &at.inputs, &at.unknowns, &mut angles);
        let folded = angles.iter().map(TransmissionAngle::folded);
        folded.min_by(|one, other| one.real().total_cmp(&other.real()))
    }

    pub(crate) fn joints(&self, at: &Solved<T>, found: &mut dyn FnMut([T; 2])) {
        self.over.joints(self.parameters, &at.inputs, &at.unknowns, found);
    }

    pub(crate) fn forms(&self) -> Vec<BlockForm<T>> {
        let mut forms = Vec::new();
        self.over.block_forms(self.parameters, &mut |form| forms.push(form));
        forms
    }
}

/// An angle within half a turn of zero, with the same derivative.
pub(crate) fn unturned<T: Number>(angle: T) -> T {
    angle - T::constant(TAU * (angle.real() / TAU).round())
}
