//! Random declarations, compiled, and solved against both oracles: see `tests/sample.rs`.
