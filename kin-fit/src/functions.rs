//! The functions of a mechanism on which a fit depends.

use std::f64::consts::TAU;

use kin_core::any::{FormsOver, Of, OutputsOver, PositionChoice, PositionOver, SkeletonOver, TransmissionOver};
use kin_core::extremes::{At, ExtremesError, Peak};
use kin_core::linkage::{AnyLinkage, LinkageFunctions};
use kin_core::sweep::{Local, Swept as _};
use kin_core::{BlockForm, Changing, Mechanism, Number, Row, TransmissionAngle};

use crate::quantity::QuantityIndex;

/// A number and its derivative with respect to one of the numbers that are sought.
pub type Change = Changing<f64>;

/// The functions of a mechanism from which it is fitted: `Of::<M>::FUNCTIONS` has them for every declared mechanism.
/// `kin_live::Mechanism` has them, too, with the feature `live`.
pub trait FitFunctions:
    LinkageFunctions
    + PositionOver<Change>
    + OutputsOver<Change>
    + FormsOver<Change>
    + TransmissionOver<Change>
    + SkeletonOver<Change>
{
    /// The largest length of a derivative of a point, over a line of inputs on which the moving one has the speed 1.
    /// Only a mechanism that rustc has compiled has this figure.
    ///
    /// # Errors
    /// Those of [`QuantityAlong::highest`](kin_core::extremes::QuantityAlong::highest).
    #[doc(hidden)]
    fn peak_of_point(&self, way: &PointWay<'_>) -> Option<Result<Peak, ExtremesError>> {
        let _ = way;
        None
    }
}

#[cfg(feature = "live")]
impl FitFunctions for kin_live::Mechanism {}

/// A derivative of a point along a line of inputs.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct PointWay<'w> {
    pub(crate) parameters: &'w [f64],
    pub(crate) assembly: usize,
    pub(crate) ends: [&'w [f64]; 2],
    pub(crate) rows: usize,
    pub(crate) speed: f64,
    pub(crate) quantities: [QuantityIndex; 2],
    pub(crate) order: usize,
}

fn row<T: Copy, R: Row<T>>(values: &[T]) -> R {
    R::from_fn(|index| values[index])
}

impl<M: Mechanism<Scalar = f64>> FitFunctions for Of<M> {
    fn peak_of_point(&self, way: &PointWay<'_>) -> Option<Result<Peak, ExtremesError>> {
        let mechanism = M::from_parameters(row(way.parameters));
        let assembly = M::assembly(way.assembly)?;
        let [from, to] = way.ends.map(row);
        let sweep = mechanism.sweep(assembly).between(from, to, way.rows).speed(way.speed);
        // The square of the length has derivatives where the point stands still.
        let square = |at: &At<M>| {
            let [x, y] = way.quantities.map(|quantity| {
                let value = match quantity {
                    QuantityIndex::Unknown(index) => at.unknown(index, way.order),
                    QuantityIndex::Output(index) => at.output(index, way.order),
                };
                value.unwrap_or(Local::constant(f64::NAN))
            });
            x * x + y * y
        };
        let highest = sweep.of_expression(square).highest();
        Some(highest.map(|highest| Peak {
            value: highest.value.sqrt(),
            ..highest
        }))
    }
}

/// The choice among the positions of a mechanism, for all dimensions.
#[derive(Clone, Debug, PartialEq)]
pub enum Choice {
    /// The position of an assembly, by its index.
    Assembly(usize),
    /// The position to which the mechanism moves from a known position, as its inputs go along a straight line.
    From {
        /// The inputs of the known position.
        inputs: Vec<f64>,
        /// Values near its unknowns.
        near: Vec<f64>,
    },
}

impl Choice {
    /// The choice of a typed assembly. `inputs` are those at which a coupled mechanism is known; assemblies with closed
    /// forms need none.
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
pub(crate) struct Solved {
    pub(crate) inputs: Vec<Change>,
    pub(crate) unknowns: Vec<Change>,
}

/// A mechanism with its dimensions and its choice of a position.
pub(crate) struct Posed<'p> {
    pub(crate) functions: &'static dyn FitFunctions,
    /// The parameters, and behind them the other numbers of a design.
    pub(crate) values: Vec<Change>,
    pub(crate) choice: &'p Choice,
}

impl Posed<'_> {
    pub(crate) fn parameters(&self) -> &[Change] {
        &self.values[..self.functions.description().parameters.len()]
    }

    /// The position at these inputs, or `None` where the mechanism does not close.
    pub(crate) fn solve(&self, inputs: Vec<Change>) -> Option<Solved> {
        let functions: &dyn PositionOver<Change> = self.functions;
        let mut unknowns = vec![Change::constant(0.0); self.functions.description().unknowns.len()];
        let mut position = |choice| {
            functions
                .position(self.parameters(), &inputs, choice, &mut unknowns)
                .ok()
        };
        match self.choice {
            Choice::Assembly(index) => position(PositionChoice::Assembly(*index))?,
            Choice::From { inputs: known, near } => {
                let real = |values: &[Change]| values.iter().map(|value| value.value).collect::<Vec<f64>>();
                let linkage = AnyLinkage::new(self.functions, &real(self.parameters()));
                let start = linkage.position(known, PositionChoice::Near(near)).ok()?;
                let there = linkage.track(known, &start, &real(&inputs)).ok()?;
                let near: Vec<Change> = there.into_iter().map(Change::constant).collect();
                position(PositionChoice::Near(&near))?;
            }
        }
        Some(Solved { inputs, unknowns })
    }

    pub(crate) fn outputs(&self, at: &Solved) -> Vec<Change> {
        let functions: &dyn OutputsOver<Change> = self.functions;
        let mut outputs = vec![Change::constant(0.0); self.functions.description().outputs.len()];
        functions.outputs(self.parameters(), &at.inputs, &at.unknowns, &mut outputs);
        outputs
    }

    /// The smallest transmission angle, folded to at most a right angle.
    pub(crate) fn transmission(&self, at: &Solved) -> Option<Change> {
        let functions: &dyn TransmissionOver<Change> = self.functions;
        let one = TransmissionAngle::of("", Change::constant(0.0), Change::constant(1.0));
        let mut angles = vec![one; self.functions.dyad_count()];
        functions.angles_of_dyads(self.parameters(), &at.inputs, &at.unknowns, &mut angles);
        let folded = angles.iter().map(TransmissionAngle::folded);
        folded.min_by(|one, other| one.value.total_cmp(&other.value))
    }

    pub(crate) fn joints(&self, at: &Solved, found: &mut dyn FnMut([Change; 2])) {
        let functions: &dyn SkeletonOver<Change> = self.functions;
        functions.skeleton_points(self.parameters(), &at.inputs, &at.unknowns, &mut |point| {
            if let [x, y, ..] = point {
                found([*x, *y]);
            }
        });
    }

    pub(crate) fn forms(&self) -> Vec<BlockForm<Change>> {
        let functions: &dyn FormsOver<Change> = self.functions;
        let mut forms = Vec::new();
        functions.block_forms(self.parameters(), &mut |form| forms.push(form));
        forms
    }
}

/// The angle within -π ..= π that differs by whole revolutions, with the same derivative.
pub(crate) fn unturned(angle: Change) -> Change {
    angle - Change::constant(TAU * (angle.value / TAU).round())
}
