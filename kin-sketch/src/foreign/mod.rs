//! Files of other programs become drawings.
//!
//! [`read`] knows the format by the text:
//!
//! | program | format |
//! |---|---|
//! | pylinkage 1.3 | JSON of a mechanism, as `mechanism_to_json` writes it |
//! | PMKS+ | the address that it shares, or what stands behind the `?` |
//! | PMKS | text with a line for each joint |
//! | Linkage 3 | `.linkage2` |
//!
//! ```
//! let pump = "ground crank R 0 0\ncrank rod R 0 3\nrod piston R 4 0\nground piston P 4 0 0";
//! let pump = kin_sketch::foreign::read(pump)?;
//! let declared = pump.sketch.declaration().expect("it moves in one way, and its crank is driven");
//! assert!(declared.text.contains("input crank_angle: Angle;"));
//! assert_eq!(declared.dimensions[0], ("crank".to_owned(), 3.0));
//! # Ok::<(), kin_sketch::foreign::ForeignError>(())
//! ```

mod draft;
mod error;
mod found;
mod linkage;
mod pmks;
mod pmks_plus;
mod pylinkage;

pub use error::ForeignError;
pub use found::{Foreign, ForeignFormat};

/// More bytes than any file of these formats needs.
const MOST_BYTES: usize = 1 << 20;

/// Reads a file of another program.
///
/// # Errors
/// The first place at which the text cannot be read.
pub fn read(text: &str) -> Result<Foreign, ForeignError> {
    if text.len() > MOST_BYTES {
        let message = format!("the file has {} bytes, and kin reads at most {MOST_BYTES}", text.len());
        return Err(ForeignError::TooLarge(message));
    }
    let text = text.trim_start_matches('\u{feff}').trim();
    if text.starts_with(['{', '[']) {
        pylinkage::read(text)
    } else if text.starts_with('<') {
        linkage::read(text)
    } else if pmks_plus::is_address(text) {
        pmks_plus::read(text)
    } else if pmks::is_table(text) {
        pmks::read(text)
    } else {
        Err(ForeignError::Unknown)
    }
}
