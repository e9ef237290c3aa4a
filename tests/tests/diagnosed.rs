//! Mistakes that only generation detects, reported at the author's line. Each file of `tests/diagnosed/` is a package
//! of models, and its snapshot is the output of `cargo xtask gen`. A run has half of them, the next one the others.

use std::fs;
use std::path::PathBuf;

use bessemer_codegen::generate::{self, Error};
use bessemer_tests::turn;
use bessemer_tests::workspace::Workspace;

#[test]
fn each_error_has_its_authors_terms() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("diagnosed");
    let mut cases: Vec<PathBuf> = fs::read_dir(folder)
        .expect("the cases")
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .collect();
    cases.sort();
    let half = cases.len().div_ceil(2);
    let cases = turn::some_of(cases, half);
    let workspace = Workspace::with_source("").expect("a workspace");
    for case in cases {
        let text = fs::read_to_string(&case).expect("a case");
        workspace.set_source(&text).expect("a source file");
        // As `gen` does: it writes the bodies of derivatives first.
        let renewed = match text.contains("(derivative(") {
            true => generate::renewed(&workspace.job()).map(|_| ()),
            false => Ok(()),
        };
        let said = match renewed.and_then(|()| workspace.generate("0")) {
            Err(Error::Models(said) | Error::Refused(said)) => said.to_string(),
            Err(other) => panic!("{}: {other}", case.display()),
            Ok(_) => panic!("{} was generated", case.display()),
        };
        assert!(!said.contains("__"), "{}: internals show:\n{said}", case.display());
        let name = case.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        insta::with_settings!({ prepend_module_to_snapshot => false, snapshot_path => "../diagnosed", omit_expression => true }, {
            insta::assert_snapshot!(name, said);
        });
    }
}
