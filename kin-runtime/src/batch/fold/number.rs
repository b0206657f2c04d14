//! The numbers of a pose that a fold summarises.

use core::error::Error;
use core::fmt;

use crate::batch::outcome::LengthMismatch;
use crate::batch::target::Slot;
use crate::mechanism::Description;
use crate::quantity::Quantity;

/// A number of a pose that a [`Fold`](super::Fold) summarises.
///
/// ```
/// use kin_core::Mechanism;
/// use kin_core::batch::{FoldedNumber, Slot};
/// use kin_core::library::FourBar;
///
/// let description = FourBar::<f64>::DESCRIPTION;
/// let snap = FoldedNumber::named(&description, "theta4", 4);
/// assert_eq!(snap, Some(FoldedNumber::At(Slot::Unknown(1, 4))));
/// assert_eq!(FoldedNumber::named(&description, "theta5", 4), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FoldedNumber {
    /// An input, an unknown or an output, or a derivative of one. The sine of an unknown that is not a direction exists
    /// in no pose.
    At(Slot),
    /// The transmission angle of a dyad, folded to at most a right angle, by the index of the dyad in the order of
    /// [`Mechanism::transmission_angles`](crate::Mechanism::transmission_angles).
    TransmissionAngle(usize),
    /// The smallest transmission angle of all dyads, each folded to at most a right angle.
    SmallestTransmissionAngle,
}

impl From<Slot> for FoldedNumber {
    fn from(slot: Slot) -> Self {
        Self::At(slot)
    }
}

impl FoldedNumber {
    /// The derivative of this order of the input, the unknown or the output with this name, if the mechanism has it.
    /// Order 0 is the position.
    #[must_use]
    pub fn named(description: &Description<'_>, name: &str, order: usize) -> Option<Self> {
        let index_in = |quantities: &[Quantity<'_>]| quantities.iter().position(|quantity| quantity.name == name);
        let slot = if let Some(input) = index_in(description.inputs) {
            Slot::Input(input, order)
        } else if let Some(unknown) = index_in(description.unknowns) {
            Slot::Unknown(unknown, order)
        } else {
            Slot::Output(index_in(description.outputs)?, order)
        };
        (order <= description.order).then_some(Self::At(slot))
    }

    /// Whether a mechanism with so many dyads has this number.
    pub(super) fn is_of(self, description: &Description<'_>, dyads: usize) -> bool {
        match self {
            Self::At(slot) => {
                let (quantities, index, order) = match slot {
                    Slot::Input(index, order) => (description.inputs, index, order),
                    Slot::Unknown(index, order) => (description.unknowns, index, order),
                    Slot::Sine(index) => (description.unknowns, index, 0),
                    Slot::Output(index, order) => (description.outputs, index, order),
                };
                index < quantities.len() && order <= description.order
            }
            Self::TransmissionAngle(dyad) => dyad < dyads,
            Self::SmallestTransmissionAngle => dyads > 0,
        }
    }
}

/// The error for a fold that cannot be started.
#[derive(Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FoldError {
    /// A column has another length than there are poses.
    Length(LengthMismatch),
    /// The mechanism does not have this number.
    NoSuchNumber {
        /// The number.
        number: FoldedNumber,
    },
    /// The mechanism does not have the input of the grid.
    NoSuchInput {
        /// The index of the input.
        input: usize,
    },
}

impl From<LengthMismatch> for FoldError {
    fn from(mismatch: LengthMismatch) -> Self {
        Self::Length(mismatch)
    }
}

impl fmt::Display for FoldError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(LengthMismatch {
                quantity,
                poses,
                length,
            }) => write!(
                formatter,
                "a column of `{quantity}` has {length} entries, but {poses} poses are folded: give one entry for each \
                 pose"
            ),
            Self::NoSuchNumber { number } => write!(
                formatter,
                "the mechanism has no number {number:?}: its description lists the quantities and the order"
            ),
            Self::NoSuchInput { input } => write!(
                formatter,
                "the mechanism has no input {input} that could vary: inputs count from 0, as in its description"
            ),
        }
    }
}

crate::__debug_by_display!(FoldError);

impl Error for FoldError {}
