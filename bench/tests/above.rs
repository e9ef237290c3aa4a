//! The list of what takes more than the best.

use bench::kernels::above::markdown;
use bench::kernels::case::{Case, Element, Routine};
use bench::kernels::contender::Contender;
use bench::kernels::machine::HOST_SSE2;
use bench::kernels::results::{Cell, Results, Row, Table};

fn results(own: u64, other: u64) -> Results {
    let case = Case { routine: Routine::Product, element: Element::F64, size: 6 };
    let cell = |count| Some(Cell { instructions: Some(count), times: None });
    let row = Row { case, cells: vec![cell(own), cell(other)] };
    let contenders = vec![Contender::Generated, Contender::Naive];
    let table = Table { machine: HOST_SSE2, contenders, rows: vec![row] };
    Results { small: vec![table], ..Results::default() }
}

#[test]
fn what_is_above_its_limit_is_listed() {
    assert_eq!(markdown(&results(90, 100)), "");
    assert!(markdown(&results(95, 100)).contains("product f64 6 | 0.95 | 0.9 | naive C"));
}
