//! Rewords rustc's messages about the builders' own names in the author's terms, with a remedy.

use super::hints;
use super::remedies::instead;
use super::rustc::{Mark, Message};
use super::types;

/// Replacement for rustc's text.
pub struct Words {
    /// Message.
    pub title: String,
    /// Remedy.
    pub help: String,
    /// Name of the type that the message is about.
    pub of_type: Option<String>,
    /// Scope in which the message is reported once.
    pub once: Once,
    /// True if an attribute reports it about its own item; false if the builders or the witness copy do.
    pub is_refusal: bool,
}

/// Scope in which a message is reported once, however often rustc repeats it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Once {
    /// A line.
    Line,
    /// A function or a type.
    Item,
    /// A file.
    File,
}

/// Returns words for a mistake of a function or a type.
pub fn words(title: impl Into<String>, help: impl Into<String>) -> Option<Words> {
    let (title, help) = (title.into(), help.into());
    Some(Words { title, help, of_type: None, once: Once::Item, is_refusal: false })
}

/// Returns the rewording of a message about the DSL; none for other messages.
pub fn of(message: &Message<'_>) -> Option<Words> {
    if !message.is_error {
        return None;
    }
    const EACH: [fn(&Message<'_>) -> Option<Words>; 13] = [
        refused, attribute, misplaced, component, unmarked, initial, order, function, pattern,
        interface, builders, dimensions, global,
    ];
    EACH.iter().find_map(|it| it(message)).or_else(|| unnamed(message))
}

/// Rewords a refusal by an attribute, whose remedy is in separate lines.
fn refused(message: &Message<'_>) -> Option<Words> {
    let (title, help) = message.title.split_once("\nhelp: ")?;
    Some(Words { is_refusal: true, ..words(title, help)? })
}

/// Attributes of the DSL.
const ATTRIBUTES: [&str; 13] = [
    "component",
    "data",
    "entry",
    "function",
    "interface",
    "bound",
    "unroll",
    "keep",
    "unit",
    "range",
    "axes",
    "external",
    "c",
];

/// Rewords an unknown attribute that is the DSL's and was not imported.
fn attribute(message: &Message<'_>) -> Option<Words> {
    let name = message.title.strip_prefix("cannot find attribute `")?.split('`').next()?;
    if !ATTRIBUTES.contains(&name) {
        return None;
    }
    let reported = words(
        "the attributes of the DSL are not in scope",
        "write `use bessemer::prelude::*;` at the head of the file",
    )?;
    Some(Words { once: Once::File, ..reported })
}

/// Rewords an attribute of the DSL on a field or another part of an item.
fn misplaced(message: &Message<'_>) -> Option<Words> {
    let title =
        message.title.strip_prefix("expected non-macro attribute, found attribute macro `")?;
    let name = title.strip_suffix('`')?;
    let (place, help) = match name {
        "entry" => (
            "a method in an `impl` block marked `#[component]`",
            "remove it: the fields of a component are in its C struct; to return one, write a method that is an entry point",
        ),
        "function" => ("a free function", "remove it"),
        "interface" => ("a trait", "remove it"),
        "data" | "component" => (
            "a struct, an enum, an `impl` block or a constant",
            "remove it: a part is in the C as the whole is; mark the declaration of the part's type",
        ),
        _ => return None,
    };
    words(format!("`#[{name}]` belongs on {place}"), help)
}

/// Rewords a component that a vector of nalgebra does not have.
fn component(message: &Message<'_>) -> Option<Words> {
    const NAMES: [&str; 4] = ["x", "y", "z", "w"];
    let [field, owner] = message.quoted()[..] else { return None };
    let owner = types::written(owner);
    let size = owner.strip_prefix("SVector<")?.strip_suffix('>')?.split(", ").nth(1)?;
    let (size, has_vector) = (size.parse::<usize>().ok()?, NAMES.contains(&field));
    if message.code != "E0609" || !has_vector || size == 0 {
        return None;
    }
    let shown = NAMES.get(..size).map(|it| format!("`{}`", it.join("`, `")));
    let shown = shown.unwrap_or_else(|| "no components by name".to_owned());
    let help = match size {
        1..=3 => format!(
            "use one of these, or a `Vector{}`",
            1 + NAMES.iter().position(|it| *it == field)?
        ),
        4 => "use one of these".to_owned(),
        _ => "index the element: `v[3]`".to_owned(),
    };
    words(format!("no field `{field}`: a `Vector{size}` has {shown}"), help)
}

/// Rewords an implementation of a trait that is no interface, so its companions are missing in the trait.
fn interface(message: &Message<'_>) -> Option<Words> {
    let quoted = message.quoted();
    let of = match (message.code, quoted.as_slice()) {
        ("E0407" | "E0576", [method, of, ..]) if method.starts_with("__") => of,
        _ => return None,
    };
    words(format!("the trait `{of}` is not part of the DSL"), "mark the trait `#[interface]`")
}

/// Rewords matrices of different dimensions.
fn dimensions(message: &Message<'_>) -> Option<Words> {
    let (title, help) = hints::dimensions(message)?;
    Some(Words { once: Once::Line, ..words(title, help)? })
}

/// Rewords the use of a `static mut`.
fn global(message: &Message<'_>) -> Option<Words> {
    let is_static = message.code == "E0133" && message.title.starts_with("use of mutable static");
    let name = message.mark()?.text();
    is_static
        .then(|| words(format!("`{name}` is a global that any code can change"), types::STATE))?
}

/// Message about an unknown item.
pub const UNNAMED: &str = "this is not part of the DSL";

/// Rewords other messages with names that no author has written.
fn unnamed(message: &Message<'_>) -> Option<Words> {
    const INTERNAL: [&str; 4] = ["__", OWNED, "bessemer::generate", "ScalarType"];
    let label = message.mark().map_or("", |mark| mark.label);
    let shows = |text: &str| INTERNAL.iter().any(|it| text.contains(it));
    if label.contains("found `Items<") {
        return words("a range expression cannot be a value here", hints::ENDS);
    }
    if message.code == "E0119" && message.title.contains("OwnImplied") {
        return words(
            "a generic type can implement `Index` only once",
            "write a method for the other index: `fn cell(&self, at: (usize, usize)) -> &T`",
        );
    }
    if message.code == "E0034" {
        return words(
            "rustc cannot tell whether this is the method of a float or of the type parameter",
            "write a closure that calls the method: `|a, b| a.max(b)`",
        );
    }
    (shows(message.title) || shows(label)).then(|| {
        words(UNNAMED, "write it out with supported operations: see docs/book/reference/methods.md")
    })?
}

/// First words about a function without attribute.
pub const UNMARKED: &str = "the function around this is not marked";

/// Rewords a method of floats that only marked functions have where there is no `std`.
fn unmarked(message: &Message<'_>) -> Option<Words> {
    let quoted = message.quoted();
    let [method, owner, ..] = quoted.as_slice() else { return None };
    let is_float = matches!(*owner, "f64" | "f32" | "{float}");
    let is_method = message.title.starts_with("no method named");
    if !is_method || !is_float || !OF_FLOATS.contains(method) {
        return None;
    }
    let title = format!("{UNMARKED}: without `std` it has no `{method}` of `{owner}`");
    words(
        title,
        "mark it `#[function]`; a method, by `#[data]` or `#[component]` on its `impl` block",
    )
}

/// Methods of floats that `core` does not have.
const OF_FLOATS: [&str; 35] = [
    "acos",
    "acosh",
    "asin",
    "asinh",
    "atan",
    "atan2",
    "atanh",
    "cbrt",
    "cos",
    "cosh",
    "div_euclid",
    "exp",
    "exp2",
    "exp_m1",
    "hypot",
    "ln",
    "ln_1p",
    "log",
    "log10",
    "log2",
    "mul_add",
    "powf",
    "powi",
    "rem_euclid",
    "sin",
    "sin_cos",
    "sinh",
    "sqrt",
    "tan",
    "tanh",
    "floor",
    "ceil",
    "round",
    "trunc",
    "fract",
];

/// Rewords a comparison in a sort whose closure returns no order.
fn order(message: &Message<'_>) -> Option<Words> {
    let is_ours = message.code == "E0599" && message.quoted().first() == Some(&"is_lt");
    is_ours
        .then(|| words("the closure of `sort_by` does not return an `Ordering`", hints::ORDER))?
}

/// Rewords a state whose parameter has no `Default`, or is not marked: a mark of the state's type, `Motor<On>`.
fn initial(message: &Message<'_>) -> Option<Words> {
    let of = message
        .title
        .strip_prefix("the trait bound `")?
        .strip_suffix(": Default` is not satisfied")?;
    if message.code != "E0277"
        || !message.rendered.contains("bessemer::generate")
            && !message.rendered.contains("introduced by this call")
    {
        return None;
    }
    let of = types::within_modules(of);
    let reported = words(
        format!("`{of}` has no `Default`, which the initial state requires"),
        format!(
            "mark it `#[data]`, and derive `Clone`, `Copy` and `Default` below: `#[data] #[derive(Clone, Copy, Default)] pub struct {of};`"
        ),
    )?;
    Some(Words { once: Once::File, ..reported })
}

/// Rewords the call of an unmarked function, which has no builder.
fn function(message: &Message<'_>) -> Option<Words> {
    let label = message.mark()?.label;
    // One of a module: `expected type, found function `limit` in `tools``.
    if let Some(of_module) = label.strip_prefix("expected type, found function `") {
        let name = of_module.split('`').next()?;
        return words(
            format!("`{name}` is not part of the DSL"),
            "mark the function `#[function]`",
        );
    }
    let label = label.strip_suffix(" is not a crate or module")?;
    if let Some(name) = label.strip_prefix("constant ").or_else(|| label.strip_prefix("static ")) {
        return words(
            format!("{name} has a lower-case name, which is read as a function here"),
            "rename the constant in capitals, as rustc also advises",
        );
    }
    let name = label.strip_prefix("function ")?;
    let help = match name {
        "`swap`" | "`replace`" | "`take`" => MEM,
        "`max`" | "`min`" => CMP,
        _ => "mark the function `#[function]`",
    };
    words(format!("{name} is not part of the DSL"), help)
}

/// Remedy for functions that may be `core::mem`'s.
const MEM: &str =
    "write `core::mem::swap(&mut a, &mut b)` whole, or mark a function of your own `#[function]`";

/// Remedy for functions that may be `core::cmp`'s.
const CMP: &str = "write `core::cmp::max(a, b)` whole, or `a.max(b)`; or mark a function of your own `#[function]`";

/// Rewords a name that looks like a variant or an associated function, and is neither.
fn pattern(message: &Message<'_>) -> Option<Words> {
    if ["E0223", "E0599"].contains(&message.code)
        && message.rendered.contains("__b_")
        && !message.title.contains("__")
        && !message.title.starts_with("no method named")
    {
        return words(
            "a type alias with a lower-case name cannot be used to call a function",
            "rename the alias with a capital, `type Real32 = f32;`, or call the method",
        );
    }
    if message.code == "E0223" && message.mark().is_some_and(is_pattern) {
        return words(
            "this path is not a variant",
            "name a constant in a pattern in capitals: `Preset::IDLE`",
        );
    }
    None
}

/// Returns true if an error is at a pattern of a `match`, judging by its line.
fn is_pattern(mark: &Mark<'_>) -> bool {
    ["=>", "|", "if "].iter().any(|next| mark.rest().trim_start().starts_with(next))
}

/// Macros that a model may call; the builders let rustc check that they are Rust's.
const TAKEN_MACROS: [&str; 8] = [
    "assert",
    "assert_eq",
    "assert_ne",
    "matches",
    "panic",
    "todo",
    "unimplemented",
    "unreachable",
];

/// Prefix of the DSL's own methods.
const OWNED: &str = "dsl_";

/// Rewords messages about names in builders.
fn builders(message: &Message<'_>) -> Option<Words> {
    let (title, quoted) = (message.title, message.quoted());
    // The builders request the one, what is simulated for the other, of the methods that the DSL owns.
    let owned = |name: &&str| message.code == "E0599" && name.starts_with(OWNED);
    let owned = quoted.iter().find(|name| owned(name)).and_then(|name| name.strip_prefix(OWNED));
    let method = quoted.iter().find_map(|name| name.strip_prefix("__b_")).or(owned);
    let owner = types::written(quoted.last().copied().unwrap_or_default());
    // Parameters of nalgebra's own declaration say nothing.
    let owner = owner.strip_suffix("<T, D>").unwrap_or(&owner).to_owned();
    if let Some(method) = method {
        let help = if let Some(help) = instead(method, &owner).or_else(|| types::instead(&owner)) {
            help
        } else if types::is_parameter(&owner) {
            "mark the trait that has it `#[interface]`, and the `impl` blocks of it `#[data]` or `#[component]`"
        } else if method == "clone" {
            "derive `Clone` below `#[data]`; build a value with a slice again"
        } else if types::is_known(&owner) {
            "write it out with supported operations: see docs/book/reference/methods.md; if a trait of your own has it, mark the trait `#[interface]` and its `impl` blocks `#[data]`"
        } else {
            "mark the `impl` block that has it `#[data]` or `#[component]`"
        };
        let owner = types::within_modules(&owner);
        if owner.starts_with("Items<") {
            return words(
                format!("`{method}` after an iterator adapter is not part of the DSL"),
                "write a `for` over the iterator before it, which skips items in its body and ends with `break`",
            );
        }
        return words(format!("`{method}` of `{owner}` is not part of the DSL"), help);
    }
    if title.starts_with("`core::cmp::max` and") {
        return words(title, "write `a.max(b)`, of references `*a.max(b)`");
    }
    if title.contains("`__call`") {
        return words(
            format!("`{owner}` is not part of the DSL"),
            "mark the function `#[function]`",
        );
    }
    if let ([name], true) = (quoted.as_slice(), title.ends_with("` is ambiguous")) {
        let help = "rename it: models use Rust's item of this name";
        if TAKEN_MACROS.contains(name) {
            return words(format!("an own macro has the name of Rust's `{name}!`"), help);
        }
        if ["matrix", "vector"].contains(name) {
            return words(
                format!("an own macro has the name of nalgebra's `{name}!`"),
                "rename it: models use nalgebra's item of this name",
            );
        }
        if ["ComplexField", "RealField"].contains(name) {
            return words(
                format!("an own trait has the name of nalgebra's `{name}`"),
                "rename it: models use nalgebra's item of this name",
            );
        }
        if ["array", "cmp", "mem"].contains(name) {
            return words(format!("an own module has the name of Rust's `{name}`"), help);
        }
    }
    None
}
