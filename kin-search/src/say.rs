//! Messages for people.

use std::fmt;
use std::io::{self, Write as _};

/// Writes a line to the standard error stream. A reader that has gone away, as in `kin-search query … 2>&1 | head -1`,
/// is no mistake.
pub fn say(message: fmt::Arguments<'_>) {
    let _ = writeln!(io::stderr(), "{message}");
}
