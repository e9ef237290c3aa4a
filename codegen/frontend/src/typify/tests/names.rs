//! Names with one word, among those of a package.

use bessemer_ir::tree::Package;

use super::super::context::Names;

/// Names of a package, a word of a text, and the pair that has it.
type Case = (&'static [(u64, &'static str)], u64, Option<[&'static str; 2]>);

const CASES: [Case; 8] = [
    (&[], 3, None),
    (&[(3, "a"), (4, "b")], 3, None),
    (&[(3, "a"), (3, "b"), (4, "c")], 3, Some(["a", "b"])),
    (&[(3, "a"), (3, "b"), (4, "c")], 4, None),
    (&[(0, ""), (3, "a")], 0, None),
    (&[(0, ""), (0, "a")], 0, Some(["", "a"])),
    // Zeroed memory has the empty name, whether or not a package writes it.
    (&[(0, "a")], 0, Some(["", "a"])),
    (&[(0, "a"), (3, "b")], 3, None),
];

fn package(names: &[(u64, &str)]) -> Package {
    let names = names.iter().map(|(word, text)| (*word, (*text).to_owned())).collect();
    Package { names, ..Package::default() }
}

#[test]
fn two_names_with_one_word_are_found_once() {
    for (names, word, pair) in CASES {
        let package = package(names);
        let mut known = Names::of(&package);
        assert_eq!(known.clash(&[word], true), pair, "{names:?}");
        assert_eq!(known.clash(&[word], true), None, "{names:?}, again");
    }
}

#[test]
fn a_zero_in_a_value_is_no_name() {
    let package = package(&[(0, "a"), (3, "b"), (3, "c")]);
    let mut known = Names::of(&package);
    assert_eq!(known.clash(&[0, 1], false), None);
    assert_eq!(known.clash(&[0, 3], false), Some(["b", "c"]));
}
