//! Call graph of an entry point as a picture: callers on the left, what they call on the right.
//!
//! Invariants: a function is to the right of each function that calls it; the same calls give the same bytes.
//! Must not know: what the functions compute, and how the page looks around the picture.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::calls::Calls;

/// Height of a row, px.
const ROW: usize = 22;

/// Width of ten letters, px.
const LETTERS: usize = 74;

/// Space between two columns, px.
const GAP: usize = 60;

/// Number of passes that bring neighbours close to each other.
const PASSES: usize = 4;

/// A function in the picture.
struct Node<'a> {
    name: &'a str,
    x: usize,
    y: usize,
    width: usize,
}

/// Returns the calls below a function as SVG, with the place of each function for its link; none if it calls nothing.
pub fn picture(calls: &Calls, entry: &str, places: &BTreeMap<&str, &str>) -> Option<String> {
    let columns = columns(calls, entry);
    if columns.len() < 2 {
        return None;
    }
    let mut nodes: BTreeMap<&str, Node> = BTreeMap::new();
    let (mut left, mut most) = (1, 0);
    let rows = columns.iter().map(Vec::len).max().unwrap_or(1);
    for column in &columns {
        let width = column.iter().map(|it| it.len()).max().unwrap_or(1) * LETTERS / 10 + 12;
        let top = (rows - column.len()) * ROW / 2;
        for (row, &name) in column.iter().enumerate() {
            nodes.insert(name, Node { name, x: left, y: top + row * ROW, width });
        }
        most = left + width;
        left = most + GAP;
    }
    let mut svg = format!(
        "<svg class=\"graph\" role=\"img\" aria-label=\"Calls below {entry}\" width=\"{}\" height=\"{}\">",
        most + 1,
        rows * ROW
    );
    for node in nodes.values() {
        for to in calls.0.get(node.name).into_iter().flatten().filter_map(|it| nodes.get(&**it)) {
            let (x, y) = (node.x + node.width, node.y + ROW / 2);
            let (end, down) = (to.x, to.y + ROW / 2);
            let middle = (x + end) / 2;
            write!(svg, "<path d=\"M{x} {y}C{middle} {y} {middle} {down} {end} {down}\"/>").ok()?;
        }
    }
    for Node { name, x, y, width } in nodes.values() {
        let place = places.get(name).unwrap_or(&"");
        write!(
            svg,
            "<a href=\"trace.html#{place}\"><rect x=\"{x}\" y=\"{}\" width=\"{width}\" height=\"{}\" rx=\"3\"/><text x=\"{}\" y=\"{}\">{name}</text></a>",
            y + 2,
            ROW - 4,
            x + 6,
            y + 15
        )
        .ok()?;
    }
    svg.push_str("</svg>");
    Some(svg)
}

/// Returns the functions below one in columns: each to the right of the last function that calls it.
fn columns<'a>(calls: &'a Calls, entry: &'a str) -> Vec<Vec<&'a str>> {
    let mut order = Vec::new();
    visit(calls, entry, &mut order);
    // Callers come before what they call.
    order.reverse();
    let mut depth: BTreeMap<&str, usize> = order.iter().map(|it| (*it, 0)).collect();
    for name in &order {
        let next = depth[name] + 1;
        for callee in calls.0.get(*name).into_iter().flatten() {
            let callee = depth.entry(callee).or_default();
            *callee = next.max(*callee);
        }
    }
    let mut columns = vec![Vec::new(); depth.values().max().map_or(0, |it| it + 1)];
    for (name, column) in depth {
        columns[column].push(name);
    }
    for _ in 0..PASSES {
        near(calls, &mut columns);
    }
    columns
}

/// Lists the functions below one, each after all that it calls.
fn visit<'a>(calls: &'a Calls, name: &'a str, order: &mut Vec<&'a str>) {
    // A stack of its own: a chain of calls may be long.
    let mut open = vec![(name, false)];
    while let Some((name, done)) = open.pop() {
        if order.contains(&name) {
            continue;
        }
        if done {
            order.push(name);
            continue;
        }
        open.push((name, true));
        let callees = calls.0.get(name).into_iter().flatten();
        open.extend(callees.filter(|it| !order.contains(&&***it)).map(|it| (&**it, false)));
    }
}

/// Orders each column by the mean row of those that call a function.
fn near(calls: &Calls, columns: &mut [Vec<&str>]) {
    let mut rows: BTreeMap<String, f64> = BTreeMap::new();
    for column in columns {
        let mean = |name: &str| {
            let callers = calls.0.iter().filter(|(_, callees)| callees.contains(name));
            let found: Vec<f64> =
                callers.filter_map(|(caller, _)| rows.get(caller).copied()).collect();
            found.iter().sum::<f64>() / found.len().max(1) as f64
        };
        let mut keyed: Vec<(f64, &str)> = column.iter().map(|name| (mean(name), *name)).collect();
        keyed.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(other.1)));
        let length = keyed.len() as f64;
        for (row, (_, name)) in keyed.iter().enumerate() {
            rows.insert((*name).to_owned(), row as f64 - length / 2.0);
        }
        *column = keyed.into_iter().map(|(_, name)| name).collect();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn calls(rows: &[(&str, &[&str])]) -> Calls {
        let row = |&(name, callees): &(&str, &[&str])| {
            (name.to_owned(), callees.iter().map(|it| (*it).to_owned()).collect::<BTreeSet<_>>())
        };
        Calls(rows.iter().map(row).collect())
    }

    #[test]
    fn a_function_is_right_of_its_callers() {
        let calls = calls(&[("f", &["g", "h"]), ("g", &["h", "i"]), ("h", &["i"]), ("x", &["f"])]);
        assert_eq!(columns(&calls, "f"), [vec!["f"], vec!["g"], vec!["h"], vec!["i"]]);
        assert_eq!(columns(&calls, "i"), [vec!["i"]]);
        let places = BTreeMap::from([("g", "g.c:1")]);
        let picture = picture(&calls, "f", &places).unwrap_or_default();
        assert_eq!((picture.matches("<rect").count(), picture.matches("<path").count()), (4, 5));
        assert!(picture.contains("trace.html#g.c:1"), "{picture}");
    }

    #[test]
    fn a_column_follows_its_callers() {
        let calls = calls(&[("f", &["a", "b"]), ("a", &["z"]), ("b", &["y"])]);
        assert_eq!(columns(&calls, "f"), [vec!["f"], vec!["a", "b"], vec!["z", "y"]]);
    }

    #[test]
    fn a_function_without_calls_has_no_picture() {
        assert_eq!(picture(&calls(&[("f", &[])]), "f", &BTreeMap::new()), None);
    }
}
