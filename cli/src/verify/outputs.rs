//! Writes a replayed recording as CSV: a row for each call, with its inputs, its outputs and the state after it.
//!
//! Inputs have the names that `--inputs` expects, so the file is a valid recording itself. The names of the other
//! columns begin with `out:`, which is no name in Rust.

use bessemer_ir::{Mode, Module};

use super::Case;
use super::recording::{Column, columns_of};

/// The table of the calls of an entry point.
pub fn csv(module: &Module, case: &Case) -> String {
    let function = &module.functions[case.id.index()];
    let parameters = function.parameters();
    let (mut inputs, mut outputs) = (Vec::new(), Vec::new());
    for parameter in parameters.iter().skip(1) {
        columns_of(module, &parameter.ty, &parameter.name, &mut inputs);
    }
    columns_of(module, &function.result, "out:result", &mut outputs);
    let changed = parameters.iter().enumerate();
    for (_, it) in changed.filter(|(at, it)| *at == 0 || it.mode == Mode::RefMut) {
        let name = if it.name == parameters[0].name { "self" } else { &it.name };
        columns_of(module, &it.ty, &format!("out:{name}"), &mut outputs);
    }
    let names = inputs.iter().chain(&outputs).map(|it| it.name.as_str());
    let mut rows = vec![names.chain(["out:fault"]).collect::<Vec<_>>().join(",")];
    for (call, outcome) in case.calls.iter().zip(&case.expected) {
        let words = call.iter().skip(1).flatten();
        let mut cells: Vec<String> = texts(module, &inputs, words);
        match outcome {
            Ok(words) => {
                cells.extend(texts(module, &outputs, words.iter()));
                cells.push(String::new());
            }
            Err(fault) => {
                cells.extend(outputs.iter().map(|_| String::new()));
                cells.push(format!("{fault:?}"));
            }
        }
        rows.push(cells.join(","));
    }
    rows.join("\n") + "\n"
}

fn texts<'w>(
    module: &Module,
    columns: &[Column],
    words: impl Iterator<Item = &'w u64>,
) -> Vec<String> {
    columns.iter().zip(words).map(|(column, word)| column.text(module, *word)).collect()
}
