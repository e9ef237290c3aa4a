//! Rewords rustc's messages about items of other crates, which nobody can mark.

use super::origins::Origins;
use super::remedies::{instead, of_crate};
use super::rustc::Message;
use super::types;
use super::wording::{Words, words};

/// Returns the rewording of an error about another crate's item; none for other messages.
pub fn of(message: &Message<'_>, origins: &Origins<'_>) -> Option<Words> {
    let mark = message.mark().filter(|_| message.is_error)?;
    if let Some(words) = version(message) {
        return Some(words);
    }
    let function = mark.label.strip_suffix(" is not a crate or module");
    let function = function.and_then(|label| label.strip_prefix("function `")?.strip_suffix('`'));
    if let Some(name) = function {
        let home = origins.crate_of(name, mark)?;
        let title = format!("`{name}` of the crate `{home}` is not part of the DSL");
        return words(title, of_crate(&home));
    }
    let quoted = message.quoted();
    let method = quoted.iter().find_map(|name| name.strip_prefix("__b_"))?;
    let last = *quoted.last()?;
    if ["E0407", "E0576"].contains(&message.code) {
        let home = origins.imported(types::name(last), mark.file);
        let home = home.or_else(|| origins.crate_of(last, mark))?;
        let title = format!(
            "`{method}` of the trait `{last}`, of the crate `{home}`, is not part of the DSL"
        );
        return words(title, of_crate(&home));
    }
    let owner = types::written(last);
    let home = match types::is_parameter(&owner) {
        true => origins.crate_of_bound(&owner, mark)?,
        false if types::is_known(&owner) || instead(method, &owner).is_some() => return None,
        false => origins.home_of_type(last, mark)?,
    };
    let shown = types::within_modules(&owner);
    let title = format!("`{method}` of `{shown}`, from the crate `{home}`, is not part of the DSL");
    words(title, of_crate(&home))
}

/// Rewords an error about a type of a crate that is there in two versions.
fn version(message: &Message<'_>) -> Option<Words> {
    let said = message.below().find(|it| it.contains("different versions of crate `"))?;
    let name = said.split("of crate `").nth(1)?.split('`').next()?;
    let own = ["nalgebra", "num_traits", "libm", "num_complex", "bessemer"].contains(&name);
    let help = match name {
        "nalgebra" => {
            "use the version that the DSL has: `use bessemer::nalgebra;`, or write that version of nalgebra in Cargo.toml (`cargo tree -d` shows both)"
        }
        _ => "write the version that `bessemer` has in Cargo.toml: `cargo tree -d` shows both",
    };
    own.then(|| words(format!("this `{name}` is another version than the DSL's"), help))?
}

#[cfg(test)]
mod tests {
    use bessemer_frontend::source::Sources;
    use serde_json::{Value, json};

    use super::super::reported;

    /// A file that imports from another crate, from one of the workspace, and bounds a parameter.
    const FILE: &str = "use libm::{lgamma, tgamma};\nuse filters::smooth;\nuse crc::Crc;\n\
                        use num_integer::Roots;\n\nfn f<T: Roots>(x: T) -> T {\n    x.nth_root(3)\n}\n";

    fn artifact(id: &str, name: &str) -> Value {
        json!({ "reason": "compiler-artifact", "package_id": id, "target": { "name": name } })
    }

    fn error(title: &str, code: &str, (line, label, note): (u32, &str, &str)) -> Value {
        let text = FILE.lines().nth(line as usize - 1).unwrap_or_default();
        let span = json!({
            "file_name": "lib.rs", "line_start": line, "line_end": line, "column_start": 5,
            "column_end": 6, "is_primary": true, "label": label, "text": [{ "text": text }],
        });
        let children = json!([{ "level": "note", "message": note, "spans": [] }]);
        json!({ "reason": "compiler-message", "message": {
            "message": title, "level": "error", "code": { "code": code }, "spans": [span],
            "children": children, "rendered": title,
        }})
    }

    /// Returns title and remedy for an error in a build with crates of others and one of the workspace.
    fn said(error: Value) -> (String, String) {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("lib.rs"), FILE).expect("a file");
        let registry = "registry+https://example.org/index#libm@0.2.16";
        let crates = ["libm", "crc", "num-integer", "nalgebra"];
        let mut messages: Vec<Value> = crates.map(|it| artifact(registry, it)).into();
        messages.push(artifact("path+file:///src/filters#0.1.0", "filters"));
        messages.push(error);
        let reported = reported(&messages, &Sources::new(folder.path()));
        let first = reported.into_iter().next().expect("a diagnostic");
        (first.message, first.help)
    }

    #[test]
    fn what_another_crate_has_is_not_to_be_marked() {
        let cases = [
            (
                error(
                    "cannot find",
                    "E0433",
                    (1, "function `lgamma` is not a crate or module", ""),
                ),
                "`lgamma` of the crate `libm` is not part of the DSL",
            ),
            (
                error(
                    "no method named `__b_checksum` found for struct `Crc<u16>`",
                    "E0599",
                    (3, "", ""),
                ),
                "`checksum` of `Crc<u16>`, from the crate `crc`, is not part of the DSL",
            ),
            (
                error(
                    "no method named `__b_nth_root` found for type parameter `T`",
                    "E0599",
                    (7, "", ""),
                ),
                "`nth_root` of `T`, from the crate `num_integer`, is not part of the DSL",
            ),
            (
                error(
                    "cannot find method or associated constant `__b_sqrt` in trait `Roots`",
                    "E0576",
                    (7, "", ""),
                ),
                "`sqrt` of the trait `Roots`, of the crate `num_integer`, is not part of the DSL",
            ),
            (
                error(
                    "mismatched types",
                    "E0308",
                    (
                        7,
                        "",
                        "there are multiple different versions of crate `nalgebra` in the dependency graph",
                    ),
                ),
                "this `nalgebra` is another version than the DSL's",
            ),
        ];
        for (error, title) in cases {
            let (message, help) = said(error);
            assert_eq!(message, title);
            assert!(!help.is_empty() && !help.contains("mark the"), "{help}");
        }
    }

    #[test]
    fn what_the_workspace_has_is_to_be_marked() {
        let label = "function `smooth` is not a crate or module";
        let (message, help) = said(error("cannot find", "E0433", (2, label, "")));
        assert_eq!(message, "`smooth` is not part of the DSL");
        assert_eq!(help, "mark the function `#[function]`");
    }
}
