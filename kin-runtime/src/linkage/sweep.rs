//! Sweeps of a linkage without its type.

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use super::AnyLinkage;
use crate::any::AssemblyChoice;
use crate::exact::{ExactTable, ExactTableError, Precision, exact_table};
use crate::extremes::{
    ByDyad, ByEffort, ByJacobian, ByName, ByPower, ByReaction, ChangedFunctions, ExtremesError, NamedFunctions, Over,
    QuantityAlong, QuantitySource, reactions_in_rows,
};
use crate::failure::SolveError;
use crate::law::{Piecewise, Side};
use crate::load::NamedLoads;
use crate::mechanism::JacobianMeasure;
use crate::number::{ClosedRange, NumberRow};
use crate::reaction::{Efficiency, ForceProof, NamedReactions, ReactionPart, ReactionQuantity, Reactions};
use crate::sweep::{
    Drive as _, Footing, Laws, READ, SmoothDrive, StraightLine, SweepError, Table, TabledMechanism, UntypedSweep, Walk,
};

/// A linkage in an assembly, of which a sweep is wanted.
#[derive(Clone, Debug)]
#[must_use = "say how the inputs move, as in `between`"]
pub struct AnyAssembled<'m> {
    linkage: AnyLinkage<'m>,
    assembly: AssemblyChoice,
}

/// A sweep of a linkage, whose inputs move.
#[derive(Clone, Debug)]
#[must_use = "read its `rows` or ask for a quantity of it"]
pub struct AnySweep<'m, D> {
    linkage: AnyLinkage<'m>,
    assembly: AssemblyChoice,
    drive: D,
    range: [f64; 2],
    count: usize,
}

impl<'m> AnyLinkage<'m> {
    /// A sweep in an assembly. The next word says how its inputs move.
    pub fn sweep(&self, assembly: AssemblyChoice) -> AnyAssembled<'m> {
        AnyAssembled {
            linkage: self.clone(),
            assembly,
        }
    }
}

impl<'m> AnyAssembled<'m> {
    fn sweep<D>(self, drive: D, range: [f64; 2], count: usize) -> AnySweep<'m, D> {
        AnySweep {
            linkage: self.linkage,
            assembly: self.assembly,
            drive,
            range,
            count,
        }
    }

    /// Over the straight line between two places in the space of the inputs: see
    /// [`between`](crate::sweep::Assembled::between).
    pub fn between(self, from: &[f64], to: &[f64], rows: usize) -> AnySweep<'m, StraightLine> {
        let line = StraightLine::new(from, to);
        let range = line.range();
        self.sweep(line, range, rows)
    }

    /// Over a range of the time, with a law for each input: see [`under_laws`](crate::sweep::Assembled::under_laws).
    pub fn under_laws<'l>(
        self,
        laws: &[&'l dyn Piecewise<f64>],
        range: impl ClosedRange,
        rows: usize,
    ) -> AnySweep<'m, Laws<'l>> {
        let laws = Laws::new(laws, self.linkage.functions.input_names());
        self.sweep(laws, range.ends(), rows)
    }
}

impl AnySweep<'_, StraightLine> {
    /// The speed of the first input that moves, in the direction of the range: see
    /// [`speed`](crate::sweep::Sweep::speed).
    pub fn speed(mut self, speed: f64) -> Self {
        self.drive = self.drive.at_speed(speed);
        self
    }

    /// Proofs about the forces of this motion, over all inputs of the range and not only in rows: see [`ForceProof`].
    pub fn proof<'r>(&self, reactions: &'r NamedReactions<'r>) -> ForceProof<'r> {
        let StraightLine { from, to, .. } = &self.drive;
        ForceProof::new(
            reactions,
            &self.linkage.parameters,
            &self.assembly,
            [from, to],
            self.drive.rate(),
        )
    }
}

impl<D: SmoothDrive> AnySweep<'_, D> {
    /// The number of rows.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// The value of the variable in a row.
    #[must_use]
    pub fn at(&self, row: usize) -> f64 {
        self.untyped().at(row)
    }

    /// Whether the inputs can move so. Every question to the sweep is answered by this error if they cannot.
    ///
    /// # Errors
    /// [`SweepError`] for numbers that are not finite, for the speed zero, and for a law whose value jumps.
    pub fn check(&self) -> Result<(), SweepError> {
        self.untyped().check()
    }

    /// The first place beyond another one where two pieces of a law meet, if there is one; it may lie behind the range.
    #[must_use]
    pub fn next_joint(&self, after: f64) -> Option<f64> {
        self.drive.next_joint(after)
    }

    /// The inputs at a value of the variable, each with its derivatives with respect to the variable, the value first.
    /// Where two pieces of a law meet, `side` selects one.
    #[must_use]
    pub fn inputs(&self, at: f64, side: Side) -> Vec<Vec<f64>> {
        let mut derivatives = vec![0.0; self.linkage.description().inputs.len() * READ];
        self.drive.derivatives(at, side, &mut derivatives);
        derivatives.chunks_exact(READ).map(<[f64]>::to_vec).collect()
    }

    /// The poses of all rows, each with the value of the variable: see [`rows`](crate::sweep::Sweep::rows).
    #[must_use]
    pub fn rows(&self) -> Vec<(f64, Result<AnyPose, SolveError>)> {
        let sweep = self.untyped();
        let mut walk = Walk::BEGINNING;
        let row = |row: usize| {
            let at = sweep.at(row);
            let reached = walk.step(&sweep, at, &sweep.motions(at));
            (at, reached.map(AnyPose::new))
        };
        (0..self.count).map(row).collect()
    }

    /// The poses as a table: see [`table`](crate::sweep::Sweep::table). The functions are those of the mechanism.
    ///
    /// # Errors
    /// As there.
    pub fn table(&self, functions: &dyn TabledMechanism) -> Result<Table, SweepError> {
        self.untyped().table(functions, &mut |_| {})
    }

    /// The motion as an exact table: see [`exact_table`](crate::sweep::Sweep::exact_table).
    ///
    /// # Errors
    /// As there.
    pub fn exact_table(&self, precision: impl Into<Precision>) -> Result<ExactTable, ExactTableError> {
        exact_table(self.untyped(), &self.drive, precision.into())
    }

    /// A quantity by the name of its column, to ask for its peak, its extremes or its mean: see
    /// [`of`](crate::sweep::Sweep::of).
    pub fn of<'q>(&self, name: &'q str) -> QuantityAlong<'_, Self, ByName<'q>> {
        QuantityAlong::by_name(self, name)
    }

    /// The transmission angle of a dyad, by its index in the order in which the dyads are solved, or its supplement if
    /// this is smaller.
    pub fn of_transmission_angle(&self, dyad: usize) -> QuantityAlong<'_, Self, ByDyad> {
        QuantityAlong::new(self, ByDyad(dyad))
    }

    /// The effort of the drive of an input under loads, by the index of the input: order 0 is the torque or force, 1
    /// and 2 are its rates by time. See [`NamedLoads`].
    pub fn of_effort<'q>(
        &self,
        loads: &'q NamedLoads,
        input: usize,
        order: usize,
    ) -> QuantityAlong<'_, Self, ByEffort<'q>> {
        QuantityAlong::by_effort(self, loads, input, order)
    }

    /// The power of the drive of an input under loads, by the index of the input: its effort times its velocity.
    pub fn of_power<'q>(&self, loads: &'q NamedLoads, input: usize) -> QuantityAlong<'_, Self, ByPower<'q>> {
        QuantityAlong::by_power(self, loads, input)
    }

    /// A part of the force in a joint, by the name of the joint: order 0 is the force or moment, 1 and 2 are its rates
    /// by time. See [`NamedReactions`].
    pub fn of_reaction<'q>(
        &self,
        reactions: &'q NamedReactions<'q>,
        name: &str,
        part: ReactionPart,
        order: usize,
    ) -> QuantityAlong<'_, Self, ByReaction<'q>> {
        let index = reactions.index(name);
        let quantity = index.map(|index| ReactionQuantity::Part(index, part));
        QuantityAlong::by_reaction(self, reactions, quantity, order)
    }

    /// The effort of the drive of an input with the friction of joints, in the same orders. Without friction it is that
    /// of [`of_effort`](Self::of_effort).
    pub fn of_effort_with_friction<'q>(
        &self,
        reactions: &'q NamedReactions<'q>,
        input: usize,
        order: usize,
    ) -> QuantityAlong<'_, Self, ByReaction<'q>> {
        QuantityAlong::by_reaction(self, reactions, reactions.effort_of(input), order)
    }

    /// The power of the drive of an input with the friction of joints.
    pub fn of_power_with_friction<'q>(
        &self,
        reactions: &'q NamedReactions<'q>,
        input: usize,
    ) -> QuantityAlong<'_, Self, ByReaction<'q>> {
        let power = reactions.effort_of(input).map(|_| ReactionQuantity::Power(input));
        QuantityAlong::by_reaction(self, reactions, power, 0)
    }

    /// The power that friction turns into heat, in the same orders.
    pub fn of_heat<'q>(
        &self,
        reactions: &'q NamedReactions<'q>,
        order: usize,
    ) -> QuantityAlong<'_, Self, ByReaction<'q>> {
        QuantityAlong::by_reaction(self, reactions, Ok(ReactionQuantity::Heat), order)
    }

    /// The mean power of all drives, and what friction takes of it. Over a cycle the rest goes to the loads.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::any::AssemblyChoice;
    /// use kin_core::linkage::AnyLinkage;
    /// use kin_core::prelude::*;
    /// use kin_core::reaction::Friction;
    ///
    /// mechanism! {
    ///     /// A pendulum in metres.
    ///     struct Pendulum { length: Length }
    ///     input theta: Angle;
    ///     unknown x: Length;
    ///     x == length * cos(theta);
    ///     output bob: Point = polar(length, theta);
    ///     ground 0;
    ///     body arm: 0, bob;
    /// }
    ///
    /// let linkage = AnyLinkage::of(&Pendulum { length: 0.4 });
    /// let loads = linkage.loads().gravity(Plane::new(0.0, -9.81)).mass(2.0, "bob")?;
    /// let friction = Friction::Pin { coefficient: 0.1, radius: 0.01 };
    /// let reactions = linkage.reactions(&loads)?.friction("ground_arm", friction)?;
    /// let turn = linkage.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[TAU], 361).speed(0.01);
    /// let mean = turn.efficiency(&reactions)?;
    /// // the weight turns with the arm, and all work is heat: μ r m g ω
    /// assert!((mean.heat - 0.1 * 0.01 * 2.0 * 9.81 * 0.01).abs() < 1e-8);
    /// assert!(mean.ratio().is_some_and(|ratio| ratio.abs() < 1e-9));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As for [`mean`](QuantityAlong::mean).
    pub fn efficiency(&self, reactions: &NamedReactions<'_>) -> Result<Efficiency, ExtremesError> {
        let mean = |quantity| {
            let power = QuantityAlong::by_reaction(self, reactions, Ok(quantity), 0);
            Ok::<_, ExtremesError>(power.mean(Over::Time)?.value)
        };
        Ok(Efficiency {
            input: mean(ReactionQuantity::Input)?,
            heat: mean(ReactionQuantity::Heat)?,
        })
    }

    /// The forces in all joints in each row, found by one solution for each. At a joint of laws they are those behind
    /// it.
    ///
    /// # Errors
    /// [`ExtremesError::Sweep`] if the inputs cannot move so. A row in which the mechanism does not close has the error
    /// [`ExtremesError::Gap`], and one in which the joints do not hold the bodies has [`ExtremesError::Reaction`].
    pub fn reactions(
        &self,
        reactions: &NamedReactions<'_>,
    ) -> Result<Vec<Result<Reactions, ExtremesError>>, ExtremesError> {
        reactions_in_rows(self, reactions)
    }

    /// A measure of the Jacobian of results, by their names: see [`of_jacobian`](crate::sweep::Sweep::of_jacobian).
    pub fn of_jacobian(&self, results: &[&str], measure: JacobianMeasure) -> QuantityAlong<'_, Self, ByJacobian> {
        QuantityAlong::by_jacobian(self, results, measure)
    }
}

impl<D: SmoothDrive> QuantitySource for AnySweep<'_, D> {
    fn untyped(&self) -> UntypedSweep<'_> {
        let [from, to] = self.range;
        UntypedSweep {
            mechanism: self.linkage.functions,
            description: self.linkage.description(),
            parameters: self.linkage.parameters.clone(),
            assembly: self.assembly.clone(),
            drive: &self.drive,
            from,
            to,
            count: self.count,
        }
    }

    fn drive(&self) -> &dyn SmoothDrive {
        &self.drive
    }

    fn named(&self) -> &dyn NamedFunctions {
        self.linkage.functions
    }

    fn changed(&self) -> &dyn ChangedFunctions {
        self.linkage.functions
    }
}

/// A pose of a sweep, with unwrapped angles.
#[derive(Clone)]
pub struct AnyPose {
    inputs: NumberRow,
    unknowns: NumberRow,
    /// The motions of unknowns and outputs.
    results: Vec<f64>,
    orders: usize,
}

impl fmt::Debug for AnyPose {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.results()).finish()
    }
}

impl AnyPose {
    fn new(footing: &Footing<'_>) -> Self {
        Self {
            inputs: footing.inputs(),
            unknowns: footing.unknowns(),
            results: footing.results().flatten().copied().collect(),
            orders: footing.motion(0).len(),
        }
    }

    /// The values of the inputs.
    #[must_use]
    pub fn inputs(&self) -> &[f64] {
        &self.inputs
    }

    /// The values of the unknowns.
    #[must_use]
    pub fn unknowns(&self) -> &[f64] {
        &self.unknowns
    }

    /// The motions of unknowns and outputs, one after the other, each with all its orders.
    pub fn results(&self) -> impl Iterator<Item = &[f64]> {
        self.results.chunks_exact(self.orders)
    }
}
