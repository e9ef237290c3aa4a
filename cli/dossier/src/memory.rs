//! Memory by lifetime as a picture: the state of a component between calls, and the stack of a call.
//!
//! Invariant: all bars have one scale, so that they compare. Must not know how the page looks around the picture.

use std::fmt::Write as _;

use crate::content::{Component, grouped};

/// Height of a row, px.
const ROW: usize = 22;
/// Width of the names, px.
const NAMES: usize = 230;
/// Width of the longest bar, px.
const BARS: u64 = 560;

/// Returns the picture; none if no component has a state or an entry point.
pub fn picture(components: &[Component]) -> Option<String> {
    let stack = |it: &Component| it.entries.iter().map(|entry| entry.stack).max().unwrap_or(0);
    let shown: Vec<&Component> = components.iter().filter(|it| !it.entries.is_empty()).collect();
    let most = shown.iter().map(|it| it.bytes.max(stack(it))).max().filter(|it| *it > 0)?;
    let height = shown.len() * 2 * ROW + ROW;
    let mut svg = format!(
        "<svg class=\"memory\" role=\"img\" aria-label=\"Memory by lifetime\" width=\"{}\" height=\"{height}\">",
        NAMES as u64 + BARS + 110
    );
    for (at, component) in shown.into_iter().enumerate() {
        let top = at * 2 * ROW;
        let (name, middle) = (&component.name, top + ROW / 2 + 4);
        write!(svg, "<text x=\"0\" y=\"{middle}\">{name}</text>").ok()?;
        let bars = [("state", component.bytes), ("stack", stack(component))];
        for (row, (class, bytes)) in bars.into_iter().enumerate() {
            let y = top + row * ROW * 2 / 3;
            let width = (bytes * BARS).div_ceil(most);
            write!(
                svg,
                "<rect class=\"{class}\" x=\"{NAMES}\" y=\"{}\" width=\"{width}\" height=\"{}\"/>\
                 <text class=\"figure\" x=\"{}\" y=\"{}\">{}</text>",
                y + 3,
                ROW / 2,
                NAMES as u64 + width + 6,
                y + ROW / 2 + 3,
                grouped(bytes)
            )
            .ok()?;
        }
    }
    svg.push_str("</svg>");
    Some(svg)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::content::Entry;

    fn component(name: &str, bytes: u64, stack: u64) -> Component {
        let entry = Entry {
            name: format!("{name}_step"),
            rust: String::new(),
            docs: String::new(),
            parameters: Vec::new(),
            stack,
            state: bytes,
            wide: (0, 0),
            instructions: String::new(),
            cycles: Vec::new(),
            left: Vec::new(),
            reached: 0,
            graph: None,
        };
        Component {
            name: name.to_owned(),
            rust: String::new(),
            docs: String::new(),
            header: String::new(),
            bytes,
            fields: Vec::new(),
            entries: vec![entry],
        }
    }

    /// The longest bar has the full width, and each other one its share.
    #[test]
    fn bars_have_one_scale() {
        let svg =
            picture(&[component("motor", 80, 20), component("gate", 0, 40)]).expect("a picture");
        for width in [560, 140, 0, 280] {
            assert!(svg.contains(&format!(" width=\"{width}\" height=\"11\"")), "{width}: {svg}");
        }
        assert_eq!(picture(&[component("empty", 0, 0)]), None);
    }
}
