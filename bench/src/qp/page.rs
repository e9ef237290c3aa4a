//! The page of the results, `bench/results/qp.md`.

use std::fmt::Write as _;

use serde_json::Value;

use crate::dsp::page::grouped;

/// Returns the page of a result file.
pub fn markdown(json: &Value) -> String {
    let mut text = String::from(
        "# Quadratic programs beside OSQP, CVXPYgen and TinyMPC\n\n\
         A predictive control of a quadcopter's linear model in double precision: twelve states, four inputs with limits, ten periods. Twenty states of a\n\
         flight to a point, in executed instructions of a Cortex-A9 by gcc `-O2` without contraction, counted under QEMU. Each contender begins at its last\n\
         solution, and iterates until it is within 1e-6 of the minimum: its inputs are compared with those of the active set before its instructions count.\n\n\
         The emitted solvers are `ActiveSet` and `Admm` of [`bessemer-blocks`](../../docs/book/blocks/quadratic.md), on the program in the inputs alone;\n\
         `Admm` has 1,200 iterations in each step, as many as the hardest of them needs. OSQP and CVXPYgen, whose solver is OSQP, have the sparse program of\n\
         states and inputs, as their authors recommend, with tolerances of 1e-9. OSQP has a step size that suits this problem. CVXPYgen's code takes no step\n\
         size, and runs into its limit of 20,000 iterations each time. Code is in bytes, with constants. Variables are those of solver and problem, without the\n\
         stack; TinyMPC's are on the heap.\n\n\
         `cargo xtask bench --only qp --peers FOLDER` measures it again, with `TinyMPC` in that folder, and writes [qp.json](qp.json) and this page.\n\n\
         | | instructions of a step: mean | most | code | variables | largest error |\n|---|--:|--:|--:|--:|--:|\n",
    );
    for row in json["rows"].as_array().into_iter().flatten() {
        let cell = |key: &str| row[key].as_u64().map_or("–".to_owned(), grouped);
        let name = row["contender"].as_str().unwrap_or_default();
        let error = row["error"].as_str().unwrap_or_default();
        let cells = ["mean", "most", "text", "ram"].map(cell).join(" | ");
        let _ = writeln!(text, "| {name} | {cells} | {error} |");
    }
    text += "\n## Versions\n\n";
    for (name, version) in json["versions"].as_object().into_iter().flatten() {
        let _ = writeln!(text, "* {name}: {}", version.as_str().unwrap_or_default());
    }
    text
}
