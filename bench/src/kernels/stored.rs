//! Results of a run as a file with one line per row, so that a difference shows the changed cases. Stored results are
//! read again to update the text about them without another run.

use serde_json::{Value, json};

use super::case::{CHAPTER_6, Case};
use super::clock::Times;
use super::contender::Contender;
use super::machine::{ALL, HOST, Machine};
use super::results::{Cell, Results, Row, Size, Table};
use super::run::FULL;

/// Formats JSON with one line for each row.
pub fn text(json: &Value) -> String {
    let mut text = String::new();
    put(json, "\n", &mut text);
    text + "\n"
}

/// Appends a value; `before` is the line break with its indentation.
fn put(value: &Value, before: &str, text: &mut String) {
    let is_row = |items: &[Value]| items.first().is_none_or(Value::is_string);
    let (brackets, items): (_, Vec<(String, &Value)>) = match value {
        Value::Array(items) if !is_row(items) => {
            (['[', ']'], items.iter().map(|item| (String::new(), item)).collect())
        }
        Value::Object(fields) => {
            (['{', '}'], fields.iter().map(|(key, it)| (format!("{}: ", json!(key)), it)).collect())
        }
        row => return *text += &row.to_string(),
    };
    let deeper = format!("{before}  ");
    text.push(brackets[0]);
    for (at, (key, item)) in items.into_iter().enumerate() {
        *text += if at == 0 { "" } else { "," };
        *text += &deeper;
        *text += &key;
        put(item, &deeper, text);
    }
    *text += before;
    text.push(brackets[1]);
}

impl Results {
    /// Parses the output of [`Results::json`]; none if it is something else.
    pub fn from_json(json: &Value) -> Option<Results> {
        let tables = |name: &str| json[name].as_array()?.iter().map(table).collect::<Option<_>>();
        let left_out = json["left_out"].as_array()?.iter();
        let sizes: Option<Vec<Vec<Size>>> = json["sizes"].as_array()?.iter().map(sizes).collect();
        Some(Results {
            chapter_6: tables("chapter_6")?,
            small: tables("small")?,
            sizes: sizes?.into_iter().flatten().collect(),
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

fn sizes(json: &Value) -> Option<Vec<Size>> {
    let machine = machine(json)?.name;
    let size = |row: &Value| {
        let kernel = row[0].as_str()?.to_owned();
        Some(Size { kernel, machine, text: row[1].as_u64()?, stack: row[2].as_u64()? })
    };
    json["rows"].as_array()?.iter().map(size).collect()
}

fn table(json: &Value) -> Option<Table> {
    let known: Vec<Case> = CHAPTER_6.into_iter().chain(Case::small(FULL.sizes)).collect();
    let row = |row: &Value| {
        let (name, cells) = row.as_array()?.split_first()?;
        let case = *known.iter().find(|case| Some(&*case.name()) == name.as_str())?;
        Some(Row { case, cells: cells.iter().map(cell).collect() })
    };
    Some(Table {
        machine: machine(json)?,
        contenders: json["columns"].as_array()?.iter().skip(1).map(who).collect::<Option<_>>()?,
        rows: json["rows"].as_array()?.iter().map(row).collect::<Option<_>>()?,
        processor: json["processor"].as_str().map(str::to_owned),
    })
}

fn who(json: &Value) -> Option<Contender> {
    let known = Contender::of_chapter_6(&HOST).into_iter().chain(Contender::SMALL);
    known.into_iter().find(|contender| Some(contender.name()) == json.as_str())
}

fn cell(json: &Value) -> Option<Cell> {
    let times = json.as_array().and_then(|figures| {
        let [low, median, high, ratio] = figures.as_slice() else { return None };
        Some(Times {
            low: low.as_f64()?,
            median: median.as_f64()?,
            high: high.as_f64()?,
            ratio: ratio.as_f64()?,
        })
    });
    let instructions = json.as_u64();
    (instructions.is_some() || times.is_some()).then_some(Cell { instructions, times })
}
