//! Marks the programs that become C, and lists their functions that can be called with words. A new file adds a test.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use entries::Entries;

#[path = "../corpus/entries.rs"]
mod entries;
mod marked;

fn main() -> io::Result<()> {
    let folder = PathBuf::from(std::env::var("CARGO_MANIFEST_DIR").unwrap_or_default());
    let output = PathBuf::from(std::env::var("OUT_DIR").unwrap_or_default());
    for read in ["programs", "marks", "README.md"] {
        // From the package's folder, wherever that lies: a copy of it has the same name for it.
        println!("cargo::rerun-if-changed={read}");
    }
    let (mut modules, mut all) = (String::new(), String::new());
    for name in marked::programs(&folder)?.0 {
        let path = output.join(format!("{name}.rs"));
        let text = marked::marked(&folder, &name)?;
        let mut entries = Entries { root: "plain", methods: true, found: Vec::new() };
        // A file that does not parse is rustc's to tell of.
        if let Ok(file) = syn::parse_file(&text) {
            entries.items(&file.items, &name);
        }
        // Within the program, whose names may be its own alone.
        let entries: String = entries.found.iter().map(|it| format!("    {it},\n")).collect();
        let entries = format!(
            "bessemer::__natively! {{\n/// What can be called.\npub const __ENTRIES: &[crate::Entry] = &[\n{entries}];\n}}\n"
        );
        write(&path, &format!("{text}\n{entries}"))?;
        modules.push_str(&format!("#[path = {path:?}]\npub mod {name};\n"));
        all.push_str(&format!("    {name}::__ENTRIES,\n"));
    }
    let text = format!(
        "{modules}\nbessemer::__natively! {{\n/// What can be called, by program.\npub const ENTRIES: &[&[crate::Entry]] = &[\n{all}];\n}}\n"
    );
    write(&output.join("programs.rs"), &text)
}

fn write(path: &Path, text: &str) -> io::Result<()> {
    fs::write(path, text)
}
