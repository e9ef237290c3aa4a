//! Lookups of names find the innermost and latest binding.

use super::*;

#[test]
fn later_and_inner_bindings_come_first() {
    let scope = |bindings: &[(&str, usize)]| -> Names {
        bindings.iter().map(|(name, at)| (name.to_string(), Value::Closure(*at))).collect()
    };
    let mut scopes = Scopes::default();
    [scope(&[("a", 0), ("b", 1), ("a", 2)]), scope(&[]), scope(&[("a", 3)])]
        .into_iter()
        .for_each(|it| scopes.push(it));
    let closures = |scopes: &Scopes, name: &str| -> Vec<usize> {
        let index = |meaning: &Value| match meaning {
            Value::Closure(at) => *at,
            _ => usize::MAX,
        };
        scopes.meanings(name).map(index).collect()
    };
    assert_eq!(closures(&scopes, "a"), [3, 2, 0]);
    assert_eq!(closures(&scopes, "b"), [1]);
    assert!(closures(&scopes, "c").is_empty());
    scopes.add_name("b".to_owned(), Value::Closure(4));
    assert_eq!((closures(&scopes, "b"), scopes.len()), (vec![4, 1], 5));
    scopes.meanings_mut().for_each(|meaning| *meaning = Value::Closure(5));
    assert_eq!(closures(&scopes, "b"), [5, 5]);
}

#[test]
fn an_inner_scope_leaves_nothing_behind() {
    let mut scopes = Scopes::default();
    scopes.add_name("a".to_owned(), Value::Closure(0));
    scopes.push(vec![("a".to_owned(), Value::Closure(1)), ("b".to_owned(), Value::Closure(2))]);
    scopes.add_name("a".to_owned(), Value::Closure(3));
    scopes.pop();
    assert!(matches!(scopes.meanings("a").collect::<Vec<_>>()[..], [Value::Closure(0)]));
    assert!(scopes.meaning("b").is_none() && scopes.len() == 1);
    // The outermost scope may end, too.
    scopes.pop();
    scopes.pop();
    scopes.add_name("c".to_owned(), Value::Closure(4));
    assert!(scopes.meaning("c").is_none() && scopes.iter().next().is_none());
}
