//! Declared mechanisms to put the macro to the test.

pub mod four_bar_typings;
