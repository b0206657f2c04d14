//! Forces proved over all inputs and tolerances.
//!
//! A sweep looks at places of a motion. A proof covers all of them: it divides the range of the input into pieces, and
//! has bounds of the force over each, in interval arithmetic that includes rounding.
//! [`AnySweep::proof`](crate::linkage::AnySweep::proof) makes it.

mod error;
mod forces;
mod pose;
mod search;

pub use error::ProofError;

use alloc::string::ToString;
use alloc::vec::Vec;
use core::fmt;

use super::{NamedReactions, ReactionPart};
use crate::any::AssemblyChoice;
use crate::load::{NamedLoad, NamedLoads};
use crate::number::ClosedRange;
use crate::quantity::{Digits, Dimension};
use forces::Wanted;

/// So many pieces are tried if nothing else is said.
const BUDGET: usize = 20_000;

/// A proof about the forces of a motion, of which a force is wanted.
///
/// The input moves over its whole range with a constant speed, or with any [speed](Self::speed_within) and
/// [acceleration](Self::acceleration_within) of intervals, and dimensions have [tolerances](Self::tolerance).
///
/// ```
/// use std::f64::consts::TAU;
/// use kin_core::any::AssemblyChoice;
/// use kin_core::linkage::AnyLinkage;
/// use kin_core::prelude::*;
/// use kin_core::reaction::{ForceVerdict, ReactionPart};
///
/// mechanism! {
///     /// A bob on an arm, in metres.
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
/// let reactions = linkage.reactions(&loads)?;
/// let turn = linkage.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[TAU], 2).speed(30.0);
/// let pivot = turn.proof(&reactions).tolerance("length", 0.001)?.of("ground_arm", ReactionPart::Force)?;
/// // the bob hangs below the pivot, on the longest arm: m (g + l ω²)
/// let peak = 2.0 * (9.81 + 0.401 * 30.0 * 30.0);
/// let found = pivot.peak(1e-6)?;
/// assert!(found.lower.force <= peak && peak <= found.upper && found.upper - found.lower.force < 1e-6 * peak);
/// assert!(matches!(pivot.below(1.0001 * peak)?, ForceVerdict::Holds { .. }));
/// let ForceVerdict::Fails(place) = pivot.below(0.9999 * peak)? else { panic!("it is more") };
/// assert_eq!(place.dimensions, [0.401]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # What is proved
///
/// For every input of the range, and for all dimensions and speeds within their bounds, the mechanism has one pose that
/// goes over into that of the stated assembly at the beginning of the range, and the force is below the bound. This
/// holds for closed forms and for coupled blocks alike: the poses are enclosed by Krawczyk's operator on the closure,
/// and the solvers only say where to look. Forces come from the equations of [reactions](NamedReactions), which
/// Gaussian elimination solves in interval arithmetic, after a multiplication with an approximate inverse.
///
/// A dimension without a tolerance counts as known to one unit in its last place. The numbers of the declaration, of
/// the loads and of speeds are taken as they are stored, and elementary functions are taken to be right to 8 ε.
///
/// Two things are decided in one pose in plain numbers, as for all reactions, and not proved: where drives and torques
/// act, and which joints hold the bodies.
#[derive(Clone)]
#[must_use = "say which force is meant, by `of` or `of_effort`"]
pub struct ForceProof<'r> {
    reactions: &'r NamedReactions<'r>,
    parameters: Vec<f64>,
    assembly: AssemblyChoice,
    from: Vec<f64>,
    to: Vec<f64>,
    /// The velocity and the acceleration of the first input that moves.
    velocity: [f64; 2],
    acceleration: [f64; 2],
    /// The dimensions with tolerances, by their indices.
    tolerances: Vec<(usize, f64)>,
    budget: usize,
}

/// A force of which something is to be proved.
#[derive(Clone, Debug)]
#[must_use = "ask whether it is `below` a limit, or for its `peak`"]
pub struct ProvenForce<'r> {
    proof: ForceProof<'r>,
    wanted: Wanted,
}

/// A place of a motion, and what the force there is at least.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcePlace {
    /// A number that the size of the force is not below.
    pub force: f64,
    /// The value of the first input that moves.
    pub at: f64,
    /// Its velocity and its acceleration.
    pub velocity: f64,
    /// See `velocity`.
    pub acceleration: f64,
    /// All scalar parameters, of which those with tolerances are within them.
    pub dimensions: Vec<f64>,
}

/// Bounds of the largest size of a force.
#[derive(Clone, Debug, PartialEq)]
pub struct PeakBounds {
    /// A place where the force is nearly as large as it can be.
    pub lower: ForcePlace,
    /// A number that the force exceeds nowhere.
    pub upper: f64,
    /// The number of pieces that were looked at.
    pub pieces: usize,
}

/// Whether a force stays below a limit.
#[derive(Clone, Debug, PartialEq)]
pub enum ForceVerdict {
    /// It does everywhere.
    Holds {
        /// A number that the force exceeds nowhere.
        upper: f64,
        /// The number of pieces that were looked at.
        pieces: usize,
    },
    /// It does not, certainly, at this place.
    Fails(ForcePlace),
    /// The bounds do not tell.
    Undecided(UndecidedForce),
}

/// Where bounds do not tell about a force.
#[derive(Clone, Debug, PartialEq)]
pub struct UndecidedForce {
    /// The part of the range of the first input that moves.
    pub range: [f64; 2],
    /// What the largest force is at least anywhere, and at most in this part.
    pub force: [f64; 2],
    /// What is not known there.
    pub reason: UndecidedReason,
    /// The number of pieces that were looked at.
    pub pieces: usize,
}

/// Why bounds do not tell about a force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UndecidedReason {
    /// No pose is proved: there is a limit or a change point, or one is close within the tolerances.
    Pose,
    /// There were too many pieces.
    Budget,
    /// Rounding decides, or the equations of the forces may be singular.
    Rounding,
}

impl fmt::Debug for ForceProof<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("ForceProof")
            .field("from", &self.from)
            .field("to", &self.to)
            .field("tolerances", &self.tolerances)
            .finish_non_exhaustive()
    }
}

impl<'r> ForceProof<'r> {
    pub(crate) fn new(
        reactions: &'r NamedReactions<'r>,
        parameters: &[f64],
        assembly: &AssemblyChoice,
        [from, to]: [&[f64]; 2],
        velocity: f64,
    ) -> Self {
        Self {
            reactions,
            parameters: parameters.to_vec(),
            assembly: assembly.clone(),
            from: from.to_vec(),
            to: to.to_vec(),
            velocity: [velocity; 2],
            acceleration: [0.0; 2],
            tolerances: Vec::new(),
            budget: BUDGET,
        }
    }

    /// The same, where a scalar dimension may differ by a tolerance up or down.
    ///
    /// # Errors
    /// [`ProofError::NoSuchDimension`], and [`ProofError::Tolerance`] if it is negative or not finite.
    pub fn tolerance(mut self, name: &str, tolerance: f64) -> Result<Self, ProofError> {
        let parameters = self.reactions.functions.description().parameters;
        let Some(index) = parameters.iter().position(|parameter| parameter.name == name) else {
            return Err(ProofError::NoSuchDimension {
                name: name.to_string(),
                names: parameters.iter().map(|parameter| parameter.name.to_string()).collect(),
            });
        };
        if !(tolerance >= 0.0 && tolerance.is_finite()) {
            let name = name.to_string();
            return Err(ProofError::Tolerance { name, tolerance });
        }
        self.tolerances.retain(|(own, _)| *own != index);
        if tolerance > 0.0 {
            self.tolerances.push((index, tolerance));
        }
        Ok(self)
    }

    /// The same at any speed of a range, in the direction of the motion.
    pub fn speed_within(mut self, range: impl ClosedRange) -> Self {
        let [low, high] = range.ends();
        let is_down = self.lead().is_some_and(|lead| self.to[lead] < self.from[lead]);
        self.velocity = if is_down { [-high, -low] } else { [low, high] };
        self
    }

    /// The same with any acceleration of a range, of the first input that moves. Without it, the speed is constant.
    pub fn acceleration_within(mut self, range: impl ClosedRange) -> Self {
        self.acceleration = range.ends();
        self
    }

    /// The same with another largest number of pieces. A piece takes about as long as a few hundred poses, and again as
    /// long for each tolerance.
    pub fn budget(self, budget: usize) -> Self {
        Self { budget, ..self }
    }

    /// A part of the force in a joint, by the name of the joint. What is proved is about its size.
    ///
    /// # Errors
    /// [`ProofError`] if no proof can be given: with friction, for loads on an angle that only an output has, for a
    /// motion that is not finite or stands, and those of [reactions](NamedReactions::at).
    pub fn of(self, name: &str, part: ReactionPart) -> Result<ProvenForce<'r>, ProofError> {
        let index = self.reactions.index(name)?;
        self.wanted(Wanted::Part(index, part))
    }

    /// The effort of the drive of an input.
    ///
    /// # Errors
    /// As for [`of`](Self::of).
    pub fn of_effort(self, input: usize) -> Result<ProvenForce<'r>, ProofError> {
        self.reactions.effort_of(input)?;
        self.wanted(Wanted::Effort(input))
    }

    fn wanted(mut self, wanted: Wanted) -> Result<ProvenForce<'r>, ProofError> {
        let numbers = [
            &self.parameters,
            &self.from,
            &self.to,
            &self.velocity[..],
            &self.acceleration,
        ];
        if !numbers.into_iter().flatten().all(|number| number.is_finite()) || self.lead().is_none() {
            return Err(ProofError::NoMotion);
        }
        if self.reactions.has_friction() {
            return Err(ProofError::Friction);
        }
        if self.reactions.functions.is_space() {
            return Err(ProofError::InSpace);
        }
        let mut connections = self.reactions.connections.iter();
        if let Some(own) = connections.find(|own| own.mesh.is_some_and(|mesh| mesh.has_pressure_angle())) {
            let reaction = own.name.clone();
            return Err(ProofError::PressureAngle { reaction });
        }
        if let Some(name) = self.wound_output() {
            return Err(ProofError::OutputAngle { name });
        }
        for range in [&mut self.velocity, &mut self.acceleration] {
            range.sort_unstable_by(f64::total_cmp);
        }
        Ok(ProvenForce { proof: self, wanted })
    }

    /// The first input that moves.
    fn lead(&self) -> Option<usize> {
        self.from.iter().zip(&self.to).position(|(from, to)| from != to)
    }

    /// The name of an output with a torsion spring, whose turns nothing counts.
    fn wound_output(&self) -> Option<alloc::string::String> {
        let loads: &NamedLoads = &self.reactions.loads;
        let description = self.reactions.functions.description();
        let before = description.parameters.len() + description.inputs.len() + description.unknowns.len();
        let wound = |load: &NamedLoad| match load {
            NamedLoad::TorsionSpring(_, quantity) => {
                let output = description.outputs.get(quantity.checked_sub(before)?)?;
                (output.dimension == Dimension::Angle).then(|| output.name.to_string())
            }
            _ => None,
        };
        loads.all().iter().find_map(wound)
    }
}

impl ProvenForce<'_> {
    /// Whether the size of the force stays below a limit, or at most reaches it.
    ///
    /// # Errors
    /// [`ProofError::Reaction`] if the mechanism has no pose at the beginning of the range, or if the force is not
    /// determined, and [`ProofError::Limit`] for a limit that is not a number from zero on.
    pub fn below(&self, limit: f64) -> Result<ForceVerdict, ProofError> {
        if limit.is_nan() || limit < 0.0 {
            return Err(ProofError::Limit(limit));
        }
        search::below(&self.proof, self.wanted, limit)
    }

    /// Bounds of the largest size of the force, which differ by a part of the lower one at most: 1e-3 is a permille.
    ///
    /// # Errors
    /// As for [`below`](Self::below), and [`ProofError::Undecided`].
    pub fn peak(&self, part: f64) -> Result<PeakBounds, ProofError> {
        if part.is_nan() || part < 0.0 {
            return Err(ProofError::Limit(part));
        }
        search::peak(&self.proof, self.wanted, part)
    }
}

impl fmt::Display for UndecidedForce {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [low, high] = self.range;
        match self.reason {
            UndecidedReason::Pose => write!(
                formatter,
                "from the input {} on no pose is proved: there is a limit or a change point, or the tolerances \
                 reach one",
                Digits(low)
            ),
            UndecidedReason::Budget => write!(
                formatter,
                "{} pieces do not decide: between the inputs {} and {} the force is at most {}, and it reaches {}",
                self.pieces,
                Digits(low),
                Digits(high),
                Digits(self.force[1]),
                Digits(self.force[0])
            ),
            UndecidedReason::Rounding => write!(
                formatter,
                "at the input {} rounding decides: the force is at most {} there, and it reaches {}",
                Digits(low),
                Digits(self.force[1]),
                Digits(self.force[0])
            ),
        }
    }
}
