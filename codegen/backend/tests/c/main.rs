//! The C back end: what it emits for the modules in `tests/c/*.ir`, and that every compiler at hand
//! takes it without a warning. Dropping in a file adds a test.

mod compilers;
mod contracts;
#[allow(dead_code)]
#[path = "../passes_random/generate.rs"]
mod generate;
mod hostile;
mod packages;
mod run;
#[path = "../passes_random/vectors.rs"]
mod vectors;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use bessemer_backend::c::{CFile, MapLine, Options, Plan, emit};
use bessemer_backend::kernels::{Mode, Tuning};
use bessemer_backend::passes;
use bessemer_backend::validate::validate;
use bessemer_ir::Module;

fn load(path: &Path) -> Module {
    let text = std::fs::read_to_string(path).expect("the file is there");
    let module = bessemer_ir::text::parse(&text)
        .unwrap_or_else(|error| panic!("{}: {error:?}", path.display()));
    validate(&module).unwrap_or_else(|errors| panic!("{}: {errors:#?}", path.display()));
    module
}

/// The module as the back end takes it.
fn explicit(path: &Path) -> Module {
    let passed = passes::explicit(load(path));
    let explicit = passed.unwrap_or_else(|errors| panic!("{}: {errors:#?}", path.display())).0;
    passes::lend(explicit, &Tuning::default(), true)
}

fn modules() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/c");
    let entries = std::fs::read_dir(folder).expect("the folder is there");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("readable").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "ir"));
    paths.sort();
    paths
}

/// The files one after another, and the report.
fn show(module: &Module, files: &[CFile]) -> String {
    let mut text = String::new();
    for file in files {
        let _ = writeln!(text, "======== {}\n{}", file.name, file.text);
    }
    for entry in Plan::new(module, &Options::default()).report(files).0 {
        let _ = writeln!(text, "{entry:?}");
    }
    text
}

#[test]
fn emitted_c() {
    for path in modules() {
        let module = explicit(&path);
        let files = emit(&module, &Options::default());
        let name = path.file_stem().expect("a file").to_string_lossy().into_owned();
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path("");
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.bind(|| insta::assert_snapshot!(name, show(&module, &files)));
    }
}

#[test]
fn compiles_without_a_warning() {
    for path in modules() {
        let files = emit(&explicit(&path), &Options::default());
        compilers::check(&path.file_stem().expect("a file").to_string_lossy(), &files);
    }
}

#[test]
fn the_map_points_at_code() {
    for path in modules() {
        for file in emit(&explicit(&path), &Options::default()) {
            let lines: Vec<&str> = file.text.lines().collect();
            for entry in &file.map {
                let line = lines[entry.c_line as usize - 1].trim();
                assert!(
                    !line.is_empty() && !line.starts_with("/*"),
                    "{}: {entry:?}: {line}",
                    file.name
                );
            }
            assert!(file.map.is_sorted_by_key(|entry| entry.c_line), "{}", file.name);
        }
    }
}

#[test]
fn computes_what_the_interpreter_computes() {
    for path in modules() {
        let (module, explicit) = (load(&path), explicit(&path));
        let files = emit(&explicit, &Options::default());
        let name = path.file_stem().expect("a file").to_string_lossy().into_owned();
        run::compare(&name, &module, &explicit, &files);
    }
}

fn texts(module: &Module) -> Vec<(String, String)> {
    let files = emit(module, &Options::default());
    files.into_iter().map(|file| (file.name, file.text)).collect()
}

fn example(name: &str) -> Module {
    explicit(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/c").join(name))
}

#[test]
fn a_line_above_moves_nothing() {
    for path in modules() {
        let module = explicit(&path);
        let text = bessemer_ir::text::print(&module);
        let moved: Vec<String> = text.lines().map(moved_down).collect();
        let moved = bessemer_ir::text::parse(&moved.join("\n")).expect("only lines changed");
        assert_eq!(texts(&module), texts(&moved));
    }
}

/// `@0:12:5 …` as `@0:13:5 …`.
fn moved_down(line: &str) -> String {
    let Some((before, after)) = line.split_once("@0:") else { return line.to_owned() };
    let digits = after.find(|letter: char| !letter.is_ascii_digit()).unwrap_or(after.len());
    let Ok(number) = after[..digits].parse::<u32>() else { return line.to_owned() };
    if !before.trim().is_empty() {
        return line.to_owned();
    }
    format!("{before}@0:{}{}", number + 1, &after[digits..])
}

#[test]
fn a_new_function_leaves_the_others_as_they_were() {
    let before = example("linear.ir");
    let mut after = before.clone();
    let mut added = before.functions[1].clone();
    added.name = "added".to_owned();
    added.module = "models::other".to_owned();
    after.functions.insert(0, added);
    let after = texts(&after);
    for file in texts(&before) {
        assert!(after.contains(&file), "{} changed", file.0);
    }
}

#[test]
fn what_the_firmware_gives_is_asked_for_though_it_is_written_anew() {
    let own = example("copies.ir");
    let mut brought = own.clone();
    let fresh = brought.functions.iter_mut().find(|function| function.name == "fresh");
    fresh.expect("it is there").attributes.external = Some("part.h".to_owned());
    let asks = |module: &Module| {
        let source = texts(module).into_iter().find(|(name, _)| name == "copies.c");
        let text = source.expect("it has functions").1;
        let body = text.split("copies_rewritten(").nth(1).expect("it is defined");
        body.split("\n}").next().expect("it ends").contains("fresh(")
    };
    assert_eq!((asks(&own), asks(&brought)), (false, true));
}

#[test]
fn options_name_things() {
    let module = example("faults.ir");
    let options = Options {
        prefix: "acme_".to_owned(),
        status: "acme".to_owned(),
        license: "Apache-2.0".to_owned(),
        ..Options::default()
    };
    let files = emit(&module, &options);
    compilers::check("options", &files);
    let header = files.iter().find(|file| file.name == "acme_mixer.h").expect("it has a component");
    for wanted in [
        "ACME_MUST_USE acme_status_t acme_mixer_step(acme_mixer_t *ACME_RESTRICT self",
        "SPDX-License-Identifier: Apache-2.0",
        "#ifndef ACME_MIXER_H",
    ] {
        assert!(header.text.contains(wanted), "{wanted} in\n{}", header.text);
    }
}

/// The C for a compiler that knows no pragma, in ASCII, with a comment behind each line of the map.
#[test]
fn without_pragmas_in_ascii_and_with_trace_comments() {
    let plain = Tuning { mode: Mode::Plain, ..Tuning::default() };
    let options = Options {
        pragmas: false,
        ascii: true,
        trace_comments: true,
        self_test: true,
        kernels: plain,
        ..Options::default()
    };
    for name in ["kernels.ir", "loops.ir", "height.ir"] {
        let files = emit(&example(name), &options);
        for file in &files {
            let pragma =
                file.text.lines().find(|it| it.contains("#pragma") || it.contains("_Pragma"));
            assert_eq!(pragma, None, "{}", file.name);
            assert!(file.text.is_ascii(), "{}:\n{}", file.name, file.text);
            let lines: Vec<&str> = file.text.lines().collect();
            let is_traced = |row: &&MapLine| {
                let comment = format!(" /* {}:{} */", row.rust_file, row.rust_line);
                lines[row.c_line as usize - 1].ends_with(&comment)
            };
            assert_eq!(file.map.iter().find(|row| !is_traced(row)), None, "{}", file.name);
        }
        assert!(files.iter().any(|file| file.name == "bessemer_self_test.c"), "{name}");
        compilers::check(&format!("without-pragmas-{name}"), &files);
    }
}

/// gcc writes out loops of few passes, unless code must be small or loops are as the source has them.
#[test]
fn short_loops_stay_loops_where_code_must_be_small() {
    let small = Tuning { code_bytes: 1023, ..Tuning::default() };
    let plain = Tuning { mode: Mode::Plain, ..Tuning::default() };
    for (kernels, expected) in [(Tuning::default(), true), (small, false), (plain, false)] {
        let files = emit(&example("linear.ir"), &Options { kernels, ..Options::default() });
        let is_found = files.iter().any(|file| file.text.contains("BESSEMER_FEW_PASSES"));
        assert_eq!(is_found, expected, "{kernels:?}");
    }
}

/// Names that some linkers take for one: those that are equal in their first 31 characters, and external.
#[test]
fn external_names_alike_are_found() {
    let of = |name: &str| format!("fn {name} in m() -> f64 as x {{\n  return 1.0;\n}}\n");
    // With `m_` before it, the name has 31 characters.
    let begin = "temperature_of_the_coolant_at";
    let text = format!(
        "module m\n{}{}{}{}",
        of(begin),
        of(&format!("{begin}_inlet")),
        of(&format!("{begin}_outlet")),
        of("temperature_of_the_coolant_after"),
    );
    let module = bessemer_ir::text::parse(&text).expect("it parses");
    let (options, (explicit, _)) =
        (Options::default(), passes::explicit(module).expect("explicit"));
    let alike = Plan::new(&explicit, &options).alike();
    let names: Vec<_> =
        alike.iter().map(|(_, name, first)| (name.as_str(), first.as_str())).collect();
    let (first, inlet, outlet) =
        (format!("m_{begin}"), format!("m_{begin}_inlet"), format!("m_{begin}_outlet"));
    assert_eq!(names, [(inlet.as_str(), first.as_str()), (outlet.as_str(), first.as_str())]);
}

#[test]
fn it_gets_on_with_others() {
    for name in ["faults.ir", "kernels.ir", "height.ir"] {
        let module = example(name);
        packages::link_together(name, &module);
        packages::stand_beside_a_vendors(name, &module);
        packages::stand_in_a_folder(name, &module);
    }
}

/// `BESSEMER_SEEDS=100..200` tries others.
#[test]
fn random_modules_agree() {
    let seeds = std::env::var("BESSEMER_SEEDS").unwrap_or_else(|_| "0..3".to_owned());
    let (first, last) = seeds.split_once("..").expect("a range");
    for seed in first.parse::<u64>().expect("a number")..last.parse().expect("a number") {
        let module = generate::module(seed);
        let Ok(()) = validate(&module) else { continue };
        let (explicit, _) = bessemer_backend::passes::explicit(module.clone()).expect("explicit");
        let files = emit(&explicit, &Options::default());
        run::compare("random", &module, &explicit, &files);
    }
}

/// Statements over the elements of vectors have the interpreter's values, whichever share a loop.
#[test]
fn joined_loops_compute_what_the_interpreter_computes() {
    let seeds = std::env::var("BESSEMER_SEEDS").unwrap_or_else(|_| "0..1".to_owned());
    let (first, last) = seeds.split_once("..").expect("a range");
    for seed in first.parse::<u64>().expect("a number")..last.parse().expect("a number") {
        let module = vectors::module(seed, 12);
        validate(&module).unwrap_or_else(|errors| panic!("seed {seed}: {errors:#?}"));
        let (explicit, _) = passes::explicit(module.clone()).expect("explicit");
        let files = emit(&explicit, &Options::default());
        run::compare("joined-random", &module, &explicit, &files);
        let joined: usize = files.iter().map(|file| statements_in_loops(&file.text)).sum();
        assert!(joined > 4, "seed {seed}: {joined} statements joined others");
    }
}

/// Number of statements beside another one in a loop over six elements.
fn statements_in_loops(text: &str) -> usize {
    let loops = text.split("< 6U; ").skip(1);
    let bodies = loops.filter_map(|rest| rest.split_once('{')?.1.split_once('}'));
    bodies.map(|(body, _)| body.matches(';').count().saturating_sub(1)).sum()
}

/// Checks that were proved are in the C, and none of them fails.
#[test]
fn kept_checks_hold() {
    let options = Options { keep_checks: true, ..Options::default() };
    for path in modules() {
        let module = load(&path);
        let (kept, _) =
            bessemer_backend::passes::explicit_with(module.clone(), passes::Choices::KEPT)
                .unwrap_or_else(|errors| panic!("{}: {errors:#?}", path.display()));
        let name = path.file_stem().expect("a file").to_string_lossy().into_owned();
        // What fails fails with either compiler.
        let compiler = compilers::by_turn(&run::COMPILERS, 1, 0);
        run::compare_with(
            &compiler,
            &format!("kept-{name}"),
            &module,
            &kept,
            &emit(&kept, &options),
        );
    }
}
