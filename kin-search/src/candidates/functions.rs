//! Candidates as functions of SQL.

use std::hash::{Hash, Hasher};
use std::sync::Arc;

use datafusion::arrow::array::{ArrayRef, AsArray, Float64Array};
use datafusion::arrow::datatypes::{DataType, Float64Type, Int64Type};
use datafusion::common::{Result, ScalarValue, exec_err, plan_err};
use datafusion::logical_expr::{
    ColumnarValue, DocSection, Documentation, ScalarFunctionArgs, ScalarUDF, ScalarUDFImpl, Signature, TypeSignature,
    Volatility,
};

use crate::function::arguments::accepted;

use super::sequence::{MOST_DIMENSIONS, Sequence, at};

/// `candidate` and `candidate_log`.
pub(crate) fn functions() -> [ScalarUDF; 2] {
    [Scale::Linear, Scale::Logarithmic].map(|scale| ScalarUDF::from(CandidateFunction::new(scale)))
}

/// The distribution over a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Scale {
    /// Evenly.
    Linear,
    /// Evenly in the logarithm.
    Logarithmic,
}

impl Scale {
    fn name(self) -> &'static str {
        match self {
            Self::Linear => "candidate",
            Self::Logarithmic => "candidate_log",
        }
    }

    fn between(self, low: f64, high: f64, part: f64) -> f64 {
        match self {
            Self::Linear => low + part * (high - low),
            Self::Logarithmic => low * (part * (high / low).ln()).exp(),
        }
    }
}

/// The function `candidate(id, dimension, dimensions, low, high)`.
#[derive(Debug)]
struct CandidateFunction {
    scale: Scale,
    signature: Signature,
    documentation: Documentation,
}

const NAMES: [&str; 5] = ["id", "dimension", "dimensions", "low", "high"];

const TYPES: [DataType; 5] = [
    DataType::Int64,
    DataType::Int64,
    DataType::Int64,
    DataType::Float64,
    DataType::Float64,
];

impl CandidateFunction {
    fn new(scale: Scale) -> Self {
        let types = TYPES.to_vec();
        let mut signature = Signature::one_of(
            vec![
                TypeSignature::UserDefined,
                TypeSignature::Exact(types),
                TypeSignature::Nullary,
            ],
            Volatility::Immutable,
        );
        signature.parameter_names = Some(NAMES.map(String::from).to_vec());
        let even = match scale {
            Scale::Linear => "evenly",
            Scale::Logarithmic => "evenly in the logarithm; both limits are positive",
        };
        let section = DocSection {
            include: true,
            label: "Candidates",
            description: Some("Dimensions from an id"),
        };
        let meanings = [
            "The number of the candidate".to_owned(),
            "Which dimension of the candidate, from 1".to_owned(),
            format!("How many dimensions a candidate has, at most {MOST_DIMENSIONS}"),
            "The lower limit".to_owned(),
            "The upper limit".to_owned(),
        ];
        let text = format!(
            "One dimension of the candidate with this id: a number between low and high, by the low-discrepancy \
             sequence R_d of M. Roberts. The candidates with ids from 0 on fill the box of all dimensions {even}. Each \
             dimension of a candidate is one call with the same number of dimensions."
        );
        let name = scale.name();
        let builder = Documentation::builder(section, text, format!("{name}({})", NAMES.join(", ")));
        let builder = NAMES.iter().zip(meanings).fold(builder, |builder, (name, meaning)| {
            builder.with_argument(*name, meaning)
        });
        Self {
            scale,
            signature,
            documentation: builder.build(),
        }
    }

    fn of(&self, args: &ScalarFunctionArgs) -> Result<ArrayRef> {
        let [id, dimension, dimensions, low, high] = args.args.as_slice() else {
            return exec_err!("{} takes five arguments", self.name());
        };
        let (ColumnarValue::Scalar(dimension), ColumnarValue::Scalar(dimensions)) = (dimension, dimensions) else {
            return exec_err!(
                "the dimension of {} and the number of dimensions are constants, not columns",
                self.name()
            );
        };
        let (ScalarValue::Int64(Some(dimension)), ScalarValue::Int64(Some(dimensions))) = (dimension, dimensions)
        else {
            return Ok(Arc::new(Float64Array::new_null(args.number_rows)));
        };
        let sequence = usize::try_from(*dimensions).ok().and_then(Sequence::new);
        let coordinate = dimension.checked_sub(1).and_then(|index| usize::try_from(index).ok());
        let (Some(sequence), Some(coordinate)) = (sequence, coordinate.filter(|_| dimension <= dimensions)) else {
            return exec_err!(
                "{} has no dimension {dimension} of {dimensions}: dimensions count from 1, and there are at most \
                 {MOST_DIMENSIONS}",
                self.name()
            );
        };
        let step = sequence.step(coordinate);
        let ids = id.to_array(args.number_rows)?;
        let ids = ids.as_primitive::<Int64Type>();
        // A negative id counts on from the largest one.
        let parts: Float64Array = ids.unary(|id| at(id.cast_unsigned(), step));
        let scale = self.scale;
        if let (
            ColumnarValue::Scalar(ScalarValue::Float64(Some(low))),
            ColumnarValue::Scalar(ScalarValue::Float64(Some(high))),
        ) = (low, high)
        {
            self.check(*low, *high)?;
            let all: Float64Array = parts.unary(|part| scale.between(*low, *high, part));
            return Ok(Arc::new(all));
        }
        let (low, high) = (low.to_array(args.number_rows)?, high.to_array(args.number_rows)?);
        let (low, high) = (low.as_primitive::<Float64Type>(), high.as_primitive::<Float64Type>());
        let one = |((part, low), high): ((Option<f64>, Option<f64>), Option<f64>)| match (part, low, high) {
            (Some(part), Some(low), Some(high)) => {
                self.check(low, high)?;
                Ok(Some(self.scale.between(low, high, part)))
            }
            _ => Ok(None),
        };
        let all: Result<Float64Array> = parts.iter().zip(low).zip(high).map(one).collect();
        Ok(Arc::new(all?))
    }

    /// The types to which the arguments of a call are converted, if there is such a call.
    fn coerced(&self, types: &[DataType]) -> Result<Vec<DataType>> {
        if types.len() != NAMES.len() {
            return plan_err!(
                "{} takes {} arguments, and {} are given: {}({})",
                self.name(),
                NAMES.len(),
                types.len(),
                self.name(),
                NAMES.join(", ")
            );
        }
        for (index, (given, wanted)) in types.iter().zip(&TYPES).enumerate() {
            let (fits, kind) = if wanted.is_integer() {
                (given.is_integer(), "whole number")
            } else {
                (given.is_numeric(), "number")
            };
            if !fits && !given.is_null() {
                return plan_err!(
                    "argument {} of {}, {}, is no {kind} but {given}",
                    index + 1,
                    self.name(),
                    NAMES[index]
                );
            }
        }
        Ok(TYPES.to_vec())
    }

    fn check(&self, low: f64, high: f64) -> Result<()> {
        let (is_good, wanted) = match self.scale {
            Scale::Linear => ((high - low).is_finite(), "finite, and so is their difference"),
            Scale::Logarithmic => (
                low > 0.0 && high > 0.0 && high / low > 0.0 && (high / low).is_finite(),
                "finite and positive, and so is their ratio",
            ),
        };
        if low.is_finite() && high.is_finite() && is_good {
            return Ok(());
        }
        exec_err!(
            "the limits of {} are {low} and {high}; they must be {wanted}",
            self.name()
        )
    }
}

impl PartialEq for CandidateFunction {
    fn eq(&self, other: &Self) -> bool {
        self.scale == other.scale
    }
}

impl Eq for CandidateFunction {}

impl Hash for CandidateFunction {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.scale.hash(state);
    }
}

impl ScalarUDFImpl for CandidateFunction {
    fn name(&self) -> &'static str {
        self.scale.name()
    }

    fn signature(&self) -> &Signature {
        &self.signature
    }

    fn coerce_types(&self, types: &[DataType]) -> Result<Vec<DataType>> {
        Ok(accepted(self.coerced(types), types))
    }

    fn return_type(&self, types: &[DataType]) -> Result<DataType> {
        self.coerced(types)?;
        Ok(DataType::Float64)
    }

    fn invoke_with_args(&self, args: ScalarFunctionArgs) -> Result<ColumnarValue> {
        let array = self.of(&args)?;
        if array.len() == 1
            && args
                .args
                .iter()
                .all(|argument| matches!(argument, ColumnarValue::Scalar(_)))
        {
            return Ok(ColumnarValue::Scalar(ScalarValue::try_from_array(&array, 0)?));
        }
        Ok(ColumnarValue::Array(array))
    }

    fn documentation(&self) -> Option<&Documentation> {
        Some(&self.documentation)
    }
}
