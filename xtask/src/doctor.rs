//! `cargo xtask doctor`: lists the tools found and missing, and the line that installs the missing ones.
//!
//! Invariants: it changes nothing; its texts depend only on the findings, and `run` only prints them.

use crate::args::Doctor;
use crate::error::{Error, Outcome};
use crate::install::Plan;
use crate::tools::{self, Finding, Machine, Need, Source};
use anstyle::{AnsiColor, Style};
use serde_json::{Value, json};
use std::fmt::Write as _;

const HOST: &[Need] = &[Need::Everything, Need::Host];
const ALL: &[Need] = &[Need::Everything, Need::Host, Need::Target, Need::Analysis];
const RED: Style = Style::new().bold().fg_color(Some(anstyle::Color::Ansi(AnsiColor::Red)));
const GREEN: Style = Style::new().fg_color(Some(anstyle::Color::Ansi(AnsiColor::Green)));
const BOLD: Style = Style::new().bold();

/// Prints the state of this machine. The outcome is bad if something that `test` needs is missing.
///
/// # Errors
/// None today; the type is that of every command.
pub fn run(wanted: &Doctor, machine: &dyn Machine) -> Result<Outcome, Error> {
    let findings = tools::survey(machine);
    let plan = Plan::of(&tools::missing(&findings, ALL), machine);
    let text = if wanted.json {
        format!("{:#}\n", json(&findings, plan.as_ref()))
    } else {
        table(&findings, plan.as_ref())
    };
    anstream::print!("{text}");
    Ok(if tools::missing(&findings, ALL).is_empty() { Outcome::Good } else { Outcome::Bad })
}

/// The table for people, with colour codes, which the stream drops where they are not wanted.
#[must_use]
pub fn table(findings: &[Finding], plan: Option<&Plan>) -> String {
    let width = |cell: fn(&Finding) -> &str| {
        findings.iter().map(|finding| cell(finding).len()).max().unwrap_or(0)
    };
    let (names, versions, needs) = (width(name), width(version).max("version".len()), width(need));
    let mut text = format!(
        "{BOLD}{:names$}  {:versions$}  {:needs$}  what for{BOLD:#}\n",
        "tool", "version", "needed for"
    );
    for finding in findings {
        let style = if finding.is_missing() { RED } else { GREEN };
        let (tool, found, need) = (name(finding), version(finding), need(finding));
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{tool:names$}  {style}{found:versions$}{style:#}  {need:needs$}  {}",
            finding.tool.purpose
        );
    }
    text + "\n" + &conclusion(findings, plan)
}

fn conclusion(findings: &[Finding], plan: Option<&Plan>) -> String {
    let missing = tools::missing(findings, ALL);
    if missing.is_empty() {
        return "Everything is there: `cargo xtask test` can run.\n".to_owned();
    }
    let names: Vec<_> = missing.iter().map(|tool| tool.name).collect();
    let host = match tools::missing(findings, HOST).is_empty() {
        true => " `cargo xtask test --host` can run.",
        false => "",
    };
    let remedy = match plan {
        Some(plan) => format!(
            "To install, run this line, or `cargo xtask test --install`:\n  {}",
            plan.line()
        ),
        None => "There is no apt-get here: install them with this system's own package manager."
            .to_owned(),
    };
    format!("Missing: {}.{host}\n{remedy}\n", names.join(", "))
}

/// Returns the findings as JSON.
#[must_use]
pub fn json(findings: &[Finding], plan: Option<&Plan>) -> Value {
    let tools: Vec<Value> = findings.iter().map(entry).collect();
    json!({
        "tools": tools,
        "ready": {
            "gen": tools::missing(findings, &[Need::Everything]).is_empty(),
            "test": tools::missing(findings, ALL).is_empty(),
            "test --host": tools::missing(findings, HOST).is_empty(),
        },
        "install": plan.map(Plan::line),
    })
}

fn entry(finding: &Finding) -> Value {
    let source = &finding.tool.source;
    let package = match source {
        Source::Package(name) => Some(name),
        _ => None,
    };
    let component = match source {
        Source::Component(name) => Some(name),
        _ => None,
    };
    let python = match source {
        Source::Python(name) => Some(name),
        _ => None,
    };
    json!({
        "name": finding.tool.name,
        "found": !finding.is_missing(),
        "version": finding.found,
        "needed_for": finding.tool.need.text(),
        "purpose": finding.tool.purpose,
        "package": package,
        "component": component,
        "python": python,
    })
}

fn name(finding: &Finding) -> &str {
    finding.tool.name
}

fn version(finding: &Finding) -> &str {
    finding.found.as_deref().unwrap_or("missing")
}

fn need(finding: &Finding) -> &str {
    finding.tool.need.text()
}
