//! The common part of the functions of revolutions: their arguments, and the rows of a call.

use datafusion::arrow::buffer::NullBuffer;
use datafusion::arrow::datatypes::DataType;
use datafusion::common::{Result, exec_err, plan_err};
use datafusion::logical_expr::{ColumnarValue, Documentation, ScalarFunctionArgs, Signature, Volatility};
use kin_core::batch::{Column, ColumnChoice, GivenColumns, InputGrid, Vectors};
use kin_core::{Dimension, in_small_letters};

use super::arguments::{Argument, Numbers, Texts, accepted, coerced, signature, valid_rows};
use super::assembly;
use super::names::{plain, unit};
use super::pose::{choice, dimensions, documented};
use super::settings;
use super::solver::{SearchedMechanism, Solver};
use super::used;

/// The number of poses of a revolution, unless it is given.
const POSES: f64 = 360.0;
/// The largest number of poses of a revolution.
const MOST_POSES: f64 = 1e6;

/// A function of the poses of a revolution, or of a part of it: its name and its arguments.
#[derive(Debug)]
pub(crate) struct Search {
    pub(crate) name: String,
    pub(crate) mechanism: SearchedMechanism,
    assemblies: Vec<String>,
    arguments: Vec<Argument>,
    /// The number of texts that come first.
    texts: usize,
    /// The number of arguments that cannot be left out.
    required: usize,
    pub(crate) signature: Signature,
    pub(crate) documentation: Documentation,
}

/// The arguments of a call.
pub(crate) struct Call<'s> {
    search: &'s Search,
    /// The texts that come first.
    pub(crate) texts: Vec<Texts>,
    numbers: Vec<Numbers>,
    assembly: Texts,
    /// The number of poses, the speed, and the range.
    options: Vec<Numbers>,
    /// The rows in which no argument is null.
    pub(crate) valid: Option<NullBuffer>,
    pub(crate) rows: usize,
    /// The fields that the query uses, `None` if it may use all.
    pub(crate) used: Option<Vec<String>>,
    pub(crate) vectors: Vectors,
}

/// A candidate of a call: the poses of a row.
pub(crate) struct Candidate<'s> {
    parameters: Vec<Column<'s>>,
    assembly: usize,
    /// The positions of the inputs that stand.
    standing: Vec<f64>,
    /// The speed of the input that moves.
    speed: f64,
    /// The poses.
    pub(crate) grid: InputGrid,
    /// Whether the poses are a full revolution, so that the first follows the last.
    pub(crate) is_whole: bool,
}

impl Search {
    /// Whether a mechanism has a revolution: its first input is an angle, and every block has a closed form.
    pub(crate) fn is_possible(solver: &dyn Solver) -> bool {
        let first = solver.description().inputs.first();
        first.is_some_and(|input| input.dimension == Dimension::Angle) && !solver.assembly_names().is_empty()
    }

    /// A function with this ending of its name. The texts come before the dimensions.
    pub(crate) fn new(mechanism: &SearchedMechanism, ending: &str, texts: Vec<Argument>, result: &str) -> Self {
        let description = mechanism.description();
        let name = format!("{}_{ending}", in_small_letters(description.name, '_'));
        let assemblies = mechanism.assembly_names();
        let text_count = texts.len();
        let mut arguments = texts;
        arguments.extend(dimensions(&**mechanism));
        for input in description.inputs.iter().skip(1) {
            let meaning = format!("{}, which stands ({})", input.description, unit(input.dimension, 0));
            arguments.push(Argument::number(plain(input), meaning));
        }
        let required = arguments.len();
        arguments.extend(choice(&**mechanism, &assemblies));
        let turning = description.inputs.first().map_or("", |input| input.name);
        arguments.extend([
            Argument::number("poses", "The number of poses; 360 if it is left out"),
            Argument::number("speed", format!("The speed of {turning}; 1 if it is left out (rad/s)")),
            Argument::number(
                "from",
                format!("The first value of {turning}, for a part of a revolution (rad)"),
            ),
            Argument::number(
                "to",
                format!("The last value of {turning}, for a part of a revolution (rad)"),
            ),
        ]);
        // A condition on a result would be moved below the call, and the call made twice, once for the condition. The
        // engine leaves it where it is if the function is volatile.
        let signature = signature(&arguments, Volatility::Volatile);
        let text = format!(
            "{result} The mechanism is {}: {}. Its input {turning} moves, by default by one revolution. Arguments: {}. \
             Numbers are null where they do not exist.",
            description.name,
            description.equations.join("; "),
            super::pose::meanings(&arguments),
        );
        let documentation = documented(&name, text, &arguments);
        Self {
            name,
            mechanism: mechanism.clone(),
            assemblies,
            arguments,
            texts: text_count,
            required,
            signature,
            documentation,
        }
    }

    /// The types to which the arguments of a call are converted.
    pub(crate) fn accepted(&self, types: &[DataType]) -> Vec<DataType> {
        accepted(self.coerced(types), types)
    }

    /// Refuses a call with wrong arguments.
    pub(crate) fn check(&self, types: &[DataType]) -> Result<()> {
        self.coerced(types).map(drop)
    }

    fn coerced(&self, types: &[DataType]) -> Result<Vec<DataType>> {
        let (types, used) = used::split_types(types);
        let mut types = coerced(&self.name, &self.arguments, self.required, types)?;
        self.indices(&types)?;
        types.extend(used.cloned());
        Ok(types)
    }

    /// The index of the assembly, and the indices of the options.
    fn indices(&self, types: &[DataType]) -> Result<(Option<usize>, Vec<usize>)> {
        let is_text = |index: &usize| types[*index] != DataType::Float64;
        let (texts, options): (Vec<usize>, Vec<usize>) = (self.required..types.len()).partition(is_text);
        if texts.len() > usize::from(self.assemblies.len() > 1) {
            let texts = if self.assemblies.len() > 1 {
                "one text, the assembly"
            } else {
                "no text: the mechanism has one assembly"
            };
            return plan_err!("{} takes {texts}", self.name);
        }
        match options.len() {
            0..=4 => Ok((texts.first().copied(), options)),
            many => plan_err!(
                "{} takes four numbers at most after the {} that it needs, poses, speed, from and to, and {many} are \
                 given",
                self.name,
                self.required
            ),
        }
    }

    /// Reads the arguments of a call.
    pub(crate) fn call(&self, args: &ScalarFunctionArgs) -> Result<Call<'_>> {
        let (given, used) = used::split(&args.args);
        let types: Vec<DataType> = given.iter().map(ColumnarValue::data_type).collect();
        let (assembly, options) = self.indices(&types)?;
        if options.len() == 3 {
            return exec_err!("{} takes `from` together with `to`", self.name);
        }
        let number = |index: usize| Numbers::new(&given[index]);
        Ok(Call {
            search: self,
            texts: given[..self.texts].iter().map(Texts::new).collect::<Result<_>>()?,
            numbers: (self.texts..self.required).map(number).collect::<Result<_>>()?,
            assembly: assembly.map_or(Ok(Texts::Same(None)), |index| Texts::new(&given[index]))?,
            options: options.into_iter().map(number).collect::<Result<_>>()?,
            valid: valid_rows(given, args.number_rows),
            rows: args.number_rows,
            used,
            vectors: settings::vectors(&args.config_options)?,
        })
    }
}

impl<'s> Call<'s> {
    /// The candidate of a row, `None` if an argument is null.
    pub(crate) fn candidate(&self, row: usize) -> Result<Option<Candidate<'s>>> {
        if self.valid.as_ref().is_some_and(|valid| valid.is_null(row)) {
            return Ok(None);
        }
        let name = &self.search.name;
        let option = |index: usize| self.options.get(index).map(|numbers| numbers.at(row));
        let poses = option(0).unwrap_or(POSES);
        if !(1.0..=MOST_POSES).contains(&poses) || poses.fract() != 0.0 {
            return exec_err!("{name} takes a whole number of poses from 1 to {MOST_POSES}, and not {poses}");
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "it is a whole number between 1 and a million"
        )]
        let poses = poses as usize;
        let (grid, is_whole) = match (option(2), option(3)) {
            (Some(from), Some(to)) => (InputGrid::between(0, from, to, poses), false),
            _ => (InputGrid::revolution(0, poses), true),
        };
        let parameters = self.search.mechanism.description().parameters.len();
        let assembly = match self.assembly.at(row) {
            Some(text) => assembly::index_of(&self.search.assemblies, text)?,
            None => 0,
        };
        let (dimensions, standing) = self.numbers.split_at(parameters);
        Ok(Some(Candidate {
            parameters: dimensions.iter().map(|numbers| Column::Same(numbers.at(row))).collect(),
            assembly,
            standing: standing.iter().map(|numbers| numbers.at(row)).collect(),
            speed: option(1).unwrap_or(1.0),
            grid,
            is_whole,
        }))
    }
}

impl Candidate<'_> {
    /// Calls `then` with the columns of the candidate. The moving input has these positions.
    pub(crate) fn given<R>(&self, positions: Column<'_>, then: impl FnOnce(GivenColumns<'_>) -> R) -> R {
        let turning = [positions, Column::Same(self.speed)];
        let given = |inputs: &[&[Column<'_>]]| {
            then(GivenColumns {
                parameters: &self.parameters,
                inputs,
                choice: ColumnChoice::Assembly(self.assembly),
            })
        };
        if self.standing.is_empty() {
            return given(&[&turning]);
        }
        let standing: Vec<Column<'_>> = self.standing.iter().map(|position| Column::Same(*position)).collect();
        let inputs: Vec<&[Column<'_>]> = [turning.as_slice()].into_iter().chain(standing.chunks(1)).collect();
        given(&inputs)
    }
}

/// The traits that make a function of SQL from a structure with a field `search`.
macro_rules! function_of_a_search {
    ($function:ident) => {
        impl PartialEq for $function {
            fn eq(&self, other: &Self) -> bool {
                self.search.name == other.search.name
                    && self.search.mechanism.declaration() == other.search.mechanism.declaration()
            }
        }

        impl Eq for $function {}

        impl super::solver::OfMechanism for $function {
            fn mechanism(&self) -> &super::solver::SearchedMechanism {
                &self.search.mechanism
            }
        }

        impl std::hash::Hash for $function {
            fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
                self.search.name.hash(state);
            }
        }

        impl datafusion::logical_expr::ScalarUDFImpl for $function {
            fn name(&self) -> &str {
                &self.search.name
            }

            fn signature(&self) -> &datafusion::logical_expr::Signature {
                &self.search.signature
            }

            fn coerce_types(&self, types: &[DataType]) -> Result<Vec<DataType>> {
                Ok(self.search.accepted(types))
            }

            fn return_type(&self, types: &[DataType]) -> Result<DataType> {
                self.search.check(types)?;
                Ok(DataType::Struct(self.fields.clone()))
            }

            fn invoke_with_args(
                &self,
                args: datafusion::logical_expr::ScalarFunctionArgs,
            ) -> Result<datafusion::logical_expr::ColumnarValue> {
                let array = self.evaluate(&self.search.call(&args)?)?;
                super::pose::constant_or_column(&args.args, std::sync::Arc::new(array))
            }

            fn documentation(&self) -> Option<&datafusion::logical_expr::Documentation> {
                Some(&self.search.documentation)
            }
        }
    };
}
pub(crate) use function_of_a_search;
