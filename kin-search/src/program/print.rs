//! The standard output.

use std::io::{self, ErrorKind, Write as _};

use super::fault::Fault;

/// Prints text. A reader that has gone away, as in `kin-search functions | head`, is no mistake.
pub(crate) fn print(text: &str) -> Result<(), Fault> {
    let mut output = io::stdout().lock();
    match output.write_all(text.as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Fault::Wrong(format!("the standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}
