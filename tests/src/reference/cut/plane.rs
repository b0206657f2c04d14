//! Bodies of the plane, with friction in their joints.

use kin_precise::Number;

use super::super::series::{Series, number};
use super::{COUNT, Forces, ORDERS, System, constant, moved, positions, rate, rates, times, with_conditions, zero};

/// Digits of the friction that a fixed point leaves open.
const OPEN: f64 = 1e-66;
/// Steps of the fixed point at most.
const STEPS: usize = 400;

/// How the joints follow from the crank.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// A four-bar linkage, by ground, crank, coupler and rocker, with the knee at the left of the line from the crank's
    /// pin to the pivot of the rocker. Its joints: base, pin, knee, pivot.
    FourBar,
    /// A slider-crank by crank and rod, with the slider on the x axis before the crank. Its joints: base, pin, slider.
    SliderCrank,
}

/// A body with its mass. Its frame lies in its first joint, and points to its second one, or along x.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// Its name.
    pub name: &'static str,
    /// Its joints, by their index.
    pub joints: (usize, Option<usize>),
    /// Its mass.
    pub mass: f64,
    /// The centre of mass in its frame.
    pub centre: [f64; 2],
    /// The moment of inertia about the centre.
    pub inertia: f64,
}

/// What holds two bodies together.
#[derive(Clone, Copy, Debug)]
pub struct Connection {
    /// The name of the force.
    pub name: &'static str,
    /// The joint where it acts, by its index.
    pub joint: usize,
    /// The body on which it acts.
    pub on: usize,
    /// The body that exerts it; without one, the ground.
    pub by: Option<usize>,
    /// The coefficient of friction.
    pub coefficient: f64,
    /// The radius of a pin. A slide along x has none; it has a normal force and a moment.
    pub radius: Option<f64>,
}

/// A mechanism of the plane in motion, of which the first body is driven.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    /// How it closes.
    pub shape: Shape,
    /// The dimensions of the shape.
    pub dimensions: &'static [f64],
    /// Its bodies.
    pub bodies: &'static [Body],
    /// Its joints.
    pub connections: &'static [Connection],
    /// The acceleration of gravity.
    pub gravity: [f64; 2],
    /// A force on a body at its first joint.
    pub force: Option<(usize, [f64; 2])>,
    /// The motion of the crank through snap.
    pub motion: [f64; COUNT],
}

type Point = [Series; 2];

fn plus([x, y]: &Point, [u, v]: &Point) -> Point {
    [x.plus(u), y.plus(v)]
}

fn minus([x, y]: &Point, [u, v]: &Point) -> Point {
    [x.minus(u), y.minus(v)]
}

fn scaled([x, y]: &Point, factor: &Series) -> Point {
    [times(x, factor), times(y, factor)]
}

fn cross([x, y]: &Point, [u, v]: &Point) -> Series {
    times(x, v).minus(&times(y, u))
}

fn square([x, y]: &Point) -> Series {
    times(x, x).plus(&times(y, y))
}

fn left([x, y]: &Point) -> Point {
    [y.negated(), x.clone()]
}

/// The positions of the joints.
fn places(shape: Shape, dimensions: &[Series], angle: &Series) -> Vec<Point> {
    let (sine, cosine) = angle.sin_cos(COUNT);
    match (shape, dimensions) {
        (Shape::FourBar, [ground, crank, coupler, rocker]) => {
            let pin = scaled(&[cosine, sine], crank);
            let pivot = [ground.clone(), zero()];
            let line = minus(&pivot, &pin);
            // where the circles about pin and pivot intersect, along the line between their centres and beside it
            let length = square(&line);
            let double = length.plus(&length);
            let squares = times(coupler, coupler).minus(&times(rocker, rocker));
            let along = squares.plus(&length).over(&double, COUNT);
            let beside = times(coupler, coupler).over(&length, COUNT);
            let beside = beside.minus(&times(&along, &along)).sqrt(COUNT);
            let knee = plus(&scaled(&line, &along), &scaled(&left(&line), &beside));
            vec![[zero(), zero()], pin.clone(), plus(&pin, &knee), pivot]
        }
        (Shape::SliderCrank, [crank, rod]) => {
            let pin = scaled(&[cosine, sine], crank);
            let beside = times(rod, rod).minus(&times(&pin[1], &pin[1])).sqrt(COUNT);
            let slider = [pin[0].plus(&beside), zero()];
            vec![[zero(), zero()], pin, slider]
        }
        _ => panic!("{shape:?} has other dimensions"),
    }
}

/// A body in motion.
struct Moving {
    centre: Point,
    turn: Series,
}

/// The forces, where each given number is changed by a factor.
fn forces(cut: &Cut, factor: impl Fn(usize) -> Number) -> Forces {
    let mut count = 0;
    let mut given = |value: f64| {
        count += 1;
        &Number::exactly(value) * &factor(count - 1)
    };
    let dimensions: Vec<Series> = cut.dimensions.iter().map(|own| constant(&given(*own))).collect();
    let angle = moved(&cut.motion, &mut given);
    let places = places(cut.shape, &dimensions, &angle);
    let gravity = cut.gravity.map(&mut given);
    let mut lacking = Vec::new();
    let mut moving = Vec::new();
    for body in cut.bodies {
        let (first, second) = body.joints;
        let axis = second.map_or_else(
            || [constant(&number(1)), zero()],
            |second| {
                let line = minus(&places[second], &places[first]);
                let length = square(&line).sqrt(COUNT);
                line.map(|part| part.over(&length, COUNT))
            },
        );
        let [x, y] = body.centre.map(|part| constant(&given(part)));
        let offset = plus(&scaled(&axis, &x), &scaled(&left(&axis), &y));
        let centre = plus(&places[first], &offset);
        let [mass, inertia] = [body.mass, body.inertia].map(|own| constant(&given(own)));
        let acceleration: [Series; 2] = [0, 1].map(|part| rate(&rate(&centre[part])).minus(&constant(&gravity[part])));
        let turn = cross(&axis, &axis.clone().map(|part| rate(&part)));
        let [along, across] = scaled(&acceleration, &mass);
        lacking.extend([along, across, times(&inertia, &rate(&turn))]);
        moving.push(Moving { centre, turn });
    }
    if let Some((body, force)) = cut.force {
        let force = force.map(|part| constant(&given(part)));
        let arm = minus(&places[cut.bodies[body].joints.0], &moving[body].centre);
        let [x, y] = force.clone();
        for (row, part) in [x, y, cross(&arm, &force)].iter().enumerate() {
            lacking[3 * body + row] = lacking[3 * body + row].minus(part);
        }
    }
    let frictions: Vec<[Number; 2]> = cut
        .connections
        .iter()
        .map(|own| [given(own.coefficient), own.radius.map_or_else(|| number(1), &mut given)])
        .collect();

    // the columns of the system: what a unit of each unknown exerts on all bodies
    let size = lacking.len();
    let one = constant(&number(1));
    let mut columns: Vec<Vec<Series>> = Vec::new();
    let wrench = |connection: &Connection, force: &Point, moment: &Series| {
        let mut column = vec![zero(); size];
        for (body, sign) in [(Some(connection.on), 1), (connection.by, -1)] {
            let Some(body) = body else { continue };
            let arm = minus(&places[connection.joint], &moving[body].centre);
            let moment = cross(&arm, force).plus(moment);
            for (row, part) in [force[0].clone(), force[1].clone(), moment].into_iter().enumerate() {
                column[3 * body + row] = if sign > 0 { part } else { part.negated() };
            }
        }
        column
    };
    let [right, up] = [[one.clone(), zero()], [zero(), one.clone()]];
    for connection in cut.connections {
        if connection.radius.is_some() {
            columns.push(wrench(connection, &right, &zero()));
            columns.push(wrench(connection, &up, &zero()));
        } else {
            columns.push(wrench(connection, &up, &zero()));
            columns.push(wrench(connection, &[zero(), zero()], &one));
        }
    }
    let mut drive = vec![zero(); size];
    drive[2] = one.clone();
    columns.push(drive);
    let system = System::new(&columns);

    // friction by its fixed point
    let speeds: Vec<Series> = cut
        .connections
        .iter()
        .map(|own| {
            if own.radius.is_some() {
                let turn = |body: Option<usize>| body.map_or_else(zero, |body| moving[body].turn.clone());
                turn(Some(own.on)).minus(&turn(own.by))
            } else {
                rate(&places[own.joint][0])
            }
        })
        .collect();
    let opposed = |index: usize| -speeds[index].coefficient(0).nearest().signum();
    let mut friction = vec![zero(); cut.connections.len()];
    let mut values = Vec::new();
    for step in 0.. {
        assert!(step < STEPS, "friction does not converge");
        let mut right = lacking.clone();
        for (index, (connection, friction)) in cut.connections.iter().zip(&friction).enumerate() {
            let own = times(friction, &constant(&Number::exactly(opposed(index))));
            let column = if connection.radius.is_some() {
                wrench(connection, &[zero(), zero()], &own)
            } else {
                wrench(connection, &[own, zero()], &zero())
            };
            right = right.iter().zip(&column).map(|(right, own)| right.minus(own)).collect();
        }
        values = system.solve(&right);
        let mut change: f64 = 0.0;
        for (index, connection) in cut.connections.iter().enumerate() {
            let [first, second] = [&values[2 * index], &values[2 * index + 1]];
            let size = if connection.radius.is_some() {
                square(&[first.clone(), second.clone()]).sqrt(ORDERS).cut(ORDERS)
            } else if first.coefficient(0).nearest() < 0.0 {
                first.negated()
            } else {
                first.clone()
            };
            let [coefficient, radius] = &frictions[index];
            let next = times(&size, &constant(&(coefficient * radius)));
            for power in 0..ORDERS {
                let [next, before] = [&next, &friction[index]].map(|own| own.coefficient(power));
                change = change.max(((&next - &before).nearest() / next.nearest().abs().max(1.0)).abs());
            }
            friction[index] = next;
        }
        if change < OPEN {
            break;
        }
    }

    let mut heat = zero();
    let mut connections = Vec::new();
    for (index, connection) in cut.connections.iter().enumerate() {
        let own = times(&friction[index], &constant(&Number::exactly(opposed(index))));
        heat = heat.minus(&times(&own, &speeds[index]));
        let [first, second] = [&values[2 * index], &values[2 * index + 1]];
        connections.push(if connection.radius.is_some() {
            [first, second, &own].map(rates).to_vec()
        } else {
            [&own, first, second].map(rates).to_vec()
        });
    }
    Forces {
        connections,
        torque: rates(&values[size - 1]),
        heat: rates(&heat),
        places: positions(&places),
    }
}

impl Cut {
    /// The forces with the conditions of their numbers.
    ///
    /// # Panics
    /// If the joints do not hold the bodies.
    #[must_use]
    pub fn forces(&self) -> (Forces, Vec<f64>) {
        with_conditions(|factor| forces(self, factor))
    }
}
