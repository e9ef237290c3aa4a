//! The functions of a `drive.rs`, by their signatures, which are on one line each: numbers, and arrays and tuples of numbers, by value.

/// A function that is called with words.
pub struct Signature {
    /// Name of the function.
    pub name: String,
    /// The types of its parameters, as written.
    pub params: Vec<String>,
}

/// Returns the public functions of a text.
///
/// # Errors
///
/// A line that begins like a function but cannot be parsed.
pub fn of(text: &str) -> Result<Vec<Signature>, String> {
    text.lines().filter(|line| line.starts_with("pub fn ")).map(read).collect()
}

fn read(line: &str) -> Result<Signature, String> {
    let wrong = || format!("drive.rs: `{line}` is no signature on one line");
    let (name, rest) = line["pub fn ".len()..].split_once('(').ok_or_else(wrong)?;
    let rest = rest.strip_suffix('{').ok_or_else(wrong)?;
    let inner = match rest.split_once(" -> ") {
        Some((inner, _)) => inner,
        None => rest.trim_end(),
    };
    let inner = inner.strip_suffix(')').ok_or_else(wrong)?;
    let mut params = Vec::new();
    let mut open = 0_usize;
    let mut start = 0;
    for (at, letter) in inner.char_indices().chain([(inner.len(), ',')]) {
        match letter {
            '[' | '(' => open += 1,
            ']' | ')' => open = open.saturating_sub(1),
            ',' if open == 0 => {
                let param = inner[start..at].trim();
                if !param.is_empty() {
                    let (_, ty) = param.split_once(": ").ok_or_else(wrong)?;
                    params.push(ty.to_owned());
                }
                start = at + 1;
            }
            _ => {}
        }
    }
    Ok(Signature { name: name.to_owned(), params })
}
