//! Removes from a kernel's text the variants for other processors than the target's family.
//!
//! The text has a variant for each family, under preprocessor conditions. If the family is known, branches that can
//! never be taken are removed, and so are those that depend only on macros defined there. Conditions that depend on
//! compiler flags remain.
//!
//! Invariant: for this family the preprocessor makes the same of both texts. For any other it selects a C99 variant
//! with the same bits.
//!
//! Must not know: the computations of a variant.

use std::collections::BTreeSet;

/// Processors for which the files of kernels have variants.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Processors {
    /// All processors.
    #[default]
    Every,
    /// Processors of the Cortex-A family.
    CortexA,
    /// Processors of the Cortex-M family.
    CortexM,
    /// Processors of x86-64.
    X86,
}

/// Prefixes of the macros that compilers for x86-64 define.
const X86: [&str; 6] = ["__x86_64__", "__AVX", "__SSE", "__FMA", "__BMI", "__i386__"];
/// Prefixes of the macros that compilers for ARM define.
const ARM: [&str; 2] = ["__arm__", "__ARM_"];
/// The letter of the Cortex-M in `__ARM_ARCH_PROFILE`, and its comparison.
const PROFILE: &str = "__ARM_ARCH_PROFILE";
const IS_M: &str = "__ARM_ARCH_PROFILE == 'M'";

impl Processors {
    /// Returns whether a macro is defined, if that is known.
    fn defines(self, name: &str) -> Option<bool> {
        let begins = |list: &[&str]| list.iter().any(|it| name.starts_with(it));
        match self {
            Processors::Every => None,
            Processors::CortexA | Processors::CortexM if begins(&X86) => Some(false),
            Processors::CortexM if name == "__ARM_NEON" => Some(false),
            Processors::CortexM if name == PROFILE => Some(true),
            Processors::X86 if begins(&ARM) => Some(false),
            _ => None,
        }
    }

    /// Returns the value of a comparison, if that is known.
    fn holds(self, comparison: &str) -> Option<bool> {
        (comparison == IS_M && self != Processors::Every).then_some(self == Processors::CortexM)
    }

    /// Returns a text with only this family's variants.
    pub(super) fn alone(self, text: &str) -> String {
        if self == Processors::Every {
            return text.to_owned();
        }
        let own = defined(text);
        let mut text = text.to_owned();
        loop {
            let live = defined(&text);
            let gone = |name: &str| own.contains(name) && !live.contains(name);
            let known = |name: &str| if gone(name) { Some(false) } else { self.defines(name) };
            let mut lines = text.lines().peekable();
            let mut left = Vec::new();
            let decide = |condition: &str| Condition::of(condition, &known, &|it| self.holds(it));
            resolve(&mut lines, &decide, &mut left);
            let next: String = left.iter().map(|line| format!("{line}\n")).collect();
            if next == text {
                return next;
            }
            text = next;
        }
    }
}

/// Returns the macros that a text defines.
fn defined(text: &str) -> BTreeSet<String> {
    let name = |line: &str| {
        let rest = line.trim_start().strip_prefix("#define ")?;
        let end = rest.find(|it: char| !it.is_ascii_alphanumeric() && it != '_');
        Some(rest[..end.unwrap_or(rest.len())].to_owned())
    };
    text.lines().filter_map(name).collect()
}

type Lines<'t> = std::iter::Peekable<std::str::Lines<'t>>;

/// Collects the lines that remain up to the end of their block.
fn resolve(lines: &mut Lines<'_>, decide: &dyn Fn(&str) -> Condition, left: &mut Vec<String>) {
    while let Some(line) = lines.peek() {
        if ["#elif", "#else", "#endif"].iter().any(|it| line.starts_with(it)) {
            return;
        }
        let line = lines.next().unwrap_or_default();
        match condition(line) {
            Some(first) => choice(first, lines, decide, left),
            None => left.push(line.to_owned()),
        }
    }
}

/// Returns the condition of a line that opens a block.
fn condition(line: &str) -> Option<String> {
    let named = |word: &str| line.strip_prefix(word).map(|name| format!("defined({name})"));
    let plain = || line.strip_prefix("#if ").map(str::to_owned);
    named("#ifdef ").or_else(|| Some(format!("!{}", named("#ifndef ")?))).or_else(plain)
}

/// Resolves a block, removing the branches that cannot be taken.
fn choice(
    first: String,
    lines: &mut Lines<'_>,
    decide: &dyn Fn(&str) -> Condition,
    left: &mut Vec<String>,
) {
    let mut branches: Vec<(Option<String>, Vec<String>)> = Vec::new();
    let (mut next, mut decided) = (Some(Some(first)), false);
    while let Some(condition) = next {
        let mut inside = Vec::new();
        resolve(lines, decide, &mut inside);
        let condition = match condition.as_deref().map(decide) {
            Some(Condition::Known(false)) => None,
            Some(Condition::Known(true)) | None => Some(None),
            Some(Condition::Open(text, _)) => Some(Some(text)),
        };
        if let Some(condition) = condition.filter(|_| !decided) {
            decided = condition.is_none();
            branches.push((condition, inside));
        }
        let line = lines.next().unwrap_or("#endif");
        next = match line.strip_prefix("#elif ") {
            Some(other) => Some(Some(other.to_owned())),
            None => line.starts_with("#else").then_some(None),
        };
    }
    match branches.first_mut() {
        None => without_comment(left),
        Some((None, inside)) => left.append(inside),
        Some(_) => {
            for (index, (condition, inside)) in branches.into_iter().enumerate() {
                left.push(match (index, condition) {
                    (0, Some(condition)) => format!("#if {condition}"),
                    (_, Some(condition)) => format!("#elif {condition}"),
                    (_, None) => "#else".to_owned(),
                });
                left.extend(inside);
            }
            left.push("#endif".to_owned());
        }
    }
}

/// Removes the comment above a removed branch.
fn without_comment(left: &mut Vec<String>) {
    if !left.last().is_some_and(|line| line.trim_end().ends_with("*/")) {
        return;
    }
    if let Some(first) = left.iter().rposition(|line| line.trim_start().starts_with("/*")) {
        left.truncate(first);
    }
}

/// A preprocessor condition, resolved as far as the family decides it.
enum Condition {
    Known(bool),
    /// Remaining condition, with the operator that joins its parts.
    Open(String, Binds),
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Binds {
    Or,
    And,
    Compares,
    Tightly,
}

impl Condition {
    fn of(
        text: &str,
        defines: &dyn Fn(&str) -> Option<bool>,
        holds: &dyn Fn(&str) -> Option<bool>,
    ) -> Condition {
        let text = text.trim();
        let each = |parts: Vec<&str>| {
            parts.into_iter().map(|part| Condition::of(part, defines, holds)).collect()
        };
        let parts = parts(text, "||");
        if parts.len() > 1 {
            return Condition::together(each(parts), Binds::Or);
        }
        let parts = self::parts(text, "&&");
        if parts.len() > 1 {
            return Condition::together(each(parts), Binds::And);
        }
        let known = match (text.strip_prefix('!'), within(text)) {
            (Some(rest), _) => {
                return match Condition::of(rest, defines, holds) {
                    Condition::Known(value) => Condition::Known(!value),
                    open => {
                        Condition::Open(format!("!{}", open.text(Binds::Tightly)), Binds::Tightly)
                    }
                };
            }
            (_, Some(inside)) => return Condition::of(inside, defines, holds),
            _ => match text.strip_prefix("defined(").and_then(|it| it.strip_suffix(')')) {
                Some(name) => defines(name),
                None => holds(text),
            },
        };
        let binds = if text.contains(' ') { Binds::Compares } else { Binds::Tightly };
        known.map_or_else(|| Condition::Open(text.to_owned(), binds), Condition::Known)
    }

    /// Joins parts by `&&` or `||`.
    fn together(parts: Vec<Condition>, binds: Binds) -> Condition {
        // What decides the whole by itself, and what says nothing.
        let decides = binds == Binds::Or;
        if parts.iter().any(|part| matches!(part, Condition::Known(it) if *it == decides)) {
            return Condition::Known(decides);
        }
        let mut open: Vec<Condition> =
            parts.into_iter().filter(|part| matches!(part, Condition::Open(..))).collect();
        match open.len() {
            0 => Condition::Known(!decides),
            1 => open.remove(0),
            _ => {
                let word = if decides { " || " } else { " && " };
                let text: Vec<String> = open.iter().map(|part| part.text(binds)).collect();
                Condition::Open(text.join(word), binds)
            }
        }
    }

    /// Returns the text of the condition as a part of an expression with this operator.
    fn text(&self, binds: Binds) -> String {
        match self {
            Condition::Known(value) => u8::from(*value).to_string(),
            Condition::Open(text, own) => match (own, binds) {
                (Binds::Tightly, _) | (Binds::Compares, Binds::Or | Binds::And) => text.clone(),
                _ if *own == binds => text.clone(),
                _ => format!("({text})"),
            },
        }
    }
}

/// Splits a condition at an operator outside parentheses.
fn parts<'t>(text: &'t str, operator: &str) -> Vec<&'t str> {
    let (mut depth, mut start, mut parts) = (0_u32, 0, Vec::new());
    for (at, letter) in text.char_indices() {
        match letter {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ if depth == 0 && at >= start && text[at..].starts_with(operator) => {
                parts.push(&text[start..at]);
                start = at + operator.len();
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    parts
}

/// Returns the text in the parentheses around a whole condition.
fn within(text: &str) -> Option<&str> {
    let inside = text.strip_prefix('(')?.strip_suffix(')')?;
    let mut depth = 0_i32;
    let closed = inside.chars().any(|letter| {
        depth += i32::from(letter == '(') - i32::from(letter == ')');
        depth < 0
    });
    (!closed).then_some(inside)
}

#[cfg(test)]
mod tests {
    use super::Processors::{CortexA, CortexM, Every, X86};

    const TEXT: &str = "\
/* How wide. */
#if defined(__GNUC__) && (defined(__clang__) || (__GNUC__ >= 12)) && defined(__x86_64__) && defined(__AVX__)
#define LANES 4U
#elif defined(__ARM_NEON) && defined(WANTED)
#define LANES 2U
#define QUAD
#endif
#if defined(LANES)
#if defined(QUAD)
quad
#else
wide
#endif
#elif defined(__x86_64__) || (defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M')
sixteen
#else
many
#endif
";

    #[test]
    fn what_can_never_hold_goes_with_what_it_would_define() {
        assert_eq!(Every.alone(TEXT), TEXT);
        let on_a = "\
/* How wide. */
#if defined(__ARM_NEON) && defined(WANTED)
#define LANES 2U
#define QUAD
#endif
#if defined(LANES)
#if defined(QUAD)
quad
#else
wide
#endif
#else
many
#endif
";
        assert_eq!(CortexA.alone(TEXT), on_a);
        assert_eq!(CortexM.alone(TEXT), "sixteen\n");
        let on_x86 = "\
/* How wide. */
#if defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) && defined(__x86_64__) && defined(__AVX__)
#define LANES 4U
#endif
#if defined(LANES)
wide
#elif defined(__x86_64__)
sixteen
#else
many
#endif
";
        assert_eq!(X86.alone(TEXT), on_x86);
    }

    #[test]
    fn what_is_left_of_a_condition_keeps_its_parentheses() {
        let of = |text: &str| CortexA.alone(&format!("#if {text}\na\n#endif\n"));
        assert_eq!(
            of("(defined(X) || defined(Y)) && !defined(__AVX__)"),
            "#if defined(X) || defined(Y)\na\n#endif\n"
        );
        assert_eq!(
            of("!(defined(X) || defined(Y)) && Z"),
            "#if !(defined(X) || defined(Y)) && Z\na\n#endif\n"
        );
        assert_eq!(of("!(defined(X) && defined(__SSE2__))"), "a\n");
        assert_eq!(of("!(__GNUC__ >= 12) || X"), "#if !(__GNUC__ >= 12) || X\na\n#endif\n");
        assert_eq!(of("defined(__FMA__)"), "");
    }
}
