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
    /// The contenders in order; the generated C is first.
    pub contenders: Vec<Contender>,
    /// A row for each case.
    pub rows: Vec<Row>,
    /// The processor on which times were measured; `None` for counts, which do not depend on it.
    pub processor: Option<String>,
}

/// The results of a case.
pub struct Row {
    /// Case of the row.
    pub case: Case,
    /// The result of each contender, in their order; `None` if it lacks the case.
    pub cells: Vec<Option<Cell>>,
}

/// The result of one contender for one case.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Executed instructions.
    pub instructions: Option<u64>,
    /// Quartiles of the time.
    pub times: Option<Times>,
}

/// Code size and stack of a kernel.
pub struct Size {
    /// Name of the kernel, such as `lu_solve_f64_6`.
    pub kernel: String,
    /// Name of the machine.
    pub machine: &'static str,
    /// Code and constants, bytes.
    pub text: u64,
    /// Bound of the stack, bytes: of all functions of the file together.
    pub stack: u64,
}

/// All results of a run.
#[derive(Default)]
pub struct Results {
    /// Results of the computation of Chapter 6, for each machine.
    pub chapter_6: Vec<Table>,
    /// Results of the small sizes, for each machine.
    pub small: Vec<Table>,
    /// Sizes of the generated kernels.
    pub sizes: Vec<Size>,
    /// Contenders and cases that were omitted, with the reasons.
    pub left_out: Vec<String>,
}

impl Row {
    /// Returns the instructions of the generated C divided by the fewest of the others.
    pub fn against_best(&self) -> Option<f64> {
        let count = |cell: &Option<Cell>| cell.and_then(|cell| cell.instructions);
        let (own, others) = self.cells.split_first()?;
        let best = others.iter().filter_map(count).min()?;
        Some(count(own)? as f64 / best as f64)
    }

    /// Returns the time of the generated C divided by the shortest of the others.
    pub fn time_against_best(&self) -> Option<f64> {
        let ratio = |cell: &Option<Cell>| cell.and_then(|cell| cell.times).map(|times| times.ratio);
        self.cells.iter().skip(1).filter_map(ratio).max_by(f64::total_cmp)
    }
}

impl Results {
    /// Replaces results by those of a later run.
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
    /// Formats executed instructions; or the quartiles in ns, and the generated C's time divided by this one.
    fn json(&self) -> Value {
        let Some(times) = self.times else { return json!(self.instructions) };
        let rounded = |value: f64, parts: f64| (parts * value).round() / parts;
        let [low, median, high] =
            [times.low, times.median, times.high].map(|time| rounded(time, 10.0));
        json!([low, median, high, rounded(times.ratio, 1000.0)])
    }
}
