//! The figures of the book.

mod circuits;
mod diagrams;
mod gallery;
mod laws;
mod page;
mod peaks;
mod problems;
mod rates;
mod walking;

use std::error::Error;

pub use gallery::{Entry, gallery};

/// A file of the book.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Its name, without a folder.
    pub file: String,
    /// Its content.
    pub svg: String,
}

/// All figures, in the order in which they are written.
///
/// # Errors
/// If a mechanism does not close, or if there is no such motion law. With the numbers of the figures, neither happens.
pub fn all() -> Result<Vec<Figure>, Box<dyn Error>> {
    let mut figures = vec![
        page::page()?,
        diagrams::four_bar()?,
        diagrams::open_and_crossed()?,
        diagrams::dyads(),
        diagrams::torn_triad(),
        diagrams::coupler_curve()?,
        rates::jerk_and_snap()?,
        laws::motion_laws()?,
        circuits::circuits()?,
        peaks::peaks()?,
        walking::walking()?,
        problems::straight_lines()?,
        problems::flat_steps()?,
        problems::eighteen_points()?,
        diagrams::pipeline(),
    ];
    figures.extend(gallery()?.iter().map(Entry::figure));
    Ok(figures)
}
