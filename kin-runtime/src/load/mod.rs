//! Loads: the efforts of drives, equivalent inertia, energies and shaking forces, by virtual work.
//!
//! [`Loads`] lists masses, moments of inertia, gravity, forces, torques, springs and dampers. Each is tied to a point
//! or an angle of the mechanism by a function of the pose. [`balance`](Loaded::balance) of a mechanism returns the
//! [`Balance`] of a pose: what the drive of each input must give, with the first and second rates that a servo has to
//! follow, and more.
//!
//! ```
//! use kin_core::load::Loads;
//! use kin_core::prelude::*;
//!
//! mechanism! {
//!     /// Four-bar linkage in metres.
//!     pub struct Press { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
//!     input theta2: Angle;
//!     unknown theta3: Angle, theta4: Angle;
//!     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
//!
//!     output coupler: Point = r2 * cis(theta2) + r3 / 2 * cis(theta3);
//!     output tool: Point = r1 + r4 * cis(theta4);
//! }
//!
//! let press: Press = Press { r1: 0.9, r2: 0.3, r3: 0.6, r4: 0.45 };
//! let loads = Loads::<Press>::new()
//!     .gravity(Plane::new(0.0, -9.81))
//!     .mass(2.5, |pose| pose.coupler)
//!     .inertia(0.08, |pose| pose.theta3)
//!     .inertia(0.04, |pose| pose.theta4)
//!     .force(Plane::new(-120.0, 0.0), |pose| pose.tool);
//!
//! let crank = Motion::at_constant_speed(1.1, 10.0);
//! let balance = press.balance(&loads, [crank], Assembly::Open)?;
//! let [torque] = balance.efforts();
//! println!("{} N m, {} N m/s, {} N m/s²", torque.value(), torque.rate(), torque.second_rate());
//!
//! // the drive and the force pay for the change of energy
//! let [power] = balance.powers();
//! let energy = balance.kinetic_energy().rate() + balance.potential_energy().rate();
//! let paid = power.value() + balance.applied_power().value();
//! assert!((energy - paid).abs() < 1e-12 * power.value().abs());
//! # Ok::<(), kin_core::load::LoadError>(())
//! ```
//!
//! # Method
//!
//! By d'Alembert's principle, the virtual work of drives, loads and inertia forces vanishes: the drive of the input q
//! has the effort Q = Σ m a · ∂r/∂q + Σ I α ∂θ/∂q - Σ F · ∂r/∂q - Σ M ∂θ/∂q + ∂V/∂q. (H. Goldstein, C. Poole & J.
//! Safko, *Classical Mechanics*, 3rd edition, Addison-Wesley 2002, section 1.4.)
//!
//! The influence coefficients ∂r/∂q come from the solvers themselves, run once for each input over numbers that carry
//! the change with that input. Because partial derivatives by q and by time commute, this gives all their derivatives
//! by time, too. Nothing is divided by a speed, so that a start from rest and a dwell are like other poses, and closed
//! forms and Newton's method serve alike.
//!
//! # Other numbers
//!
//! Loads take the number type of the mechanism. `Loads::<Press<Local>>` balances along a [sweep](crate::sweep), where
//! an effort carries its derivatives, so that its peaks, means and sensitivities are found like those of any quantity.
//! A function of any number type serves both: `fn loads<T: Scalar>() -> Loads<Press<T>, impl Load<Press<T>>>`.
//!
//! # Names
//!
//! [`NamedLoads`] acts on points and angles by their names. A program that does not know the type of its mechanism asks
//! an [`AnySweep`](crate::linkage::AnySweep) for their efforts.
//!
//! The forces in the joints, with friction, are those of [`reaction`](crate::reaction).

mod balance;
mod coordinate;
mod dynamics;
mod error;
mod kinds;
mod loaded;
#[cfg(feature = "alloc")]
mod named;
#[cfg(feature = "alloc")]
mod plane_body;
mod system;
#[cfg(test)]
mod tests;
mod totals;
mod varying;

pub use balance::{Balance, Rates};
pub use dynamics::EquivalentInertia;
pub use error::LoadError;
#[cfg(feature = "alloc")]
pub(crate) use kinds::not_negative;
#[doc(hidden)]
pub use kinds::{BetweenPoints, Damper, Force, Inertia, Mass, OnAngle, SpaceBody, Spring, Torque};
pub use kinds::{Load, Solid};
pub use loaded::{Loaded, LoadsOf};
#[cfg(feature = "alloc")]
#[doc(hidden)]
pub use named::LoadedKind;
#[cfg(feature = "alloc")]
pub(crate) use named::{EFFORT_ENTRIES, NamedLoad, NamedMotion, PointIndex};
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
pub use named::{LoadPoint, NamedLoads, NoSuchName};
#[cfg(feature = "alloc")]
pub(crate) use plane_body::{ALONG, BodyFrame, centre_on_line};
pub use system::LoadedSystem;
#[doc(hidden)]
pub use totals::Totals;
#[doc(hidden)]
pub use varying::{VaryingNumber, VaryingVector};

use core::fmt;
use core::marker::PhantomData;

use crate::failure::SolveError;
use crate::geometry::Space;
use crate::mechanism::Mechanism;
use crate::number::Changing;

/// A number with its change along one input.
pub type Change<T = f64> = Changing<T>;

/// The pose that the functions of loads receive: that of the mechanism `M`, over numbers with their change along one
/// input. It has the fields of any pose.
pub type Moving<M> = <<M as Mechanism>::With<Change<<M as Mechanism>::Scalar>> as Mechanism>::Pose;

/// Masses, moments of inertia, gravity, forces, torques, springs and dampers on the mechanism `M`.
///
/// Points and angles are chosen by functions of the pose: `|pose| pose.tool`. Declare the points as outputs of the
/// mechanism. A fixed point is a `Plane` or a `Space`: `|_| Plane::new(0.3, 0.0)`. Forces and torques are constant, or
/// a [`Motion`](crate::Motion) in time.
///
/// Units are free, but must fit together: metres, kilograms, seconds and newtons, for example. Angles are in radians.
///
/// The list does not allocate. It depends on no dimension of the mechanism, so that one list serves all variants of a
/// design.
#[derive(Clone, Copy)]
pub struct Loads<M: Mechanism, L = ()> {
    list: L,
    gravity: Space<f64>,
    mechanism: PhantomData<fn() -> M>,
}

impl<M: Mechanism> Loads<M> {
    /// No load.
    #[must_use]
    pub fn new() -> Self {
        Self {
            list: (),
            gravity: Space::zero(),
            mechanism: PhantomData,
        }
    }
}

impl<M: Mechanism> Default for Loads<M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<M: Mechanism, L: Load<M>> fmt::Debug for Loads<M, L> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Loads")
            .field("count", &L::COUNT)
            .field("gravity", &self.gravity)
            .finish_non_exhaustive()
    }
}

impl<M: Mechanism, L> Loads<M, L> {
    fn and<H>(self, load: H) -> Loads<M, (L, H)> {
        Loads {
            list: (self.list, load),
            gravity: self.gravity,
            mechanism: PhantomData,
        }
    }

    /// The acceleration of gravity, a `Plane` or `Space`. It acts on all masses, wherever they stand in the list.
    #[must_use]
    pub fn gravity(mut self, acceleration: impl VaryingVector<f64>) -> Self {
        self.gravity = acceleration.entry(0);
        self
    }

    /// A mass at a point: the centre of mass of a link or of a slider. A negative mass is an error of the
    /// [balance](Loaded::balance).
    #[must_use]
    pub fn mass<P, F>(self, mass: f64, point: F) -> Loads<M, (L, Mass<F>)>
    where
        P: VaryingVector<Change<M::Scalar>>,
        F: Fn(Moving<M>) -> P + Copy,
    {
        self.and(Mass { mass, point })
    }

    /// The moment of inertia of a link of the plane about its centre of mass, or of a rotor about its axis, with the
    /// angle by which it turns. Its axis is z; the direction matters for the shaking moment alone.
    #[must_use]
    pub fn inertia<P, F>(self, inertia: f64, angle: F) -> Loads<M, (L, Inertia<F>)>
    where
        P: VaryingNumber<Change<M::Scalar>>,
        F: Fn(Moving<M>) -> P + Copy,
    {
        self.inertia_about(Space::new(0.0, 0.0, 1.0), inertia, angle)
    }

    /// The moment of inertia of a rotor about an axis of fixed direction in space, a unit vector.
    #[must_use]
    pub fn inertia_about<P, F>(self, axis: Space<f64>, inertia: f64, angle: F) -> Loads<M, (L, Inertia<F>)>
    where
        P: VaryingNumber<Change<M::Scalar>>,
        F: Fn(Moving<M>) -> P + Copy,
    {
        self.and(Inertia {
            moment: inertia,
            axis,
            angle,
        })
    }

    /// A rigid body in space, which moves with three of its points.
    ///
    /// ```
    /// use kin_core::load::{Loads, Solid};
    /// use kin_core::prelude::*;
    ///
    /// mechanism! {
    ///     /// A plate on a shaft along z.
    ///     pub struct Plate { pub arm: Length }
    ///     input turn: Angle;
    ///     unknown follower: Angle;
    ///     follower == turn;
    ///     output hub: Point3 = vec3(0 * arm, 0 * arm, 0 * arm);
    ///     output rim: Point3 = rot_z(turn) * vec3(arm, 0 * arm, 0 * arm);
    ///     output top: Point3 = vec3(0 * arm, 0 * arm, arm);
    /// }
    ///
    /// let plate: Plate = Plate { arm: 0.5 };
    /// // the second axis of its frame is that of the shaft
    /// let solid = Solid {
    ///     mass: 4.0,
    ///     centre: Space::new(0.1, 0.0, 0.0),
    ///     inertia: [[0.1, 0.0, 0.0], [0.0, 0.15, 0.0], [0.0, 0.0, 0.06]],
    /// };
    /// let loads = Loads::<Plate>::new().body(solid, |pose| [pose.hub, pose.rim, pose.top]);
    /// let felt = plate.equivalent_inertia(&loads, [0.7])?;
    /// // Steiner's theorem
    /// assert!((felt.matrix[0][0] - (0.15 + 4.0 * 0.1 * 0.1)).abs() < 1e-15);
    /// # Ok::<(), kin_core::load::LoadError>(())
    /// ```
    #[must_use]
    pub fn body<P, F>(self, solid: Solid, points: F) -> Loads<M, (L, SpaceBody<F>)>
    where
        P: VaryingVector<Change<M::Scalar>>,
        F: Fn(Moving<M>) -> [P; 3] + Copy,
    {
        self.and(SpaceBody { solid, points })
    }

    /// A force at a point. A force that changes in time is a `Motion` with at least two derivatives fewer than the
    /// mechanism.
    #[must_use]
    pub fn force<V, P, F>(self, force: V, point: F) -> Loads<M, (L, Force<V, F>)>
    where
        V: VaryingVector<M::Scalar>,
        P: VaryingVector<Change<M::Scalar>>,
        F: Fn(Moving<M>) -> P + Copy,
    {
        const { assert!(has_rates::<M>(V::ENTRIES), "a force needs its derivatives") };
        self.and(Force { force, point })
    }

    /// A torque on a link, positive in the direction of its angle, or a force on a slider, positive in the direction of
    /// its distance.
    #[must_use]
    pub fn torque<V, P, F>(self, torque: V, angle: F) -> Loads<M, (L, Torque<V, F>)>
    where
        V: VaryingNumber<M::Scalar>,
        P: VaryingNumber<Change<M::Scalar>>,
        F: Fn(Moving<M>) -> P + Copy,
    {
        const { assert!(has_rates::<M>(V::ENTRIES), "a torque needs its derivatives") };
        self.and(Torque { torque, angle })
    }

    /// A spring between two points, with the given stiffness and length at rest.
    #[must_use]
    pub fn spring<P, Q, F, G>(
        self,
        stiffness: f64,
        rest: f64,
        from: F,
        to: G,
    ) -> Loads<M, (L, BetweenPoints<Spring, F, G>)>
    where
        P: VaryingVector<Change<M::Scalar>>,
        Q: VaryingVector<Change<M::Scalar>>,
        F: Fn(Moving<M>) -> P + Copy,
        G: Fn(Moving<M>) -> Q + Copy,
    {
        let kind = Spring { stiffness, rest };
        self.and(BetweenPoints { kind, from, to })
    }

    /// A damper between two points: its force is the given constant times the rate of its length.
    #[must_use]
    pub fn damper<P, Q, F, G>(self, damping: f64, from: F, to: G) -> Loads<M, (L, BetweenPoints<Damper, F, G>)>
    where
        P: VaryingVector<Change<M::Scalar>>,
        Q: VaryingVector<Change<M::Scalar>>,
        F: Fn(Moving<M>) -> P + Copy,
        G: Fn(Moving<M>) -> Q + Copy,
    {
        let kind = Damper { damping };
        self.and(BetweenPoints { kind, from, to })
    }

    /// A spring that acts on an angle, with its angle at rest, or on the distance of a slider.
    #[must_use]
    pub fn torsion_spring<P, F>(self, stiffness: f64, rest: f64, angle: F) -> Loads<M, (L, OnAngle<Spring, F>)>
    where
        P: VaryingNumber<Change<M::Scalar>>,
        F: Fn(Moving<M>) -> P + Copy,
    {
        let kind = Spring { stiffness, rest };
        self.and(OnAngle { kind, angle })
    }

    /// A damper that acts on an angle, or on the distance of a slider.
    #[must_use]
    pub fn torsion_damper<P, F>(self, damping: f64, angle: F) -> Loads<M, (L, OnAngle<Damper, F>)>
    where
        P: VaryingNumber<Change<M::Scalar>>,
        F: Fn(Moving<M>) -> P + Copy,
    {
        let kind = Damper { damping };
        self.and(OnAngle { kind, angle })
    }
}

/// Whether a force with so many entries has as many rates as an effort.
const fn has_rates<M: Mechanism>(entries: usize) -> bool {
    entries.saturating_add(2) >= coordinate::entries::<M>()
}

impl<M: Mechanism, L: Load<M>> LoadsOf<M> for Loads<M, L> {
    fn balance(
        &self,
        mechanism: &M,
        inputs: M::Inputs<M::Motion<M::Scalar>>,
        solve: impl Fn(&totals::ChangingMechanism<M>, totals::ChangingInputs<M>) -> Result<Moving<M>, SolveError>,
    ) -> Result<Balance<M>, LoadError> {
        let poses = totals::poses(mechanism, inputs, solve)?;
        let mut totals = Totals::new(poses, self.gravity);
        self.list.add(&mut totals)?;
        if totals.are_finite() {
            Ok(Balance::new(inputs, &totals))
        } else {
            Err(LoadError::NotFinite)
        }
    }
}
