//! Cases of a `switch` before and after an invalid value has its place.

use super::*;
use crate::c::tree::{Origin, plain};

/// A `switch` as text: `A B | C*` has two cases, of which the second is the default.
fn written(arms: &[SwitchArm]) -> String {
    let arm = |arm: &SwitchArm| {
        let labels = arm.labels.iter().filter_map(Expr::last_name).collect::<Vec<_>>().join(" ");
        format!("{labels}{}", if arm.default { "*" } else { "" })
    };
    arms.iter().map(arm).collect::<Vec<_>>().join(" | ")
}

fn read(text: &str) -> Vec<SwitchArm> {
    let arm = |text: &str| SwitchArm {
        labels: text.trim_end_matches('*').split_whitespace().map(Expr::name).collect(),
        default: text.ends_with('*'),
        body: Vec::new(),
    };
    text.split(" | ").map(arm).collect()
}

fn placed(text: &str, fallback: Option<&str>, hook: bool) -> (String, bool) {
    let variants = ["A", "B", "C"].map(str::to_owned);
    let hook = hook.then(|| vec![plain(StmtKind::Forever)]);
    let enums = std::iter::once(Enum { variants: &variants, fallback });
    let kind = StmtKind::Switch { scrutinee: Expr::name("x"), arms: read(text) };
    let mut body = vec![Stmt { kind, origin: None::<Origin> }];
    let hooked = Corrupted::new(enums, hook).rewrite(&mut body);
    let StmtKind::Switch { arms, .. } = &body[0].kind else { unreachable!("it is a switch") };
    (written(arms), hooked)
}

#[test]
fn the_chosen_variant_takes_invalid_values() {
    for (before, chosen, after) in [
        ("A | B | C*", "A", "B | C | A*"),
        ("A | B | C*", "C", "A | B | C*"),
        ("A B | C*", "B", "C | A B*"),
        // The others get labels beside a `_` arm.
        ("A | *", "A", "B C | A*"),
        ("A | *", "B", "A | *"),
        ("A | B | *", "A", "B | C | A*"),
        // An entry point checks its argument: only invalid values fail.
        ("A B C | *", "A", "A B C | *"),
        // A number is no variant.
        ("1 | 2*", "A", "1 | 2*"),
    ] {
        assert_eq!(placed(before, Some(chosen), false), (after.to_owned(), false), "{before}");
        // The author's choice precedes the hook.
        assert_eq!(placed(before, Some(chosen), true), (after.to_owned(), false), "{before}");
    }
}

#[test]
fn the_hook_has_a_case_of_its_own() {
    for (before, after, hooked) in [
        ("A | B | C*", "A | B | C | *", true),
        ("A | *", "A | B C | *", true),
        ("A B C | *", "A B C | *", false),
    ] {
        assert_eq!(placed(before, None, true), (after.to_owned(), hooked), "{before}");
        assert_eq!(placed(before, None, false), (before.to_owned(), false), "{before}");
    }
}
