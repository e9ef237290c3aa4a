//! The performance goals of the generated C, and the measured values.

use std::fmt::Write as _;

use super::above;
use super::contender::Contender;
use super::machine::{A9, A9_PLAIN, HOST, HOST_V3, Machine};
use super::reasons::Reasons;
use super::results::{Cell, Results, Size, Table};

/// A figure and its upper limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// Description of the goal.
    pub what: String,
    /// Upper limit of the figure.
    pub most: f64,
    /// Measured value; none if the run did not measure it.
    pub reached: Option<f64>,
}

impl Goal {
    fn new(what: impl Into<String>, most: f64, reached: Option<f64>) -> Goal {
        Goal { what: what.into(), most, reached }
    }

    /// Returns true if the figure was measured and is within its limit.
    pub fn holds(&self) -> bool {
        self.reached.is_some_and(|reached| reached <= self.most)
    }
}

/// Returns all goals.
pub fn of(results: &Results, reasons: &Reasons) -> Vec<Goal> {
    let mut goals = vec![
        Goal::new(
            "Cortex-A9, Chapter 6, NEON loads: million instructions of both parts",
            5.6,
            millions(results, &A9),
        ),
        Goal::new(
            "Cortex-A9, Chapter 6, plain C99: million instructions of both parts",
            7.0,
            millions(results, &A9_PLAIN),
        ),
    ];
    for (name, machine) in [("host", &HOST), ("host without AVX-512", &HOST_V3)] {
        on_host(results, name, machine, &mut goals);
    }
    let unknown = || above::without_reason(results, reasons) as f64;
    let unknown = (!results.small.is_empty()).then(unknown);
    let what = "small sizes: cases above the best, and nobody knows why";
    goals.push(Goal::new(what, 0.0, unknown));
    sizes(results, &mut goals);
    goals
}

/// Adds the goals for the times of the computation of Chapter 6 on this machine.
fn on_host(results: &Results, name: &str, machine: &Machine, goals: &mut Vec<Goal>) {
    for (part, job) in ["solve 200", "invert 100"].into_iter().enumerate() {
        for contender in [Contender::Eigen, Contender::OpenBlas] {
            let what = format!("{name}, {job}: time over that of {}", contender.title());
            goals.push(Goal::new(what, 0.55, part_over(results, machine, contender, part)));
        }
    }
    for contender in [Contender::Eigen, Contender::OpenBlas] {
        let what = format!("{name}, both parts: time over that of {}", contender.title());
        goals.push(Goal::new(what, 0.55, times(results, machine, Contender::Generated, contender)));
    }
    goals.push(Goal::new(
        format!("{name}, Chapter 6: time over that of the handwritten C, as in the thesis"),
        0.20,
        times(results, machine, Contender::Generated, Contender::Thesis),
    ));
    goals.push(Goal::new(
        format!("{name}, Chapter 6: the fast mode's time over the exact mode's"),
        0.96,
        times(results, machine, Contender::Fast, Contender::Generated),
    ));
}

/// Adds the goals for the code size on the Cortex-A9, and for the stack on all machines.
fn sizes(results: &Results, goals: &mut Vec<Goal>) {
    let is_large = |size: &&Size| ["solve_f64_200", "inverse_f64_100"].contains(&&*size.kernel);
    for machine in [A9, A9_PLAIN] {
        let own = || results.sizes.iter().filter(|size| size.machine == machine.name);
        let large: Vec<u64> = own().filter(is_large).map(|size| size.text).collect();
        let both = (large.len() == 2).then(|| large.iter().sum::<u64>() as f64);
        let what = format!("{}, Chapter 6: bytes of code of both parts", machine.title);
        goals.push(Goal::new(what, 14.0 * 1024.0, both));
        let largest = own().filter(|size| !is_large(size)).map(|size| size.text).max();
        let what = format!("{}: bytes of code of the largest other kernel", machine.title);
        goals.push(Goal::new(what, 8.0 * 1024.0, largest.map(|bytes| bytes as f64)));
    }
    let stack = results.sizes.iter().map(|size| size.stack).max().map(|bytes| bytes as f64);
    goals.push(Goal::new("bytes of the stack that a kernel takes, on any machine", 4096.0, stack));
}

fn chapter_6<'a>(results: &'a Results, machine: &Machine) -> Option<&'a Table> {
    results.chapter_6.iter().find(|table| table.machine.name == machine.name)
}

fn cells(table: &Table, contender: Contender) -> Option<Vec<Cell>> {
    let at = table.contenders.iter().position(|it| *it == contender)?;
    table.rows.iter().map(|row| *row.cells.get(at)?).collect()
}

/// Returns the instructions of the generated C for both parts of Chapter 6, in millions.
fn millions(results: &Results, machine: &Machine) -> Option<f64> {
    let cells = cells(chapter_6(results, machine)?, Contender::Generated)?;
    let counts: Option<Vec<u64>> = cells.iter().map(|cell| cell.instructions).collect();
    Some(counts?.iter().sum::<u64>() as f64 / 1e6)
}

/// Returns the generated C's time for one part divided by a contender's: the median of the rounds' ratios.
fn part_over(
    results: &Results,
    machine: &Machine,
    contender: Contender,
    part: usize,
) -> Option<f64> {
    let cells = cells(chapter_6(results, machine)?, contender)?;
    Some(cells.get(part)?.times?.ratio)
}

/// Returns the sum of the medians of one contender divided by another's, over both parts.
fn times(results: &Results, machine: &Machine, one: Contender, other: Contender) -> Option<f64> {
    let table = chapter_6(results, machine)?;
    let both = |contender| -> Option<f64> {
        cells(table, contender)?.iter().map(|cell| Some(cell.times?.median)).sum()
    };
    Some(both(one)? / both(other)?)
}

/// Formats the goals as lines of a table.
pub fn markdown(results: &Results, reasons: &Reasons) -> String {
    let mut text = String::from(
        "\n## What was to be reached\n\n| | at most | reached | |\n|---|---:|---:|---|\n",
    );
    for goal in of(results, reasons) {
        let digits = if goal.most.fract() == 0.0 && goal.most != 7.0 { 0 } else { 3 };
        let figure = |figure: f64| format!("{figure:.digits$}");
        let reached = goal.reached.map_or_else(|| "–".to_owned(), figure);
        let word = match (goal.reached, goal.holds()) {
            (None, _) => "not measured".to_owned(),
            (_, true) => "yes".to_owned(),
            (_, false) => format!("**no**: {}", why(&goal, reasons)),
        };
        let most = figure(goal.most);
        let _ = writeln!(text, "| {} | {most} | {reached} | {word} |", goal.what);
    }
    text
}

fn why<'a>(goal: &Goal, reasons: &'a Reasons) -> &'a str {
    reasons.of_goal(&goal.what).unwrap_or("no reason known")
}

/// Formats the measured goals that are missed, for the terminal.
pub fn missed(results: &Results, reasons: &Reasons) -> String {
    let goals = of(results, reasons);
    let missed = goals.iter().filter(|goal| goal.reached.is_some() && !goal.holds());
    let line = |goal: &Goal| {
        let (what, most, reached) = (&goal.what, goal.most, goal.reached.unwrap_or_default());
        format!("\nnot reached: {what}: {reached:.3}, at most {most:.3}: {}\n", why(goal, reasons))
    };
    missed.map(line).collect()
}

/// A line for each goal that is not measured, or is missed by more than a reason speaks for, or is listed and not missed.
pub fn unsettled(results: &Results, reasons: &Reasons) -> Vec<String> {
    let goals = of(results, reasons);
    let missed: Vec<&Goal> = goals.iter().filter(|goal| !goal.holds()).collect();
    let speaks_for = |goal: &Goal| {
        let listed = reasons.goals().find(|known| known.what == goal.what);
        listed.zip(goal.reached).is_some_and(|(known, reached)| reached <= known.up_to)
    };
    let unknown = missed.iter().filter(|goal| !speaks_for(goal));
    let unknown = unknown.map(|goal| match goal.reached {
        Some(reached) => format!("{}: {reached}, and no reason speaks for that", goal.what),
        None => format!("{}: not measured", goal.what),
    });
    let settled = reasons.goals().filter(|known| missed.iter().all(|goal| goal.what != known.what));
    let settled = settled.map(|known| format!("{}: listed, and not missed", known.what));
    unknown.chain(settled).collect()
}
