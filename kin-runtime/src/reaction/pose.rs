//! The forces of a pose by what is found once, in one number or in several at once.

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use super::action::Influence;
use super::demand::PARTS;
use super::equations::{Arm, Equations, Solution, TakenAway, Unknown};
use super::frames::{JointAxis, MovedFrame, MovedMechanism, shortened, still, unit};
use super::ordered::OrderedSystem;
use super::pose_number::PoseNumber;
use super::rolling::{Flank, Mesh};
use super::structure::Structure;
use super::{MovedNumber, MovingPose, NamedReactions, ORDERS, REACH, ReactionError, ReactionPlace, orders, size};
use crate::any::SkeletonOver;
use crate::geometry::Space;
use crate::load::{NamedLoad, PointIndex};
use crate::number::Number;
use crate::number::series::{Series, SeriesOf};
use crate::picture::Outline;

/// The terms of a motion through snap.
pub(super) const TERMS: usize = 5;

/// A force has two derivatives less than a motion.
type ForceNumber<S> = SeriesOf<S, ORDERS>;

/// The reactions in one pose, each by its index among the [names](NamedReactions::names).
#[derive(Clone, Copy)]
pub struct PoseReactions<'p> {
    solution: &'p dyn PoseSolution,
    pose: usize,
}

impl fmt::Debug for PoseReactions<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let forces = (0..).map_while(|index| self.force(index));
        formatter.debug_list().entries(forces).finish()
    }
}

/// A solution of one pose, or of several.
pub(super) trait PoseSolution: Send + Sync {
    fn force(&self, index: usize, pose: usize) -> Option<Space<Series<ORDERS>>>;
    fn moment(&self, index: usize, pose: usize) -> Option<Space<Series<ORDERS>>>;
    fn effort(&self, input: usize, pose: usize) -> Option<Series<ORDERS>>;
}

impl PoseSolution for Solution<ORDERS> {
    fn force(&self, index: usize, _: usize) -> Option<Space<Series<ORDERS>>> {
        self.forces.get(index)?.whole()
    }

    fn moment(&self, index: usize, _: usize) -> Option<Space<Series<ORDERS>>> {
        self.moments.get(index)?.whole()
    }

    fn effort(&self, input: usize, _: usize) -> Option<Series<ORDERS>> {
        self.efforts.get(input).copied().flatten()
    }
}

impl<'p> PoseReactions<'p> {
    /// Those of one of the poses of a solution.
    pub(super) fn of(solution: &'p dyn PoseSolution, pose: usize) -> Self {
        Self { solution, pose }
    }

    /// A force along x, y and z, each with two rates by time; none if equilibrium alone does not determine it, or
    /// without such a reaction.
    #[must_use]
    pub fn force(&self, index: usize) -> Option<[[f64; ORDERS]; 3]> {
        let Space { x, y, z } = self.solution.force(index, self.pose)?;
        Some([x, y, z].map(orders))
    }

    /// The size of a force, with two rates.
    #[must_use]
    pub fn magnitude(&self, index: usize) -> Option<[f64; ORDERS]> {
        Some(orders(size(self.solution.force(index, self.pose)?)))
    }

    /// A moment about x, y and z: that of a slide or a hinge, or of friction in a pin.
    #[must_use]
    pub fn moment(&self, index: usize) -> Option<[[f64; ORDERS]; 3]> {
        let Space { x, y, z } = self.solution.moment(index, self.pose)?;
        Some([x, y, z].map(orders))
    }

    /// The effort of the drive of an input, with two rates.
    #[must_use]
    pub fn effort(&self, input: usize) -> Option<[f64; ORDERS]> {
        self.solution.effort(input, self.pose).map(orders)
    }
}

/// Where a joint is found, or the direction of a slide.
#[derive(Clone, Copy, Debug)]
enum PlaceOf {
    /// It stands still.
    Still(Space<f64>),
    /// Its coordinates are quantities.
    Quantities(PointIndex),
    /// It is drawn.
    Drawn,
}

/// What is found once for all poses of an assembly: without friction, and where the solver gives motions through snap.
#[derive(Clone)]
pub(super) struct PosePlan {
    structure: Structure,
    /// The order of the equations, with their entries in the first pose.
    system: OrderedSystem<ORDERS>,
    places: Vec<PlaceOf>,
    /// The quantities that are asked for.
    pub(super) needed: Vec<usize>,
    /// Those of them that the equations ask for.
    in_equations: Vec<usize>,
    /// Whether a contact has a pressure angle.
    has_teeth: bool,
    arms: Vec<Arm>,
    others: Vec<(usize, Unknown)>,
    /// The first pose.
    pub(super) moved: MovedMechanism<MovedNumber>,
    frames: Vec<MovedFrame<MovedNumber>>,
}

/// The memory in which poses are solved.
#[derive(Clone)]
pub(super) struct PoseRoom<S> {
    system: OrderedSystem<ORDERS, S>,
    pub(super) moved: MovedMechanism<SeriesOf<S, TERMS>>,
    frames: Vec<MovedFrame<SeriesOf<S, TERMS>>>,
    /// The same in as many terms as forces have.
    short: MovedMechanism<ForceNumber<S>>,
    short_frames: Vec<MovedFrame<ForceNumber<S>>>,
    /// How contacts bear, first as is taken for granted, and then as is found.
    flanks: [Vec<Flank>; 2],
    right: Vec<ForceNumber<S>>,
    pub(super) solution: Solution<ORDERS, S>,
}

impl PosePlan {
    /// The plan by a pose; none if it needs more than the solver of rates gives. If dimensions vary, what stands still
    /// may differ in another pose.
    pub(super) fn new(
        reactions: &NamedReactions<'_>,
        place: &ReactionPlace<'_>,
        varies: bool,
    ) -> Result<Option<Self>, ReactionError> {
        let functions = place.functions;
        if reactions.has_friction() || functions.description().order + 1 < TERMS {
            return Ok(None);
        }
        let outline = functions.outline();
        let (moved, frames) = place.moving(&outline, &reactions.connections)?;
        let (structure, all) = reactions.structure(place, &outline, &moved, &frames)?;
        let equations = structure.equations(reactions, &outline, &moved, &frames);
        let columns = equations.columns(&structure.unknowns);
        let shorter = |column: &Vec<Series<REACH>>| column.iter().map(Series::resized).collect();
        let columns: Vec<Vec<Series<ORDERS>>> = columns.iter().map(shorter).collect();
        let Some(mut system) = structure.order(reactions, &outline, &columns, &all) else {
            return Ok(None);
        };
        for (column, entries) in columns.iter().enumerate() {
            for (row, entry) in entries.iter().enumerate() {
                system.set(row, column, *entry);
            }
        }
        let (arms, others) = equations.arms(&structure.unknowns);
        let otherwise = if varies {
            place.otherwise(&outline, &reactions.connections)
        } else {
            Some(Vec::new())
        };
        let places: Vec<PlaceOf> = (0..moved.places.len())
            .map(|index| PlaceOf::find(reactions, &outline, index, &all, otherwise.as_deref()))
            .collect();
        let mut plan = Self {
            system,
            needed: Vec::new(),
            in_equations: in_equations(reactions),
            has_teeth: reactions
                .connections
                .iter()
                .any(|own| own.mesh.is_some_and(|mesh| mesh.has_pressure_angle())),
            arms,
            others,
            moved,
            frames,
            structure,
            places,
        };
        plan.needed = plan.needed(reactions, place);
        Ok(Some(plan))
    }

    fn needed(&self, reactions: &NamedReactions<'_>, place: &ReactionPlace<'_>) -> Vec<usize> {
        let loads = reactions.loads.all().iter().flat_map(NamedLoad::quantities);
        let places = self.places.iter().flat_map(|own| match *own {
            PlaceOf::Quantities(point) => point.quantities(),
            _ => PointIndex::Moving([None; 3]).quantities(),
        });
        let mut needed: Vec<usize> = loads.chain(places).chain(self.in_equations.iter().copied()).collect();
        if self.is_drawn() {
            let first = place.parameters.len();
            needed.extend(0..first + place.inputs.len() + place.unknowns.len());
        }
        needed.sort_unstable();
        needed.dedup();
        needed
    }

    /// The joints and directions that are drawn.
    #[cfg(feature = "std")]
    pub(super) fn drawn(&self) -> impl Iterator<Item = usize> {
        let places = self.places.iter().enumerate();
        places.filter_map(|(index, place)| matches!(place, PlaceOf::Drawn).then_some(index))
    }

    /// Whether joints are drawn.
    pub(super) fn is_drawn(&self) -> bool {
        self.places.iter().any(|place| matches!(place, PlaceOf::Drawn))
    }

    /// Memory for poses.
    pub(super) fn room<S: PoseNumber>(&self, reactions: &NamedReactions<'_>) -> PoseRoom<S> {
        // a quantity that nobody asks for is no number
        let mut quantities = vec![SeriesOf::constant(f64::NAN); self.moved.quantities.len()];
        for (quantity, parameter) in quantities.iter_mut().zip(&reactions.parameters[..]) {
            *quantity = SeriesOf::constant(*parameter);
        }
        let place = |place: &PlaceOf| match *place {
            PlaceOf::Still(point) => still(point),
            _ => Space::zero(),
        };
        let moved = MovedMechanism {
            quantities,
            places: self.places.iter().map(place).collect(),
            joints: self.moved.joints,
            is_space: self.moved.is_space,
        };
        let short = MovedMechanism {
            quantities: moved.quantities.iter().map(SeriesOf::resized).collect(),
            places: moved.places.iter().copied().map(shortened).collect(),
            joints: moved.joints,
            is_space: moved.is_space,
        };
        let (connections, drives) = (reactions.connections.len(), reactions.driven.len());
        PoseRoom {
            system: self.system.in_numbers(),
            frames: self.frames.iter().map(MovedFrame::in_numbers).collect(),
            short_frames: self.frames.iter().map(MovedFrame::in_numbers).collect(),
            flanks: [self.structure.flanks.clone(), self.structure.flanks.clone()],
            right: vec![SeriesOf::constant(0.0); self.structure.rows.count()],
            solution: Solution::empty(moved.is_space, connections, drives),
            moved,
            short,
        }
    }

    /// Where the joints stand that no output tells, in a pose whose quantities are known.
    pub(super) fn draw(
        &self,
        reactions: &NamedReactions<'_>,
        quantities: &[MovingPose],
        found: &mut impl FnMut(usize, Space<MovingPose>),
    ) {
        let description = reactions.functions.description();
        let (parameters, rest) = quantities.split_at(description.parameters.len());
        let (inputs, rest) = rest.split_at(description.inputs.len());
        let unknowns = &rest[..description.unknowns.len()];
        let mut index = 0;
        let joints = self.moved.joints;
        let mut add = |coordinates: &[MovingPose]| {
            if matches!(self.places.get(index), Some(PlaceOf::Drawn)) {
                let coordinate = |axis: usize| coordinates.get(axis).copied().unwrap_or(Series::ZERO);
                let place = Space::new(coordinate(0), coordinate(1), coordinate(2));
                let is_joint = index < joints;
                found(index, if is_joint { place } else { unit(place) });
            }
            index += 1;
        };
        SkeletonOver::<MovingPose>::skeleton_points(reactions.functions, parameters, inputs, unknowns, &mut add);
    }
}

impl PlaceOf {
    fn find(
        reactions: &NamedReactions<'_>,
        outline: &Outline<'_>,
        index: usize,
        all: &[Influence<REACH>],
        otherwise: Option<&[Influence<REACH>]>,
    ) -> Self {
        let Some(first) = all.first() else { return Self::Drawn };
        let terms = |one: &Influence<REACH>| {
            let Space { x, y, z } = one.moved.places[index];
            [x, y, z].map(|part| part.coefficients())
        };
        let own = terms(first).map(|part| part[0]);
        let stands = |one: &Influence<REACH>| {
            let mut parts = terms(one).into_iter().zip(own);
            parts.all(|(part, own)| part[0] == own && part[1..].iter().all(|term| *term == 0.0))
        };
        if all.iter().all(stands) && otherwise.is_some_and(|otherwise| otherwise.iter().all(stands)) {
            return Self::Still(own.into());
        }
        let mut points = outline.points.iter();
        let name = points.find(|(_, joint)| *joint == index && index < first.moved.joints);
        let place = name.and_then(|(name, _)| reactions.loads.load_point((*name).into()).ok());
        place.map_or(Self::Drawn, Self::Quantities)
    }
}

/// The quantities that the equations ask for beside the joints.
fn in_equations(reactions: &NamedReactions<'_>) -> Vec<usize> {
    let points = reactions.connections.iter().flat_map(|own| {
        let hinge = match own.hinge {
            Some(JointAxis::Vector(vector)) => Some(vector),
            _ => None,
        };
        let contact = own.mesh.iter().flat_map(Mesh::points);
        hinge.into_iter().chain(contact)
    });
    points.flat_map(PointIndex::quantities).collect()
}

impl<S: PoseNumber> PoseRoom<S> {
    /// Solves poses whose quantities and drawn places are written. False if the plan does not fit.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn solve(
        &mut self,
        plan: &PosePlan,
        reactions: &NamedReactions<'_>,
        outline: &Outline<'_>,
    ) -> Result<bool, ReactionError> {
        let connections = &reactions.connections[..];
        let PosePlan { structure, .. } = plan;
        let Self {
            system,
            moved,
            frames,
            short,
            short_frames,
            flanks,
            right,
            solution,
        } = self;
        for (index, place) in plan.places.iter().enumerate() {
            match place {
                PlaceOf::Still(_) => continue,
                PlaceOf::Quantities(point) => moved.move_place(index, *point),
                PlaceOf::Drawn => {}
            }
            let (own, place) = (&mut short.places[index], &moved.places[index]);
            (own.x, own.y) = (place.x.resized(), place.y.resized());
            if moved.is_space {
                own.z = place.z.resized();
            }
        }
        for quantity in &plan.in_equations {
            short.quantities[*quantity] = moved.quantities[*quantity].resized();
        }
        moved.move_frames(outline, connections, frames)?;
        if !structure.rows.fit(moved, frames) {
            return Ok(false);
        }
        if moved.check(outline, connections, frames).is_err() {
            return Ok(false);
        }
        for (short, frame) in short_frames.iter_mut().zip(&*frames) {
            short.shorten(frame);
        }
        let [flanks, bears] = flanks;
        flanks.copy_from_slice(&structure.flanks);
        for turn in 0..2 {
            let equations = Equations {
                flanks,
                ..structure.equations(reactions, outline, short, short_frames)
            };
            if turn == 0 {
                right.fill(SeriesOf::constant(0.0));
                let demand = structure.demand(reactions, moved, frames, 1.0);
                for load in 0..structure.places.len() {
                    for part in 0..PARTS {
                        if let Some((_, exertion)) = demand.exertion(load, part)? {
                            equations.entries_of(&exertion, &mut TakenAway(right));
                        }
                    }
                }
            }
            if !equations.fill_arms(system, &plan.arms) {
                return Ok(false);
            }
            for (column, unknown) in &plan.others {
                if !equations.fill(system, *column, *unknown) {
                    return Ok(false);
                }
            }
            if !system.factor() {
                return Ok(false);
            }
            let values = system.solve(right);
            if !SeriesOf::are_finite(values) {
                return Err(ReactionError::NotFinite);
            }
            equations.write(&structure.unknowns, values, |_| false, solution);
            if !plan.has_teeth {
                break;
            }
            bears.copy_from_slice(flanks);
            equations.bears(solution, bears);
            if bears == flanks {
                break;
            }
            if turn == 1 {
                return Ok(false);
            }
            flanks.copy_from_slice(bears);
        }
        Ok(true)
    }
}
