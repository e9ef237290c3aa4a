//! Runs of several seeds at once.

use bessemer_campaign::{Campaign, Column, Row, Value, run};
use std::sync::Mutex;

/// Runs of three seeds at once. They panic at once if 13 is among them, and lose a result if 20 is.
#[derive(Default)]
struct Triples {
    /// The seeds of each run of several.
    calls: Mutex<Vec<Vec<u64>>>,
}

impl Campaign for Triples {
    fn kind(&self) -> &str {
        "triples"
    }

    fn version(&self) -> u32 {
        1
    }

    fn models(&self) -> String {
        String::new()
    }

    fn columns(&self) -> Vec<Column> {
        vec![Column::number("double", "m")]
    }

    fn run(&self, seed: u64) -> Result<Vec<Value>, String> {
        assert_ne!(seed, 13, "not this one");
        Ok(vec![(2.0 * seed as f64).into()])
    }

    fn together(&self) -> usize {
        3
    }

    fn run_together(&self, seeds: &[u64]) -> Vec<Result<Vec<Value>, String>> {
        self.calls.lock().expect("no panic while it is locked").push(seeds.to_vec());
        let mut results: Vec<_> = seeds.iter().map(|seed| self.run(*seed)).collect();
        if seeds.contains(&20) {
            results.pop();
        }
        results
    }
}

#[test]
fn seeds_run_at_once_have_the_rows_of_each_alone() {
    let campaign = Triples::default();
    let seeds: Vec<u64> = (10..23).collect();
    let mut rows = Vec::new();
    run(&campaign, &seeds, 0, |row| {
        rows.push(row);
        Ok(())
    })
    .expect("it runs");
    rows.sort_by_key(|row| row.seed);
    let alone: Vec<Row> = seeds.iter().map(|seed| Row::of(&campaign, *seed)).collect();
    assert_eq!(rows, alone);
    // The panic concerns one seed, and the missing result none.
    let failed: Vec<u64> = rows.iter().filter(|it| it.result.is_err()).map(|it| it.seed).collect();
    assert_eq!(failed, [13]);
    let mut calls = campaign.calls.into_inner().expect("no panic while it is locked");
    calls.sort();
    // The last seed is alone.
    assert_eq!(calls, [[10, 11, 12], [13, 14, 15], [16, 17, 18], [19, 20, 21]]);
}
