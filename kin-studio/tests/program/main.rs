//! The program, as a person types it.

mod chapters;
mod codes;
mod commands;
mod files;
mod imported;
mod mistakes;
mod serving;
mod typed;
