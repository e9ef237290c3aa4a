//! The author's comments as comments of C, without links of rustdoc and without ends of comments in them.

/// Returns the author's lines as lines of a C comment, without empty ones at either end.
pub fn comment_lines(lines: &[String]) -> Vec<String> {
    let lines = lines.iter().filter(|line| !defines_link(line)).map(|line| comment_text(line));
    let mut lines: Vec<String> = lines.skip_while(String::is_empty).collect();
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    lines
}

/// Returns true if a line defines a link, `` [`name`]: path ``, which rustdoc does not show.
fn defines_link(line: &str) -> bool {
    let named = line.trim_start().strip_prefix('[').and_then(|line| line.split_once("]:"));
    named.is_some_and(|(name, path)| !name.contains(']') && path.split_whitespace().count() == 1)
}

/// Removes `crate`, `super` and `self` from a Rust path, since C has no such names.
fn without_roots(mut code: &str) -> String {
    code = code.strip_prefix('`').unwrap_or(code);
    while let Some((_, names)) =
        code.split_once("::").filter(|(root, _)| ["crate", "super", "self"].contains(root))
    {
        code = names;
    }
    format!("`{code}")
}

/// Replaces links by their text: `[text](path)` and `` [`name`] ``.
fn without_links(line: &str) -> String {
    let (mut text, mut rest) = (String::new(), line);
    while let Some(start) = rest.find('[') {
        let (before, link) = rest.split_at(start);
        text.push_str(before);
        let end = link.find(']').map(|end| (&link[1..end], &link[end + 1..]));
        let is_code =
            |inner: &str| inner.len() > 2 && inner.starts_with('`') && inner.ends_with('`');
        match end {
            Some((inner, behind)) if behind.starts_with('(') && behind.contains(')') => {
                text.push_str(inner);
                rest = behind.split_once(')').map_or("", |(_, rest)| rest);
            }
            Some((inner, behind)) if is_code(inner) => {
                text.push_str(&without_roots(inner));
                rest = behind;
            }
            _ => {
                text.push('[');
                rest = &link[1..];
            }
        }
    }
    text + rest
}

/// Returns a line of the author's comment with `*/` and the like separated, which would end a C comment.
pub fn comment_text(line: &str) -> String {
    without_links(line.strip_prefix(' ').unwrap_or(line))
        .trim_end()
        .replace("*/", "* /")
        .replace("/*", "/ *")
        // Twice: of three in a row, the first two take the second from the third.
        .replace("??", "? ?")
        .replace("??", "? ?")
        .replace('\t', "    ")
}

#[cfg(test)]
mod tests {
    use super::{comment_lines, without_links};

    #[test]
    fn comments_have_no_definitions_of_links() {
        let lines = ["", " Of [`a`].", "", " [`a`]: super::b::a", " [a]: it is", ""];
        let lines = lines.map(str::to_owned);
        assert_eq!(comment_lines(&lines), ["Of `a`.", "", "[a]: it is"]);
        assert_eq!(comment_lines(&lines[2..4]), [""; 0]);
    }

    #[test]
    fn comments_have_no_links_of_rustdoc() {
        for (line, text) in [
            (
                "see [`LowPass`], and [`rotation`](Orientation::rotation).",
                "see `LowPass`, and `rotation`.",
            ),
            ("[the page](https://a.b/c) says", "the page says"),
            ("as [`crate::cascade`], [`super::super::a::b`]", "as `cascade`, `a::b`"),
            ("from [0, 1) on, a[3] of `b[i]` [and", "from [0, 1) on, a[3] of `b[i]` [and"),
        ] {
            assert_eq!(without_links(line), text);
        }
    }
}
