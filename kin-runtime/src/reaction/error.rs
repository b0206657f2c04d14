//! The reasons why reactions are not found.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;
use core::error::Error;
use core::fmt;

use super::friction::FrictionMistake;
use super::rolling::RollingMistake;
use crate::failure::SolveError;
use crate::load::{LoadError, NoSuchName};
use crate::quantity::Digits;

/// The reason why a mechanism has no reactions, or why one of them is not determined.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum ReactionError {
    /// The mechanism has no pose there.
    Solve(SolveError),
    /// The loads have no forces there.
    Load(LoadError),
    /// The bodies are guessed from the equations.
    Guessed {
        /// The statements that would declare the guess.
        statements: String,
    },
    /// The axis of a hinge is not fixed to both bodies, or has no length.
    HingeTurns {
        /// The reaction.
        reaction: String,
        /// The body against which the axis turns.
        body: String,
        /// The rate at which it turns, per unit of an input.
        rate: f64,
    },
    /// No vector has the name of an axis, or no body or point that of a contact.
    NoSuchName(NoSuchName),
    /// A contact cannot roll as it is stated.
    Rolling {
        /// The reaction.
        reaction: String,
        /// What is wrong.
        mistake: RollingMistake,
    },
    /// A joint cannot have an axis: it is no ball of space.
    NoBall {
        /// The reaction.
        reaction: String,
    },
    /// The mechanism has no bodies.
    NoBodies,
    /// The points of a body do not keep their distances.
    NotRigid {
        /// The body.
        body: String,
        /// The speed of one of its joints against its first two, per unit of an input.
        rate: f64,
    },
    /// Nothing tells how a body turns: it has one joint without a slide, or its first two joints coincide.
    NoFrame {
        /// The body.
        body: String,
    },
    /// No body, or several, hold the place where a load or a drive acts.
    Place {
        /// What acts there, in a few words.
        what: String,
        /// Where it could act: none, or several places.
        places: Vec<String>,
    },
    /// No joint of space moves like the quantity on which a load or a drive acts.
    NoHinge {
        /// What acts there, in a few words.
        what: String,
        /// The joints that have one point, and no axis.
        balls: Vec<String>,
    },
    /// The joints leave bodies free to move while the inputs stand.
    Free {
        /// By how many freedoms.
        freedoms: usize,
        /// The bodies.
        bodies: Vec<String>,
        /// The equations that are no vectors, which may hold them.
        equations: Vec<String>,
        /// The joints of space that have one point, and no axis.
        balls: Vec<String>,
    },
    /// The joints hold the bodies in other positions, but not in this one: a change point or a limit.
    Singular {
        /// The smallest pivot of the equilibrium equations as a part of the largest.
        pivot: f64,
        /// The reactions that grow beyond all bounds.
        grows: Vec<String>,
    },
    /// A force has its value and two rates.
    NoSuchRate {
        /// The order that was asked for.
        order: usize,
    },
    /// No reaction has this name.
    NoSuchReaction {
        /// The name.
        name: String,
        /// The names that there are.
        names: Vec<String>,
    },
    /// The mechanism holds itself in more than one way, so that equilibrium alone does not determine the reaction.
    Undetermined {
        /// The reaction.
        reaction: String,
        /// All reactions that are not determined.
        all: Vec<String>,
    },
    /// A joint cannot have the friction that is stated for it.
    Friction {
        /// The reaction.
        reaction: String,
        /// What is wrong.
        mistake: FrictionMistake,
    },
    /// All inputs rest, and nothing says which motion friction opposes.
    AtRest,
    /// The bodies of a joint do not move against each other, so that its friction has no sense.
    NoSense {
        /// The reaction.
        reaction: String,
    },
    /// Friction holds the mechanism: no forces of joints and drives move it in this sense.
    Locked {
        /// The share of the friction up to which there are forces.
        share: f64,
        /// The reactions whose friction is largest there.
        reactions: Vec<String>,
    },
    /// The iteration for friction has not converged.
    FrictionUnsolved {
        /// The number of its steps.
        steps: usize,
        /// The factor by which each of them should contract.
        contraction: f64,
    },
    /// The forces have no derivative with respect to a dimension, as bodies are rigid and contacts roll with its
    /// present value alone.
    ThisDesignOnly {
        /// The dimension.
        dimension: String,
        /// What is wrong with another value.
        reason: Box<ReactionError>,
    },
    /// A result is not finite.
    NotFinite,
}

impl From<SolveError> for ReactionError {
    fn from(error: SolveError) -> Self {
        Self::Solve(error)
    }
}

impl From<NoSuchName> for ReactionError {
    fn from(error: NoSuchName) -> Self {
        Self::NoSuchName(error)
    }
}

impl From<LoadError> for ReactionError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}

/// Names between commas.
pub(super) struct Listed<'n>(pub(super) &'n [String]);

impl fmt::Display for Listed<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, name) in self.0.iter().enumerate() {
            write!(formatter, "{}`{name}`", if index == 0 { "" } else { ", " })?;
        }
        Ok(())
    }
}

/// Joints of space that may be hinges, with the advice how to declare one.
struct Balls<'n>(&'n [String]);

impl fmt::Display for Balls<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "bodies that share one point have a ball joint there, as {}: for a hinge, list a second point of its axis \
             in both bodies, or give the axis by `hinge`, in a file by `hinge of .. = ..;`",
            Listed(self.0)
        )
    }
}

impl fmt::Display for ReactionError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Solve(error) => write!(formatter, "{error}"),
            Self::Load(error) => write!(formatter, "{error}"),
            Self::Guessed { statements } => write!(
                formatter,
                "the declaration does not state its bodies, on which the forces in joints depend; if this is how they \
                 are joined, add\n{statements}"
            ),
            Self::HingeTurns { reaction, body, rate } => write!(
                formatter,
                "the axis of `{reaction}` turns against the body `{body}` by {} per unit of an input: give a direction \
                 that is fixed to both bodies of the joint",
                Digits(*rate)
            ),
            Self::NoSuchName(error) => write!(formatter, "{error}"),
            Self::Rolling { reaction, mistake } => write!(formatter, "the contact `{reaction}`: {mistake}"),
            Self::NoBall { reaction } => write!(
                formatter,
                "`{reaction}` cannot have an axis: that of a pin in the plane, of a slide, and of a hinge is known"
            ),
            Self::NoBodies => write!(
                formatter,
                "the mechanism has no bodies: state them, as in `body crank: 0, pin;`"
            ),
            Self::NotRigid { body, rate } => write!(
                formatter,
                "the points of the body `{body}` do not keep their distances: one moves against the others by {} per \
                 unit of an input",
                Digits(*rate)
            ),
            Self::NoFrame { body } => write!(
                formatter,
                "nothing tells how the body `{body}` turns: give it a second joint apart from its first one, or a slide"
            ),
            Self::Place { what, places } if places.is_empty() => write!(
                formatter,
                "no body holds the place of {what}: list the point among those of its body, or let a body turn like \
                 the angle"
            ),
            Self::Place { what, places } => write!(
                formatter,
                "{what} could act on each of {}, on which the forces in joints depend: {}",
                Listed(places),
                if what.starts_with("the drive") {
                    "say which by `driving`, or in a file by `drive of .. = ..;`"
                } else {
                    "let it act on a point that one body alone has"
                }
            ),
            Self::NoHinge { what, balls } => {
                write!(formatter, "no hinge and no slide moves like {what}")?;
                if balls.is_empty() {
                    Ok(())
                } else {
                    write!(formatter, ": {}", Balls(balls))
                }
            }
            Self::Free {
                freedoms,
                bodies,
                equations,
                balls,
            } => {
                write!(
                    formatter,
                    "the joints leave {} {freedoms} freedom{} while the inputs stand: ",
                    Listed(bodies),
                    if *freedoms == 1 { "" } else { "s" }
                )?;
                if !balls.is_empty() {
                    write!(formatter, "declare the joint that is missing; {}", Balls(balls))
                } else if equations.is_empty() {
                    formatter.write_str("declare the joint that is missing")
                } else {
                    write!(
                        formatter,
                        "declare the joint that is missing; if gears or racks stand for {}, say by `rolling`, in a \
                         file by `gears` or `rack`, which bodies they are",
                        Listed(equations)
                    )
                }
            }
            Self::Singular { pivot, grows } => write!(
                formatter,
                "the position is singular: towards it the forces {} grow beyond all bounds; the smallest pivot of \
                 their equations is {} of the largest",
                Listed(grows),
                Digits(*pivot)
            ),
            Self::NoSuchRate { order } => write!(
                formatter,
                "a force in a joint has the orders 0, 1 and 2, its value and two rates: there is no order {order}"
            ),
            Self::NoSuchReaction { name, names } => {
                write!(formatter, "there is no reaction `{name}`; there is {}", Listed(names))
            }
            Self::Undetermined { reaction, all } => write!(
                formatter,
                "the force `{reaction}` is not determined: the joints hold the bodies in more than one way, and \
                 equilibrium leaves open {}",
                Listed(all)
            ),
            Self::Friction { reaction, mistake } => write!(formatter, "the friction of `{reaction}`: {mistake}"),
            Self::AtRest => formatter.write_str(
                "all inputs rest, where friction takes any sense: say by `about_to_move`, or in a file by `sense \
                 of .. = forwards;`, which motion is about to begin, or leave out the rest",
            ),
            Self::NoSense { reaction } => write!(
                formatter,
                "the bodies of `{reaction}` do not move against each other, so that its friction has no sense: leave \
                 it out"
            ),
            Self::Locked { share, reactions } => write!(
                formatter,
                "friction locks the mechanism, and no drive moves it in this sense: forces are in balance up to {} of \
                 the friction that is stated, most of it at {}",
                Digits(*share),
                Listed(reactions)
            ),
            Self::FrictionUnsolved { steps, contraction } => write!(
                formatter,
                "friction and the forces that cause it are not found within {steps} steps, each of which contracts by \
                 {}",
                Digits(*contraction)
            ),
            Self::ThisDesignOnly { dimension, reason } => write!(
                formatter,
                "the forces have no derivative with respect to `{dimension}`, of which other values disagree with the \
                 bodies and contacts that are stated: {reason}"
            ),
            Self::NotFinite => write!(
                formatter,
                "a force in a joint is not finite: a mass, force or other number of a load is not finite or too large"
            ),
        }
    }
}

crate::__debug_by_display!(ReactionError);

impl Error for ReactionError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Solve(error) => Some(error),
            Self::Load(error) => Some(error),
            Self::NoSuchName(error) => Some(error),
            Self::ThisDesignOnly { reason, .. } => Some(reason),
            _ => None,
        }
    }
}
