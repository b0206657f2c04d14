//! The number of ways in which a drawing moves, from the rank of its equations in the pose that is drawn.
//!
//! Counts of links and joints (Chebyshev, Grübler, Kutzbach) miss what moves only because its lengths fit, as a third
//! rod of a parallelogram. The rank finds it.

use std::collections::BTreeMap;

use nalgebra::DMatrix;

use crate::fault::{SketchFault, SketchFaultKind, SketchParts, counted, listed};
use crate::local::Variable;
use crate::placement::{Placement, Step, StepKind, index, place};
use crate::sketch::{Body, Drive, PointId, Sketch};

/// How a point moves with each variable.
type Gradient = BTreeMap<Variable, [f64; 2]>;

/// A column is called zero, and a rank lower, below this part of the largest.
const RANK_TOLERANCE: f64 = 1e-8;

impl Sketch {
    fn is_input(&self, variable: Variable) -> bool {
        match variable {
            Variable::Turned(_) => true,
            Variable::Angle(_) => false,
            Variable::Slide(slide) => self.is_driven(slide),
        }
    }
}

/// The equations in the drawn pose: their derivatives by all variables.
struct Jacobian {
    variables: Vec<Variable>,
    rows: Vec<Gradient>,
    size: f64,
}

impl Jacobian {
    fn of(sketch: &Sketch, placement: &Placement) -> Self {
        let mut gradients = vec![Gradient::new(); sketch.points.len()];
        let mut rows = Vec::new();
        for step in &placement.steps {
            let Step {
                point,
                body,
                slide,
                kind,
            } = *step;
            let frame = placement.frames[index(body)];
            let [x, y] = sketch.offset(frame, point);
            let mut along = Gradient::new();
            for angle in sketch.angles_of(body) {
                along.insert(angle, [-y, x]);
            }
            if let Some(slide) = slide {
                let (sine, cosine) = sketch.slides[slide].direction.sin_cos();
                along.insert(Variable::Slide(slide), [cosine, sine]);
            }
            let of_origin = |gradients: &[Gradient]| match frame.origin {
                Some(origin) => gradients[origin].clone(),
                None => Gradient::new(),
            };
            match kind {
                StepKind::Point => gradients[point] = sum(of_origin(&gradients), &along, 1.0),
                StepKind::Origin => {
                    let origin: PointId = frame.origin.expect("a link has points");
                    gradients[origin] = sum(gradients[point].clone(), &along, -1.0);
                }
                StepKind::Closure => {
                    let through = sum(of_origin(&gradients), &along, 1.0);
                    rows.push(sum(through, &gradients[point], -1.0));
                }
            }
        }
        let links = (0..sketch.links.len()).map(Body::Link);
        let angles = links.flat_map(|link| sketch.angles_of(link));
        let slides = (0..sketch.slides.len()).map(Variable::Slide);
        let mut variables: Vec<Variable> = angles.chain(slides).collect();
        variables.sort_unstable();
        variables.dedup();
        Self {
            variables,
            rows,
            size: sketch.size().max(f64::MIN_POSITIVE),
        }
    }

    /// The number of ways in which the drawing moves.
    fn freedom(&self) -> usize {
        self.variables.len() - rank(&self.matrix(&self.variables))
    }

    /// The matrix of some variables. Lengths are divided by the drawing's size.
    fn matrix(&self, variables: &[Variable]) -> DMatrix<f64> {
        let (rows, columns) = (2 * self.rows.len(), variables.len());
        DMatrix::from_fn(rows, columns, |row, column| {
            let variable = variables[column];
            let value = self.rows[row / 2].get(&variable).map_or(0.0, |vector| vector[row % 2]);
            match variable {
                Variable::Slide(_) => value,
                Variable::Turned(_) | Variable::Angle(_) => value / self.size,
            }
        })
    }
}

fn sum(mut left: Gradient, right: &Gradient, sign: f64) -> Gradient {
    for (variable, [x, y]) in right {
        let entry = left.entry(*variable).or_default();
        entry[0] += sign * x;
        entry[1] += sign * y;
    }
    left
}

/// The rank by QR with column pivoting, which ends for any numbers; iterations for singular values need not.
fn rank(matrix: &DMatrix<f64>) -> usize {
    if matrix.is_empty() {
        return 0;
    }
    let triangle = matrix.clone().col_piv_qr().r();
    let pivots = (0..triangle.nrows()).map(|index| triangle[(index, index)].abs());
    let least = RANK_TOLERANCE * pivots.clone().fold(1e-3, f64::max);
    pivots.filter(|pivot| *pivot > least).count()
}

/// Compares the ways in which a drawing moves with its drives.
pub(crate) fn check(sketch: &Sketch, placement: &Placement) -> Option<SketchFault> {
    let jacobian = Jacobian::of(sketch, placement);
    let (inputs, unknowns): (Vec<_>, Vec<_>) = jacobian.variables.iter().partition(|it| sketch.is_input(**it));
    let of_unknowns = jacobian.matrix(&unknowns);
    let (freedom, drives) = (jacobian.freedom(), inputs.len());
    if freedom > drives {
        return Some(needs_drives(
            sketch,
            freedom,
            drives,
            undetermined(&unknowns, &of_unknowns),
        ));
    }
    // without drives nothing moves, whatever repeats
    if freedom < drives || drives == 0 {
        return Some(too_many_drives(freedom, drives));
    }
    if rank(&of_unknowns) < unknowns.len() {
        let parts = undetermined(&unknowns, &of_unknowns);
        let message = format!(
            "in the pose that is drawn the drives do not move {}",
            listed(&sketch.names_of(&parts))
        );
        let advice = "draw the linkage a little further";
        return Some(SketchFault::new(SketchFaultKind::DeadPoint, message, advice).at(parts));
    }
    let independent = jacobian.variables.len() - freedom;
    let redundant = 2 * jacobian.rows.len() - independent;
    (redundant > 0).then(|| overconstrained(sketch, redundant, removable(sketch, freedom)))
}

fn needs_drives(sketch: &Sketch, freedom: usize, drives: usize, parts: SketchParts) -> SketchFault {
    let mut message = format!(
        "the drawing moves in {} and has {}",
        counted(freedom, "way"),
        counted(drives, "drive")
    );
    let names = sketch.names_of(&parts);
    if !names.is_empty() {
        message = format!("{message}; {} can move while the drives stand still", listed(&names));
    }
    let kind = SketchFaultKind::NeedsDrives { freedom, drives };
    SketchFault::new(kind, message, "add a drive, or a link").at(parts)
}

fn too_many_drives(freedom: usize, drives: usize) -> SketchFault {
    let kind = SketchFaultKind::TooManyDrives { freedom, drives };
    if freedom == 0 {
        return SketchFault::new(kind, "the drawing cannot move", "remove a link");
    }
    let message = format!(
        "the drawing moves in {} and has {}",
        counted(freedom, "way"),
        counted(drives, "drive")
    );
    SketchFault::new(kind, message, "remove a drive")
}

fn overconstrained(sketch: &Sketch, redundant: usize, parts: SketchParts) -> SketchFault {
    let equations = match redundant {
        1 => "one equation follows".to_owned(),
        count => format!("{count} equations follow"),
    };
    let message = format!("the drawing moves only because its lengths fit, {equations} from the others");
    let advice = match &sketch.names_of(&parts)[..] {
        [] => "remove a link that only supports the others".to_owned(),
        [link] => format!("remove {link}, and nothing moves differently"),
        links => format!(
            "remove one of these, and nothing moves differently: {}",
            links.join(", ")
        ),
    };
    SketchFault::new(SketchFaultKind::Overconstrained { redundant }, message, advice).at(parts)
}

/// The links and slides that move although all drives stand still.
fn undetermined(unknowns: &[Variable], matrix: &DMatrix<f64>) -> SketchParts {
    let full = rank(matrix);
    let is_free = |column: usize| {
        // a column that the others determine leaves the rank without it as it is, minus one
        let others = matrix.clone().remove_column(column);
        rank(&others) == full
    };
    let mut parts = SketchParts::default();
    for (column, variable) in unknowns.iter().enumerate() {
        if !is_free(column) {
            continue;
        }
        match *variable {
            Variable::Angle(Body::Link(link)) | Variable::Turned(Body::Link(link)) => parts.links.push(link),
            Variable::Angle(Body::Ground) | Variable::Turned(Body::Ground) => {}
            Variable::Slide(slide) => parts.slides.push(slide),
        }
    }
    parts
}

/// The links without which the drawing moves as it does.
fn removable(sketch: &Sketch, freedom: usize) -> SketchParts {
    let is_of_drive = |link: usize| {
        let mut drives = sketch.drives.iter();
        drives.any(|drive| matches!(*drive, Drive::Angle { of, to } if of == link || to == Body::Link(link)))
    };
    let moves_alike = |link: &usize| {
        let rest = sketch.without(*link);
        rest.faults().is_empty() && {
            let jacobian = Jacobian::of(&rest, &place(&rest));
            jacobian.freedom() == freedom
        }
    };
    let links = (0..sketch.links.len()).filter(|link| !is_of_drive(*link) && !sketch.is_of_slide(*link));
    SketchParts {
        links: links.filter(moves_alike).collect(),
        ..SketchParts::default()
    }
}
