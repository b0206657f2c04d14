//! Bodies of space.

use kin_precise::Number;

use super::super::series::{Series, number};
use super::{COUNT, Forces, System, constant, moved, positions, rate, rates, times, with_conditions, zero};

/// How the joints follow from a crank, which turns about z.
#[derive(Clone, Copy, Debug)]
pub enum SpaceShape {
    /// A rod between two ball joints, from the crank to a rocker: by crank, pivot, axis, arm and rod, where the ball
    /// of the rocker would move away from the crank's if the rocker alone turned on about its axis. Its joints: base, a
    /// point above it, pin, pivot, ball, and a tip that turns with the rocker.
    Rssr,
    /// A rod between two ball joints, from the crank to a block on a rail: by crank, start, rail and rod, with the
    /// block as far along the rail as the rod lets it. Its joints: base, a point above it, pin, ball, and two more of
    /// the block, which lie beside the ball and above it.
    Rssp,
}

/// How a body resists being turned, about its centre.
#[derive(Clone, Copy, Debug)]
pub enum Inertia {
    /// A rod has one moment of inertia across its line, and none about it.
    Rod(f64),
    /// The tensor in the frame of the body: xx, yy, zz, xy, xz, yz.
    Tensor([f64; 6]),
}

/// A body with its mass. Its frame lies in its first joint, its first axis leads to the second one, and the third joint
/// lies on the side of its second axis.
#[derive(Clone, Copy, Debug)]
pub struct Solid {
    /// Its name.
    pub name: &'static str,
    /// Its joints, by their index; the last one is the second again for a rod.
    pub joints: [usize; 3],
    /// Its mass.
    pub mass: f64,
    /// The centre of mass in its frame.
    pub centre: [f64; 3],
    /// Its inertia.
    pub inertia: Inertia,
}

/// What a joint holds.
#[derive(Clone, Copy, Debug)]
pub enum JointKind {
    /// It has a force alone.
    Ball,
    /// It has moments across the axis with this index, too: the crank's, or the one of the dimensions.
    Hinge(usize),
    /// It has a force across the axis with this index, and all moments.
    Guide(usize),
}

/// What holds two bodies together.
#[derive(Clone, Copy, Debug)]
pub struct Joint {
    /// The name of the force.
    pub name: &'static str,
    /// The joint where it acts, by its index.
    pub joint: usize,
    /// The body on which it acts.
    pub on: usize,
    /// The body that exerts it; without one, the ground.
    pub by: Option<usize>,
    /// What it holds.
    pub kind: JointKind,
}

/// A mechanism of space in motion, of which the first body is driven.
#[derive(Clone, Copy, Debug)]
pub struct SpaceCut {
    /// How it closes.
    pub shape: SpaceShape,
    /// The dimensions of the shape, vectors by their coordinates.
    pub dimensions: &'static [f64],
    /// Its bodies.
    pub bodies: &'static [Solid],
    /// Its joints.
    pub joints: &'static [Joint],
    /// The acceleration of gravity.
    pub gravity: [f64; 3],
    /// A force on a body at a joint.
    pub force: (usize, usize, [f64; 3]),
    /// The motion of the crank through snap.
    pub motion: [f64; COUNT],
}

type Vector = [Series; 3];

fn plus(one: &Vector, other: &Vector) -> Vector {
    core::array::from_fn(|part| one[part].plus(&other[part]))
}

fn minus(one: &Vector, other: &Vector) -> Vector {
    core::array::from_fn(|part| one[part].minus(&other[part]))
}

fn scaled(vector: &Vector, factor: &Series) -> Vector {
    vector.each_ref().map(|part| times(part, factor))
}

fn dot(one: &Vector, other: &Vector) -> Series {
    one.iter()
        .zip(other)
        .fold(zero(), |sum, (one, other)| sum.plus(&times(one, other)))
}

fn cross([x, y, z]: &Vector, [u, v, w]: &Vector) -> Vector {
    let part = |a: &Series, b: &Series, c: &Series, d: &Series| times(a, d).minus(&times(b, c));
    [part(y, z, v, w), part(z, x, w, u), part(x, y, u, v)]
}

fn unit(vector: &Vector) -> Vector {
    let length = dot(vector, vector).sqrt(COUNT);
    vector.each_ref().map(|part| part.over(&length, COUNT))
}

fn slope(vector: &Vector) -> Vector {
    vector.each_ref().map(rate)
}

/// The vector of this length along an axis of coordinates.
fn along(axis: usize, length: &Series) -> Vector {
    core::array::from_fn(|part| if part == axis { length.clone() } else { zero() })
}

fn nothing() -> Vector {
    along(0, &zero())
}

fn one() -> Series {
    constant(&number(1))
}

/// The index of the coordinate that is largest now.
fn largest(vector: &Vector) -> usize {
    let size = |part: &usize| vector[*part].coefficient(0).nearest().abs();
    let all = [0, 1, 2].into_iter();
    all.max_by(|one, other| size(one).total_cmp(&size(other))).unwrap_or(0)
}

/// Two vectors across an axis.
fn across(axis: &Vector) -> [Vector; 2] {
    let first = cross(axis, &along((largest(axis) + 1) % 3, &one()));
    let second = cross(axis, &first);
    [first, second]
}

/// The positions of the joints, and the axes.
fn places(shape: SpaceShape, dimensions: &[Series], angle: &Series) -> (Vec<Vector>, [Vector; 2]) {
    let (sine, cosine) = angle.sin_cos(COUNT);
    let vector = |first: usize| -> Vector { core::array::from_fn(|part| dimensions[first + part].clone()) };
    let crank = &dimensions[0];
    let pin = scaled(&[cosine, sine, zero()], crank);
    let mut all = vec![nothing(), along(2, crank), pin.clone()];
    let direction = match shape {
        SpaceShape::Rssr => {
            let (pivot, axis, arm, rod) = (vector(1), unit(&vector(4)), vector(7), &dimensions[10]);
            // a vector turns as a part along the axis, a part across it by the cosine, and one beside by the sine
            let parts = |vector: &Vector| {
                let level = scaled(&axis, &dot(vector, &axis));
                [level.clone(), minus(vector, &level), cross(&axis, vector)]
            };
            let [level, ahead, beside] = parts(&arm);
            let from = minus(&plus(&pivot, &level), &pin);
            // the length of the rod is a b = c with the unknown b = (cosine, sine)
            let [a, b] = [dot(&from, &ahead), dot(&from, &beside)];
            let squares = times(rod, rod).minus(&dot(&from, &from)).minus(&dot(&ahead, &ahead));
            let c = squares.over(&constant(&number(2)), COUNT);
            let square = times(&a, &a).plus(&times(&b, &b));
            let root = square.minus(&times(&c, &c)).sqrt(COUNT);
            let cosine = times(&a, &c).plus(&times(&b, &root)).over(&square, COUNT);
            let sine = times(&b, &c).minus(&times(&a, &root)).over(&square, COUNT);
            let turned = |vector: &Vector| {
                let [level, ahead, beside] = parts(vector);
                let moved = plus(&scaled(&ahead, &cosine), &scaled(&beside, &sine));
                plus(&pivot, &plus(&level, &moved))
            };
            all.extend([pivot.clone(), turned(&arm), turned(&along(0, crank))]);
            axis
        }
        SpaceShape::Rssp => {
            let (start, rail, rod) = (vector(1), unit(&vector(4)), &dimensions[7]);
            let from = minus(&start, &pin);
            let back = dot(&from, &rail);
            let square = times(&back, &back).minus(&dot(&from, &from)).plus(&times(rod, rod));
            let ball = plus(&start, &scaled(&rail, &square.sqrt(COUNT).minus(&back)));
            let more = [1, 2].map(|axis| plus(&ball, &along(axis, crank)));
            all.push(ball);
            all.extend(more);
            rail
        }
    };
    (all, [along(2, &one()), direction])
}

/// The forces, where each given number is changed by a factor.
fn forces(cut: &SpaceCut, factor: &dyn Fn(usize) -> Number) -> Forces {
    let mut count = 0;
    let mut given = |value: f64| {
        count += 1;
        &Number::exactly(value) * &factor(count - 1)
    };
    let dimensions: Vec<Series> = cut.dimensions.iter().map(|own| constant(&given(*own))).collect();
    let angle = moved(&cut.motion, &mut given);
    let (places, axes) = places(cut.shape, &dimensions, &angle);
    let gravity = cut.gravity.map(|part| constant(&given(part)));
    let (mut lacking, mut centres, mut rows) = (Vec::new(), Vec::new(), Vec::new());
    for (index, body) in cut.bodies.iter().enumerate() {
        let [first, second, third] = body.joints.map(|joint| &places[joint]);
        let line = unit(&minus(second, first));
        let mass = constant(&given(body.mass));
        let offset = body.centre.map(|part| constant(&given(part)));
        // the arm of the centre, the rate of the angular momentum about it, and the row of moments that a rod lacks
        let (arm, change, lost) = match body.inertia {
            Inertia::Rod(inertia) => {
                let turn = cross(&line, &slope(&line));
                let momentum = scaled(&turn, &constant(&given(inertia)));
                (scaled(&line, &offset[0]), slope(&momentum), Some(largest(&line)))
            }
            Inertia::Tensor(inertia) => {
                let normal = unit(&cross(&line, &minus(third, first)));
                let frame = [line.clone(), cross(&normal, &line), normal];
                let sum = |all: [Vector; 3]| all.iter().fold(nothing(), |sum, own| plus(&sum, own));
                let half = constant(&(&number(1) / &number(2)));
                let turn = scaled(&sum(frame.each_ref().map(|axis| cross(axis, &slope(axis)))), &half);
                let [xx, yy, zz, xy, xz, yz] = inertia.map(|own| constant(&given(own)));
                let tensor = [[&xx, &xy, &xz], [&xy, &yy, &yz], [&xz, &yz, &zz]];
                let own = frame.each_ref().map(|axis| dot(axis, &turn));
                let of = |row: usize| (0..3).fold(zero(), |sum, part| sum.plus(&times(tensor[row][part], &own[part])));
                let by = |parts: [Series; 3]| sum(core::array::from_fn(|axis| scaled(&frame[axis], &parts[axis])));
                (by(offset), slope(&by([of(0), of(1), of(2)])), None)
            }
        };
        let centre = plus(first, &arm);
        let acceleration = minus(&slope(&slope(&centre)), &gravity);
        lacking.extend(scaled(&acceleration, &mass));
        lacking.extend(change);
        centres.push(centre);
        let own = (0..6).filter(|row| lost.is_none_or(|lost| *row != 3 + lost));
        rows.extend(own.map(|row| 6 * index + row));
    }
    // what a force and a moment exert on a body
    let exerted = |body: usize, joint: usize, force: &Vector, moment: &Vector| {
        let arm = minus(&places[joint], &centres[body]);
        let moment = plus(&cross(&arm, force), moment);
        force.iter().chain(&moment).cloned().collect::<Vec<_>>()
    };
    let (body, joint, force) = cut.force;
    let load = exerted(body, joint, &force.map(|part| constant(&given(part))), &nothing());
    for (own, part) in lacking[6 * body..].iter_mut().zip(&load) {
        *own = own.minus(part);
    }

    // a unit of each unknown: its connection, its force, and its moment
    let whole = || [0, 1, 2].map(|axis| along(axis, &one()));
    let mut units: Vec<(&Joint, Vector, Vector)> = Vec::new();
    for own in cut.joints {
        let (forces, moments) = match own.kind {
            JointKind::Ball => (whole().to_vec(), Vec::new()),
            JointKind::Hinge(axis) => (whole().to_vec(), across(&axes[axis]).to_vec()),
            JointKind::Guide(axis) => (across(&axes[axis]).to_vec(), whole().to_vec()),
        };
        units.extend(forces.into_iter().map(|force| (own, force, nothing())));
        units.extend(moments.into_iter().map(|moment| (own, nothing(), moment)));
    }
    let mut columns: Vec<Vec<Series>> = Vec::new();
    for (own, force, moment) in &units {
        let mut column = vec![zero(); lacking.len()];
        for (body, sign) in [(Some(own.on), 1), (own.by, -1)] {
            let Some(body) = body else { continue };
            for (row, part) in exerted(body, own.joint, force, moment).into_iter().enumerate() {
                column[6 * body + row] = if sign > 0 { part } else { part.negated() };
            }
        }
        columns.push(column);
    }
    let mut drive = vec![zero(); lacking.len()];
    for (row, part) in exerted(0, 0, &nothing(), &axes[0]).into_iter().enumerate() {
        drive[row] = part;
    }
    columns.push(drive);
    let kept = |all: &[Series]| -> Vec<Series> { rows.iter().map(|row| all[*row].clone()).collect() };
    let columns: Vec<Vec<Series>> = columns.iter().map(|column| kept(column)).collect();
    let values = System::new(&columns).solve(&kept(&lacking));

    let connections = cut.joints.iter().map(|own| {
        let mut sums = [nothing(), nothing()];
        for ((joint, force, moment), value) in units.iter().zip(&values) {
            if joint.name == own.name {
                sums = [(&sums[0], force), (&sums[1], moment)].map(|(sum, unit)| plus(sum, &scaled(unit, value)));
            }
        }
        sums.iter().flatten().map(rates).collect()
    });
    Forces {
        connections: connections.collect(),
        torque: rates(&values[units.len()]),
        heat: rates(&zero()),
        places: positions(&places),
    }
}

impl SpaceCut {
    /// The forces with the conditions of their numbers.
    ///
    /// # Panics
    /// If the joints do not hold the bodies.
    #[must_use]
    pub fn forces(&self) -> (Forces, Vec<f64>) {
        with_conditions(|factor| forces(self, factor))
    }
}
