//! The functions of a mechanism that a report needs beside its answers.

use kin_core::any::{Pictured, SkeletonOver};
use kin_core::linkage::LinkageFunctions;
use kin_core::tape::RecordedFunctions;

/// The functions of a mechanism for its report: `Of::<M>::FUNCTIONS` has them for every mechanism that rustc compiled,
/// and so has `kin_live::Mechanism`. All else is compiled once, in this crate.
pub trait ReportFunctions: LinkageFunctions + Pictured + SkeletonOver<f64> + RecordedFunctions<f64> {}

impl<F: LinkageFunctions + Pictured + SkeletonOver<f64> + RecordedFunctions<f64>> ReportFunctions for F {}
