//! A list of functions that all processes of a search share.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use datafusion::common::Result;
use datafusion::execution::FunctionRegistry;
use datafusion::logical_expr::ScalarUDF;
use datafusion::prelude::SessionContext;
use kin_core::Mechanism;
use kin_core::any::Of;

use crate::candidates;
use crate::digest::digest;

use super::line::LineFunction;
use super::path::PathFunction;
use super::pose::PoseFunction;
use super::search::Search;
use super::solver::Solver;
use super::turn::TurnFunction;

/// A list of functions of SQL, by their names.
///
/// Processes that search together must have the same list: see [`fingerprint`](Self::fingerprint).
///
/// ```
/// use kin_core::prelude::*;
/// use kin_search::Functions;
///
/// mechanism! {
///     /// A point on a wheel.
///     pub struct Wheel { pub radius: Length }
///     input theta: Angle;
///     unknown height: Length;
///     height == radius * sin(theta);
/// }
///
/// let functions = Functions::library().with::<Wheel>();
/// assert!(functions.list().iter().any(|line| line.starts_with("wheel(radius, theta")));
/// assert_ne!(functions.fingerprint(), Functions::library().fingerprint());
/// ```
#[derive(Clone, Default)]
pub struct Functions {
    all: BTreeMap<String, Arc<ScalarUDF>>,
}

impl Functions {
    /// A list without functions.
    #[must_use]
    pub fn none() -> Self {
        Self::default()
    }

    /// The functions of all mechanisms of kin's library, and those that make [candidates](crate::candidates), and
    /// with the feature `refine` those of a four-bar linkage with a tracer on its coupler.
    #[must_use]
    pub fn library() -> Self {
        macro_rules! of_the_library {
            ($($mechanism:ident)+) => {
                [$(Of::<kin_core::library::$mechanism>::FUNCTIONS as &'static dyn Solver),+]
            };
        }
        let solvers = kin_core::each_library_mechanism!(of_the_library);
        let candidates = candidates::functions()
            .into_iter()
            .fold(Self::none(), Self::with_function);
        let library = solvers.into_iter().fold(candidates, Self::with_solver);
        #[cfg(feature = "refine")]
        let library = library.with::<kin_fit::TracedFourBar>();
        library
    }

    /// This list with the functions of one more mechanism. Functions of the same name are replaced.
    #[must_use]
    pub fn with<M: Mechanism<Scalar = f64> + 'static>(self) -> Self {
        self.with_solver(Of::<M>::FUNCTIONS)
    }

    /// This list with one more function of any kind.
    #[must_use]
    pub fn with_function(mut self, function: ScalarUDF) -> Self {
        self.all.insert(function.name().to_owned(), Arc::new(function));
        self
    }

    fn with_solver(self, solver: &'static dyn Solver) -> Self {
        let mut own = self.with_function(ScalarUDF::from(PoseFunction::new(solver)));
        if Search::is_possible(solver) {
            own = own.with_function(ScalarUDF::from(TurnFunction::new(solver)));
            if let Some(line) = LineFunction::new(solver) {
                own = own.with_function(ScalarUDF::from(line));
            }
            if let Some(path) = PathFunction::new(solver) {
                own = own.with_function(ScalarUDF::from(path));
            }
        }
        own
    }

    /// The functions in the order of their names.
    pub fn iter(&self) -> impl Iterator<Item = &Arc<ScalarUDF>> {
        self.all.values()
    }

    /// A line for each function in the order of their names: the name, and the names of its arguments.
    #[must_use]
    pub fn list(&self) -> Vec<String> {
        let line = |function: &Arc<ScalarUDF>| {
            let names = function.signature().parameter_names.clone().unwrap_or_default();
            format!("{}({})", function.name(), names.join(", "))
        };
        self.iter().map(line).collect()
    }

    /// The version of this package with sixteen hexadecimal digits that depend on every line of the [list](Self::list)
    /// and on the text about each function, which holds the equations, the units and the assemblies. Expressions of
    /// outputs are in neither: a program that changes one needs another version.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let texts = self.iter().filter_map(|function| function.documentation());
        let texts = texts.map(|documentation| documentation.description.clone());
        let lines: Vec<String> = self.list().into_iter().chain(texts).collect();
        let hash = digest(lines.iter().flat_map(|line| line.bytes().chain([b'\n'])));
        format!("{}-{hash:016x}", env!("CARGO_PKG_VERSION"))
    }

    /// Makes the functions known to a session, or to another place where functions are looked up.
    ///
    /// # Errors
    /// Returns an error if the registry takes no functions.
    pub fn register(&self, registry: &mut dyn FunctionRegistry) -> Result<()> {
        for function in self.iter() {
            registry.register_udf(Arc::clone(function))?;
        }
        Ok(())
    }
}

impl fmt::Debug for Functions {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.list()).finish()
    }
}

/// The functions of kin's library.
#[must_use]
pub fn functions() -> Vec<ScalarUDF> {
    Functions::library()
        .iter()
        .map(|function| function.as_ref().clone())
        .collect()
}

/// Makes the functions of one more mechanism known to a session.
pub fn register<M: Mechanism<Scalar = f64> + 'static>(session: &SessionContext) {
    for function in Functions::none().with::<M>().iter() {
        session.register_udf(function.as_ref().clone());
    }
}
