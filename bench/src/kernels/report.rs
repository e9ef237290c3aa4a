//! Tables for the terminal, and the report in Markdown.

use std::fmt::Write as _;

use serde_json::Value;

use super::case::{Element, Routine};
use super::reasons::Reasons;
use super::results::{Cell, Results, Row, Table};
use super::{above, goals};

/// Formats short tables for the terminal.
pub fn terminal(results: &Results, reasons: &Reasons) -> String {
    let mut text = String::new();
    for table in &results.chapter_6 {
        let _ = writeln!(text, "\nChapter 6, {}\n", table.machine.title);
        for line in chapter_6(table) {
            let [who, solve, inverse, both, ratio] = line;
            let _ = writeln!(text, "{who:<32} {solve:>12} {inverse:>12} {both:>12} {ratio:>10}");
        }
    }
    for table in &results.small {
        let _ = writeln!(
            text,
            "\nSmall sizes, {}: generated / best of the others\n",
            table.machine.title
        );
        text += &small(table, "  ");
    }
    text += &goals::missed(results, reasons);
    for line in &results.left_out {
        let _ = writeln!(text, "\nleft out: {line}");
    }
    text
}

/// Formats the report of a run; `about` is the entry of that name in its JSON.
pub fn markdown(results: &Results, about: &Value, reasons: &Reasons) -> String {
    let mut text = String::from(
        "# Generated C against its peers\n\n\
         Written by `cargo xtask bench`; [kernels.json](kernels.json) has every figure, [reasons.json](reasons.json) why a\n\
         goal is missed or a case above the best. All contenders of a table had the same flags, without contraction, and ran in\n\
         turns in one run; each result was checked before (the generated C by its bits against the model as rustc compiles it,\n\
         the others by their residual).\n\n",
    );
    for (key, value) in about.as_object().into_iter().flatten() {
        let _ = writeln!(text, "* {key}: {}", value.as_str().unwrap_or_default());
    }
    text += &goals::markdown(results, reasons);
    text += "\n## The Chapter 6 job\n\n\
             Solve 200×200 with one right-hand side, and invert 100×100; doubles in [0, 1]. The data are loaded\n\
             outside the measured part. `ratio` is the generated C's figure over the contender's, for both parts.\n\n\
             ![Chapter 6](chapter6.svg)\n";
    for table in &results.chapter_6 {
        let unit =
            if has_times(table) { "median (quartiles), µs" } else { "million instructions" };
        let _ = write!(
            text,
            "\n### {}: {unit}\n\n{}| | solve 200 | invert 100 | both | ratio |\n|---|---:|---:|---:|---:|\n",
            table.machine.title,
            circumstances(table)
        );
        for line in chapter_6(table).iter().skip(1) {
            let _ = writeln!(text, "| {} |", line.join(" | "));
        }
    }
    text += "\n## Small sizes\n\n\
             The generated C's figure over that of the best of naive C, Eigen (fixed sizes) and nalgebra. Each call\n\
             leaves its operands as they were, so copies count. A time is that of as many calls at each of the four places\n\
             of a line of the cache where a stack may begin, for that alone makes up to three times the difference.\n\n![Small sizes](small.svg)\n";
    for table in &results.small {
        let what = if has_times(table) { "time" } else { "instructions" };
        let _ = write!(
            text,
            "\n### {}: {what}\n\n{}```text\n",
            table.machine.title,
            circumstances(table)
        );
        text += &small(table, "");
        text += "```\n";
    }
    text += &above::markdown(results, reasons);
    text += &sizes(results);
    for line in &results.left_out {
        let _ = writeln!(text, "\nLeft out: {line}");
    }
    text
}

/// Formats the flags, and the processor on which the times were measured.
fn circumstances(table: &Table) -> String {
    let processor = table.processor.as_ref().map(|name| format!("; {name}")).unwrap_or_default();
    format!("`{}`{processor}\n\n", table.machine.flags.join(" "))
}

/// Formats the code sizes: a line for each kernel, a column for each machine.
fn sizes(results: &Results) -> String {
    let mut machines = Vec::new();
    let mut kernels = Vec::new();
    for size in &results.sizes {
        if !machines.contains(&size.machine) {
            machines.push(size.machine);
        }
        if !kernels.contains(&&size.kernel) {
            kernels.push(&size.kernel);
        }
    }
    let mut text = format!(
        "\n## Code and stack\n\nBytes of code and constants of each kernel on each machine; and of stack at most, all functions of the \
         file together, on the one that takes the most.\n\n| kernel | {} | stack |\n|---|{}\n",
        machines.join(" | "),
        "---:|".repeat(machines.len() + 1)
    );
    for kernel in kernels {
        let of = |machine: &&str| {
            let size =
                results.sizes.iter().find(|it| &it.kernel == kernel && it.machine == *machine);
            size.map_or_else(|| "–".to_owned(), |size| size.text.to_string())
        };
        let cells: Vec<String> = machines.iter().map(of).collect();
        let own = results.sizes.iter().filter(|it| &it.kernel == kernel);
        let stack = own.map(|it| it.stack).max().unwrap_or_default();
        let _ = writeln!(text, "| `{kernel}` | {} | {stack} |", cells.join(" | "));
    }
    text
}

fn has_times(table: &Table) -> bool {
    table.rows.iter().flat_map(|row| &row.cells).flatten().any(|cell| cell.times.is_some())
}

/// Formats the results of Chapter 6: a heading, and a line for each contender.
fn chapter_6(table: &Table) -> Vec<[String; 5]> {
    let unit = if has_times(table) { "µs" } else { "M instr." };
    let mut lines =
        vec![[unit.into(), "solve".into(), "invert".into(), "both".into(), "ratio".into()]];
    let total = |index: usize| -> Option<f64> {
        table.rows.iter().map(|row| row.cells.get(index)?.as_ref().map(value)).sum()
    };
    for (index, contender) in table.contenders.iter().enumerate() {
        let part = |part: usize| {
            let cell = table.rows.get(part).and_then(|row| row.cells.get(index)?.as_ref());
            cell.map_or_else(|| "–".to_owned(), shown)
        };
        let both = total(index).map_or_else(|| "–".to_owned(), |both| format!("{both:.2}"));
        let ratio = match (total(0), total(index)) {
            (Some(own), Some(other)) => format!("{:.3}", own / other),
            _ => "–".to_owned(),
        };
        lines.push([contender.title().into(), part(0), part(1), both, ratio]);
    }
    lines
}

/// Returns a time in µs, or a count in millions of instructions.
fn value(cell: &Cell) -> f64 {
    match (cell.times, cell.instructions) {
        (Some(times), _) => times.median / 1e3,
        (None, count) => count.unwrap_or_default() as f64 / 1e6,
    }
}

fn shown(cell: &Cell) -> String {
    match cell.times {
        Some(times) => {
            format!("{:.1} ({:.1}–{:.1})", times.median / 1e3, times.low / 1e3, times.high / 1e3)
        }
        None => format!("{:.3}", value(cell)),
    }
}

/// Returns the ratio of a row: of times if there are any, otherwise of counts.
pub fn ratio(row: &Row) -> Option<f64> {
    row.time_against_best().or_else(|| row.against_best())
}

/// Formats the small sizes: a line for each routine and type, a column for each size.
fn small(table: &Table, indent: &str) -> String {
    let mut sizes: Vec<usize> = table.rows.iter().map(|row| row.case.size).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let mut text = format!("{indent}{:<20}", "");
    for size in &sizes {
        let _ = write!(text, "{size:>6}");
    }
    text.push('\n');
    for element in [Element::F64, Element::F32] {
        for routine in Routine::ALL {
            let of = |size: &usize| {
                let fits = |row: &&Row| {
                    row.case.element == element
                        && row.case.routine == routine
                        && row.case.size == *size
                };
                table.rows.iter().find(fits).and_then(ratio)
            };
            let ratios: Vec<Option<f64>> = sizes.iter().map(of).collect();
            if ratios.iter().all(Option::is_none) {
                continue;
            }
            let _ =
                write!(text, "{indent}{:<20}", format!("{} {}", routine.title(), element.name()));
            for ratio in ratios {
                let _ = match ratio {
                    Some(ratio) => write!(text, "{ratio:>6.2}"),
                    None => write!(text, "{:>6}", "–"),
                };
            }
            text.push('\n');
        }
    }
    text
}
