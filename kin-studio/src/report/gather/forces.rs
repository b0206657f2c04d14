//! The forces that loads cause over the range.

use kin_core::Dimension;
use kin_core::extremes::{AskedQuantity, ExtremesError, Over, QuantityAlong, QuantitySource};
use kin_core::linkage::AnySweep;
use kin_core::reaction::{BodyLoadKind, NamedReactions, ReactionPart, Reactions};
use kin_core::sweep::SmoothDrive;

use super::peaks::over_all;
use super::way::Way;
use crate::forces::{Causes, Force, ForceQuestion, OfPeak, OfRows};
use crate::names::symbol;
use crate::report::draft::{WishedLoads, Wishes};
use crate::report::model::{ActingLoad, BodyLoad, CurveKind, ForceCurve, ForcePeak, ForceSample, Forces, JointForce};

/// The forces, if there are loads.
pub(super) fn of<D: SmoothDrive>(wishes: &Wishes<'_>, way: &Way<'_, D>) -> Option<Forces> {
    let wished = wishes.loads.as_ref()?;
    let found = if wishes.functions.is_space() {
        Err(IN_SPACE.to_owned())
    } else {
        let found = wished.stated.reactions(&wishes.linkage, &wished.loads);
        found.map_err(|error| error.to_string())
    };
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
    if let Some(reactions) = &reactions {
        let (own, rows) = gathered.joints(reactions, &mut all, &mut unknown);
        joints = own;
        body_loads = gathered.body_loads(&mut all, &rows);
    }
    Some(Forces {
        metres: wished.metres,
        joints,
        curves: all.curves,
        body_loads,
        samples: all.samples,
        unknown,
    })
}

/// A page draws forces in the plane.
const IN_SPACE: &str = "the mechanism is one of space, where pages show no forces in joints; `kin forces` tells them";

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

    /// The joints, and the solutions of all rows. Moments of guides become curves.
    fn joints(
        &self,
        reactions: &NamedReactions<'_>,
        all: &mut All,
        unknown: &mut Option<String>,
    ) -> (Vec<JointForce>, Rows) {
        let rows = self.way.ascending(|sweep| match sweep.reactions(reactions) {
            Ok(rows) => rows,
            Err(error) => vec![Err(error); sweep.count()],
        });
        let outline = self.wishes.functions.outline();
        let member = |name: &str| outline.bodies.iter().position(|body| body.name == name);
        let mut joints = Vec::new();
        for name in reactions.names() {
            let [on, by] = reactions.bodies_of(name).unwrap_or_default();
            let is_slide = reactions.is_slide(name) == Ok(true);
            let mut moments = Vec::new();
            for (sample, row) in all.samples.iter_mut().zip(&rows) {
                let found = match row {
                    Ok(row) => row.of(name).map_err(|error| error.to_string()),
                    Err(ExtremesError::Gap { .. }) => Err(String::new()),
                    Err(error) => Err(self.wishes.named(error)),
                };
                let found = found.map_err(|error| {
                    if !error.is_empty() {
                        unknown.get_or_insert(error);
                    }
                });
                let force = found.ok().and_then(|force| {
                    let [x, y] = [force.x, force.y].map(|[value, rate, _]| self.sized([value, rate], 1));
                    let ([x, x_rate], [y, y_rate]) = (x?, y?);
                    Some([x, y, x_rate, y_rate])
                });
                sample.forces.push(force);
                moments.push(
                    found
                        .ok()
                        .and_then(|force| self.sized([force.moment[0], force.moment[1]], 2)),
                );
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
        for (sample, row) in all.samples.iter_mut().zip(&rows) {
            let Ok(row) = row else { continue };
            let places = reactions.names().filter_map(|name| row.pitch_point(name));
            sample.contacts = places.map(|at| [short(at.x), short(at.y)]).collect();
        }
        (joints, rows)
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
