//! Converts Rust names to C names.

use std::collections::BTreeMap;

use bessemer_ir::{Int, Scalar};

/// Converts a Rust identifier to a C identifier: ASCII letters, digits and `_`.
pub fn identifier(name: &str) -> String {
    let name = name.strip_prefix("r#").unwrap_or(name);
    let mut out = String::new();
    for letter in name.chars() {
        match letter {
            'a'..='z' | 'A'..='Z' | '0'..='9' | '_' => out.push(letter),
            _ => match greek(letter) {
                Some(word) => out.push_str(word),
                None if letter.is_alphanumeric() => {
                    out.push_str(&format!("u{:04x}", letter as u32))
                }
                None => out.push('_'),
            },
        }
    }
    // A leading `_` says that Rust must not complain; in C it is reserved.
    let out = match out.trim_start_matches('_') {
        "" => "unused".to_owned(),
        rest => rest.to_owned(),
    };
    if out.starts_with(|letter: char| letter.is_ascii_digit()) { format!("n{out}") } else { out }
}

/// Converts `PidGains` to `pid_gains`, `LQR` to `lqr`, `Axis3D` to `axis3_d`.
pub fn snake(name: &str) -> String {
    let letters: Vec<char> = identifier(name).chars().collect();
    let mut out = String::new();
    for (index, letter) in letters.iter().enumerate() {
        let before = index.checked_sub(1).map(|at| letters[at]);
        let after = letters.get(index + 1);
        let starts_word = letter.is_ascii_uppercase()
            && before.is_some_and(|before| {
                before.is_ascii_lowercase()
                    || before.is_ascii_digit()
                    || before.is_ascii_uppercase() && after.is_some_and(char::is_ascii_lowercase)
            });
        if starts_word {
            out.push('_');
        }
        out.push(letter.to_ascii_lowercase());
    }
    out
}

/// Converts `TakeOff` to `TAKE_OFF`.
pub fn screaming(name: &str) -> String {
    snake(&if name.chars().any(char::is_lowercase) { name.to_owned() } else { name.to_lowercase() })
        .to_uppercase()
}

/// Returns the segments of a module path below the crate, or the crate for its root.
pub fn relative(path: &str) -> Vec<String> {
    let segments: Vec<String> = path.split("::").map(snake).collect();
    if segments.len() > 1 { segments[1..].to_vec() } else { segments }
}

/// Returns the number of requests for each name.
pub fn wanted(names: impl Iterator<Item = String>) -> BTreeMap<String, usize> {
    let mut wanted = BTreeMap::new();
    names.for_each(|name| *wanted.entry(name).or_default() += 1);
    wanted
}

/// Returns the last segment of a module path.
pub fn last_segment(path: &str) -> String {
    relative(path).pop().unwrap_or_default()
}

fn greek(letter: char) -> Option<&'static str> {
    const SMALL: [&str; 25] = [
        "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
        "lambda", "mu", "nu", "xi", "omicron", "pi", "rho", "sigma", "sigma", "tau", "upsilon",
        "phi", "chi", "psi", "omega",
    ];
    const CAPITAL: [&str; 25] = [
        "Alpha", "Beta", "Gamma", "Delta", "Epsilon", "Zeta", "Eta", "Theta", "Iota", "Kappa",
        "Lambda", "Mu", "Nu", "Xi", "Omicron", "Pi", "Rho", "", "Sigma", "Tau", "Upsilon", "Phi",
        "Chi", "Psi", "Omega",
    ];
    let at = |first: char| (letter as u32).checked_sub(first as u32).map(|offset| offset as usize);
    let pick =
        |table: &[&'static str; 25], first| at(first).and_then(|offset| table.get(offset).copied());
    pick(&SMALL, 'α').or_else(|| pick(&CAPITAL, 'Α'))
}

/// Returns the C type of a scalar.
pub fn scalar_type(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::Bool => "bool",
        Scalar::Float(bessemer_ir::Float::F32) => "float",
        Scalar::Float(bessemer_ir::Float::F64) => "double",
        Scalar::Int(int) => match int {
            Int::I8 => "int8_t",
            Int::I16 => "int16_t",
            Int::I32 => "int32_t",
            Int::I64 | Int::Isize => "int64_t",
            Int::U8 => "uint8_t",
            Int::U16 => "uint16_t",
            Int::U32 => "uint32_t",
            Int::U64 | Int::Usize => "uint64_t",
        },
    }
}

/// Returns the first free name of `name`, `name_2`, `name_3`, ….
pub fn unique(name: &str, taken: impl Fn(&str) -> bool) -> String {
    unique_from(name, FIRST_NUMBER, taken).0
}

/// Number of the second variable of a name.
pub const FIRST_NUMBER: u32 = 2;

/// Returns the first free name, and its number if it has one; those with a lower number than `first` are taken.
pub fn unique_from(name: &str, first: u32, taken: impl Fn(&str) -> bool) -> (String, Option<u32>) {
    if !taken(name) {
        return (name.to_owned(), None);
    }
    let stem = stem(name);
    let candidates = (first..).map(|number| (format!("{stem}{number}"), Some(number)));
    candidates.into_iter().find(|(candidate, _)| !taken(candidate)).expect("numbers do not end")
}

/// Returns the part of a numbered name before its number: `x_` for `x` and for `x_`.
pub fn stem(name: &str) -> String {
    if name.ends_with('_') { name.to_owned() } else { format!("{name}_") }
}

/// Returns the stem and the number of a numbered name.
pub fn numbered(name: &str) -> Option<(&str, u32)> {
    let stem = name.trim_end_matches(|last: char| last.is_ascii_digit());
    Some((stem, name[stem.len()..].parse().ok()?))
}
