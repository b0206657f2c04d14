//! Friction in joints as it is stated, and the sense in which it acts.

use alloc::string::ToString;
use alloc::vec::Vec;
use core::fmt;

use super::action::{AGREEMENT, Influence, TERMS};
use super::connection::{Connection, Member};
use super::frames::{MovedFrame, MovedMechanism, slope_of};
use super::pose_number::{SinglePose, values};
use super::{MovedIn, MovedNumber, NamedReactions, REACH, ReactionError, ReactionPlace};
use crate::law::Side;
use crate::number::Number;
use crate::number::series::{Series, SeriesOf};
use crate::picture::Outline;

/// Coulomb friction in a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Friction {
    /// In a pin: the moment μ r |F| of a force F in it.
    Pin {
        /// The coefficient μ.
        coefficient: f64,
        /// The radius r of the pin.
        radius: f64,
    },
    /// On a slide: the force μ |N| of a normal force N.
    ///
    /// A bushing of length L that has a moment M carries it by two forces N/2 ± M/L at its ends, and the friction is
    /// that of both.
    Slide {
        /// The coefficient μ.
        coefficient: f64,
        /// The length L of the bushing; without it, a moment causes no friction.
        length: Option<f64>,
    },
}

/// What is wrong in the statement of a friction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FrictionMistake {
    /// The coefficient is negative or not finite.
    Coefficient(f64),
    /// The radius of a pin is not above zero, or not finite.
    Radius(f64),
    /// The length of a bushing is not above zero, or not finite.
    Length(f64),
    /// The joint is a slide, and the friction that of a pin.
    IsSlide,
    /// The joint is a pin, and the friction that of a slide.
    IsPin,
    /// The joint has friction already.
    Twice,
    /// The joint is a contact that rolls.
    Rolls,
    /// The mechanism is one of space.
    InSpace,
}

impl fmt::Display for FrictionMistake {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coefficient(value) => write!(formatter, "the coefficient is {value}: give one from zero on"),
            Self::Radius(value) => write!(formatter, "the radius is {value}: give one above zero"),
            Self::Length(value) => write!(formatter, "the length is {value}: give one above zero"),
            Self::IsSlide => formatter.write_str("it is a slide, which has no radius: give the friction of a slide"),
            Self::IsPin => {
                formatter.write_str("it is a pin, whose friction needs its radius: give the friction of a pin")
            }
            Self::Twice => formatter.write_str("it has friction already: state it once"),
            Self::Rolls => formatter.write_str("it rolls, and friction is that of a pin or a slide"),
            Self::InSpace => formatter.write_str("friction is found in the plane, and the mechanism is one of space"),
        }
    }
}

impl Friction {
    pub(super) fn coefficient(self) -> f64 {
        match self {
            Self::Pin { coefficient, .. } | Self::Slide { coefficient, .. } => coefficient,
        }
    }

    fn mistake(self, is_slide: bool) -> Option<FrictionMistake> {
        let coefficient = self.coefficient();
        let is_size = |value: f64| value.is_finite() && value > 0.0;
        match self {
            Self::Pin { .. } if is_slide => Some(FrictionMistake::IsSlide),
            Self::Slide { .. } if !is_slide => Some(FrictionMistake::IsPin),
            _ if !coefficient.is_finite() || coefficient < 0.0 => Some(FrictionMistake::Coefficient(coefficient)),
            Self::Pin { radius, .. } if !is_size(radius) => Some(FrictionMistake::Radius(radius)),
            Self::Slide {
                length: Some(length), ..
            } if !is_size(length) => Some(FrictionMistake::Length(length)),
            _ => None,
        }
    }
}

/// Friction that acts.
#[derive(Clone, Copy, Debug)]
pub(super) struct ActingFriction<T> {
    pub(super) connection: usize,
    pub(super) friction: Friction,
    /// The sense of the motion of the body on which the reaction acts, against the one that exerts it: 1 or -1.
    pub(super) sense: f64,
    /// The rate of this motion by the variable.
    pub(super) rate: T,
    /// The speed of the motion that gives the sense; at rest, of the one that is about to begin.
    pub(super) speed: f64,
}

/// The motion by which all inputs leave a place where they stand.
pub(super) struct Beginning {
    pub(super) inputs: Vec<MovedNumber>,
    pub(super) by_time: f64,
    side: Side,
}

/// A rate below this part of the largest is zero up to rounding, and the next term of the motion counts. It is no more
/// than rounding, as places next to the end of a stretch, where its side counts, are 16 ε of the variable away from it.
const NO_RATE: f64 = 8.0 * f64::EPSILON;
/// The same for terms of rates, which are less precise.
const NO_TERM: f64 = 1e-9;

impl NamedReactions<'_> {
    /// The same with friction in a joint, by the name of its reaction.
    ///
    /// ```
    /// use kin_core::any::PositionChoice;
    /// use kin_core::linkage::AnyLinkage;
    /// use kin_core::prelude::*;
    /// use kin_core::reaction::Friction;
    ///
    /// mechanism! {
    ///     /// A load on an incline, in metres.
    ///     struct Incline { angle: Angle }
    ///     input s: Length;
    ///     unknown x: Length;
    ///     x == s * cos(angle);
    ///     output block: Point = polar(s, angle);
    ///     ground vec2(0, 0);
    ///     body load: block;
    ///     slide block along cis(angle);
    /// }
    ///
    /// let incline = Incline { angle: 0.2 };
    /// let linkage = AnyLinkage::of(&incline);
    /// let weight = linkage.loads().force(Plane::new(0.0, -50.0), "block")?;
    /// let friction = Friction::Slide { coefficient: 0.3, length: None };
    /// let reactions = linkage.reactions(&weight)?.friction("block", friction)?;
    /// let rest = [Motion::at_constant_speed(0.1, 0.0)];
    /// // the load breaks away upwards, and must be pushed downwards: 0.2 < arctan 0.3
    /// for sense in [1.0, -1.0] {
    ///     let force = 50.0 * (0.2_f64.sin() + sense * 0.3 * 0.2_f64.cos());
    ///     let about_to_move = reactions.clone().about_to_move(&[sense]);
    ///     let found = about_to_move.at(&rest, PositionChoice::Assembly(0))?;
    ///     let [effort, ..] = found.effort(0).ok_or("no effort")?;
    ///     assert!((effort - force).abs() < 1e-13);
    ///     assert_eq!(found.efficiency().is_some_and(|efficiency| efficiency.is_locked()), sense < 0.0);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ReactionError::NoSuchReaction`], and [`ReactionError::Friction`] for a friction that the joint cannot have.
    pub fn friction(mut self, name: &str, friction: Friction) -> Result<Self, ReactionError> {
        let index = self.index(name)?;
        let is_twice = self.frictions.iter().any(|(connection, _)| *connection == index);
        let mistake = friction.mistake(self.connections[index].slide.is_some());
        let mistake = mistake.or(is_twice.then_some(FrictionMistake::Twice));
        let mistake = self
            .functions
            .is_space()
            .then_some(FrictionMistake::InSpace)
            .or(self.connections[index].mesh.map(|_| FrictionMistake::Rolls))
            .or(mistake);
        if let Some(mistake) = mistake {
            let reaction = name.to_string();
            return Err(ReactionError::Friction { reaction, mistake });
        }
        // without a coefficient, no sense is needed
        if friction.coefficient() > 0.0 {
            self.frictions.push((index, friction));
            self.solutions.forget();
        }
        Ok(self)
    }

    /// The same with friction in several joints.
    ///
    /// # Errors
    /// As for [`friction`](Self::friction).
    pub fn frictions<N: AsRef<str>>(self, all: impl IntoIterator<Item = (N, Friction)>) -> Result<Self, ReactionError> {
        let mut all = all.into_iter();
        all.try_fold(self, |reactions, (name, friction)| {
            reactions.friction(name.as_ref(), friction)
        })
    }

    /// The same, where friction opposes a motion with these rates of the inputs wherever all of them rest: the efforts
    /// are those at which this motion is about to begin. Missing rates are zero. Inputs that stand for a moment, as
    /// where a law begins, have a motion.
    #[must_use]
    pub fn about_to_move(mut self, rates: &[f64]) -> Self {
        self.about_to_move = Some(rates.to_vec());
        self.solutions.forget();
        self
    }

    /// Whether any joint has friction.
    #[must_use]
    pub fn has_friction(&self) -> bool {
        !self.frictions.is_empty()
    }

    /// The number of joints with friction.
    pub(crate) fn joints_with_friction(&self) -> usize {
        self.frictions.len()
    }

    /// The speed of the motion in a joint with friction, by its place among them.
    pub(crate) fn joint_speed(&self, place: &ReactionPlace<'_>, index: usize) -> Result<MovedNumber, ReactionError> {
        let (moved, frames) = place.moving(&place.functions.outline(), &self.connections)?;
        let rate = relative_rate(&self.connections[self.frictions[index].0], &moved, &frames);
        Ok(rate * Series::constant(place.rate))
    }

    /// The motion that gives friction its sense where all inputs stand for a moment, or rest.
    pub(super) fn beginning(&self, place: &ReactionPlace<'_>) -> Result<Option<Beginning>, ReactionError> {
        let moves = |order: &usize| place.inputs.iter().any(|input| input.coefficients()[*order] != 0.0);
        let order = (1..REACH).find(moves);
        let rates: Vec<f64> = match (order, &self.about_to_move) {
            (Some(1), _) => return Ok(None),
            // the way of the inputs is straight there, whatever the power of the variable is with which they begin
            (Some(order), _) => place.inputs.iter().map(|input| input.coefficients()[order]).collect(),
            (None, Some(rates)) => rates.clone(),
            (None, None) => return Err(ReactionError::AtRest),
        };
        let inputs = place.inputs.iter().enumerate().map(|(input, value)| {
            let mut terms = [0.0; REACH];
            (terms[0], terms[1]) = (value.real(), rates.get(input).copied().unwrap_or(0.0));
            Series::from_coefficients(terms)
        });
        // before an even power, the inputs come back on the way on which they go
        let returns = place.side == Side::Left && order.is_some_and(|order| order.is_multiple_of(2));
        Ok(Some(Beginning {
            inputs: inputs.collect(),
            by_time: place.rate * if returns { -1.0 } else { 1.0 },
            side: if returns || order.is_none() {
                Side::Right
            } else {
                place.side
            },
        }))
    }

    /// All friction that acts in a motion, with its sense.
    pub(super) fn acting<S: SinglePose>(
        &self,
        place: &ReactionPlace<'_>,
        outline: &Outline<'_>,
        (moved, frames): (&MovedMechanism<MovedIn<S>>, &[MovedFrame<MovedIn<S>>]),
        stand: &[bool],
    ) -> Result<Vec<ActingFriction<MovedIn<S>>>, ReactionError> {
        if self.frictions.is_empty() {
            return Ok(Vec::new());
        }
        let beginning = self.beginning(place)?;
        let begun = beginning.as_ref().map(|beginning| {
            let moved = place.moved(place.parameters, &beginning.inputs)?;
            let frames = moved.frames(outline, &self.connections)?;
            Ok::<_, ReactionError>((moved, frames))
        });
        let begun = begun.transpose()?;
        let (by_time, side) = beginning.map_or((place.rate, place.side), |one| (one.by_time, one.side));
        let all = self.frictions.iter().zip(stand).map(|((index, friction), stands)| {
            let own = &self.connections[*index];
            let rate = relative_rate(own, moved, frames);
            let (begun_rate, sizes) = match &begun {
                Some((moved, frames)) => (relative_rate(own, moved, frames), sizes(own, moved, frames)),
                None => (values(rate), sizes(own, moved, frames)),
            };
            let sense = sense(begun_rate, sizes, by_time, side);
            // what never moves has no sense, whatever rounding makes of it
            let sense = sense.filter(|_| !stands);
            let sense = sense.ok_or_else(|| ReactionError::NoSense {
                reaction: own.name.clone(),
            })?;
            Ok(ActingFriction {
                connection: *index,
                friction: *friction,
                sense,
                rate,
                speed: begun_rate.real() * by_time,
            })
        });
        all.collect()
    }
}

/// The rate by the variable at which one body of a connection moves against the other: it turns in a pin, and slides on
/// a slide.
fn relative_rate<S: SinglePose, const N: usize>(
    own: &Connection,
    moved: &MovedMechanism<SeriesOf<S, N>>,
    frames: &[MovedFrame<SeriesOf<S, N>>],
) -> SeriesOf<S, N> {
    let nothing = SeriesOf::constant(0.0);
    let (Some(slide), Some(joint)) = (own.slide, own.joint) else {
        let turn = |member: Member| member.map_or(nothing, |body| frames[body].turn.z);
        return turn(own.on) - turn(own.by);
    };
    let at = moved.places[joint];
    let along = |member: Member| {
        let velocity = member.map(|body| frames[body].velocity(at));
        velocity.map_or(nothing, |velocity| moved.along(slide).dot(velocity))
    };
    along(own.on) - along(own.by)
}

/// The largest terms of the rates of the same kind.
fn sizes<S: SinglePose, const N: usize>(
    own: &Connection,
    moved: &MovedMechanism<SeriesOf<S, N>>,
    frames: &[MovedFrame<SeriesOf<S, N>>],
) -> [f64; N] {
    let mut sizes = [0.0_f64; N];
    let mut add = |rate: SeriesOf<S, N>| {
        for (size, term) in sizes.iter_mut().zip(rate.coefficients()) {
            *size = size.max(term.real().abs());
        }
    };
    if own.slide.is_none() {
        for frame in frames {
            add(frame.turn.z);
        }
    } else {
        for joint in &moved.places[..moved.joints] {
            let velocity = slope_of(*joint);
            add(velocity.x);
            add(velocity.y);
        }
    }
    sizes
}

/// Whether the bodies of a connection do not move against each other while an input moves alone.
pub(super) fn stands<const N: usize>(own: &Connection, one: &Influence<N>) -> bool {
    let rate = relative_rate(own, &one.moved, &one.frames).coefficients();
    let sizes = sizes(own, &one.moved, &one.frames);
    let largest = sizes.into_iter().take(TERMS).fold(0.0, f64::max);
    rate.into_iter()
        .take(TERMS)
        .all(|term| term.abs() <= AGREEMENT * largest)
}

/// The sign of a rate; where it is zero, of its values beside it.
fn sense<const N: usize>(rate: Series<N>, sizes: [f64; N], by_time: f64, side: Side) -> Option<f64> {
    let terms = rate.coefficients().into_iter().zip(sizes).enumerate();
    let mut terms = terms.filter(|(order, (term, size))| {
        let least = if *order == 0 { NO_RATE } else { NO_TERM };
        term.abs() > least * size
    });
    terms.next().map(|(order, (term, _))| {
        let is_turned = side == Side::Left && !order.is_multiple_of(2);
        term.signum() * by_time.signum() * if is_turned { -1.0 } else { 1.0 }
    })
}
