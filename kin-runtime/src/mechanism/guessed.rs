//! Calls that people guess and that do not exist. Each trait here leads the compiler to a message that says what to
//! write.
//!
//! No program can use these traits: their methods ask for conditions that never hold, and their constant is no
//! function. A method that a program defines on the type itself comes before them.

/// The type of [`new`](MadeOfNamedParameters::new), named for the compiler to say: `expected function, found …`.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct WriteTheParametersByName;

/// A structure of parameters is made by naming them: `FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 }`.
#[doc(hidden)]
pub trait MadeOfNamedParameters {
    /// No function: the parameters have names, and no order that a caller could know.
    #[doc(hidden)]
    #[allow(non_upper_case_globals, reason = "people guess the name of a function")]
    const new: WriteTheParametersByName = WriteTheParametersByName;
}

/// A mechanism with floating-point numbers as parameters. None implements it, because these have inherent solvers.
#[diagnostic::on_unimplemented(
    message = "the parameters of `{Self}` are integers, with which no mechanism is solved",
    label = "write the parameters with a decimal point: `90.0` instead of `90`"
)]
pub trait WithADecimalPoint {
    /// What the solvers would return. Its absence prevents further errors.
    type Pose;
    /// A value for the methods that cannot be called.
    const POSE: Self::Pose;
}

/// The solvers of a mechanism of integers. They take as many arguments as those of other numbers, so that the compiler
/// does not complain about the number of arguments first.
macro_rules! solvers_of_integers {
    ($($trait:ident: $arguments:tt;)+) => {
        $(
            #[doc(hidden)]
            pub trait $trait: Sized {
                solvers_of_integers!(@method position $arguments);
                solvers_of_integers!(@method position_near $arguments);
                solvers_of_integers!(@method solve $arguments);
                solvers_of_integers!(@method solve_near $arguments);
            }
        )+
    };
    (@method $method:ident [$($argument:ident)+]) => {
        #[doc(hidden)]
        fn $method<$($argument),+>(&self, $(_: $argument),+) -> <Self as WithADecimalPoint>::Pose
        where
            Self: WithADecimalPoint,
        {
            Self::POSE
        }
    };
}

solvers_of_integers! {
    IntegersInOne: [A];
    IntegersInTwo: [A B];
    IntegersInThree: [A B C];
    IntegersInFour: [A B C D];
}

/// The sweep of a mechanism of integers, which takes the assembly alone whatever the inputs.
#[doc(hidden)]
pub trait IntegersInASweep: Sized {
    solvers_of_integers!(@method sweep [A]);
}

/// A pose that knows the rates below the order that is asked for. None implements it, because such a pose has an
/// inherent method.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not know the rates below this order",
    label = "go on from order to order: `.velocity(rates)` of a position, then `.acceleration(rates)`, and so on",
    note = "`solve` solves for all orders at once, and every quantity of its pose has rates: \
            `pose.theta.acceleration()`"
)]
pub trait KnowsTheRatesBelow {}

/// The orders to which a position does not lead at once.
#[doc(hidden)]
pub trait LaterOrders {
    #[doc(hidden)]
    fn acceleration(&self) {}
    #[doc(hidden)]
    fn jerk(&self) {}
    #[doc(hidden)]
    fn snap(&self) {}
}

/// A mechanism that finds all of its positions. None implements it, because those that do have an inherent method.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not find all of its positions",
    label = "start from values near a position instead: `position_near`, `solve_near`, and `track` from one to the \
             next",
    note = "`assemblies_at` is there if the coupled equations are algebraic in their unknowns, sines and cosines, and \
            the product of their degrees is 1024 at most: the coordinates of joints as unknowns often give a smaller \
            one than the angles of a body in space",
    note = "it is also there for one body in space on six legs, if the unknowns are the coordinates in `vec3(x, y, z)` \
            and the three angles in a product such as `rot_z(a) * rot_y(b) * rot_x(c)`"
)]
pub trait FindsAllPositions {
    /// What would be found. Its absence prevents further errors.
    type Found;
    /// A value for the method that cannot be called.
    const FOUND: Self::Found;
}
