//! Contracts in ACSL are comments: without them the C is equal. Those of a loop and of a head are as expected.

use bessemer_backend::c::{Options, emit};

use super::{example, explicit, modules};

/// The text without contracts and without the lines that they leave empty.
fn without_contracts(text: &str) -> String {
    let mut kept = String::new();
    let mut inside = false;
    for line in text.lines() {
        let begins = line.trim_start().starts_with("/*@");
        inside |= begins;
        if !inside {
            kept.push_str(line);
            kept.push('\n');
        }
        inside &= !line.trim_end().ends_with("*/");
    }
    kept
}

#[test]
fn contracts_change_nothing_but_comments() {
    let with = Options { contracts: true, ..Options::default() };
    for path in modules() {
        let module = explicit(&path);
        let (plain, contracts) = (emit(&module, &Options::default()), emit(&module, &with));
        assert_eq!(plain.len(), contracts.len());
        for (plain, contract) in plain.iter().zip(&contracts) {
            let gaps = |text: &str| text.replace("\n\n", "\n");
            let stripped = without_contracts(&contract.text);
            assert_eq!(gaps(&plain.text), gaps(&stripped), "{}", plain.name);
            let lines: Vec<&str> = contract.text.lines().collect();
            for row in &contract.map {
                let line = lines[row.c_line as usize - 1].trim_start();
                assert!(!line.starts_with("/*@") && !line.starts_with("requires"), "{line}");
            }
        }
    }
}

/// The C of a module with contracts, all files as one text.
fn contracts(name: &str) -> String {
    let options = Options { contracts: true, ..Options::default() };
    emit(&example(name), &options).into_iter().map(|it| it.text).collect()
}

#[test]
fn a_contract_has_what_is_read_and_changed() {
    let height = contracts("height.ir");
    for clauses in [
        "/*@\n  requires \\valid(self);\n  requires \\valid_read(gains);\n  requires \\separated(self, gains);\n  \
         assigns *self;\n*/\ndouble height_step(",
        "/*@\n  requires \\valid_read(self);\n  assigns \\nothing;\n*/\nstatic bool height_settled(",
        "/*@ assigns \\nothing; */\nstatic inline double clamp_f64(",
    ] {
        assert!(height.contains(clauses), "{clauses}\nin\n{height}");
    }
}

#[test]
fn a_loop_has_what_it_changes_and_the_bounds_of_its_counter() {
    let loops = contracts("loops.ir");
    for clauses in [
        "/*@\n      loop invariant 0U <= i;\n      loop invariant i <= 3U;\n      loop assigns i, total;\n      \
         loop variant 3U - i;\n    */\n    for (uint32_t i = 0U; i < 3U; i++) {",
        // It counts down, so its counter has no bounds.
        "/*@ loop assigns i, sum; */\n    for (uint8_t i = to; i-- > from;) {",
    ] {
        assert!(loops.contains(clauses), "{clauses}\nin\n{loops}");
    }
}
