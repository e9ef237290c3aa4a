//! Templates of C, in which `$name` represents a value.
//!
//! `$` has no meaning in C, so a template looks like the resulting C.

use bessemer_ir::Float;

/// Returns the template with its names replaced. A name without a value remains, and a test detects it.
pub fn fill(template: &str, values: &[(&str, String)]) -> String {
    let mut text = String::new();
    let mut parts = template.split('$');
    text.push_str(parts.next().unwrap_or_default());
    for part in parts {
        let end = part
            .find(|letter: char| !letter.is_ascii_alphanumeric() && letter != '_')
            .unwrap_or(part.len());
        let (name, rest) = part.split_at(end);
        match values.iter().find(|(known, _)| *known == name) {
            Some((_, value)) => text.push_str(value),
            None => text.push_str(&format!("${name}")),
        }
        text.push_str(rest);
    }
    text
}

/// Returns the size of a number, bytes.
pub fn bytes(float: Float) -> u32 {
    match float {
        Float::F64 => 8,
        Float::F32 => 4,
    }
}

/// Returns C's names for the numbers of a float type: `$real`, `$zero`, `$one`, `$abs`, `$sqrt`, `$nan`.
pub fn numbers(float: Float) -> Vec<(&'static str, String)> {
    let words: [(&str, &str); 6] = match float {
        Float::F64 => [
            ("real", "double"),
            ("zero", "0.0"),
            ("one", "1.0"),
            ("abs", "fabs"),
            ("sqrt", "sqrt"),
            ("nan", "(double)NAN"),
        ],
        Float::F32 => [
            ("real", "float"),
            ("zero", "0.0F"),
            ("one", "1.0F"),
            ("abs", "fabsf"),
            ("sqrt", "sqrtf"),
            ("nan", "NAN"),
        ],
    };
    words.into_iter().map(|(name, word)| (name, word.to_owned())).collect()
}

/// Returns the values with sizes as C literals: `("n", 6)` becomes `6U`.
pub fn values(float: Float, sizes: &[(&'static str, u32)]) -> Vec<(&'static str, String)> {
    let mut values = numbers(float);
    values.extend(sizes.iter().map(|(name, size)| (*name, format!("{size}U"))));
    values
}

/// Returns the preprocessor condition under which vectors of a target are used. Those of x86-64 are shuffled, which
/// gcc supports from version 12 on; those of ARM are not. i386 is excluded: its stack aligns `double` at 4 bytes, too
/// little for its vectors.
pub fn vectors_if(target: &str) -> String {
    let compiler = match target.contains("ARM") {
        true => "defined(__GNUC__)",
        false => {
            "defined(__GNUC__) && (defined(__clang__) || (__GNUC__ >= 12)) && defined(__x86_64__)"
        }
    };
    format!("{compiler} && {target} && !defined(BESSEMER_PLAIN)")
}

/// Text before that of [`fused`], up to an `#endif`.
pub const FUSED: &str = "#if defined(__FMA__)\n#include <immintrin.h>\n";

/// Returns the fused operation of x86-64 on vectors of this size: a number in each lane, and two vectors.
pub fn fused(
    element: Float,
    vector: u32,
    operation: &str,
    [number, left, right]: [&str; 3],
) -> String {
    let (suffix, letter) = match element {
        Float::F64 => ("pd", "d"),
        Float::F32 => ("ps", ""),
    };
    let (prefix, bits) = match vector {
        64 => ("_mm512", "512"),
        32 => ("_mm256", "256"),
        _ => ("_mm", "128"),
    };
    format!(
        "{prefix}_{operation}_{suffix}({prefix}_set1_{suffix}({number}), (__m{bits}{letter})({left}), \
         (__m{bits}{letter})({right}))"
    )
}

/// Returns the text without the branches under a macro that the kernel never defines.
pub fn without(text: &str, name: &str) -> String {
    decided(text, name, false)
}

/// Returns the text with only the selected branches of a macro that is always defined, or never.
pub fn decided(text: &str, name: &str, defined: bool) -> String {
    let condition = format!("#if defined({name})");
    let mut kept = String::new();
    // Where a block of the macro is open: how deep, and whether its other branch has begun.
    let (mut depth, mut other) = (0u32, false);
    for line in text.lines() {
        if depth == 0 {
            if line == condition {
                (depth, other) = (1, false);
                continue;
            }
        } else if line.starts_with("#if") {
            depth += 1;
        } else if line == "#endif" {
            depth -= 1;
            if depth == 0 {
                continue;
            }
        } else if depth == 1 && line == "#else" {
            other = true;
            continue;
        } else if let (1, false, false, Some(rest)) =
            (depth, other, defined, line.strip_prefix("#elif"))
        {
            // What follows is a block of its own.
            kept += &format!("#if{rest}\n");
            depth = 0;
            continue;
        }
        if depth == 0 || other != defined {
            kept += line;
            kept.push('\n');
        }
    }
    kept
}

/// Returns the text with every line indented by one level.
pub fn indented(text: &str) -> String {
    text.lines()
        .map(|line| if line.is_empty() { "\n".to_owned() } else { format!("    {line}\n") })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{fill, without};

    #[test]
    fn names_are_replaced_whole() {
        let values = [("n", "6U".to_owned()), ("name", "x".to_owned())];
        assert_eq!(fill("a[$n + 1] = $name; $other", &values), "a[6U + 1] = x; $other");
    }

    #[test]
    fn what_a_kernel_never_has_is_left_out() {
        let text = "a\n#if defined(X)\nb\n#if defined(Y)\nc\n#else\nd\n#endif\n#else\n#if defined(Y)\ne\n#endif\n#endif\nf\n";
        assert_eq!(without(text, "X"), "a\n#if defined(Y)\ne\n#endif\nf\n");
        let text = "#if defined(X)\na\n#elif B == 4U\nb\n#else\nc\n#endif\n";
        assert_eq!(without(text, "X"), "#if B == 4U\nb\n#else\nc\n#endif\n");
        assert_eq!(without("#if defined(X)\na\n#endif\nb\n", "X"), "b\n");
    }
}
