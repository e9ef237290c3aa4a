//! The C of a package in a foreign tree: beside another package's, and beside headers of the same names. The runs
//! rotate through the standards that a project can select.

use std::path::Path;
use std::process::Command;

use bessemer_backend::c::{CFile, FLAGS, Options, Standard, emit};
use bessemer_ir::Module;

use crate::compilers::{by_turn, folder, is_there, run};

fn emitted(module: &Module, name: &str) -> Vec<CFile> {
    let (prefix, status) = (format!("{name}_"), name.to_owned());
    emit(module, &Options { prefix, status, self_test: true, ..Options::default() })
}

fn named<'f>(files: &'f [CFile], end: &str) -> Vec<&'f str> {
    files.iter().map(|file| file.name.as_str()).filter(|name| name.ends_with(end)).collect()
}

/// The headers for firmware: what sources share is theirs alone.
fn public(files: &[CFile]) -> impl Iterator<Item = &str> {
    let internal = |name: &&str| {
        ["_helpers.h", "_constants.h", "_inline.h"].iter().any(|it| name.ends_with(it))
    };
    named(files, ".h").into_iter().filter(move |name| !internal(name))
}

/// Two packages with prefixes of their own share a folder, a translation unit and a firmware, with mathematics, kernels and status.
#[track_caller]
pub fn link_together(name: &str, module: &Module) {
    if !is_there("gcc") {
        return;
    }
    let (mut files, other) = (emitted(module, "acme"), emitted(module, "umbrella"));
    let headers: String = public(&files).chain(public(&other)).map(include).collect();
    files.extend(other);
    files.push(CFile { name: "both.c".to_owned(), text: headers, map: Vec::new() });
    let count = files.len();
    let folder = folder(&format!("packages-{name}"), &files);
    let there = std::fs::read_dir(&folder).expect("just written").count();
    assert_eq!(there, count, "two files have one name");
    let mut link = Command::new("gcc");
    run(
        link.args(FLAGS).args(["-r", "-nostdlib", "-o", "all.o"]).args(named(&files, ".c")),
        &folder,
    );
}

/// Checks headers in a folder of their own beside a vendor's with the same names and guards, which the compiler finds
/// first. Each compiler accepts the C by the selected standard and rejects it by an older one.
#[track_caller]
pub fn stand_in_a_folder(name: &str, module: &Module) {
    let plain = emit(module, &Options { self_test: true, ..Options::default() });
    for standard in by_turn(&Standard::ALL, 2, 0) {
        let options = Options {
            headers: "acme/control".to_owned(),
            self_test: true,
            threads: 2,
            standard,
            ..Options::default()
        };
        let mut files = emit(module, &options);
        assert_eq!(files.len(), plain.len());
        let all = named(&files, ".h");
        assert!(all.iter().all(|it| it.starts_with("acme/control/")), "{all:?}");
        let includes = all.into_iter().map(include).collect();
        files.push(CFile { name: "main.c".to_owned(), text: includes, map: Vec::new() });
        let folder = folder(&format!("folder-{name}-{}", standard.flag()), &files);
        let vendors = folder.join("vendor");
        std::fs::create_dir(&vendors).expect("the target folder is writable");
        for header in named(&plain, ".h") {
            let guard = header.replace('.', "_").to_uppercase();
            let text = format!("#ifndef {guard}\n#define {guard}\n#error a vendor's\n#endif\n");
            std::fs::write(vendors.join(header), text).expect("the target folder is writable");
        }
        for compiler in ["gcc", "clang"].into_iter().filter(|it| is_there(it)) {
            let command = |flag: &str| {
                let mut command = Command::new(compiler);
                command.args(FLAGS).args([flag, "-pthread", "-fsyntax-only", "-Ivendor", "-I."]);
                command.args(named(&files, ".c")).current_dir(&folder);
                command
            };
            run(&mut command(standard.flag()), &folder);
            if !matches!(standard, Standard::C99 | Standard::Gnu99) {
                let older = command("-std=c99").output().expect("it is there");
                let said = String::from_utf8_lossy(&older.stderr);
                assert!(said.contains("compile it with"), "{compiler} {standard:?}: {said}");
            }
        }
    }
}

/// Checks headers beside a vendor's of the same names and guards. With a prefix, both can be included; without one, the
/// package's own folder resolves them.
#[track_caller]
pub fn stand_beside_a_vendors(name: &str, module: &Module) {
    if !is_there("gcc") {
        return;
    }
    let prefixed = emitted(module, "acme");
    let root = folder(&format!("vendor-{name}"), &prefixed);
    let vendors = root.join("vendor");
    std::fs::create_dir(&vendors).expect("the target folder is writable");
    let mut both = String::new();
    for header in named(&prefixed, ".h") {
        let own = header.trim_start_matches("acme_");
        let guard = own.replace('.', "_").to_uppercase();
        let text = format!(
            "#ifndef {guard}\n#define {guard}\n#ifdef OURS\n#error theirs\n#endif\n#endif\n"
        );
        std::fs::write(vendors.join(own), text).expect("the target folder is writable");
        both += &include(own);
    }
    both.extend(named(&prefixed, ".h").into_iter().map(include));
    std::fs::write(root.join("both.c"), both).expect("the target folder is writable");
    let compile = |arguments: &[&str], folder: &Path| {
        run(Command::new("gcc").args(FLAGS).args(["-fsyntax-only"]).args(arguments), folder);
    };
    compile(&["-Ivendor", "both.c"], &root);

    let own = emit(module, &Options::default());
    let ours = root.join("ours");
    std::fs::create_dir(&ours).expect("the target folder is writable");
    for file in &own {
        std::fs::write(ours.join(&file.name), &file.text).expect("the target folder is writable");
    }
    let by_folder: String =
        named(&own, ".h").iter().map(|header| include(format!("ours/{header}"))).collect();
    std::fs::write(root.join("by_folder.c"), by_folder).expect("the target folder is writable");
    let sources: Vec<String> = named(&own, ".c").iter().map(|it| format!("ours/{it}")).collect();
    let mut arguments = vec!["-DOURS", "-Ivendor", "-I.", "by_folder.c"];
    arguments.extend(sources.iter().map(String::as_str));
    compile(&arguments, &root);
}

fn include(header: impl AsRef<str>) -> String {
    format!("#include \"{}\"\n", header.as_ref())
}
