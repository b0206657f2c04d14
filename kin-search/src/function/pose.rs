//! The function of a mechanism that solves one pose for each row.

use std::hash::{Hash, Hasher};
use std::sync::Arc;

use datafusion::arrow::array::{ArrayRef, Float64Array, StringArray, StructArray};
use datafusion::arrow::buffer::{BooleanBuffer, NullBuffer};
use datafusion::arrow::datatypes::{DataType, Field, FieldRef, Fields};
use datafusion::common::{Result, ScalarValue, exec_datafusion_err, plan_err};
use datafusion::logical_expr::{
    ColumnarValue, DocSection, Documentation, ReturnFieldArgs, ScalarFunctionArgs, ScalarUDFImpl, Signature, Volatility,
};
use kin_core::any::Quantity;
use kin_core::batch::{Column, ColumnChoice, GivenColumns, Outcome, Slot, Vectors, WantedColumns, angles_from_cosines};
use kin_core::in_small_letters;

use super::arguments::{Argument, FEWEST_ROWS, Numbers, Texts, accepted, coerced, signature, valid_rows};
use super::assembly;
use super::names::{of_order, plain, unit};
use super::settings;
use super::solver::{OfMechanism, SearchedMechanism, Solver};

/// The section of the documentation to which the functions belong.
pub(crate) const SECTION: DocSection = DocSection {
    include: true,
    label: "Mechanisms",
    description: Some("kin's solvers"),
};

/// Whether a function is one of kin's solvers.
#[cfg(feature = "cluster")]
pub(crate) fn is_solver(function: &datafusion::logical_expr::ScalarUDF) -> bool {
    function
        .documentation()
        .is_some_and(|documentation| documentation.doc_section.label == SECTION.label)
}

/// The texts of all outcomes.
const OUTCOMES: [&str; 4] = ["solved", "out_of_reach", "singular", "failed"];

/// The text of an outcome.
fn text_of(outcome: Outcome) -> &'static str {
    OUTCOMES[match outcome {
        Outcome::Solved => 0,
        Outcome::OutOfReach { .. } => 1,
        Outcome::Singular => 2,
        _ => 3,
    }]
}

/// A function such as `four_bar(r1, r2, r3, r4, theta2, …)`.
#[derive(Debug)]
pub(crate) struct PoseFunction {
    name: String,
    mechanism: SearchedMechanism,
    assemblies: Vec<String>,
    arguments: Vec<Argument>,
    /// The number of arguments that cannot be left out.
    required: usize,
    signature: Signature,
    documentation: Documentation,
}

/// The meaning of the arguments of a call, by their indices.
struct Layout {
    /// The index of the assembly.
    assembly: Option<usize>,
    /// The indices of the rates of the inputs: the velocities of all inputs, then the accelerations, and so on.
    rates: Vec<usize>,
    /// The highest order given.
    order: usize,
}

/// The dimensions of a mechanism as arguments.
pub(crate) fn dimensions(solver: &dyn Solver) -> Vec<Argument> {
    let meaning = |quantity: &Quantity<'_>| format!("{} ({})", quantity.description, unit(quantity.dimension, 0));
    let parameters = solver.description().parameters.iter();
    parameters
        .map(|quantity| Argument::number(plain(quantity), meaning(quantity)))
        .collect()
}

/// The choice among several positions as arguments: a text, or values nearby.
pub(crate) fn choice(solver: &dyn Solver, assemblies: &[String]) -> Vec<Argument> {
    match assemblies {
        [] => {
            let near = |quantity: &Quantity<'_>| {
                Argument::number(
                    format!("near_{}", plain(quantity)),
                    format!(
                        "A value of {} near the wanted position ({})",
                        quantity.name,
                        unit(quantity.dimension, 0)
                    ),
                )
            };
            solver.description().unknowns.iter().map(near).collect()
        }
        [_] => Vec::new(),
        names => vec![Argument::text(
            "assembly",
            format!(
                "One of {}; the first of them if it is left out",
                assembly::listed(names)
            ),
        )],
    }
}

impl PoseFunction {
    pub(crate) fn new(mechanism: &SearchedMechanism) -> Self {
        let solver = &**mechanism;
        let description = solver.description();
        let name = in_small_letters(description.name, '_');
        let assemblies = solver.assembly_names();
        let mut arguments = dimensions(solver);
        for input in description.inputs {
            let meaning = format!("{} ({})", input.description, unit(input.dimension, 0));
            arguments.push(Argument::number(plain(input), meaning));
        }
        let mut required = arguments.len();
        let choice = choice(solver, &assemblies);
        if assemblies.is_empty() {
            required += choice.len();
        }
        arguments.extend(choice);
        for order in 1..=description.order {
            for input in description.inputs {
                let meaning = format!(
                    "A derivative of {}, zero if it is left out ({})",
                    input.name,
                    unit(input.dimension, order)
                );
                arguments.push(Argument::number(of_order(&plain(input), order), meaning));
            }
        }
        let signature = signature(&arguments, Volatility::Immutable);
        let documentation = documentation(&name, solver, &arguments);
        Self {
            name,
            mechanism: mechanism.clone(),
            assemblies,
            arguments,
            required,
            signature,
            documentation,
        }
    }

    /// The types to which the arguments of a call are converted, if there is such a call.
    fn coerced(&self, types: &[DataType]) -> Result<Vec<DataType>> {
        coerced(&self.name, &self.arguments, self.required, types)
    }

    fn layout(&self, types: &[DataType]) -> Result<Layout> {
        let is_text = |index: &usize| types[*index] != DataType::Float64;
        let assembly = (self.required..types.len()).find(is_text);
        let rates: Vec<usize> = (self.required..types.len()).filter(|index| !is_text(index)).collect();
        let inputs = self.mechanism.description().inputs.len();
        if rates.len() + usize::from(assembly.is_some()) + self.required != types.len() {
            return plan_err!("{} takes one text at most, the assembly", self.name);
        }
        if !rates.len().is_multiple_of(inputs) {
            return plan_err!(
                "{} has {inputs} inputs, and {} rates are given: give the velocities of all, then the accelerations of \
                 all, and so on",
                self.name,
                rates.len()
            );
        }
        Ok(Layout {
            assembly,
            order: rates.len() / inputs,
            rates,
        })
    }

    /// The fields of the result through an order.
    fn fields(&self, order: usize) -> Fields {
        let description = self.mechanism.description();
        let mut fields = Vec::new();
        for quantity in description.unknowns.iter().chain(description.outputs) {
            for order in 0..=order {
                fields.push(Field::new(of_order(&plain(quantity), order), DataType::Float64, true));
            }
        }
        // Not a dictionary: executors of a cluster send its texts alone, while the next stage waits for a dictionary.
        fields.push(Field::new("outcome", DataType::Utf8, true));
        fields.push(Field::new("margin", DataType::Float64, true));
        fields.into()
    }

    fn solve(&self, args: &ScalarFunctionArgs) -> Result<ArrayRef> {
        let rows = args.number_rows;
        let types: Vec<DataType> = args.args.iter().map(ColumnarValue::data_type).collect();
        let layout = self.layout(&types)?;
        let description = self.mechanism.description();
        let vectors = settings::vectors(&args.config_options)?;
        let valid = valid_rows(&args.args, rows);
        let numbers = |indices: &mut dyn Iterator<Item = usize>| -> Result<Vec<Numbers>> {
            indices.map(|index| Numbers::new(&args.args[index])).collect()
        };
        let (parameters, inputs) = (description.parameters.len(), description.inputs.len());
        let first_near = parameters + inputs;
        let dimensions = numbers(&mut (0..parameters))?;
        let positions = numbers(&mut (parameters..first_near))?;
        let near = numbers(&mut (first_near..self.required))?;
        let rates = numbers(&mut layout.rates.iter().copied())?;
        let assembly = match layout.assembly {
            Some(index) => Texts::new(&args.args[index])?,
            None => Texts::Same(None),
        };

        let dimensions: Vec<Column<'_>> = dimensions.iter().map(Numbers::column).collect();
        let near: Vec<Column<'_>> = near.iter().map(Numbers::column).collect();
        let motion = |input: usize| -> Vec<Column<'_>> {
            let rates = rates.iter().skip(input).step_by(inputs);
            [&positions[input]]
                .into_iter()
                .chain(rates)
                .map(Numbers::column)
                .collect()
        };
        let motions: Vec<Vec<Column<'_>>> = (0..inputs).map(motion).collect();
        let motions: Vec<&[Column<'_>]> = motions.iter().map(Vec::as_slice).collect();
        let mut poses: Option<Poses> = None;
        for (text, text_rows) in assembly.groups(rows) {
            let choice = match text {
                _ if self.assemblies.is_empty() => ColumnChoice::Near(&near),
                None => ColumnChoice::Assembly(0),
                Some(text) => ColumnChoice::Assembly(assembly::index_of(&self.assemblies, text)?),
            };
            let given = GivenColumns {
                parameters: &dimensions,
                inputs: &motions,
                choice,
            };
            let found = Poses::solve(&*self.mechanism, given, layout.order, rows, vectors)?;
            match (&mut poses, text_rows) {
                (Some(poses), Some(text_rows)) => poses.take(&found, &text_rows),
                (poses, _) => *poses = Some(found),
            }
        }
        let poses = poses.unwrap_or_default();
        Ok(Arc::new(poses.into_array(self.fields(layout.order), rows, valid)?))
    }
}

/// The poses of a batch, column by column.
#[derive(Default)]
struct Poses {
    /// The unknowns and then the outputs, each with its rates.
    columns: Vec<Vec<f64>>,
    outcomes: Vec<Outcome>,
}

impl Poses {
    fn solve(
        solver: &dyn Solver,
        given: GivenColumns<'_>,
        order: usize,
        rows: usize,
        vectors: Vectors,
    ) -> Result<Self> {
        let description = solver.description();
        // as many rows as are solved in vectors of any width
        let padded = if rows == 0 { 0 } else { rows.max(FEWEST_ROWS) };
        let (unknowns, outputs) = (description.unknowns.len(), description.outputs.len());
        let mut columns = vec![vec![0.0; padded]; (unknowns + outputs) * (order + 1)];
        let mut outcomes = vec![Outcome::Unsolved; padded];
        let is_direction = |unknown: usize| description.unknowns[unknown].is_direction;
        let sine = |unknown| vec![0.0; if is_direction(unknown) { padded } else { 0 }];
        let mut sines: Vec<Vec<f64>> = (0..unknowns).map(sine).collect();

        let mut wanted = Vec::new();
        for (index, column) in columns.iter_mut().enumerate() {
            let (quantity, order) = (index / (order + 1), index % (order + 1));
            let slot = match quantity.checked_sub(unknowns) {
                None => Slot::Unknown(quantity, order),
                Some(output) => Slot::Output(output, order),
            };
            wanted.push((slot, column.as_mut_slice()));
        }
        for (unknown, sine) in sines
            .iter_mut()
            .enumerate()
            .filter(|(unknown, _)| is_direction(*unknown))
        {
            wanted.push((Slot::Sine(unknown), sine.as_mut_slice()));
        }
        solver
            .solve_batch(given, &mut WantedColumns::new(wanted), &mut outcomes, vectors)
            .map_err(|mismatch| exec_datafusion_err!("{mismatch}"))?;
        for (unknown, sines) in sines.iter().enumerate() {
            angles_from_cosines(&mut columns[unknown * (order + 1)], sines);
        }
        Ok(Self { columns, outcomes })
    }

    /// Takes over some rows.
    fn take(&mut self, other: &Self, rows: &[usize]) {
        for row in rows.iter().copied() {
            for (column, other) in self.columns.iter_mut().zip(&other.columns) {
                column[row] = other[row];
            }
            self.outcomes[row] = other.outcomes[row];
        }
    }

    /// The poses as an array. The numbers of a row are null if it has no pose, and the row is if an argument was.
    fn into_array(mut self, fields: Fields, rows: usize, valid: Option<NullBuffer>) -> Result<StructArray> {
        self.outcomes.truncate(rows);
        let all_solved = self.outcomes.iter().all(Outcome::is_solved);
        let solved = (!all_solved).then(|| {
            let found = self.outcomes.iter().map(Outcome::is_solved);
            NullBuffer::new(found.collect::<BooleanBuffer>())
        });
        // A field is read without a look at its row, so it is null itself where the row is.
        let numbers = NullBuffer::union(solved.as_ref(), valid.as_ref());
        let mut arrays: Vec<ArrayRef> = Vec::with_capacity(fields.len());
        for mut column in self.columns {
            column.truncate(rows);
            arrays.push(Arc::new(Float64Array::new(column.into(), numbers.clone())));
        }
        let is_valid = |row: usize| valid.as_ref().is_none_or(|valid| valid.is_valid(row));
        let rows_with_outcomes = || self.outcomes.iter().enumerate();
        let texts: StringArray = rows_with_outcomes()
            .map(|(row, outcome)| is_valid(row).then(|| text_of(*outcome)))
            .collect();
        arrays.push(Arc::new(texts));
        let margins: Float64Array = if all_solved {
            Float64Array::new_null(rows)
        } else {
            rows_with_outcomes()
                .map(|(row, outcome)| outcome.margin().filter(|_| is_valid(row)))
                .collect()
        };
        arrays.push(Arc::new(margins));
        Ok(StructArray::try_new_with_length(fields, arrays, valid, rows)?)
    }
}

/// The result of a function for all rows, or for one if all its arguments are constant.
pub(crate) fn constant_or_column(args: &[ColumnarValue], array: ArrayRef) -> Result<ColumnarValue> {
    if array.len() == 1 && args.iter().all(|argument| matches!(argument, ColumnarValue::Scalar(_))) {
        return Ok(ColumnarValue::Scalar(ScalarValue::try_from_array(&array, 0)?));
    }
    Ok(ColumnarValue::Array(array))
}

fn documentation(name: &str, solver: &dyn Solver, arguments: &[Argument]) -> Documentation {
    let description = solver.description();
    let listed = |quantities: &[Quantity<'_>]| {
        let one = |quantity: &Quantity<'_>| {
            format!(
                "{} ({}; {})",
                plain(quantity),
                quantity.description,
                unit(quantity.dimension, 0)
            )
        };
        quantities.iter().map(one).collect::<Vec<_>>().join(", ")
    };
    let outputs = if description.outputs.is_empty() {
        String::new()
    } else {
        format!("; outputs {}", listed(description.outputs))
    };
    let text = format!(
        "A pose of the mechanism {}: {}. Arguments: {}. The result has the unknowns {}{outputs}; each with as many \
         rates as the inputs have; and outcome, which is '{}', and margin, the missing length as a negative number if \
         the links do not reach. Numbers are null without a pose.",
        description.name,
        description.equations.join("; "),
        meanings(arguments),
        listed(description.unknowns),
        OUTCOMES.join("', '"),
    );
    documented(name, text, arguments)
}

/// Arguments with their meanings.
pub(crate) fn meanings(arguments: &[Argument]) -> String {
    let one = |argument: &Argument| format!("{}: {}", argument.name, argument.meaning);
    arguments.iter().map(one).collect::<Vec<_>>().join("; ")
}

/// The documentation of a function by its text and its arguments.
pub(crate) fn documented(name: &str, text: String, arguments: &[Argument]) -> Documentation {
    let syntax = format!("{name}({})", super::arguments::names(arguments));
    let builder = Documentation::builder(SECTION, text, syntax);
    let builder = arguments.iter().fold(builder, |builder, argument| {
        builder.with_argument(argument.name.as_str(), argument.meaning.as_str())
    });
    builder.build()
}

impl PartialEq for PoseFunction {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.mechanism.declaration() == other.mechanism.declaration()
    }
}

impl Eq for PoseFunction {}

impl OfMechanism for PoseFunction {
    fn mechanism(&self) -> &SearchedMechanism {
        &self.mechanism
    }
}

impl Hash for PoseFunction {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

impl ScalarUDFImpl for PoseFunction {
    fn name(&self) -> &str {
        &self.name
    }

    fn signature(&self) -> &Signature {
        &self.signature
    }

    fn coerce_types(&self, types: &[DataType]) -> Result<Vec<DataType>> {
        Ok(accepted(self.coerced(types), types))
    }

    fn return_type(&self, types: &[DataType]) -> Result<DataType> {
        let types = self.coerced(types)?;
        Ok(DataType::Struct(self.fields(self.layout(&types)?.order)))
    }

    fn return_field_from_args(&self, args: ReturnFieldArgs<'_>) -> Result<FieldRef> {
        let types: Vec<DataType> = args.arg_fields.iter().map(|field| field.data_type().clone()).collect();
        Ok(Arc::new(Field::new(&self.name, self.return_type(&types)?, true)))
    }

    fn invoke_with_args(&self, args: ScalarFunctionArgs) -> Result<ColumnarValue> {
        let array = self.solve(&args)?;
        constant_or_column(&args.args, array)
    }

    fn documentation(&self) -> Option<&Documentation> {
        Some(&self.documentation)
    }
}
