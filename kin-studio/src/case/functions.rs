//! The functions of a mechanism that answer a case. The rest is compiled once, in this crate.

use kin_core::linkage::TabledMechanism;
#[cfg(feature = "program")]
use kin_core::verify::VerifiedFunctions;
#[cfg(feature = "program")]
use kin_fit::FitFunctions;

use crate::report::ReportFunctions;

/// The functions of a mechanism for tables and pages.
#[cfg(not(feature = "program"))]
pub(crate) trait CaseFunctions: ReportFunctions + TabledMechanism {}

#[cfg(not(feature = "program"))]
impl<F: ReportFunctions + TabledMechanism> CaseFunctions for F {}

/// The functions of a mechanism for tables and pages, and for the program's proofs and fits.
#[cfg(feature = "program")]
pub(crate) trait CaseFunctions: ReportFunctions + TabledMechanism + VerifiedFunctions + FitFunctions {}

#[cfg(feature = "program")]
impl<F: ReportFunctions + TabledMechanism + VerifiedFunctions + FitFunctions> CaseFunctions for F {}
