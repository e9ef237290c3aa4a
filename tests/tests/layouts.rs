//! The layouts of matrices: how the C spells them. `corpus.rs` holds the bits.

use bessemer_codegen::compile::Layout;
use bessemer_tests::toolchain::{self, run};
use bessemer_tests::workspace::Workspace;

const MODEL: &str = "//! Matrices.
#![no_std]
use bessemer::nalgebra::Matrix2x3;
use bessemer::prelude::*;

/// A map from the plane.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Map {
    /// Its matrix.
    pub matrix: Matrix2x3<f64>,
}

/// An element that someone else names, and the one before.
#[function]
pub fn element(map: &Map, i: usize) -> f64 {
    map.matrix[(i % 2, 2)] + map.matrix[(1, 0)]
}

/// A matrix as a whole.
#[function]
pub fn turned(a: &Matrix2<f64>, b: &Matrix2x3<f64>) -> Matrix2x3<f64> {
    a * b
}

/// A table.
pub const TABLE: Matrix2<f64> = Matrix2::new(1.0, 2.0, 3.0, 4.0);

/// With the table.
#[function]
pub fn tabled(v: &Vector2<f64>) -> Vector2<f64> {
    TABLE * v
}

/// A system of equations.
#[function]
pub fn solved(a: &Matrix2<f64>, b: &Vector2<f64>) -> Option<Vector2<f64>> {
    bessemer::solve(a, b)
}
";

#[test]
fn each_layout_spells_matrices_its_way() {
    let workspace = Workspace::with_source(MODEL).expect("a workspace");
    let mut job = workspace.job();
    let spellings: [(Layout, &[&str]); 3] = [
        (
            Layout::Columns,
            &[
                "double matrix[6];",
                "map->matrix[(i % UINT64_C(2)) + 2U * 2U] + map->matrix[1 + 2 * 0]",
                "const double a[4], const double b[6], double result[BESSEMER_RESTRICT 6]",
            ],
        ),
        (
            Layout::Rows,
            &[
                "double matrix[6];",
                "map->matrix[2U + 3U * (i % UINT64_C(2))] + map->matrix[0 + 3 * 1]",
                "const double a[4], const double b[6], double result[BESSEMER_RESTRICT 6]",
            ],
        ),
        (
            Layout::Array,
            &[
                "double matrix[2][3];",
                "map->matrix[i % UINT64_C(2)][2] + map->matrix[1][0]",
                "const double a[2][2], const double b[2][3], double result[BESSEMER_RESTRICT 2][3]",
            ],
        ),
    ];
    for (layout, spellings) in spellings {
        job.options.layout = layout;
        let summary = workspace.perform(&job).expect("generated");
        let files = &summary.compiled.files;
        let text: String = files.iter().map(|file| file.text.as_str()).collect();
        let words: Vec<&str> = text.split_whitespace().collect();
        let unbroken = words.join(" ");
        for spelling in spellings {
            assert!(unbroken.contains(spelling), "{spelling} is not in\n{text}");
        }
        let table = match layout {
            Layout::Columns => "1.0, 3.0,",
            Layout::Rows => "1.0, 2.0,",
            Layout::Array => "{1.0, 2.0}",
        };
        assert!(text.contains(table), "{table} is not in\n{text}");
        for toolchain in toolchain::host().iter().filter(|it| it.level == 0) {
            for file in files.iter().filter(|file| file.name.ends_with(".c")) {
                let object = workspace.path("model.o");
                let mut command = toolchain.command();
                command.arg("-c").arg(job.output.join(&file.name)).arg("-o").arg(&object);
                run(&mut command).expect("an object");
            }
        }
    }
}
