//! Loads on a linkage without its type, and the forces in its joints.

use super::AnyLinkage;
use crate::any::Outline;
use crate::load::NamedLoads;
use crate::reaction::{NamedReactions, ReactionError};

impl<'m> AnyLinkage<'m> {
    /// Its bodies and joints.
    #[must_use]
    pub fn outline(&self) -> Outline<'m> {
        self.functions.outline()
    }

    /// No load on its points, angles and bodies: add some.
    #[must_use]
    pub fn loads(&self) -> NamedLoads {
        NamedLoads::new(self.description()).with_bodies(&self.outline())
    }

    /// The forces in its joints under loads: see [`reaction`](crate::reaction).
    ///
    /// # Errors
    /// [`ReactionError::Guessed`] if the declaration does not state its bodies; it shows the statements to add. And
    /// [`ReactionError::NoBodies`].
    pub fn reactions(&self, loads: &NamedLoads) -> Result<NamedReactions<'m>, ReactionError> {
        NamedReactions::new(self.functions, &self.parameters, loads, false)
    }

    /// The forces in its joints, as [`reactions`](Self::reactions) finds them, where its bodies may be guessed from the
    /// equations. Look at the [guess](Outline::guess): a body that the guess divides, or a joint that it does not see,
    /// changes the forces.
    ///
    /// # Errors
    /// [`ReactionError::NoBodies`].
    pub fn reactions_as_guessed(&self, loads: &NamedLoads) -> Result<NamedReactions<'m>, ReactionError> {
        NamedReactions::new(self.functions, &self.parameters, loads, true)
    }
}
