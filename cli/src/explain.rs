//! `cargo bessemer explain`: the checks that are left, and why.

use std::path::Path;

use bessemer_codegen::generate::explanation;
use bessemer_project::{Wanted, compile};

use crate::args::Explain;
use crate::error::Error;

/// Lists the checks that are left in the chosen entry point, or in each.
///
/// # Errors
/// Errors of the models, or an entry point that does not exist.
pub fn run(folder: &Path, wanted: &Explain, colour: bool) -> Result<String, Error> {
    let package = wanted.package.name();
    let (_, compiled) = compile(folder, Wanted { package, colour, ..Wanted::default() })?;
    let text = explanation(&compiled);
    let Some(name) = &wanted.entry else { return Ok(text) };
    let rust = |component: &str, entry: &str| {
        // The C name ends with the author's.
        text.lines()
            .filter_map(|line| line.split_once(": "))
            .map(|(head, _)| head)
            .find(|head| {
                head.split_once("::")
                    .is_some_and(|(of, function)| of == component && entry.ends_with(function))
            })
            .unwrap_or_default()
            .to_owned()
    };
    let named: Vec<(String, String)> = compiled
        .entries
        .iter()
        .map(|entry| (entry.entry.clone(), rust(&entry.component, &entry.entry)))
        .collect();
    match named.iter().find(|(c, rust)| c == name || rust == name) {
        Some((_, head)) => Ok(section(&text, head)),
        None => Err(Error::NoEntry {
            name: name.clone(),
            known: named.into_iter().map(|(c, _)| c).collect(),
        }),
    }
}

/// The lines under the head of one entry point.
fn section(text: &str, head: &str) -> String {
    let own = |line: &&str| line.starts_with(&format!("{head}: "));
    let mut lines = text.lines().skip_while(|line| !own(line));
    let first = lines.next().unwrap_or_default();
    let rest = lines.take_while(|line| line.starts_with(' '));
    [first].into_iter().chain(rest).fold(String::new(), |text, line| text + line + "\n")
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_section_ends_with_the_next() {
        let text = "A::f: 1 check is left\n  a.rs:1:1: index: why\n\nB::f: no check is left\n\n";
        assert_eq!(super::section(text, "A::f"), "A::f: 1 check is left\n  a.rs:1:1: index: why\n");
        assert_eq!(super::section(text, "B::f"), "B::f: no check is left\n");
    }
}
