//! The program of the library's mechanisms.

use std::process::ExitCode;

fn main() -> ExitCode {
    kin_studio::program::library()
}
