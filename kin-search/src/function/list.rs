//! A list of functions that all processes of a search share.

use std::collections::BTreeMap;
#[cfg(feature = "cluster")]
use std::collections::VecDeque;
use std::fmt;
use std::sync::{Arc, LazyLock};
#[cfg(feature = "cluster")]
use std::sync::{Mutex, PoisonError};

use datafusion::common::Result;
#[cfg(feature = "cluster")]
use datafusion::common::exec_datafusion_err;
use datafusion::execution::FunctionRegistry;
use datafusion::logical_expr::ScalarUDF;
use datafusion::prelude::SessionContext;
use kin_core::Mechanism;
use kin_core::any::Of;
use kin_live::Mechanism as LiveMechanism;

use crate::candidates;
use crate::digest::digest;

use super::declaration::{DeclarationError, Owner, alike, declaration_of, is_of_sql};
use super::line::LineFunction;
use super::path::PathFunction;
use super::pose::PoseFunction;
use super::search::Search;
use super::solver::SearchedMechanism;
use super::turn::TurnFunction;

/// The declarations that a process keeps compiled for the next query.
#[cfg(feature = "cluster")]
const MOST_KEPT: usize = 64;

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
    ///
    /// The library is declared from its texts; with the feature `compiled`, rustc compiles it.
    #[must_use]
    pub fn library() -> Self {
        static LIBRARY: LazyLock<Functions> = LazyLock::new(|| {
            let candidates = candidates::functions()
                .into_iter()
                .fold(Functions::none(), Functions::with_function);
            let library = of_the_library().iter().fold(candidates, Functions::with_mechanism);
            #[cfg(feature = "refine")]
            let library = library.with::<kin_fit::TracedFourBar>();
            library
        });
        LIBRARY.clone()
    }

    /// This list with the functions of one more mechanism. Functions of the same name are replaced.
    #[must_use]
    pub fn with<M: Mechanism<Scalar = f64> + 'static>(self) -> Self {
        self.with_mechanism(&SearchedMechanism::of_program(*Of::<M>::FUNCTIONS))
    }

    /// This list with the functions of a mechanism that is declared by a text, as `kin_live::Mechanism::declare` takes
    /// it. No other process of a cluster needs it: the text goes with a query.
    ///
    /// # Errors
    /// [`DeclarationError`]: every mistake of the text, or a name that is taken.
    ///
    /// ```
    /// use kin_search::Functions;
    ///
    /// let wheel = "
    ///     struct Wheel { radius: Length }
    ///     input theta: Angle;
    ///     unknown height: Length;
    ///     height == radius * sin(theta);
    /// ";
    /// let functions = Functions::library().with_declaration(wheel)?;
    /// assert!(functions.list().iter().any(|line| line.starts_with("wheel(radius, theta")));
    /// assert_eq!(functions.fingerprint(), Functions::library().fingerprint());
    /// # Ok::<(), kin_search::DeclarationError>(())
    /// ```
    pub fn with_declaration(mut self, text: &str) -> std::result::Result<Self, DeclarationError> {
        let mechanism = SearchedMechanism::declared(LiveMechanism::declare(text)?, text);
        let own = Self::none().with_mechanism(&mechanism);
        let functions: Vec<&ScalarUDF> = own.iter().map(Arc::as_ref).collect();
        if let Some(error) = alike(&mechanism, &functions) {
            return Err(error);
        }
        let taken = own.all.keys().find_map(|name| Some((name, self.owner(name)?)));
        if let Some((function, owner)) = taken {
            return Err(DeclarationError::Taken {
                mechanism: mechanism.description().name.to_owned(),
                function: function.clone(),
                owner,
            });
        }
        self.all.extend(own.all);
        Ok(self)
    }

    /// Who has the function of this name, if anybody has.
    fn owner(&self, name: &str) -> Option<Owner> {
        match self.all.get(name) {
            Some(function) if declaration_of(function).is_some() => Some(Owner::Declaration),
            Some(_) => Some(Owner::Program),
            None => is_of_sql(name).then_some(Owner::Sql),
        }
    }

    /// The function of this name of the mechanism that a text declares.
    ///
    /// A text is compiled once, as long as it is among the last ones.
    #[cfg(feature = "cluster")]
    pub(crate) fn of_declaration(text: &str, name: &str) -> Result<Arc<ScalarUDF>> {
        static LAST: Mutex<VecDeque<(String, Functions)>> = Mutex::new(VecDeque::new());
        let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
        if !last.iter().any(|(own, _)| own == text) {
            let live = LiveMechanism::declare(text);
            let live = live.map_err(|error| exec_datafusion_err!("the declaration of `{name}`: {error}"))?;
            let own = Self::none().with_mechanism(&SearchedMechanism::declared(live, text));
            last.truncate(MOST_KEPT - 1);
            last.push_front((text.to_owned(), own));
        }
        let own = last.iter().find(|(own, _)| own == text);
        let function = own.and_then(|(_, functions)| functions.all.get(name));
        function
            .cloned()
            .ok_or_else(|| exec_datafusion_err!("the declaration that came with the query has no function `{name}`"))
    }

    /// This list with one more function of any kind.
    #[must_use]
    pub fn with_function(mut self, function: ScalarUDF) -> Self {
        self.all.insert(function.name().to_owned(), Arc::new(function));
        self
    }

    fn with_mechanism(self, mechanism: &SearchedMechanism) -> Self {
        let mut own = self.with_function(ScalarUDF::from(PoseFunction::new(mechanism)));
        if Search::is_possible(&**mechanism) {
            own = own.with_function(ScalarUDF::from(TurnFunction::new(mechanism)));
            if let Some(line) = LineFunction::new(mechanism) {
                own = own.with_function(ScalarUDF::from(line));
            }
            if let Some(path) = PathFunction::new(mechanism) {
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
        self.iter().map(line).collect()
    }

    /// The functions that a program has before it reads declarations.
    fn of_program(&self) -> impl Iterator<Item = &Arc<ScalarUDF>> {
        self.iter().filter(|function| declaration_of(function).is_none())
    }

    /// The [list](Self::list) without functions of declarations.
    pub(crate) fn list_of_program(&self) -> Vec<String> {
        self.of_program().map(line).collect()
    }

    /// The version of this package with sixteen hexadecimal digits that depend on every line of the [list](Self::list)
    /// and on the text about each function, which holds the equations, the units and the assemblies. Expressions of
    /// outputs are in neither: a program that changes one needs another version. Functions of
    /// [declarations](Self::with_declaration) do not count, because they go with a query.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let texts = self.of_program().filter_map(|function| function.documentation());
        let texts = texts.map(|documentation| documentation.description.clone());
        let lines: Vec<String> = self.list_of_program().into_iter().chain(texts).collect();
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

/// The mechanisms of the library.
#[cfg(feature = "compiled")]
fn of_the_library() -> Vec<SearchedMechanism> {
    macro_rules! compiled {
        ($($mechanism:ident)+) => {
            vec![$(SearchedMechanism::of_program(*Of::<kin_core::library::$mechanism>::FUNCTIONS)),+]
        };
    }
    kin_core::each_library_mechanism!(compiled)
}

/// The mechanisms of the library.
#[cfg(not(feature = "compiled"))]
fn of_the_library() -> Vec<SearchedMechanism> {
    let declare = |text| LiveMechanism::declare(text).expect("the library has no mistakes");
    kin_studio::library::declarations()
        .map(|(_, text)| SearchedMechanism::of_program(declare(text)))
        .collect()
}

/// The name of a function, and the names of its arguments.
fn line(function: &Arc<ScalarUDF>) -> String {
    let names = function.signature().parameter_names.clone().unwrap_or_default();
    format!("{}({})", function.name(), names.join(", "))
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
