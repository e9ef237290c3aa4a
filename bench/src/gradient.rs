//! Measures the gradient of the cost of a rollout against code that CasADi generates for the same model.

use serde_json::Value;

use crate::peers::{self, Subject};

/// The cost of fifty periods, its gradient by a hundred inputs, and a sine and a cosine.
pub const ROLLOUT: Subject = Subject {
    name: "gradient",
    source: "bench/gradient/cost.rs",
    packages: &[("casadi", "3.8.2")],
    contenders: &["emitted C", "CasADi"],
    parts: &["call"],
    angles: true,
    words: 1 + 100 + 2,
    tolerances: [1e-12, 1e-4],
};

/// Rows of the tables.
const KEYS: [(&str, &str); 3] = [
    ("instructions", "instructions of a gradient"),
    ("sines and cosines", "a sine and a cosine alone"),
    ("text", "code, bytes"),
];

/// Returns the page of a result file.
pub fn markdown(json: &Value) -> String {
    let mut text = String::from(
        "# The gradient of a rollout beside CasADi\n\n\
         The cost of fifty periods of a rotor in a plane (five states, two inputs), and its gradient by the hundred inputs, in executed instructions, by\n\
         gcc `-O2` without contraction, counted under QEMU. Instructions are no cycles: there is no cache and no pipeline. Code is in bytes, with constants,\n\
         without elementary functions. A gradient needs a sine and a cosine in each period.\n\n\
         The emitted C comes from [bench/gradient/cost.rs](../gradient/cost.rs), written as a user writes it; the generator writes the gradient in reverse\n\
         mode. CasADi's code comes from [bench/gradient/peers.py](../gradient/peers.py): the whole rollout without a loop, in reverse mode. Costs and\n\
         gradients after twenty descents are compared before the counts. `cargo xtask bench --only gradient` measures it again, and writes\n\
         [gradient.json](gradient.json) and this page.\n",
    );
    peers::tables(&mut text, &ROLLOUT, json, &KEYS);
    text
}
