//! The declaration of a drawing.

use crate::fault::{SketchFault, SketchFaultKind};
use crate::freedom;
use crate::names::Names;
use crate::placement::place;
use crate::sketch::{LinkId, PointId, Sketch};
use crate::statements;

/// A drawing as a declaration, with the values that the drawing has.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
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
        let mut faults = Vec::new();
        let mut complain = |name: &str, points: &[PointId], links: &[LinkId]| {
            let fault = kin_compiler::name_mistake(name).map(|it| SketchFault::new(SketchFaultKind::Name, it, ""));
            faults.extend(fault.map(|fault| fault.at_points(points).at_links(links)));
        };
        complain(&self.name, &[], &[]);
        for (number, link) in self.links.iter().enumerate().filter(|(_, link)| !link.name.is_empty()) {
            complain(&link.name, &[], &[number]);
        }
        for (number, point) in self.points.iter().enumerate() {
            complain(&point.name, &[number], &[]);
        }
        let twice = |kind: &str, name: &str| {
            let message = format!("two {kind} are called `{name}`");
            SketchFault::new(SketchFaultKind::Name, message, "choose another name for one")
        };
        for (number, point) in self.points.iter().enumerate() {
            if !names.take_as_it_is(&point.name) {
                let others = (0..=number).filter(|other| self.points[*other].name == point.name);
                faults.push(twice("points", &point.name).at_points(&others.collect::<Vec<_>>()));
            }
        }
        for (number, link) in self.links.iter().enumerate() {
            let others = (0..=number).filter(|other| self.links[*other].name == link.name);
            let others: Vec<LinkId> = others.collect();
            if !link.name.is_empty() && others.len() > 1 {
                faults.push(twice("links", &link.name).at_links(&others));
            }
        }
        faults
    }
}
