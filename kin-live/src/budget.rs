//! Limits on the cost of a mechanism that strangers declare.

/// The greatest cost of a declared mechanism.
///
/// | cost | limit | beyond it |
/// |---|---|---|
/// | bytes of text | `compiler.text` | [`DeclareError::TooLarge`](crate::DeclareError::TooLarge) |
/// | work of the compiler, and the memory that it takes | `compiler.work` | the same |
/// | depth of a formula | 256 | a mistake |
/// | values of the solver | 65 536 | `TooLarge` |
/// | assemblies | 65 536 | `TooLarge` |
/// | paths of a search for all positions | `paths` | nothing is found, and `is_complete` is false |
/// | solutions of one coupled block | 1024 | the same |
/// | attempts to follow a path | 3, of 5000 steps at 20 radii from 3 starts | `is_complete` is false |
/// | Newton's method | 64 steps, each shortened up to 20 times | `NotConverged` |
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// The budget of the compiler.
    pub compiler: kin_compiler::Budget,
    /// The paths that a search for all positions may follow: assemblies, or combinations of solutions of coupled
    /// blocks.
    pub paths: usize,
}

impl Default for Budget {
    /// The usual budget of the compiler, and paths for every mechanism that can be declared.
    fn default() -> Self {
        Self {
            compiler: kin_compiler::Budget::default(),
            paths: 1 << 16,
        }
    }
}
