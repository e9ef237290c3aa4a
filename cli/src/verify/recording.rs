//! Recorded inputs of an entry point: a table (CSV) with a column for each number that goes in, a row for each call.
//!
//! Columns are called as the parameters and their parts are in the Rust: `target`, `gains.p`, `position[2]`. Elements of a
//! matrix count by columns. Columns of other names are let be, so that a log can be taken as it is; text in quotation
//! marks is not known. The component begins in its initial state, and lives from row to row.

use bessemer_ir::{Float, Form, Function, Int, Module, Scalar, Type};

/// What is wrong with a recording, and where: the line counts from 1.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Wrong {
    /// A number has no column.
    #[error("it has no column `{column}`; wanted are {wanted}")]
    Column {
        /// Which is missing.
        column: String,
        /// All that are wanted.
        wanted: String,
    },
    /// A row has another length than the head.
    #[error("line {line} has {found} columns, and the first {wanted}")]
    Row {
        /// Which.
        line: usize,
        /// How many it has.
        found: usize,
        /// How many it should have.
        wanted: usize,
    },
    /// A cell is no value of its type.
    #[error("line {line}: `{text}` is no {kind}, as `{column}` has to be")]
    Cell {
        /// Where it is.
        line: usize,
        /// In which column.
        column: String,
        /// What it says.
        text: String,
        /// What it should be.
        kind: String,
    },
    /// There is no row.
    #[error("it has no rows")]
    Empty,
}

/// The words of the arguments of each call, without those of the component.
///
/// # Errors
/// What is wrong, and where.
pub fn calls(
    module: &Module,
    function: &Function,
    text: &str,
) -> Result<Vec<Vec<Vec<u64>>>, Wrong> {
    let parameters = function.parameters();
    let parameters = &parameters[1.min(parameters.len())..];
    let columns: Vec<Vec<Column>> = parameters
        .iter()
        .map(|parameter| {
            let mut columns = Vec::new();
            columns_of(module, &parameter.ty, &parameter.name, &mut columns);
            columns
        })
        .collect();
    let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    let (_, head) = lines.next().ok_or(Wrong::Empty)?;
    let head: Vec<&str> = cells(head);
    let place = |name: &str| {
        let wanted = || columns.iter().flatten().map(|column| format!("`{}`", column.name));
        head.iter().position(|it| *it == name).ok_or_else(|| Wrong::Column {
            column: name.to_owned(),
            wanted: wanted().collect::<Vec<_>>().join(", "),
        })
    };
    let places: Vec<Vec<usize>> = columns
        .iter()
        .map(|columns| columns.iter().map(|column| place(&column.name)).collect())
        .collect::<Result<_, _>>()?;
    let mut calls = Vec::new();
    for (index, line) in lines {
        let (line, cells) = (index + 1, cells(line));
        if cells.len() != head.len() {
            return Err(Wrong::Row { line, found: cells.len(), wanted: head.len() });
        }
        let mut call = Vec::new();
        for ((columns, places), parameter) in columns.iter().zip(&places).zip(parameters) {
            let one = |(column, place): (&Column, &usize)| {
                column.word(module, cells[*place]).ok_or_else(|| Wrong::Cell {
                    line,
                    column: column.name.clone(),
                    text: cells[*place].to_owned(),
                    kind: column.kind(module),
                })
            };
            let words = columns.iter().zip(places).map(one);
            let mut words = words.collect::<Result<Vec<u64>, _>>()?;
            module.canonical(&parameter.ty, &mut words);
            call.push(words);
        }
        calls.push(call);
    }
    if calls.is_empty() { Err(Wrong::Empty) } else { Ok(calls) }
}

fn cells(line: &str) -> Vec<&str> {
    line.split(',').map(str::trim).collect()
}

/// A number that goes in.
struct Column {
    name: String,
    ty: Type,
    /// Of a list's length the most.
    most: Option<u32>,
}

/// The numbers in a value, in the order of their words.
fn columns_of(module: &Module, ty: &Type, name: &str, columns: &mut Vec<Column>) {
    let column = |name: String, ty: Type| Column { name, ty, most: None };
    match ty {
        Type::Unit | Type::Slice(_) => {}
        Type::Scalar(_) | Type::Enum(_) => columns.push(column(name.to_owned(), ty.clone())),
        Type::Array { element, len } => {
            (0..*len).for_each(|n| columns_of(module, element, &format!("{name}[{n}]"), columns));
        }
        Type::Matrix { element, rows, cols } => {
            let element = Type::Scalar(*element);
            let one = |n| column(format!("{name}[{n}]"), element.clone());
            columns.extend((0..rows * cols).map(one));
        }
        Type::Struct(id) => {
            let item = &module.structs[id.index()];
            let first = columns.len();
            for field in &item.fields {
                columns_of(module, &field.ty, &format!("{name}.{}", field.name), columns);
            }
            if item.form == Form::Sequence
                && let Type::Array { len, .. } = item.fields[1].ty
            {
                columns[first].most = Some(len);
            }
        }
    }
}

impl Column {
    /// The word that a cell says; none if it is no value of the type.
    fn word(&self, module: &Module, text: &str) -> Option<u64> {
        match &self.ty {
            Type::Scalar(Scalar::Float(Float::F64)) => text.parse().ok().map(f64::to_bits),
            Type::Scalar(Scalar::Float(Float::F32)) => {
                text.parse().ok().map(|number: f32| u64::from(number.to_bits()))
            }
            Type::Scalar(Scalar::Int(int)) => {
                let number: i128 = text.parse().ok()?;
                (Int::min(*int)..=self.largest(*int)).contains(&number).then_some(number as u64)
            }
            Type::Scalar(Scalar::Bool) => match text {
                "true" | "1" => Some(1),
                "false" | "0" => Some(0),
                _ => None,
            },
            Type::Enum(id) => {
                let variants = &module.enums[id.index()].variants;
                let found = variants.iter().position(|it| it.name == text);
                found.map(|index| index as u64)
            }
            _ => None,
        }
    }

    fn largest(&self, int: Int) -> i128 {
        self.most.map_or(Int::max(int), i128::from)
    }

    /// What a cell has to be.
    fn kind(&self, module: &Module) -> String {
        match &self.ty {
            Type::Scalar(Scalar::Float(_)) => "number".to_owned(),
            Type::Scalar(Scalar::Int(int)) => {
                format!("whole number from {} to {}", Int::min(*int), self.largest(*int))
            }
            Type::Scalar(Scalar::Bool) => "`true` or `false`".to_owned(),
            Type::Enum(id) => format!("variant of `{}`", module.enums[id.index()].name),
            _ => "value".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_become_calls_and_mistakes_are_placed() {
        let text = include_str!("../../../codegen/tests/c/height.ir");
        let module = bessemer_ir::text::parse(text).expect("it is a module");
        let entry = |it: &&Function| matches!(it.role, bessemer_ir::Role::Entry { .. });
        let function = module.functions.iter().find(entry).expect("an entry point");
        let mut columns = Vec::new();
        for parameter in &function.parameters()[1..] {
            columns_of(&module, &parameter.ty, &parameter.name, &mut columns);
        }
        let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
        let cell = |column: &Column| match column.ty {
            Type::Scalar(Scalar::Bool) => "true",
            _ => "-2.5",
        };
        let cells: Vec<&str> = columns.iter().map(cell).collect();
        let (head, row) = (names.join(","), cells.join(" , "));
        let read = calls(&module, function, &format!("time,{head}\n\n0.5,{row}\n1,{row}\n"));
        let read = read.expect("a recording");
        assert_eq!(read.len(), 2);
        let words: Vec<u64> = read[0].concat();
        assert_eq!(words.len(), columns.len());
        assert!(words.contains(&(-2.5_f64).to_bits()), "{words:x?}");

        let said = |text: &str| calls(&module, function, text).expect_err(text).to_string();
        assert!(said(&format!("{head}\n")).contains("no rows"));
        assert!(said("time\n1\n").starts_with("it has no column `"));
        assert!(said(&format!("{head}\n1,{row}\n")).starts_with("line 2 has "));
        let wrong = row.replacen("-2.5", "high", 1);
        let expected = "line 2: `high` is no number, as `";
        assert!(said(&format!("{head}\n{wrong}\n")).starts_with(expected));
    }
}
