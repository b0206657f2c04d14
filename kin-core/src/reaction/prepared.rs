//! Reactions of many poses, by what is found once.

use alloc::vec;
use alloc::vec::Vec;

use super::action::Influence;
use super::equations::{Equations, Solution};
use super::frames::{MovedFrame, MovedMechanism, real};
use super::ordered::OrderedSystem;
use super::structure::{Plan, Structure};
use super::{NamedReactions, ORDERS, REACH, ReactionError, ReactionPlace, Solved, orders, size};
use crate::any::PositionChoice;
use crate::geometry::Space;
use crate::load::PointIndex;
use crate::motion::Motion;
use crate::number::Number;
use crate::number::series::Series;
use crate::picture::Outline;

/// The terms of a motion through snap.
const TERMS: usize = 5;

type PoseNumber = Series<TERMS>;

/// A force has two derivatives less than a motion.
type ForceNumber = Series<ORDERS>;

/// The reactions of a mechanism, prepared for many poses: [`NamedReactions::prepared`].
///
/// Where loads and drives act, what is unknown, and the order in which the equations are solved, are found in the first
/// pose. Other poses of the assembly take them over, and ask for no memory: without friction and gears, in a mechanism
/// of order 4 or more whose joints have names or stand still. Where that order would divide by numbers that are too
/// small, all is found anew.
#[derive(Clone)]
pub struct PreparedReactions<'r> {
    reactions: &'r NamedReactions<'r>,
    /// The index of the assembly to which all belongs.
    assembly: Option<usize>,
    plan: Option<Plan>,
    quick: Option<Quick>,
    solution: Solution<ORDERS>,
}

/// A plan for poses whose motion the solver of rates gives: without friction and contacts, and where the outputs tell
/// the motion of all joints.
#[derive(Clone)]
struct Quick {
    structure: Structure,
    system: OrderedSystem<ORDERS>,
    /// The joints and the directions of slides among the quantities, or where they stand.
    places: Vec<PointIndex>,
    /// The numbers of each motion in the slices of the solver.
    stride: usize,
    inputs: Vec<f64>,
    unknowns: Vec<f64>,
    outputs: Vec<f64>,
    moved: MovedMechanism<PoseNumber>,
    frames: Vec<MovedFrame<PoseNumber>>,
    right: Vec<ForceNumber>,
}

/// The reactions in one pose, each by its index among the [names](NamedReactions::names).
#[derive(Clone, Copy)]
pub struct PoseReactions<'p> {
    solution: &'p Solution<ORDERS>,
}

impl PoseReactions<'_> {
    /// A force along x, y and z, each with two rates by time; none if equilibrium alone does not determine it, or
    /// without such a reaction.
    #[must_use]
    pub fn force(&self, index: usize) -> Option<[[f64; ORDERS]; 3]> {
        let Space { x, y, z } = self.solution.forces.get(index)?.whole()?;
        Some([x, y, z].map(orders))
    }

    /// The size of a force, with two rates.
    #[must_use]
    pub fn magnitude(&self, index: usize) -> Option<[f64; ORDERS]> {
        let force = self.solution.forces.get(index)?.whole()?;
        Some(orders(size(force)))
    }

    /// A moment about x, y and z: that of a slide or a hinge, or of friction in a pin.
    #[must_use]
    pub fn moment(&self, index: usize) -> Option<[[f64; ORDERS]; 3]> {
        let Space { x, y, z } = self.solution.moments.get(index)?.whole()?;
        Some([x, y, z].map(orders))
    }

    /// The effort of the drive of an input, with two rates.
    #[must_use]
    pub fn effort(&self, input: usize) -> Option<[f64; ORDERS]> {
        self.solution.efforts.get(input).copied().flatten().map(orders)
    }
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
            Some(quick) => quick.solve(self.reactions, inputs, choice, &mut self.solution)?,
            None => false,
        };
        if !is_solved {
            self.solve_by_plan(inputs, choice)?;
        }
        Ok(PoseReactions {
            solution: &self.solution,
        })
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
        let functions = place.functions;
        let description = functions.description();
        let has_contacts = reactions.connections.iter().any(|own| own.mesh.is_some());
        if reactions.has_friction() || has_contacts || description.order + 1 < TERMS {
            return Ok(None);
        }
        let outline = functions.outline();
        let (moved, frames) = place.moving(&outline, &reactions.connections)?;
        let (structure, all) = reactions.structure(place, &outline, &moved, &frames)?;
        let Some(places) = places(reactions, &outline, &all) else {
            return Ok(None);
        };
        let equations = structure.equations(reactions, &outline, &moved, &frames);
        let columns = equations.columns(&structure.unknowns);
        let shorter = |column: &Vec<Series<REACH>>| column.iter().map(Series::resized).collect();
        let columns: Vec<Vec<ForceNumber>> = columns.iter().map(shorter).collect();
        let Some(system) = structure.order(reactions, &outline, &columns, &all) else {
            return Ok(None);
        };
        let stride = description.order + 1;
        let mut quantities = vec![Series::ZERO; moved.quantities.len()];
        for (quantity, parameter) in quantities.iter_mut().zip(place.parameters) {
            *quantity = Series::constant(*parameter);
        }
        Ok(Some(Self {
            right: vec![Series::ZERO; structure.rows.count()],
            frames: Vec::with_capacity(frames.len()),
            moved: MovedMechanism {
                quantities,
                places: vec![Space::zero(); places.len()],
                joints: moved.joints,
                is_space: moved.is_space,
            },
            inputs: vec![0.0; stride * description.inputs.len()],
            unknowns: vec![0.0; stride * description.unknowns.len()],
            outputs: vec![0.0; stride * description.outputs.len()],
            structure,
            system,
            places,
            stride,
        }))
    }

    /// Solves a pose. False if the plan does not fit.
    fn solve(
        &mut self,
        reactions: &NamedReactions<'_>,
        inputs: &[Motion],
        choice: PositionChoice<'_, f64>,
        solution: &mut Solution<ORDERS>,
    ) -> Result<bool, ReactionError> {
        self.move_to(reactions, inputs, choice)?;
        let outline = reactions.functions.outline();
        let Self {
            structure,
            system,
            moved,
            frames,
            right,
            ..
        } = self;
        moved.frames_into(&outline, &reactions.connections, frames)?;
        if !structure.rows.fit(moved, frames) || moved.check(&outline, &reactions.connections, frames).is_err() {
            return Ok(false);
        }
        let equations: Equations<'_, PoseNumber> = structure.equations(reactions, &outline, moved, frames);
        right.fill(Series::ZERO);
        let demand = structure.demand(reactions, moved, frames, 1.0);
        demand.each(&mut |_, body, wrench| {
            equations.entries_of(body, wrench, &mut |row, part| right[row] = right[row] - part.resized());
        })?;
        if !equations.fill(system, &structure.unknowns) {
            return Ok(false);
        }
        let values = system.solve(right);
        if !values.iter().all(|value| value.is_finite()) {
            return Err(ReactionError::NotFinite);
        }
        equations.write(&structure.unknowns, values, |_| false, solution);
        Ok(true)
    }

    /// Moves the mechanism to a pose.
    fn move_to(
        &mut self,
        reactions: &NamedReactions<'_>,
        inputs: &[Motion],
        choice: PositionChoice<'_, f64>,
    ) -> Result<(), ReactionError> {
        let stride = self.stride;
        for (motion, numbers) in inputs.iter().zip(self.inputs.chunks_exact_mut(stride)) {
            numbers[..TERMS].copy_from_slice(motion.as_ref());
        }
        let (parameters, functions) = (&reactions.parameters, reactions.functions);
        let (unknowns, outputs) = (&mut self.unknowns[..], &mut self.outputs[..]);
        match choice {
            PositionChoice::Assembly(index) => {
                functions.motion_of_assembly(parameters, &self.inputs, index, unknowns, outputs)?;
            }
            PositionChoice::Near(near) => functions.motion_near(parameters, &self.inputs, near, unknowns, outputs)?,
        }
        let motions = [&self.inputs, &self.unknowns, &self.outputs].into_iter();
        let motions = motions.flat_map(|motions| motions.chunks_exact(stride));
        for (quantity, motion) in self.moved.quantities[parameters.len()..].iter_mut().zip(motions) {
            *quantity = Series::from_derivatives(core::array::from_fn(|order| motion[order]));
        }
        for (index, place) in self.places.iter().enumerate() {
            self.moved.places[index] = self.moved.point(*place);
        }
        Ok(())
    }
}

/// Where all joints and the directions of all slides are among the quantities; none if they are not all there.
fn places(reactions: &NamedReactions<'_>, outline: &Outline<'_>, all: &[Influence<REACH>]) -> Option<Vec<PointIndex>> {
    let first = all.first()?;
    let place = |index: usize| {
        let stands = |one: &Influence<REACH>| {
            let Space { x, y, z } = one.moved.places[index];
            let mut terms = [x, y, z]
                .into_iter()
                .flat_map(|part| part.coefficients().into_iter().skip(1));
            terms.all(|term| term == 0.0)
        };
        if all.iter().all(stands) {
            return Some(PointIndex::Fixed(real(first.moved.places[index])));
        }
        let (name, _) = outline.points.iter().find(|(_, joint)| *joint == index)?;
        let place = reactions.loads.place((*name).into()).ok()?;
        (index < first.moved.joints).then_some(place)
    };
    (0..first.moved.places.len()).map(place).collect()
}
