//! Derivatives equal differences of the function, which know no rule of a derivative: neither the generator's nor the
//! dual numbers'.
//!
//! At a kink, near a pole and where rounding decides, differences of other steps differ, and there is no comparison.

use bessemer_interpret::Interpreter;
use bessemer_ir::{FunctionId, Module};

/// Largest difference between a derivative and a quotient of differences, relative to the larger of both and 1.
const BOUND: f64 = 1e-5;

/// Arguments or results of a call, as words.
pub type Words = Vec<Vec<u64>>;

/// Returns the derivatives of the words of a result by a word of the arguments; none where differences disagree.
pub fn slopes(
    module: &Module,
    function: FunctionId,
    arguments: &Words,
    (argument, word): (usize, usize),
) -> Vec<Option<f64>> {
    let x = f64::from_bits(arguments[argument][word]);
    let at = |step: f64| -> Option<Vec<f64>> {
        let mut moved = arguments.clone();
        moved[argument][word] = (x + step).to_bits();
        let found = Interpreter::new(module).call(function, &mut moved).ok()?;
        Some(found.into_iter().map(f64::from_bits).collect())
    };
    let step = 1e-5 * x.abs().max(1.0);
    let steps = [0.0, step, -step, 0.5 * step, -0.5 * step].map(at);
    let [Some(here), Some(after), Some(before), Some(near_after), Some(near_before)] = steps else {
        return Vec::new();
    };
    let each = (0..here.len()).map(|row| {
        let central = (after[row] - before[row]) / (2.0 * step);
        let near = (near_after[row] - near_before[row]) / step;
        let sides = [(after[row] - here[row]) / step, (here[row] - before[row]) / step];
        let scale = here[row].abs().max(central.abs()).max(1.0);
        let agrees = |other: f64, bound: f64| (other - central).abs() <= bound * scale;
        let smooth = agrees(near, 0.1 * BOUND) && sides.iter().all(|side| agrees(*side, BOUND));
        // The differences of larger numbers have too few digits.
        (smooth && here[row].abs() <= 1e3).then_some(central)
    });
    each.collect()
}

/// Returns true if a derivative equals a quotient of differences.
pub fn agree(found: f64, difference: f64) -> bool {
    (found - difference).abs() <= BOUND * found.abs().max(difference.abs()).max(1.0)
}
