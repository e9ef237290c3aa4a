//! Words that appear in the C: names of fields and of temporaries that no author named.
//!
//! Invariant: no decision depends on them; `xtask/tests/structure.rs` checks that none is compared.

/// Names of tuples with one, two and three parts, and of their parts.
pub(super) const TUPLES: [&str; 3] = ["single", "pair", "triple"];
pub(super) const PARTS: [&str; 8] =
    ["first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth"];

/// Names of the fields of lists, `Option`, `Result`, enums with payload, and slices in values. A slice has the index of
/// its first element, and its length.
pub(super) const LENGTH: &str = "length";
pub(super) const ITEMS: &str = "items";
pub(super) const IS_SOME: &str = "is_some";
pub(super) const IS_OK: &str = "is_ok";
pub(super) const VALUE: &str = "value";
pub(super) const ERROR: &str = "error";
pub(super) const TAG: &str = "tag";
pub(super) const ENDS: [&str; 2] = ["from", "length"];
/// Names of the fields of a reference to one element.
pub(super) const ENDS_OF_ONE: [&str; 2] = ["index", "length"];

/// Names of a function that compares part by part, and of its parameters.
pub(super) const EQUAL: &str = "equal";
pub(super) const SAME_PARTS: &str = "same_parts";
pub(super) const LESS: [&str; 2] = ["less", "comes_first"];
pub(super) const LESS_OR_EQUAL: [&str; 2] = ["less_or_equal", "comes_first_or_equals"];
pub(super) const IN_ORDER: &str = "in_order";
pub(super) const ALL_PARTS: &str = "all";
pub(super) const COMPARED: [&str; 2] = ["one", "other"];

/// Names of temporaries for destructured values, by type.
pub(super) const OPTION: &str = "option";
pub(super) const OUTCOME: &str = "outcome";
pub(super) const VECTOR: &str = "vector";
pub(super) const ELEMENTS: &str = "elements";
pub(super) const SELECTOR: &str = "selector";
pub(super) const PART: &str = "part";
pub(super) const OTHERS: &str = "others";
pub(super) const ELEMENT: &str = "element";

/// Names of the results of operations on matrices of integers.
pub(super) const NEGATIVE: &str = "negative";
pub(super) const SUM: &str = "sum";
pub(super) const DIFFERENCE: &str = "difference";
pub(super) const PRODUCT: &str = "product";
pub(super) const QUOTIENT: &str = "quotient";
pub(super) const SCALED: &str = "scaled";

/// Names of operands and arguments that are computed early.
pub(super) const OPERAND: &str = "operand";
pub(super) const ARGUMENT: &str = "argument";
pub(super) const INDEX: &str = "index";
pub(super) const OPERANDS: [&str; 3] = ["left", "middle", "right"];
pub(super) const SIDES: [&str; 2] = ["left", "right"];
pub(super) const OF_NUMBERS: [&str; 2] = ["value", "by"];
pub(super) const BOUNDS: [&str; 2] = ["first", "end"];
/// Names of the indices of a matrix element.
pub(super) const ROW: &str = "row";
pub(super) const COLUMN: &str = "column";

/// Names of search results, of a loop and its flags, of a pass, and of counters without an author's name.
pub(super) const FOUND: &str = "found";
pub(super) const LOOP: &str = "loop";
pub(super) const DONE: &str = "done";
pub(super) const NEXT: &str = "next";
pub(super) const PASS: &str = "pass";
pub(super) const COUNTERS: [&str; 3] = ["i", "j", "k"];
