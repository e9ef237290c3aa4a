//! Puts the marks into the programs that become C, and lists what of them can be called with words: dropping in a file
//! adds a test.

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
        println!("cargo::rerun-if-changed={}", folder.join(read).display());
    }
    let mut modules = String::new();
    let mut entries = Entries { root: "plain", methods: true, found: Vec::new() };
    for name in marked::programs(&folder)?.0 {
        let path = output.join(format!("{name}.rs"));
        write(&path, &marked::marked(&folder, &name)?)?;
        modules.push_str(&format!("#[path = {path:?}]\npub mod {name};\n"));
        // A file that does not parse is rustc's to tell of.
        if let Ok(file) = syn::parse_file(&fs::read_to_string(&path)?) {
            entries.items(&file.items, &name);
        }
    }
    let entries: String = entries.found.iter().map(|entry| format!("    {entry},\n")).collect();
    let text = format!(
        "{modules}\n/// What can be called.\npub const ENTRIES: &[crate::Entry] = &[\n{entries}];\n"
    );
    write(&output.join("programs.rs"), &text)
}

fn write(path: &Path, text: &str) -> io::Result<()> {
    fs::write(path, text)
}
