//! Blocks in space.

use super::Mechanism;
use crate::formula::Formula;

impl Mechanism<'_> {
    /// A rotation by an angle.
    fn turn(&mut self, angle: &Formula) -> Formula {
        match self.random.below(5) {
            0 => {
                let axis = self.parameter("w", "Vector3");
                Formula::call("rot", &[axis, angle.clone()])
            }
            1 => Formula::call("rot", &[Formula::of_numbers("vec3", &["1", "2", "2"]), angle.clone()]),
            2 => Formula::method("rot_x", std::slice::from_ref(angle)),
            3 => Formula::call("rot_y", std::slice::from_ref(angle)),
            _ => Formula::call("rot_z", std::slice::from_ref(angle)),
        }
    }

    /// A fixed vector of space.
    fn offset(&mut self) -> Formula {
        // on none of the axes, so that a rotation about one does turn it
        match self.random.below(3) {
            0 => self.parameter("p", "Point3"),
            1 => {
                let [x, z] = [self.length(), self.length()];
                Formula::call("vec3", &[x, Formula::operand("0"), z])
            }
            _ => {
                let [x, y, z] = [self.length(), self.length(), self.length()];
                Formula::call("vec3", &[x, y, z])
            }
        }
    }

    /// A point of space that is known and moves.
    fn place(&mut self) -> Formula {
        if !self.places.is_empty() && self.random.one_in(2) {
            return self.random.pick(&self.places).clone();
        }
        let angle = self.angle();
        let turn = self.turn(&angle);
        let place = turn.times(&self.offset());
        let place = if self.random.one_in(3) {
            self.offset().plus(&place)
        } else {
            place
        };
        let place = self.abbreviated(place);
        self.places.push(place.clone());
        place
    }

    /// Where the end of a serial arm is.
    pub(super) fn forward(&mut self) {
        let joints = self.random.between(1, 3);
        let mut end = self.offset();
        for _ in 0..joints {
            let angle = self.angle();
            let turn = self.turn(&angle);
            let link = turn.times(&end);
            let offset = self.offset();
            end = self.abbreviated(offset.plus(&link));
        }
        let unknowns = ["s"; 3].map(|letter| self.unknown(letter, "Length", ""));
        self.equate(&Formula::call("vec3", &unknowns), &end);
        for unknown in &unknowns {
            self.solved(unknown, "Length");
        }
        self.places.push(end);
    }

    /// A rod between two points.
    fn rod(&mut self, start: &Formula, end: &Formula) {
        let length = self.length();
        let rod = self.abbreviated(end.minus(start));
        match self.random.below(3) {
            0 => self.equate(&Formula::call("norm", &[rod]), &length),
            1 => {
                let square = Formula::call("powi", &[length, Formula::operand("2")]);
                self.equate(&Formula::call("dot", &[rod.clone(), rod]), &square);
            }
            _ => {
                let square = length.times(&length.in_parentheses());
                self.equate(&Formula::method("dot", &[rod.clone(), rod]), &square);
            }
        }
    }

    /// A rod that drives a crank: RSSR.
    pub(super) fn spatial_angle(&mut self) {
        let start = self.place();
        let u = self.unknown("u", "Angle", "");
        let crank = self.turn(&u).times(&self.offset());
        let end = self.offset().plus(&crank);
        let end = self.abbreviated(end);
        self.rod(&start, &end);
        self.solved(&u, "Angle");
        self.places.push(end);
    }

    /// A rod that drives a slider: RSSP.
    pub(super) fn spatial_length(&mut self) {
        let start = self.place();
        let s = self.unknown("s", "Length", "");
        let along = match self.random.below(3) {
            0 => Formula::call("vec3", &[s.clone(), Formula::operand("0"), Formula::operand("0")]),
            1 => s.times(&Formula::of_numbers("vec3", &["0", "0.6", "0.8"])),
            _ => {
                let axis = self.parameter("w", "Vector3");
                s.times(&axis).over(&Formula::call("norm", &[axis]))
            }
        };
        let end = self.offset().plus(&along);
        self.rod(&start, &end);
        self.solved(&s, "Length");
        self.places.push(end);
    }

    /// Two axes that stay at a right angle.
    pub(super) fn universal_joint(&mut self) {
        let angle = self.angle();
        let u = self.unknown("u", "Angle", "");
        let bend = self.parameter("d", "Angle");
        let first = Formula::call("rot_x", &[angle]).times(&Formula::of_numbers("vec3", &["0", "0", "1"]));
        let second = Formula::call("rot_y", &[bend])
            .times(&Formula::call("rot_x", std::slice::from_ref(&u)))
            .times(&Formula::of_numbers("vec3", &["0", "1", "0"]));
        self.equate(&Formula::call("dot", &[first, second]), &Formula::operand("0"));
        self.solved(&u, "Angle");
    }
}
