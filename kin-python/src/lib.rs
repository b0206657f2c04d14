//! The extension module below the Python package `kin`, whose documentation is that of its classes.

mod answers;
mod arguments;
mod arrays;
mod arrow;
mod batch;
mod choice;
mod code;
mod cycle;
mod declared;
mod exact;
mod fault;
mod fit;
mod law;
mod library;
mod linkage;
mod loads;
mod made;
mod mechanism;
mod methods;
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
    use crate::batch::{Batch, restored_batch};
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
    use crate::loads::{Loads, restored_loads};
    #[pymodule_export]
    use crate::mechanism::Mechanism;
    #[pymodule_export]
    use crate::motion::{Motion, restored_motion};
    #[pymodule_export]
    use crate::pose::{Pose, restored_pose};
    #[pymodule_export]
    use crate::proof::ForceProof;
    #[pymodule_export]
    use crate::quantity::Quantity;
    #[pymodule_export]
    use crate::report::{Page, restored_page};
    #[pymodule_export]
    use crate::sweep::Sweep;
    #[pymodule_export]
    use crate::table::{Table, restored_table};
}
