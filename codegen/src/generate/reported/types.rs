//! Types as authors write them, and replacements for types that the DSL does not support.

/// Returns a type without references and modules, with nalgebra's alias for a matrix.
pub fn written(ty: &str) -> String {
    let ty = ty.trim_start_matches("&mut ").trim_start_matches('&');
    shown(ty.strip_prefix("'static ").unwrap_or(ty))
}

/// Returns the name of a type without path and parameters.
pub fn name(ty: &str) -> &str {
    let ty = ty.split(['<', '[', '(']).next().unwrap_or_default();
    ty.rsplit("::").next().unwrap_or_default()
}

/// Returns a type without the modules of its path.
pub fn within_modules(ty: &str) -> &str {
    let head = ty.find(['<', '[', '(']).unwrap_or(ty.len());
    ty[..head].rfind("::").map_or(ty, |at| &ty[at + 2..])
}

/// Returns the innermost type: `Instant` for `Option<Instant>`.
pub fn innermost(ty: &str) -> &str {
    let ty = ty.trim_start_matches("&mut ").trim_start_matches('&');
    let within = |before: &str, after: char| ty.strip_prefix(before)?.strip_suffix(after);
    let inner = within("Option<", '>').or_else(|| within("[", ']')?.split(';').next());
    inner.map_or(ty, innermost)
}

/// Returns true for a type of the DSL, nalgebra or Rust, whose methods no author marks.
pub fn is_known(ty: &str) -> bool {
    const KNOWN: [&str; 19] = [
        "SMatrix",
        "SVector",
        "RowSVector",
        "List",
        "BoundedMatrix",
        "Text",
        "Option",
        "Result",
        "Range",
        "RangeInclusive",
        "NonZero",
        "Wrapping",
        "Complex",
        "Unit",
        "Quaternion",
        "Rotation",
        "Isometry",
        "Translation",
        "OPoint",
    ];
    let name = name(ty);
    let is_matrix = || {
        name.starts_with("Matrix") || name.starts_with("Vector") || name.starts_with("RowVector")
    };
    !name.contains(char::is_uppercase) || KNOWN.contains(&name) || (ty.contains('<') && is_matrix())
}

/// Returns true if a type is a generic parameter, by its name.
pub fn is_parameter(ty: &str) -> bool {
    !ty.is_empty() && !ty.contains(|it: char| !it.is_ascii_uppercase() && !it.is_ascii_digit())
}

/// Returns the remedy for a type of Rust, nalgebra or another library that models cannot use.
pub fn instead(ty: &str) -> Option<&'static str> {
    Some(match name(ty) {
        "Vec" => "write `List<T, N>`, a list of at most `N` elements, or an array `[T; N]`",
        "String" | "str" => "write `Text<N>`, a text of at most `N` bytes, or an enum for a choice",
        "VecDeque" => {
            "write an array `[T; N]` and the index of the oldest element, or `List<T, N>`"
        }
        "HashMap" | "BTreeMap" | "HashSet" | "BTreeSet" | "BinaryHeap" => {
            "search a `List<(K, V), N>`, or use an array with the key as index"
        }
        "Box" | "Rc" | "Arc" => "store the value itself; use an `enum` for values of several types",
        "Instant" | "SystemTime" => {
            "a model has no clock: pass the time to the entry point, in seconds or as a count of ticks"
        }
        "Duration" => "write seconds, `period: f64`, or ticks of an integer type",
        "Mutex" | "RwLock" | "Cell" | "RefCell" | "UnsafeCell" | "OnceCell" | "OnceLock"
        | "LazyLock" | "LazyCell" | "LocalKey" => STATE,
        it if it.starts_with("Atomic") => STATE,
        "Items" => {
            "write `.into_iter()` after the call that returns the iterator, `values().into_iter().map(…)`; or write a `for`"
        }
        "RangeFrom" | "RangeTo" | "RangeToInclusive" | "RangeFull" => {
            "store both ends, `RangeInclusive<f32>` or `Range<u16>`, or one number"
        }
        "DMatrix" | "DVector" | "Dyn" => {
            "write `SMatrix<f64, R, C>` or `SVector<f64, N>`; for a varying size, `BoundedMatrix<f64, R, C>`"
        }
        _ => return None,
    })
}

/// Returns the replacement for a stored iterator of Rust; an author may have a type of such a name.
pub fn iterator(ty: &str) -> Option<&'static str> {
    const NAMES: [&str; 13] = [
        "Rev",
        "Map",
        "Filter",
        "Enumerate",
        "Zip",
        "Chain",
        "Skip",
        "Take",
        "StepBy",
        "Peekable",
        "Cycle",
        "Iter",
        "IterMut",
    ];
    NAMES.contains(&name(ty)).then_some(
        "an iterator is no data: store the index of the next element, and iterate inside a method",
    )
}

/// Remedy for state outside of a component.
pub const STATE: &str =
    "keep state in a field of the component, which methods change through `&mut self`";

/// Returns a text of rustc with its types as authors write them.
pub fn shown(text: &str) -> String {
    let mut shown = String::new();
    let mut rest = text;
    while let Some(at) = rest.find("Matrix<") {
        let is_whole = !rest[..at].ends_with(|it: char| it.is_alphanumeric() || it == '_');
        let matrix = static_matrix(&rest[at..]).filter(|_| is_whole);
        let (written, length) = matrix.unwrap_or_else(|| ("Matrix<".to_owned(), "Matrix<".len()));
        shown.push_str(&rest[..at]);
        shown.push_str(&written);
        rest = &rest[at + length..];
    }
    shown.push_str(rest);
    const PATHS: [&str; 6] = [
        "bessemer::nalgebra::",
        "nalgebra::",
        "std::ops::",
        "core::ops::",
        "std::sync::atomic::",
        "std::option::",
    ];
    PATHS.iter().fold(shown, |shown, path| shown.replace(path, ""))
}

/// Returns a static matrix as authors write it, and the length of rustc's text for it.
fn static_matrix(text: &str) -> Option<(String, usize)> {
    let mut depth = 0_usize;
    let end = text.char_indices().find_map(|(at, it)| {
        depth = match it {
            '<' => depth + 1,
            '>' => depth.saturating_sub(1),
            _ => return None,
        };
        (depth == 0).then_some(at + 1)
    })?;
    let bare = text[..end].replace("bessemer::nalgebra::", "").replace("nalgebra::", "");
    let mut parts = bare.strip_prefix("Matrix<")?.split(", ");
    let element = parts.next()?;
    let mut size = || parts.next()?.strip_prefix("Const<")?.strip_suffix('>');
    let (rows, columns) = (size()?, size()?);
    let written = match columns {
        "1" => format!("SVector<{element}, {rows}>"),
        _ => format!("SMatrix<{element}, {rows}, {columns}>"),
    };
    Some((written, end))
}

/// Returns rows and columns of a matrix as [`shown`] writes it.
pub fn dimensions(shown: &str) -> Option<(&str, &str)> {
    let (_, inner) = shown.split_once('<')?;
    let mut parts = inner.trim_end_matches('>').split(", ").skip(1);
    let rows = parts.next()?;
    Some((rows, parts.next().unwrap_or("1")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_are_shown_by_their_alias() {
        let said = "cannot add `f64` to `Matrix<f64, Const<2>, bessemer::nalgebra::Const<3>, ArrayStorage<f64, 2, 3>>`";
        assert_eq!(shown(said), "cannot add `f64` to `SMatrix<f64, 2, 3>`");
        assert_eq!(shown("`Matrix<T, R, C, S>`"), "`Matrix<T, R, C, S>`");
        assert_eq!(written("&Matrix<f64, Const<3>, Const<1>, A<f64, 3, 1>>"), "SVector<f64, 3>");
        assert_eq!(dimensions("SMatrix<f64, 2, 3>"), Some(("2", "3")));
        assert_eq!(dimensions("SVector<f64, 2>"), Some(("2", "1")));
        assert_eq!(innermost("Option<[Instant; 2]>"), "Instant");
    }
}
