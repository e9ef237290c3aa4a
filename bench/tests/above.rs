//! The list of what takes more than the best.

use bench::kernels::above::markdown;
use bench::kernels::case::{Case, Element, Routine};
use bench::kernels::contender::Contender;
use bench::kernels::machine::{A9, HOST_SSE2, Machine};
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
    assert_eq!(markdown(&results(HOST_SSE2, case, 90, 100)), "");
    let text = markdown(&results(HOST_SSE2, case, 95, 100));
    assert!(text.contains("product f64 6 | 0.95 | 0.9 | naive C"));
}

#[test]
fn a_case_says_why_and_one_that_nobody_has_looked_at_says_so() {
    let cholesky = |size| Case { routine: Routine::CholeskySolve, element: Element::F64, size };
    assert!(markdown(&results(A9, cholesky(2), 37, 35)).contains("`None` take six"));
    assert!(markdown(&results(A9, cholesky(7), 70, 100)).contains("no reason known"));
}
