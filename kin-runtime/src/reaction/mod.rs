//! Joint reactions: the forces in joints of the plane and of space, with their rates.
//!
//! [`NamedReactions`] are those of a mechanism under [loads](NamedLoads), without its type:
//! [`AnyLinkage::reactions`](crate::linkage::AnyLinkage::reactions) makes them. In a pose they tell each force with two
//! rates by time, and a sweep tells its peak, its extremes and its mean:
//! [`of_reaction`](crate::linkage::AnySweep::of_reaction).
//!
//! ```
//! use kin_core::any::PositionChoice;
//! use kin_core::linkage::AnyLinkage;
//! use kin_core::load::NamedLoads;
//! use kin_core::prelude::*;
//!
//! mechanism! {
//!     /// Slider-crank in metres.
//!     pub struct Engine { pub r: Length, pub l: Length }
//!     input theta: Angle;
//!     unknown phi: Angle, s: Length;
//!     r * cis(theta) + l * cis(phi) == vec2(s, 0);
//!     output pin: Point = r * cis(theta);
//!     output piston: Point = vec2(s, 0);
//!
//!     ground 0;
//!     body crank: 0, pin;
//!     body rod: pin, piston;
//!     slide piston along vec2(1, 0);
//! }
//!
//! let engine = Engine { r: 0.05, l: 0.15 };
//! let linkage = AnyLinkage::of(&engine);
//! let loads = linkage.loads().force(Plane::new(-800.0, 0.0), "piston")?;
//! let reactions = linkage.reactions(&loads)?;
//! let crank = Motion::at_constant_speed(1.0, 0.0);
//! let found = reactions.at(&[crank], PositionChoice::Assembly(0))?;
//! // the gas force goes along the rod, and the cylinder holds its part across
//! let slope = -0.05 * 1.0_f64.sin() / 0.15;
//! let side = 800.0 * slope / (1.0 - slope * slope).sqrt();
//! assert!((found.of("piston")?.y[0] + side).abs() < 1e-11);
//! assert_eq!(reactions.names().collect::<Vec<_>>(), ["ground_crank", "pin", "piston"]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//!
//! Newton's and Euler's equations of each body, three in the plane and six in space, are linear in the forces: those of
//! each pin or ball, the moments of a hinge across its axis, the normal forces of each slide, its moments where nothing
//! but the slide keeps its slider from turning, the tangential forces of contacts that roll, and the efforts of the
//! drives. (J. Wittenburg, *Dynamics of Multibody Systems*, 2nd edition, Springer 2008, chapter 5.)
//! Their matrix and the loads are series in time, and so are the solutions, from the triangular factors of one matrix:
//! rates are exact, and nothing is divided by a speed.
//!
//! [Friction] opposes the motion in a pin with the moment μ r |F| and on a slide with the force μ |N|, which
//! change F and N in turn. The same factors tell by how much, and a system with one equation for each joint with
//! friction remains. Its size is bounded before it is solved: see [`contraction`](Reactions::contraction).

mod action;

#[cfg(feature = "std")]
mod batch;
mod body_load;
mod change;
mod connection;
mod contact;
mod coulomb;
mod demand;
mod efficiency;
mod equations;
mod error;
mod frames;
mod friction;
mod ordered;
mod pose;
mod pose_number;
mod prepared;
#[cfg(feature = "std")]
mod program;
mod proof;
mod rank;
mod remembered;
mod rolling;
#[cfg(feature = "std")]
mod steps;
mod structure;
#[cfg(test)]
mod tests;
#[cfg(feature = "std")]
mod traced;
#[cfg(feature = "std")]
mod traced_plan;

#[cfg(feature = "std")]
#[cfg_attr(docsrs, doc(cfg(feature = "std")))]
pub use batch::ReactionBatch;
pub use body_load::{BodyLoad, BodyLoadKind};
pub use efficiency::Efficiency;
pub use error::ReactionError;
pub use friction::{Friction, FrictionMistake};
pub use pose::PoseReactions;
pub use prepared::PreparedReactions;
pub use proof::{
    ForcePlace, ForceProof, ForceVerdict, PeakBounds, ProofError, ProvenForce, UndecidedForce, UndecidedReason,
};
pub use rolling::{Rolling, RollingMistake};

use alloc::string::{String, ToString};
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use crate::any::{
    AnyMechanism, ClosureOver, MotionOver, NearOver, OutputsOver, Pictured, PositionChoice, SkeletonOver,
};
use crate::batch::AnyBatch;
use crate::bounds::Bounds;
use crate::failure::SolveError;
use crate::geometry::Space;
use crate::hermite::TERMS;
use crate::law::Side;
use crate::load::{LoadError, LoadPoint, NamedLoads};
use crate::motion::Motion;
use crate::number::series::{Series, SeriesOf};
use crate::number::{Changing, Number, NumberRow};
use crate::picture::Outline;
use action::{Action, Influence, Influences};
use body_load::Acting;
use connection::{Connection, Member, connections, member_name};
use equations::Solution;
use frames::{JointAxis, MovedFrame, MovedMechanism, MovingNumber};
use pose_number::{SinglePose, is_nothing, unchanging};
use remembered::Remembered;
use rolling::Flank;
pub(crate) use structure::Plan;

/// The orders of a motion up to snap, and the terms of a series of each.
const REACH: usize = 4 + TERMS;

/// The number of orders of a force: its value and two rates.
const ORDERS: usize = 3;

/// A motion as a series.
pub type MovedNumber = Series<REACH>;

/// The same in other numbers.
pub(crate) type MovedIn<S> = SeriesOf<S, REACH>;

/// A motion through snap as a series.
pub(crate) type MovingPose = Series<{ pose::TERMS }>;

/// A motion through accelerations, as bounds of its values over an interval.
pub(crate) type MovingBounds = Changing<Changing<Bounds>>;

/// The functions of a mechanism from which its reactions are found. Every declared mechanism has them.
#[expect(
    private_bounds,
    reason = "messages would list a public number among those that a user may take"
)]
pub trait ReactionFunctions:
    Send
    + Sync
    + AnyMechanism
    + AnyBatch
    + Pictured
    + NearOver<MovedNumber>
    + OutputsOver<MovedNumber>
    + SkeletonOver<MovedNumber>
    + NearOver<Changing<MovedNumber>>
    + OutputsOver<Changing<MovedNumber>>
    + SkeletonOver<Changing<MovedNumber>>
    + SkeletonOver<MovingPose>
    + MotionOver<f64>
    + ClosureOver<MovingBounds>
    + OutputsOver<MovingBounds>
    + SkeletonOver<MovingBounds>
{
}

impl<F> ReactionFunctions for F where
    F: ?Sized
        + Send
        + Sync
        + AnyMechanism
        + AnyBatch
        + Pictured
        + NearOver<MovedNumber>
        + OutputsOver<MovedNumber>
        + SkeletonOver<MovedNumber>
        + NearOver<Changing<MovedNumber>>
        + OutputsOver<Changing<MovedNumber>>
        + SkeletonOver<Changing<MovedNumber>>
        + SkeletonOver<MovingPose>
        + MotionOver<f64>
        + ClosureOver<MovingBounds>
        + OutputsOver<MovingBounds>
        + SkeletonOver<MovingBounds>
{
}

/// Which part of a reaction is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReactionPart {
    /// The force along x.
    X,
    /// The force along y.
    Y,
    /// The force along z.
    Z,
    /// The size of the force.
    Force,
    /// The moment of a slide about its joint; in a pin of the plane, that of friction. In space, the size of the moment
    /// of a slide or of a hinge.
    Moment,
    /// The moment about x.
    MomentX,
    /// The moment about y.
    MomentY,
    /// The moment about z.
    MomentZ,
}

/// What is asked of the reactions along a sweep.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ReactionQuantity {
    /// A part of a reaction, by its index.
    Part(usize, ReactionPart),
    /// The effort of the drive of an input.
    Effort(usize),
    /// The power of the drive of an input.
    Power(usize),
    /// The power of all drives.
    Input,
    /// The power of friction.
    Heat,
}

/// The reactions of a mechanism under loads.
///
/// A reaction is called by the point of its joint, which is an output, as in `"knee"`: it acts on the body that is
/// declared later, and the earlier one exerts it; of the ground and of guides it acts on the body that they hold. Where
/// more than two bodies meet, one of them holds the others, and each of these has its own: `"knee_rod"`. A joint
/// without a name is called by its bodies: `"crank_rod"`. If bodies are pinned to a slider, the reaction of its guide
/// is `"piston_slide"`.
///
/// The body that holds the others is the ground; or the slider, which is a body with this joint alone; or the first
/// body.
///
/// In space, bodies that share two points are joined by a hinge about the line through them, and those that share one
/// point by a ball, unless it has an axis by [`hinge`](Self::hinge). A body whose points lie on a line is a rod, about
/// whose line nothing acts.
#[derive(Clone)]
pub struct NamedReactions<'m> {
    functions: &'m dyn ReactionFunctions,
    parameters: NumberRow,
    loads: NamedLoads,
    connections: Vec<Connection>,
    /// The body that an input is said to drive.
    driven: Vec<Option<usize>>,
    /// The friction of connections.
    frictions: Vec<(usize, Friction)>,
    /// The rates of the inputs that friction opposes while all of them rest.
    about_to_move: Option<Vec<f64>>,
    solutions: Remembered,
}

impl fmt::Debug for NamedReactions<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.names()).finish()
    }
}

/// The place at which reactions are wanted.
pub(crate) struct ReactionPlace<'p> {
    pub(crate) functions: &'p dyn ReactionFunctions,
    pub(crate) parameters: &'p [f64],
    /// The inputs as series in a variable.
    pub(crate) inputs: Vec<MovedNumber>,
    /// The unknowns and outputs, with unwrapped angles.
    pub(crate) unknowns: &'p [f64],
    pub(crate) outputs: &'p [f64],
    /// The change of the variable for each unit of time.
    pub(crate) rate: f64,
    /// The side from which the place is approached, where friction changes its sense.
    pub(crate) side: Side,
}

/// By so much dimensions are changed, each by another part of it, to tell apart what moves alike by its length alone.
const CHANGE: f64 = 1e-4;

impl<'m> NamedReactions<'m> {
    /// The reactions under loads. `guessed` admits bodies that no statement declares.
    pub(crate) fn new(
        functions: &'m dyn ReactionFunctions,
        parameters: &[f64],
        loads: &NamedLoads,
        guessed: bool,
    ) -> Result<Self, ReactionError> {
        let outline = functions.outline();
        if outline.bodies.is_empty() {
            return Err(ReactionError::NoBodies);
        }
        if let (Some(statements), false) = (outline.guess, guessed) {
            let statements = statements.to_string();
            return Err(ReactionError::Guessed { statements });
        }
        Ok(Self {
            functions,
            parameters: parameters.into(),
            loads: loads.clone(),
            connections: connections(&outline, functions.is_space()),
            driven: vec![None; functions.description().inputs.len()],
            frictions: Vec::new(),
            about_to_move: None,
            solutions: Remembered::default(),
        })
    }

    /// The same, where the drive of an input turns or pushes this body. It need only be said if several bodies move
    /// like the input.
    ///
    /// # Errors
    /// [`ReactionError::Place`] if there is no such input or body.
    pub fn driving(mut self, input: &str, body: &str) -> Result<Self, ReactionError> {
        let bodies = self.functions.outline().bodies;
        let inputs = self.functions.description().inputs;
        let input_index = inputs.iter().position(|own| own.name == input);
        let body_index = bodies.iter().position(|own| own.name == body);
        if let (Some(input), Some(_)) = (input_index, body_index) {
            self.driven[input] = body_index;
            self.solutions.forget();
            return Ok(self);
        }
        Err(ReactionError::Place {
            what: drive_of(input),
            places: bodies.iter().map(|body| body.name.to_string()).collect(),
        })
    }

    /// The same, where a joint of space that has one point is a hinge about this axis instead of a ball. The axis is a
    /// vector of the mechanism by its name, or one of the ground, of any length, and is fixed to both bodies.
    ///
    /// ```
    /// use kin_core::any::PositionChoice;
    /// use kin_core::library::Rssr;
    /// use kin_core::linkage::AnyLinkage;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = Rssr {
    ///     crank: 1.0,
    ///     pivot: Space::new(3.0, 0.0, 0.0),
    ///     axis: Space::new(0.0, 1.0, 0.0),
    ///     arm: Space::new(0.0, 0.0, 2.0),
    ///     rod: 13_f64.sqrt(),
    /// };
    /// let linkage = AnyLinkage::of(&linkage);
    /// let loads = linkage.loads().torque(-5.0, "phi")?;
    /// let reactions = linkage
    ///     .reactions(&loads)?
    ///     .hinge("ground_crank", Space::new(0.0, 0.0, 1.0))?
    ///     .hinge("ground_arm", "axis")?;
    /// let crank = Motion::at_constant_speed(0.4, 1.0);
    /// let found = reactions.at(&[crank], PositionChoice::Assembly(0))?;
    /// for name in ["ground_crank", "ball", "ground_arm"] {
    ///     println!("{name}: {} N", found.of(name)?.magnitude()[0]);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ReactionError::NoSuchReaction`], [`ReactionError::NoBall`] for a joint that has an axis, and
    /// [`ReactionError::NoSuchName`] if no vector has the name.
    pub fn hinge<'n>(mut self, name: &str, axis: impl Into<LoadPoint<'n>>) -> Result<Self, ReactionError> {
        let index = self.index(name)?;
        if !self.functions.is_space() || self.connections[index].axis().is_some() {
            let reaction = name.to_string();
            return Err(ReactionError::NoBall { reaction });
        }
        let axis = self.loads.load_point(axis.into())?;
        self.connections[index].hinge = Some(JointAxis::Vector(axis));
        self.solutions.forget();
        Ok(self)
    }

    /// The names of all reactions.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.connections.iter().map(|connection| connection.name.as_str())
    }

    /// The bodies of a reaction: the one on which it acts, and the one that exerts it, which may be the `ground`.
    ///
    /// # Errors
    /// [`ReactionError::NoSuchReaction`].
    pub fn bodies_of(&self, name: &str) -> Result<[String; 2], ReactionError> {
        let Connection { on, by, .. } = self.connections[self.index(name)?];
        let outline = self.functions.outline();
        Ok([on, by].map(|member: Member| member_name(&outline, member)))
    }

    /// Whether a reaction is that of a slide, which may have a moment.
    ///
    /// # Errors
    /// [`ReactionError::NoSuchReaction`].
    pub fn is_slide(&self, name: &str) -> Result<bool, ReactionError> {
        Ok(self.connections[self.index(name)?].slide.is_some())
    }

    /// Whether a reaction is that of a hinge of space, which has a moment across its axis.
    ///
    /// # Errors
    /// [`ReactionError::NoSuchReaction`].
    pub fn is_hinge(&self, name: &str) -> Result<bool, ReactionError> {
        Ok(self.connections[self.index(name)?].hinge.is_some())
    }

    /// The joint of the [picture](Outline) in which a reaction acts, by its index.
    ///
    /// # Errors
    /// [`ReactionError::NoSuchReaction`].
    pub fn joint_of(&self, name: &str) -> Result<usize, ReactionError> {
        let joint = self.connections[self.index(name)?].joint;
        joint.ok_or_else(|| ReactionError::Rolling {
            reaction: name.to_string(),
            mistake: RollingMistake::NoJoint,
        })
    }

    pub(crate) fn index(&self, name: &str) -> Result<usize, ReactionError> {
        index_of(name, || self.names())
    }

    /// The reactions in the pose at given motions of the inputs, through snap.
    ///
    /// # Errors
    /// [`ReactionError`] where the mechanism has no pose, where loads or drives have no certain place, and where the
    /// joints do not hold the bodies.
    pub fn at(&self, inputs: &[Motion], choice: PositionChoice<'_, f64>) -> Result<Reactions, ReactionError> {
        let unknowns = self.unknowns_at(inputs, choice)?;
        self.found(&self.place(inputs, &unknowns), None)
    }

    fn unknowns_at(&self, inputs: &[Motion], choice: PositionChoice<'_, f64>) -> Result<Vec<f64>, SolveError> {
        let values: Vec<f64> = inputs.iter().map(Motion::value).collect();
        let mut unknowns = vec![0.0; self.functions.description().unknowns.len()];
        self.functions
            .position(&self.parameters, &values, choice, &mut unknowns)?;
        Ok(unknowns)
    }

    fn place<'p>(&'p self, inputs: &[Motion], unknowns: &'p [f64]) -> ReactionPlace<'p> {
        let series = |motion: &Motion| {
            Series::from_derivatives(core::array::from_fn(|order| motion.derivative(order).unwrap_or(0.0)))
        };
        ReactionPlace {
            functions: self.functions,
            parameters: &self.parameters,
            inputs: inputs.iter().map(series).collect(),
            unknowns,
            outputs: &[],
            rate: 1.0,
            side: Side::Right,
        }
    }

    /// The reactions at a place, by time, by a plan if one is kept.
    pub(crate) fn found(
        &self,
        place: &ReactionPlace<'_>,
        plan: Option<&mut Option<Plan>>,
    ) -> Result<Reactions, ReactionError> {
        let solved = self.solved_by(place, plan)?;
        let input = self.input_of(place, &solved.solution);
        let body_loads = self.body_loads(&solved);
        let pitch_points = self.pitch_points(place, &solved.moved)?;
        let mut solution = solved.solution.map(|series| by_time(series, place.rate));
        solution.heat = solution.heat * Series::constant(place.rate);
        Ok(Reactions {
            names: self.names().map(ToString::to_string).collect(),
            efficiency: input.map(|input| Efficiency {
                input,
                heat: solution.begun_heat,
            }),
            solution,
            body_loads,
            pitch_points,
        })
    }

    /// The power of all drives, by time; at rest, in the motion that is about to begin.
    fn input_of(&self, place: &ReactionPlace<'_>, solution: &Solution<REACH>) -> Option<f64> {
        let beginning = self.beginning(place).ok().flatten();
        let (speeds, by_time) = match &beginning {
            Some(beginning) => (&beginning.inputs, beginning.by_time),
            None => (&place.inputs, place.rate),
        };
        let efforts = solution.efforts.iter().zip(speeds);
        let powers = efforts.map(|(effort, speed)| Some(effort.as_ref()?.real() * speed.coefficients()[1] * by_time));
        powers.sum()
    }

    /// The effort of the drive of an input, as a quantity along a sweep.
    pub(crate) fn effort_of(&self, input: usize) -> Result<ReactionQuantity, ReactionError> {
        let is_input = input < self.driven.len();
        is_input
            .then_some(ReactionQuantity::Effort(input))
            .ok_or(LoadError::NoEffort { input }.into())
    }

    /// A quantity as a series in the variable.
    pub(crate) fn quantity(
        &self,
        place: &ReactionPlace<'_>,
        plan: &mut Option<Plan>,
        quantity: ReactionQuantity,
    ) -> Result<MovedNumber, ReactionError> {
        let find = || Ok(self.solved_by(place, Some(plan))?.solution);
        let read = |solution: &Solution<REACH>| self.of_solution(place, solution, quantity);
        // other questions ask for the same solution
        self.solutions.read(place.key(), find, read)?
    }

    /// A quantity of a solution.
    fn of_solution<S: SinglePose>(
        &self,
        place: &ReactionPlace<'_>,
        solution: &Solution<REACH, S>,
        quantity: ReactionQuantity,
    ) -> Result<MovedIn<S>, ReactionError> {
        let by_time = SeriesOf::constant(place.rate);
        let effort = |input: usize| {
            let drive = || drive_of(self.functions.description().inputs[input].name);
            solution.efforts[input].ok_or_else(|| self.undetermined(solution, drive()))
        };
        let power = |input: usize| Ok(effort(input)? * unchanging::<S, REACH>(place.inputs[input]).slope() * by_time);
        match quantity {
            ReactionQuantity::Part(index, part) => {
                let found = solution.part(index, part);
                found.ok_or_else(|| self.undetermined(solution, self.connections[index].name.clone()))
            }
            ReactionQuantity::Effort(input) => effort(input),
            ReactionQuantity::Power(input) => power(input),
            ReactionQuantity::Input => {
                (0..place.inputs.len()).try_fold(SeriesOf::constant(0.0), |sum, input| Ok(sum + power(input)?))
            }
            ReactionQuantity::Heat => Ok(solution.heat * by_time),
        }
    }

    fn undetermined<S>(&self, solution: &Solution<REACH, S>, reaction: String) -> ReactionError {
        let names: Vec<String> = self.names().map(ToString::to_string).collect();
        undetermined(solution, &names, reaction)
    }
}

impl NamedReactions<'_> {
    /// Where the drives act.
    fn drives(&self, influences: &Influences<'_, '_, REACH>) -> Result<Vec<Action>, ReactionError> {
        let description = self.functions.description();
        let drives = description.inputs.iter().enumerate().map(|(input, quantity)| {
            let index = description.parameters.len() + input;
            let found = |influences: &Influences<'_, '_, REACH>| influences.actions(index, quantity.dimension);
            let wanted = |action: &Action| self.driven[input].is_none_or(|body| action.acts_on(body));
            influences.action(drive_of(quantity.name), found, wanted)
        });
        drives.collect()
    }

    /// Where the contacts touch, with the flank that bears first.
    fn flanks(&self, all: &[Influence<REACH>]) -> Result<Vec<Flank>, ReactionError> {
        let flank = |connection: &Connection| {
            let side = connection
                .mesh
                .map(|mesh| mesh.side([connection.on, connection.by], all));
            let side = side.transpose().map_err(|mistake| ReactionError::Rolling {
                reaction: connection.name.clone(),
                mistake,
            });
            Ok(Flank {
                side: side?.unwrap_or(1.0),
                sign: 1.0,
            })
        };
        self.connections.iter().map(flank).collect()
    }
}

/// A solution with what it was found for.
struct Solved<S = f64> {
    solution: Solution<REACH, S>,
    /// What masses and loads exert.
    loads: Vec<Acting<MovedIn<S>>>,
    drives: Vec<Action>,
    moved: MovedMechanism<MovedIn<S>>,
    frames: Vec<MovedFrame<MovedIn<S>>>,
}

/// A mechanism with the frames of its bodies.
type Moving<S = f64> = (MovedMechanism<MovedIn<S>>, Vec<MovedFrame<MovedIn<S>>>);

fn drive_of(input: &str) -> String {
    ["the drive of `", input, "`"].concat()
}

/// The index of a reaction among the names of all.
fn index_of<'n, N: Iterator<Item = &'n str>>(name: &str, names: impl Fn() -> N) -> Result<usize, ReactionError> {
    let index = names().position(|own| own == name);
    index.ok_or_else(|| ReactionError::NoSuchReaction {
        name: name.to_string(),
        names: names().map(ToString::to_string).collect(),
    })
}

/// The length of a vector. Where it passes through zero, it is that behind the zero.
fn size<S: SinglePose, const N: usize>(vector: Space<SeriesOf<S, N>>) -> SeriesOf<S, N> {
    let parts = [vector.x, vector.y, vector.z];
    // in the plane, the third part is nothing
    let count = if is_nothing(parts[2]) { 2 } else { 3 };
    S::length(&parts[..count])
}

fn undetermined<S>(solution: &Solution<REACH, S>, names: &[String], reaction: String) -> ReactionError {
    let is_undetermined = |index: &usize| {
        let vectors = [&solution.forces[*index], &solution.moments[*index]];
        vectors.iter().any(|vector| vector.0.iter().any(Option::is_none))
    };
    ReactionError::Undetermined {
        reaction,
        all: (0..names.len())
            .filter(is_undetermined)
            .map(|index| names[index].clone())
            .collect(),
    }
}

impl ReactionPlace<'_> {
    /// All numbers of the place.
    fn key(&self) -> Vec<u64> {
        let inputs = self.inputs.iter().flat_map(Series::coefficients);
        let side = if self.side == Side::Left { -1.0 } else { 1.0 };
        let still = [self.parameters, self.unknowns, self.outputs, &[self.rate, side]];
        let still = still.into_iter().flatten().copied();
        inputs.chain(still).map(f64::to_bits).collect()
    }

    /// The mechanism near the place, with inputs that move.
    fn moved(&self, parameters: &[f64], inputs: &[MovedNumber]) -> Result<MovedMechanism<MovedNumber>, SolveError> {
        let parameters: Vec<MovedNumber> = parameters.iter().copied().map(Series::constant).collect();
        MovedMechanism::near(self.functions, &parameters, inputs, self.unknowns, self.outputs)
    }

    /// The mechanism with the frames of its bodies.
    fn moving(&self, outline: &Outline<'_>, connections: &[Connection]) -> Result<Moving, ReactionError> {
        let moved = self.moved(self.parameters, &self.inputs)?;
        let frames = moved.frames(outline, connections)?;
        Ok((moved, frames))
    }

    /// The mechanism while each input moves alone at unit speed, of which one may be its own motion.
    fn influences(
        &self,
        parameters: &[f64],
        outline: &Outline<'_>,
        connections: &[Connection],
        own: Option<(&MovedMechanism<MovedNumber>, &[MovedFrame<MovedNumber>])>,
    ) -> Result<Vec<Influence<REACH>>, ReactionError> {
        let count = self.inputs.len();
        let moved = (0..count).map(|moved| {
            let inputs = self.inputs.iter().enumerate().map(|(input, motion)| {
                let rate = f64::from(u8::from(input == moved));
                let mut terms = [0.0; REACH];
                (terms[0], terms[1]) = (motion.real(), rate);
                Series::from_coefficients(terms)
            });
            let inputs: Vec<MovedNumber> = inputs.collect();
            let mut pairs = inputs.iter().zip(&self.inputs);
            let is_own = pairs.all(|(one, own)| one.coefficients() == own.coefficients());
            let (moved, frames) = if let (Some((moved, frames)), true) = (own, is_own) {
                (moved.clone(), frames.to_vec())
            } else {
                let moved = self.moved(parameters, &inputs)?;
                let frames = moved.frames(outline, connections)?;
                (moved, frames)
            };
            moved.check(outline, connections, &frames)?;
            Ok(Influence { moved, frames })
        });
        moved.collect()
    }

    /// The same with other dimensions, where it still closes.
    fn otherwise(&self, outline: &Outline<'_>, connections: &[Connection]) -> Option<Vec<Influence<REACH>>> {
        let mut part = 0.0;
        let parameters = self.parameters.iter().map(|parameter| {
            part = (part + core::f64::consts::FRAC_1_SQRT_2) % 1.0;
            parameter * (1.0 + CHANGE * part)
        });
        self.influences(&parameters.collect::<Vec<_>>(), outline, connections, None)
            .ok()
    }
}

/// The force in a joint, with its rates by time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction {
    /// The force along x: its value, its rate and its second rate.
    pub x: [f64; ORDERS],
    /// The force along y.
    pub y: [f64; ORDERS],
    /// The force along z.
    pub z: [f64; ORDERS],
    /// The moment of a slide about its joint; in a pin, that of friction. In space, the size of the moment of a slide
    /// or of a hinge.
    pub moment: [f64; ORDERS],
    /// The moments about x, y and z.
    pub moments: [[f64; ORDERS]; 3],
    /// What of it is friction: the moment in a pin, and the force along the direction of a slide.
    pub friction: [f64; ORDERS],
    force: Space<MovedNumber>,
}

impl Reaction {
    /// The size of the force with its rates. Where the force passes through zero, the rates are those behind the zero.
    #[must_use]
    pub fn magnitude(&self) -> [f64; ORDERS] {
        orders(size(self.force))
    }

    /// One part with its rates.
    #[must_use]
    pub fn part(&self, part: ReactionPart) -> [f64; ORDERS] {
        match part {
            ReactionPart::X => self.x,
            ReactionPart::Y => self.y,
            ReactionPart::Z => self.z,
            ReactionPart::Force => self.magnitude(),
            ReactionPart::Moment => self.moment,
            ReactionPart::MomentX => self.moments[0],
            ReactionPart::MomentY => self.moments[1],
            ReactionPart::MomentZ => self.moments[2],
        }
    }

    /// The angle of the force in the plane of x and y with its rates, -π ..= π; none if it is zero there.
    #[must_use]
    pub fn direction(&self) -> Option<[f64; ORDERS]> {
        let Space { x, y, .. } = self.force;
        let is_zero = x.real() == 0.0 && y.real() == 0.0;
        (!is_zero).then(|| orders(y.atan2(x)))
    }
}

/// A series in the time, from one in a variable that changes so fast.
fn by_time(series: MovedNumber, rate: f64) -> MovedNumber {
    let mut power = 1.0;
    Series::from_coefficients(series.coefficients().map(|coefficient| {
        let own = coefficient * power;
        power *= rate;
        own
    }))
}

fn orders<const N: usize>(series: Series<N>) -> [f64; ORDERS] {
    let derivatives = series.derivatives();
    core::array::from_fn(|order| derivatives[order])
}

/// The reactions in one pose.
#[derive(Clone, Debug)]
pub struct Reactions {
    names: Vec<String>,
    efficiency: Option<Efficiency>,
    solution: Solution<REACH>,
    body_loads: Vec<BodyLoad>,
    /// Those of contacts, empty if there is no contact.
    pitch_points: Vec<Option<Space<f64>>>,
}

impl Reactions {
    /// A reaction by its name.
    ///
    /// # Errors
    /// [`ReactionError::Undetermined`] if equilibrium alone does not determine it, and
    /// [`ReactionError::NoSuchReaction`].
    pub fn of(&self, name: &str) -> Result<Reaction, ReactionError> {
        let index = index_of(name, || self.names.iter().map(String::as_str))?;
        let solution = &self.solution;
        match (solution.forces[index].whole(), solution.moments[index].whole()) {
            (Some(force), Some(moment)) => Ok(Reaction {
                x: orders(force.x),
                y: orders(force.y),
                z: orders(force.z),
                moment: orders(if solution.is_space { size(moment) } else { moment.z }),
                moments: [moment.x, moment.y, moment.z].map(orders),
                friction: orders(self.solution.frictions[index]),
                force,
            }),
            _ => Err(undetermined(&self.solution, &self.names, self.names[index].clone())),
        }
    }

    /// All reactions with their names.
    pub fn all(&self) -> impl Iterator<Item = (&str, Result<Reaction, ReactionError>)> {
        self.names.iter().map(|name| (name.as_str(), self.of(name)))
    }

    /// The pitch point of a [contact](NamedReactions::rolling), at which its force acts; none of a joint.
    #[must_use]
    pub fn pitch_point(&self, name: &str) -> Option<Space<f64>> {
        let index = self.names.iter().position(|own| own == name)?;
        self.pitch_points.get(index).copied().flatten()
    }

    /// What acts on the bodies beside the forces in joints: masses, other loads, drives, and the moments of guides. An
    /// effort or a moment that equilibrium does not determine is zero among them.
    #[must_use]
    pub fn body_loads(&self) -> &[BodyLoad] {
        &self.body_loads
    }

    /// The effort of the drive of an input, with its rates; none if equilibrium does not determine it.
    #[must_use]
    pub fn effort(&self, input: usize) -> Option<[f64; ORDERS]> {
        self.solution.efforts.get(input).copied().flatten().map(orders)
    }

    /// The power that friction turns into heat, with its rates.
    #[must_use]
    pub fn heat(&self) -> [f64; ORDERS] {
        orders(self.solution.heat)
    }

    /// The power of the drives and what friction takes of it; at rest, for the motion that is [about to
    /// begin](NamedReactions::about_to_move). What is left also moves masses. None if equilibrium does not determine an
    /// effort.
    #[must_use]
    pub fn efficiency(&self) -> Option<Efficiency> {
        self.efficiency
    }

    /// A bound of the factor by which forces change friction and friction the forces. Below 1 there is no other
    /// solution; from 1 on, this is the one that grows with friction from the forces without it.
    #[must_use]
    pub fn contraction(&self) -> f64 {
        self.solution.contraction
    }
}
