//! The JSON Schema of `bessemer.toml`, and the table of its keys for the documentation.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use crate::keys::{KEYS, Key, Kind};

/// The schema, for editors.
pub fn schema() -> String {
    let mut properties = Map::new();
    for key in KEYS {
        let value = property(key);
        match key.name.split_once('.') {
            None => {
                properties.insert(key.name.to_owned(), value);
            }
            Some((section, name)) => {
                let inner =
                    json!({ "type": "object", "additionalProperties": false, "properties": {} });
                let section = properties.entry(section).or_insert(inner);
                section["properties"][name] = value;
            }
        }
    }
    let schema = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "bessemer.toml",
        "description": "What a user of Bessemer decides about the C of a package.",
        "type": "object",
        "additionalProperties": false,
        "properties": properties,
    });
    // Plain JSON values: writing them cannot fail.
    serde_json::to_string_pretty(&schema).unwrap_or_default() + "\n"
}

fn property(key: &Key) -> Value {
    let mut property = match &key.kind {
        Kind::Text(form, _) => json!({ "type": "string", "pattern": form.pattern() }),
        Kind::Choice(words, _) => json!({ "enum": words }),
        Kind::Flag(_) => json!({ "type": "boolean" }),
        Kind::Number(most, _) => json!({ "type": "integer", "minimum": 0, "maximum": most }),
        Kind::Replacements => json!({ "type": "array", "items": { "type": "object" } }),
        Kind::Inputs | Kind::Outputs => {
            json!({ "type": "object", "additionalProperties": { "type": "object" } })
        }
        Kind::Periods => json!({
            "type": "object",
            "additionalProperties": { "type": "number", "exclusiveMinimum": 0 },
        }),
    };
    property["description"] = json!(format!("{} Without it: {}.", key.says, key.default));
    property
}

/// The table of the keys, in Markdown.
pub fn table() -> String {
    let mut text =
        String::from("| key | takes | without it | what it decides |\n|---|---|---|---|\n");
    for key in KEYS {
        let takes = match &key.kind {
            Kind::Text(form, _) => form.expected().to_owned(),
            Kind::Choice(words, _) => {
                words.iter().map(|word| format!("`\"{word}\"`")).collect::<Vec<_>>().join(", ")
            }
            Kind::Flag(_) => "`true` or `false`".to_owned(),
            Kind::Number(u32::MAX, _) => "a whole number".to_owned(),
            Kind::Number(most, _) => format!("a whole number up to {most}"),
            Kind::Replacements => "a list of tables, `[[replacements]]`".to_owned(),
            Kind::Inputs => {
                "a table for each entry point, such as `[inputs.motor_step]`".to_owned()
            }
            Kind::Outputs => {
                "a table for each entry point, such as `[outputs.motor_step]`".to_owned()
            }
            Kind::Periods => "a table of seconds, such as `motor_step = 0.001`".to_owned(),
        };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| `{}` | {takes} | {} | {} |", key.name, key.default, key.says);
    }
    text
}
