//! What friction leaves of the power of the drives.

/// Powers of drives and of friction: in a pose, or their means along a motion.
///
/// ```
/// use kin_core::reaction::Efficiency;
///
/// let lifting = Efficiency { input: 10.0, heat: 4.0 };
/// assert_eq!((lifting.output(), lifting.ratio()), (6.0, Some(0.6)));
/// // a load that sinks, and drives the drive
/// let sinking = Efficiency { input: -3.0, heat: 2.0 };
/// assert_eq!((sinking.output(), sinking.ratio()), (-5.0, Some(0.6)));
/// // a load that would sink, if friction did not hold it
/// let held = Efficiency { input: 1.0, heat: 4.0 };
/// assert!(held.is_locked() && held.ratio() == Some(-3.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Efficiency {
    /// The power of all drives; below zero if loads drive them.
    pub input: f64,
    /// The power that friction turns into heat.
    pub heat: f64,
}

/// A power is zero if it is at most this part of the others.
const NO_POWER: f64 = 1e-12;

impl Efficiency {
    /// The power that is left: what loads take and what is stored, and nothing stays stored over a cycle.
    #[must_use]
    pub fn output(&self) -> f64 {
        self.input - self.heat
    }

    /// The part of the power that passes the joints: from drives to loads, or from loads to drives where these drive.
    /// It is zero or less if drives and loads both feed friction, as where it [locks](Self::is_locked). None if nothing
    /// has power.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        let output = self.output();
        let [part, whole] = if self.input < 0.0 {
            [self.input, output]
        } else {
            [output, self.input]
        };
        let ratio = part / whole;
        ratio.is_finite().then_some(ratio)
    }

    /// Whether the loads push in the sense of the motion, and the drives must push too: without them, friction holds
    /// the mechanism.
    #[must_use]
    pub fn is_locked(&self) -> bool {
        self.input >= 0.0 && self.output() < -NO_POWER * (self.input + self.heat)
    }
}
