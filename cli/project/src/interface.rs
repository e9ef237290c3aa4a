//! `interface.json`: a description of the C's interface for tools, in the form of `docs/interface.schema.json`.
//!
//! Invariant: the same C gives the same text. It must not know who reads it.

use bessemer_backend::c::interface::{
    Bytes, Entry, Enum, Field, Interface, Parameter, Struct, Value,
};
use bessemer_backend::c::names::Passing;
use serde_json::{Value as Json, json};

use crate::parameters::{self, Row};

/// The name of the file.
pub const NAME: &str = "interface.json";

/// The text of the file.
pub fn text(package: &str, face: &Interface) -> String {
    let json = json!({
        "package": package,
        "structs": face.structs.iter().map(|it| structure(face, it)).collect::<Json>(),
        "enums": face.enums.iter().map(enumeration).collect::<Json>(),
        "entries": face.entries.iter().map(entry).collect::<Json>(),
    });
    format!("{json:#}\n")
}

/// The first members of each item: its name, the header that declares it, its comment.
fn item(name: &str, header: &str, docs: &[String]) -> Json {
    let mut json = json!({ "name": name, "header": header });
    add(&mut json, "comment", comment(docs));
    json
}

fn structure(face: &Interface, it: &Struct) -> Json {
    let mut json = item(&it.name, &it.header, &it.docs);
    add(&mut json, "rust", Some(json!(it.rust)));
    add(&mut json, "component", Some(json!(it.component)));
    add(&mut json, "size", Some(bytes(it.size)));
    add(&mut json, "fields", Some(it.fields.iter().map(field).collect()));
    add(&mut json, "set_by", it.set_by.as_ref().map(|name| json!(name)));
    let rows = parameters::tables(face).find(|(of, _)| of.name == it.name);
    add(&mut json, "parameters", rows.map(|(_, rows)| rows.iter().map(row).collect()));
    json
}

fn row(it: &Row) -> Json {
    let mut json = json!({
        "name": it.name, "type": it.ty, "count": it.count, "range": [it.low, it.high], "size": it.size,
    });
    add(&mut json, "unit", it.unit.as_ref().map(|unit| json!(unit)));
    add(&mut json, "offset", Some(bytes(it.offset)));
    json
}

fn field(it: &Field) -> Json {
    let mut json = value(&it.value);
    add(&mut json, "name", Some(json!(it.name)));
    add(&mut json, "axes", (!it.axes.is_empty()).then(|| json!(it.axes)));
    add(&mut json, "comment", comment(&it.docs));
    add(&mut json, "offset", Some(bytes(it.offset)));
    json
}

fn bytes(it: Bytes) -> Json {
    json!({ "int_enums": it.int_enums, "short_enums": it.short_enums })
}

fn value(it: &Value) -> Json {
    let mut json = json!({ "type": it.ty });
    add(&mut json, "dimensions", (!it.dimensions.is_empty()).then(|| json!(it.dimensions)));
    let shape = |(rows, columns): (u32, u32)| json!({ "rows": rows, "columns": columns });
    add(&mut json, "matrix", it.matrix.map(shape));
    add(&mut json, "unit", it.unit.as_ref().map(|unit| json!(unit)));
    add(&mut json, "range", it.range.map(|range| json!([range.low(), range.high()])));
    add(&mut json, "beyond_its_range", it.range.and_then(|it| it.enforced()).map(|it| json!(it)));
    json
}

fn enumeration(it: &Enum) -> Json {
    let variants = it.variants.iter().map(|(name, value, docs)| {
        let mut json = json!({ "name": name, "value": value });
        add(&mut json, "comment", comment(docs));
        json
    });
    let mut json = item(&it.name, &it.header, &it.docs);
    add(&mut json, "size", Some(bytes(it.size)));
    add(&mut json, "variants", Some(variants.collect()));
    json
}

fn entry(it: &Entry) -> Json {
    let mut json = item(&it.name, &it.header, &it.docs);
    add(&mut json, "rust", Some(json!(it.rust)));
    add(&mut json, "status", Some(json!(it.status)));
    add(&mut json, "parameters", Some(it.parameters.iter().map(parameter).collect()));
    add(&mut json, "result", it.result.as_ref().map(value));
    json
}

fn parameter(it: &Parameter) -> Json {
    let mut json = value(&it.value);
    add(&mut json, "name", Some(json!(it.name)));
    let passing = match it.passing {
        Passing::Value => "value",
        Passing::Input => "in",
        Passing::InOut => "in-out",
        Passing::Output => "out",
    };
    add(&mut json, "passing", Some(json!(passing)));
    json
}

fn comment(docs: &[String]) -> Option<Json> {
    (!docs.is_empty()).then(|| json!(docs.join("\n")))
}

/// Adds a member if it has a value.
fn add(json: &mut Json, name: &str, value: Option<Json>) {
    if let (Json::Object(members), Some(value)) = (json, value) {
        members.insert(name.to_owned(), value);
    }
}
