//! The library behind `kin-core`: numbers, closed forms, and all that is asked of a mechanism, such as sweeps, cycles
//! and forces.
//!
//! Use it through `kin-core`, which has everything that is here, under the same names and with the same features, and
//! beside it the macro and the library of mechanisms. Nothing here needs the macro, so Cargo builds this crate and the
//! compiler of declarations at the same time.
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
// Tests declare mechanisms, and take those of the library, as users of kin-core do.
#[cfg(test)]
#[path = "../../kin-core/src/declaration.rs"]
mod declaration;
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
#[cfg(test)]
#[path = "../../kin-core/src/library/mod.rs"]
pub mod library;
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
pub mod linkage;
pub mod load;
mod mechanism;
mod motion;
mod number;
mod picture;
#[cfg(test)]
#[path = "../../kin-core/src/prelude.rs"]
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

pub use assemblies::{Assemblies, Positions, continuation};
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
pub use assembly::assembly_named;
pub use assembly::{Assembly, Guess, IntoAssembly, Near};
pub use curve::{CurveFunctions, LimitKind};
pub use declared::*;
pub use failure::{Failure, InputValues, SolveError};
pub use geometry::{Plane, Rotation, Space};
pub use mechanism::guessed::WriteTheParametersByName;
pub use mechanism::{
    BlockForm, Mechanism, OneInput, PartialMotions, Partials, Pose, PoseOf, PositionSearch, Prepared, Sensitive,
};
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
pub use mechanism::{Jacobian, JacobianError, JacobianMeasure, JacobianNumber};
pub use motion::{Contains, Direction, IntoMotion, LinkMotion, Motion, rpm};
#[cfg(feature = "std")]
pub use number::count;
pub use number::{Changing, ClosedRange, Number, Operations, Row, series};
pub use picture::{PlaneOrSpace, PointArray, Slide, TransmissionAngle};
#[cfg(feature = "alloc")]
pub use quantity::in_small_letters;
pub use quantity::{Dimension, GREEK, Name, NameKind, RATES};
pub use solve::Scalar;
#[cfg(feature = "alloc")]
pub use track::track_between;
pub use track::{MOST_TRACK_STEPS, TrackError, TrackErrorOf, TrackLimit, TrackStop, track};

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
