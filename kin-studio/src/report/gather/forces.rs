//! The forces that loads cause over the range.

use kin_core::Dimension;
use kin_core::extremes::{AskedQuantity, ExtremesError, Over, QuantityAlong, QuantitySource};
use kin_core::linkage::AnySweep;
use kin_core::reaction::{BodyLoadKind, NamedReactions, Reaction, ReactionPart, Reactions};
use kin_core::sweep::SmoothDrive;

use super::contacts;
use super::peaks::over_all;
use super::way::Way;
use crate::forces::{Causes, Force, ForceQuestion, OfPeak, OfRows, ratio};
use crate::names::symbol;
use crate::report::draft::{WishedLoads, Wishes};
use crate::report::model::{
    ActingLoad, BodyLoad, CurveKind, ForceCurve, ForcePeak, ForceSample, Forces, JointForce, MeanPowers,
};

/// The forces, if there are loads.
pub(super) fn of<D: SmoothDrive>(wishes: &Wishes<'_>, way: &Way<'_, D>) -> Option<Forces> {
    let wished = wishes.loads.as_ref()?;
    let found = wished.stated.reactions(&wishes.linkage, &wished.loads);
    let found = found.map_err(|error| error.to_string());
    let (reactions, mut unknown) = match found {
        Ok(reactions) => (Some(reactions), None),
        Err(error) => (None, Some(error)),
    };
    let causes = Causes {
        loads: &wished.loads,
        reactions: reactions.as_ref(),
        has_friction: wished.stated.has_friction(),
    };
    let gathered = Gathered {
        wishes,
        wished,
        way,
        causes,
    };
    let mut all = gathered.efforts();
    let (mut joints, mut body_loads) = (Vec::new(), Vec::new());
    let is_space = wishes.functions.is_space();
    if let Some(reactions) = &reactions {
        let rows = gathered.rows(reactions);
        if is_space {
            gathered.joints_of_space((reactions, &rows), &mut all, &mut unknown);
        } else {
            joints = gathered.joints((reactions, &rows), &mut all, &mut unknown);
            body_loads = gathered.body_loads(&mut all, &rows);
        }
    }
    Some(Forces {
        metres: wished.metres,
        joints,
        curves: all.curves,
        body_loads,
        contacts: if is_space {
            Vec::new()
        } else {
            contacts::of(&wished.stated, &wishes.linkage, &wishes.functions.outline())
        },
        samples: all.samples,
        powers: gathered.powers(),
        unknown,
    })
}

/// The curves of efforts and moments, and the samples of all.
struct All {
    curves: Vec<ForceCurve>,
    samples: Vec<ForceSample>,
}

struct Gathered<'g, 'm, D> {
    wishes: &'g Wishes<'g>,
    wished: &'g WishedLoads,
    way: &'g Way<'m, D>,
    causes: Causes<'g>,
}

type Rows = Vec<Result<Reactions, ExtremesError>>;

impl<D: SmoothDrive> Gathered<'_, '_, D> {
    /// A force or moment with its rate, for a power of the unit of lengths in it.
    fn sized(&self, values: [f64; 2], lengths: i32) -> Option<[f64; 2]> {
        let size = self.wished.metres.powi(lengths);
        let sized = values.map(|value| short(value * size));
        sized.iter().all(|value| value.is_finite()).then_some(sized)
    }

    /// The efforts of the drives that move, and samples of nothing else.
    fn efforts(&self) -> All {
        let inputs = self.wishes.linkage.description().inputs.iter().enumerate();
        let at = |sweep: &AnySweep<'_, D>| (0..sweep.count()).map(|row| sweep.at(row)).collect();
        let sample = |input: f64| ForceSample {
            input: super::short(input),
            forces: Vec::new(),
            curves: Vec::new(),
            loads: Vec::new(),
            contacts: Vec::new(),
        };
        let mut samples: Vec<ForceSample> = self.way.ascending(at).into_iter().map(sample).collect();
        let mut curves = Vec::new();
        for (input, quantity) in inputs {
            let lengths = if quantity.dimension == Dimension::Length { 1 } else { 2 };
            let effort = Force::Effort(input);
            let column = |order| {
                let of = |sweep: &AnySweep<'_, D>| {
                    let column = self.causes.ask(&effort, order, sweep, &OfRows);
                    column
                        .and_then(Result::ok)
                        .unwrap_or_else(|| vec![f64::NAN; sweep.count()])
                };
                self.way.ascending(of)
            };
            for ((sample, value), rate) in samples.iter_mut().zip(column(0)).zip(column(1)) {
                sample.curves.push(self.sized([value, rate], lengths));
            }
            curves.push(ForceCurve {
                name: format!("{}_effort", quantity.name),
                text: format!("effort of {}", symbol(quantity.name)),
                kind: CurveKind::of(lengths),
                peak: self.peak(lengths, &effort),
            });
        }
        All { curves, samples }
    }

    /// The solutions of all rows.
    fn rows(&self, reactions: &NamedReactions<'_>) -> Rows {
        self.way.ascending(|sweep| match sweep.reactions(reactions) {
            Ok(rows) => rows,
            Err(error) => vec![Err(error); sweep.count()],
        })
    }

    /// The force in a joint in a row. Why one is not known is told once.
    fn force_in(
        &self,
        row: &Result<Reactions, ExtremesError>,
        name: &str,
        unknown: &mut Option<String>,
    ) -> Option<Reaction> {
        let error = match row {
            Ok(row) => match row.of(name) {
                Ok(force) => return Some(force),
                Err(error) => error.to_string(),
            },
            Err(ExtremesError::Gap { .. }) => return None,
            Err(error) => self.wishes.named(error),
        };
        unknown.get_or_insert(error);
        None
    }

    /// The sizes of forces and moments in joints of space, where a page draws no arrows.
    fn joints_of_space(
        &self,
        (reactions, rows): (&NamedReactions<'_>, &Rows),
        all: &mut All,
        unknown: &mut Option<String>,
    ) {
        for name in reactions.names() {
            let parts = [("force", ReactionPart::Force, 1), ("moment", ReactionPart::Moment, 2)];
            for (word, part, lengths) in parts {
                let values = rows.iter().map(|row| {
                    let [value, rate, _] = self.force_in(row, name, unknown)?.part(part);
                    self.sized([value, rate], lengths)
                });
                let values: Vec<Option<[f64; 2]>> = values.collect();
                if part == ReactionPart::Moment && !values.iter().flatten().any(|[moment, _]| *moment != 0.0) {
                    continue;
                }
                for (sample, value) in all.samples.iter_mut().zip(values) {
                    sample.curves.push(value);
                }
                all.curves.push(ForceCurve {
                    name: format!("{name}_{word}"),
                    text: format!("{word} of {name}"),
                    kind: CurveKind::of(lengths),
                    peak: self.peak(lengths, &Force::Reaction(name.to_owned(), part)),
                });
            }
        }
    }

    /// The mean powers, if joints have friction and one sweep goes over the range.
    fn powers(&self) -> Option<MeanPowers> {
        let ([sweep], true) = (self.way.sweeps.as_slice(), self.causes.has_friction) else {
            return None;
        };
        let mean = sweep.efficiency(self.causes.reactions?).ok()?;
        let watts = self.wished.metres.powi(2);
        Some(MeanPowers {
            input: mean.input * watts,
            heat: mean.heat * watts,
            efficiency: ratio(mean),
        })
    }

    /// The joints of the plane. Moments of guides become curves.
    fn joints(
        &self,
        (reactions, rows): (&NamedReactions<'_>, &Rows),
        all: &mut All,
        unknown: &mut Option<String>,
    ) -> Vec<JointForce> {
        let outline = self.wishes.functions.outline();
        let member = |name: &str| outline.bodies.iter().position(|body| body.name == name);
        let mut joints = Vec::new();
        for name in reactions.names() {
            let [on, by] = reactions.bodies_of(name).unwrap_or_default();
            let is_slide = reactions.is_slide(name) == Ok(true);
            let mut moments = Vec::new();
            for (sample, row) in all.samples.iter_mut().zip(rows) {
                let found = self.force_in(row, name, unknown);
                let force = found.and_then(|force| {
                    let [x, y] = [force.x, force.y].map(|[value, rate, _]| self.sized([value, rate], 1));
                    let ([x, x_rate], [y, y_rate]) = (x?, y?);
                    Some([x, y, x_rate, y_rate])
                });
                sample.forces.push(force);
                moments.push(found.and_then(|force| self.sized([force.moment[0], force.moment[1]], 2)));
            }
            let part = |part: ReactionPart| Force::Reaction(name.to_owned(), part);
            joints.push(JointForce {
                name: name.to_owned(),
                on: member(&on),
                by: member(&by),
                joint: reactions.joint_of(name).ok(),
                is_slide,
                peak: self.peak(1, &part(ReactionPart::Force)),
            });
            if moments.iter().flatten().any(|[moment, _]| *moment != 0.0) {
                for (sample, moment) in all.samples.iter_mut().zip(moments) {
                    sample.curves.push(moment);
                }
                all.curves.push(ForceCurve {
                    name: format!("{name}_moment"),
                    text: format!("moment of {name}"),
                    kind: CurveKind::Moment,
                    peak: self.peak(2, &part(ReactionPart::Moment)),
                });
            }
        }
        for (sample, row) in all.samples.iter_mut().zip(rows) {
            let Ok(row) = row else { continue };
            let places = reactions.names().filter_map(|name| row.pitch_point(name));
            sample.contacts = places.map(|at| [short(at.x), short(at.y)]).collect();
        }
        joints
    }

    /// What acts on the bodies beside the joints.
    fn body_loads(&self, all: &mut All, rows: &Rows) -> Vec<BodyLoad> {
        let outline = self.wishes.functions.outline();
        let Some(first) = rows.iter().find_map(|row| row.as_ref().ok()) else {
            return Vec::new();
        };
        let is_force = |index: usize| {
            let own = |row: &Reactions| row.body_loads()[index].force != [0.0; 3];
            rows.iter().flatten().any(own)
        };
        let is_couple = |index: usize| {
            let own = |row: &Reactions| row.body_loads()[index].moment != [0.0; 3];
            rows.iter().flatten().any(own)
        };
        let mut kept = Vec::new();
        for (index, load) in first.body_loads().iter().enumerate() {
            let body = outline.bodies.iter().position(|body| body.name == load.body);
            if let (Some(body), true) = (body, is_force(index) || is_couple(index)) {
                kept.push((
                    index,
                    BodyLoad {
                        body,
                        kind: match load.kind {
                            BodyLoadKind::Mass => ActingLoad::Mass,
                            BodyLoadKind::Applied => ActingLoad::Load,
                            BodyLoadKind::Drive(_) => ActingLoad::Drive,
                            BodyLoadKind::Friction => ActingLoad::Friction,
                            BodyLoadKind::Guide => ActingLoad::Guide,
                        },
                        is_couple: !is_force(index),
                    },
                ));
            }
        }
        for (sample, row) in all.samples.iter_mut().zip(rows) {
            let Ok(row) = row else { continue };
            for (index, load) in &kept {
                let own = &row.body_loads()[*index];
                let newton = self.wished.metres;
                sample.loads.push(if load.is_couple {
                    vec![short(own.moment[2] * newton * newton)]
                } else {
                    let [x, y, _] = own.force.map(|part| short(part * newton));
                    let [right, up, _] = own.at.map(short);
                    vec![x, y, right, up]
                });
            }
        }
        kept.into_iter().map(|(_, load)| load).collect()
    }

    /// The extremes of a force of which each sweep has an answer, none if it is nowhere known.
    fn peak(&self, lengths: i32, force: &Force) -> Option<ForcePeak> {
        let size = self.wished.metres.powi(lengths);
        let best = |order: usize| {
            let peak = |sweep| {
                let reached = self.causes.ask(force, order, sweep, &OfPeak)?.ok()?;
                Some((reached.value.unwrap_or(f64::INFINITY), reached.at))
            };
            let all: Option<Vec<(f64, f64)>> = self.way.sweeps.iter().map(peak).collect();
            let size = |one: &(f64, f64)| one.0.abs();
            all?.into_iter().max_by(|one, other| size(one).total_cmp(&size(other)))
        };
        let (value, at) = best(0)?;
        let rms = over_all(self.way, |sweep| {
            let rms = self.causes.ask(force, 0, sweep, &OfRms);
            rms.unwrap_or(Err(ExtremesError::NotFinite { at: f64::NAN }))
        });
        // in the rounding of what does not change nothing is to be sought
        let is_steady = matches!(rms, Ok(Some(rms)) if (value.abs() - rms).abs() <= STEADY * rms);
        let rate = if is_steady {
            Some(0.0)
        } else {
            best(1).map(|(rate, _)| rate)
        };
        let sized = |value: f64| Some(value * size).filter(|value| value.is_finite());
        Some(ForcePeak {
            value: sized(value),
            at,
            rms: rms.ok().flatten().and_then(sized),
            rate: rate.and_then(sized),
        })
    }
}

/// A mean that differs from the peak by less than this part of it is that of a force which does not change.
const STEADY: f64 = 1e-10;

/// What is the root of the mean square?
struct OfRms;

impl ForceQuestion for OfRms {
    type Answer = Result<f64, ExtremesError>;

    fn ask<S: QuantitySource, Q: AskedQuantity<S>>(&self, quantity: &QuantityAlong<'_, S, Q>) -> Self::Answer {
        quantity.rms(Over::Time).map(|rms| rms.value)
    }
}

impl Forces {
    /// The names by which they are plotted: those of their columns.
    pub(super) fn names(&self) -> impl Iterator<Item = String> {
        let joints = self.joints.iter().map(|joint| format!("{}_force", joint.name));
        joints.chain(self.curves.iter().map(|curve| curve.name.clone()))
    }
}

impl CurveKind {
    fn of(lengths: i32) -> Self {
        if lengths == 1 { Self::Force } else { Self::Moment }
    }
}

/// A number to six significant figures, for arrows.
fn short(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
