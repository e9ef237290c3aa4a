//! Large temporaries are the caller's: a work struct in the signature, nothing large on the stack.

use bessemer_tests::interpreter::Interpreted;
use bessemer_tests::pilot::entry;
use bessemer_tests::process::Process;
use bessemer_tests::toolchain;
use bessemer_tests::workspace::Workspace;

const MODEL: &str = "//! A chain of large products.
#![no_std]
use bessemer::prelude::*;

/// Powers of a matrix.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Powers {
    /// Number of steps.
    pub steps: f64,
}

/// The square of `a`, scaled.
#[function]
pub fn scaled_square(a: &SMatrix<f64, 7, 7>, scale: f64) -> SMatrix<f64, 7, 7> {
    let square = a * a;
    let turned = square.transpose();
    turned * scale
}

#[component]
impl Powers {
    /// The sum of the first powers of `a`, by rows.
    #[entry(infallible)]
    pub fn step(&mut self, a: &SMatrix<f64, 7, 7>, scale: f64) -> SVector<f64, 7> {
        self.steps += 1.0;
        let square = scaled_square(a, scale);
        let fourth = scaled_square(&square, self.steps);
        let sum = a + square + fourth;
        let mut rows = SVector::<f64, 7>::zeros();
        for row in 0..7 {
            for column in 0..7 {
                rows[row] += sum[(row, column)];
            }
        }
        rows
    }
}
";

#[test]
fn large_temporaries_are_lent_by_the_caller() {
    let workspace = Workspace::with_source(MODEL).expect("a workspace");
    let compiled = workspace.compiled().unwrap_or_else(|said| panic!("{said}"));
    let header = compiled.files.iter().find(|file| file.name == "powers.h").expect("a header");
    assert!(header.text.contains("powers_step_work_t *BESSEMER_RESTRICT work"), "{}", header.text);
    assert!(compiled.entries[0].stack_bytes < 512, "{:?}", compiled.entries[0]);

    let step = entry(&compiled, "Powers", "step").expect("an entry point");
    for toolchain in toolchain::all().iter().filter(|it| it.level == 2) {
        let mut c = Process::start(&compiled, step, toolchain)
            .unwrap_or_else(|error| panic!("{}: {error}", toolchain.name()));
        let mut interpreter = Interpreted::new(&compiled.module, step);
        for seed in 1..20_u32 {
            let a: Vec<u64> = (0..49).map(|n| f64::from(seed * n % 17).sqrt().to_bits()).collect();
            let scale = vec![f64::from(seed).recip().to_bits()];
            let expected = interpreter.step(&[a.clone(), scale.clone()]).expect("no fault");
            let found = c.step(&[a, scale].concat()).expect("a running process");
            assert_eq!(found[1..], expected, "{}", toolchain.name());
        }
    }
}

/// Read by people: the C of the test's model.
#[test]
fn the_c_reads_well() {
    let workspace = Workspace::with_source(MODEL).expect("a workspace");
    let compiled = workspace.compiled().unwrap_or_else(|said| panic!("{said}"));
    let shown: Vec<&str> = ["powers.h", "powers.c"]
        .iter()
        .filter_map(|name| compiled.files.iter().find(|file| file.name == *name))
        .map(|file| file.text.as_str())
        .collect();
    insta::assert_snapshot!(shown.join("\n"));
}
