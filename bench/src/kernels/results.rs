//! The results of the measurement.

use serde_json::{Value, json};

use super::case::Case;
use super::clock::Times;
use super::contender::Contender;
use super::machine::{ALL, Machine};

/// Instructions or times of the cases on one machine.
pub struct Table {
    /// Machine of the run.
    pub machine: Machine,
    /// Contenders in order; the generated C first.
    pub contenders: Vec<Contender>,
    /// Results of each case, in order of the contenders; none where one has no such case.
    pub rows: Vec<Row>,
    /// Whose times these are; counts are the same on any.
    pub processor: Option<String>,
}

/// A case.
pub struct Row {
    /// Case of the row.
    pub case: Case,
    /// One of each contender.
    pub cells: Vec<Option<Cell>>,
}

/// One contender on one case.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Executed instructions.
    pub instructions: Option<u64>,
    /// Time.
    pub times: Option<Times>,
}

/// Code size and stack of a kernel.
pub struct Size {
    /// `lu_solve_f64_6`.
    pub kernel: String,
    /// The machine's name.
    pub machine: &'static str,
    /// Bytes of code and constants.
    pub text: u64,
    /// At most so many bytes of the stack: all functions of the file together.
    pub stack: u64,
}

/// Everything of one run.
#[derive(Default)]
pub struct Results {
    /// The Chapter 6 job.
    pub chapter_6: Vec<Table>,
    /// Small sizes.
    pub small: Vec<Table>,
    /// Sizes of the generated kernels.
    pub sizes: Vec<Size>,
    /// Contenders and cases left out, with reasons.
    pub left_out: Vec<String>,
}

impl Row {
    /// The generated C's instructions over the fewest of the others.
    pub fn against_best(&self) -> Option<f64> {
        let count = |cell: &Option<Cell>| cell.and_then(|cell| cell.instructions);
        let (own, others) = self.cells.split_first()?;
        let best = others.iter().filter_map(count).min()?;
        Some(count(own)? as f64 / best as f64)
    }

    /// The generated C's time over the shortest of the others.
    pub fn time_against_best(&self) -> Option<f64> {
        let ratio = |cell: &Option<Cell>| cell.and_then(|cell| cell.times).map(|times| times.ratio);
        self.cells.iter().skip(1).filter_map(ratio).max_by(f64::total_cmp)
    }
}

impl Results {
    /// Takes what was measured again in place of what there was.
    pub fn renew(&mut self, again: Results) {
        let tables = || again.chapter_6.iter().chain(&again.small);
        self.sizes.retain(|size| !tables().any(|it| it.machine.name == size.machine));
        self.left_out.retain(|line| !tables().any(|it| line.contains(it.machine.title)));
        self.sizes.extend(again.sizes);
        for (tables, fresh) in
            [(&mut self.chapter_6, again.chapter_6), (&mut self.small, again.small)]
        {
            for table in fresh {
                let has_it = |old: &&mut Table| old.machine == table.machine;
                match tables.iter_mut().find(has_it) {
                    Some(old) => *old = table,
                    None => tables.push(table),
                }
            }
        }
        let place = |table: &Table| ALL.iter().position(|machine| *machine == table.machine);
        self.chapter_6.sort_by_key(place);
        self.left_out.extend(again.left_out);
    }

    /// Returns the content of `kernels.json`: a table for each machine, a row for each case. Sizes follow the machines,
    /// so that a later run of some machines leaves other rows unchanged.
    pub fn json(&self, about: &Value) -> Value {
        let tables = |tables: &[Table]| tables.iter().map(Table::json).collect::<Vec<_>>();
        let sizes = ALL.iter().filter_map(|machine| {
            let own = self.sizes.iter().filter(|size| size.machine == machine.name);
            let rows: Vec<Value> =
                own.map(|size| json!([size.kernel, size.text, size.stack])).collect();
            (!rows.is_empty()).then(|| {
                let columns = ["kernel", "text_bytes", "stack_bytes_at_most"];
                json!({ "machine": machine.name, "columns": columns, "rows": rows })
            })
        });
        json!({
            "about": about,
            "chapter_6": tables(&self.chapter_6),
            "small": tables(&self.small),
            "sizes": sizes.collect::<Vec<_>>(),
            "left_out": self.left_out,
        })
    }
}

impl Table {
    fn json(&self) -> Value {
        let row = |row: &Row| {
            let cells = row.cells.iter().map(|cell| cell.as_ref().map_or(Value::Null, Cell::json));
            Value::Array(std::iter::once(json!(row.case.name())).chain(cells).collect())
        };
        let who = self.contenders.iter().map(|contender| contender.name());
        let mut table = json!({
            "machine": self.machine.name,
            "flags": self.machine.flags.join(" "),
            "rust_flags": self.machine.rust_flags,
            "columns": std::iter::once("case").chain(who).collect::<Vec<_>>(),
            "rows": self.rows.iter().map(row).collect::<Vec<_>>(),
        });
        if let Some(processor) = &self.processor {
            table["processor"] = json!(processor);
        }
        table
    }
}

impl Cell {
    /// Executed instructions; or the quartiles in nanoseconds, and the generated C's time over this one.
    fn json(&self) -> Value {
        let Some(times) = self.times else { return json!(self.instructions) };
        let rounded = |value: f64, parts: f64| (parts * value).round() / parts;
        let [low, median, high] =
            [times.low, times.median, times.high].map(|time| rounded(time, 10.0));
        json!([low, median, high, rounded(times.ratio, 1000.0)])
    }
}
