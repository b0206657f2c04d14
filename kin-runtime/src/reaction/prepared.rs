//! Reactions of many poses, by what is found once.

use alloc::vec;
use alloc::vec::Vec;

use super::equations::Solution;
use super::pose::{PosePlan, PoseReactions, PoseRoom, TERMS};
use super::structure::Plan;
use super::{NamedReactions, ORDERS, ReactionError, ReactionPlace, Solved};
use crate::any::PositionChoice;
use crate::motion::Motion;
use crate::number::series::Series;

/// The reactions of a mechanism, prepared for many poses: [`NamedReactions::prepared`].
///
/// Where loads and drives act, what is unknown, and the order in which the equations are solved, are found in the first
/// pose. Other poses of the assembly take them over, and ask for no memory: without friction, in a mechanism of order 4
/// or more. Where that order would divide by numbers that are too small, all is found anew.
#[derive(Clone)]
pub struct PreparedReactions<'r> {
    reactions: &'r NamedReactions<'r>,
    /// The index of the assembly to which all belongs.
    assembly: Option<usize>,
    plan: Option<Plan>,
    quick: Option<Quick>,
    solution: Solution<ORDERS>,
}

/// A plan with the motion that the solver of rates gives.
#[derive(Clone)]
struct Quick {
    plan: PosePlan,
    room: PoseRoom<f64>,
    /// The numbers of each motion in the slices of the solver.
    stride: usize,
    /// The motions of the inputs, unknowns and outputs, one after the other.
    motions: Vec<f64>,
    /// The first numbers of unknowns and of outputs.
    starts: [usize; 2],
}

impl NamedReactions<'_> {
    /// The same for many poses of an assembly. The first one costs as much as [`at`](Self::at), and others a small part
    /// of that.
    ///
    /// ```
    /// use kin_core::any::PositionChoice;
    /// use kin_core::library::FourBar;
    /// use kin_core::linkage::AnyLinkage;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = AnyLinkage::of(&FourBar { r1: 0.9, r2: 0.3, r3: 0.8, r4: 0.6 });
    /// let loads = linkage.loads().torque(-30.0, "theta4")?;
    /// let reactions = linkage.reactions_as_guessed(&loads)?;
    /// let mut prepared = reactions.prepared();
    /// let mut torques = [0.0; 360];
    /// for (degrees, torque) in (0_u16..).zip(&mut torques) {
    ///     let crank = Motion::at_constant_speed(f64::from(degrees).to_radians(), 12.0);
    ///     let pose = prepared.at(&[crank], PositionChoice::Assembly(0))?;
    ///     [*torque, ..] = pose.effort(0).ok_or("no effort")?;
    /// }
    /// let found = reactions.at(&[Motion::at_constant_speed(1_f64.to_radians(), 12.0)], PositionChoice::Assembly(0))?;
    /// assert!((torques[1] - found.effort(0).ok_or("no effort")?[0]).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn prepared(&self) -> PreparedReactions<'_> {
        PreparedReactions {
            reactions: self,
            assembly: None,
            plan: None,
            quick: None,
            solution: Solution::empty(self.functions.is_space(), self.connections.len(), self.driven.len()),
        }
    }
}

impl PreparedReactions<'_> {
    /// The reactions in the pose at given motions of the inputs, through snap. Values nearby choose poses of the
    /// assembly that they chose first.
    ///
    /// # Errors
    /// As for [`NamedReactions::at`].
    pub fn at(
        &mut self,
        inputs: &[Motion],
        choice: PositionChoice<'_, f64>,
    ) -> Result<PoseReactions<'_>, ReactionError> {
        let assembly = match choice {
            PositionChoice::Assembly(index) => Some(index),
            PositionChoice::Near(_) => None,
        };
        if assembly != self.assembly {
            (self.assembly, self.plan, self.quick) = (assembly, None, None);
        }
        let is_solved = match &mut self.quick {
            Some(quick) => quick.solve(self.reactions, inputs, choice)?,
            None => false,
        };
        if !is_solved {
            self.solve_by_plan(inputs, choice)?;
        }
        let quick = self.quick.as_ref().filter(|_| is_solved);
        Ok(PoseReactions::of(
            quick.map_or(&self.solution, |quick| &quick.room.solution),
            0,
        ))
    }

    /// The reactions in a pose for which nothing is prepared.
    #[cfg(feature = "std")]
    pub(super) fn alone(
        &mut self,
        inputs: &[Motion],
        choice: PositionChoice<'_, f64>,
    ) -> Result<PoseReactions<'_>, ReactionError> {
        let unknowns = self.reactions.unknowns_at(inputs, choice)?;
        let place = self.reactions.place(inputs, &unknowns);
        self.solution = self.reactions.solved_by(&place, None)?.solution.resized();
        Ok(PoseReactions::of(&self.solution, 0))
    }

    /// The same from a longer series.
    fn solve_by_plan(&mut self, inputs: &[Motion], choice: PositionChoice<'_, f64>) -> Result<(), ReactionError> {
        let reactions = self.reactions;
        let unknowns = reactions.unknowns_at(inputs, choice)?;
        let place = reactions.place(inputs, &unknowns);
        let was_planned = self.plan.is_some();
        let Solved { solution, .. } = reactions.solved_by(&place, Some(&mut self.plan))?;
        self.solution = solution.resized();
        if self.plan.is_none() {
            self.quick = None;
        } else if !was_planned || self.quick.is_some() {
            self.quick = Quick::new(reactions, &place)?;
        }
        Ok(())
    }
}

impl Quick {
    /// The plan in a pose; none if it needs more than the solver of rates gives.
    fn new(reactions: &NamedReactions<'_>, place: &ReactionPlace<'_>) -> Result<Option<Self>, ReactionError> {
        let Some(plan) = PosePlan::new(reactions, place, false)? else {
            return Ok(None);
        };
        let description = place.functions.description();
        let stride = description.order + 1;
        let counts = [description.inputs, description.unknowns, description.outputs].map(|own| own.len() * stride);
        Ok(Some(Self {
            room: plan.room(reactions),
            plan,
            stride,
            motions: vec![0.0; counts.iter().sum()],
            starts: [counts[0], counts[0] + counts[1]],
        }))
    }

    /// Solves a pose. False if the plan does not fit.
    fn solve(
        &mut self,
        reactions: &NamedReactions<'_>,
        inputs: &[Motion],
        choice: PositionChoice<'_, f64>,
    ) -> Result<bool, ReactionError> {
        let Self { plan, room, stride, .. } = self;
        let (given, found) = self.motions.split_at_mut(self.starts[0]);
        let (unknowns, outputs) = found.split_at_mut(self.starts[1] - self.starts[0]);
        for (motion, numbers) in inputs.iter().zip(given.chunks_exact_mut(*stride)) {
            numbers[..TERMS].copy_from_slice(motion.as_ref());
        }
        let (parameters, functions) = (&reactions.parameters, reactions.functions);
        match choice {
            PositionChoice::Assembly(index) => {
                functions.motion_of_assembly(parameters, given, index, unknowns, outputs)?;
            }
            PositionChoice::Near(near) => functions.motion_near(parameters, given, near, unknowns, outputs)?,
        }
        for quantity in &plan.needed {
            if let Some(index) = quantity.checked_sub(parameters.len()) {
                let motion = &self.motions[index * *stride..][..TERMS];
                let mut derivatives = [0.0; TERMS];
                derivatives.copy_from_slice(motion);
                room.moved.quantities[*quantity] = Series::from_derivatives(derivatives);
            }
        }
        if plan.is_drawn() {
            let places = &mut room.moved.places;
            plan.draw(reactions, &room.moved.quantities, &mut |index, place| {
                places[index] = place;
            });
        }
        room.solve(plan, reactions, &functions.outline())
    }
}
