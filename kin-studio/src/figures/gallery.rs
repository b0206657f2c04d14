//! One small drawing for each mechanism of the library.

use kin_core::in_small_letters;
use kin_core::prelude::*;

use super::Figure;
use crate::drawing::{Scene, Style, draw};
use crate::library::{self, Visitor};

/// All mechanisms of the library, in the order of the book's table.
///
/// # Errors
/// If a mechanism does not close.
pub fn gallery() -> Result<Vec<Entry>, SolveError> {
    let mut drawn = Drawn(Ok(Vec::new()));
    library::visit(&mut drawn);
    drawn.0
}

/// The entries up to here, or the first error.
struct Drawn(Result<Vec<Entry>, SolveError>);

impl Visitor for Drawn {
    fn visit<M: Mechanism<Scalar = f64> + 'static>(
        &mut self,
        mechanism: &M,
        inputs: M::Inputs<f64>,
        assembly: M::Assembly,
    ) {
        let Ok(entries) = &mut self.0 else { return };
        match Scene::of_mechanism(mechanism, inputs, assembly) {
            Ok(scene) => entries.push(Entry {
                name: M::DESCRIPTION.name,
                scene,
            }),
            Err(error) => self.0 = Err(error),
        }
    }
}

/// A mechanism of the gallery.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its name.
    pub name: &'static str,
    /// Its drawing.
    pub scene: Scene,
}

impl Entry {
    /// The drawing.
    #[must_use]
    pub fn figure(&self) -> Figure {
        let style = Style {
            width: 300.0,
            height: 240.0,
            title: self.name.to_owned(),
            names: true,
        };
        Figure {
            file: format!("gallery-{}.svg", in_small_letters(self.name, '-')),
            svg: draw(&self.scene, &style),
        }
    }
}
