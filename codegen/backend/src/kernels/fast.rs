//! Contract of the fast mode. The order of a sum is free and multiply-add may be fused, so the bits can differ from the
//! Rust's. The error has a bound that is valid for any order, fused or not.
//!
//! The bounds are Higham's (*Accuracy and Stability of Numerical Algorithms*, second edition). With `u` half a unit in the
//! last place of 1 and `γ(n) = n u / (1 − n u)`:
//! * solves, and each column of an inverse: `(A + E) x = b` with `|E| ≤ γ(3 n) |L| |U|` (theorem 9.4). Multipliers are
//!   products with a reciprocal, which round once more than quotients; below the diagonal of column `j` that is
//!   `γ(j + 1)` in place of `γ(j)` for an element, and `j < n`. Quotients of the way back may be such products too: then
//!   U's diagonal has `γ(n + 1)` in place of `γ(n)`, which L, whose diagonal needs no quotient, leaves room for: it has
//!   `γ(n − 1)`.
//! * products: `|C − A B| ≤ γ(n) |A| |B|`, of `n` terms (section 3.5).
//!
//! They hold element by element, where nothing underflows.

use bessemer_ir::{Float, Kernel, KernelRoutine};

/// Half a unit in the last place of 1.
fn unit(element: Float) -> f64 {
    match element {
        Float::F64 => f64::EPSILON / 2.0,
        Float::F32 => f64::from(f32::EPSILON) / 2.0,
    }
}

/// Returns `γ(n)`, the relative error that `n` roundings can cause.
fn gamma(roundings: u32, element: Float) -> f64 {
    let error = f64::from(roundings) * unit(element);
    error / (1.0 - error)
}

/// Returns the factor of a kernel's error bound in the fast mode: of `|A| |B|` for a product, of `|L| |U|` for all
/// others.
pub fn factor(kernel: &Kernel) -> f64 {
    let roundings = match (kernel.routine, kernel.dims.as_slice()) {
        (
            KernelRoutine::Product | KernelRoutine::ProductTr | KernelRoutine::TrProduct,
            &[_, terms, _],
        ) => terms,
        (_, dims) => 3 * dims[0],
    };
    gamma(roundings, kernel.element)
}

/// Returns the error bound of a kernel in the fast mode, as one line of ASCII.
pub fn bound(kernel: &Kernel) -> String {
    let factor = upwards(factor(kernel));
    match kernel.routine {
        KernelRoutine::Product => format!("|result - a b| <= {factor} |a| |b|"),
        KernelRoutine::ProductTr => format!("|result - a b'| <= {factor} |a| |b'|"),
        KernelRoutine::TrProduct => format!("|result - a' b| <= {factor} |a'| |b|"),
        KernelRoutine::Inverse => {
            format!("(a + E) x = e, column by column, with |E| <= {factor} |L| |U|")
        }
        _ => format!("(a + E) x = b with |E| <= {factor} |L| |U|"),
    }
}

/// Rounds a number up to two digits: half a unit of the second digit is at most a twentieth of the number.
fn upwards(number: f64) -> String {
    let nearest = format!("{number:.1e}");
    let is_below = nearest.parse().is_ok_and(|nearest: f64| nearest < number);
    if is_below { format!("{:.1e}", 1.05 * number) } else { nearest }
}

/// Returns the note in a kernel of the fast mode.
pub(super) fn note(kernel: &Kernel) -> String {
    format!(
        "/* The fast mode: steps are fused and sums are split, where the target gains by it. The last bits may\n   \
         differ from the Rust's. The error, element by element: {}. */\n",
        bound(kernel),
    )
}

#[cfg(test)]
mod tests {
    use super::{bound, factor};
    use bessemer_ir::{Float, Kernel, KernelRoutine};

    #[test]
    fn what_is_said_is_no_less_than_the_bound() {
        for element in [Float::F64, Float::F32] {
            for size in 2..300 {
                let kernel = Kernel::new(KernelRoutine::Solve, element, &[size, 1]).expect("sound");
                let text = bound(&kernel);
                let words = text.split("<= ").nth(1).and_then(|rest| rest.split(' ').next());
                let said: f64 = words.and_then(|word| word.parse().ok()).expect("a number");
                let bound = factor(&kernel);
                assert!((bound..1.11 * bound).contains(&said), "{text}, {bound}");
            }
        }
    }

    #[test]
    fn a_product_rounds_once_for_each_term() {
        let kernel = Kernel::new(KernelRoutine::Product, Float::F64, &[3, 20, 5]).expect("sound");
        assert_eq!(bound(&kernel), "|result - a b| <= 2.3e-15 |a| |b|");
    }
}
