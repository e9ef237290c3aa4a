//! Remedies for words and forms of other languages: C, C++, Python and MATLAB.
//!
//! Must not know: the DSL's items; a remedy here is plain Rust.

use super::rustc::{Mark, Message};

/// Returns a remedy; none if the error is of another kind, or if rustc's remedy is better.
pub fn of(message: &Message<'_>) -> Option<String> {
    let mark = message.mark()?;
    let named = message.quoted().first().copied().unwrap_or_default();
    match message.code {
        "" if message.title.starts_with("expected") || message.title.starts_with("parameter") => {
            syntax(message.title, mark).map(str::to_owned)
        }
        "E0423" if message.title.contains("builtin type") => {
            Some(format!("write `n as {named}`, or `{named}::from(n)` for a narrower type"))
        }
        "E0425" if message.title.starts_with("cannot find function") => {
            let has_call = message.below().any(|it| it.starts_with("use the `.` operator"));
            (!has_call).then(|| function(named))?
        }
        "E0425" if matches!(named, "null" | "NULL" | "nullptr" | "nil") => {
            Some("write an `Option`, with `None` for no value".to_owned())
        }
        "E0425" if matches!(named, "NAN" | "NaN" | "INFINITY" | "inf") => {
            Some("write `f64::NAN`, `f64::INFINITY` or `f64::NEG_INFINITY`".to_owned())
        }
        "E0571" => Some(
            "declare a variable before the loop, `let mut found = None;`, write `found = Some(i); break;`, and read it behind the loop, `if let Some(i) = found { … }`; or search by `.iter().position(|x| …)`, which returns such an `Option`".to_owned(),
        ),
        "" if message.title.starts_with("invalid suffix `") => {
            let number = mark.text().trim_end_matches(|it: char| it.is_alphabetic()).to_owned();
            Some(format!("remove it: `{number}` has the type that its use requires"))
        }
        "" if message.title.starts_with("`~` cannot be used") => Some(match mark.rest().starts_with('=') {
            true => "write `!=`".to_owned(),
            false => "write `!`, which inverts a condition or the bits of an integer".to_owned(),
        }),
        _ => None,
    }
}

/// Returns the remedy for a text that is no Rust, by the word before the place where rustc stops.
fn syntax(title: &str, mark: &Mark<'_>) -> Option<&'static str> {
    let (before, marked) = (mark.before(), mark.text());
    let (before, line) = (before.trim_end(), mark.line.trim_start());
    let word = before.rsplit(|it: char| !it.is_alphanumeric() && it != '_').next();
    Some(match word.unwrap_or_default() {
        _ if title.starts_with("parameter defaults") => {
            "remove it: each call passes the value; or take an `Option<f64>`, and write `gain.unwrap_or(1.0)`"
        }
        _ if line.starts_with("for (") || line.starts_with("for(") => {
            "write a range: `for i in 0..3 { … }`"
        }
        "double" | "float" | "int" | "long" | "short" | "unsigned" | "char" | "auto" | "var" => {
            "declare a variable by `let`: `let y = …;`, or `let mut y: f64 = …;` for one that changes"
        }
        "elif" | "elseif" | "elsif" => "write `else if`",
        "switch" | "case" => "write a `match`: `match n { 0 => …, _ => … }`",
        "new" => {
            "name the fields, `Gains { p: 1.0 }`, or call a function of the type, `Gains::new(1.0)`"
        }
        "def" | "func" | "function" => "write `fn`",
        "Fn" | "FnMut" | "FnOnce" => "write `impl` before it: `law: impl Fn(f64) -> f64`",
        _ if marked == "," && line.starts_with("let ") && !before.contains(['(', '[']) => {
            "write a `let` for each variable"
        }
        _ if marked == "," && title.contains("`]`") => {
            "an element of a matrix is `m[(row, column)]`, with indices from 0"
        }
        _ if line.starts_with(['<', '>']) && before.ends_with(['<', '>', '=']) => {
            "write a condition behind a name: `x if x < 0.0 => …`"
        }
        _ => return None,
    })
}

/// Returns the method for a function of C, Python or MATLAB.
fn function(name: &str) -> Option<String> {
    let bare = match name.strip_suffix('f') {
        Some(bare) if bare.len() > 2 => bare,
        _ => name,
    };
    Some(match bare {
        "fabs" | "fab" | "abs" | "labs" => "write `x.abs()`".to_owned(),
        "sqrt" | "cbrt" | "exp" | "exp2" | "log10" | "log2" | "sin" | "cos" | "tan" | "asin"
        | "acos" | "atan" | "sinh" | "cosh" | "tanh" | "floor" | "ceil" | "round" | "trunc" => {
            format!("write `x.{bare}()`")
        }
        "log" | "ln" => "write `x.ln()`, the natural logarithm".to_owned(),
        "atan2" | "hypot" => format!("write `y.{bare}(x)`"),
        "pow" | "power" => "write `x.powi(2)` or `x.powf(y)`".to_owned(),
        "fmod" | "mod" | "rem" => {
            "write `x % y`, or `x.rem_euclid(y)`, which is not negative".to_owned()
        }
        "max" | "fmax" | "maximum" => "write `a.max(b)`".to_owned(),
        "min" | "fmin" | "minimum" => "write `a.min(b)`".to_owned(),
        "clamp" | "clip" | "constrain" | "saturate" => "write `x.clamp(low, high)`".to_owned(),
        "sign" | "sgn" | "signum" => "write `x.signum()`".to_owned(),
        "isnan" => "write `x.is_nan()`".to_owned(),
        "isfinite" => "write `x.is_finite()`".to_owned(),
        "range" => "write a range: `for i in 0..3 { … }`".to_owned(),
        "len" | "length" | "size" | "numel" => "write `values.len()`".to_owned(),
        "sum" => "write `values.iter().sum::<f64>()`".to_owned(),
        "float" | "double" => "write `n as f64`, or `f64::from(n)` for a narrower type".to_owned(),
        "int" => "write `x as i32`, which goes toward 0".to_owned(),
        _ => return None,
    })
}
