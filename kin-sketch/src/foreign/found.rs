//! What a reader has found.

use crate::declaration::SketchDeclaration;
use crate::kin_file::DriveMotion;
use crate::sketch::Sketch;

/// The program that wrote a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ForeignFormat {
    /// pylinkage 1.3, JSON of a mechanism.
    Pylinkage,
    /// PMKS+, an address.
    PmksPlus,
    /// PMKS, a line for each joint.
    Pmks,
    /// Linkage 3, XML.
    Linkage,
}

impl ForeignFormat {
    /// The name of the program.
    #[must_use]
    pub fn program(self) -> &'static str {
        match self {
            Self::Pylinkage => "pylinkage",
            Self::PmksPlus => "PMKS+",
            Self::Pmks => "PMKS",
            Self::Linkage => "Linkage",
        }
    }
}

/// A file that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Foreign {
    /// The program that wrote it.
    pub format: ForeignFormat,
    /// The drawing.
    pub sketch: Sketch,
    /// The motions of its drives, in their order, as far as the file states them.
    pub motions: Vec<DriveMotion>,
    /// The unit of its lengths: `mm`, `cm`, `m` or `in`; none if the file does not say.
    pub unit: Option<&'static str>,
    /// Each part of the file that the drawing lacks, or holds otherwise, in a sentence.
    pub notes: Vec<String>,
}

impl Foreign {
    /// The text of a `.kin` file with the declaration of this drawing: it tells the program, and has the file's motions
    /// and unit.
    #[must_use]
    pub fn kin_file(&self, declared: &SketchDeclaration) -> String {
        let documentation = format!("Imported from {}.", self.format.program());
        declared.kin_file(&documentation, self.unit.unwrap_or_default(), &self.motions)
    }
}
