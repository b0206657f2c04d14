//! A mechanism that counts how often it is asked.

use std::cell::Cell;

use kin_core::{
    BlockForm, ClosureTerm, Description, Formulas, Mechanism, Outline, Pose, Scalar, SolveError, TransmissionAngle,
};

thread_local! {
    static CALLS: Cell<Calls> = const { Cell::new(Calls { solutions: 0, closures: 0 }) };
}

/// How often a mechanism was asked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Calls {
    /// For a position or a motion near given values.
    pub solutions: u64,
    /// For what is left of its equations.
    pub closures: u64,
}

/// The result of a computation, and how often it asks mechanisms that are [`Counting`], in this thread.
pub fn calls_of<R>(something: impl FnOnce() -> R) -> (R, Calls) {
    CALLS.set(Calls::default());
    let result = something();
    (result, CALLS.get())
}

fn count(which: impl FnOnce(&mut Calls)) {
    let mut calls = CALLS.get();
    which(&mut calls);
    CALLS.set(calls);
}

/// A mechanism whose calls are counted.
#[derive(Clone, Copy, Debug)]
pub struct Counting<M>(pub M);

impl<M: Mechanism> Mechanism for Counting<M> {
    type Scalar = M::Scalar;
    type With<S: Scalar> = Counting<M::With<S>>;
    type Assembly = M::Assembly;
    type Motion<V: Copy> = M::Motion<V>;
    type Pose = M::Pose;
    type Parameters<V: Copy> = M::Parameters<V>;
    type Inputs<V: Copy> = M::Inputs<V>;
    type Unknowns<V: Copy> = M::Unknowns<V>;
    type Results<V: Copy> = M::Results<V>;
    type Residuals<V: Copy> = M::Residuals<V>;
    type Prepared = M::Prepared;
    type Blocks<V: Copy> = M::Blocks<V>;
    type Dyads<V: Copy> = M::Dyads<V>;
    type SkeletonPoints = M::SkeletonPoints;

    fn lend<R>(use_of_it: impl FnOnce(kin_core::__private::Lent<'_>) -> R) -> R {
        M::lend(use_of_it)
    }

    const DESCRIPTION: Description = M::DESCRIPTION;
    const FORMULAS: Formulas = M::FORMULAS;
    const ASSEMBLY_COUNT: usize = M::ASSEMBLY_COUNT;
    const OUTLINE: Outline = M::OUTLINE;

    fn assembly(index: usize) -> Option<Self::Assembly> {
        M::assembly(index)
    }

    fn assembly_at(&self, inputs: Self::Inputs<Self::Scalar>, near: Self::Unknowns<Self::Scalar>) -> Self::Assembly {
        self.0.assembly_at(inputs, near)
    }

    fn from_parameters(parameters: Self::Parameters<Self::Scalar>) -> Self {
        Self(M::from_parameters(parameters))
    }

    fn parameters(&self) -> Self::Parameters<Self::Scalar> {
        self.0.parameters()
    }

    fn convert<S: Scalar>(&self, convert: impl FnMut(Self::Scalar) -> S) -> Self::With<S> {
        Counting(self.0.convert(convert))
    }

    fn prepare(&self) -> Self::Prepared {
        self.0.prepare()
    }

    fn solve_prepared(
        &self,
        prepared: &Self::Prepared,
        inputs: Self::Inputs<Self::Motion<Self::Scalar>>,
        assembly: Self::Assembly,
    ) -> Result<Self::Pose, SolveError> {
        self.0.solve_prepared(prepared, inputs, assembly)
    }

    fn solve_near(
        &self,
        inputs: Self::Inputs<Self::Motion<Self::Scalar>>,
        near: Self::Unknowns<Self::Scalar>,
    ) -> Result<Self::Pose, SolveError> {
        count(|calls| calls.solutions += 1);
        self.0.solve_near(inputs, near)
    }

    fn position(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        assembly: Self::Assembly,
    ) -> Result<Self::Unknowns<Self::Scalar>, SolveError> {
        self.0.position(inputs, assembly)
    }

    fn position_near(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        near: Self::Unknowns<Self::Scalar>,
    ) -> Result<Self::Unknowns<Self::Scalar>, SolveError> {
        count(|calls| calls.solutions += 1);
        self.0.position_near(inputs, near)
    }

    fn closure(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        unknowns: Self::Unknowns<Self::Scalar>,
    ) -> Self::Residuals<Self::Scalar> {
        count(|calls| calls.closures += 1);
        self.0.closure(inputs, unknowns)
    }

    fn closure_terms(&self, found: impl FnOnce(&'static [ClosureTerm], &[Self::Scalar])) {
        self.0.closure_terms(found);
    }

    fn skeleton_points(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        unknowns: Self::Unknowns<Self::Scalar>,
    ) -> Self::SkeletonPoints {
        self.0.skeleton_points(inputs, unknowns)
    }

    fn outputs_at(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        unknowns: Self::Unknowns<Self::Scalar>,
    ) -> <Self::Pose as Pose>::Outputs<Self::Scalar> {
        self.0.outputs_at(inputs, unknowns)
    }

    fn block_forms(&self) -> Self::Blocks<BlockForm<Self::Scalar>> {
        self.0.block_forms()
    }

    fn transmission_angles_at(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        unknowns: Self::Unknowns<Self::Scalar>,
    ) -> Self::Dyads<TransmissionAngle<Self::Scalar>> {
        self.0.transmission_angles_at(inputs, unknowns)
    }

    fn jacobian_near(
        &self,
        inputs: Self::Inputs<Self::Scalar>,
        near: Self::Unknowns<Self::Scalar>,
    ) -> Result<Self::Results<Self::Inputs<Self::Scalar>>, SolveError> {
        self.0.jacobian_near(inputs, near)
    }
}
