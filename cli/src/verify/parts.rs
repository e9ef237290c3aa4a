//! The words of recorded calls, by argument.

use bessemer_ir::{FunctionId, Module};

use super::named;
use crate::error::Error;

/// Returns the number of words of each argument except the component, and checks those of each call.
///
/// # Errors
/// [`Error::Words`] if a call has another number of words.
pub fn widths(module: &Module, entry: FunctionId, calls: &[Vec<u64>]) -> Result<Vec<usize>, Error> {
    let function = &module.functions[entry.index()];
    let counts: Vec<usize> =
        function.parameters().iter().skip(1).map(|it| module.width(&it.ty)).collect();
    let taken = counts.iter().sum();
    match calls.iter().find(|words| words.len() != taken) {
        Some(words) => {
            let name = named(module, function);
            Err(Error::Words { name, found: words.len(), wanted: taken })
        }
        None => Ok(counts),
    }
}

/// Parts the words of each call into those of each argument except the component.
///
/// # Errors
/// [`Error::Words`] if a call has another number of words.
pub fn parted(
    module: &Module,
    entry: FunctionId,
    calls: &[Vec<u64>],
) -> Result<Vec<Vec<Vec<u64>>>, Error> {
    let counts = widths(module, entry, calls)?;
    let parted = |words: &Vec<u64>| {
        let mut rest = words.as_slice();
        let parts = counts.iter().filter_map(|count| rest.split_off(..*count));
        parts.map(<[u64]>::to_vec).collect()
    };
    Ok(calls.iter().map(parted).collect())
}
