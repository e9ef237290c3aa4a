//! Finds the programs: every file below `src/programs` becomes a module. Every function and entry point in it that can
//! be called with words is listed, so a new file adds a test.
//!
//! A folder is a module of its files; a folder with a `mod.rs` is one program. What several programs have in
//! common stands in a file that they `include!`.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use syn::Item;

use entries::Entries;

mod entries;

fn main() -> io::Result<()> {
    let programs = Path::new(&std::env::var("CARGO_MANIFEST_DIR").unwrap_or_default())
        .join("src")
        .join("programs");
    // From the package's folder, wherever that lies: a copy of it has the same name for it.
    println!("cargo::rerun-if-changed=src/programs");
    let entries = Entries { root: "corpus", methods: false, found: Vec::new() };
    let mut found = Found { modules: String::new(), entries };
    found.folder(&programs, &mut Vec::new())?;
    let (modules, entries) = (found.modules, found.entries.found);
    let entries = entries.iter().map(|entry| format!("    {entry},\n")).collect::<String>();
    let text = format!(
        "{modules}\nbessemer::__natively! {{\n/// Every function and entry point of the programs.\n\
         pub const ENTRIES: &[crate::Entry] = &[\n{entries}];\n}}\n"
    );
    let output = PathBuf::from(std::env::var("OUT_DIR").unwrap_or_default()).join("programs.rs");
    fs::write(output, text)
}

struct Found {
    /// The text of the modules.
    modules: String,
    entries: Entries,
}

impl Found {
    fn folder(&mut self, folder: &Path, at: &mut Vec<String>) -> io::Result<()> {
        let mut paths = fs::read_dir(folder)?
            .map(|entry| entry.map(|entry| entry.path()))
            .collect::<io::Result<Vec<_>>>()?;
        paths.sort();
        for path in paths {
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            if path.is_dir() && path.join("mod.rs").exists() {
                self.module(&path.join("mod.rs"), &name, at)?;
            } else if path.is_dir() {
                self.modules.push_str(&format!("#[allow(missing_docs)]\npub mod {name} {{\n"));
                at.push(name);
                self.folder(&path, at)?;
                at.pop();
                self.modules.push_str("}\n");
            } else if path.extension().is_some_and(|it| it == "rs") {
                self.module(&path, &name, at)?;
            }
        }
        Ok(())
    }

    fn module(&mut self, path: &Path, name: &str, at: &mut Vec<String>) -> io::Result<()> {
        self.modules.push_str(&format!("#[path = {path:?}]\npub mod {name};\n"));
        at.push(name.to_owned());
        // A file that does not parse is rustc's to tell of.
        if let Ok(file) = syn::parse_file(&fs::read_to_string(path)?) {
            self.entries.items(&file.items, &at.join("::"));
            for shared in file.items.iter().filter_map(included) {
                let text = fs::read_to_string(path.with_file_name(shared))?;
                if let Ok(file) = syn::parse_file(&text) {
                    self.entries.items(&file.items, &at.join("::"));
                }
            }
        }
        at.pop();
        Ok(())
    }
}

/// The file that `include!("…")` brings.
fn included(item: &Item) -> Option<String> {
    match item {
        Item::Macro(it) if it.mac.path.is_ident("include") => {
            it.mac.parse_body::<syn::LitStr>().ok().map(|name| name.value())
        }
        _ => None,
    }
}
