//! `bessemer_parameter_table.h` and `.c`: tables of the entry points' parameters, by which firmware lists, reads and
//! sets them by number, for a ground station.
//!
//! Parameters are the numbers in data that an entry point takes and that has a default. A number is read and set as a
//! `double`, as ground stations send it; a value that the parameter cannot represent is refused.
//!
//! Invariants: no row can produce a value that is invalid in Rust, so the tag of an enum and the length of a list
//! have no row. The same C gives the same tables. It must not know what the C computes.

use std::fmt::Write as _;

use bessemer_backend::c::CFile;
use bessemer_backend::c::interface::{Bytes, Interface, Leaf, Struct};
use bessemer_codegen::compile::Options;

/// A parameter: one number, or the elements of an array or a matrix.
pub struct Row {
    /// Path in the struct: `axes[2].gain`.
    pub name: String,
    /// C type of an element.
    pub ty: &'static str,
    /// Number of elements.
    pub count: u32,
    /// Unit of the parameter.
    pub unit: Option<String>,
    /// Lower limit: of its range, or of its type.
    pub low: f64,
    /// Upper limit.
    pub high: f64,
    /// Offset in the struct, bytes.
    pub offset: Bytes,
    /// Size of an element, bytes.
    pub size: u32,
}

/// A type of numbers.
struct Number {
    /// Name of the type in C.
    ty: &'static str,
    /// Suffix of its enumerator.
    name: &'static str,
    size: u32,
    low: f64,
    high: f64,
}

/// The number up to which `double` represents every whole number.
const EXACT: f64 = 9007199254740991.0;

const NUMBERS: [Number; 11] = [
    Number { ty: "bool", name: "BOOL", size: 1, low: 0.0, high: 1.0 },
    Number { ty: "int8_t", name: "INT8", size: 1, low: -128.0, high: 127.0 },
    Number { ty: "uint8_t", name: "UINT8", size: 1, low: 0.0, high: 255.0 },
    Number { ty: "int16_t", name: "INT16", size: 2, low: -32768.0, high: 32767.0 },
    Number { ty: "uint16_t", name: "UINT16", size: 2, low: 0.0, high: 65535.0 },
    Number { ty: "int32_t", name: "INT32", size: 4, low: -2147483648.0, high: 2147483647.0 },
    Number { ty: "uint32_t", name: "UINT32", size: 4, low: 0.0, high: 4294967295.0 },
    Number { ty: "int64_t", name: "INT64", size: 8, low: -EXACT, high: EXACT },
    Number { ty: "uint64_t", name: "UINT64", size: 8, low: 0.0, high: EXACT },
    Number { ty: "float", name: "FLOAT", size: 4, low: f32::MIN as f64, high: f32::MAX as f64 },
    Number { ty: "double", name: "DOUBLE", size: 8, low: f64::MIN, high: f64::MAX },
];

/// The structs that hold parameters, each with its rows.
pub fn tables(face: &Interface) -> impl Iterator<Item = (&Struct, Vec<Row>)> {
    // Only what an entry point takes has a function that sets its default.
    let taken = face.structs.iter().filter(|it| !it.component && it.set_by.is_some());
    let tables = taken.map(move |it| {
        let whole = |inner: &Struct| inner.whole && !inner.rust.starts_with("bessemer::");
        (it, face.leaves_of(it, &whole).iter().filter_map(row).collect::<Vec<_>>())
    });
    tables.filter(|(_, rows)| !rows.is_empty())
}

fn row(leaf: &Leaf<'_>) -> Option<Row> {
    let number = NUMBERS.iter().find(|it| it.ty == leaf.value.ty)?;
    let count = leaf.value.dimensions.iter().copied().product::<Option<u32>>()?;
    // The ends of a `float` are what it makes of them.
    let end = |end: f64| if number.ty == "float" { f64::from(end as f32) } else { end };
    let (low, high) = match leaf.value.range {
        Some(range) => (end(range.low()).max(number.low), end(range.high()).min(number.high)),
        None => (number.low, number.high),
    };
    Some(Row {
        name: leaf.path.clone(),
        ty: number.ty,
        count,
        unit: leaf.value.unit.clone(),
        low,
        high,
        offset: leaf.offset,
        size: number.size,
    })
}

/// Returns the two files; `None` if there is no parameter.
pub fn files(face: &Interface, options: &Options, license: &str) -> Vec<CFile> {
    let stem = &options.status;
    let tables: Vec<_> = tables(face).collect();
    if tables.is_empty() {
        return Vec::new();
    }
    let name = format!("{stem}_parameter_table");
    let (header_name, source_name) = (options.header(&name), format!("{name}.c"));
    let guard = header_name.replace(['.', '-', '/'], "_").to_uppercase();
    let file = |name: String, text: String| CFile {
        name,
        text: text
            .replace("@HEADER@", &header_name)
            .replace("@GUARD@", &guard)
            .replace("@SOURCE@", &source_name)
            .replace("@LICENSE@", license)
            .replace("@STEM@", &stem.to_uppercase())
            .replace("@stem@", stem),
        map: Vec::new(),
    };
    vec![file(header_name.clone(), header(&tables)), file(source_name.clone(), source(&tables))]
}

/// Returns the prefix of the names of a struct's table: `gains` for `gains_t`.
fn own(of: &Struct) -> &str {
    of.name.strip_suffix("_t").unwrap_or(&of.name)
}

/// Names of the indices of a struct's parameters: `GAINS_PARAMETER_AXES_1_GAIN`.
///
/// A name depends on its parameter alone, so that it means the same one when others are added before it.
pub fn index_names(of: &Struct, rows: &[Row]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for row in rows {
        let words = row.name.split(|it: char| !it.is_ascii_alphanumeric() && it != '_');
        let words: Vec<&str> = words.filter(|it| !it.is_empty()).collect();
        let mut name = format!("{}_PARAMETER_{}", own(of), words.join("_")).to_uppercase();
        while names.contains(&name) {
            name.push('_');
        }
        names.push(name);
    }
    names
}

fn header(tables: &[(&Struct, Vec<Row>)]) -> String {
    let mut headers: Vec<&str> = tables.iter().map(|(it, _)| it.header.as_str()).collect();
    headers.sort_unstable();
    headers.dedup();
    let includes: String = headers.iter().map(|it| format!("#include \"{it}\"\n")).collect();
    let types: Vec<String> = (0..)
        .zip(&NUMBERS)
        .map(|(at, it)| format!("    @STEM@_PARAMETER_{} = {at}", it.name))
        .collect();
    let mut faces = String::new();
    for (of, rows) in tables {
        let (own, ty, count) = (own(of), &of.name, rows.len());
        let indices: String = (0..)
            .zip(index_names(of, rows))
            .map(|(at, name): (u32, _)| format!("#define {name} {at}U\n"))
            .collect();
        let _ = write!(
            faces,
            "
/** How many parameters a `{ty}` has. */
#define {upper}_PARAMETERS {count}U

/* Their indices: a name stays with its parameter when others are added. */
{indices}
/** The parameters of a `{ty}`. */
extern const @stem@_parameter_t {own}_parameters[{upper}_PARAMETERS];

/** Reads an element of a parameter. False, and `value` is as it was, if there is none or a `double` cannot hold it. */
bool {own}_parameter_get(const {ty} *self, size_t index, size_t element, double *value);

/** Sets an element of a parameter. False, and all is as it was, if there is none or the number is none that it takes. */
bool {own}_parameter_set({ty} *self, size_t index, size_t element, double value);
",
            upper = own.to_uppercase(),
        );
    }
    let types = types.join(",\n");
    format!(
        "\
/*
 * @HEADER@: the parameters of the entry points, listed, read and set by number.
 *
 * Generated by Bessemer; edit the Rust instead.
 * SPDX-License-Identifier: @LICENSE@
 *
 * Read and set between two calls of the entry points, not while one runs.
 */
#ifndef @GUARD@
#define @GUARD@

#include <stdbool.h>
#include <stddef.h>

{includes}
#ifdef __cplusplus
extern \"C\" {{
#endif

/** The type of a parameter's elements. */
typedef enum {{
{types}
}} @stem@_parameter_type_t;

/** A parameter: a number, or the elements of an array. */
typedef struct {{
    /** Its way in the struct. */
    const char *name;
    /** Its unit; empty if it has none. */
    const char *unit;
    /** The least number that it takes. */
    double low;
    /** The greatest number that it takes. */
    double high;
    /** Where it begins in the struct, in bytes. */
    size_t offset;
    /** The bytes of an element. */
    size_t size;
    /** How many elements it has. */
    size_t count;
    /** The type of an element. */
    @stem@_parameter_type_t type;
}} @stem@_parameter_t;
{faces}
#ifdef __cplusplus
}}
#endif

#endif
"
    )
}

fn source(tables: &[(&Struct, Vec<Row>)]) -> String {
    let used =
        |number: &&Number| tables.iter().any(|(_, rows)| rows.iter().any(|it| it.ty == number.ty));
    let (mut reads, mut sets) = (String::new(), String::new());
    for Number { ty, name, .. } in NUMBERS.iter().filter(used) {
        let zero = if *ty == "bool" { "false" } else { "0" };
        let (read, check, set) = match *ty {
            "bool" => ("it ? 1.0 : 0.0".to_owned(), "true", "number > 0.5".to_owned()),
            "int64_t" | "uint64_t" => {
                ("(double)it".to_owned(), "is_exact(number)", format!("({ty})number"))
            }
            "double" => ("it".to_owned(), "true", "number".to_owned()),
            _ => ("(double)it".to_owned(), "true", format!("({ty})number")),
        };
        let case = format!("    case @STEM@_PARAMETER_{name}: {{\n");
        let _ = write!(
            reads,
            "{case}        {ty} it = {zero};\n        copy((unsigned char *)&it, bytes, sizeof(it));\n        number = {read};\n        \
             known = {check};\n        break;\n    }}\n"
        );
        let _ = write!(
            sets,
            "{case}        const {ty} it = {set};\n        copy(bytes, (const unsigned char *)&it, sizeof(it));\n        break;\n    }}\n"
        );
    }
    let wide = |it: &Number| it.size == 8 && it.name != "DOUBLE";
    let exact = if NUMBERS.iter().filter(used).any(wide) {
        format!(
            "\n/* Whether a double of this size has every whole number. */\nstatic bool is_exact(double number)\n{{\n    \
             return (number >= -{EXACT:?}) && (number <= {EXACT:?});\n}}\n"
        )
    } else {
        String::new()
    };
    let mut own_tables = String::new();
    for (of, rows) in tables {
        own_tables += &table(of, rows);
    }
    format!(
        "\
/*
 * @SOURCE@: the parameters of the entry points, listed, read and set by number.
 *
 * Generated by Bessemer; edit the Rust instead.
 * SPDX-License-Identifier: @LICENSE@
 */
#include \"@HEADER@\"

#include <float.h>
#include <stdint.h>

/* Bytes, one by one: of what type they are, the table says. */
static void copy(unsigned char *to, const unsigned char *from, size_t size)
{{
    for (size_t at = 0; at < size; at++) {{
        to[at] = from[at];
    }}
}}
{exact}
/* Reads a number of this type. */
static bool get(@stem@_parameter_type_t type, const unsigned char *bytes, double *value)
{{
    double number = 0.0;
    bool known = false;
    switch (type) {{
{reads}    default:
        break;
    }}
    if (known) {{
        *value = number;
    }}
    return known;
}}

/* The number that a parameter holds if it is set to this one. */
static double held(@stem@_parameter_type_t type, double value)
{{
    double number = value;
    if ((type == @STEM@_PARAMETER_FLOAT) && (value >= -(double)FLT_MAX) && (value <= (double)FLT_MAX)) {{
        number = (double)(float)value;
    }}
    return number;
}}

/* Whether a parameter takes this number: NaN is in no range, and a whole number has no fraction. */
static bool takes(const @stem@_parameter_t *parameter, double number)
{{
    bool taken = (number >= parameter->low) && (number <= parameter->high);
    if (taken && (parameter->type != @STEM@_PARAMETER_FLOAT) && (parameter->type != @STEM@_PARAMETER_DOUBLE)) {{
        const double whole = (double)(int64_t)number;
        taken = (whole >= number) && (whole <= number);
    }}
    return taken;
}}

/* Sets a number of this type, which takes it. */
static void set(@stem@_parameter_type_t type, unsigned char *bytes, double number)
{{
    switch (type) {{
{sets}    default:
        break;
    }}
}}
{own_tables}"
    )
}

/// Formats a table and its functions.
fn table(of: &Struct, rows: &[Row]) -> String {
    let (own, ty) = (own(of), &of.name);
    let upper = own.to_uppercase();
    let mut lines = String::new();
    for row in rows {
        let name = NUMBERS.iter().find(|it| it.ty == row.ty).map_or("", |it| it.name);
        let _ = writeln!(
            lines,
            "    {{\"{}\", {}, {:?}, {:?}, offsetof({ty}, {0}), sizeof({}), {}U, @STEM@_PARAMETER_{name}}},",
            row.name,
            quoted(row.unit.as_deref().unwrap_or_default()),
            row.low,
            row.high,
            row.ty,
            row.count,
        );
    }
    format!(
        "
const @stem@_parameter_t {own}_parameters[{upper}_PARAMETERS] = {{
{lines}}};

bool {own}_parameter_get(const {ty} *self, size_t index, size_t element, double *value)
{{
    bool known = false;
    if ((index < {upper}_PARAMETERS) && (element < {own}_parameters[index].count)) {{
        const @stem@_parameter_t *const parameter = &{own}_parameters[index];
        const size_t place = parameter->offset + (element * parameter->size);
        known = get(parameter->type, &((const unsigned char *)self)[place], value);
    }}
    return known;
}}

bool {own}_parameter_set({ty} *self, size_t index, size_t element, double value)
{{
    bool taken = false;
    if ((index < {upper}_PARAMETERS) && (element < {own}_parameters[index].count)) {{
        const @stem@_parameter_t *const parameter = &{own}_parameters[index];
        const size_t place = parameter->offset + (element * parameter->size);
        const double number = held(parameter->type, value);
        taken = takes(parameter, number);
        if (taken) {{
            set(parameter->type, &((unsigned char *)self)[place], number);
        }}
    }}
    return taken;
}}
"
    )
}

/// Formats a string literal in C.
fn quoted(text: &str) -> String {
    let text = text.replace('\\', "\\\\").replace('"', "\\\"").replace('?', "\\?");
    format!("\"{text}\"")
}
