//! Reasons why a condition or a statement needs no further test: a table of the author, with the columns `function`, `code`
//! and `reason`.
//!
//! A row holds for each missing pair or statement of the function, in the C, whose decision, condition or line is `code`.
//! Invariant: a row whose code is not in the C is reported, so that no reason outlives what it was written for. A row may
//! be of code that the search happens to cover.

use super::Report;
use crate::separated::{self, Rows};

/// Reason why a table cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// The table is no CSV, or a cell is empty.
    #[error("line {line}: {why}")]
    Row {
        /// The line.
        line: u64,
        /// The mistake.
        why: String,
    },
    /// A column is missing.
    #[error("the first line names no column `{name}`")]
    NoColumn {
        /// Name of the column.
        name: &'static str,
    },
}

/// A row of the table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Function in the C.
    pub function: String,
    /// Text of the decision, of the condition or of the line.
    pub code: String,
    /// The reason.
    pub reason: String,
}

/// Reads a table.
///
/// # Errors
/// See [`Error`].
pub fn read(text: &str) -> Result<Vec<Row>, Error> {
    let mut reader = separated::reader(text, Rows::Even);
    let wrong = |error: &csv::Error| Error::Row {
        line: error.position().map_or(1, csv::Position::line),
        why: error.to_string(),
    };
    let head = reader.headers().map_err(|error| wrong(&error))?.clone();
    let column = |name| head.iter().position(|it| it == name).ok_or(Error::NoColumn { name });
    let (function, code, reason) = (column("function")?, column("code")?, column("reason")?);
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| wrong(&error))?;
        let line = separated::line(text, &record);
        let cell = |at: usize| match record.get(at).unwrap_or_default() {
            "" => Err(Error::Row { line, why: format!("`{}` is empty", &head[at]) }),
            text => Ok(text.to_owned()),
        };
        rows.push(Row { function: cell(function)?, code: cell(code)?, reason: cell(reason)? });
    }
    Ok(rows)
}

/// Adds the reasons to the missing pairs and statements. Returns the rows whose code is not in the C.
pub fn add<'r>(report: &mut Report, rows: &'r [Row]) -> Vec<&'r Row> {
    let mut unused = Vec::new();
    for row in rows {
        let missing = report.statements.iter_mut().chain(&mut report.conditions);
        let own = missing.filter(|it| {
            it.function == row.function && (it.text == row.code || it.condition == row.code)
        });
        own.for_each(|it| it.reason.clone_from(&row.reason));
        if !report.codes.contains(&(row.function.clone(), row.code.clone())) {
            unused.push(row);
        }
    }
    unused
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coverage::Missing;

    #[test]
    fn a_reason_holds_for_a_decision_or_a_condition_of_its_function() {
        let rows = read(
            "function, code, reason\nf,a && b,never\nf,c,\"not, ever\"\ng,c,no\ng,d,covered\n",
        );
        let rows = rows.expect("a table");
        let missing = |function: &str, text: &str, condition: &str| Missing {
            function: function.to_owned(),
            text: text.to_owned(),
            condition: condition.to_owned(),
            ..Missing::default()
        };
        let mut report = Report {
            conditions: vec![missing("f", "a && b", "a"), missing("f", "c || d", "c")],
            statements: vec![missing("h", "c", "")],
            codes: [("f", "a && b"), ("f", "c"), ("g", "d")]
                .map(|(function, code)| (function.to_owned(), code.to_owned()))
                .into(),
            ..Report::default()
        };
        let unused = add(&mut report, &rows);
        assert_eq!(unused, [&rows[2]]);
        let reasons: Vec<&str> = report.conditions.iter().map(|it| it.reason.as_str()).collect();
        assert_eq!(reasons, ["never", "not, ever"]);
        assert_eq!(report.statements[0].reason, "");
    }

    #[test]
    fn tables_of_spreadsheets_are_read() {
        let rows = read("\u{feff}reason;code;function\nnever, ever;a && b;f\n");
        let wanted = Row {
            function: "f".to_owned(),
            code: "a && b".to_owned(),
            reason: "never, ever".to_owned(),
        };
        assert_eq!(rows, Ok(vec![wanted.clone()]));
        assert_eq!(read("function\tcode\treason\nf\ta && b\tnever, ever\n"), Ok(vec![wanted]));
    }

    #[test]
    fn a_table_without_its_columns_or_with_an_empty_cell_is_refused() {
        assert_eq!(read("function,code\n"), Err(Error::NoColumn { name: "reason" }));
        let error = read("function,code,reason\nf,a,\n").expect_err("an empty cell");
        assert_eq!(error.to_string(), "line 2: `reason` is empty");
        assert!(matches!(read("function,code,reason\nf\n"), Err(Error::Row { line: 2, .. })));
    }
}
