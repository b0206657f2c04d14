//! The kinematics of mechanisms in the plane and in space: from loop closures to position, velocity, acceleration, jerk
//! and snap.
//!
//! [`mechanism!`] takes the loop closure of a mechanism as you would write it on a blackboard. At compile time it finds
//! out how to solve the closure, differentiates it, and generates a position solver and straight-line code for each
//! derivative. Where a closed form exists, the position solver uses it.
//!
//! ```
//! use kin_core::prelude::*;
//!
//! mechanism! {
//!     /// A slider-crank, driven at its slider.
//!     pub struct Pump {
//!         /// Crank.
//!         pub crank: Length,
//!         /// Connecting rod.
//!         pub rod: Length,
//!     }
//!     input s: Length;
//!     unknown theta: Angle, phi: Angle;
//!
//!     crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
//! }
//!
//! let pump: Pump = Pump { crank: 3.0, rod: 4.0 };
//! let stroke = Motion::from((5.0, 1.0, 0.0, 0.0, 0.0));
//! let pose = pump.solve(stroke, Assembly::Open)?;
//! assert!((pose.theta.position().tan() - 4.0 / 3.0).abs() < 1e-15);
//! println!("{} {}", pose.theta.velocity(), pose.theta.snap());
//!
//! // beyond the reach of the links: an error, which says by how much
//! let error = pump.position(7.5, Assembly::Open).unwrap_err();
//! assert_eq!(error.margin(), Some(-0.5));
//! # Ok::<(), SolveError>(())
//! ```
//!
//! # Where to look
//!
//! | for | see |
//! |---|---|
//! | the language of declarations | [`mechanism!`] |
//! | a value with its time derivatives | [`Motion`] |
//! | motion laws of cams and servo drives | [`law`] |
//! | an angle as a unit vector, without an arctangent | [`Direction`] |
//! | the tangent and curvature of a point's path | [`Motion`], the methods of points |
//! | the instant centre of a link | [`LinkMotion`] |
//! | a picture of the mechanism | [`Skeleton`] |
//! | how well a dyad transmits force | [`TransmissionAngle`] |
//! | a point or vector in the plane, in space | [`Plane`], [`Space`] |
//! | a rotation in space | [`Rotation`] |
//! | the choice between two solutions (branches) | [`Assembly`] |
//! | moving from one position to another in the same assembly | [`track`](track()), [`TrackError`] |
//! | many poses over an input or over time, tables with named columns | [`sweep`] |
//! | peaks, extremes, zeros, dwells and means of a sweep | `extremes` (feature `alloc`) |
//! | tables that replace a solver, read in any language | [`exact`] |
//! | all circuits and branches with their limits, Grashof's type | `cycle` (feature `alloc`) |
//! | the reason why there is no position | [`SolveError`], [`Failure`] |
//! | code for any mechanism | [`Mechanism`], [`Pose`] |
//! | how the motion depends on the dimensions | [`Mechanism::sensitivities_at`], [`Sensitive`] |
//! | how unknowns and outputs depend on the inputs | [`Mechanism::jacobian`] |
//! | all positions of any mechanism | [`Mechanism::positions_at`] |
//! | the forms of the blocks, with the lengths of links | [`BlockForm`] |
//! | mechanisms ready to use | `library` (feature `library`) |
//! | verification of your own mechanism | `verify` (feature `std`) |
//! | all solutions of a block without a closed form | [`Assemblies`] |
//! | solvers as data, for other languages | `tape` (feature `tape`) |
//! | files and messages: JSON and other formats | `stored` (feature `serde`) |
//! | number types | [`Number`] and [`Scalar`], [`series`] for truncated Taylor series, [`Changing`] for a number with one derivative |
//!
//! # Units
//!
//! Angles are in radians and counter-clockwise. Lengths share any one unit, and times share any one unit.
//!
//! # Features
//!
//! The solvers do not allocate and need no standard library: without the default feature `std`, the feature `libm`
//! supplies the floating-point functions. The feature `alloc`, which `std` implies, adds tables and extremes of sweeps.
//! The feature `library` adds declared mechanisms, and `rayon` solves batches on all cores. The feature `num-dual`
//! makes the dual numbers of that crate a [`Scalar`], and `verify` uses them. The feature `nalgebra` converts to and
//! from the points and vectors of that crate, and `approx` compares vectors and motions within a tolerance by the
//! traits of that crate. The feature `serde` lets programs store parameters, motions, assemblies and poses. The feature
//! `tape`, which needs `std`, records solvers as data.
//!
//! The features stand for one version of each crate: `num-dual` 0.15, `nalgebra` 0.35, `approx` 0.5, `serde` 1. With
//! another version, pass vectors as their coordinates.
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![cfg_attr(
    test,
    allow(
        clippy::float_cmp,
        reason = "the tests compare with numbers that are exact in binary"
    )
)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(any(feature = "std", test))]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("kin-core needs the functions of either the feature `std` or the feature `libm`");

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;
pub mod any;
mod assemblies;
mod assembly;
pub mod batch;
#[cfg(feature = "alloc")]
mod bounds;
mod curve;
#[cfg(feature = "alloc")]
pub mod cycle;
mod declared;
#[cfg(rust_analyzer)]
#[doc(hidden)]
pub mod editor;
pub mod exact;
#[cfg(feature = "alloc")]
pub mod extremes;
mod failure;
mod geometry;
#[cfg(feature = "alloc")]
mod hermite;
mod interop;
pub mod law;
#[cfg(feature = "library")]
pub mod library;
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
pub mod linkage;
pub mod load;
mod mechanism;
mod motion;
mod number;
mod picture;
pub mod prelude;
mod quantity;
#[cfg(feature = "alloc")]
pub mod reaction;
#[doc(hidden)]
pub mod solve;
#[cfg(feature = "serde")]
pub mod stored;
#[cfg(feature = "alloc")]
pub mod sweep;
#[cfg(feature = "tape")]
pub mod tape;
mod track;
#[cfg(feature = "std")]
pub mod verify;

pub use assemblies::Assemblies;
#[doc(hidden)]
pub use assemblies::{Positions, continuation};
#[doc(hidden)]
pub use assembly::IntoAssembly;
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
pub use assembly::assembly_named;
pub use assembly::{Assembly, Guess, Near};
#[doc(hidden)]
pub use curve::CurveFunctions;
pub use curve::LimitKind;
pub use declared::*;
pub use failure::{Failure, InputValues, SolveError};
pub use geometry::{Plane, Rotation, Space};
#[cfg(feature = "alloc")]
#[doc(hidden)]
pub use mechanism::JacobianNumber;
#[doc(hidden)]
pub use mechanism::guessed::WriteTheParametersByName;
pub use mechanism::{
    BlockForm, Mechanism, OneInput, PartialMotions, Partials, Pose, PoseOf, PositionSearch, Prepared, Sensitive,
};
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
pub use mechanism::{Jacobian, JacobianError, JacobianMeasure};
#[doc(hidden)]
pub use motion::Contains;
pub use motion::{Direction, IntoMotion, LinkMotion, Motion, rpm};
#[cfg(feature = "std")]
#[doc(hidden)]
pub use number::count;
pub use number::{Changing, ClosedRange, Number, Operations, Row, series};
#[doc(hidden)]
pub use picture::PlaneOrSpace;
#[doc(hidden)]
pub use picture::PointArray;
pub use picture::{Slide, TransmissionAngle};
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
#[doc(hidden)]
pub use quantity::in_small_letters;
pub use quantity::{Dimension, Name, NameKind};
#[doc(hidden)]
pub use quantity::{GREEK, RATES};
pub use solve::Scalar;
#[doc(hidden)]
pub use track::MOST_TRACK_STEPS;
#[cfg(feature = "alloc")]
#[doc(hidden)]
pub use track::track_between;
pub use track::{TrackError, TrackErrorOf, TrackLimit, TrackStop, track};

/// Declares a mechanism by its loop closure, and generates solvers for its position and all time derivatives up to snap
/// (also called jounce), or up to another order.
///
/// `use kin_core::prelude::*;` imports the macro together with what its solvers take, `Motion` and `Assembly` among
/// others.
///
/// A declaration is a structure with the dimensions of the mechanism, and statements in any order:
///
/// ```text
/// declaration = struct statement*
/// struct      = attribute* visibility "struct" NAME "{" field ("," field)* "}"
/// field       = attribute* visibility NAME ":" dimension
/// dimension   = "Length" | "Angle" | "Scalar" | "Point" | "Vector" | "Point3" | "Vector3"
///
/// statement   = "input"   quantity ("," quantity)* ";"
///             | "unknown" unknown  ("," unknown)* ";"
///             | "order" "=" INTEGER ";"
///             | "with" request ("," request)* ";"
///             | "for" names "in" "[" element ("," element)* "]" "{" repeatable+ "}"
///             | repeatable
/// repeatable  = "let" NAME "=" (expression | frame) ";"
///             | "output" NAME ":" dimension "=" expression ";"
///             | expression "==" expression ";"
///             | "body" NAME ":" points ";"
///             | "ground" points ";"
///             | "slide" expression "along" expression ("on" NAME)? ";"
/// frame       = "frame" "(" expression "," expression ")"
/// names       = NAME | "(" NAME ("," NAME)* ")"
/// element     = expression | "(" expression ("," expression)* ")"
/// points      = expression ("," expression)*
/// request     = "transmission_angles" | "sensitivities" | "test"
/// quantity    = NAME ":" ("Length" | "Angle" | "Scalar")
/// unknown     = NAME ":" ("Length" | "Angle" | "Scalar" | "Direction") range?
/// range       = "where" NAME ("<" | "<=" | ">" | ">=") constant
///             | "in" constant (".." | "..=") constant
/// ```
///
/// - Each field of the structure has a `dimension`. The structure becomes generic over its number type, which is `f64`
///   by default. Documentation, other attributes and visibility are passed on.
/// - An equation joins two scalars, two plane vectors or two space vectors, and counts as one, two or three scalar
///   equations. There are as many scalar equations as unknowns.
/// - An unknown declared as a `Direction` is an angle whose cosine and sine are wanted: the result is a [`Direction`],
///   without an arctangent.
/// - A range selects one of two solutions. For unknowns without a range, an [`Assembly`] selects it.
/// - The order is the highest time derivative, from 1 to 12. The default is 4, which is snap. After snap come crackle
///   and pop, then `derivative_7` and so on.
/// - `with` requests more generated items. For example, `with transmission_angles;` requests the method that returns
///   the [`TransmissionAngle`] of every dyad. `with sensitivities;` requests the method `sensitivities`, which returns
///   the partial derivatives of unknowns and outputs, and of all their time derivatives, with respect to each
///   parameter: see [`Sensitive`].
/// - `body`, `ground` and `slide` state for the [`Skeleton`] what belongs together, where the equations do not.
/// - `for` repeats statements with other names. A `frame` is the origin and the rotation, in the plane the angle, of a
///   rigid body, whose points are placed by `frame * point`.
/// - A `let` is an abbreviation; it must precede its uses. An output is a quantity that is calculated to the same order
///   as the unknowns. Formulas behind it may use it as they use a `let`.
///
/// Expressions are Rust expressions of the declared names, numbers and `PI`, with `+`, `-`, `*`, `/`, with `sin`,
/// `cos`, `tan`, `asin`, `acos`, `atan`, `atan2`, `sinh`, `cosh`, `tanh`, `asinh`, `acosh`, `atanh`, `sqrt`, `exp`,
/// `ln` and `powi`, and with three functions that make plane vectors: `cis(angle)`, the unit vector at an angle,
/// `polar(length, angle)`, and `vec2(x, y)`. Functions may be written as methods, and the coordinates of a vector `v`
/// are `v.x` and `v.y`. Plane vectors multiply like complex numbers, so `v * cis(angle)` is `v` rotated by the angle. A
/// scalar that is added to a vector lies along the x axis.
///
/// The function `vec3(x, y, z)` makes space vectors, whose coordinates are `v.x`, `v.y` and `v.z`. Rotations rotate
/// them: `rotation * vector`. A rotation is `rot_x(angle)`, `rot_y(angle)`, `rot_z(angle)`, `rot(axis, angle)` about an
/// axis of any length but zero, or a product of rotations, of which the last one rotates first. Plane and space vectors
/// both have `dot(a, b)`, `cross(a, b)` (a scalar in the plane) and `norm(v)`. Plane and space do not mix:
/// `vec3(v.x, v.y, 0)` places a plane vector in space, and `vec3(s, 0, 0)` a scalar.
///
/// Angles are in radians. Dimensions are checked: a length plus an angle, the sine of a length, and a scalar equal to a
/// vector do not compile. The product of a length and an angle is a length.
///
/// ```
/// use kin_core::prelude::*;
///
/// mechanism! {
///     /// Planar four-bar linkage: ground 1, crank 2, coupler 3, rocker 4.
///     pub struct FourBar {
///         /// From the pivot of the crank to the pivot of the rocker.
///         pub r1: Length,
///         /// Crank.
///         pub r2: Length,
///         /// Coupler.
///         pub r3: Length,
///         /// Rocker.
///         pub r4: Length,
///     }
///     input theta2: Angle;
///     unknown theta3: Angle, theta4: Angle;
///
///     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
///
///     let half = r3 / 2;
///     output midpoint: Point = r2 * cis(theta2) + half * cis(theta3);
/// }
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let crank = Motion::from([65f64.to_radians(), -10.0, 2.0, -0.5, 0.3]);
///
/// // everything through snap in one call
/// let pose = linkage.solve(crank, Assembly::Open)?;
/// println!("{} {:?}", pose.theta4.snap(), pose.midpoint.acceleration());
///
/// // or successively: each solver takes what its order adds, and reuses what came before
/// let position = linkage.position(crank.value(), Assembly::Open)?;
/// let velocity = position.velocity(crank.velocity());
/// let acceleration = velocity.acceleration(crank.acceleration());
/// let jerk = acceleration.jerk(crank.jerk());
/// let snap = jerk.snap(crank.snap());
/// # Ok::<(), SolveError>(())
/// ```
///
/// A declaration up to the sixth derivative:
///
/// ```
/// use kin_core::prelude::*;
///
/// mechanism! {
///     /// A point on a wheel.
///     pub struct Wheel {
///         /// Its distance from the axle.
///         pub radius: Length,
///     }
///     input theta: Angle;
///     unknown height: Length;
///     height == radius * sin(theta);
///     order = 6;
/// }
///
/// let wheel = Wheel { radius: 2.0 };
/// let pose: WheelPop = wheel.solve(Motion::at_constant_speed(0.5, 3.0))?;
/// assert!((pose.height.crackle() - 2.0 * 243.0 * 0.5_f64.cos()).abs() < 1e-12);
/// assert!((pose.height.pop() + 2.0 * 729.0 * 0.5_f64.sin()).abs() < 1e-12);
/// # Ok::<(), SolveError>(())
/// ```
#[macro_export]
macro_rules! mechanism {
    ($($declaration:tt)*) => {
        $crate::__private::mechanism_in! { ($crate) $($declaration)* }
    };
}

/// Lets mechanisms be stored: implements serde's `Serialize` and `Deserialize` for their structures, as
/// [`ParameterRecord`](stored::ParameterRecord) does.
///
/// The crate that calls it need not depend on serde. A structure that is storable must not derive these traits.
///
/// ```
/// use kin_core::prelude::*;
///
/// mechanism! {
///     pub struct Lever { pub pivot: Point, pub arm: Length }
///     input phi: Angle;
///     unknown x: Length;
///     x == dot(pivot + arm * cis(phi), vec2(1, 0));
/// }
/// kin_core::storable!(Lever);
///
/// let lever = Lever { pivot: Plane::new(0.0, f64::NAN), arm: 2.0 };
/// let error = kin_core::stored::check(&lever).unwrap_err();
/// assert_eq!(error.to_string(), "pivot.y is NaN, and only finite numbers can be stored");
/// ```
#[cfg(feature = "serde")]
#[cfg_attr(docsrs, doc(cfg(feature = "serde")))]
#[macro_export]
macro_rules! storable {
    ($($mechanism:ident),+ $(,)?) => {
        $(
            impl<__T> $crate::__private::serde::Serialize for $mechanism<__T>
            where
                __T: $crate::Scalar + $crate::__private::serde::Serialize,
            {
                fn serialize<__S: $crate::__private::serde::Serializer>(
                    &self,
                    __serializer: __S,
                ) -> ::core::result::Result<__S::Ok, __S::Error> {
                    let record = $crate::stored::ParameterRecord(*self);
                    $crate::__private::serde::Serialize::serialize(&record, __serializer)
                }
            }

            impl<'de, __T> $crate::__private::serde::Deserialize<'de> for $mechanism<__T>
            where
                __T: $crate::Scalar + $crate::__private::serde::Deserialize<'de>,
            {
                fn deserialize<__D: $crate::__private::serde::Deserializer<'de>>(
                    __deserializer: __D,
                ) -> ::core::result::Result<Self, __D::Error> {
                    let $crate::stored::ParameterRecord(__mechanism) =
                        $crate::__private::serde::Deserialize::deserialize(__deserializer)?;
                    ::core::result::Result::Ok(__mechanism)
                }
            }
        )+
    };
}

/// A type that contains a reported mistake, so that no further errors are reported about it. An editor sees a number.
#[cfg(not(rust_analyzer))]
#[doc(hidden)]
#[macro_export]
macro_rules! __unexpanded {
    ($($mistake:tt)*) => {
        <[(); $($mistake)*] as ::core::ops::Deref>::Target
    };
}

/// A type that contains a reported mistake, so that no further errors are reported about it. An editor sees a number.
#[cfg(rust_analyzer)]
#[doc(hidden)]
#[macro_export]
macro_rules! __unexpanded {
    ($($mistake:tt)*) => {
        ::core::primitive::f64
    };
}

/// The names of local variables, imported as functions, so that in the patterns of an expansion they cannot refer to
/// constants of the user.
#[doc(hidden)]
#[macro_export]
macro_rules! __locals {
    ($($name:ident),*) => {
        use $crate::__private::{$(local as $name),*};
    };
}

/// The traits that the poses of all mechanisms implement in the same way, for the poses of one mechanism.
#[doc(hidden)]
#[macro_export]
macro_rules! __poses {
    ($mechanism:ident, $arguments:tt, $unknowns:literal, $fields:tt, $($pose:ident)*) => {
        $(
            // without `#[diagnostic::do_not_recommend]`, which a crate without the implicit prelude does not find
            #[doc(hidden)]
            impl<T: $crate::Scalar> $crate::Guess<T, $unknowns, $mechanism<T>> for $pose<T> {
                fn values(self) -> [T; $unknowns] {
                    $crate::PoseOf::<$mechanism<T>>::unknowns(&self)
                }
            }

            impl<T: $crate::Scalar> $crate::__private::core::fmt::Display for $pose<T> {
                fn fmt(
                    &self,
                    formatter: &mut $crate::__private::core::fmt::Formatter<'_>,
                ) -> $crate::__private::core::fmt::Result {
                    let fields = $crate::__private::fields!(self $fields);
                    $crate::__private::fmt_pose::<$mechanism<T>>(formatter, fields)
                }
            }
        )*
        $crate::__guessed! { $mechanism $arguments $($pose)* }
    };
}

/// The messages about calls that people guess, and that a mechanism and its poses do not have. The last pose has all
/// orders.
#[doc(hidden)]
#[macro_export]
macro_rules! __guessed {
    ($mechanism:ident $arguments:tt $($pose:ident)*) => {
        #[doc(hidden)]
        impl<T> $crate::__private::guessed::MadeOfNamedParameters for $mechanism<T> {}

        $crate::__guessed! { @integers $mechanism $arguments }
        $crate::__guessed! { @before_the_last $($pose)* }
    };
    (@integers $mechanism:ident 1) => { $crate::__guessed! { @integers $mechanism IntegersInOne } };
    (@integers $mechanism:ident 2) => { $crate::__guessed! { @integers $mechanism IntegersInTwo } };
    (@integers $mechanism:ident 3) => { $crate::__guessed! { @integers $mechanism IntegersInThree } };
    (@integers $mechanism:ident 4) => { $crate::__guessed! { @integers $mechanism IntegersInFour } };
    (@integers $mechanism:ident $solvers:ident) => {
        // integers without a stated type are `i32`
        #[doc(hidden)]
        impl $crate::__private::guessed::$solvers for $mechanism<$crate::__private::core::primitive::i32> {}

        #[doc(hidden)]
        impl $crate::__private::guessed::IntegersInASweep for $mechanism<$crate::__private::core::primitive::i32> {}
    };
    (@integers $mechanism:ident $more:literal) => {};
    (@before_the_last $last:ident) => {};
    (@before_the_last $pose:ident $($later:ident)+) => {
        #[doc(hidden)]
        impl<T> $crate::__private::guessed::LaterOrders for $pose<T> where
            Self: $crate::__private::guessed::KnowsTheRatesBelow
        {
        }

        $crate::__guessed! { @before_the_last $($later)+ }
    };
}

/// References to fields of a pose, in a slice.
#[doc(hidden)]
#[macro_export]
macro_rules! __fields {
    ($pose:ident [$($field:ident)*]) => {
        &[$(&$pose.$field as &dyn $crate::__private::Shown),*]
    };
}

/// The items that a mechanism has only with the feature `alloc`.
#[cfg(feature = "alloc")]
#[doc(hidden)]
#[macro_export]
macro_rules! __with_memory {
    ($($tokens:tt)*) => { $($tokens)* };
}

/// The items that a mechanism has only with the feature `alloc`: without it, none.
#[cfg(not(feature = "alloc"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __with_memory {
    ($($tokens:tt)*) => {};
}

/// The implementations of serde's traits for generated items: without the feature `serde`, none.
#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __stored {
    ($($tokens:tt)*) => {};
}

/// `Debug` of an error: its sentence, because that is what `unwrap` and a `main` that returns the error show.
#[doc(hidden)]
#[macro_export]
macro_rules! __debug_by_display {
    ([$($parameters:tt)*] $error:ty) => {
        impl<$($parameters)*> ::core::fmt::Debug for $error {
            fn fmt(&self, formatter: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                ::core::fmt::Display::fmt(self, formatter)
            }
        }
    };
    ($error:ident) => {
        $crate::__debug_by_display! { [] $error }
    };
}

/// `Debug` of poses, by the names of inputs, unknowns and outputs. Values that only later orders need are left out.
#[doc(hidden)]
#[macro_export]
macro_rules! __readable {
    ([$($pose:ident)*] $fields:tt) => {
        $($crate::__readable! { @pose $pose $fields })*
    };
    (@pose $pose:ident { $($field:ident)* }) => {
        impl<T: ::core::fmt::Debug> ::core::fmt::Debug for $pose<T> {
            fn fmt(&self, formatter: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                let mut shown = formatter.debug_struct(::core::stringify!($pose));
                $(shown.field(::core::stringify!($field), &self.$field);)*
                shown.finish()
            }
        }
    };
}

/// The methods of a structure of assemblies. For each block: its field, the method that sets it, and its unknowns.
#[doc(hidden)]
#[macro_export]
macro_rules! __choices {
    ($assembly:ident { $($field:ident $setter:ident $unknowns:literal)* }) => {
        #[allow(unreachable_pub)]
        impl $assembly {
            /// The same assembly for every block.
            #[doc(alias = "Open")]
            #[doc(alias = "Crossed")]
            #[must_use]
            pub const fn all(assembly: $crate::Assembly) -> Self {
                Self { $($field: assembly),* }
            }

            $(
                #[doc = ::core::concat!("Another assembly for the block that finds `", $unknowns, "`.")]
                #[must_use]
                pub const fn $setter(mut self, assembly: $crate::Assembly) -> Self {
                    self.$field = assembly;
                    self
                }
            )*
        }

        /// Writes the assembly of each block, as in `theta3_theta4: open, phi: crossed`.
        impl ::core::fmt::Display for $assembly {
            fn fmt(&self, formatter: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                let choices = [$((::core::stringify!($field), self.$field)),*];
                for (index, (block, assembly)) in $crate::__private::core::iter::Iterator::enumerate(
                    $crate::__private::core::iter::IntoIterator::into_iter(choices),
                ) {
                    let separator = if index == 0 { "" } else { ", " };
                    ::core::write!(formatter, "{separator}{block}: {assembly}")?;
                }
                ::core::result::Result::Ok(())
            }
        }
    };
}

/// The method of mechanisms that do not find all of their positions, which says why.
#[doc(hidden)]
#[macro_export]
macro_rules! __not_all_positions {
    ($mechanism:ident $($input:ident)+) => {
        #[allow(unreachable_pub)]
        impl<T> $mechanism<T> {
            #[doc(hidden)]
            pub fn assemblies_at(
                &self,
                $($input: impl ::core::marker::Sized),+
            ) -> <Self as $crate::__private::guessed::FindsAllPositions>::Found
            where
                Self: $crate::__private::guessed::FindsAllPositions,
            {
                $(let _ = $input;)+
                <Self as $crate::__private::guessed::FindsAllPositions>::FOUND
            }
        }
    };
}

/// What a mechanism with a single position answers without an assembly: the methods of the traits that take one, for
/// every mechanism.
#[doc(hidden)]
#[macro_export]
macro_rules! __single_position {
    ($mechanism:ident $order:tt) => {
        $crate::__single_position! { @accelerations $mechanism $order }

        #[allow(unreachable_pub)]

        impl<T: $crate::Scalar> $mechanism<T> {
            /// `Loaded::balance` in the only position.
            ///
            /// # Errors
            /// As there.
            pub fn balance(
                &self,
                loads: &impl $crate::load::LoadsOf<Self>,
                inputs: <Self as $crate::Mechanism>::Inputs<<Self as $crate::Mechanism>::Motion<T>>,
            ) -> ::core::result::Result<$crate::load::Balance<Self>, $crate::load::LoadError> {
                $crate::load::Loaded::balance(self, loads, inputs, ())
            }
        }

        #[allow(unreachable_pub)]

        impl $mechanism<::core::primitive::f64> {
            $crate::__with_memory! {
                /// `Swept::sweep` of the only position.
                pub fn sweep(&self) -> $crate::sweep::Assembled<Self> {
                    $crate::sweep::Swept::sweep(self, ())
                }
            }

            /// `Loaded::equivalent_inertia` in the only position.
            ///
            /// # Errors
            /// As there.
            pub fn equivalent_inertia(
                &self,
                loads: &impl $crate::load::LoadsOf<Self>,
                inputs: <Self as $crate::Mechanism>::Inputs<::core::primitive::f64>,
            ) -> ::core::result::Result<$crate::load::EquivalentInertia<Self>, $crate::load::LoadError> {
                $crate::load::Loaded::equivalent_inertia(self, loads, inputs, ())
            }
        }
    };
    // without accelerations there are none by efforts
    (@accelerations $mechanism:ident 1) => {};
    (@accelerations $mechanism:ident $order:tt) => {
        #[allow(unreachable_pub)]
        impl $mechanism<::core::primitive::f64> {
            /// `Loaded::accelerations` in the only position.
            ///
            /// # Errors
            /// As there.
            pub fn accelerations(
                &self,
                loads: &impl $crate::load::LoadsOf<Self>,
                inputs: <Self as $crate::Mechanism>::Inputs<::core::primitive::f64>,
                velocities: <Self as $crate::Mechanism>::Inputs<::core::primitive::f64>,
                efforts: <Self as $crate::Mechanism>::Inputs<::core::primitive::f64>,
            ) -> ::core::result::Result<
                <Self as $crate::Mechanism>::Inputs<::core::primitive::f64>,
                $crate::load::LoadError,
            > {
                $crate::load::Loaded::accelerations(self, loads, inputs, velocities, efforts, ())
            }
        }
    };
}

/// The body of the test that a declaration asks for.
#[cfg(feature = "std")]
#[doc(hidden)]
#[macro_export]
macro_rules! __assert_verified {
    ($mechanism:ty) => {
        $crate::verify::mechanism::<$mechanism>().assert()
    };
}

/// The replacement of that body without the feature `std`.
#[cfg(not(feature = "std"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __assert_verified {
    ($mechanism:ty) => {
        compile_error!(
            "the test of a mechanism needs the feature `std` of kin-core: repeat the dependency under \
             [dev-dependencies] of Cargo.toml, with the same path or version and with features = [\"std\"]"
        )
    };
}
