//! The solvers: positions and motions in an assembly and near values, their errors, and what belongs to a position.

use kin_core::any::{
    AnyMechanism, AssemblyMotionOver, AssemblyOver, ClosureTermsOver, Described, EveryPosition, FormsOver,
    MotionNearOver, Named, NearOver, Of, Pictured, TransmissionOver,
};
use kin_core::{Mechanism, SolveError, TransmissionAngle};

use crate::bits::Bits;
use crate::random::Random;
use crate::samples;

/// The searches for all positions of a mechanism, each of which may follow hundreds of paths.
const SEARCHES: usize = 2;

/// A mechanism gives the description of its text.
pub(crate) fn assert_same_description<M: Mechanism<Scalar = f64>>(live: &kin_live::Mechanism) {
    let (own, expected) = (live.description(), M::DESCRIPTION);
    assert_eq!(own.parameters, expected.parameters);
    assert_eq!(
        (own.inputs, own.unknowns, own.outputs),
        (expected.inputs, expected.unknowns, expected.outputs)
    );
    assert_eq!((own.equations, own.blocks), (expected.equations, expected.blocks));
    assert_eq!((own.order, own.operations), (expected.order, expected.operations));
    assert_eq!(live.assembly_count(), M::ASSEMBLY_COUNT);
    assert_eq!(live.assembly_names(), Of::<M>::FUNCTIONS.assembly_names());
    assert_eq!(live.choices(), Of::<M>::FUNCTIONS.choices());
    assert_eq!(live.dyad_count(), Of::<M>::FUNCTIONS.dyad_count());
}

/// A mechanism is shown as its text is.
pub(crate) fn assert_same_picture<M: Mechanism<Scalar = f64>>(live: &kin_live::Mechanism) {
    let compiled = Of::<M>::FUNCTIONS;
    assert_eq!((live.outline(), live.is_space()), (M::OUTLINE, compiled.is_space()));
    assert_eq!(live.formulas(), M::FORMULAS);
}

/// The functions of a mechanism that are compared, in one kind of numbers.
trait Solver<T>:
    AssemblyOver<T>
    + NearOver<T>
    + AssemblyMotionOver<T>
    + MotionNearOver<T>
    + TransmissionOver<T>
    + FormsOver<T>
    + ClosureTermsOver<T>
{
}

impl<T, F> Solver<T> for F where
    F: AssemblyOver<T>
        + NearOver<T>
        + AssemblyMotionOver<T>
        + MotionNearOver<T>
        + TransmissionOver<T>
        + FormsOver<T>
        + ClosureTermsOver<T>
{
}

/// A pose to be solved.
struct Problem<T> {
    parameters: Vec<T>,
    /// The motions of the inputs, one after the other.
    motions: Vec<T>,
    inputs: Vec<T>,
    near: Vec<T>,
}

/// The bits of a result, or the text of an error.
type Answer = Result<Vec<Vec<u64>>, String>;

fn bits<T: Bits>(numbers: &[T]) -> Vec<Vec<u64>> {
    numbers.iter().map(|number| number.bits()).collect()
}

/// An error with its names and all digits. Names are written with quotes by one of both, and without by the other.
fn text(error: SolveError, own: &dyn Described) -> String {
    let shown = format!("{error} {error:?}");
    // the inputs have their names by reference or by index
    let shown = shown.split(" inputs: ").next().unwrap_or_default().to_owned();
    Named::new(shown, own.description()).to_string().replace('"', "")
}

/// All answers about a pose.
fn answers<T: Bits>(
    solver: &impl Solver<T>,
    own: &dyn Described,
    problem: &Problem<T>,
    assembly: usize,
) -> Vec<Answer> {
    let Problem {
        parameters,
        motions,
        inputs,
        near,
    } = problem;
    let description = own.description();
    let orders = description.order + 1;
    let zero = T::constant(0.0);
    let position = || vec![zero; description.unknowns.len()];
    let motion = || [&description.unknowns, &description.outputs].map(|all| vec![zero; all.len() * orders]);
    let answer = |result: Result<(), SolveError>, numbers: &[&[T]]| {
        result.map_err(|error| text(error, own))?;
        Ok(numbers.iter().flat_map(|numbers| bits(numbers)).collect())
    };
    let mut all = Vec::new();
    if assembly < own.assembly_count() {
        let mut unknowns = position();
        let result = solver.position_of_assembly(parameters, inputs, assembly, &mut unknowns);
        all.push(answer(result, &[&unknowns]));
        let [mut unknowns, mut outputs] = motion();
        let result = solver.motion_of_assembly(parameters, motions, assembly, &mut unknowns, &mut outputs);
        all.push(answer(result, &[&unknowns, &outputs]));
    }
    let mut unknowns = position();
    let result = solver.position_near(parameters, inputs, near, &mut unknowns);
    all.push(answer(result, &[&unknowns]));
    let [mut unknowns, mut outputs] = motion();
    let result = solver.motion_near(parameters, motions, near, &mut unknowns, &mut outputs);
    all.push(answer(result, &[&unknowns, &outputs]));
    let mut angles = vec![TransmissionAngle::of("", zero, zero); own.dyad_count()];
    solver.angles_of_dyads(parameters, inputs, near, &mut angles);
    for angle in angles {
        let name = Named::new(angle.block, description).to_string();
        all.push(Ok(angle.angle.bits().into_iter().map(|bits| vec![bits]).collect()));
        all.push(Err(name));
    }
    solver.block_forms(parameters, &mut |form| {
        all.push(Err(Named::new(format!("{form:?}"), description)
            .to_string()
            .replace('"', "")));
    });
    solver.closure_terms(parameters, &mut |terms, coefficients| {
        all.push(Err(format!("{terms:?}")));
        all.push(Ok(bits(coefficients)));
    });
    all
}

/// Compares all answers at random poses. Returns how many positions were solved.
pub(crate) fn agreeing<M: Mechanism<Scalar = f64>, T: Bits>(live: &kin_live::Mechanism) -> usize {
    let compiled = Of::<M>::FUNCTIONS;
    let description = M::DESCRIPTION;
    let mut random = Random::new(11);
    let mut solved = 0;
    let mut found: Option<Vec<T>> = None;
    for sample in 0..samples() {
        let broken = sample % 50 == 49;
        let mut drawn = |count: usize| (0..count).map(|_| T::drawn(&mut random)).collect::<Vec<T>>();
        let (parameters, motions, near) = (
            drawn(description.parameters.len()),
            drawn(description.inputs.len() * (description.order + 1)),
            drawn(description.unknowns.len()),
        );
        // lengths are positive, as a rule, and similar
        let mut parameters: Vec<T> = parameters
            .into_iter()
            .map(|value| value * value + T::constant(0.5))
            .collect();
        if broken && let Some(first) = parameters.first_mut() {
            *first = T::constant(f64::NAN);
        }
        let inputs = motions.iter().step_by(description.order + 1).copied().collect();
        let near = found.take().filter(|_| sample % 3 > 0).unwrap_or(near);
        let problem = Problem {
            parameters,
            motions,
            inputs,
            near,
        };
        let assembly = if M::ASSEMBLY_COUNT == 0 {
            0
        } else {
            sample % M::ASSEMBLY_COUNT
        };
        let own = answers(live, live, &problem, assembly);
        let expected = answers(compiled, compiled, &problem, assembly);
        assert_eq!(own, expected, "{} in sample {sample}", description.name);
        solved += usize::from(own[0].is_ok());
        let mut unknowns = vec![T::constant(0.0); description.unknowns.len()];
        let Problem {
            parameters,
            inputs,
            near,
            ..
        } = &problem;
        if compiled.position_near(parameters, inputs, near, &mut unknowns).is_ok() {
            found = Some(unknowns);
        }
    }
    solved
}

/// Compares all positions at some random inputs, and the assemblies to which they belong, in double precision.
pub(crate) fn assert_same_positions<M: Mechanism<Scalar = f64>>(live: &kin_live::Mechanism) {
    let mut random = Random::new(12);
    for _ in 0..SEARCHES {
        let mut drawn = |count: usize| (0..count).map(|_| f64::drawn(&mut random)).collect::<Vec<_>>();
        let parameters = drawn(M::DESCRIPTION.parameters.len());
        let parameters: Vec<f64> = parameters.into_iter().map(|value| value * value + 0.5).collect();
        assert_same_positions_at::<M>(live, &parameters, &drawn(M::DESCRIPTION.inputs.len()));
    }
}

fn assert_same_positions_at<M: Mechanism<Scalar = f64>>(
    live: &kin_live::Mechanism,
    parameters: &[f64],
    inputs: &[f64],
) {
    let compiled = Of::<M>::FUNCTIONS;
    let all = |own: &dyn EveryPosition| {
        let mut found = Vec::new();
        let search = own.every_position(parameters, inputs, &mut |unknowns| found.push(unknowns.to_vec()));
        search.map(|search| (search, found))
    };
    let (own, expected) = (all(live), all(compiled));
    match (own, expected) {
        (Ok((own, found)), Ok((expected, wanted))) => {
            assert_eq!(own, expected);
            for unknowns in &found {
                let [own, expected] =
                    [live as &dyn AnyMechanism, compiled].map(|own| own.assembly_at(parameters, inputs, unknowns));
                assert_eq!(own, expected.filter(|_| M::ASSEMBLY_COUNT > 0));
            }
            assert_eq!(found, wanted);
        }
        (own, expected) => assert_eq!(
            own.map_err(|error| text(error, live)),
            expected.map_err(|error| text(error, compiled))
        ),
    }
}
