//! Constant messages: each names the Rust item that is refused, in one sentence, and a remedy says what to write instead. A
//! message that includes names of the author's is formatted where it arises.

/// A message and its remedy.
pub(super) type Reason = (&'static str, &'static str);

macro_rules! reasons {
    ($($name:ident: $message:literal, $help:literal;)*) => {$(
        pub(super) const $name: Reason = ($message, $help);
    )*};
}

reasons! {
    EMPTY_ELEMENTS: "a slice cannot have zero-sized elements", "keep the count, or an array of `bool`";
    SLICE_PATTERN: "this pattern cannot match a slice", "write a slice pattern: `[first, .., last]` or `[first, rest @ ..]`";
    SLICE_VALUE: "`match` cannot take an unsized slice by value", "match on a reference: `match &values[..] { … }`";
    ROW_AND_COLUMN: "indexing a `BoundedMatrix` requires a row and a column", "write `m[(row, column)]`";
    TWO_INDICES: "this index requires a row and a column", "write `m[(row, column)]`";
    STATEMENT: "this call returns `()`", "write it as a statement of its own";
    UNUSED_VALUE: "the result of this call is unused", "remove the call";
    BY_HAND: "this iterator does not support explicit `next` calls", "consume it in one `for`; or call `next` on `values.iter()` alone; or keep an index. For an iterator of your own, write `it.take(n)` before the other adapters";
    NESTED_WRITES: "the closure of this `flat_map` writes, takes mutable references or calls an external function, and is called again by each explicit `next` call", "consume the iterator in one `for`; or write and call in the loop, instead of the closure";
    BOTH_ENDS: "this iterator does not support `next_back` calls", "call it on `values.iter()`, or with `map`, `filter` and the like behind it; or keep an index";
    UNKNOWN_LENGTH: "the number of items of this iterator is not known", "write `.count()`, or keep the number";
    LENT_TWICE: "two arguments refer to elements of one array", "pass the parts themselves, as `&mut [T]`, and choose the elements in the function; or exchange by index: `values.swap(i, j)`";
    MATCHED: "`match` cannot compare values of this type", "compare with `if`";
    NUMBER_PATTERN: "this pattern cannot match a number", "write values, ranges, a name or `_`";
    HIDDEN_NAME: "a variable that this closure captures is shadowed where another closure calls it", "rename the later variable";
    CLOSURE_GIVEN: "this argument must be a closure", "write a closure that calls the function: `|x| name(x)`";
    SLICE_IN_CLOSURE: "a closure that is passed to a function cannot capture a slice", "read the elements before: `let first = values[0];`";
    CLOSURE_HANDED_ON: "a closure parameter cannot be called inside another closure here", "call it before, and capture its result";
    SLICES_COMPARED: "`==` does not compare slices inside other values", "compare the slices themselves: `a.bytes == b.bytes`";
    ORDER: "this type has no order by its parts: only types that derive `PartialOrd` below `#[data]`, tuples and arrays do", "for an order of its own write a method, `fn is_before(&self, other: &Self) -> bool`, and call it here; for the order by parts write `#[derive(PartialOrd)]` below `#[data]` in place of an `impl PartialOrd`";
    EMPTY_ORDER: "zero-sized values have no order to compare", "remove the comparison";
    TRIED: "`?` requires an `Option` or a `Result`", "`match` on the value";
    MOVED_REFERENCE: "a reference variable cannot be assigned another reference", "write to the referenced place, `*name = …`; or choose between two places by an index or an `if`";
    ASSIGNED: "this expression is not assignable", "assign to a variable, a field or an element";
    TUPLE_MADE: "a tuple cannot hold a slice or a mutable reference here", "destructure it where it is bound: `|(a, b)| …`";
    WINDOW_APART: "an item of `windows` or `chunks` cannot be destructured in the pattern of the loop", "bind it to a name, and index it: `for pair in values.windows(2)`";
    CHAINED: "one part of this `chain` is not an iterator over elements by reference", "write `a.iter().chain(b.iter())` of arrays, slices, lists or vectors; or write two loops";
    ITERATOR_CALL: "the iterator that this function returns must be consumed at the call", "write the call in the `for`, or before `.map(…)`, `.filter(…)`, `.sum()` and the like, with `.into_iter()` between";
    EXPANDS_ITSELF: "a function that is expanded at its calls cannot call itself", "write a loop over a range";
    CLOSURE_ARGUMENT: "this function does not take a closure", "call the closure, and pass its result; docs/book/reference/statements.md lists the functions that take closures";
    NO_VALUE: "this expression has no value", "write an expression with a value";
    NOTHING_COMPARED: "a comparison of zero-sized values is always true or always false", "remove it: the type has one value";
    ORDER_AND_EQUALITY: "a derived `PartialOrd` may contradict an own `PartialEq`", "derive `PartialEq` too, or compare parts";
    OPERAND_TYPES: "no operator is defined for these operand types", "use a method";
    PART_OF_A_NAME: "the C has a number for each name, and no bytes", "compare whole names by `==` or `match`; write `Text<N>` for a text with bytes";
    ORDER_OF_NAMES: "the C has a number for each name, and numbers are not in the order of the texts", "compare names by `==`; give each a number beside it, by which to sort";
    CAST: "`as` converts numbers, `bool`, `char` and plain enums only", "convert the parts";
    VARIANT_BRACES: "a variant without fields takes no braces", "remove `{}`";
    TRY_FOLD: "the closure of `try_fold` must return an `Option` or a `Result`", "return `Some(…)` or `Ok(…)` from it";
    SUMMED: "`sum` and `product` require numbers, complex numbers or matrices", "use `fold`";
    BY_ITSELF: "an iterator that a function returns cannot be combined by `zip` or `chain` here", "consume it alone with `.enumerate()`, and index the other";
    ONE_BY_ONE: "an iterator that a function returns can only be consumed from its first item, one item at a time", "number the items with `.enumerate()`, and skip unwanted ones in the loop or in a `.filter(…)`";
    EMPTY_PART: "an element of this tuple is zero-sized", "remove it from the tuple";
    EMPTY_LIST: "a `List` without capacity, or of zero-sized elements, has no memory in C", "give it a capacity of at least 1, or keep the count";
    VARIANT_NUMBER: "the number of a variant does not fit in 32 bits", "choose numbers between -2147483648 and 2147483647";
    ERROR_OF_NOTHING: "`?` cannot convert this zero-sized error", "write `.map_err(|_| …)?`";
    ERROR_CONVERSION: "the `From` that `?` needs for this error is not marked", "mark its `impl From` block `#[data]`, as the type is; or convert the error with `map_err`";
    ENTRY_BORROWS: "an entry point cannot take a value with a slice in it, because C cannot check the slice's length", "take an array, `&[T; N]`, or a `List<T, N>`, and build the value inside";
    TWO_LENDERS: "this call requires that two slices of the value are parts of one array", "let both be parts of one array";
    SLICE_GIVEN: "an external function cannot return a slice, because C cannot tell which array it is part of", "return a copy; or return an index and a length";
    BORROWED_CONSTANT: "a value with a reference cannot be a constant in C", "build it here, or in a function, instead of a `const`";
    EMPTY_ITERATOR: "an iterator without fields has no state to advance", "give it a field";
    SHOWN_BOUND: "`#[bound]` has no effect here, because the loop's bound is already known", "remove `#[bound]`; in a chain that starts with an iterator of your own, write the number of items after it: `.take(64)`";
    BOUND: "`#[bound]` requires an integer", "write `#[bound(64)]`";
    LAST_NUMBER: "this open range may overflow, because the number of items that `zip` takes is not known", "put the elements first, `values.iter().zip(first..)`, without `.skip(n)`; or number with `0_usize..`";
    COUNTER: "a `for` over a range requires integers", "count with `0..`";
    PLACE: "this method requires a variable, a field or an element", "bind the value to a variable first: `let mut last = …;`";
    EMPTY_CHOICE: "this method returns a zero-sized payload", "use `is_some` or `is_ok`";
    EMPTY_OPTION: "the payload of this `Option` is zero-sized", "keep a `bool`";
    CLOSURE_TAKEN: "`get_or_insert_with` requires a closure", "write `|| …`";
    TUPLE_PATTERN: "a tuple expression can only be matched part by part", "bind it to a name first: `let pair = (a, b);`";
    NAMES_BY_CASE: "a name in the alternatives of `|` refers to different places", "write a `match` with an arm for each";
    CONSTANT_PATTERN: "a constant of this type cannot be a pattern", "compare with `==`";
    PATTERN: "this pattern cannot match a value of this type", "destructure arrays, tuples, structs and variants";
    INDEXED: "only arrays, slices, lists, matrices, vectors and types with a marked `impl Index` can be indexed", "of a type of your own: mark its `impl Index` block `#[data]`; otherwise use `[T; N]`, or a vector";
    CHOSEN_REFERENCE: "a mutable reference cannot be the value of an `if`, a `match`, a block or a loop here", "borrow the variable itself: `&mut a`; or write in each branch: `if left { a += 1 } else { b += 1 }`; or choose an index: `let i = if left { 0 } else { 1 };`, and write to `values[i]`";
    NAMED_REFERENCE: "a reference variable must name a variable, a field or an element", "copy the value: `let x = *place;`; or pass the reference as an argument; or unwrap it: `let Some(x) = … else { … };`";
    TWO_INDEXINGS: "`Index` and `IndexMut` of this type return different places, and either may be meant here", "write one and the same body in both, or methods with names";
    LENDS_NOTHING: "this function must end in the place that it returns by reference", "end in `&self.field`";
    LENT_PLACE: "this expression cannot be returned by reference", "end in a field or an element: `&self.axes[i]`";
    BOUNDED_MATRIX: "the elements of a `BoundedMatrix` cannot be combined with other iterators, or skipped", "bind the matrix to a name and iterate over it alone; or write `for column in 0..m.ncols()`, and index";
    RANGE_TAKEN: "a `Range` variable has no explicit `next` calls", "iterate over a copy, `range.clone()`; or keep the next number, and count on";
    ITERATOR_IN_CLOSURE: "a closure that is passed to a function cannot capture an iterator", "create the iterator in the closure; or pass it to the function as `items: impl Iterator<Item = T>`";
    ZIPPED_BY_ACCESS: "the number of items that this `zip` takes from its first iterator depends on the version of Rust, and a closure of that iterator writes or may fault", "call the closure behind the `zip`: `values.iter().zip(others).map(|(x, y)| …)`";
    SKIPPED_BY_ACCESS: "this `zip` calls no closure for the items that `skip` leaves out, which depends on the version of Rust", "write `.skip(n)` before the closure: `values.iter().skip(n).map(|x| …)`";
    COMPARED_BY_ACCESS: "the number of items that this comparison takes depends on the version of Rust, and a closure of an iterator writes or may fault", "compare in a loop: `for (x, y) in values.zip(others)`";
    LAST_CHUNK: "`last` calls the closure of `chunk_by` from the end on, and the closure writes or may fault", "keep the last part in a loop: `for part in values.chunk_by(…)`";
    TAKEN_BY_LENGTH: "the number of items that this call consumes differs between versions of Rust", "limit them first, `it.by_ref().take(n)`; or iterate over both in a `for`";
    OWN_ITER: "a loop cannot iterate over this type", "if the type is an iterator, mark its `impl Iterator` block `#[data]`; otherwise write `for i in 0..n`, and index, or add a method with another name than `iter`, `fn items(&self) -> impl Iterator<Item = &T>`";
    GONE_THROUGH: "a loop cannot iterate over this type", "write `for i in 0..n`, and index; loops accept arrays, slices, lists, vectors, ranges and iterators";
    EMPTY_GROUPS: "the size for `chunks`, `windows` or `step_by` must not be zero", "write a number above 0";
    ENDLESS: "this iterator never ends", "write both ends of a range, `0..n`; or write `.zip(…)` first, and the other adapters after it";
    PAIRS: "the loop's items are pairs, and must be destructured", "bind both parts: `for (i, x) in …`";
    ENTRY_SLICE: "an entry point cannot take a slice, because C cannot check its length", "take an array, `&[T; N]`, or a `List<T, N>`";
    IN_A_ROW: "the elements of this value are not contiguous", "pass an array, a `List`, or `.as_slice()` of a vector";
    TWO_LENGTHS: "the two slices of `copy_from_slice` never have equal lengths", "take equally many elements on both sides";
    PLATFORM: "nalgebra calls the platform's `sin`, `cos` or `sqrt` here, so the bits would depend on the target", "call the function of `bessemer::rotation` or `bessemer::complex` instead: `rotation::angle(&q)`, `rotation::from_scaled_axis(v)`, `complex::norm(&z)` and the like";
    QUATERNION_INDEX: "the index of a quaternion must be a number from 0 to 3", "write `q[0]` to `q[3]`, or `q.i`, `q.j`, `q.k` and `q.w`";
    QUATERNION_PARTS: "the parts of a quaternion are not stored as a vector in C", "write to `q.i`, `q.j`, `q.k` and `q.w`, or assign a new quaternion";
    MOVED_VIEW: "a mutable view of a matrix cannot be stored or passed on here", "bind it with `let`, and use that name; call `.into_owned()` for a copy";
    REFERENCE_VALUE: "a reference cannot be stored here", "copy the referenced value, or pass the reference as an argument";
    EMPTY_ARRAY: "C has no arrays or matrices without elements", "give it an element; or pass an empty part of another array: `&other[..0]`";
    ARRAY_OF_NOTHING: "an array cannot have zero-sized elements", "keep the count, or an array of `bool`; write `core::array::from_fn(|i| …)` for `[(); N].map(|()| …)`";
    EMPTY_COMPONENT: "a component whose fields are all zero-sized has no state", "mark it and its `impl` blocks `#[data]`, or add a field";
    EMPTY_NAME: "a zero-sized struct has no type in C that `#[c(name)]` could name", "remove the name, or name its methods";
    KEPT_NOTHING: "a zero-sized value cannot be stored here", "remove the variable: the type has one value";
    ONE_OR_OTHER: "this slice is part of one array or of another, depending on a condition at run time", "let both be parts of one array; or do the work in each branch";
    CHOSEN: "the index of the array that this slice is part of changes while the slice is in use", "compute the index before the `let`";
    OF_MATRIX: "a struct cannot hold a reference to elements of a matrix", "find the index, and use it: `if let Some(at) = m.iter().position(|x| …) { m[at] = … }`";
    UNNAMEABLE: "this function returns a part of an array that its caller did not pass", "take the array as a parameter, and return a part of it";
    MANY_SLICES: "an array or a `List` cannot have slices as elements", "keep their ends as an array of pairs, or keep each slice in a field";
    LENT: "a slice or a reference that this method returns cannot be stored here", "destructure it at the call: `if let Some(x) = values.get_mut(i) { … }`, `let (a, b) = values.split_at(n);`";
    LENT_BY_OPTION: "the reference that this method returns cannot be stored here", "destructure it at the call: `if let Some(x) = self.last.as_mut() { … }`";
    MAY_MEET: "two arguments are parts of one array, one of them mutable, and they may overlap", "pass the halves of one `split_at_mut` unchanged, and take the parts in the function: `merge(low, n, high)`, there `low[..n]`";
}
