//! Finds the author's expressions for the fields of a hand-written `Default`, for comments in the C. The `impl` has
//! no attribute, so no macro sees it, and rustc provides only the resulting numbers.
//!
//! Only one form is read: `impl Default for Name` whose `default` is one struct literal. Any other form yields no
//! expressions. Must not know: what the expressions mean.

/// Longest expression that a comment quotes, in characters.
const LONGEST: usize = 72;

/// Returns the computed fields of the default of `name`, each with its expression.
pub(super) fn computed(text: &str, name: &str) -> Vec<(String, String)> {
    let text = without_comments(text);
    literal(&text, name).map(fields).unwrap_or_default()
}

/// Returns the text between the braces of the literal.
fn literal<'t>(text: &'t str, name: &str) -> Option<&'t str> {
    let head = format!("impl Default for {name}");
    let mut found =
        text.match_indices(&head).filter_map(|(at, _)| braced(&text[at + head.len()..]));
    let (body, _) = found.next().filter(|_| found.next().is_none())?;
    let (_, function) = body.split_once("fn default()")?;
    let (_, block) = function.split_once("->")?;
    let (block, _) = braced(&block[block.find('{')?..])?;
    let block = block.trim();
    let inner = block.strip_prefix("Self").or_else(|| block.strip_prefix(name))?;
    braced(inner).filter(|(_, rest)| rest.trim().is_empty()).map(|(literal, _)| literal)
}

/// Returns the text in the braces at the beginning of a text, and the rest.
fn braced(text: &str) -> Option<(&str, &str)> {
    let inner = text.trim_start().strip_prefix('{')?;
    let mut depth = 1;
    for (at, next) in inner.char_indices() {
        depth += match next {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        if depth == 0 {
            return Some((&inner[..at], &inner[at + 1..]));
        }
    }
    None
}

/// Returns the fields of a struct literal whose values contain a computation, each with its expression.
fn fields(literal: &str) -> Vec<(String, String)> {
    let mut parts = vec![String::new()];
    let mut depth = 0;
    for next in literal.chars() {
        depth += match next {
            '(' | '[' | '{' => 1,
            ')' | ']' | '}' => -1,
            _ => 0,
        };
        match parts.last_mut() {
            _ if next == ',' && depth == 0 => parts.push(String::new()),
            Some(part) => part.push(next),
            None => {}
        }
    }
    let field = |part: &String| {
        let (name, value) = part.split_once(':')?;
        let name = name.trim();
        let is_name = name.chars().all(|next| next.is_alphanumeric() || next == '_');
        let value = value.split_whitespace().collect::<Vec<_>>().join(" ");
        // What has fields, type arguments, texts or comments in it is left out.
        let odd = value.replace("::", "").contains(['<', '"', ':'])
            || ["/*", "*/"].iter().any(|mark| value.contains(mark));
        let fits = value.chars().count() <= LONGEST && !odd;
        (is_name && fits && computes(&value)).then(|| (name.to_owned(), value))
    };
    parts.iter().filter_map(field).collect()
}

/// Returns true if an expression computes something. It calls a function that is no constructor, has a binary operator,
/// or names a constant that is no length.
fn computes(value: &str) -> bool {
    let value = value.split(';').next().unwrap_or_default();
    let operators = [" + ", " - ", " * ", " / ", " % ", " << ", " >> ", " | ", " & ", " ^ "];
    operators.iter().any(|operator| value.contains(operator)) || calls(value) || constant(value)
}

fn calls(value: &str) -> bool {
    value.match_indices('(').any(|(at, _)| {
        let called = |next: char| !next.is_alphanumeric() && next != '_';
        let callee = value[..at].rsplit(called).next().unwrap_or_default();
        let constructs = callee == "new" || callee.starts_with(char::is_uppercase);
        !callee.is_empty() && !constructs && !value[at + 1..].starts_with(')')
    })
}

fn constant(value: &str) -> bool {
    let within = |next: char| next.is_alphanumeric() || matches!(next, '_' | ':');
    value.split(|next| !within(next)).any(|path| {
        let name = path.rsplit(':').next().unwrap_or_default();
        name.len() > 1
            && name.starts_with(char::is_uppercase)
            && !name.chars().any(char::is_lowercase)
    })
}

/// Returns a text in one line without its `//` comments.
fn without_comments(text: &str) -> String {
    let line = |line: &str| line.split("//").next().unwrap_or_default().to_owned();
    text.lines().map(line).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::computed;

    const FILTER: &str = "
        impl Default for Filters { fn default() -> Self { Filters { gain: 2.0 * GAIN } } }
        impl Default for Filter {
            /// At rest.
            fn default() -> Self {
                Filter {
                    axes: [Axis::at_rest(3.0, 0.3); 3], // Each.
                    level: Level::default(),
                    force: Vector3::new(0.0, 0.0, GRAVITY),
                    row: Vector3::new(0.0, 0.0, 1.0),
                    room: [0.0; WIDTH],
                    gain: -1.0 / 6.0,
                    shown: true,
                }
            }
        }";

    #[test]
    fn computed_fields_are_told() {
        let told = computed(FILTER, "Filter");
        let told: Vec<(&str, &str)> =
            told.iter().map(|(name, value)| (name.as_str(), value.as_str())).collect();
        let wanted = [
            ("axes", "[Axis::at_rest(3.0, 0.3); 3]"),
            ("force", "Vector3::new(0.0, 0.0, GRAVITY)"),
            ("gain", "-1.0 / 6.0"),
        ];
        assert_eq!(told, wanted);
    }

    /// Any other form of `default`, or none, yields no expressions.
    #[test]
    fn other_forms_say_nothing() {
        for text in [
            "",
            "impl Default for A",
            "impl Default for A { fn default() -> A { let a = 3 * N; A { a } } }",
            "impl Default for A { fn default() -> A { A::of(2) } }",
            "impl Default for A { fn default() -> A { A { a: 2 * 3 ",
            "impl Default for A { fn default() -> A { A { a: 2 * 3 } } } impl Default for A { fn default() -> A { A { a: 1 } } }",
        ] {
            assert_eq!(computed(text, "A"), [], "{text}");
        }
    }
}
