//! The unit of length has no say in a cycle: with all lengths multiplied by 10ᵏ, for k from -60 to 60, it has the same
//! circuits, branches, kinds of ends, labels and flags, and limits at the same inputs.

use kin_core::cycle::{BlockClass, Branch, Cycle, FullCycle, GrashofType};
use kin_core::library::{
    FourBar, GearedFiveBar, InvertedSliderCrank, OffsetSliderCrank, StephensonI, StephensonIII, WattI, WattII,
};
use kin_core::prelude::*;
use kin_core::{Dimension, LimitKind};
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::random::Random;

/// The largest power of ten.
const MOST: i32 = 60;
/// The largest difference of the inputs at the ends of branches, as a part of the range, for links of one size: next to
/// a change point, rounding of the lengths moves a limit by its root.
const SAME: f64 = 1e-7;

/// The same for each unit of the ratio of the longest link to the shortest one. A change point is found from values at
/// least 0.01 away from it. What decides there has a relative error of the ratio times ε, divided by that distance.
const APART: f64 = 64.0 * f64::EPSILON / 0.01;

/// What a cycle tells besides numbers, and the inputs at the ends of its branches.
#[derive(PartialEq)]
struct Outline {
    words: String,
    ends: Vec<f64>,
}

impl Outline {
    fn of<M: Mechanism<Scalar = f64>>(mechanism: &M, cycle: &Cycle<M>) -> Self {
        let forms = mechanism.block_forms();
        let labels: Vec<Option<BlockClass>> = forms.as_ref().iter().map(BlockClass::of).collect();
        let branches = cycle.branches().iter();
        let branches: Vec<String> = branches
            .map(|branch| {
                let kinds = branch.ends().map(|end| (end.kind, end.block));
                format!("{kinds:?} of {} to {:?}", branch.circuit(), branch.joins())
            })
            .collect();
        let circuits = cycle.circuits().iter();
        let circuits: Vec<String> = circuits
            .map(|circuit| {
                let turns = circuit.revolutions().map(|turns| turns.as_ref().to_vec());
                format!("{:?} {:?} {turns:?}", circuit.branches(), circuit.input_revolutions())
            })
            .collect();
        let kinds: Vec<_> = cycle.incomplete().iter().map(core::mem::discriminant).collect();
        Self {
            words: format!(
                "{labels:?} {branches:?} {circuits:?} {:?} {kinds:?} {}",
                cycle.period(),
                cycle.seeds().len()
            ),
            ends: cycle
                .branches()
                .iter()
                .flat_map(Branch::ends)
                .map(|end| end.input)
                .collect(),
        }
    }

    fn agrees(&self, other: &Self, ratio: f64) -> bool {
        let range = self.ends.iter().fold(1.0, |most: f64, end| most.max(end.abs()));
        let mut ends = self.ends.iter().zip(&other.ends);
        self.words == other.words && ends.all(|(one, other)| (one - other).abs() <= (SAME + APART * ratio) * range)
    }
}

/// The property, with what it has seen.
pub(super) struct Units {
    /// The powers of ten, of which every mechanism takes some.
    powers: usize,
    pub(super) mechanisms: usize,
    pub(super) cycles: usize,
    pub(super) change_points: usize,
    pub(super) incomplete: usize,
    pub(super) wrong: Vec<String>,
}

impl Units {
    /// The property at a number of powers for each mechanism.
    fn new(powers: usize) -> Self {
        Self {
            powers,
            mechanisms: 0,
            cycles: 0,
            change_points: 0,
            incomplete: 0,
            wrong: Vec::new(),
        }
    }

    /// Compares the cycles of a mechanism in all units, over its first input, with the others at a place.
    fn compare<M: Mechanism<Scalar = f64>>(&mut self, mechanism: &M, place: &M::Inputs<f64>) {
        let scaled = |power: i32| -> Result<(Outline, Cycle<M>), String> {
            // A quotient is rounded as a decimal fraction is that a person writes.
            let unit = |value: f64| {
                let factor = 10.0_f64.powi(power.abs());
                if power < 0 { value / factor } else { value * factor }
            };
            let row = |dimension: Dimension, value: f64| {
                if dimension == Dimension::Length {
                    unit(value)
                } else {
                    value
                }
            };
            let parameters = mechanism.parameters();
            let own = M::from_parameters(Row::from_fn(|index| {
                row(M::DESCRIPTION.parameters[index].dimension, parameters[index])
            }));
            let from = Row::from_fn(|index| row(M::DESCRIPTION.inputs[index].dimension, place[index]));
            let direction = Row::from_fn(|index| match index {
                0 => row(M::DESCRIPTION.inputs[0].dimension, 1.0),
                _ => 0.0,
            });
            let cycle = own.cycle_along(from, direction);
            let cycle = cycle.map_err(|error| format!("{mechanism:?} at 1e{power}: {error}"))?;
            Ok((Outline::of(&own, &cycle), cycle))
        };
        let (expected, cycle) = match scaled(0) {
            Ok(found) => found,
            Err(error) => return self.wrong.push(error),
        };
        let parameters = mechanism.parameters();
        let named = M::DESCRIPTION.parameters.iter().zip(parameters.as_ref());
        let links = named.filter(|(quantity, value)| quantity.dimension == Dimension::Length && **value != 0.0);
        let (short, long) = links.fold((f64::INFINITY, 0.0_f64), |(short, long), (_, value)| {
            (short.min(value.abs()), long.max(value.abs()))
        });
        let ratio = if long > 0.0 { long / short } else { 1.0 };
        let mut ends = cycle.branches().iter().flat_map(Branch::ends);
        self.change_points += usize::from(ends.any(|end| end.limit() == Some(LimitKind::ChangePoint)));
        self.incomplete += usize::from(!cycle.is_complete());
        self.mechanisms += 1;
        self.cycles += 1;
        let step = (2 * MOST + 1).unsigned_abs() as usize / self.powers;
        let shift = self.mechanisms % step;
        for power in (-MOST..=MOST).skip(shift).step_by(step) {
            self.cycles += 1;
            match scaled(power) {
                Ok((found, _)) if found.agrees(&expected, ratio) => {}
                Ok((found, _)) => {
                    self.wrong.push(format!(
                        "{mechanism:?} at 1e{power}:\n {} {:?}\n {} {:?}",
                        found.words, found.ends, expected.words, expected.ends
                    ));
                    return;
                }
                Err(error) => return self.wrong.push(error),
            }
        }
    }

    fn single<M: Mechanism<Scalar = f64, Inputs<f64> = [f64; 1]>>(&mut self, mechanism: &M) {
        self.compare(mechanism, &[0.0]);
    }

    /// A linkage of whole lengths whose shortest and longest link are together as long as the other two, with a ratio
    /// of up to 1 to 10⁶.
    fn change_point(&mut self, random: &mut Random) {
        let short = random.between(1.0, 10.0).floor();
        let long = short * 10.0_f64.powf(random.between(0.0, 6.0)).floor();
        let between = match random.between(0.0, 4.0).floor() {
            0.0 => short,
            1.0 => (short + 10.0).min(long),
            _ => random.between(short, long + 1.0).floor(),
        };
        let mut links = [short, long, between, short + long - between];
        for last in (1..4_u8).rev() {
            let chosen = (0..=last).find(|place| random.between(0.0, 1.0) < 1.0 / f64::from(last + 1 - place));
            links.swap(usize::from(last), usize::from(chosen.unwrap_or(last)));
        }
        let [r1, r2, r3, r4] = links;
        let linkage = FourBar { r1, r2, r3, r4 };
        let [form] = linkage.block_forms();
        let Some(BlockClass::FourBar(class)) = BlockClass::of(&form) else {
            return self.wrong.push(format!("{linkage:?} has no class"));
        };
        let found = linkage.cycle().map(|cycle| {
            let mut ends = cycle.branches().iter().flat_map(Branch::ends);
            let has_change_point = ends.any(|end| end.limit() == Some(LimitKind::ChangePoint));
            (cycle.is_complete(), has_change_point, cycle.circuits().len())
        });
        if class.grashof() != GrashofType::ChangePoint || found != Ok((true, true, 1)) {
            self.wrong.push(format!("{linkage:?} {class:?}: {found:?}"));
        }
        self.single(&linkage);
    }

    /// One of the random mechanisms.
    fn random(&mut self, index: usize, random: &mut Random) {
        let mut length = |low: f64, high: f64| random.between(low, high);
        let [r1, r2, r3, r4, r5, r6] = [(); 6].map(|()| length(0.3, 4.0));
        let [p, q] = [(); 2].map(|()| Plane::new(length(-2.0, 2.0), length(-2.0, 2.0)));
        let pivot = Plane::new(length(-5.0, 5.0), length(-5.0, 5.0));
        match index % 40 {
            0 => self.single(&WattI {
                r1,
                r2,
                r3,
                r4,
                p,
                q,
                r5,
                r6,
            }),
            1 => self.single(&StephensonI {
                r1,
                r2,
                r3,
                r4,
                p,
                q,
                r5,
                r6,
            }),
            2 => self.single(&StephensonIII {
                r1,
                r2,
                r3,
                r4,
                p,
                r5,
                pivot,
                r6,
            }),
            3 => self.single(&WattII {
                r1,
                r2,
                r3,
                r4,
                arm: p,
                pivot,
                r5,
                r6,
            }),
            4 => {
                let ratio = (length(-3.0, 4.0).floor() + 0.5) * if r6 > 2.0 { 1.0 } else { 2.0 };
                self.single(&GearedFiveBar {
                    r1,
                    r2,
                    r3,
                    r4,
                    r5,
                    ratio,
                    phase: r6,
                });
            }
            5..=7 => self.single(&OffsetSliderCrank {
                r: r1,
                l: r2,
                h: r3 - 1.0,
            }),
            8 => self.single(&InvertedSliderCrank { r1, r2 }),
            9 => self.single(&InvertedSliderCrank { r1, r2: r1 }),
            10..=24 => self.change_point(random),
            25..=29 => {
                let whole = |value: f64| (3.0 * value).ceil();
                self.single(&FourBar {
                    r1: whole(r1),
                    r2: whole(r2),
                    r3: whole(r3),
                    r4: whole(r4),
                });
            }
            30..=34 => {
                // each length in a unit of its own
                let own = |value: f64| 10.0_f64.powf(value - 1.5);
                self.single(&FourBar {
                    r1: own(r1),
                    r2: own(r2),
                    r3: own(r3),
                    r4: own(r4),
                });
            }
            _ => self.single(&FourBar { r1, r2, r3, r4 }),
        }
    }
}

impl Visitor for Units {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let place = M::Inputs::from_fn(|index| {
            let (low, high) = case.inputs[index];
            f64::midpoint(low, high)
        });
        self.compare(&case.mechanism::<M>(), &place);
    }
}

fn tell(name: &str, units: &Units) {
    println!(
        "{name}: {} mechanisms, {} cycles; {} with a change point, {} incomplete",
        units.mechanisms, units.cycles, units.change_points, units.incomplete
    );
    assert!(
        units.wrong.is_empty(),
        "{} wrong:\n{}",
        units.wrong.len(),
        units.wrong.join("\n")
    );
}

/// The library at some powers, and random mechanisms.
fn units_of_length(library: usize, coupled: usize, random: usize, powers: usize, seed: u64) {
    let mut units = Units::new(library);
    cases::library(&mut units);
    tell("library", &units);
    let mut units = Units::new(coupled);
    cases::coupled_library(&mut units);
    tell("coupled library", &units);
    let mut units = Units::new(powers);
    let mut numbers = Random::new(seed);
    for index in 0..random {
        units.random(index, &mut numbers);
    }
    tell("random", &units);
    assert!(units.change_points > random / 4);
}

#[test]
fn small() {
    units_of_length(3, 1, if cfg!(feature = "every-case") { 1200 } else { 40 }, 3, 1);
}

#[test]
#[ignore = "takes minutes"]
fn large() {
    units_of_length(121, 13, 2000, 13, super::given("KIN_CAMPAIGN_SEED").unwrap_or(2));
}
