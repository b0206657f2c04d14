//! What the equations of a pose do, as a program, and its results in columns.

use alloc::vec::Vec;

use super::equations::Solution;
use super::pose::{PosePlan, PoseSolution, TERMS};
use super::program::{Place, Program};
use super::traced::Traced;
use super::{NamedReactions, ORDERS, ReactionError, ReactionPlace};
use crate::batch::Slot;
use crate::geometry::Space;
use crate::number::Number;
use crate::number::series::{Series, SeriesOf};

/// A number on which a program depends.
#[derive(Clone, Copy, Debug)]
pub(super) enum Given {
    Dimension(usize),
    Motion(Slot),
    /// A coordinate of a joint that is drawn, by its axis and its order.
    Drawn(usize, usize, usize),
}

/// A plan with the program of what it does in a pose.
pub(super) struct TracedPlan {
    pub(super) plan: PosePlan,
    pub(super) program: Program,
    pub(super) given: Vec<Given>,
    /// The quantities that move, in the order of what is given.
    pub(super) moving: Vec<usize>,
    /// The number of quantities.
    pub(super) quantities: usize,
    /// The forces, the moments and the efforts, one after the other, each with all orders.
    forces: Vec<Place>,
    reactions: usize,
    drives: usize,
}

impl TracedPlan {
    /// The program of a plan; none if it does not fit the pose for which it was made.
    pub(super) fn of(
        reactions: &NamedReactions<'_>,
        plan: PosePlan,
        place: &ReactionPlace<'_>,
        varies: bool,
    ) -> Result<Option<Self>, ReactionError> {
        let (mut given, mut moving) = (Vec::new(), Vec::new());
        let mut quantities = 0;
        let (is_solved, program, forces) = Program::of(|| {
            let mut room = plan.room::<Traced>(reactions);
            quantities = room.moved.quantities.len();
            let mut add = |own: Given, value: f64| {
                given.push(own);
                Traced::given(given.len() - 1, value)
            };
            for quantity in &plan.needed {
                let derivatives = plan.moved.quantities[*quantity].derivatives();
                let own = &mut room.moved.quantities[*quantity];
                if slot(reactions, *quantity, 0).is_some() {
                    moving.push(*quantity);
                    let mut traced = [Traced::constant(0.0); TERMS];
                    for (order, traced) in traced.iter_mut().enumerate() {
                        if let Some(slot) = slot(reactions, *quantity, order) {
                            *traced = add(Given::Motion(slot), derivatives[order]);
                        }
                    }
                    *own = SeriesOf::from_derivatives(traced);
                } else if varies {
                    let mut terms = [Traced::constant(0.0); TERMS];
                    terms[0] = add(Given::Dimension(*quantity), derivatives[0]);
                    *own = SeriesOf::from_coefficients(terms);
                }
            }
            for index in plan.drawn() {
                let Space { x, y, z } = plan.moved.places[index];
                let [x, y, z] = [x, y, z].map(|part| part.coefficients());
                let axes = if plan.moved.is_space { 3 } else { 2 };
                let mut coordinates = [SeriesOf::constant(0.0); 3];
                for (axis, own) in coordinates.iter_mut().enumerate().take(axes) {
                    let mut terms = [Traced::constant(0.0); TERMS];
                    for (order, term) in terms.iter_mut().enumerate() {
                        *term = add(Given::Drawn(index, axis, order), [x, y, z][axis][order]);
                    }
                    *own = SeriesOf::from_coefficients(terms);
                }
                room.moved.places[index] = coordinates.into();
            }
            let is_solved = room.solve(&plan, reactions, &place.functions.outline());
            (is_solved, all_of(&room.solution))
        });
        let plan = Self {
            plan,
            program,
            given,
            moving,
            quantities,
            forces,
            reactions: reactions.connections.len(),
            drives: reactions.driven.len(),
        };
        Ok(is_solved?.then_some(plan))
    }
}

/// All numbers of a solution.
fn all_of(solution: &Solution<ORDERS, Traced>) -> Vec<Traced> {
    let vectors = solution
        .forces
        .iter()
        .chain(&solution.moments)
        .flat_map(|vector| vector.0);
    let series = vectors.chain(solution.efforts.iter().copied());
    let series = series.map(|own| own.unwrap_or(SeriesOf::constant(f64::NAN)));
    series.flat_map(|own| own.coefficients()).collect()
}

/// The solutions of a block of poses.
pub(super) struct TracedColumns<'r> {
    pub(super) traced: &'r TracedPlan,
    pub(super) results: &'r [f64],
    pub(super) stride: usize,
}

impl TracedColumns<'_> {
    /// A series by its index among all.
    fn series(&self, index: usize, pose: usize) -> Option<Series<ORDERS>> {
        let places = self.traced.forces.get(index * ORDERS..(index + 1) * ORDERS)?;
        let mut terms = [0.0; ORDERS];
        for (term, place) in terms.iter_mut().zip(places) {
            *term = match *place {
                Place::Same(value) => value,
                Place::Column(column) => self.results[column * self.stride + pose],
            };
        }
        Some(Series::from_coefficients(terms))
    }

    fn vector(&self, index: usize, pose: usize) -> Option<Space<Series<ORDERS>>> {
        let part = |axis: usize| self.series(3 * index + axis, pose);
        Some(Space::new(part(0)?, part(1)?, part(2)?))
    }
}

impl PoseSolution for TracedColumns<'_> {
    fn force(&self, index: usize, pose: usize) -> Option<Space<Series<ORDERS>>> {
        (index < self.traced.reactions).then(|| self.vector(index, pose))?
    }

    fn moment(&self, index: usize, pose: usize) -> Option<Space<Series<ORDERS>>> {
        let first = self.traced.reactions;
        (index < first).then(|| self.vector(first + index, pose))?
    }

    fn effort(&self, input: usize, pose: usize) -> Option<Series<ORDERS>> {
        let first = 6 * self.traced.reactions;
        (input < self.traced.drives).then(|| self.series(first + input, pose))?
    }
}

/// Where a batch writes a derivative of a quantity; none of a parameter.
pub(super) fn slot(reactions: &NamedReactions<'_>, quantity: usize, order: usize) -> Option<Slot> {
    let description = reactions.functions.description();
    let [inputs, unknowns] = [description.inputs.len(), description.unknowns.len()];
    let index = quantity.checked_sub(description.parameters.len())?;
    Some(if index < inputs {
        Slot::Input(index, order)
    } else if index < inputs + unknowns {
        Slot::Unknown(index - inputs, order)
    } else {
        Slot::Output(index - inputs - unknowns, order)
    })
}
