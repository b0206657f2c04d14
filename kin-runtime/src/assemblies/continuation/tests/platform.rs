//! The class III triad: a ternary link on three legs.

use super::super::sequence::FixedSequence;
use super::table::Table;

/// Three legs from fixed points to three points of a platform.
#[derive(Clone, Copy, Debug)]
pub(super) struct Platform {
    pub(super) bases: [[f64; 2]; 3],
    pub(super) legs: [f64; 3],
    /// The vectors from the end of the first leg to the ends of the second and the third, fixed in the platform.
    pub(super) sides: [[f64; 2]; 2],
}

impl Platform {
    /// Random dimensions that allow at least one assembly.
    pub(super) fn random(random: &mut FixedSequence) -> Self {
        let mut vector = |size: f64| {
            [
                size * (2.0 * random.fraction() - 1.0),
                size * (2.0 * random.fraction() - 1.0),
            ]
        };
        let bases = [[0.0, 0.0], vector(2.0), vector(2.0)];
        let sides = [vector(1.5), vector(1.5)];
        let [x, y] = vector(2.0);
        let angle = vector(core::f64::consts::PI)[0];
        let mut platform = Self {
            bases,
            legs: [0.0; 3],
            sides,
        };
        platform.legs = [0, 1, 2].map(|leg| {
            let [px, py] = platform.point(leg, [x, y], angle);
            (px - bases[leg][0]).hypot(py - bases[leg][1])
        });
        platform
    }

    /// The end of a leg, given the end of the first leg and the angle of the platform.
    pub(super) fn point(&self, leg: usize, [x, y]: [f64; 2], angle: f64) -> [f64; 2] {
        if leg == 0 {
            return [x, y];
        }
        let [u, v] = self.sides[leg - 1];
        let (sine, cosine) = angle.sin_cos();
        [x + u * cosine - v * sine, y + u * sine + v * cosine]
    }

    /// The system whose variables are the cosines and sines of the three legs and of the platform.
    pub(super) fn table(&self) -> Table {
        let mut table = Table::default();
        for loops in 0..2 {
            let equation = 2 * loops;
            let leg = loops + 1;
            table.add_vector(equation, 0, [self.legs[0], 0.0]);
            table.add_vector(equation, 3, self.sides[loops]);
            table.add_vector(equation, u16::try_from(leg).unwrap(), [-self.legs[leg], 0.0]);
            for axis in 0..2 {
                table.add(equation + axis, self.bases[0][axis] - self.bases[leg][axis], &[]);
            }
        }
        for angle in 0..4 {
            table.add_angle(4 + usize::from(angle), angle);
        }
        table
    }
}
