//! What rustc says about programs with mistakes: see `tests/messages.rs`.
