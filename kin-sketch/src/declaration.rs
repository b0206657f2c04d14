//! The declaration of a drawing.

use crate::fault::SketchFault;
use crate::freedom;
use crate::names::Names;
use crate::placement::place;
use crate::sketch::Sketch;
use crate::statements;

/// A drawing as a declaration, with the values that the drawing has.
#[derive(Clone, Debug, PartialEq)]
pub struct SketchDeclaration {
    /// The text of the declaration, as it stands between the braces of `mechanism!`.
    pub text: String,
    /// The dimensions in the order of the declaration: `r2`, or `r3_c.x` and `r3_c.y` for a vector. Lengths are in the
    /// drawing's unit, angles in radians.
    pub dimensions: Vec<(String, f64)>,
    /// The inputs in the order of the drives.
    pub inputs: Vec<(String, f64)>,
    /// The unknowns in the order of the declaration.
    pub unknowns: Vec<(String, f64)>,
    /// The origin of the declaration in the drawing. The axes have the same directions.
    pub origin: [f64; 2],
}

impl Sketch {
    /// Writes the declaration whose motion is that of the drawing. Each loop becomes an equation of vectors; a joint
    /// that several links share is named by a `let`, any other point of a link by an output.
    ///
    /// # Errors
    /// Every fault of the drawing: parts that make no sense, or, if there are none, too many drives or too few.
    pub fn declaration(&self) -> Result<SketchDeclaration, Vec<SketchFault>> {
        let mut faults = self.faults();
        let mut names = Names::default();
        faults.extend(self.name_faults(&mut names));
        if !faults.is_empty() {
            return Err(faults);
        }
        let placement = place(self);
        if let Some(fault) = freedom::check(self, &placement) {
            return Err(vec![fault]);
        }
        Ok(statements::declaration(self, &placement, names))
    }

    /// Takes the names of the points, and complains of names that cannot be.
    fn name_faults(&self, names: &mut Names) -> Vec<SketchFault> {
        let links = self.links.iter().map(|link| &link.name).filter(|name| !name.is_empty());
        let all = std::iter::once(&self.name)
            .chain(links)
            .chain(self.points.iter().map(|point| &point.name));
        let complaints = all.filter_map(|name| kin_compiler::name_mistake(name));
        let mut faults: Vec<_> = complaints.map(SketchFault::Name).collect();
        for point in &self.points {
            if !names.take_as_it_is(&point.name) {
                let message = format!("two points are called `{}`: choose another name for one", point.name);
                faults.push(SketchFault::Name(message));
            }
        }
        for (number, link) in self.links.iter().enumerate() {
            if !link.name.is_empty() && self.links[..number].iter().any(|other| other.name == link.name) {
                let message = format!("two links are called `{}`: choose another name for one", link.name);
                faults.push(SketchFault::Name(message));
            }
        }
        faults
    }
}
