//! The line of inputs along which a report moves, at constant speed.

use kin_core::SolveError;
use kin_core::any::{AssemblyChoice, Quantity};
use kin_core::linkage::{AnyCycle, AnyLinkage, AnySweep};
use kin_core::sweep::StraightLine;

use super::way::ROWS;
use crate::report::ReportError;
use crate::report::draft::{WayWished, Wishes};

/// A straight line in the space of the inputs. Its variable is the first input that moves.
pub(super) struct Line {
    /// The index of that input.
    pub(super) lead: usize,
    /// The value of that input where the assembly was asked for.
    pub(super) start: f64,
    /// Its range, if one was given.
    pub(super) range: Option<[f64; 2]>,
    /// Its velocity.
    pub(super) speed: f64,
    /// The given points of the line. The assembly was asked for at the first.
    given: Vec<Vec<f64>>,
    /// The way of each input for each unit of the variable.
    direction: Vec<f64>,
}

impl Line {
    pub(super) fn new(wishes: &Wishes<'_>) -> Result<Self, ReportError> {
        let inputs = wishes.linkage.description().inputs;
        let speed = wishes.speed.unwrap_or(1.0);
        match &wishes.way {
            WayWished::Between([from, to]) => {
                let lead = from.iter().zip(to).position(|(from, to)| from != to);
                let lead = lead.ok_or_else(|| ReportError::NoWay {
                    inputs: wishes.linkage.input_values(from),
                })?;
                let way = to[lead] - from[lead];
                let parts = from.iter().zip(to).map(|(from, to)| (to - from) / way);
                Ok(Self {
                    lead,
                    start: from[lead],
                    range: Some([from[lead].min(to[lead]), from[lead].max(to[lead])]),
                    speed: way.signum() * speed,
                    given: vec![from.clone(), to.clone()],
                    direction: parts.collect(),
                })
            }
            WayWished::OneInput | WayWished::UnderLaws(..) => {
                let lead = moving(wishes, inputs)?;
                let at = wishes.at.clone().unwrap_or_else(|| vec![0.0; inputs.len()]);
                let mut direction = vec![0.0; inputs.len()];
                direction[lead] = 1.0;
                Ok(Self {
                    lead,
                    start: at[lead],
                    range: wishes.range,
                    speed,
                    given: vec![at],
                    direction,
                })
            }
        }
    }

    /// The inputs at a value of the variable. Given points are returned exactly.
    pub(super) fn inputs_at(&self, at: f64) -> Vec<f64> {
        if let Some(given) = self.given.iter().find(|given| given[self.lead] == at) {
            return given.clone();
        }
        let parts = self.given[0].iter().zip(&self.direction);
        let mut inputs: Vec<f64> = parts.map(|(value, part)| value + part * (at - self.start)).collect();
        inputs[self.lead] = at;
        inputs
    }

    /// The inputs where the assembly was asked for.
    pub(super) fn inputs(&self) -> &[f64] {
        &self.given[0]
    }

    /// The sweep from one value of the variable to another.
    pub(super) fn sweep<'m>(
        &self,
        linkage: &AnyLinkage<'m>,
        assembly: &AssemblyChoice,
        [from, to]: [f64; 2],
    ) -> AnySweep<'m, StraightLine> {
        let ends = [from, to].map(|at| self.inputs_at(at));
        let sweep = linkage.sweep(assembly.clone()).between(&ends[0], &ends[1], ROWS);
        // a sweep downwards has a positive speed downwards
        sweep.speed(if to < from { -self.speed } else { self.speed })
    }

    /// All circuits and branches. Their input is the variable of the line.
    pub(super) fn cycle<'m>(&self, linkage: &AnyLinkage<'m>) -> Result<AnyCycle<'m>, SolveError> {
        linkage.cycle_along(&self.inputs_at(0.0), &self.direction)
    }
}

/// The index of the input that moves.
fn moving(wishes: &Wishes<'_>, inputs: &[Quantity<'_>]) -> Result<usize, ReportError> {
    let Some(name) = &wishes.moving else { return Ok(0) };
    let found = inputs.iter().position(|input| input.name == name);
    found.ok_or_else(|| ReportError::NoSuchInput {
        name: name.clone(),
        inputs: inputs.iter().map(|input| input.name.to_owned()).collect(),
    })
}
