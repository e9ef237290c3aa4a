//! The results of a run, read again from their JSON: so that what is written about them can change without another run.

use serde_json::Value;

use super::case::{CHAPTER_6, Case};
use super::clock::Times;
use super::contender::Contender;
use super::machine::{ALL, Machine};
use super::results::{Cell, Results, Row, Size, Table};
use super::run::FULL;

impl Results {
    /// What [`Results::json`] gave; none if this is something else.
    pub fn from_json(json: &Value) -> Option<Results> {
        let tables = |name: &str| json[name].as_array()?.iter().map(table).collect::<Option<_>>();
        let left_out = json["left_out"].as_array()?.iter();
        Some(Results {
            chapter_6: tables("chapter_6")?,
            small: tables("small")?,
            sizes: json["sizes"].as_array()?.iter().map(size).collect::<Option<_>>()?,
            left_out: left_out
                .map(|line| line.as_str().map(str::to_owned))
                .collect::<Option<_>>()?,
        })
    }
}

fn machine(json: &Value) -> Option<Machine> {
    let name = json["machine"].as_str()?;
    ALL.into_iter().find(|machine| machine.name == name)
}

fn size(json: &Value) -> Option<Size> {
    Some(Size {
        kernel: json["kernel"].as_str()?.to_owned(),
        machine: machine(json)?.name,
        text: json["text_bytes"].as_u64()?,
        stack: json["stack_bytes_at_most"].as_u64()?,
    })
}

fn table(json: &Value) -> Option<Table> {
    let machine = machine(json)?;
    let rows = json["cases"].as_array()?;
    let is_large = |case: &Case| CHAPTER_6.contains(case);
    let known: Vec<Case> = CHAPTER_6.into_iter().chain(Case::small(FULL.sizes)).collect();
    let cases: Option<Vec<Case>> = rows
        .iter()
        .map(|row| known.iter().copied().find(|case| Some(&*case.name()) == row["case"].as_str()))
        .collect();
    let cases = cases?;
    let mut contenders = match cases.first().is_some_and(is_large) {
        true => Contender::of_chapter_6(&machine),
        false => Contender::SMALL.to_vec(),
    };
    // Who was left out has no figure.
    contenders.retain(|it| rows.iter().any(|row| !row["contenders"][it.name()].is_null()));
    let row = |(case, row): (Case, &Value)| {
        let cells = contenders.iter().map(|it| cell(&row["contenders"][it.name()])).collect();
        Row { case, cells }
    };
    let rows = cases.into_iter().zip(rows).map(row).collect();
    let processor = json["processor"].as_str().map(str::to_owned);
    Some(Table { machine, contenders, rows, processor })
}

fn cell(json: &Value) -> Option<Cell> {
    let times = || {
        let quartile = |at: usize| json["nanoseconds_quartiles"][at].as_f64();
        Some(Times {
            low: quartile(0)?,
            median: quartile(1)?,
            high: quartile(2)?,
            ratio: json["generated_over_this"].as_f64()?,
        })
    };
    let instructions = json["instructions"].as_u64();
    let times = times();
    (instructions.is_some() || times.is_some()).then_some(Cell { instructions, times })
}
