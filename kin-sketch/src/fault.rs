//! What keeps a drawing from being a mechanism.

use std::error::Error;
use std::fmt;

/// What keeps a drawing from being a mechanism. The message of `Display` says what to change.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SketchFault {
    /// A link, a slide, a drive or the ground names a part that does not exist.
    Missing(String),
    /// A part cannot have its name.
    Name(String),
    /// A coordinate or a direction is not finite.
    NotFinite(String),
    /// A part is drawn in a way that means nothing.
    Meaningless(String),
    /// No joint connects these links with the ground.
    Loose(Vec<String>),
    /// The drawing moves in more ways than it has drives. The links named move although all drives stand still.
    NeedsDrives {
        /// The number of ways in which the drawing moves.
        freedom: usize,
        /// The number of drives.
        drives: usize,
        /// The links that move although all drives stand still.
        undetermined: Vec<String>,
    },
    /// The drawing moves in fewer ways than it has drives.
    TooManyDrives {
        /// The number of ways in which the drawing moves.
        freedom: usize,
        /// The number of drives.
        drives: usize,
    },
    /// Some equations repeat others: the drawing moves only because its lengths happen to fit.
    Overconstrained {
        /// The number of equations that follow from the others.
        redundant: usize,
        /// The links each of which can be removed without another motion.
        removable: Vec<String>,
    },
    /// The drives do not determine the motion in the pose that is drawn, a limit position or a change point.
    DeadPoint {
        /// The links that move although all drives stand still.
        undetermined: Vec<String>,
    },
}

impl fmt::Display for SketchFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing(message) | Self::Name(message) | Self::NotFinite(message) | Self::Meaningless(message) => {
                f.write_str(message)
            }
            Self::Loose(links) => write!(
                f,
                "no joint connects {} with the ground: give one of its points to another link, or fix it",
                listed(links)
            ),
            Self::NeedsDrives {
                freedom,
                drives,
                undetermined,
            } => {
                write!(
                    f,
                    "the drawing moves in {} and has {}",
                    counted(*freedom, "way"),
                    counted(*drives, "drive")
                )?;
                if !undetermined.is_empty() {
                    write!(f, "; {} can move while the drives stand still", listed(undetermined))?;
                }
                f.write_str(": add a drive, or a link")
            }
            Self::TooManyDrives { freedom: 0, .. } => f.write_str("the drawing cannot move: remove a link"),
            Self::TooManyDrives { freedom, drives } => write!(
                f,
                "the drawing moves in {} and has {}: remove a drive",
                counted(*freedom, "way"),
                counted(*drives, "drive")
            ),
            Self::Overconstrained { redundant, removable } => {
                write!(
                    f,
                    "the drawing moves only because its lengths fit: {} from the others",
                    match redundant {
                        1 => "one equation follows".to_owned(),
                        count => format!("{count} equations follow"),
                    }
                )?;
                match &removable[..] {
                    [] => f.write_str("; remove a link that only supports the others"),
                    [link] => write!(f, "; remove {link}, and nothing moves differently"),
                    links => write!(
                        f,
                        "; remove one of these, and nothing moves differently: {}",
                        links.join(", ")
                    ),
                }
            }
            Self::DeadPoint { undetermined } => write!(
                f,
                "in the pose that is drawn the drives do not move {}: draw the linkage a little further",
                listed(undetermined)
            ),
        }
    }
}

impl Error for SketchFault {}

fn counted(count: usize, word: &str) -> String {
    match count {
        0 => format!("no {word}"),
        1 => format!("one {word}"),
        _ => format!("{count} {word}s"),
    }
}

fn listed(names: &[String]) -> String {
    match names {
        [] => "the links".to_owned(),
        [one] => one.clone(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}
