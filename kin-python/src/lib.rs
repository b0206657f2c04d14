//! The extension module below the Python package `kin`, whose documentation is that of its classes.

mod answers;
mod arguments;
mod arrays;
mod arrow;
mod batch;
mod choice;
mod code;
mod cycle;
mod exact;
mod fault;
mod fit;
mod law;
mod library;
mod linkage;
mod loads;
mod mechanism;
mod motion;
mod pose;
mod proof;
mod quantity;
mod report;
mod sweep;
mod table;

/// The classes and functions that the package hands on.
#[pyo3::pymodule]
mod _kin {
    #[pymodule_export]
    use crate::batch::Batch;
    #[pymodule_export]
    use crate::cycle::Cycle;
    #[pymodule_export]
    use crate::exact::ExactTable;
    #[pymodule_export]
    use crate::law::{Law, constant_speed, dwell, fourier, polynomial, rise, s_curve};
    #[pymodule_export]
    use crate::library::library_designs;
    #[pymodule_export]
    use crate::linkage::{Linkage, restored_linkage};
    #[pymodule_export]
    use crate::loads::Loads;
    #[pymodule_export]
    use crate::mechanism::Mechanism;
    #[pymodule_export]
    use crate::motion::Motion;
    #[pymodule_export]
    use crate::pose::{Pose, restored_pose};
    #[pymodule_export]
    use crate::proof::ForceProof;
    #[pymodule_export]
    use crate::quantity::Quantity;
    #[pymodule_export]
    use crate::report::Page;
    #[pymodule_export]
    use crate::sweep::Sweep;
    #[pymodule_export]
    use crate::table::Table;
}
