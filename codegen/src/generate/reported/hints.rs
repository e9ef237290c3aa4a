//! Remedies for rustc's errors about plain Rust, where rustc's own help does not fit a model, or is missing.

use super::rustc::{Mark, Message};
use super::{habits, remedies, types};

/// Returns a remedy; none if rustc's is better.
pub fn of(message: &Message<'_>) -> Option<String> {
    let (title, quoted) = (message.title, message.quoted());
    let marked = message.mark().map(Mark::text).unwrap_or_default();
    let habit = habits::of(message);
    if habit.is_some() {
        return habit;
    }
    let help = match message.code {
        "E0277" if title.ends_with("is not supported") => {
            message.below().find(|it| it.starts_with("write "))?.to_owned()
        }
        "E0277" if title.starts_with("cannot ") => operands(&quoted, message.mark()?)?,
        "E0277" if title.contains("f64: Eq`") || title.contains("f32: Eq`") => {
            "remove `Eq`: a float is not equal to itself if it is NaN, so it has `PartialEq` alone".to_owned()
        }
        "E0277" if title.starts_with("the trait bound") && title.contains(": From<") => converted(&from_bound(title)?)?,
        "E0277" if title.ends_with("size` is not an iterator") => {
            "write a range: `for i in 0..values.len()`".to_owned()
        }
        "E0282" | "E0283" if matches!(&*marked, "sum" | "product") => {
            format!("name the type of the result: `.{marked}::<f64>()`")
        }
        "E0282" | "E0283" if ["(derivative(", "(gradient("].iter().any(|it| message.mark().is_some_and(|mark| mark.line.contains(it))) => {
            format!("differentiate an instance: a function without type parameters that calls `{marked}`")
        }
        "E0277" if title.contains("f64: Ord") || title.contains("f32: Ord") => match &*marked {
            "max" => "floats have no greatest with NaN among them: `.fold(f64::NEG_INFINITY, |a, b| a.max(b))`",
            "min" => "floats have no least with NaN among them: `.fold(f64::INFINITY, |a, b| a.min(b))`",
            _ => ORDER,
        }
        .to_owned(),
        "E0107" if title.starts_with("missing generics for ") => {
            let ty = marked.split('<').next().unwrap_or_default();
            match message.mark()?.line.trim_start().starts_with("impl") {
                true => format!("write `impl<T> {ty}<T>` for every type, or `impl {ty}<f64>` for one"),
                false => format!("name the type that it is for: `{ty}<f64>`"),
            }
        }
        "E0782" if title == "expected a type, found a trait" && !message.mark()?.line.contains("fn ") => {
            generic(&marked)
        }
        "E0369" if quoted.len() == 2 && quoted.iter().all(|it| types::is_parameter(it)) => {
            format!("require it of the type parameter: `{}: Real` for floats, or a bound of `core::ops`, such as `core::ops::Add<Output = {}>`", quoted[1], quoted[1])
        }
        "E0061" if marked.starts_with("Self::") && message.marked_below().any(|it| it.text().contains("self") || it.line.contains("self,")) => {
            format!("a method is called on its value: `self.{}(…)`", marked.trim_start_matches("Self::"))
        }
        "overflowing_literals" if message.is_error => {
            "name a type that holds the number, such as `u16` or `u32`, here and where the value goes".to_owned()
        }
        "E0308" => converted(message.mark()?.label).or_else(|| mismatched(message.mark()?))?,
        "E0061" if matches!(&*marked, "round" | "floor" | "ceil" | "trunc") => {
            format!("write `(100.0 * x).{marked}() / 100.0` for two digits")
        }
        "E0061" if matches!(&*marked, "min" | "max") => {
            format!("write it once for each: `a.{marked}(b).{marked}(c)`")
        }
        "E0599" if quoted.first() == Some(&"clone") && title.contains("struct") => COPY.to_owned(),
        "E0277" if title.ends_with(": Copy` is not satisfied") => COPY.to_owned(),
        "E0382" if message.rendered.contains("consider restricting type parameter")
            || message.rendered.contains("consider further restricting type parameter")
            || message.rendered.contains("move occurs because") && has_parameter(message) =>
        {
            "require it of the type parameter: `T: Copy`, or a bound that implies it, such as `T: Real`".to_owned()
        }
        "E0382" if message.rendered.contains("implicit call to `.into_iter()`") => {
            let name = quoted.first().copied().unwrap_or("values");
            format!("loop by reference: `for value in &{name}`, or `in {name}.by_ref()` if it is an iterator")
        }
        "E0382" | "E0507" if message.rendered.contains("does not implement the `Copy` trait") => {
            format!("{COPY}; or pass it by reference: `&{marked}`")
        }
        "E0277"
            if title.ends_with(": Default` is not satisfied")
                && message.marked_below().any(|it| it.line.contains("enum ")) =>
        {
            "derive it, `#[derive(Default)]` below `#[data]`, and write `#[default]` above a variant".to_owned()
        }
        "E0277" if title.contains("]: Default` is not satisfied") => {
            "Rust has no `Default` of arrays of more than 32 elements: write the value, `[0.0; 40]`; below an attribute of the DSL `#[derive(Default)]` takes such fields".to_owned()
        }
        "E0277" if title.contains("cannot be built directly from an iterator") => {
            "map the array itself, `values.map(|x| 2.0 * x)`, or write `core::array::from_fn(|i| …)`".to_owned()
        }
        "E0067" | "E0070" => {
            format!("a constant does not change: {}", types::STATE)
        }
        "E0499" if message.rendered.contains("[_]") => {
            "write `values.swap(0, 1)` for an exchange, and `values.split_at_mut(1)` for parts that are changed at once".to_owned()
        }
        "E0600" if title.contains("`f64`") || title.contains("`f32`") => {
            "compare the number: `x == 0.0`".to_owned()
        }
        "E0369" if title.contains("f64 >> ") || title.contains("f32 >> ") => {
            "divide, or multiply by a power of two: `0.5 * x`".to_owned()
        }
        "E0369" if title.contains("f64 << ") || title.contains("f32 << ") => {
            "multiply by a power of two: `2.0 * x`".to_owned()
        }
        "E0609" if quoted.first() == Some(&"T") => "write `m.transpose()`".to_owned(),
        "E0609" if quoted.get(1).is_some_and(|it| it.contains("Vector<") || it.contains("Matrix<")) => {
            "an element of a vector is `v[0]`, of a matrix `m[(row, column)]`".to_owned()
        }
        "E0608" if message.mark()?.before().ends_with(']') => {
            "write `m[(row, column)]`, with indices from 0".to_owned()
        }
        "E0608" if title.ends_with("type `()`") => {
            "this value is the result of a call that changes its variable in place: write the call alone, and use the variable after it".to_owned()
        }
        "E0277" if title.contains("Range<f") && message.rendered.contains("introduced by this call") => {
            ENDS.to_owned()
        }
        "E0277" if title.contains("Range<{float}>") => {
            "count with integers: `for i in 0..10 { let x = 0.1 * f64::from(i); … }`".to_owned()
        }
        "E0277" if title.contains("cannot be indexed by") => {
            "an index is a `usize`: `values[i as usize]`, or declare it as one".to_owned()
        }
        "E0277" if title.starts_with("`?` couldn't convert") => {
            let from = message.mark()?.label.split('`').nth(1).unwrap_or("From<…>").to_owned();
            let target = quoted.get(1)?;
            format!("implement the conversion, `#[data] impl {from} for {target} {{ … }}`, or map the error: `.map_err(|_| …)?`")
        }
        "E0277" if title.starts_with("the `?` operator can only") => {
            "let the function return a `Result` or an `Option`, or unwrap the value: `.unwrap_or(0.0)`".to_owned()
        }
        "E0369" if title.contains("f64 ^") || title.contains("f32 ^") => POWER.to_owned(),
        "E0614" if marked.starts_with('*') && message.mark()?.before().ends_with("* ") => POWER.to_owned(),
        "E0614" if matches!(quoted.first(), Some(&("f64" | "f32"))) && !marked.starts_with("**") && !marked.starts_with("* ") => {
            "remove the `*`: the number is no reference".to_owned()
        }
        "E0614" if marked.starts_with("**") || marked.starts_with("* ") => POWER.to_owned(),
        "E0369" => operator(message, &quoted)?,
        "E0605" => {
            let [from, to] = quoted.get(..2)? else { return None };
            format!("destructure the value with `match`, or implement the conversion: `#[data] impl TryFrom<{from}> for {to} {{ … }}`")
        }
        "E0425" => match *quoted.first()? {
            "M_PI" | "PI" | "pi" => "write `core::f64::consts::PI`".to_owned(),
            _ if title.starts_with("cannot find type") && !has_remedy(message) => {
                "declare it here, or import it by `use`; the blocks of the library are in the crate `bessemer_blocks`".to_owned()
            }
            _ => return None,
        },
        "E0432" | "E0433" if message.rendered.contains("unlinked crate") && quoted.last() == Some(&"nalgebra") => {
            "the prelude has nalgebra's types, `Vector3::new(…)`; others are in `bessemer::nalgebra`".to_owned()
        }
        "E0432"
            if remedies::is_known_crate(quoted.first()?)
                && !message.rendered.contains("a similar path exists") =>
        {
            remedies::of_crate(quoted.first()?).to_owned()
        }
        "E0433" => match *quoted.first()? {
            "rand" | "fastrand" | "getrandom" => {
                "pass random values to the entry point as an argument".to_owned()
            }
            "libm" => "call the method: `x.sin()`; its bits are the same in Rust and C".to_owned(),
            _ => return None,
        },
        "E0435" => {
            "the length of an array must be a constant, `[0.0; 16]`; use a `List<f64, 16>` for a varying number of elements".to_owned()
        }
        "E0599" if quoted.first() == Some(&"norm") && title.contains("Complex") => {
            "write `z.abs()`, or `bessemer::complex::norm(&z)`".to_owned()
        }
        "E0599" if title.contains("<{integer}") => {
            "write the numbers with a point: `Vector3::new(1.0, 2.0, 3.0)`".to_owned()
        }
        "E0599" if quoted.first() == Some(&"eye") => "write `identity()`".to_owned(),
        "E0599" if quoted.first() == Some(&"append") => "write `list.push(x)`".to_owned(),
        "E0599" if quoted.first() == Some(&"push") && title.contains("array") => {
            "an array has a fixed number of elements: write `values[i] = x`, or declare a `List<f64, 4>`".to_owned()
        }
        "E0599" if title.ends_with("]` is not an iterator") => {
            format!("iterate over the elements: `values.iter().{marked}()`, of a sum also its type, `.sum::<f64>()`")
        }
        "E0599" if quoted.get(1).is_some_and(|it| matches!(*it, "f64" | "f32")) => match *quoted.first()? {
            "pow" => POWER.to_owned(),
            "sqr" | "square" | "squared" => "write a square as `x * x`".to_owned(),
            "sind" | "cosd" | "tand" => "convert the angle: `x.to_radians().sin()`".to_owned(),
            "saturating_add" | "saturating_sub" | "saturating_mul" => {
                "floats do not overflow: add, and keep the sum within limits with `.clamp(low, high)`".to_owned()
            }
            _ if message.own_help().is_none() => {
                "floats have no such method: write a function marked `#[function]`".to_owned()
            }
            _ => return None,
        },
        "E0658" if title.contains("unstable library feature") => {
            "this item is not in stable Rust: write it out in a function marked `#[function]`".to_owned()
        }
        _ => return None,
    };
    Some(help)
}

/// Remedy for a range where a value is expected.
pub const ENDS: &str = "name its two ends: `core::ops::Range { start: a, end: b }`";

const COPY: &str = "derive `Copy`: write `#[derive(Clone, Copy)]` below `#[data]`";

/// Remedy for an order of floats.
pub const ORDER: &str =
    "order floats by `total_cmp`: `values.sort_unstable_by(|a, b| a.total_cmp(b))`";

/// Returns true if a moved value is of a type parameter.
fn has_parameter(message: &Message<'_>) -> bool {
    let moved = message.rendered.split("has type `").nth(1);
    moved.and_then(|it| it.split('`').next()).is_some_and(types::is_parameter)
}

/// Returns the remedy for a value of another kind than required, judging by rustc's label.
fn mismatched(mark: &Mark<'_>) -> Option<String> {
    let (wanted, found) = mark.label.strip_prefix("expected ")?.split_once(", found ")?;
    let is_float = |it: &str| matches!(it, "`f64`" | "`f32`");
    let is_integer = |it: &str| it == "integer" || it.starts_with("`i") || it.starts_with("`u");
    let is_optional = |it: &str| it.starts_with("`Option<");
    let remedy = match () {
        () if wanted == "`bool`" && is_float(found) => "compare the number: `x != 0.0`",
        () if wanted == "`bool`" && is_integer(found) && mark.line.contains("&&") => {
            "`&` joins bits and `&&` conditions: `flags & 0x03 != 0`"
        }
        () if wanted == "`bool`" && is_integer(found) && mark.line.contains("||") => {
            "`|` joins bits and `||` conditions: `(a | b) != 0`"
        }
        () if wanted == "`bool`" && is_integer(found) => "compare the number: `x != 0`",
        () if is_float(wanted) && found == "integer" => {
            let text = mark.text();
            return Some(match text.chars().all(|it| it.is_ascii_digit()) {
                true => format!("write the number with a point: `{text}.0`"),
                false => "write the numbers with a point: `1.0 / 100.0`".to_owned(),
            });
        }
        () if wanted == "`Ordering`" && found == "`bool`" => {
            "compare by `total_cmp`: `|a, b| a.total_cmp(b)`"
        }
        () if wanted.starts_with("`&") && found == "floating-point number" => {
            "dereference the other side, `**x > 0.0`, or destructure the parameter: `|&&x| x > 0.0`"
        }
        () if is_float(wanted) && found.starts_with("`Matrix<") => {
            "of two vectors write `a.dot(&b)`; an element is `v[0]` or `m[(row, column)]`"
        }
        () if wanted.starts_with("`[") && !wanted.contains(';') && found.contains("; ") => {
            "copy the elements: `target[0..2].copy_from_slice(&source)`"
        }
        () if wanted.starts_with("`[u8; ") && found == "`[u8]`" => {
            "write its elements, `[bytes[0], bytes[1], bytes[2], bytes[3]]`; or `bytes.first_chunk::<4>()`, which returns an `Option`"
        }
        () if found == "`()`" && wanted != "`bool`" && mark.text().contains(" = ") => {
            "an assignment has no value: write each by itself"
        }
        () if wanted.starts_with("type parameter") && found == "floating-point number" => {
            "write `real(0.5)`, the literal of a type `T: Real`"
        }
        () if is_optional(found) => {
            "unwrap the value: `if let Some(value) = … { … }`, `.copied().unwrap_or(0.0)`"
        }
        () if is_optional(wanted) => {
            "unwrap the other value: `if let Some(value) = … { … }`, `.is_some_and(|value| *value > 0.0)`"
        }
        () => return None,
    };
    Some(remedy.to_owned())
}

/// Returns rustc's label for a conversion that `From` does not have, from a title such as `u8: From<f64>`.
fn from_bound(title: &str) -> Option<String> {
    let (to, from) = title.split('`').nth(1)?.split_once(": From<")?;
    Some(format!("expected `{to}`, found `{}`", from.trim_end_matches('>')))
}

/// Returns the remedy for an interface where a type is required.
fn generic(interface: &str) -> String {
    format!(
        "name a type that implements `{interface}`; or let the type around it be generic, `struct Control<L> {{ law: L }}` with `impl<L: {interface}> Control<L>`, and name its instances, `pub type GainControl = Control<Gain>;`, each marked as the type is"
    )
}

/// Returns true if rustc says more than the error.
fn has_remedy(message: &Message<'_>) -> bool {
    message.below().next().is_some()
}

/// Returns the remedy for a number of another type than expected.
fn converted(label: &str) -> Option<String> {
    let mut quoted = label.split('`').skip(1).step_by(2);
    let (to, from) = (quoted.next()?, quoted.next()?);
    let bits = |it: &str| match it {
        "usize" | "isize" => Some(64),
        _ => it.get(1..)?.parse::<u32>().ok().filter(|_| it.starts_with(['i', 'u', 'f'])),
    };
    let (wanted, given) = (bits(to)?, bits(from)?);
    let is_float = |it: &str| it.starts_with('f');
    // A float holds integers of fewer bits than its own; a signed type holds those of fewer bits.
    let fits = match (is_float(to), is_float(from)) {
        (false, true) => false,
        _ => given < wanted && !(from.starts_with('i') && to.starts_with('u')),
    };
    Some(if fits && !to.ends_with("size") {
        format!("convert it: `{to}::from(…)`")
    } else if is_float(from) && !is_float(to) {
        format!(
            "convert it: `… as {to}`, which goes toward 0 and stays within the limits of `{to}`"
        )
    } else if is_float(to) {
        format!("convert it: `… as {to}`, which rounds")
    } else {
        format!(
            "convert the narrower number with `from`; or `{to}::try_from(…)`, which reports a value that does not fit, or `… as {to}`, which truncates bits"
        )
    })
}

const POWER: &str = "write a power as `x.powi(2)` or `x.powf(y)`, and a square as `x * x`";

/// Returns the remedy for an operator on numbers of two types, or on a number and a matrix.
fn operands(quoted: &[&str], mark: &Mark<'_>) -> Option<String> {
    let [one, other] = quoted.get(..2)? else { return None };
    let is_float = |it: &&&str| matches!(**it, "f64" | "f32" | "{float}");
    let is_integer = |it: &&&str| it.len() < 6 && it.starts_with(['i', 'u']);
    let both = [one, other];
    let float = both.iter().find(|it| is_float(it));
    let integer = both.iter().find(|it| is_integer(it));
    if float.is_some() && both.contains(&&"{integer}") {
        let rest = mark.rest();
        let digits = rest.trim_start().split(|it: char| !it.is_ascii_digit()).next();
        let number = digits.filter(|it| !it.is_empty()).unwrap_or("2");
        return Some(format!("write the number with a point: `{number}.0`"));
    }
    if let (Some(float), Some(integer)) = (float, integer) {
        let float = if **float == "{float}" { "f64" } else { float };
        return Some(match **integer {
            "i64" | "u64" | "isize" | "usize" => {
                format!("convert it: `count as {float}`, which rounds numbers above 2^53")
            }
            _ => format!("convert it: `{float}::from(count)`"),
        });
    }
    if both.iter().any(|it| it.contains("Matrix<")) && float.is_some() {
        return Some(
            "write `m.add_scalar(x)` or `m.map(|e| e + x)`, which apply to each element".to_owned(),
        );
    }
    None
}

/// Returns the remedy for an operator that an author's type lacks, or on an `Option` or a `Result`.
fn operator(message: &Message<'_>, quoted: &[&str]) -> Option<String> {
    let absent = quoted.iter().find(|it| it.starts_with("Option<") || it.starts_with("Result<"));
    if absent.is_some() {
        return Some(
            "unwrap the value first: `if let Some(value) = … { … }`, or `.unwrap_or(other)`"
                .to_owned(),
        );
    }
    let missing = message.below().find_map(|it| it.strip_prefix("an implementation of `"))?;
    let (of, ty) = missing.split_once("` might be missing for `")?;
    let ty = ty.trim_end_matches('`');
    (of != "PartialEq" && of != "PartialOrd").then(|| {
        format!("implement the operator: `#[data] impl {of} for {ty} {{ … }}`, for values of a `Copy` type")
    })
}

/// Returns message and remedy for matrices of different dimensions. rustc's message names the traits by which
/// nalgebra compares dimensions.
pub fn dimensions(message: &Message<'_>) -> Option<(String, String)> {
    if !message.title.contains("ShapeConstraint") {
        return None;
    }
    let notes: Vec<String> = message.below().map(types::shown).collect();
    let written = || {
        let title = types::shown(message.title);
        let (_, sizes) = title.split_once("DimEq<Const<")?;
        let (one, other) = sizes.split_once(">, Const<")?;
        let (one, other) = (one.to_owned(), other.split('>').next()?.to_owned());
        Some((
            format!("these matrices do not fit: a dimension is {one} in one and {other} in the other"),
            "a product needs as many columns on the left as rows on the right, and a sum equal sizes; of two vectors write `a.dot(&b)` or `a.component_mul(&b)`, and transpose with `a.transpose()` or `a.tr_mul(&b)`".to_owned(),
        ))
    };
    let found = notes.iter().find_map(|note| {
        note.strip_prefix("required for `")?
            .split_once("` to implement `")
            .filter(|(_, it)| it.contains('<'))
            .filter(|(left, _)| !left.contains("ShapeConstraint"))
    });
    let Some((left, operation)) = found else { return written() };
    let (of, right) = operation.trim_end_matches('`').split_once('<')?;
    let right = right.strip_suffix('>')?;
    let (left, right) = (types::written(left), types::written(right));
    let of_left = types::dimensions(&left)?;
    let of_right = types::dimensions(&right)?;
    let size = |(rows, columns): (&str, &str)| format!("{rows}×{columns}");
    let (left, right) = (size(of_left), size(of_right));
    Some(match of {
        "Mul" | "MulAssign" => (
            format!("a {left} matrix cannot be multiplied by a {right} matrix"),
            format!(
                "the left matrix needs as many columns as the right matrix has rows, and {} are not {}; `a.transpose()` or `a.tr_mul(&b)` transpose it",
                of_left.1, of_right.0
            ),
        ),
        "Add" | "AddAssign" => {
            (format!("a {right} matrix cannot be added to a {left} matrix"), SAME.to_owned())
        }
        "Sub" | "SubAssign" => {
            (format!("a {right} matrix cannot be subtracted from a {left} matrix"), SAME.to_owned())
        }
        _ => (format!("the dimensions {left} and {right} do not fit"), SAME.to_owned()),
    })
}

const SAME: &str = "both matrices need equal numbers of rows and columns: check their types";
