//! Wanted points as text, in which they go with a query to every process.

use std::fmt::Write as _;

use datafusion::common::{Result, plan_err};

/// Wanted points.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Points {
    /// Points that may be passed at any time.
    Free(Vec<[f64; 2]>),
    /// Points with the value of the input at which they are wanted, which comes first.
    Timed(Vec<[f64; 3]>),
}

impl Points {
    /// Reads points such as `0 1; 0.5 1.2`.
    pub(crate) fn parse(text: &str) -> Result<Self> {
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for part in text.split(';').map(str::trim).filter(|part| !part.is_empty()) {
            let numbers: std::result::Result<Vec<f64>, _> = part.split_whitespace().map(str::parse).collect();
            match numbers {
                Ok(numbers) if numbers.iter().all(|number| number.is_finite()) => rows.push(numbers),
                _ => {
                    return plan_err!(
                        "`{part}` is no point; write the name of a table with the columns x and y, or points as in \
                         '0 1; 0.5 1.2'"
                    );
                }
            }
        }
        let free: Option<Vec<[f64; 2]>> = rows.iter().map(|row| row.as_slice().try_into().ok()).collect();
        let timed: Option<Vec<[f64; 3]>> = rows.iter().map(|row| row.as_slice().try_into().ok()).collect();
        match (rows.is_empty(), free, timed) {
            (true, ..) => plan_err!("there are no wanted points"),
            (_, Some(free), _) => Ok(Self::Free(free)),
            (_, _, Some(timed)) => Ok(Self::Timed(timed)),
            _ => plan_err!("the wanted points have two numbers each, x and y, or three, input, x and y"),
        }
    }

    /// The number of points.
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Free(points) => points.len(),
            Self::Timed(points) => points.len(),
        }
    }
}

/// Points as text, every number with all its digits.
pub(crate) fn text_of(rows: &[Vec<f64>]) -> String {
    let mut text = String::new();
    for row in rows {
        for number in row {
            // Writing to a text does not fail.
            let _ = write!(text, "{number} ");
        }
        text.push(';');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{Points, text_of};

    #[test]
    fn points_come_back_from_their_text() {
        let rows = vec![vec![0.1, -1e-300], vec![1.0 / 3.0, 2e17]];
        let points = Points::parse(&text_of(&rows)).unwrap();
        assert_eq!(points, Points::Free(vec![[0.1, -1e-300], [1.0 / 3.0, 2e17]]));
        assert_eq!(
            Points::parse(" 0.5 1 2 ").unwrap(),
            Points::Timed(vec![[0.5, 1.0, 2.0]])
        );
    }

    #[test]
    fn mistakes_are_named() {
        for (text, wanted) in [
            ("", "no wanted points"),
            ("1 2; 3", "two numbers each"),
            ("line", "no point"),
            ("1 nan", "no point"),
        ] {
            let message = Points::parse(text).unwrap_err().to_string();
            assert!(message.contains(wanted), "{message}");
        }
    }
}
