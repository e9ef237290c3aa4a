//! The messages whose text is constant: what is wrong, in the author's terms, and what to write instead. A message that names
//! something of the author's is formatted where it arises.

/// A message and its remedy.
pub(super) type Reason = (&'static str, &'static str);

macro_rules! reasons {
    ($($name:ident: $message:literal, $help:literal;)*) => {$(
        pub(super) const $name: Reason = ($message, $help);
    )*};
}

reasons! {
    EMPTY_ELEMENTS: "a slice of zero-sized elements is not in the DSL", "keep the count, or an array of `bool`";
    SLICE_PATTERN: "this pattern does not fit a slice", "write `[first, .., last]`, `[first, rest @ ..]` and the like";
    SLICE_VALUE: "a slice is no value", "match what `&` refers to";
    ROW_AND_COLUMN: "a `BoundedMatrix` takes a row and a column", "write `m[(row, column)]`";
    TWO_INDICES: "this takes a row and a column", "write `m[(row, column)]`";
    STATEMENT: "this has no value", "write it as a statement";
    UNUSED_VALUE: "the value of this is not used", "leave it out";
    BY_HAND: "this iterator is not gone through by hand in the DSL", "go through it in one `for`, or by hand through the elements alone, `values.iter()`; or keep an index; of an iterator of your own take first, `it.take(n)`, and let the other links follow";
    LENT_TWICE: "this refers to elements of an array to which another argument refers, too", "pass the parts themselves, as `&mut [T]`, and choose in the function; or exchange by index, `values.swap(i, j)`";
    MATCHED: "`match` compares integers, `bool` and enums in the DSL", "compare with `if`";
    NUMBER_PATTERN: "this pattern is not one of a number", "give values, ranges, a name or `_`";
    HIDDEN_NAME: "a name that a closure uses means something else where another calls it", "give the later variable another name";
    CLOSURE_GIVEN: "a function that takes a closure is given one in the DSL", "write one that calls the function: `|x| name(x)`";
    SLICE_IN_CLOSURE: "a closure that is handed to a function uses no slice in the DSL", "take what it needs of the slice before: `let first = values[0];`";
    CLOSURE_HANDED_ON: "a closure that was handed on is not called in another closure in the DSL", "call it before, and use its value";
    SLICES_COMPARED: "slices inside of values are not compared in the DSL", "compare the slices themselves: `a.bytes == b.bytes`";
    ORDER: "this has no order in the DSL", "compare parts; tuples have an order, arrays of up to 8 elements, and enums and structs that derive `PartialOrd` below `#[data]`";
    EMPTY_ORDER: "what is empty has no order in the DSL", "leave it out";
    TRIED: "`?` takes an `Option` or a `Result`", "`match` on the value";
    MOVED_REFERENCE: "a reference cannot be made to refer to something else in the DSL", "write to what it refers to (`*name = …`), or choose between two places by an index or an `if`";
    ASSIGNED: "this is not a place to assign", "assign a variable or a field";
    TUPLE_MADE: "a tuple with a slice in it, or with what may be changed, is not made in the DSL", "take it apart where it is named: `|(a, b)| …`";
    WINDOW_APART: "a window is not taken apart in the DSL", "give it a name, and index it";
    CHAINED: "of these two, one is not read element by element by reference", "write `a.iter().chain(b.iter())` of arrays, slices, lists or vectors; two loops otherwise";
    ITERATOR_CALL: "an iterator that a function gives is gone through where the function is called", "write the call in the `for`, or before `.map(…)`, `.filter(…)`, `.sum()` and the like, with `.into_iter()` between";
    EXPANDS_ITSELF: "this calls itself where it stands", "write a loop over a range";
    CLOSURE_ARGUMENT: "a closure is no argument of this in the DSL", "what takes closures is listed in docs/book/reference/statements.md; elsewhere call it, and pass its value";
    NO_VALUE: "this has no value", "write a value here";
    NOTHING_COMPARED: "zero-sized values are not compared in the DSL", "leave the comparison out: there is one value alone";
    ORDER_AND_EQUALITY: "an order that was derived and a `==` of its author's own may contradict each other", "derive `PartialEq` too, or compare parts";
    OPERAND_TYPES: "this operator does not take these types", "use a method";
    CAST: "`as` converts scalars", "convert the parts";
    VARIANT_BRACES: "write the variant without braces", "leave `{}` out";
    TRY_FOLD: "a `try_fold` gives an `Option` or a `Result` in the DSL", "let its closure give one";
    SUMMED: "only numbers, complex numbers and matrices are summed up in the DSL", "use `fold`";
    BY_ITSELF: "what a function gives is gone through by itself in the DSL", "go through it alone, and count: `.enumerate()`, and index the other";
    ONE_BY_ONE: "what a function gives is gone through one by one in the DSL, and from the first on", "count with `.enumerate()`, and leave out in the loop, or in a `.filter(…)`, what is not wanted";
    EMPTY_PART: "a part of this tuple is zero-sized", "leave it out";
    EMPTY_LIST: "this list is zero-sized", "give it room for an element, or keep the count";
    VARIANT_NUMBER: "the number of a variant has 32 bits in C", "choose numbers between -2147483648 and 2147483647";
    ERROR_OF_NOTHING: "`?` makes no error of nothing in the DSL", "write `.map_err(|_| …)?`";
    ERROR_CONVERSION: "the conversion of this error is not part of the DSL", "mark its `impl From` block as the type is, `#[data]`, or `map_err` the error";
    ENTRY_BORROWS: "an entry point takes no value with a slice in it: nothing could tell whether its length is right", "take an array, `&[T; N]`, or a `List<T, N>`, and make the value of it inside";
    TWO_LENDERS: "two slices in this value are parts of two arrays, and this function makes one a part of the other", "let both be parts of one array";
    SLICE_GIVEN: "the firmware takes no slice: it would not know of which array", "return a copy, or where the elements are: an index and a length";
    BORROWED_CONSTANT: "a value that borrows is no constant in C", "make it here, or in a function, instead of a `const`";
    EMPTY_ITERATOR: "an iterator that is zero-sized has nothing to count by", "give it a field";
    SHOWN_BOUND: "the bound of this loop shows, or is that of an iterator in it", "leave `#[bound]` out; of a chain that begins with an iterator of your own say behind that how many items are wanted: `.take(64)`";
    BOUND: "the bound of a loop is an integer", "write `#[bound(64)]`";
    LAST_NUMBER: "these numbers may come to the last of their type, and how many are asked for does not show here", "let the elements come first, `values.iter().zip(first..)`, without `.skip(n)`; or number with `0_usize..`";
    COUNTER: "a loop counts in integers in the DSL", "number with `0..`";
    PLACE: "this is not a place", "keep it in a variable";
    EMPTY_CHOICE: "there is nothing to the value", "ask with `is_some`, `is_ok`";
    EMPTY_OPTION: "there is nothing to this value", "keep a `bool`";
    CLOSURE_TAKEN: "this takes a closure", "write `|| …`";
    TUPLE_PATTERN: "a tuple that is written out is matched part by part", "give it a name first: `let pair = (a, b);`";
    NAMES_BY_CASE: "names inside `|` stand for different places", "write a `match` with an arm for each";
    CONSTANT_PATTERN: "a constant of this type is not a pattern", "compare with `==`";
    PATTERN: "this pattern does not fit what the DSL takes apart", "take apart arrays, tuples, structs and variants";
    INDEXED: "only arrays, matrices and vectors have elements in the DSL", "use `[T; N]`, or a vector";
    NAMED_REFERENCE: "a reference in a variable names a place in the DSL", "copy the value: `let x = *place;`, or pass the reference as an argument; of what may be there, `let Some(x) = … else { … };`";
    TWO_INDEXINGS: "`Index` and `IndexMut` of this type lend in two ways, and here either may be meant", "write one and the same body in both, or methods with names";
    LENDS_NOTHING: "this lends no place", "end in `&self.field`";
    LENT_PLACE: "this is no place that could be lent", "end in a field or an element: `&self.axes[i]`";
    BOUNDED_MATRIX: "all elements of a `BoundedMatrix` are gone through by themselves, and from the first on", "give the matrix a name; or write `for column in 0..m.ncols()`, and index";
    RANGE_TAKEN: "a range that is held is gone through as it is in the DSL: nothing is taken from it", "go through a copy, `range.clone()`; or keep the number that comes next, and count on";
    ITERATOR_IN_CLOSURE: "an iterator that a closure uses is not handed to a function in the DSL", "make the iterator in the closure, or give it to the function, `items: impl Iterator<Item = T>`";
    TAKEN_BY_LENGTH: "how many items this takes of an iterator that goes on differs between versions of Rust", "take them first, `it.by_ref().take(n)`; or go through both in a `for`";
    OWN_ITER: "a loop goes through arrays and vectors in the DSL, also by the names `iter` and `iter_mut`", "write `for i in 0..n`, and index; or give this type a method of another name, `fn items(&self) -> impl Iterator<Item = &T>`; if it is an iterator itself, mark its `impl Iterator` block `#[data]`";
    GONE_THROUGH: "a loop goes through arrays and vectors in the DSL", "write `for i in 0..n`, and index";
    EMPTY_GROUPS: "no elements at a time never come to an end", "write a number above 0";
    ENDLESS: "nothing ends this sequence", "write both ends of a range, `0..n`; or let `.zip(…)` come first, and the other links behind it";
    PAIRS: "the pairs that a loop goes through are taken apart in the DSL", "give both of each a name: `for (i, x) in …`";
    ENTRY_SLICE: "an entry point takes no slice: nothing could tell whether its length is right", "take an array, `&[T; N]`, or a `List<T, N>`";
    IN_A_ROW: "this has no elements in a row", "take an array, a `List`, or `.as_slice()` of a vector";
    TWO_LENGTHS: "these are never of one length", "name as many elements on both sides";
    PLATFORM: "nalgebra takes sine, cosine or the root from the platform here, so the bits would depend on the target", "call the function of `bessemer::rotation` or `bessemer::complex` for it: `rotation::angle(&q)`, `rotation::from_scaled_axis(v)`, `complex::norm(&z)` and the like";
    QUATERNION_PARTS: "the parts of a quaternion are no vector in the C", "write to `q.i`, `q.j`, `q.k` and `q.w`, or assign a new quaternion";
    MOVED_VIEW: "a view that is written stays where it is in the DSL", "give it a name by `let`, and use that; for a copy of it call `.into_owned()`";
    REFERENCE_VALUE: "a reference is not a value in the DSL", "copy what it refers to, or pass the reference as an argument";
    EMPTY_ARRAY: "an array or matrix without elements is not in the DSL", "C has none: give it an element, or pass no part of another array, `&other[..0]`";
    ARRAY_OF_NOTHING: "an array of zero-sized elements is not in the DSL", "keep the count, or an array of `bool`; write `core::array::from_fn(|i| …)` for `[(); N].map(|()| …)`";
    EMPTY_COMPONENT: "a component whose fields are zero-sized has no state to keep", "mark it and its `impl` blocks `#[data]`, or give it a field";
    EMPTY_NAME: "a zero-sized struct is no type in the C, and has no name there", "leave the name out, or give one to its methods";
    KEPT_NOTHING: "a zero-sized value is not kept here in the DSL", "leave it out: there is one value alone";
    ONE_OR_OTHER: "this may be a part of one array or of another, which is decided at run time", "let both be parts of one array, or do what is to be done in each branch";
    CHOSEN: "the array that this is a part of is chosen while the name lives", "compute its index above the `let`";
    OF_MATRIX: "a value refers to elements of arrays in the DSL, and this is one of a matrix", "find where it is, and index: `if let Some(at) = m.iter().position(|x| …) { m[at] = … }`";
    UNNAMEABLE: "what this function gives is a part of an array that its caller cannot name", "let the caller pass the array itself, and give a part of it";
    MANY_SLICES: "an array or a list of slices is not in the DSL", "keep their ends, an array of pairs, or a field for each slice";
    LENT: "what this lends is no value in the DSL", "take it apart where it is called: `if let Some(x) = values.get_mut(i) { … }`, `let (a, b) = values.split_at(n);`";
    LENT_BY_OPTION: "what this lends is no value in the DSL", "take it apart where it is called: `if let Some(x) = self.last.as_mut() { … }`";
    MAY_MEET: "two arguments are parts of one array, one of them to be written, and nothing shows that they have no element in common", "pass the halves of one `split_at_mut` as they are, and take the parts in the function: `merge(low, n, high)`, there `low[..n]`";
}
