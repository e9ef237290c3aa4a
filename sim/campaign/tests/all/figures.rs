//! Figures of a campaign: bounds against values of other programs, the summary's forms, rare failures.

use bessemer_campaign::rare::{Effort, Rare, estimate};
use bessemer_campaign::{Campaign, Column, Rate, Replay, Row, Summary, Table, Value, Worst};

/// Bounds of SciPy's `binomtest(k, n).proportion_ci(0.95, "exact")`.
#[test]
fn bounds_are_those_of_clopper_and_pearson() {
    for (events, runs, low, high) in BOUNDS {
        let rate = Rate::of(events, runs);
        assert!((rate.low - low).abs() <= 1e-9 + 1e-6 * low, "{rate:?}, not {low}");
        assert!((rate.high - high).abs() <= 1e-9 + 1e-6 * high, "{rate:?}, not {high}");
    }
    let nothing = Rate::of(0, 0);
    assert_eq!((nothing.low, nothing.high), (0.0, 1.0));
}

const BOUNDS: [(u64, u64, f64, f64); 6] = [
    (0, 10, 0.0, 0.308_497_107_8),
    (5, 100, 0.016_431_879_18, 0.112_834_911_1),
    (1, 1000, 2.531_748_749e-5, 0.005_558_924_28),
    (10, 10, 0.691_502_892_2, 1.0),
    (37, 5000, 0.005_215_479_853, 0.010_185_633_83),
    (3, 1_000_000, 6.186_725_999e-7, 8.767_247_806e-6),
];

/// A sum of normal numbers that must stay below a bound: the probability is known.
struct Sum {
    bound: f64,
}

impl Campaign for Sum {
    fn kind(&self) -> &str {
        "sum"
    }

    fn version(&self) -> u32 {
        1
    }

    fn models(&self) -> String {
        String::new()
    }

    fn columns(&self) -> Vec<Column> {
        vec![
            Column::number("sum", "m").about("sum <of> all").worst(Worst::Largest),
            Column::text("sign"),
        ]
    }

    fn run(&self, seed: u64) -> Result<Vec<Value>, String> {
        let sum = (seed as f64) - 50.0;
        Ok(vec![sum.into(), if sum < 0.0 { "minus" } else { "plus" }.into()])
    }

    fn fault(&self, row: &[Value]) -> Option<String> {
        matches!(row, [Value::Number(sum), ..] if *sum >= 45.0).then(|| "too large".to_owned())
    }

    fn replay(&self, seed: u64) -> Replay {
        Replay {
            command: format!("show --seed {seed}"),
            link: format!("http://127.0.0.1/?a&seed={seed}"),
        }
    }

    fn rare(&self) -> Option<&dyn Rare> {
        Some(self)
    }
}

impl Rare for Sum {
    fn dimensions(&self) -> usize {
        2
    }

    fn severity(&self, normals: &[f64]) -> f64 {
        normals.iter().sum::<f64>() / 2.0_f64.sqrt() - self.bound
    }
}

#[test]
fn a_summary_names_faults_bounds_and_the_worst_seeds() {
    let campaign = Sum { bound: 0.0 };
    let mut table = Table::default();
    for seed in 0..100 {
        table.rows.insert(seed, Row::of(&campaign, seed));
    }
    let summary = Summary::of(&campaign, &table).expect("names are in order");
    let figures = &summary.columns[0];
    assert_eq!((figures.least, figures.median, figures.most), (Some(-50.0), Some(0.0), Some(49.0)));
    assert_eq!(
        figures.worst.iter().map(|it| it.seed).collect::<Vec<_>>(),
        (92..100).rev().collect::<Vec<_>>()
    );
    assert_eq!(summary.columns[1].counts, [("minus".to_owned(), 50), ("plus".to_owned(), 50)]);
    assert_eq!(summary.bad, Rate::of(5, 100));
    let text = summary.text();
    assert!(text.contains("| sum <of> all, m | -50 | 0 | 39 | 48 | 49 |"), "{text}");
    assert!(
        text.contains("5 of 100 (1.643 to 11.28 % with 95 % confidence): too large: seeds 95, 96"),
        "{text}"
    );
    let page = summary.page();
    for part in [
        "<h2>sum &lt;of&gt; all, m</h2>",
        "<svg",
        "<a href=\"http://127.0.0.1/?a&amp;seed=99\">99</a> <code>show --seed 99</code>",
        "too large",
    ] {
        assert!(page.contains(part), "{part}: {page}");
    }
    let json = serde_json::to_value(&summary).expect("JSON");
    assert_eq!(json["faults"][0]["rate"]["events"], 5);
    assert_eq!(json["columns"][0]["worst"][0]["seed"], 99);
}

/// Both ways estimate the probability that is known: 3.17·10⁻⁵ beyond 4 standard deviations, 2.28·10⁻² beyond 2.
#[test]
fn splitting_agrees_with_plain_sampling_and_with_what_is_known() {
    let effort = Effort { level: 300, ..Effort::default() };
    for (bound, known) in [(2.0, 2.275e-2), (4.0, 3.167e-5)] {
        let found = estimate(&Sum { bound }, effort).expect("an estimate");
        assert!((found.probability - known).abs() < 4.0 * found.error, "{found:?}, not {known}");
        assert!(found.error < 0.4 * known, "{found:?}");
        assert!(found.severity >= 0.0 && Sum { bound }.severity(&found.worst) == found.severity);
        if bound == 4.0 {
            // Plain sampling has an error of 140 % of the probability with as many runs.
            assert!(found.runs < 18_000, "{found:?}");
        }
    }
    // Plain sampling of the frequent failure, by the first level alone.
    let plain = Effort { levels: 1, level: 2000, ..effort };
    let plain = estimate(&Sum { bound: 2.0 }, plain).expect("an estimate");
    let split = estimate(&Sum { bound: 2.0 }, effort).expect("an estimate");
    let spread = plain.error.hypot(split.error);
    assert!((plain.probability - split.probability).abs() < 4.0 * spread, "{plain:?} {split:?}");
    assert_eq!(
        estimate(&Sum { bound: 2.0 }, effort).expect("an estimate"),
        split,
        "equal each time"
    );
}

#[test]
fn what_cannot_be_estimated_is_refused() {
    struct Plain;
    impl Campaign for Plain {
        fn kind(&self) -> &str {
            "plain"
        }
        fn version(&self) -> u32 {
            1
        }
        fn models(&self) -> String {
            String::new()
        }
        fn columns(&self) -> Vec<Column> {
            Vec::new()
        }
        fn run(&self, _: u64) -> Result<Vec<Value>, String> {
            Ok(Vec::new())
        }
    }
    let message = estimate(&Plain, Effort::default()).expect_err("no severity").to_string();
    assert!(message.contains("implement `Rare`"), "{message}");
    for level in [0, 7, 10, 1001] {
        assert!(
            estimate(&Sum { bound: 1.0 }, Effort { level, ..Effort::default() }).is_err(),
            "{level}"
        );
    }
}
