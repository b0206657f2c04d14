//! Closures of vectors of the plane, each written in one of many ways.

use super::Mechanism;
use crate::formula::Formula;

/// A vector of the plane in a closure.
#[derive(Clone)]
pub(super) enum Vector {
    /// A length at an angle.
    Link(Formula, Formula),
    /// The vector of these coordinates, turned by an angle.
    Turned(Formula, Formula, Formula),
    /// A length along the x axis.
    Along(Formula),
    /// A formula.
    Whole(Formula),
}

impl Vector {
    fn coordinates(&self) -> [Formula; 2] {
        match self {
            Self::Link(length, angle) => ["cos", "sin"].map(|function| {
                let angle = std::slice::from_ref(angle);
                length.times(&Formula::call(function, angle))
            }),
            Self::Turned(x, y, angle) => {
                let [cosine, sine] =
                    ["cos", "sin"].map(|function| Formula::call(function, std::slice::from_ref(angle)));
                [
                    x.times(&cosine).minus(&y.times(&sine)),
                    x.times(&sine).plus(&y.times(&cosine)),
                ]
            }
            Self::Along(length) => [length.clone(), Formula::operand("0")],
            Self::Whole(formula) => ["x", "y"].map(|axis| formula.part(axis)),
        }
    }
}

impl Mechanism<'_> {
    /// A sum of vectors that vanishes, the second ones subtracted.
    pub(super) fn close(&mut self, added: &[Vector], subtracted: &[Vector]) {
        match self.random.below(8) {
            0 | 1 => self.close_by_coordinates(added, subtracted),
            2 => {
                let (left, right) = (self.side(added), self.side(subtracted));
                let difference = self.named(&left.minus(&right));
                for axis in ["x", "y"] {
                    self.equate(&difference.part(axis), &Formula::operand("0"));
                }
            }
            3 => {
                let turn = Formula::call("cis", &[self.angle()]);
                let (left, right) = (self.side(added), self.side(subtracted));
                self.equate(&left.times(&turn), &turn.times(&right));
            }
            4 => {
                let (left, right) = (self.side(added), self.side(subtracted));
                self.equate(&left.minus(&right), &Formula::operand("0"));
            }
            _ => {
                let (left, right) = (self.side(added), self.side(subtracted));
                self.equate(&left, &right);
            }
        }
    }

    fn close_by_coordinates(&mut self, added: &[Vector], subtracted: &[Vector]) {
        for axis in 0..2 {
            let [left, right] = [added, subtracted].map(|vectors| {
                let parts = vectors.iter().map(|vector| {
                    let [x, y] = vector.coordinates();
                    if axis == 0 { x } else { y }
                });
                sum(parts)
            });
            self.equate(&left, &right);
        }
    }

    /// A sum of vectors, itself a vector.
    fn side(&mut self, vectors: &[Vector]) -> Formula {
        if vectors.iter().all(|vector| matches!(vector, Vector::Along(_))) {
            let length = sum(vectors.iter().map(|vector| self.written(vector)));
            let function = *self.random.pick(&["polar", "vec2", "vec2"]);
            return Formula::call(function, &[length, Formula::operand("0")]);
        }
        let parts: Vec<Formula> = vectors.iter().map(|vector| self.abbreviation_or(vector)).collect();
        sum(parts)
    }

    /// A vector, or a length along the x axis, which has to be used.
    fn abbreviation_or(&mut self, vector: &Vector) -> Formula {
        let written = self.written(vector);
        self.abbreviated(written)
    }

    /// A vector, or a length along the x axis.
    pub(super) fn written(&mut self, vector: &Vector) -> Formula {
        match vector {
            Vector::Link(length, angle) => {
                let turn = [angle.clone()];
                match self.random.below(10) {
                    0 => Formula::call("polar", &[length.clone(), angle.clone()]),
                    1 => Formula::method("polar", &[length.clone(), angle.clone()]),
                    2 => length.times(&Formula::method("cis", &turn)),
                    3 => Formula::call("cis", &turn).times(length),
                    4 => Formula::call("vec2", &vector.coordinates()),
                    5 => {
                        let [x, y] = vector.coordinates();
                        Formula::call("vec2", &[x, Formula::operand("0")])
                            .plus(&Formula::call("vec2", &[Formula::operand("0"), y]))
                    }
                    _ => length.times(&Formula::call("cis", &turn)),
                }
            }
            Vector::Turned(x, y, angle) => {
                let offset = Formula::call("vec2", &[x.clone(), y.clone()]);
                offset.times(&Formula::call("cis", std::slice::from_ref(angle)))
            }
            Vector::Along(length) => length.clone(),
            Vector::Whole(formula) => formula.clone(),
        }
    }

    /// A point that is known and moves.
    pub(super) fn joint(&mut self) -> Formula {
        if !self.joints.is_empty() && !self.random.one_in(4) {
            return self.random.pick(&self.joints).clone();
        }
        let (length, angle) = (self.length(), self.angle());
        let crank = self.written(&Vector::Link(length, angle));
        let joint = if self.random.one_in(3) {
            let ground = self.ground();
            self.written(&ground).plus(&crank)
        } else {
            crank
        };
        let joint = self.abbreviated(joint);
        self.joints.push(joint.clone());
        joint
    }

    /// A pivot that nothing else is joined to.
    pub(super) fn ground(&mut self) -> Vector {
        match self.random.below(5) {
            0 => Vector::Along(self.length()),
            1 => Vector::Whole(self.parameter("p", "Point")),
            2 => Vector::Whole(self.parameter("p", "Vector")),
            3 => {
                let [x, y] = [self.length(), self.length()];
                Vector::Whole(Formula::call("vec2", &[x, y]))
            }
            _ => {
                let (length, angle) = (self.length(), self.parameter("d", "Angle"));
                Vector::Link(length, angle)
            }
        }
    }

    /// A pivot, or a joint that is another than this one.
    pub(super) fn end(&mut self, other_than: &Formula) -> Vector {
        let others: Vec<&Formula> = self.joints.iter().filter(|&joint| joint != other_than).collect();
        if !others.is_empty() && self.random.one_in(3) {
            return Vector::Whole((*self.random.pick(&others)).clone());
        }
        self.ground()
    }
}

fn sum(parts: impl IntoIterator<Item = Formula>) -> Formula {
    parts
        .into_iter()
        .reduce(|sum, part| sum.plus(&part))
        .unwrap_or_else(|| Formula::operand("0"))
}
