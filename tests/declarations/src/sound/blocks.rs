//! Blocks of one and more unknowns in the plane.

use super::Mechanism;
use super::vectors::Vector;
use crate::formula::Formula;
use crate::measure::Measure;

impl Mechanism<'_> {
    /// Adds unknowns and as many equations.
    pub(super) fn block(&mut self) {
        let block = *self.random.pick(&[
            Self::two_angles,
            Self::two_angles,
            Self::two_angles,
            Self::angle_and_length,
            Self::angle_and_length,
            Self::length_and_its_angle,
            Self::length_and_its_angle,
            Self::two_lengths,
            Self::gear,
            Self::rack,
            Self::by_its_sine,
            Self::by_its_cosine,
            Self::by_both,
            Self::quadratic,
            Self::defined,
            Self::inverted,
            Self::linear,
            Self::freudenstein,
            Self::kepler,
            Self::coupled_pair,
            Self::triad,
            Self::forward,
            Self::spatial_angle,
            Self::spatial_length,
            Self::universal_joint,
        ]);
        block(self);
    }

    /// The angle of a link, now and then with a corner in it.
    fn with_corner(&mut self, angle: &Formula) -> Formula {
        if self.random.one_in(8) {
            let corner = self.parameter("d", "Angle");
            angle.plus(&corner)
        } else {
            angle.clone()
        }
    }

    /// Two links and the joint between them.
    fn two_angles(&mut self) {
        let start = self.joint();
        let end = self.end(&start);
        let [a, b] = [self.length(), self.length()];
        let [u, v] = [self.unknown("u", "Angle", ""), self.unknown("u", "Angle", "")];
        let first = Vector::Link(a, self.with_corner(&u));
        let second = Vector::Link(b, self.with_corner(&v));
        self.close(&[Vector::Whole(start.clone()), first.clone()], &[end, second]);
        self.dyads += 1;
        for unknown in [u, v] {
            self.solved(&unknown, "Angle");
        }
        let first = self.written(&first);
        self.joints.push(start.plus(&first));
    }

    /// A link and a slider on a line.
    fn angle_and_length(&mut self) {
        let start = self.joint();
        let end = self.ground();
        let link = self.length();
        let [u, s] = [self.unknown("u", "Angle", ""), self.unknown("s", "Length", "")];
        let slide = match self.random.below(4) {
            0 => Vector::Along(s.clone()),
            1 => Vector::Link(s.clone(), self.parameter("d", "Angle")),
            2 => Vector::Link(s.clone(), Formula::operand("PI").over(&Formula::operand("2"))),
            _ => Vector::Link(s.clone(), self.angle()),
        };
        let first = Vector::Link(link, u.clone());
        self.close(&[Vector::Whole(start.clone()), first.clone()], &[end, slide]);
        self.solved(&u, "Angle");
        self.solved(&s, "Length");
        let first = self.written(&first);
        self.joints.push(start.plus(&first));
    }

    /// A cylinder, or a slotted lever.
    fn length_and_its_angle(&mut self) {
        let start = self.joint();
        let end = self.end(&start);
        let range = *self
            .random
            .pick(&["", " where _ > 0", " where _ >= 0.0", " where _ < 0", " in 0..=1e6"]);
        let [s, u] = [self.unknown("s", "Length", range), self.unknown("u", "Angle", "")];
        let bar = if self.random.one_in(3) {
            Vector::Turned(s.clone(), self.length(), u.clone())
        } else {
            Vector::Link(s.clone(), u.clone())
        };
        self.close(&[Vector::Whole(start)], &[end, bar]);
        self.solved(&s, "Length");
        self.solved(&u, "Angle");
    }

    /// A cross slide.
    fn two_lengths(&mut self) {
        let start = self.joint();
        let end = self.ground();
        let [s, r] = [self.unknown("s", "Length", ""), self.unknown("s", "Length", "")];
        let fixed = self.parameter("d", "Angle");
        let turning = self.angle();
        self.close(
            &[Vector::Whole(start), Vector::Link(s.clone(), fixed)],
            &[end, Vector::Link(r.clone(), turning)],
        );
        self.solved(&s, "Length");
        self.solved(&r, "Length");
    }

    /// Two wheels that mesh.
    fn gear(&mut self) {
        let angle = self.angle();
        let u = self.unknown("u", "Angle", "");
        let [z, w] = [self.parameter("k", "Scalar"), self.parameter("k", "Scalar")];
        let start = self.parameter("d", "Angle");
        let sign = self.random.one_in(2);
        let driven = w.times(&u);
        let driven = if sign { driven.negated() } else { driven };
        self.equate(&z.times(&angle.minus(&start)), &driven);
        self.solved(&u, "Angle");
    }

    /// A wheel that rolls on a line.
    fn rack(&mut self) {
        let (radius, angle) = (self.length(), self.angle());
        let s = self.unknown("s", "Length", "");
        let start = self.length();
        self.equate(&s.minus(&start), &radius.times(&angle));
        self.solved(&s, "Length");
    }

    /// A length that is known and changes.
    fn height(&mut self) -> Formula {
        if self.random.one_in(3) {
            let axis = *self.random.pick(&["x", "y"]);
            return self.joint().part(axis);
        }
        let (length, angle) = (self.length(), self.angle());
        let function = *self.random.pick(&["sin", "cos"]);
        length.times(&Formula::call(function, &[angle]))
    }

    fn by_its_sine(&mut self) {
        let (length, height) = (self.length(), self.height());
        let range = *self
            .random
            .pick(&["", " in -PI / 2..=PI / 2", " in PI / 2..3 * PI / 2"]);
        let u = self.unknown("u", "Angle", range);
        self.equate(&length.times(&Formula::call("sin", std::slice::from_ref(&u))), &height);
        self.solved(&u, "Angle");
    }

    fn by_its_cosine(&mut self) {
        let (length, height) = (self.length(), self.height());
        let range = *self.random.pick(&["", " in 0..=PI", " in -PI..0"]);
        let u = self.unknown("u", "Angle", range);
        self.equate(
            &Formula::call("cos", std::slice::from_ref(&u)),
            &height.over(&length.in_parentheses()),
        );
        self.solved(&u, "Angle");
    }

    fn by_both(&mut self) {
        let [a, b] = [self.length(), self.length()];
        let height = self.height();
        let u = self.unknown("u", "Angle", "");
        let [cosine, sine] = ["cos", "sin"].map(|function| Formula::call(function, std::slice::from_ref(&u)));
        self.equate(&a.times(&cosine).plus(&b.times(&sine)), &height);
        self.solved(&u, "Angle");
    }

    /// The law of cosines.
    fn quadratic(&mut self) {
        let [a, b] = [self.length(), self.length()];
        let angle = self.angle();
        let range = *self.random.pick(&["", " where _ > 0", " where _ < 0"]);
        let s = self.unknown("s", "Length", range);
        let cosine = Formula::call("cos", std::slice::from_ref(&angle));
        let square = |length: &Formula| Formula::call("powi", &[length.clone(), Formula::operand("2")]);
        match self.random.below(3) {
            0 => {
                let between = Formula::operand("2").times(&a).times(&b).times(&cosine);
                self.equate(&square(&s), &square(&a).plus(&square(&b)).minus(&between));
            }
            1 => {
                let between = Formula::operand("2").times(&a).times(&s).times(&cosine);
                self.equate(&square(&s).minus(&between).plus(&square(&a)), &square(&b));
            }
            _ => {
                let difference = Formula::call("vec2", &[s.clone(), Formula::operand("0")])
                    .minus(&a.times(&Formula::call("cis", &[angle])));
                self.equate(&Formula::call("norm", &[difference]), &b);
            }
        }
        self.solved(&s, "Length");
    }

    /// Whatever follows from a formula.
    fn defined(&mut self) {
        let (dimension, letters) = *self.random.pick(&[("Length", "s"), ("Scalar", "n"), ("Angle", "u")]);
        // so that a formula of any dimension can be written
        let [length, other] = [self.length(), self.length()];
        let formula = self.tame(Measure::of(dimension), 3);
        let sine = Formula::call("sin", &[self.angle()]);
        let changing = match dimension {
            "Length" => length.plus(&other).times(&sine),
            _ => sine.times(&length).over(&other),
        };
        let unknown = self.unknown(letters, dimension, "");
        self.equate(&unknown, &formula.plus(&changing));
        self.solved(&unknown, dimension);
    }

    /// A function of the unknown.
    fn inverted(&mut self) {
        let sine = Formula::call("sin", &[self.angle()]);
        let number = |text: &str| Formula::operand(text);
        let n = self.unknown("n", "Scalar", "");
        let above = number("2").plus(&sine);
        let call = |function| Formula::call(function, std::slice::from_ref(&n));
        let (left, right) = match self.random.below(9) {
            0 => (call("exp"), above),
            1 => (call("ln"), sine),
            2 => (call("sqrt"), above),
            3 => (call("atan"), sine),
            4 => (call("asin"), sine.over(&number("2"))),
            5 => (call("tan"), above),
            6 => (n.times(&above), number("1").minus(&sine)),
            7 => (number("1").over(&n), above),
            _ => (Formula::method("powi", &[n.clone(), number("3")]), above),
        };
        self.equate(&left, &right);
        self.solved(&n, "Scalar");
    }

    /// Two equations that are linear in two lengths.
    fn linear(&mut self) {
        let [first, second] = [self.height(), self.height()];
        let [s, r] = [self.unknown("s", "Length", ""), self.unknown("s", "Length", "")];
        let [k, m] = [self.parameter("k", "Scalar"), self.parameter("k", "Scalar")];
        self.equate(&s.plus(&k.times(&r)), &first);
        self.equate(&m.times(&s).minus(&r), &second);
        self.solved(&s, "Length");
        self.solved(&r, "Length");
    }

    /// Freudenstein's equation, one angle by the other.
    fn freudenstein(&mut self) {
        let angle = self.angle();
        let v = self.unknown("u", "Angle", "");
        let [k, l, m] = ["k"; 3].map(|letter| self.parameter(letter, "Scalar"));
        let cosine = |angle: &Formula| Formula::call("cos", std::slice::from_ref(angle));
        let left = k.times(&cosine(&v)).minus(&l.times(&cosine(&angle))).plus(&m);
        self.equate(&left, &cosine(&angle.minus(&v)));
        self.solved(&v, "Angle");
    }

    /// An angle that stands within a sine and outside.
    fn kepler(&mut self) {
        let angle = self.angle();
        let u = self.unknown("u", "Angle", "");
        let k = self.parameter("k", "Scalar");
        let sine = Formula::call("sin", std::slice::from_ref(&u));
        self.equate(&u.minus(&k.times(&sine)), &angle);
        self.solved(&u, "Angle");
    }

    /// Two angles, each in a function in the other's equation.
    fn coupled_pair(&mut self) {
        let angle = self.angle();
        let [u, v] = [self.unknown("u", "Angle", ""), self.unknown("u", "Angle", "")];
        let [k, m] = [self.parameter("k", "Scalar"), self.parameter("k", "Scalar")];
        let sine = Formula::call("sin", std::slice::from_ref(&v));
        self.equate(&u, &angle.plus(&k.times(&sine)));
        let cosine = Formula::call("cos", &[u.plus(&angle)]);
        self.equate(&v, &m.times(&cosine));
        self.solved(&u, "Angle");
        self.solved(&v, "Angle");
    }

    /// Three links on a body.
    fn triad(&mut self) {
        let start = self.joint();
        let [a, b, c, p, q] = ["a"; 5].map(|letter| self.parameter(letter, "Length"));
        let corner = self.parameter("d", "Angle");
        let [alpha, beta, gamma, phi] = ["u"; 4].map(|letter| self.unknown(letter, "Angle", ""));
        let joint = start.plus(&self.written(&Vector::Link(a, alpha.clone())));
        let joint = self.abbreviated(joint);
        let [pivot, other] = [self.ground(), self.ground()];
        self.close(
            &[Vector::Whole(joint.clone()), Vector::Link(p, phi.clone())],
            &[pivot, Vector::Link(b, beta.clone())],
        );
        self.close(
            &[Vector::Whole(joint), Vector::Link(q, phi.plus(&corner))],
            &[other, Vector::Link(c, gamma.clone())],
        );
        for unknown in [alpha, beta, gamma, phi] {
            self.solved(&unknown, "Angle");
        }
    }
}
