//! What loads act on.

use crate::load::Moving;
use crate::mechanism::Mechanism;
use crate::number::Row;
use crate::solve::Scalar;

/// What loads act on: a mechanism by its type, or the quantities of one by their names. Do not implement it: a new
/// version may add items.
#[doc(hidden)]
pub trait LoadedSystem: Copy {
    /// The number type.
    type Scalar: Scalar;
    /// A value with its derivatives by time.
    type Motion<V: Copy>: Row<V>;
    /// A value for each input.
    type Inputs<V: Copy>: Row<V>;
    /// The pose that the functions of loads receive, over numbers with their change along one input.
    type Moving: Copy;
}

impl<M: Mechanism> LoadedSystem for M {
    type Scalar = <M as Mechanism>::Scalar;
    type Motion<V: Copy> = <M as Mechanism>::Motion<V>;
    type Inputs<V: Copy> = <M as Mechanism>::Inputs<V>;
    type Moving = Moving<M>;
}
