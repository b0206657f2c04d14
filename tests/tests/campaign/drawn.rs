//! Trees of links, written by `generator.rs`.

use kin_core::mechanism;

use crate::taylor::Taylor;
use crate::vectors::{Flat, Spatial, polar};

mechanism! {
    /// [Slider, Gear, Gear, Lever].
    pub struct Drawn0 {
        pub a0: Point,
        pub a1: Vector,
        pub a2: Length,
        pub a3: Point,
        pub a4: Angle,
        pub a5: Scalar,
        pub a6: Angle,
        pub a7: Scalar,
        pub a8: Angle,
        pub a9: Point,
        pub a10: Vector,
        pub a11: Point,
        pub a12: Vector,
    }
    input theta: Angle;
    unknown x0: Angle, x1: Length, x2: Angle, x3: Angle, x4: Length, x5: Angle;

    let point0 = a0 + a1 * cis(theta);
    point0 + a2 * cis(x0) == a3 + x1 * cis(a4);
    x2 == a5 * theta + a6;
    x3 == a7 * x0 + a8;
    let point1 = a9 + a10 * cis(x2);
    let point2 = a11 + a12 * cis(x2);
    point1 == point2 + x4 * cis(x5);
}

pub(super) fn closure0(p: &[Taylor], q: &[Taylor], u: &[Taylor]) -> Vec<Taylor> {
    let mut rows = Vec::new();
    let point0 = Flat::new(&p[0..]).plus(Flat::new(&p[2..]).turned(q[0]));
    rows.extend(point0.plus(polar(p[4], u[0])).minus(Flat::new(&p[5..]).plus(polar(u[1], p[7]))).0);
    rows.extend([u[2] - p[8] * q[0] - p[9]]);
    rows.extend([u[3] - p[10] * u[0] - p[11]]);
    let point1 = Flat::new(&p[12..]).plus(Flat::new(&p[14..]).turned(u[2]));
    let point2 = Flat::new(&p[16..]).plus(Flat::new(&p[18..]).turned(u[2]));
    rows.extend(point1.minus(point2.plus(polar(u[4], u[5]))).0);
    rows
}

mechanism! {
    /// [Dyad, Plate, Slider, Slider].
    pub struct Drawn1 {
        pub a0: Point,
        pub a1: Vector,
        pub a2: Point,
        pub a3: Vector,
        pub a4: Length,
        pub a5: Length,
        pub a6: Vector,
        pub a7: Point,
        pub a8: Point,
        pub a9: Length,
        pub a10: Length,
        pub a11: Length,
        pub a12: Vector,
        pub a13: Vector,
        pub a14: Vector,
        pub a15: Length,
        pub a16: Point,
        pub a17: Angle,
        pub a18: Vector,
        pub a19: Length,
        pub a20: Point,
        pub a21: Angle,
    }
    input theta: Angle;
    unknown x0: Angle, x1: Angle, x2: Angle, x3: Angle, x4: Angle, x5: Angle, x6: Angle, x7: Length, x8: Angle, x9: Length;

    let point0 = a0 + a1 * cis(theta);
    let point1 = a2 + a3 * cis(theta);
    point0 + a4 * cis(x0) == point1 + a5 * cis(x1);
    let point2 = point1 + a6 * cis(x1);
    point2 + a9 * cis(x2) + a12 * cis(x5) == a7 + a10 * cis(x3);
    point2 + a9 * cis(x2) + a13 * cis(x5) == a8 + a11 * cis(x4);
    let point3 = point1 + a14 * cis(x1);
    point3 + a15 * cis(x6) == a16 + x7 * cis(a17);
    let point4 = point0 + a18 * cis(x0);
    point4 + a19 * cis(x8) == a20 + x9 * cis(a21);
}

pub(super) fn closure1(p: &[Taylor], q: &[Taylor], u: &[Taylor]) -> Vec<Taylor> {
    let mut rows = Vec::new();
    let point0 = Flat::new(&p[0..]).plus(Flat::new(&p[2..]).turned(q[0]));
    let point1 = Flat::new(&p[4..]).plus(Flat::new(&p[6..]).turned(q[0]));
    rows.extend(point0.plus(polar(p[8], u[0])).minus(point1.plus(polar(p[9], u[1]))).0);
    let point2 = point1.plus(Flat::new(&p[10..]).turned(u[1]));
    rows.extend(point2.plus(polar(p[16], u[2])).plus(Flat::new(&p[19..]).turned(u[5])).minus(Flat::new(&p[12..]).plus(polar(p[17], u[3]))).0);
    rows.extend(point2.plus(polar(p[16], u[2])).plus(Flat::new(&p[21..]).turned(u[5])).minus(Flat::new(&p[14..]).plus(polar(p[18], u[4]))).0);
    let point3 = point1.plus(Flat::new(&p[23..]).turned(u[1]));
    rows.extend(point3.plus(polar(p[25], u[6])).minus(Flat::new(&p[26..]).plus(polar(u[7], p[28]))).0);
    let point4 = point0.plus(Flat::new(&p[29..]).turned(u[0]));
    rows.extend(point4.plus(polar(p[31], u[8])).minus(Flat::new(&p[32..]).plus(polar(u[9], p[34]))).0);
    rows
}

mechanism! {
    /// [Spatial, Slider, Dyad, Lever].
    pub struct Drawn2 {
        pub a0: Length,
        pub a1: Point3,
        pub a2: Vector3,
        pub a3: Vector3,
        pub a4: Length,
        pub a5: Point,
        pub a6: Vector,
        pub a7: Length,
        pub a8: Point,
        pub a9: Angle,
        pub a10: Point,
        pub a11: Vector,
        pub a12: Length,
        pub a13: Length,
        pub a14: Vector,
        pub a15: Point,
    }
    input theta: Angle;
    unknown x0: Angle, x1: Angle, x2: Length, x3: Angle, x4: Angle, x5: Length, x6: Angle;

    let coupler1 = a1 + rot(a2, x0) * a3 - rot_z(theta) * vec3(a0, 0, 0);
    dot(coupler1, coupler1) == a4.powi(2);
    let point0 = a5 + a6 * cis(theta);
    point0 + a7 * cis(x1) == a8 + x2 * cis(a9);
    let point1 = a8 + x2 * cis(a9);
    let point2 = a10 + a11 * cis(theta);
    point1 + a12 * cis(x3) == point2 + a13 * cis(x4);
    let point3 = point1 + a14 * cis(x3);
    point3 == a15 + x5 * cis(x6);
}

pub(super) fn closure2(p: &[Taylor], q: &[Taylor], u: &[Taylor]) -> Vec<Taylor> {
    let mut rows = Vec::new();
    let coupler1 = Spatial::new(&p[1..]).plus(Spatial::new(&p[7..]).turned(Spatial::new(&p[4..]), u[0])).minus(Spatial::flat(polar(p[0], q[0])));
    rows.extend([coupler1.dot(coupler1) - p[10] * p[10]]);
    let point0 = Flat::new(&p[11..]).plus(Flat::new(&p[13..]).turned(q[0]));
    rows.extend(point0.plus(polar(p[15], u[1])).minus(Flat::new(&p[16..]).plus(polar(u[2], p[18]))).0);
    let point1 = Flat::new(&p[16..]).plus(polar(u[2], p[18]));
    let point2 = Flat::new(&p[19..]).plus(Flat::new(&p[21..]).turned(q[0]));
    rows.extend(point1.plus(polar(p[23], u[3])).minus(point2.plus(polar(p[24], u[4]))).0);
    let point3 = point1.plus(Flat::new(&p[25..]).turned(u[3]));
    rows.extend(point3.minus(Flat::new(&p[27..]).plus(polar(u[5], u[6]))).0);
    rows
}
