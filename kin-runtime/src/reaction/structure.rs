//! What is the same in all poses of an assembly, so that it is found once.

use alloc::vec::Vec;

use super::action::{Action, Influence, Influences};
use super::body_load::{Acting, of_exertion};
use super::demand::{Demand, LoadPlace};
use super::equations::{Equations, Rows, Solution, Unknown};
use super::frames::{MovedFrame, MovedMechanism};
use super::friction::stands;
use super::ordered::OrderedSystem;
use super::pose_number::{SinglePose, values};
use super::rolling::{Flank, RollingMistake};
use super::{MovedIn, MovedNumber, Moving, NamedReactions, REACH, ReactionError, ReactionPlace, Solved};
use crate::law::Side;
use crate::number::NumberRow;
use crate::number::series::SeriesOf;
use crate::picture::Outline;

/// Where loads, drives and contacts act, and what is unknown.
#[derive(Clone, Debug)]
pub(super) struct Structure {
    pub(super) places: Vec<LoadPlace>,
    pub(super) drives: Vec<Action>,
    /// Whether the bodies of each joint with friction never move against each other.
    pub(super) stand: Vec<bool>,
    /// How each contact bears first.
    pub(super) flanks: Vec<Flank>,
    pub(super) rows: Rows,
    pub(super) unknowns: Vec<Unknown>,
}

/// A structure with the order in which its equations are solved.
#[derive(Clone, Debug)]
pub(crate) struct Plan<S = f64> {
    pub(super) structure: Structure,
    /// The dimensions for which it was found.
    pub(super) parameters: NumberRow,
    pub(super) system: OrderedSystem<REACH, S>,
}

/// What a solver finds: no solution if its plan does not fit.
type FoundSolution<S> = Result<Option<Solution<REACH, S>>, ReactionError>;

/// A solution with what masses and loads exert.
type SolutionUnderLoads<S> = (Solution<REACH, S>, Vec<Acting<MovedIn<S>>>);

impl Structure {
    /// The equations in a pose.
    pub(super) fn equations<'e, T>(
        &'e self,
        reactions: &'e NamedReactions<'_>,
        outline: &'e Outline<'e>,
        moved: &'e MovedMechanism<T>,
        frames: &'e [MovedFrame<T>],
    ) -> Equations<'e, T> {
        Equations {
            outline,
            connections: &reactions.connections,
            rows: &self.rows,
            moved,
            frames,
            drives: &self.drives,
            frictions: &[],
            flanks: &self.flanks,
            parity: 1.0,
        }
    }

    /// What the loads exert in a pose.
    pub(super) fn demand<'d, T>(
        &'d self,
        reactions: &'d NamedReactions<'_>,
        moved: &'d MovedMechanism<T>,
        frames: &'d [MovedFrame<T>],
        rate: f64,
    ) -> Demand<'d, T> {
        Demand {
            loads: &reactions.loads,
            places: &self.places,
            moved,
            frames,
            rate,
        }
    }

    /// The order of the elimination at values of the columns. Their entries are told by all influences, as one pose
    /// may have a zero where others have none. None if equilibrium does not determine all forces.
    pub(super) fn order<S: SinglePose, const N: usize>(
        &self,
        reactions: &NamedReactions<'_>,
        outline: &Outline<'_>,
        columns: &[Vec<SeriesOf<S, N>>],
        all: &[Influence<REACH>],
    ) -> Option<OrderedSystem<N, S>> {
        if self.unknowns.len() != self.rows.count() {
            return None;
        }
        let sample = |one: &Influence<REACH>| {
            let equations = self.equations(reactions, outline, &one.moved, &one.frames);
            equations.columns(&self.unknowns)
        };
        OrderedSystem::planned(columns, all.iter().map(sample))
    }
}

impl NamedReactions<'_> {
    /// The structure in a pose, with the mechanism there while each input moves alone.
    pub(super) fn structure(
        &self,
        place: &ReactionPlace<'_>,
        outline: &Outline<'_>,
        moved: &MovedMechanism<MovedNumber>,
        frames: &[MovedFrame<MovedNumber>],
    ) -> Result<(Structure, Vec<Influence<REACH>>), ReactionError> {
        let connections = &self.connections;
        let all = place.influences(place.parameters, outline, connections, Some((moved, frames)))?;
        let otherwise = || place.otherwise(outline, connections).unwrap_or_default();
        let influences = Influences {
            outline,
            connections,
            all: &all,
            otherwise: &otherwise,
        };
        let places = LoadPlace::all(&self.loads, place.functions.description(), &influences)?;
        let drives = self.drives(&influences)?;
        let stand = |(index, _): &(usize, _)| all.iter().all(|one| stands(&connections[*index], one));
        let mut structure = Structure {
            places,
            drives,
            stand: self.frictions.iter().map(stand).collect(),
            flanks: self.flanks(&all)?,
            rows: Rows::of(moved, frames),
            unknowns: Vec::new(),
        };
        structure.unknowns = structure.equations(self, outline, moved, frames).unknowns(&influences);
        Ok((structure, all))
    }

    /// The solution at a place, by a plan if one is kept, which is made anew where it is none or does not fit.
    pub(super) fn solved_by(
        &self,
        place: &ReactionPlace<'_>,
        kept: Option<&mut Option<Plan>>,
    ) -> Result<Solved, ReactionError> {
        let moving = place.moving(&place.functions.outline(), &self.connections)?;
        self.solved_in_motion(place, moving, kept)
    }

    /// The same for the mechanism as it moves there, in numbers that may change with a dimension.
    pub(super) fn solved_in_motion<S: SinglePose>(
        &self,
        place: &ReactionPlace<'_>,
        (moved, frames): Moving<S>,
        mut kept: Option<&mut Option<Plan<S>>>,
    ) -> Result<Solved<S>, ReactionError> {
        let outline = place.functions.outline();
        let fits = |plan: &&mut Plan<S>| {
            plan.parameters[..] == *place.parameters
                && plan.structure.rows.fit(&moved, &frames)
                && moved.check(&outline, &self.connections, &frames).is_ok()
        };
        let plan = kept.as_deref_mut().and_then(Option::as_mut).filter(fits);
        if let Some(Plan { structure, system, .. }) = plan {
            let solve = |equations: &Equations<'_, MovedIn<S>>, right: &[MovedIn<S>]| {
                equations.solve_in(system, &structure.unknowns, right)
            };
            let solved = self.solved_in(place, &outline, structure, (&moved, &frames), solve)?;
            if let Some((solution, loads)) = solved {
                return Ok(Solved {
                    solution,
                    loads,
                    drives: structure.drives.clone(),
                    moved,
                    frames,
                });
            }
        }
        let own = moved.clone().map(values);
        let own_frames: Vec<_> = frames.iter().map(MovedFrame::values).collect();
        let (structure, all) = self.structure(place, &outline, &own, &own_frames)?;
        let mut columns = Vec::new();
        let solve = |equations: &Equations<'_, MovedIn<S>>, right: &[MovedIn<S>]| {
            columns = equations.columns(&structure.unknowns);
            equations.solve(&structure.unknowns, &columns, right).map(Some)
        };
        let solved = self.solved_in(place, &outline, &structure, (&moved, &frames), solve)?;
        let Some((solution, loads)) = solved else {
            return Err(ReactionError::NotFinite);
        };
        let drives = structure.drives.clone();
        if let Some(plan) = kept {
            *plan = structure.order(self, &outline, &columns, &all).map(|system| Plan {
                structure,
                parameters: place.parameters.into(),
                system,
            });
        }
        Ok(Solved {
            solution,
            loads,
            drives,
            moved,
            frames,
        })
    }

    /// The solution in a structure, with what loads exert; none if the solver gives none.
    fn solved_in<S: SinglePose>(
        &self,
        place: &ReactionPlace<'_>,
        outline: &Outline<'_>,
        structure: &Structure,
        (moved, frames): (&MovedMechanism<MovedIn<S>>, &[MovedFrame<MovedIn<S>>]),
        mut solve: impl FnMut(&Equations<'_, MovedIn<S>>, &[MovedIn<S>]) -> FoundSolution<S>,
    ) -> Result<Option<SolutionUnderLoads<S>>, ReactionError> {
        let frictions = self.acting(place, outline, (moved, frames), &structure.stand)?;
        let mut loads = Vec::new();
        let demand = structure.demand(self, moved, frames, place.rate);
        demand.each(&mut |kind, exertion| loads.extend(of_exertion(kind, exertion, frames)))?;
        let mut equations = Equations {
            frictions: &frictions,
            parity: if place.side == Side::Left { -1.0 } else { 1.0 },
            ..structure.equations(self, outline, moved, frames)
        };
        let right = equations.lacking(loads.iter().map(|(_, body, wrench)| (*body, wrench)));
        let Some(mut solution) = solve(&equations, &right)? else {
            return Ok(None);
        };
        let mut bears = structure.flanks.clone();
        equations.bears(&solution, &mut bears);
        if bears != structure.flanks {
            equations.flanks = &bears;
            let Some(turned) = solve(&equations, &right)? else {
                return Ok(None);
            };
            solution = turned;
            let mut found = bears.clone();
            equations.bears(&solution, &mut found);
            if let Some(connection) = found.iter().zip(&bears).position(|(found, own)| found != own) {
                return Err(ReactionError::Rolling {
                    reaction: self.connections[connection].name.clone(),
                    mistake: RollingMistake::NoFlank,
                });
            }
        }
        Ok(Some((solution, loads)))
    }
}
