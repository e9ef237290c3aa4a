//! The tables of parameters in C: listed, read and set by number, on the host's compilers and by the sanitizers.
//!
//! The interface is written by hand, with each type of number and what no table may have: no model has all of it.

use bessemer_backend::c::interface::{Bytes, Field, Interface, Struct, Value};
use bessemer_codegen::compile::Options;
use bessemer_ir::Range;
use bessemer_project::{interface, parameters};
use bessemer_tests::toolchain;
use serde_json::json;

/// A field, and what its C says of it.
fn field(name: &str, ty: &str, offset: u64, range: Option<(f64, f64)>) -> Field {
    let (name, dimension) = match name.split_once('[') {
        Some((name, rest)) => (name, rest.trim_end_matches(']').parse().ok()),
        None => (name, None),
    };
    let value = Value {
        ty: ty.to_owned(),
        dimensions: dimension.map(Some).into_iter().collect(),
        matrix: None,
        unit: (name == "gain").then(|| "\"V\"?".to_owned()),
        range: range.and_then(|(low, high)| Range::new(low, high)),
    };
    let offset = Bytes { int_enums: offset, short_enums: offset };
    Field { name: name.to_owned(), docs: Vec::new(), offset, value, axes: Vec::new() }
}

fn structure(name: &str, rust: &str, size: u64, fields: Vec<Field>) -> Struct {
    Struct {
        name: name.to_owned(),
        rust: rust.to_owned(),
        docs: Vec::new(),
        header: "tuned.h".to_owned(),
        component: false,
        whole: name != "list_t",
        scratch: false,
        set_by: (name == "tuned_t").then(|| "tuned_defaults".to_owned()),
        words: None,
        size: Bytes { int_enums: size, short_enums: size },
        fields,
    }
}

fn face() -> Interface {
    let axis = vec![field("gain", "double", 0, Some((0.0, 20.0)))];
    let list = vec![field("items[2]", "double", 0, None), field("len", "uint64_t", 16, None)];
    let tuned = vec![
        field("axes[2]", "axis_t", 0, None),
        field("slopes[3]", "float", 16, Some((0.1, 0.3))),
        field("steps", "int8_t", 28, Some((-200.0, 100.0))),
        field("on", "bool", 29, None),
        field("order", "uint16_t", 30, None),
        field("wide", "int64_t", 32, None),
        field("mode", "modes_t", 40, None),
        field("held", "list_t", 48, None),
        field("divisor", "non_zero_t", 72, None),
    ];
    Interface {
        structs: vec![
            structure("axis_t", "motor::Axis", 8, axis),
            structure("list_t", "motor::List2F64", 24, list),
            structure(
                "non_zero_t",
                "bessemer::non_zero::NonZero",
                4,
                vec![field("value", "uint32_t", 0, None)],
            ),
            structure("tuned_t", "motor::Tuned", 80, tuned),
        ],
        ..Interface::default()
    }
}

const HEADER: &str = "#ifndef TUNED_H\n#define TUNED_H\n#include <stdbool.h>\n#include <stdint.h>\n\
    typedef struct { double gain; } axis_t;\ntypedef struct { double items[2]; uint64_t len; } list_t;\n\
    typedef struct { uint32_t value; } non_zero_t;\ntypedef enum { MODE_A, MODE_B } modes_t;\n\
    typedef struct {\n    axis_t axes[2];\n    float slopes[3];\n    int8_t steps;\n    bool on;\n    uint16_t order;\n    int64_t wide;\n    \
    modes_t mode;\n    list_t held;\n    non_zero_t divisor;\n} tuned_t;\n#endif\n";

/// Each line: what is asked, and the answer.
const MAIN: &str = r#"#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "acme_parameter_table.h"

static tuned_t tuned;

/* Each index by its name. */
typedef char axes_1_gain[(TUNED_PARAMETER_AXES_1_GAIN == 1U) ? 1 : -1];
typedef char slopes[(TUNED_PARAMETER_SLOPES == 2U) ? 1 : -1];
typedef char wide[(TUNED_PARAMETER_WIDE + 1U == TUNED_PARAMETERS) ? 1 : -1];

static size_t named(const char *name)
{
    size_t at = 0;
    while (at < TUNED_PARAMETERS && strcmp(tuned_parameters[at].name, name) != 0) {
        at++;
    }
    return at;
}

static void put(const char *name, size_t element, double value)
{
    const bool taken = tuned_parameter_set(&tuned, named(name), element, value);
    double is = -77.0;
    const bool known = tuned_parameter_get(&tuned, named(name), element, &is);
    printf("%s %.17g: %d %d %.17g\n", name, value, (int)taken, (int)known, is);
}

int main(void)
{
    for (size_t at = 0; at < TUNED_PARAMETERS; at++) {
        const acme_parameter_t *const it = &tuned_parameters[at];
        printf("%s [%s] %d %.17g %.17g %u %u %u\n", it->name, it->unit, (int)it->type, it->low, it->high,
            (unsigned)it->offset, (unsigned)it->size, (unsigned)it->count);
    }
    put("axes[1].gain", 0, 20.0);
    put("axes[1].gain", 0, 20.5);
    put("axes[1].gain", 0, (double)NAN);
    put("axes[1].gain", 1, 1.0);
    put("slopes", 2, 0.1);
    put("slopes", 2, 0.3);
    put("slopes", 2, 0.31);
    put("slopes", 2, (double)INFINITY);
    put("slopes", 2, DBL_MAX);
    put("slopes", 3, 0.2);
    put("steps", 0, -128.0);
    put("steps", 0, -129.0);
    put("steps", 0, 0.5);
    put("steps", 0, 101.0);
    put("on", 0, 1.0);
    put("on", 0, 2.0);
    put("order", 0, 65535.0);
    put("order", 0, -1.0);
    put("wide", 0, -9007199254740991.0);
    put("wide", 0, 9007199254740992.0);
    tuned.wide = INT64_MAX;
    put("wide", 0, 0.5);
    put("mode", 0, 1.0);
    put("held.len", 0, 1.0);
    /* Nothing beside what was set has moved. */
    printf("%.17g %u %d %u\n", tuned.axes[0].gain, (unsigned)tuned.held.len, (int)tuned.mode, (unsigned)tuned.divisor.value);
    return 0;
}
"#;

const ANSWERS: &str = "axes[0].gain [\"V\"?] 10 0 20 0 8 1
axes[1].gain [\"V\"?] 10 0 20 8 8 1
slopes [] 9 0.10000000149011612 0.30000001192092896 16 4 3
steps [] 1 -128 100 28 1 1
on [] 0 0 1 29 1 1
order [] 4 0 65535 30 2 1
wide [] 7 -9007199254740991 9007199254740991 32 8 1
axes[1].gain 20: 1 1 20
axes[1].gain 20.5: 0 1 20
axes[1].gain nan: 0 1 20
axes[1].gain 1: 0 0 -77
slopes 0.10000000000000001: 1 1 0.10000000149011612
slopes 0.29999999999999999: 1 1 0.30000001192092896
slopes 0.31: 0 1 0.30000001192092896
slopes inf: 0 1 0.30000001192092896
slopes 1.7976931348623157e+308: 0 1 0.30000001192092896
slopes 0.20000000000000001: 0 0 -77
steps -128: 1 1 -128
steps -129: 0 1 -128
steps 0.5: 0 1 -128
steps 101: 0 1 -128
on 1: 1 1 1
on 2: 0 1 1
order 65535: 1 1 65535
order -1: 0 1 65535
wide -9007199254740991: 1 1 -9007199254740991
wide 9007199254740992: 0 1 -9007199254740991
wide 0.5: 0 0 -77
mode 1: 0 0 -77
held.len 1: 0 0 -77
0 0 0 0
";

#[test]
fn a_table_is_listed_read_and_set() {
    let folder = tempfile::tempdir().expect("a folder");
    let files =
        parameters::files(&face(), &Options { status: "acme".into(), ..Options::default() }, "MIT");
    let mut sources = vec![folder.path().join("main.c")];
    std::fs::write(&sources[0], MAIN).expect("a file");
    std::fs::write(folder.path().join("tuned.h"), HEADER).expect("a file");
    for file in &files {
        let path = folder.path().join(&file.name);
        std::fs::write(&path, &file.text).expect("a file");
        sources.extend(path.extension().is_some_and(|it| it == "c").then_some(path));
    }
    let sanitized = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"];
    for host in toolchain::host().into_iter().filter(|it| it.level == 2) {
        let program = folder.path().join("program");
        let more: &[&str] = if host.compiler == "gcc" { &sanitized } else { &[] };
        host.link(&sources, &program, more).unwrap_or_else(|said| panic!("{said}"));
        let output = std::process::Command::new(&program).output().expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(String::from_utf8_lossy(&output.stdout), ANSWERS, "{}: {said}", host.name());
    }
    it_is_cpp_too(&folder.path().join("acme_parameter_table.h"));
}

/// A field that is added before the others moves their indices, and not their names.
#[test]
fn names_of_indices_stay_when_a_parameter_is_added() {
    let names = |face: &Interface| {
        let named = |(of, rows): (&Struct, Vec<_>)| parameters::index_names(of, &rows);
        parameters::tables(face).flat_map(named).collect::<Vec<_>>()
    };
    let mut face = face();
    let before = names(&face);
    assert_eq!(before[..2], ["TUNED_PARAMETER_AXES_0_GAIN", "TUNED_PARAMETER_AXES_1_GAIN"]);
    let tuned = face.structs.iter_mut().find(|it| it.name == "tuned_t").expect("the struct");
    tuned.fields.insert(0, field("first", "double", 0, None));
    // A name that another parameter has gets a `_`.
    tuned.fields.push(field("axes_0", "axis_t", 80, None));
    let after = names(&face);
    assert_eq!(after[0], "TUNED_PARAMETER_FIRST");
    assert_eq!(after[1..=before.len()], before);
    assert_eq!(after.last().map(String::as_str), Some("TUNED_PARAMETER_AXES_0_GAIN_"));
}

fn it_is_cpp_too(header: &std::path::Path) {
    if !toolchain::is_asked_for("g++") {
        return;
    }
    let mut command = std::process::Command::new("g++");
    command.args(["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-x", "c++"]);
    toolchain::run(command.arg(header)).unwrap_or_else(|said| panic!("{said}"));
}

/// The description for other tools has the same rows.
#[test]
fn the_interface_has_the_same_rows() {
    let text = interface::text("motor", &face());
    let face: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let structs = face["structs"].as_array().expect("structs");
    let tuned = structs.iter().find(|it| it["name"] == "tuned_t").expect("the struct");
    assert!(
        structs.iter().filter(|it| it["name"] != "tuned_t").all(|it| it["parameters"].is_null())
    );
    let rows = tuned["parameters"].as_array().expect("rows");
    let lines: String = rows
        .iter()
        .map(|it| {
            let number = |at: &serde_json::Value| at.as_f64().expect("a number");
            let (low, high) = (number(&it["range"][0]), number(&it["range"][1]));
            let unit = it["unit"].as_str().unwrap_or_default();
            let (name, offset) = (it["name"].as_str().expect("a name"), &it["offset"]["int_enums"]);
            format!("{name} [{unit}] {low} {high} {offset} {} {}\n", it["size"], it["count"])
        })
        .collect();
    let type_is_left_out = |line: &str| {
        let mut words: Vec<&str> = line.split(' ').collect();
        words.remove(2);
        words.join(" ") + "\n"
    };
    let listed: String = ANSWERS.lines().take(rows.len()).map(type_is_left_out).collect();
    assert_eq!(lines, listed);
    assert_eq!(rows[2]["type"], json!("float"));
}
