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
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::any::{AssemblyChoice, PositionChoice};
    /// use kin_core::extremes::Over;
    /// use kin_core::linkage::AnyLinkage;
    /// use kin_core::prelude::*;
    /// use kin_core::reaction::ReactionPart;
    ///
    /// mechanism! {
    ///     /// Four-bar linkage in metres.
    ///     pub struct Press { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
    ///     input theta2: Angle;
    ///     unknown theta3: Angle, theta4: Angle;
    ///     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    ///     output pin: Point = r2 * cis(theta2);
    ///     output knee: Point = r1 + r4 * cis(theta4);
    ///     output pivot: Point = vec2(r1, 0);
    ///
    ///     ground 0, pivot;
    ///     body crank: 0, pin;
    ///     body coupler: pin, knee;
    ///     body rocker: pivot, knee;
    /// }
    ///
    /// let press: Press = Press { r1: 0.4, r2: 0.12, r3: 0.36, r4: 0.28 };
    /// let linkage = AnyLinkage::of(&press);
    /// let loads = linkage
    ///     .loads()
    ///     .gravity(Plane::new(0.0, -9.81))
    ///     .mass_of("coupler", 1.4, Plane::new(0.18, 0.02), 0.016)?
    ///     .mass_of("rocker", 0.9, Plane::new(0.14, 0.0), 0.006)?
    ///     .torque(-30.0, "theta4")?;
    /// let reactions = linkage.reactions(&loads)?;
    ///
    /// // in a pose: each value stands with its rate and its second rate
    /// let crank = Motion::at_constant_speed(1.0, rpm(120.0));
    /// let found = reactions.at(&[crank], PositionChoice::Assembly(0))?;
    /// for (name, force) in found.all() {
    ///     let [size, rate, _] = force?.magnitude();
    ///     println!("{name}: {size:.1} N, {rate:.0} N/s");
    /// }
    /// let [torque, ..] = found.effort(0).ok_or("no effort")?;
    /// println!("{torque:.2} N m at the crank");
    ///
    /// // along a motion: the peak, and the mean that a bearing feels
    /// let turn = linkage.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[TAU], 361).speed(rpm(120.0));
    /// let knee = turn.of_reaction(&reactions, "knee", ReactionPart::Force, 0);
    /// println!("{} N, {} N in the mean", knee.peak()?, knee.rms(Over::Time)?.value);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
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
