//! Sheets as flat code, compared with generated code to the last bit.

mod agreement;
mod bits;
mod library;
mod own;
mod random;
