//! Lookups of names find the innermost and latest binding.

use super::*;

#[test]
fn later_and_inner_bindings_come_first() {
    let scope = |bindings: &[(&str, usize)]| -> Names {
        bindings.iter().map(|(name, at)| (name.to_string(), Value::Closure(*at))).collect()
    };
    let mut scopes = [scope(&[("a", 0), ("b", 1), ("a", 2)]), scope(&[]), scope(&[("a", 3)])];
    let closures = |scopes: &[Names], name: &str| -> Vec<usize> {
        let index = |meaning: &Value| match meaning {
            Value::Closure(at) => *at,
            _ => usize::MAX,
        };
        meanings_in(scopes, name).map(index).collect()
    };
    assert_eq!(closures(&scopes, "a"), [3, 2, 0]);
    assert_eq!(closures(&scopes, "b"), [1]);
    assert!(closures(&scopes, "c").is_empty());
    scopes[2].add_name("b".to_owned(), Value::Closure(4));
    scopes[0].meanings_mut().for_each(|meaning| *meaning = Value::Closure(5));
    assert_eq!(closures(&scopes, "b"), [4, 5]);
    assert_eq!(scopes.iter().map(Names::len).collect::<Vec<_>>(), [3, 0, 2]);
}
