//! The interface of the C as data: sizes and offsets are the compilers', and `interface.json` is what its schema says.

use std::fmt::Write as _;

use bessemer_backend::c::interface::Bytes;
use bessemer_legs::process::lay_out;
use bessemer_project::interface;
use bessemer_tests::toolchain::{self, CORTEX_M4F, GCC, run};
use bessemer_tests::{flight_models, root};
use serde_json::{Value, json};

/// Selection of one of the two sizes.
type Chosen = fn(Bytes) -> u64;

#[test]
fn sizes_and_offsets_are_the_compilers() {
    let compiled = flight_models();
    let folder = lay_out(compiled).expect("the C");
    let layouts: [(_, Chosen); 2] = [(GCC, |it| it.int_enums), (CORTEX_M4F, |it| it.short_enums)];
    for (toolchain, bytes) in layouts {
        if !toolchain.programs().into_iter().all(toolchain::is_asked_for) {
            println!("left out: {} is not installed", toolchain.name());
            continue;
        }
        let mut text = String::from("#include <stddef.h>\n");
        for it in &compiled.interface.structs {
            let _ = writeln!(text, "#include \"{}\"", it.header);
        }
        let mut checks = 0;
        let mut check = |name: String, is: String, said: u64| {
            checks += 1;
            let _ = writeln!(text, "typedef char {name}[({is} == {said}U) ? 1 : -1];");
        };
        for it in &compiled.interface.structs {
            let ty = &it.name;
            check(format!("size_of_{ty}"), format!("sizeof({ty})"), bytes(it.size));
            for field in &it.fields {
                let name = format!("{ty}_{}", field.name.replace('.', "_"));
                check(name, format!("offsetof({ty}, {})", field.name), bytes(field.offset));
            }
        }
        assert!(checks > 200, "{checks} sizes and offsets");
        let source = folder.path().join("checks.c");
        std::fs::write(&source, text).expect("a file");
        run(toolchain.command().arg("-fsyntax-only").arg(&source))
            .unwrap_or_else(|said| panic!("{}: {said}", toolchain.name()));
    }
}

#[test]
fn the_file_is_what_its_schema_says() {
    let text = std::fs::read_to_string(root().join("docs/interface.schema.json")).expect("there");
    let schema: Value = serde_json::from_str(&text).expect("JSON");
    let text = interface::text("models", &flight_models().interface);
    let mut face: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(wrong(&schema, &schema, &face, ""), None);
    face["structs"][0]["size"] = json!("8");
    let said = wrong(&schema, &schema, &face, "");
    assert_eq!(said.as_deref(), Some("/structs/0/size: no object"));
}

/// Returns the place where a value violates a schema, for the keywords of JSON Schema that ours uses.
fn wrong(root: &Value, schema: &Value, value: &Value, at: &str) -> Option<String> {
    if let Some(name) = schema["$ref"].as_str() {
        let place = name.trim_start_matches('#');
        return wrong(root, root.pointer(place).expect("a definition"), value, at);
    }
    if let Some(all) = schema["enum"].as_array() {
        return (!all.contains(value)).then(|| format!("{at}: {value}"));
    }
    let types = match &schema["type"] {
        Value::Array(types) => types.clone(),
        one => vec![one.clone()],
    };
    let is = |ty: &Value| match ty.as_str() {
        Some("object") => value.is_object(),
        Some("array") => value.is_array(),
        Some("string") => value.is_string(),
        Some("boolean") => value.is_boolean(),
        Some("integer") => value.is_i64() || value.is_u64(),
        Some("number") => value.is_number(),
        Some("null") => value.is_null(),
        other => panic!("{at}: the schema has the type {other:?}"),
    };
    if !types.iter().any(is) {
        return Some(format!("{at}: no {}", types[0].as_str().unwrap_or_default()));
    }
    if let (Some(members), Some(known)) = (value.as_object(), schema["properties"].as_object()) {
        let missing = schema["required"].as_array().into_iter().flatten();
        let missing = missing.filter_map(Value::as_str).find(|name| !members.contains_key(*name));
        if let Some(name) = missing {
            return Some(format!("{at}: no `{name}`"));
        }
        return members.iter().find_map(|(name, member)| {
            let at = format!("{at}/{name}");
            known
                .get(name)
                .map_or(Some(format!("{at}: unknown")), |it| wrong(root, it, member, &at))
        });
    }
    let items = value.as_array().into_iter().flatten().enumerate();
    items
        .map(|(index, it)| (format!("{at}/{index}"), it))
        .find_map(|(at, it)| wrong(root, &schema["items"], it, &at))
}
