//! The summary as one HTML file: no network, no script, readable in any browser and on paper.

use crate::bounds::Rate;
use crate::picture::histogram;
use crate::summary::{Figures, Seed, Summary, bounds, short, titled};
use std::fmt::Write as _;

const STYLE: &str = "\
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; color: #1c2733; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin: 2rem 0 .4rem; border-bottom: 1px solid #d5dce3; }
table { border-collapse: collapse; margin: .5rem 0; } th, td { padding: .2rem .8rem .2rem 0; text-align: left; vertical-align: top; }
th { font-weight: 600; color: #52606d; } td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
.row { display: flex; flex-wrap: wrap; gap: 1.5rem; align-items: flex-start; } svg { max-width: 100%; height: auto; }
code { font: 13px ui-monospace, monospace; background: #eef2f5; padding: .1rem .3rem; border-radius: 3px; }
.big { font-size: 1.25rem; } .good { color: #1b6e3c; } .bad { color: #a3251d; } .small { color: #52606d; font-size: 13px; }
@media print { body { margin: 0; } }";

impl Summary {
    /// Returns true if a seed on the page has a link.
    fn has_links(&self) -> bool {
        let faults = self.faults.iter().flat_map(|it| &it.seeds);
        let worst = self.columns.iter().flat_map(|it| &it.worst);
        faults.chain(worst).any(|it| !it.link.is_empty())
    }

    /// Formats the figures as an HTML file.
    pub fn page(&self) -> String {
        let mut text = format!(
            "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\">\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>Campaign {0}</title>\n<style>\n{STYLE}\n</style>\n<h1>Campaign {0}</h1>\n",
            escape(&self.kind)
        );
        let class = if self.bad.events == 0 { "good" } else { "bad" };
        let _ = writeln!(
            text,
            "<p class=\"big {class}\">{} of {} runs are not as they must be: {}.</p>",
            self.bad.events,
            self.bad.runs,
            bounds(&self.bad)
        );
        let options = if self.options.is_empty() { "none" } else { &self.options };
        let _ = writeln!(
            text,
            "<p class=\"small\">Version {}, options: {}, models {}. Bounds are those of Clopper and Pearson (Biometrika 26, \
             1934): in at least 95 of 100 campaigns they contain the true probability, if seeds were not chosen by their results.</p>",
            self.version,
            escape(options),
            escape(&self.models)
        );
        for remark in &self.remarks {
            let _ = writeln!(text, "<p class=\"bad\">{}</p>", escape(remark));
        }
        if self.has_links() {
            text += "<p class=\"small\">The number of a seed is a link, which shows its run while the program of the command beside \
                     it is running, with this or any other seed.</p>\n";
        }
        if !self.faults.is_empty() {
            text += "<h2>What went wrong</h2>\n<table><tr><th>fault<th class=\"n\">runs<th>probability<th>first seeds\n";
        }
        for it in &self.faults {
            let _ = writeln!(
                text,
                "<tr><td>{}<td class=\"n\">{}<td>{}<td>{}",
                escape(&it.what),
                it.rate.events,
                range(&it.rate),
                seeds(&it.seeds)
            );
        }
        if !self.faults.is_empty() {
            text += "</table>\n";
        }
        for it in &self.columns {
            column(&mut text, it, self.runs as u64);
        }
        text + "</html>\n"
    }
}

fn column(text: &mut String, it: &Figures, runs: u64) {
    let _ = writeln!(text, "<h2>{}</h2>", escape(&titled(it)));
    if !it.counts.is_empty() {
        text.push_str("<table><tr><th>value<th class=\"n\">runs<th>probability\n");
        for (value, count) in it.counts.iter().take(24) {
            let rate = Rate::of(*count as u64, runs);
            let _ = writeln!(
                text,
                "<tr><td>{}<td class=\"n\">{count}<td>{}",
                escape(value),
                range(&rate)
            );
        }
        text.push_str("</table>\n");
        if it.counts.len() > 24 {
            let _ =
                writeln!(text, "<p class=\"small\">and {} more values</p>", it.counts.len() - 24);
        }
        return;
    }
    if it.infinite > 0 {
        let rate = Rate::of(it.infinite as u64, runs);
        let _ = writeln!(text, "<p>Infinite in {} runs ({}).</p>", it.infinite, range(&rate));
    }
    if it.finite == 0 {
        text.push_str("<p class=\"small\">no finite number</p>\n");
        return;
    }
    text.push_str("<div class=\"row\"><div>");
    text.push_str(&histogram(&it.sorted, &titled(it)));
    text.push_str("</div><div><table>");
    let figures = [
        ("least", it.least),
        ("median", it.median),
        ("90 %", it.p90),
        ("99 %", it.p99),
        ("most", it.most),
    ];
    for (name, value) in figures {
        let _ = write!(text, "<tr><th>{name}<td class=\"n\">{}", short(value.unwrap_or(0.0)));
    }
    text.push_str("</table></div></div>\n");
    if !it.worst.is_empty() {
        text.push_str("<table><tr><th class=\"n\">worst<th>seed, and how to see it\n");
        for seed in &it.worst {
            let value = short(seed.value.unwrap_or(0.0));
            let _ = writeln!(text, "<tr><td class=\"n\">{value}<td>{}", shown(seed));
        }
        text.push_str("</table>\n");
    }
}

fn range(rate: &Rate) -> String {
    let of = |share: f64| short(100.0 * share);
    format!("{} % ({} to {} %)", of(rate.share()), of(rate.low), of(rate.high))
}

fn seeds(all: &[Seed]) -> String {
    all.iter().map(shown).collect::<Vec<_>>().join("<br>")
}

fn shown(it: &Seed) -> String {
    let mut text = match it.link.as_str() {
        "" => it.seed.to_string(),
        link => format!("<a href=\"{}\">{}</a>", escape(link), it.seed),
    };
    if !it.command.is_empty() {
        let _ = write!(text, " <code>{}</code>", escape(&it.command));
    }
    text
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
