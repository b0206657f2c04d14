//! The items that generated code uses. They are not for direct use, and may change at any time.

pub use crate::__assert_verified as assert_verified;
pub use crate::__choices as choices;
pub use crate::__fields as fields;
pub use crate::__lent as lent;
pub use crate::__locals as locals;
pub use crate::__not_all_positions as not_all_positions;
pub use crate::__poses as poses;
pub use crate::__readable as readable;
pub use crate::__single_position as single_position;
pub use crate::__stored as stored;
pub use crate::__unexpanded as unexpanded;
pub use crate::assemblies::{Assemblies, Choices, continuation, every, positions_near};
pub use crate::assembly::{Assembly, Guess, IntoAssembly, Near};
pub use crate::declared::*;
#[cfg(rust_analyzer)]
pub use crate::editor;
pub use crate::failure::{Failure, InputValues, SolveError};
pub use crate::geometry::{Plane, Rotation, Space};
pub use crate::mechanism::{
    BlockForm, First, Lent, Mechanism, Memory, Partials, Pose, PoseOf, PositionSearch, Preparation, Second, Sensitive,
    Shown, culprit, failed, fmt_pose, guessed, length,
};
pub use crate::motion::{Direction, IntoMotion, Motion};
pub use crate::number::{Number, Operations, Row, series};
pub use crate::picture::{Slide, TransmissionAngle};
pub use crate::quantity::Dimension;
pub use crate::solve::Scalar;
pub use crate::track::{TrackErrorOf, track_to};
pub use crate::{batch, solve};
pub use core;
#[cfg(test)]
pub use kin_macros::mechanism_in;
#[cfg(feature = "serde")]
pub use serde;

/// The traits whose methods generated code calls.
pub mod methods {
    pub use crate::batch::{MotionColumns as _, Parameter as _};
    pub use crate::mechanism::PoseOf as _;
    pub use crate::motion::IntoMotion as _;
    pub use crate::number::Number as _;
}

pub mod live {
    //! What an interpreter of programs calls where generated code calls functions with sizes and names in their types:
    //! the same functions over slices, with a [`Name`](crate::Name) that may be an index. The sizes, the names and the
    //! order of the calls are those of generated code, and so are the bits of the results.
    //!
    //! | here | in generated code |
    //! |---|---|
    //! | [`newton_in`] in [`NewtonMemory`] | `solve::newton` |
    //! | [`factor_in`] and [`substitute_in`] with [`FactorRow`]s | `solve::factor` and `Factors::solve` |
    //! | [`decisive_in`]; the terms matter only if `T::DOUBT > 0.0` | `solve::decisive` |
    //! | [`decisive_vector_in`], likewise | `solve::decisive_vector` |
    //! | [`choose_in`] among [`SolutionInRange`]s | `solve::choose` |
    //! | `T::assembled` for each value | `T::all_assembled` |
    //! | [`agreeing_in`] | `solve::agreeing` |
    //! | [`check_guesses_in`] | `solve::check_guesses` |
    //! | [`unwrap_near`] for each angle, if there is a guess | `solve::unwrap_to_guess` |
    //! | [`largest_in`] | `solve::largest` |
    //! | [`culprit_in`], then [`failed_in`] with `Name::by_index` and [`InputNames`] | `culprit` and `failed` |
    //! | [`every_in`], [`Choices::solution_in`] and [`is_same_position`] | `every` and `Choices::solution` |
    //!
    //! Functions without sizes in their types are the same for both: the closed forms, directions, domains, `both`,
    //! `regular`, `finite`, `check_value`, `check_angle` of `solve`, the methods of numbers, `length`, `BlockForm` and
    //! `TransmissionAngle::of`. Where they take a name, they take an index as well.
    //!
    //! A polynomial system has its number of variables in its type: `BorrowedSystem<'_, M>`. An interpreter chooses
    //! among the `M` that it supports, and gives the same solutions with room for any number of paths that is enough.

    pub use crate::assemblies::{Choices, every_in, is_same_position};
    #[cfg(feature = "alloc")]
    pub use crate::cycle::{SearchMethod, SearchedFunctions};
    #[cfg(feature = "alloc")]
    pub use crate::extremes::{ChangedFunctions, PositionFunctions};
    pub use crate::failure::InputNames;
    pub use crate::mechanism::{culprit_in, failed_in};
    pub use crate::number::Changing;
    pub use crate::solve::{
        Elimination, Equations, FactorRow, NewtonMemory, SolutionInRange, agreeing_in, check_guesses_in, choose_in,
        decisive_in, decisive_vector_in, factor_in, largest_in, newton_in, substitute_in, unwrap_near,
    };
    #[cfg(feature = "alloc")]
    pub use crate::sweep::{READ, SweptMechanism};
}

/// The function as which local names of generated code are imported, so that in patterns they cannot refer to constants
/// of the user.
pub const fn local() {}

/// A mechanism whose declaration contains mistakes.
pub trait Numeric {
    /// Its number type, by default an error of the compiler.
    type Number;
}

/// Lets the poses of a mechanism be written, and its structure of assemblies be stored. Generated code calls it.
#[cfg(feature = "serde")]
#[doc(hidden)]
#[macro_export]
macro_rules! __stored {
    ($mechanism:ident: $($pose:ident $length:literal),+; $fields:tt $(; $assembly:ident $choices:tt)?) => {
        $($crate::__stored! { @pose $mechanism $pose $length $fields })+
        $($crate::__stored! { @assembly $assembly $choices })?
    };
    (
        @pose $mechanism:ident $pose:ident $length:literal
        { $held:ident => [$($input:ident),*] [$($unknown:ident $index:literal),*] [$($output:expr),*] }
    ) => {
        impl<__T: $crate::Scalar> ::core::convert::From<$pose<__T>>
            for $crate::stored::PoseRecord<$mechanism<__T>, $length>
        {
            fn from($held: $pose<__T>) -> Self {
                Self {
                    inputs: [$($held.$input),*],
                    unknowns: [$($crate::stored::motion(
                        &$held.$unknown,
                        $crate::PoseOf::<$mechanism<__T>>::unknowns(&$held)[$index],
                    )),*],
                    outputs: [$($output),*],
                }
            }
        }

        impl<__T: $crate::Scalar + $crate::__private::serde::Serialize> $crate::__private::serde::Serialize
            for $pose<__T>
        {
            fn serialize<__S: $crate::__private::serde::Serializer>(
                &self,
                __serializer: __S,
            ) -> ::core::result::Result<__S::Ok, __S::Error> {
                $crate::__private::serde::Serialize::serialize(
                    &<$crate::stored::PoseRecord<$mechanism<__T>, $length> as ::core::convert::From<_>>::from(*self),
                    __serializer,
                )
            }
        }
    };
    (@assembly $assembly:ident { $($choice:ident $index:literal),+ }) => {
        impl $crate::__private::serde::Serialize for $assembly {
            fn serialize<__S: $crate::__private::serde::Serializer>(
                &self,
                __serializer: __S,
            ) -> ::core::result::Result<__S::Ok, __S::Error> {
                $crate::stored::write_choices(&[$(stringify!($choice)),+], &[$(self.$choice),+], __serializer)
            }
        }

        impl<'de> $crate::__private::serde::Deserialize<'de> for $assembly {
            fn deserialize<__D: $crate::__private::serde::Deserializer<'de>>(
                __deserializer: __D,
            ) -> ::core::result::Result<Self, __D::Error> {
                let __choices = $crate::stored::read_choices(&[$(stringify!($choice)),+], __deserializer)?;
                ::core::result::Result::Ok(Self { $($choice: __choices[$index]),+ })
            }
        }
    };
}

/// Gives a mechanism the memory of its tracks: the counts of parameters, inputs, unknowns, blocks and orders.
#[doc(hidden)]
#[macro_export]
macro_rules! __lent {
    ($parameters:literal $inputs:literal $unknowns:literal $blocks:literal $orders:expr) => {
        fn lend<Result>(use_of_it: impl ::core::ops::FnOnce($crate::__private::Lent<'_>) -> Result) -> Result {
            const MEMORY: $crate::__private::Memory = $crate::__private::Memory {
                parameters: $parameters,
                inputs: $inputs,
                unknowns: $unknowns,
                blocks: $blocks,
                orders: $orders,
            };
            use_of_it($crate::__private::Lent {
                numbers: &mut [0.0; MEMORY.numbers()],
                first: &mut [$crate::__private::First::ZERO; MEMORY.series()],
                second: &mut [$crate::__private::Second::ZERO; MEMORY.series()],
            })
        }
    };
}
