//! The results that are committed: the report says what their JSON has, and what is missed has its reason.
//!
//! `UPDATE_DOCS=1 cargo test -p bench --test stored` writes the report anew, where what is said of the figures has changed.

use std::fs;
use std::path::PathBuf;

use bench::crates::page;
use bench::kernels::machine::{A9, HOST_V3};
use bench::kernels::reasons::{Reasons, unsettled};
use bench::kernels::results::Results;
use bench::kernels::{plot, report, stored};
use bench::wasm::{PAGE, linear_memory};
use bench::{dsp, ekf, gradient, peers, qp};
use bessemer_codegen::estimate;
use serde_json::Value;

fn file(name: &str) -> PathBuf {
    bessemer_tests::root().join("bench/results").join(name)
}

fn committed() -> (Results, Value) {
    let text = fs::read_to_string(file("kernels.json")).expect("results are committed");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    let results = Results::from_json(&json).expect("the results of a run");
    (results, json)
}

#[test]
fn the_json_is_what_the_bench_writes() {
    let (results, json) = committed();
    let text = fs::read_to_string(file("kernels.json")).expect("results are committed");
    assert!(stored::text(&results.json(&json["about"])) == text, "kernels.json has another form");
}

#[test]
fn the_report_says_what_the_json_has() {
    let (results, json) = committed();
    let files = [
        ("kernels.md", report::markdown(&results, &json["about"], &reasons())),
        ("chapter6.svg", plot::chapter_6(&results)),
        ("small.svg", plot::small(&results)),
    ];
    for (name, text) in files {
        if std::env::var_os("UPDATE_DOCS").is_some() {
            fs::write(file(name), &text).expect("bench/results is there");
        }
        let found = fs::read_to_string(file(name)).expect("it is committed");
        assert!(found == text, "{name} is stale: UPDATE_DOCS=1 cargo test -p bench --test stored");
    }
}

#[test]
fn the_page_of_crates_says_what_the_json_has() {
    let text = page::text().expect("results are committed");
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::write(page::path(), &text).expect("docs is there");
    }
    let found = fs::read_to_string(page::path()).expect("it is committed");
    assert!(
        found == text,
        "docs/crates.md is stale: UPDATE_DOCS=1 cargo test -p bench --test stored"
    );
}

#[test]
fn the_page_of_blocks_says_what_the_json_has() {
    let text = fs::read_to_string(file("dsp.json")).expect("results are committed");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    let names: Vec<&str> = dsp::jobs::JOBS.iter().map(|job| job.name).collect();
    let found = json["jobs"].as_array().expect("jobs").iter();
    let found: Vec<&str> = found.filter_map(|job| job["job"].as_str()).collect();
    assert_eq!(found, names, "dsp.json has other jobs");
    // A count has the call of the function, too.
    let call = estimate::Class::Call.cost().instructions;
    for job in json["jobs"].as_array().expect("jobs") {
        let (count, most) = (&job["instructions"]["emitted C"], &job["estimate"]);
        let (count, most) = (count.as_u64().expect("a count"), most.as_u64().expect("a bound"));
        assert!(count <= most + call, "{}: {count}, estimated {most}", job["job"]);
    }
    let page = dsp::page::markdown(&json);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::write(file("dsp.md"), &page).expect("bench/results is there");
    }
    let found = fs::read_to_string(file("dsp.md")).expect("it is committed");
    assert!(found == page, "dsp.md is stale: UPDATE_DOCS=1 cargo test -p bench --test stored");
}

#[test]
fn the_page_of_the_filter_says_what_the_json_has() {
    let text = fs::read_to_string(file("ekf.json")).expect("results are committed");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    let rows = json["rows"].as_array().expect("rows");
    assert_eq!(
        rows.len(),
        peers::MACHINES.len() * ekf::FILTER.contenders.len(),
        "ekf.json lacks rows"
    );
    let page = ekf::page::markdown(&json);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::write(file("ekf.md"), &page).expect("bench/results is there");
    }
    let found = fs::read_to_string(file("ekf.md")).expect("it is committed");
    assert!(found == page, "ekf.md is stale: UPDATE_DOCS=1 cargo test -p bench --test stored");
}

#[test]
fn the_page_of_the_gradient_says_what_the_json_has() {
    let text = fs::read_to_string(file("gradient.json")).expect("results are committed");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    let rows = json["rows"].as_array().expect("rows");
    let wanted = peers::MACHINES.len() * gradient::ROLLOUT.contenders.len();
    assert_eq!(rows.len(), wanted, "gradient.json lacks rows");
    let page = gradient::markdown(&json);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::write(file("gradient.md"), &page).expect("bench/results is there");
    }
    let found = fs::read_to_string(file("gradient.md")).expect("it is committed");
    let renewal = "UPDATE_DOCS=1 cargo test -p bench --test stored";
    assert!(found == page, "gradient.md is stale: {renewal}");
}

#[test]
fn the_page_of_quadratic_programs_says_what_the_json_has() {
    let text = fs::read_to_string(file("qp.json")).expect("results are committed");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    let rows = json["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), qp::CONTENDERS.len(), "qp.json lacks rows");
    let page = qp::page::markdown(&json);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::write(file("qp.md"), &page).expect("bench/results is there");
    }
    let found = fs::read_to_string(file("qp.md")).expect("it is committed");
    assert!(found == page, "qp.md is stale: UPDATE_DOCS=1 cargo test -p bench --test stored");
}

#[test]
fn the_page_of_the_autopilot_says_what_the_json_has() {
    let text = fs::read_to_string(file("autopilot.json")).expect("results are committed");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    let rows = json["rows"].as_array().expect("rows");
    let wanted = peers::MACHINES.len() * ekf::AUTOPILOT.contenders.len();
    assert_eq!(rows.len(), wanted, "autopilot.json lacks rows");
    let page = ekf::page::of_autopilot(&json);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::write(file("autopilot.md"), &page).expect("bench/results is there");
    }
    let found = fs::read_to_string(file("autopilot.md")).expect("it is committed");
    let renewal = "UPDATE_DOCS=1 cargo test -p bench --test stored";
    assert!(found == page, "autopilot.md is stale: {renewal}");
}

fn reasons() -> Reasons {
    Reasons::committed().expect("reasons are committed")
}

/// Checks that each missed goal and case has a reason in `bench/results/reasons.json`, and that no reason is
/// superfluous.
#[test]
fn what_is_missed_has_its_reason_and_nothing_else_has_one() {
    assert_eq!(unsettled(&committed().0, &reasons()), [""; 0]);
}

#[test]
fn a_goal_that_is_newly_missed_is_seen() {
    let (mut results, _) = committed();
    // More than twice the code, and the stack.
    for size in &mut results.sizes {
        (size.text, size.stack) = (4 * size.text, 8 * size.stack);
    }
    assert_eq!(unsettled(&results, &reasons()).len(), 5, "four of code, and the stack");
    results.chapter_6.clear();
    assert_eq!(unsettled(&results, &reasons()).len(), 5 + 18, "not measured is not reached");
}

#[test]
fn a_goal_that_is_missed_by_more_than_its_reason_speaks_for_is_seen() {
    let (mut results, _) = committed();
    let table = results.chapter_6.iter_mut().find(|table| table.machine == HOST_V3);
    let table = table.expect("it is measured");
    for cell in table.rows[0].cells.iter_mut().flatten() {
        cell.times.as_mut().expect("times").ratio += 0.001;
    }
    assert_eq!(unsettled(&results, &reasons()).len(), 2, "beside Eigen, beside OpenBLAS");
}

/// The generated C's instructions for a case on the Cortex-A9, times so many; and what is then to be looked at.
fn unsettled_with(case: &str, times: u64) -> Vec<String> {
    let (mut results, _) = committed();
    let table = results.small.iter_mut().find(|table| table.machine == A9).expect("it is measured");
    let row = table.rows.iter_mut().find(|row| row.case.name() == case).expect("a case");
    let count = row.cells[0].as_mut().and_then(|cell| cell.instructions.as_mut());
    *count.expect("a count") *= times;
    unsettled(&results, &reasons())
}

#[test]
fn a_case_that_is_newly_above_its_limit_is_seen() {
    let seen = unsettled_with("lu_solve_f64_6", 9);
    // It has no reason either, so that there is one more of those.
    assert_eq!(seen.len(), 2, "{seen:?}");
    assert!(seen[0].starts_with("lu_solve_f64_6 on a9 beside"), "{seen:?}");
}

#[test]
fn a_reason_that_is_needed_no_more_is_seen() {
    let seen = unsettled_with("product_f32_6", 0);
    assert_eq!(seen, ["product_f32_6 on a9 beside eigen: listed, and not above its limit"]);
}

/// The report of WebAssembly states the linear memory.
#[test]
fn the_memory_of_a_module_is_read() {
    let head = b"\0asm\x01\0\0\0";
    let of = |sections: &[u8]| linear_memory(&[head, sections].concat());
    // A section of types, then a memory of 2 pages; one of 130 pages at most 200.
    assert_eq!(of(&[1, 2, 9, 9, 5, 3, 1, 0, 2]), Some(2 * PAGE));
    assert_eq!(of(&[5, 6, 1, 1, 0x82, 1, 0xC8, 1]), Some(130 * PAGE));
    assert_eq!([of(&[]), of(&[5, 1, 0]), of(&[1, 9, 0]), linear_memory(b"\0as")], [None; 4]);
}
