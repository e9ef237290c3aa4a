//! The list of what takes more than the best.

use bench::kernels::above::markdown;
use bench::kernels::case::{Case, Element, Routine};
use bench::kernels::contender::Contender;
use bench::kernels::machine::{A9, HOST_SSE2, Machine};
use bench::kernels::reasons::Reasons;
use bench::kernels::results::{Cell, Results, Row, Table};

fn results(machine: Machine, case: Case, own: u64, other: u64) -> Results {
    let cell = |count| Some(Cell { instructions: Some(count), times: None });
    let row = Row { case, cells: vec![cell(own), cell(other)] };
    let contenders = vec![Contender::Generated, Contender::Naive];
    let table = Table { machine, contenders, rows: vec![row], processor: None };
    Results { small: vec![table], ..Results::default() }
}

#[test]
fn what_is_above_its_limit_is_listed() {
    let case = Case { routine: Routine::Product, element: Element::F64, size: 6 };
    let markdown =
        |own, other| markdown(&results(HOST_SSE2, case, own, other), &Reasons::default());
    assert_eq!(markdown(90, 100), "");
    let text = markdown(95, 100);
    assert!(text.contains("product f64 6 | 0.95 | 0.9 | naive C"));
}

#[test]
fn a_case_says_why_and_one_that_nobody_has_looked_at_says_so() {
    let json = r#"{ "missed": [], "above": [
        { "why": "roots", "cases": [{ "machine": "a9", "case": "cholesky_solve_f64_2", "best": "naive" }] }
    ] }"#;
    let reasons = Reasons::from_json(json).expect("reasons");
    let of = |machine, size, own| {
        let case = Case { routine: Routine::CholeskySolve, element: Element::F64, size };
        markdown(&results(machine, case, own, 35), &reasons)
    };
    assert!(of(A9, 2, 37).contains("| roots |"));
    // A reason speaks for its case on its machine alone.
    assert!(of(A9, 3, 37).contains("no reason known"));
    assert!(of(HOST_SSE2, 2, 37).contains("no reason known"));
}
