//! Two plots in SVG: bars for Chapter 6, lines for the small sizes.

use std::fmt::Write as _;

use super::case::{Element, Routine};
use super::report::ratio;
use super::results::{Results, Table};

/// Colours of the contenders or routines, the same in every panel.
const COLOURS: [&str; 9] = [
    "#b3541e", "#dba27f", "#9ca3af", "#0891b2", "#2563eb", "#0f766e", "#7c3aed", "#111827",
    "#be185d",
];

/// Colours of the routines; lines for `f32` are dashed.
const SHADES: [&str; 4] = ["#b3541e", "#2563eb", "#0f766e", "#7c3aed"];

fn open(width: usize, height: usize) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
    )
}

/// Plots both parts of Chapter 6 together: a bar for each contender, a group for each machine.
pub fn chapter_6(results: &Results) -> String {
    let bars: usize = results.chapter_6.iter().map(|table| table.contenders.len() + 2).sum();
    let mut text = open(760, 20 * bars + 20);
    let mut y = 20;
    for table in &results.chapter_6 {
        let _ = writeln!(
            text,
            "<text x=\"10\" y=\"{y}\" font-weight=\"bold\">{}: both parts, {}</text>",
            table.machine.title,
            if is_timed(table) { "µs" } else { "million instructions" }
        );
        y += 20;
        let totals: Vec<f64> =
            (0..table.contenders.len()).map(|index| total(table, index)).collect();
        let largest = totals.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        for (index, contender) in table.contenders.iter().enumerate() {
            let width = 420.0 * totals[index] / largest;
            let colour = COLOURS[*contender as usize % COLOURS.len()];
            let _ = writeln!(
                text,
                "<text x=\"10\" y=\"{y}\">{}</text><rect x=\"230\" y=\"{}\" width=\"{width:.1}\" height=\"13\" \
                 fill=\"{colour}\"/><text x=\"{:.1}\" y=\"{y}\">{:.2}</text>",
                contender.title(),
                y - 11,
                236.0 + width,
                totals[index]
            );
            y += 20;
        }
        y += 20;
    }
    text + "</svg>\n"
}

fn is_timed(table: &Table) -> bool {
    table.rows.iter().flat_map(|row| row.cells.iter().flatten()).any(|cell| cell.times.is_some())
}

fn total(table: &Table, index: usize) -> f64 {
    let cell = |cell: &super::results::Cell| match (cell.times, cell.instructions) {
        (Some(times), _) => times.median / 1e3,
        (None, count) => count.unwrap_or_default() as f64 / 1e6,
    };
    table.rows.iter().filter_map(|row| row.cells.get(index)?.as_ref().map(cell)).sum()
}

/// Plots the ratios to the best of the others: a panel for each machine.
pub fn small(results: &Results) -> String {
    let (width, height) = (760, 230);
    let mut text = open(width, height * results.small.len().max(1));
    for (panel, table) in results.small.iter().enumerate() {
        let top = (panel * height + 30) as f64;
        let x = |size: usize| 60.0 + 25.0 * size as f64;
        let y = |ratio: f64| top + 160.0 - 80.0 * ratio.clamp(0.0, 2.0);
        let _ = writeln!(
            text,
            "<text x=\"10\" y=\"{}\" font-weight=\"bold\">{}: {} of generated C / best of the others, by rows</text>",
            top - 12.0,
            table.machine.title,
            if is_timed(table) { "time" } else { "instructions" }
        );
        for line in [0.5, 1.0, 1.5] {
            let _ = writeln!(
                text,
                "<line x1=\"60\" x2=\"560\" y1=\"{0:.1}\" y2=\"{0:.1}\" stroke=\"#d1d5db\"/><text x=\"30\" y=\"{1:.1}\">{line}</text>",
                y(line),
                y(line) + 4.0
            );
        }
        for size in (2..=20).step_by(2) {
            let _ = writeln!(
                text,
                "<text x=\"{:.0}\" y=\"{:.0}\">{size}</text>",
                x(size) - 4.0,
                top + 176.0
            );
        }
        let mut entry: usize = 0;
        for element in [Element::F64, Element::F32] {
            for routine in Routine::ALL {
                let rows = table
                    .rows
                    .iter()
                    .filter(|row| row.case.element == element && row.case.routine == routine);
                let points: Vec<String> = rows
                    .filter_map(|row| {
                        Some(format!("{:.1},{:.1}", x(row.case.size), y(ratio(row)?)))
                    })
                    .collect();
                if points.is_empty() {
                    continue;
                }
                let colour = SHADES[entry % SHADES.len()];
                let dashes = if element == Element::F32 { "5 3" } else { "none" };
                let _ = writeln!(
                    text,
                    "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-dasharray=\"{dashes}\"/><text x=\"575\" y=\"{:.0}\" fill=\"{colour}\">{} {}</text>",
                    points.join(" "),
                    top + 10.0 + 16.0 * entry as f64,
                    routine.title(),
                    element.name()
                );
                entry += 1;
            }
        }
    }
    text + "</svg>\n"
}
