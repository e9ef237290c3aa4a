//! Pages of a dossier: `index.html` and `trace.html`, each whole by itself.
//!
//! Invariants: no page loads anything; everything but search and the trace works without scripts; the same content gives
//! the same bytes. Must not know: where the content comes from.

use serde_json::json;
use tera::{Context, Tera};

use crate::content::Content;
use crate::memory;
use crate::trace::{Folder, Sources, explained};

const INDEX: &str = include_str!("../../templates/index.html.tera");
const TRACE: &str = include_str!("../../templates/trace.html.tera");
const STYLE: &str = include_str!("../../templates/style.css");
const INDEX_SCRIPT: &str = include_str!("../../templates/index.js");
const TRACE_SCRIPT: &str = include_str!("../../templates/trace.js");

/// Sections of the index: anchor and title.
pub const SECTIONS: [(&str, &str); 18] = [
    ("results", "Results"),
    ("components", "Components"),
    ("types", "Types"),
    ("faults", "Faults left"),
    ("functions", "Functions and stack"),
    ("memory", "Memory by lifetime"),
    ("worst", "Worst case"),
    ("sizes", "Sizes"),
    ("contracts", "Contracts"),
    ("requirements", "Requirements"),
    ("coverage", "Coverage"),
    ("change", "Changes"),
    ("misra", "MISRA C"),
    ("notes", "Notes on the tool"),
    ("tests", "Tests of the tool"),
    ("crates", "Crates"),
    ("questions", "An auditor's questions"),
    ("identity", "Identity"),
];

/// Anchor of the trace, which is a page of its own.
pub const TRACE_PAGE: &str = "trace.html";

/// Returns `index.html`.
pub fn index(content: &Content, identity: &[(String, String)]) -> String {
    let mut context = Context::from_serialize(content).expect("a struct becomes a context");
    context.insert("sections", &SECTIONS);
    context.insert("memory", &memory::picture(&content.components));
    context.insert("identity", identity);
    rendered(INDEX, context, INDEX_SCRIPT)
}

fn rendered(template: &str, mut context: Context, script: &str) -> String {
    context.insert("style", STYLE);
    context.insert("script", script);
    Tera::one_off(template, &context, true).expect("the templates render: a test renders them")
}

/// Returns `trace.html`: each line of the C with its counterpart, and the Rust.
pub fn trace(package: &str, folder: &Folder, sources: &dyn Sources) -> String {
    let mut names: Vec<String> = folder
        .files
        .iter()
        .flat_map(|file| file.rows.iter().map(|row| row.rust_file.clone()))
        .collect();
    names.sort();
    names.dedup();
    let files = folder.files.iter().map(|file| {
        let lines: Vec<&str> = file.text.lines().collect();
        // First and last line of the statement, the Rust file, its line, the function.
        let links = (1..=lines.len() as u32).map(|line| {
            let found = file.counterpart(line).map(|(first, last, row)| {
                let rust = names.iter().position(|it| *it == row.rust_file);
                json!([first, last, rust, row.rust_line, row.function])
            });
            found.unwrap_or_else(|| json!(file.why_none(line)))
        });
        // First and last line of each function, and its names that the Rust does not have.
        let functions = file.functions.iter().map(|it| {
            let rust =
                file.counterpart(it.line).and_then(|(_, _, row)| sources.text(&row.rust_file));
            let names = explained(file, it, (it.line, it.last_line), &rust.unwrap_or_default());
            let names: Vec<_> = names.iter().map(|it| json!([it.name, it.why])).collect();
            json!([it.line, it.last_line, names])
        });
        let functions: Vec<_> = functions.collect();
        json!({
            "name": file.name,
            "text": lines,
            "links": links.collect::<Vec<_>>(),
            "functions": functions,
        })
    });
    let rust = names.iter().map(|name| {
        let text = sources.text(name);
        let lines: Option<Vec<&str>> = text.as_deref().map(|it| it.lines().collect());
        json!({ "name": name, "text": lines })
    });
    let data = json!({ "c": files.collect::<Vec<_>>(), "rust": rust.collect::<Vec<_>>() });
    // A script ends at `</script>`, wherever that is.
    let data = data.to_string().replace('<', "\\u003c");
    let mut context = Context::new();
    context.insert("package", package);
    context.insert("data", &data);
    rendered(TRACE, context, TRACE_SCRIPT)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::change::Change;
    use crate::content::{Entry, Field, Outcome};
    use crate::coverage::Report;
    use std::collections::BTreeMap;
    use std::path::Path;

    struct None;

    impl Sources for None {
        fn text(&self, name: &str) -> Option<String> {
            (name == "src/lib.rs").then(|| "fn f() {}\n// </script>\n".to_owned())
        }
    }

    fn content() -> Content {
        let field = Field {
            name: "speed".to_owned(),
            ty: "double".to_owned(),
            unit: "rad/s".to_owned(),
            range: "0 … 5".to_owned(),
            place: "in".to_owned(),
            docs: "a < b".to_owned(),
        };
        let entry = Entry {
            name: "motor_step".to_owned(),
            rust: "Motor::step".to_owned(),
            docs: String::new(),
            parameters: vec![field.clone()],
            stack: 8,
            state: 8,
            wide: (1, 2),
            instructions: "1".to_owned(),
            cycles: vec![["Cortex-A9".to_owned(), "2".to_owned()]],
            left: vec![["src/lib.rs:1:1".to_owned(), "index".to_owned(), "why".to_owned()]],
            reached: 1,
            graph: Some("<svg></svg>".to_owned()),
        };
        let component = crate::content::Component {
            name: "motor_t".to_owned(),
            rust: "motor::Motor".to_owned(),
            docs: String::new(),
            header: "motor.h".to_owned(),
            bytes: 8,
            fields: vec![field],
            entries: vec![entry],
        };
        let outcome = Outcome {
            what: "Tests".to_owned(),
            command: "cargo test".to_owned(),
            version: String::new(),
            verdict: "not run",
            detail: String::new(),
        };
        Content {
            package: "motor".to_owned(),
            results: vec![outcome],
            components: vec![component.clone()],
            structs: vec![component],
            coverage: Some(Report { inputs: vec!["a run".to_owned()], ..Report::default() }),
            change: Some(Change { since: "v1".to_owned(), ..Change::default() }),
            traced: (3, 4),
            ..Content::default()
        }
    }

    #[test]
    fn the_index_has_each_section_and_loads_nothing() {
        let identity = [("sources".to_owned(), "ab12".to_owned())];
        let page = index(&content(), &identity);
        for (anchor, _) in SECTIONS {
            assert_eq!(page.matches(&format!("<h2 id=\"{anchor}\"")).count(), 1, "{anchor}");
        }
        for text in [
            "a &lt; b",
            "3 / 4",
            "verdict not-run",
            "0 … 5",
            "2 cycles on Cortex-A9",
            "ab12",
            "<svg></svg>",
        ] {
            assert!(page.contains(text), "{text}");
        }
        for text in ["http:", "https:", "<link", "src=\"", "{{", "{%"] {
            assert!(!page.contains(text), "{text}");
        }
        let without = index(&Content::default(), &[]);
        assert!(without.contains("Not measured.") && without.contains("--since TAG"));
    }

    #[test]
    fn the_trace_has_both_sides_and_ends_where_it_should() {
        let texts = BTreeMap::from([
            ("f.c".to_owned(), "void f(void)\n{\n    g();\n}\n".to_owned()),
            ("f.c.map".to_owned(), "1\tsrc/lib.rs:1\tm::f\n3\tother/lib.rs:2\tm::g\n".to_owned()),
        ]);
        let folder = Folder::of(&texts, Path::new("x")).expect("a folder");
        let page = trace("motor", &folder, &None);
        assert_eq!(page.matches("</script>").count(), 2);
        assert!(page.contains("[3,3,0,2,\"m::g\"]"), "{page}");
        assert!(page.contains("\"functions\":[[1,4,[]]]"), "{page}");
        assert!(page.contains("{\"name\":\"other/lib.rs\",\"text\":null}"));
    }
}
