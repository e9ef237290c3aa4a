//! The result of one run, and its line in a file.
//!
//! Invariant: a line has no line break, and as many cells as the file has columns: the seed, the values, and the reason of a
//! run without values.

use crate::campaign::{Campaign, Column, Type, Value};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Result of one run.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Seed of the run.
    pub seed: u64,
    /// A value for each column, or the reason why there is none.
    pub result: Result<Vec<Value>, String>,
}

/// Name of the last column.
pub(crate) const FAILED: &str = "failed";

impl Row {
    /// Runs a seed. A panic and a number that is not finite become the row's reason.
    pub fn of(campaign: &dyn Campaign, seed: u64) -> Self {
        let columns = campaign.columns();
        let run = catch_unwind(AssertUnwindSafe(|| campaign.run(seed)));
        let result = run.unwrap_or_else(|cause| {
            let text = cause.downcast_ref::<&str>().map(|text| (*text).to_owned());
            let text = text.or_else(|| cause.downcast_ref::<String>().cloned());
            Err(format!("panic: {}", text.unwrap_or_else(|| "no text".to_owned())))
        });
        Self::checked(seed, &columns, result)
    }

    /// Runs several seeds at once. A panic concerns one of them, so each is run alone after it.
    pub fn all_of(campaign: &dyn Campaign, seeds: &[u64]) -> Vec<Self> {
        let columns = campaign.columns();
        let run = || catch_unwind(AssertUnwindSafe(|| campaign.run_together(seeds)));
        match (seeds.len() > 1).then(run) {
            Some(Ok(results)) if results.len() == seeds.len() => {
                let rows = seeds.iter().zip(results);
                rows.map(|(seed, result)| Self::checked(*seed, &columns, result)).collect()
            }
            _ => seeds.iter().map(|seed| Self::of(campaign, *seed)).collect(),
        }
    }

    /// Creates the row of a run.
    fn checked(seed: u64, columns: &[Column], result: Result<Vec<Value>, String>) -> Self {
        let result = result.and_then(|values| check(columns, values));
        let result = result.map_err(|reason| match clean(&reason) {
            empty if empty.is_empty() => "no reason".to_owned(),
            reason => reason,
        });
        Self { seed, result }
    }

    /// Returns the line of the row, without its end.
    pub fn line(&self, columns: &[Column]) -> String {
        let mut line = self.seed.to_string();
        for (index, column) in columns.iter().enumerate() {
            line.push(',');
            if let Ok(values) = &self.result {
                line += &cell(column, &values[index]);
            }
        }
        line.push(',');
        if let Err(reason) = &self.result {
            line += reason;
        }
        line
    }

    /// Parses a line.
    ///
    /// # Errors
    ///
    /// The fault of the line.
    pub fn of_line(line: &str, columns: &[Column]) -> Result<Self, String> {
        let cells: Vec<&str> = line.split(',').collect();
        let wanted = columns.len() + 2;
        let [seed, values @ .., failed] = &cells[..] else {
            return Err(format!("1 cell instead of {wanted}"));
        };
        if cells.len() != wanted {
            return Err(format!("{} cells instead of {wanted}", cells.len()));
        }
        let seed = seed.parse().map_err(|_| format!("`{seed}` is not a seed"))?;
        if !failed.is_empty() {
            return Ok(Self { seed, result: Err((*failed).to_owned()) });
        }
        let parse = |(column, cell): (&Column, &&str)| match column.values {
            Type::Text => Some(Value::Text((*cell).to_owned())),
            Type::Number => cell.parse().ok().map(Value::Number),
            Type::Truth => cell.parse().ok().map(Value::Truth),
        };
        let mut all = Vec::with_capacity(columns.len());
        for (column, cell) in columns.iter().zip(values) {
            let value = parse((column, cell));
            all.push(value.ok_or_else(|| format!("`{cell}` is no value of `{}`", column.name))?);
        }
        Ok(Self { seed, result: Ok(all) })
    }
}

/// Checks the values of a run, and makes them those that its line will have.
fn check(columns: &[Column], values: Vec<Value>) -> Result<Vec<Value>, String> {
    if values.len() != columns.len() {
        return Err(format!("{} values for {} columns", values.len(), columns.len()));
    }
    let each = columns.iter().zip(values).map(|(column, value)| match (column.values, value) {
        (Type::Number, Value::Number(number)) => {
            if number.is_nan() || number.is_infinite() && !column.may_be_infinite {
                return Err(format!("not finite: `{}` is {number}", column.name));
            }
            let rounded = cell(column, &Value::Number(number));
            Ok(Value::Number(rounded.parse().unwrap_or(number)))
        }
        (Type::Text, Value::Text(text)) => Ok(Value::Text(clean(&text))),
        (Type::Truth, value @ Value::Truth(_)) => Ok(value),
        (_, value) => Err(format!("`{}` cannot have the value {value:?}", column.name)),
    });
    each.collect()
}

fn cell(column: &Column, value: &Value) -> String {
    match value {
        Value::Number(number) => match column.decimals {
            Some(decimals) => format!("{number:.decimals$}"),
            None => format!("{number}"),
        },
        Value::Text(text) => clean(text),
        Value::Truth(truth) => truth.to_string(),
    }
}

/// Replaces the characters that a cell cannot have. `#` begins a comment where others read the file.
fn clean(text: &str) -> String {
    let of = |it: char| match it {
        ',' => ';',
        '"' => '\'',
        '#' => '№',
        it if it.is_control() => ' ',
        it => it,
    };
    text.trim().chars().map(of).collect()
}
