//! Recorded inputs of an entry point: a table with a column for each number that goes in, a row for each call. It comes from
//! CSV (`table`), from an MCAP file, whose messages in JSON are rows (`messages`), or from a flight log, whose topics
//! `bessemer.toml` maps to the columns (`flight`).
//!
//! Columns are called as the parameters and their parts are in the Rust: `target`, `gains.p`, `position[2]`. Elements of a
//! matrix count by columns. Columns of other names are ignored, so that a log can be taken as it is. A parameter with a default of which
//! the recording has no column keeps its default. The component begins in its initial state, and lives from row to row.
//!
//! Invariant: nothing is dropped in silence. What is not read is an error at its place, or a note.

mod error;
pub mod flight;
mod mcap;
mod messages;
mod table;

use bessemer_ir::{Float, Form, Function, Int, Local, Module, Scalar, Type};

pub use error::Wrong;

/// Number of names that a note lists.
const FEW: usize = 4;

/// Recorded calls, and what a reader of the result has to know of them.
pub struct Recording {
    /// Words of the arguments of each call, without those of the component.
    pub calls: Vec<Vec<Vec<u64>>>,
    /// Notes: defaults that were used, lines that were skipped, the order of messages.
    pub notes: Vec<String>,
}

/// Reads the calls of an entry point.
///
/// # Errors
/// [`Wrong`], with its place.
pub fn read(
    module: &Module,
    function: &Function,
    bytes: &[u8],
    mapping: &flight::Mapping<'_>,
) -> Result<Recording, Wrong> {
    let wanted = Wanted::of(module, function);
    let table = match flight::read(bytes, &wanted, mapping) {
        Some(table) => table?,
        None if bytes.starts_with(mcap::MAGIC) => messages::read(bytes, &wanted)?,
        None => table::read(bytes, &wanted)?,
    };
    if table.rows.is_empty() {
        return Err(Wrong::Empty);
    }
    let mut notes = table.notes;
    let absent = wanted.parameters.iter().zip(&table.present).filter(|(_, present)| !**present);
    notes.extend(absent.map(|(it, _)| format!("`{}` has its defaults: no column", it.local.name)));
    let calls =
        table.rows.iter().map(|row| wanted.call(row, &table.present)).collect::<Result<_, _>>();
    Ok(Recording { calls: calls?, notes })
}

/// Rows as they were recorded.
struct Table {
    rows: Vec<Row>,
    /// True for each parameter whose columns the rows have.
    present: Vec<bool>,
    notes: Vec<String>,
}

/// Cells of one call: the columns of all parameters that are present, in their order.
#[derive(Debug)]
struct Row {
    place: String,
    cells: Vec<String>,
}

/// Parameters of an entry point, without the component.
struct Wanted<'m> {
    module: &'m Module,
    parameters: Vec<Parameter<'m>>,
}

/// A parameter, its columns, and the words of its default where its type has one.
struct Parameter<'m> {
    local: &'m Local,
    columns: Vec<Column>,
    default: Option<&'m [u64]>,
}

impl<'m> Wanted<'m> {
    fn of(module: &'m Module, function: &'m Function) -> Wanted<'m> {
        let parameters = function.parameters().iter().skip(1);
        let parameter = |local: &'m Local| {
            let mut columns = Vec::new();
            columns_of(module, &local.ty, &local.name, &mut columns);
            let default = match &local.ty {
                Type::Struct(id) => {
                    let of = &module.structs[id.index()];
                    of.initial.as_deref().or(of.defaults.as_deref())
                }
                _ => None,
            };
            Parameter { local, columns, default }
        };
        Wanted { module, parameters: parameters.map(parameter).collect() }
    }

    /// The columns of the parameters that are present.
    fn columns(&self, present: &[bool]) -> impl Iterator<Item = &Column> {
        let present = self.parameters.iter().zip(present).filter(|(_, present)| **present);
        present.flat_map(|(parameter, _)| &parameter.columns)
    }

    /// The number of columns that a recording has.
    fn found(&self, has: impl Fn(&str) -> bool) -> usize {
        self.parameters.iter().flat_map(|it| &it.columns).filter(|it| has(&it.name)).count()
    }

    /// Returns true if any cell is a value of its column.
    fn has_value(&self, present: &[bool], cells: &[String]) -> bool {
        self.columns(present)
            .zip(cells)
            .any(|(column, cell)| column.word(self.module, cell).is_some())
    }

    /// A note on names of a recording that are parts of parameters by their beginning, and that no parameter has.
    fn beside(&self, names: &[String]) -> Option<String> {
        let is_part = |name: &str| {
            let rest = |it: &Parameter<'_>| name.strip_prefix(it.local.name.as_str());
            let mut rests = self.parameters.iter().filter_map(rest);
            rests.any(|rest| rest.starts_with(['.', '[']))
        };
        let others: Vec<String> = names.iter().filter(|it| is_part(it)).cloned().collect();
        let others: Vec<String> =
            others.into_iter().filter(|name| self.found(|it| it == name) == 0).collect();
        let more = others.len().saturating_sub(FEW);
        let shown = listed(&others[..others.len() - more]);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        (!others.is_empty())
            .then(|| format!("{shown}{more} left out: no parameter has such a part"))
    }

    /// The parameters whose columns a recording has. One of which it has none may be absent if it has a default.
    fn present(
        &self,
        has: impl Fn(&str) -> bool,
        found: impl Fn() -> Vec<String>,
    ) -> Result<Vec<bool>, Wrong> {
        let nothing = self.found(&has) == 0;
        let of_one = |parameter: &Parameter<'_>| {
            let mut missing = parameter.columns.iter().filter(|column| !has(&column.name));
            let Some(first) = missing.next() else { return Ok(true) };
            let absent = missing.count() + 1 == parameter.columns.len();
            if absent && !nothing && parameter.default.is_some() {
                return Ok(false);
            }
            Err(Wrong::Column {
                column: first.name.clone(),
                wanted: self.listed(),
                found: listed(&found()),
            })
        };
        self.parameters.iter().map(of_one).collect()
    }

    /// The parameters, as a message lists them.
    fn names(&self) -> String {
        listed(&self.parameters.iter().map(|it| it.local.name.clone()).collect::<Vec<_>>())
    }

    /// All wanted columns, as a message lists them.
    fn listed(&self) -> String {
        let columns = self.parameters.iter().flat_map(|it| &it.columns);
        listed(&columns.map(|it| it.name.clone()).collect::<Vec<_>>())
    }

    /// The words of the arguments of a call.
    fn call(&self, row: &Row, present: &[bool]) -> Result<Vec<Vec<u64>>, Wrong> {
        let mut cells = row.cells.iter();
        let word = |(column, text): (&Column, &String)| {
            column.word(self.module, text).ok_or_else(|| Wrong::Cell {
                place: row.place.clone(),
                column: column.name.clone(),
                text: text.clone(),
                kind: column.kind(self.module),
                remedy: column.remedy(text),
            })
        };
        let argument = |(parameter, present): (&Parameter<'_>, &bool)| {
            let mut words = match (present, parameter.default) {
                (false, Some(default)) => default.to_vec(),
                _ => {
                    let cells = parameter.columns.iter().zip(cells.by_ref());
                    cells.map(word).collect::<Result<Vec<u64>, _>>()?
                }
            };
            self.module.canonical(&parameter.local.ty, &mut words);
            Ok(words)
        };
        self.parameters.iter().zip(present).map(argument).collect()
    }
}

/// Names, as a message lists them.
fn listed(names: &[String]) -> String {
    if names.is_empty() {
        return "none".to_owned();
    }
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// A number that goes in or comes out.
pub(super) struct Column {
    pub(super) name: String,
    ty: Type,
    /// Largest length of a list.
    most: Option<u32>,
}

/// The numbers in a value, in the order of their words.
pub(super) fn columns_of(module: &Module, ty: &Type, name: &str, columns: &mut Vec<Column>) {
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
                let number: i128 = whole(text).parse().ok()?;
                (Int::min(*int)..=self.largest(*int)).contains(&number).then_some(number as u64)
            }
            Type::Scalar(Scalar::Bool) => match whole(text) {
                "true" | "True" | "TRUE" | "1" => Some(1),
                "false" | "False" | "FALSE" | "0" => Some(0),
                _ => None,
            },
            Type::Enum(id) => {
                let variants = &module.enums[id.index()].variants;
                // C logs the variant's number.
                let number: Option<i32> = whole(text).parse().ok();
                let found =
                    variants.iter().position(|it| it.name == text || Some(it.value) == number);
                found.map(|index| index as u64)
            }
            _ => None,
        }
    }

    /// The text that reads back as a word.
    pub(super) fn text(&self, module: &Module, word: u64) -> String {
        match &self.ty {
            Type::Scalar(Scalar::Float(Float::F64)) => format!("{:?}", f64::from_bits(word)),
            Type::Scalar(Scalar::Float(Float::F32)) => format!("{:?}", f32::from_bits(word as u32)),
            Type::Scalar(Scalar::Int(int)) if Int::min(*int) < 0 => (word as i64).to_string(),
            Type::Scalar(Scalar::Bool) => (word != 0).to_string(),
            Type::Enum(id) => {
                let variant = module.enums[id.index()].variants.get(word as usize);
                variant.map_or_else(|| word.to_string(), |it| it.name.clone())
            }
            _ => word.to_string(),
        }
    }

    fn largest(&self, int: Int) -> i128 {
        self.most.map_or(Int::max(int), i128::from)
    }

    /// The remedy for a text that is no value of the column, behind a semicolon.
    fn remedy(&self, text: &str) -> &'static str {
        let is_number = |text: &str| text.parse::<f64>().is_ok();
        match &self.ty {
            Type::Scalar(Scalar::Int(_)) if text.contains(['e', 'E']) && is_number(text) => {
                "; it was rounded when it was written: record it with all digits"
            }
            Type::Scalar(_) if text.is_empty() => "; remove rows without it, or record it in each",
            Type::Scalar(_) if text.contains(',') && is_number(&text.replacen(',', ".", 1)) => {
                "; write a decimal point for the comma"
            }
            _ => "",
        }
    }

    /// The values of the column, as a message names them.
    fn kind(&self, module: &Module) -> String {
        match &self.ty {
            Type::Scalar(Scalar::Float(_)) => "number".to_owned(),
            Type::Scalar(Scalar::Int(int)) => {
                format!("whole number from {} to {}", Int::min(*int), self.largest(*int))
            }
            Type::Scalar(Scalar::Bool) => "`true` or `false`".to_owned(),
            Type::Enum(id) => {
                let item = &module.enums[id.index()];
                let variants: Vec<String> =
                    item.variants.iter().map(|it| it.name.clone()).collect();
                format!("variant of `{}` ({}, or its number)", item.name, listed(&variants))
            }
            _ => "value".to_owned(),
        }
    }
}

/// A whole number that was written with a decimal point, without it.
fn whole(text: &str) -> &str {
    match text.split_once('.') {
        Some((before, zeros)) if zeros.bytes().all(|digit| digit == b'0') => before,
        _ => text,
    }
}

#[cfg(test)]
mod tests;
