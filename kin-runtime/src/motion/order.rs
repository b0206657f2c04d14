//! The orders of derivative that a motion or a direction contains, known at compile time.

use super::{Direction, Motion};

/// A motion or direction that contains the time derivative of the given order: 1 for the velocity, 2 for the
/// acceleration, and so on. The methods with the names of derivatives ask for it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not contain the time derivative of order {ORDER}",
    label = "this order has not been solved for",
    note = "`position` solves for values alone. `solve` solves for all orders at once, or go on from the position: \
            `.velocity(rates)` of the pose, then `.acceleration(rates)`, and so on"
)]
#[doc(hidden)]
pub trait Contains<const ORDER: usize> {}

macro_rules! contains {
    ($($order:literal: $($entries:literal)+;)+) => {
        $($(
            #[diagnostic::do_not_recommend]
            impl<T> Contains<$order> for Direction<T, $entries> {}
            #[diagnostic::do_not_recommend]
            impl<T> Contains<$order> for Motion<T, { $entries + 1 }> {}
        )+)+
    };
}

contains! {
    1: 1 2 3 4 5 6 7 8 9 10 11 12;
    2: 2 3 4 5 6 7 8 9 10 11 12;
    3: 3 4 5 6 7 8 9 10 11 12;
    4: 4 5 6 7 8 9 10 11 12;
    5: 5 6 7 8 9 10 11 12;
    6: 6 7 8 9 10 11 12;
    7: 7 8 9 10 11 12;
    8: 8 9 10 11 12;
    9: 9 10 11 12;
    10: 10 11 12;
    11: 11 12;
    12: 12;
}

/// Defines the methods with the names of derivatives. Each asks for a type that contains its derivative.
macro_rules! accessors {
    ($kind:ident, $entries:ident, $first:literal: $($(#[$attribute:meta])* $name:ident = $order:literal;)+) => {
        impl<T: Copy, const N: usize> $kind<T, N> {
            $(
                $(#[$attribute])*
                #[inline]
                #[must_use]
                pub const fn $name(&self) -> T
                where
                    Self: Contains<$order>,
                {
                    self.$entries[$order - $first]
                }
            )+
        }
    };
}

accessors! { Motion, derivatives, 0:
    /// The derivative of order 1.
    #[doc(alias = "speed")]
    #[doc(alias = "rate")]
    velocity = 1;
    /// The derivative of order 2.
    acceleration = 2;
    /// The derivative of order 3.
    jerk = 3;
    /// The derivative of order 4, also called jounce.
    #[doc(alias = "jounce")]
    snap = 4;
    /// The derivative of order 5.
    crackle = 5;
    /// The derivative of order 6.
    pop = 6;
    /// The derivative of order 7.
    derivative_7 = 7;
    /// The derivative of order 8.
    derivative_8 = 8;
    /// The derivative of order 9.
    derivative_9 = 9;
    /// The derivative of order 10.
    derivative_10 = 10;
    /// The derivative of order 11.
    derivative_11 = 11;
    /// The derivative of order 12.
    derivative_12 = 12;
}

accessors! { Direction, rates, 1:
    /// The angle's derivative of order 1.
    velocity = 1;
    /// The angle's derivative of order 2.
    acceleration = 2;
    /// The angle's derivative of order 3.
    jerk = 3;
    /// The angle's derivative of order 4, also called jounce.
    #[doc(alias = "jounce")]
    snap = 4;
    /// The angle's derivative of order 5.
    crackle = 5;
    /// The angle's derivative of order 6.
    pop = 6;
    /// The angle's derivative of order 7.
    derivative_7 = 7;
    /// The angle's derivative of order 8.
    derivative_8 = 8;
    /// The angle's derivative of order 9.
    derivative_9 = 9;
    /// The angle's derivative of order 10.
    derivative_10 = 10;
    /// The angle's derivative of order 11.
    derivative_11 = 11;
    /// The angle's derivative of order 12.
    derivative_12 = 12;
}
