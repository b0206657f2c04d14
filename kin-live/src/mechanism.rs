//! A mechanism from text.

use std::error::Error;
use std::fmt;
use std::sync::OnceLock;

use kin_compiler::lowered::{self, ClosureTerm};
use kin_compiler::{Declaration, Mistake, Refusal, Resource, TooLarge};
use kin_core::any::{Described, Name};
use kin_core::linkage::AnyLinkage;

use crate::budget::Budget;
use crate::code::{self, Labels, Register};
use crate::every::Every;
use crate::forms::Forms;
use crate::formulas::OwnedFormulas;
use crate::motion::Motion;
use crate::names::{Names, OwnedDescription};
use crate::routine::Routine;
use crate::sheet::SheetCode;

/// The choices between two solutions that the index of an assembly holds.
const MOST_CHOICES: usize = 16;

/// The values that the machine counts.
const MOST_VALUES: usize = Register::MAX as usize + 1;

/// A mechanism that was declared while the program runs.
#[derive(Debug)]
pub struct Mechanism {
    declaration: Declaration,
    pub(crate) names: OwnedDescription,
    pub(crate) motion: Motion,
    pub(crate) transmission: Routine,
    /// The names of the dyads.
    pub(crate) dyads: Vec<Name>,
    pub(crate) forms: Forms,
    pub(crate) closure_terms: Option<ClosureTerms>,
    pub(crate) every: Option<Every>,
    /// The translated methods.
    pub(crate) closure: SheetCode,
    pub(crate) outputs: SheetCode,
    pub(crate) skeleton_points: SheetCode,
    pub(crate) choices: Vec<String>,
    /// Formulas, once they are asked for.
    formulas: OnceLock<OwnedFormulas>,
    /// The paths that a search for all positions may follow.
    pub(crate) most_paths: usize,
}

/// The closure as polynomials.
#[derive(Debug)]
pub(crate) struct ClosureTerms {
    pub(crate) terms: Vec<ClosureTerm>,
    pub(crate) coefficients: Routine,
}

impl Mechanism {
    /// Compiles a declaration: the text between the braces of `mechanism! { … }`. It costs at most what the usual
    /// [`Budget`] allows.
    ///
    /// # Errors
    /// Every mistake of the declaration, in the order of the text; or the limit that the declaration exceeds.
    pub fn declare(text: &str) -> Result<Self, DeclareError> {
        Self::declare_within(text, &Budget::default())
    }

    /// Compiles a declaration, as far as a budget allows it.
    ///
    /// ```
    /// use kin_live::{Budget, CompilerBudget, DeclareError, Mechanism, Resource};
    ///
    /// let budget = Budget { compiler: CompilerBudget { text: 4096, work: 200_000 }, paths: 64 };
    /// let long = "a".repeat(5000);
    /// let Err(DeclareError::TooLarge(excess)) = Mechanism::declare_within(&long, &budget) else {
    ///     panic!("it has 5000 bytes");
    /// };
    /// assert_eq!((excess.resource, excess.limit), (Resource::Text, 4096));
    /// ```
    ///
    /// # Errors
    /// Every mistake of the declaration, in the order of the text; or the limit that the declaration exceeds.
    pub fn declare_within(text: &str, budget: &Budget) -> Result<Self, DeclareError> {
        Self::of_within(Declaration::parse_within(text, &budget.compiler)?, budget)
    }

    /// The mechanism of a compiled declaration.
    ///
    /// # Errors
    /// [`DeclareError::TooLarge`].
    pub fn of(declaration: Declaration) -> Result<Self, DeclareError> {
        Self::of_within(declaration, &Budget::default())
    }

    fn of_within(declaration: Declaration, budget: &Budget) -> Result<Self, DeclareError> {
        let too_large = |resource, limit| DeclareError::TooLarge(TooLarge::new(resource, limit));
        let program = declaration.program();
        if !program.is_coupled && program.choices.len() > MOST_CHOICES {
            return Err(too_large(Resource::Assemblies, 1 << MOST_CHOICES));
        }
        Self::new(declaration, budget.paths).map_err(|code::TooLarge| too_large(Resource::Values, MOST_VALUES))
    }

    fn new(declaration: Declaration, most_paths: usize) -> Result<Self, code::TooLarge> {
        let program = declaration.program();
        let description = &program.description;
        let mut labels = Labels::new(description, &program.outputs);
        let motion = Motion::new(program, &mut labels)?;
        let lowered::Routine { statements, results } = &program.transmission;
        let transmission = Routine::new(statements, results, &mut labels)?;
        let forms = Forms::new(&program.forms, &program.lengths, &mut labels)?;
        let closure_terms = match &program.closure {
            None => None,
            Some(closure) => Some(ClosureTerms {
                terms: closure.terms.clone(),
                coefficients: Routine::of_components(&closure.statements, &closure.coefficients, &mut labels)?,
            }),
        };
        let every = program.every.as_ref();
        let every = every.map(|every| Every::new(every, program.directions.len(), &mut labels));
        let every = every.transpose()?;
        let counts = [
            description.parameters.len(),
            description.inputs.len(),
            description.unknowns.len(),
        ];
        let [closure, outputs, skeleton_points] = {
            let sheets = declaration.sheets();
            [&sheets.closure, &sheets.outputs, &sheets.skeleton_points].map(|sheet| {
                let [parameters, inputs, unknowns] = counts;
                SheetCode::new(sheet, parameters, inputs, unknowns)
                    .unwrap_or_else(|| unreachable!("a compiled declaration names only its quantities"))
            })
        };
        let dyads = program.dyads.iter().map(|unknowns| labels.unknowns(unknowns)).collect();
        let names = Names {
            groups: labels.groups,
            outline: declaration.sheets().outline.clone(),
            description: description.clone(),
        };
        Ok(Self {
            names: OwnedDescription::of(names),
            motion,
            transmission,
            dyads,
            forms,
            closure_terms,
            choices: program.choices.clone(),
            every,
            closure,
            outputs,
            skeleton_points,
            formulas: OnceLock::new(),
            declaration,
            most_paths,
        })
    }

    /// The declaration.
    #[must_use]
    pub fn declaration(&self) -> &Declaration {
        &self.declaration
    }

    /// The equations and their solution.
    pub(crate) fn formulas(&self) -> &OwnedFormulas {
        self.formulas
            .get_or_init(|| OwnedFormulas::of(self.declaration.formulas()))
    }

    /// The name of an assembly, as `kin_core::Mechanism::assembly_name` gives it.
    pub(crate) fn name_of_assembly(&self, index: usize) -> String {
        let word = |choice: usize| {
            let is_crossed = (index >> (self.choices.len() - 1 - choice)) & 1 == 1;
            if is_crossed { "crossed" } else { "open" }
        };
        match self.choices.as_slice() {
            [] => String::new(),
            [_] => word(0).to_owned(),
            names => {
                let parts = names.iter().enumerate();
                let parts = parts.map(|(choice, name)| format!("{}={}", name.to_lowercase(), word(choice)));
                parts.collect::<Vec<_>>().join(",")
            }
        }
    }

    /// The mechanism with dimensions, which are given by name.
    ///
    /// # Errors
    /// A dimension that is missing, unknown, or given twice.
    // Inlined, because every caller compiles all answers: a program that reaches them by `AnyLinkage` compiles them
    // once.
    #[inline]
    pub fn linkage(&self, dimensions: &[(&str, f64)]) -> Result<AnyLinkage<'_>, DimensionError> {
        let parameters = self.description().parameters;
        let mut row = vec![None; parameters.len()];
        for (name, value) in dimensions {
            let index = parameters.iter().position(|parameter| parameter.name == *name);
            let index = index.ok_or_else(|| DimensionError::Unknown((*name).to_owned()))?;
            if row[index].replace(*value).is_some() {
                return Err(DimensionError::Twice((*name).to_owned()));
            }
        }
        let all = row.iter().zip(parameters);
        let all: Result<Vec<f64>, DimensionError> = all
            .map(|(value, parameter)| value.ok_or_else(|| DimensionError::Missing(parameter.name.to_owned())))
            .collect();
        Ok(AnyLinkage::new(self, &all?))
    }
}

/// The reason why a text declares no mechanism.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum DeclareError {
    /// The mistakes, in the order of the text.
    Mistakes(Vec<Mistake>),
    /// The declaration exceeds a limit of the budget or of the machine.
    TooLarge(TooLarge),
}

impl From<Refusal> for DeclareError {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Mistakes(mistakes) => Self::Mistakes(mistakes),
            Refusal::TooLarge(excess) => Self::TooLarge(excess),
        }
    }
}

impl fmt::Display for DeclareError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mistakes(mistakes) => {
                for (index, mistake) in mistakes.iter().enumerate() {
                    let separator = if index == 0 { "" } else { "\n" };
                    write!(formatter, "{separator}{mistake}")?;
                }
                Ok(())
            }
            Self::TooLarge(excess) => excess.fmt(formatter),
        }
    }
}

impl Error for DeclareError {}

/// The reason why dimensions do not fit a mechanism.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DimensionError {
    /// A parameter without a value.
    Missing(String),
    /// A value without a parameter.
    Unknown(String),
    /// Two values for a parameter.
    Twice(String),
}

impl fmt::Display for DimensionError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing(name) => write!(formatter, "the dimension `{name}` is missing"),
            Self::Unknown(name) => write!(formatter, "no dimension is called `{name}`"),
            Self::Twice(name) => write!(formatter, "the dimension `{name}` is given twice"),
        }
    }
}

impl Error for DimensionError {}
