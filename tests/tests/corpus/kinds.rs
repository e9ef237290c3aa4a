//! Each kind of data can are beside other data, be an initial value, be copied, passed, returned and
//! compared.
//!
//! A kind is a file of `tests/corpus/src/programs/kinds`; its properties are read off the functions that the
//! generator made of it and that `corpus.rs` runs on every leg, so that a kind which lacks one fails here.
//! `UPDATE_DOCS=1 cargo test -p bessemer-tests kinds::` writes docs/kinds.md.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;

use bessemer_ir::Module;
use bessemer_tests::process::lay_out;
use bessemer_tests::toolchain::{self, Toolchain, run};
use bessemer_tests::{corpus, root};

const PAGE: &str = "docs/kinds.md";
const KINDS: &str = "tests/corpus/src/programs/kinds";

/// The functions that show a property each.
const PROPERTIES: [&str; 6] = ["layout", "initial", "copy", "pass", "give", "compare"];
/// The function that compares the values which only floats have.
const NUMBERS: &str = "compare_numbers";

/// A file of the folder.
struct Kind {
    name: String,
    /// Its first line, without the full stop.
    about: String,
    /// Name of the type in Rust.
    ty: String,
}

fn kinds() -> Vec<Kind> {
    let folder = fs::read_dir(root().join(KINDS)).expect("the kinds are there").flatten();
    let programs = folder.map(|entry| entry.path());
    let programs = programs.filter(|path| path.extension().is_some_and(|it| it == "rs"));
    let mut kinds: Vec<Kind> = programs
        .map(|path| {
            let text = fs::read_to_string(&path).expect("a program");
            let after = |mark: &str| {
                let line = text.lines().find_map(|line| line.strip_prefix(mark));
                line.unwrap_or_default().trim_end_matches(['.', ';']).to_owned()
            };
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            Kind { name, about: after("//! "), ty: after("pub type It = ") }
        })
        .collect();
    kinds.sort_by(|one, other| one.name.cmp(&other.name));
    kinds
}

/// The names of what was made of a kind and is run.
fn functions(module: &Module, kind: &Kind) -> BTreeSet<String> {
    let path = format!("corpus::programs::kinds::{}", kind.name);
    let made = module.functions.iter().filter(|it| it.module == path).map(|it| it.name.clone());
    let run = corpus::programs::ENTRIES.iter().filter(|it| it.module == path).map(|it| it.name);
    let run: BTreeSet<&str> = run.collect();
    made.filter(|name| run.contains(name.as_str())).collect()
}

/// Returns true if a value of the kind holds a float.
fn has_floats(module: &Module, kind: &Kind) -> bool {
    let path = format!("corpus::programs::kinds::{}", kind.name);
    let copy = module.functions.iter().find(|it| it.module == path && it.name == "copy");
    copy.is_some_and(|copy| {
        module.leaves(&copy.locals[0].ty).iter().any(|ty| ty.as_float().is_some())
    })
}

fn page(module: &Module, kinds: &[Kind]) -> String {
    let mut text = String::from(
        "# Kinds of data\n\nEach kind of data, and a program of it for each property: it stands between other \
         data in a struct (layout),\na component begins with it (initial), it is copied, passed by value and by \
         reference (pass), returned (give), and\ncompared with `==` and `!=`; where it holds floats, with NaN and \
         ±0 among them (numbers). Every such program runs as\nRust, in the interpreter, and as C with each compiler, on the \
         host and on the emulated Cortex-A9 (`tests/tests/corpus/mod.rs`);\n`tests/tests/corpus/kinds.rs` fails where one is missing. \
         A kind is a file of `tests/corpus/src/programs/kinds`.\n\n| kind | as Rust writes it | ",
    );
    text.push_str(&PROPERTIES.join(" | "));
    text.push_str(" | numbers |\n|---|---|:-:|:-:|:-:|:-:|:-:|:-:|:-:|\n");
    for kind in kinds {
        let functions = functions(module, kind);
        let mark = |name: &str| if functions.contains(name) { "●" } else { "" };
        let marks: Vec<&str> = PROPERTIES.iter().chain([&NUMBERS]).map(|it| mark(it)).collect();
        let _ = writeln!(text, "| {} | `{}` | {} |", kind.about, kind.ty, marks.join(" | "));
    }
    text
}

#[test]
fn every_kind_has_every_property() {
    let (module, kinds) = (&corpus().module, kinds());
    let missing: Vec<String> = kinds
        .iter()
        .flat_map(|kind| {
            let functions = functions(module, kind);
            let wanted = PROPERTIES.into_iter().chain(has_floats(module, kind).then_some(NUMBERS));
            let lacks = wanted.filter(|name| !functions.contains(*name));
            lacks.map(|name| format!("{} has no `{name}`", kind.name)).collect::<Vec<_>>()
        })
        .collect();
    assert!(missing.is_empty() && !kinds.is_empty(), "{missing:#?}");
    let current = page(module, &kinds);
    let path = root().join(PAGE);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::write(path, current).expect("the page can be written");
    } else {
        let page = fs::read_to_string(path).unwrap_or_default();
        let asked = "UPDATE_DOCS=1 cargo test -p bessemer-tests kinds::";
        assert!(page == current, "{PAGE} is stale: {asked}");
    }
}

/// The report and the manifest tell how large the state of a component is: so each compiler has it, on each target.
#[test]
fn states_are_as_large_as_the_report_says() {
    let compiled = corpus();
    let folder = lay_out(compiled).expect("the C");
    let (mut includes, mut claims) = (BTreeSet::new(), BTreeSet::new());
    for entry in &compiled.entries {
        includes.insert(format!("#include \"{}\"\n", entry.header));
        let (state, bytes) = (&entry.state, entry.state_bytes);
        claims.insert(format!(
            "typedef char bytes_of_{state}[(sizeof({state}) == {bytes}U) ? 1 : -1];\n"
        ));
    }
    assert!(claims.len() > kinds().len(), "each kind is part of a state");
    let source = folder.path().join("claimed_sizes.c");
    let text: String = includes.into_iter().chain(claims).collect();
    fs::write(&source, text).expect("a file of claims");
    let once = |it: &Toolchain| it.level == 2;
    for toolchain in toolchain::all().iter().filter(|it| once(it)) {
        run(toolchain.command().arg("-fsyntax-only").arg(&source))
            .unwrap_or_else(|said| panic!("{}: {said}", toolchain.name()));
    }
}
