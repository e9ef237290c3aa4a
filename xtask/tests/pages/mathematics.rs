//! Accuracies in the doc comments of the elementary functions, and so in the headers of the C, equal the measurements.

use serde_json::Value;

use super::shared::{none, root};

const SAID: &str = "measured within ";

#[test]
fn the_functions_say_the_accuracy_that_was_measured() {
    let result = std::fs::read_to_string(root().join("bench/results/accuracy.json"));
    let result: Value = serde_json::from_str(&result.expect("committed")).expect("a result file");
    let mut offences = Vec::new();
    let mut count = 0;
    for measured in result["functions"].as_array().expect("a list") {
        let function = measured["function"].as_str().expect("a name");
        for (format, end) in [("f64", ""), ("f32", "f")] {
            let most = measured[format]["ulp"].as_f64().expect("a number");
            match said(&format!("{function}{end}"), end == "f") {
                Some(bound) if (0.0..0.01).contains(&(bound - most)) => count += 1,
                bound => offences.push(format!("{function}{end}: {bound:?}, {most} measured")),
            }
        }
    }
    none("a function's doc comment says `measured within …`, its worst ulp rounded up", &offences);
    assert!(count > 30, "{count}");
}

/// The bound that the doc comment of a function gives.
fn said(function: &str, single: bool) -> Option<f64> {
    let files = std::fs::read_dir(root().join("dsl/src/math")).expect("in the repository");
    for file in files.flatten() {
        let is_single = file.file_name() == "single.rs";
        let text = std::fs::read_to_string(file.path()).unwrap_or_default();
        let Some(at) = text.find(&format!("pub fn {function}(")).filter(|_| is_single == single)
        else {
            continue;
        };
        let (_, docs) = text[..at].rsplit_once("\n\n")?;
        let docs = docs.replace("\n///", "");
        let (_, bound) = docs.split_once(SAID)?;
        return bound.split(' ').next()?.parse().ok();
    }
    None
}
