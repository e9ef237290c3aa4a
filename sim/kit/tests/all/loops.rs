//! Loops: the order of simultaneous things, rates, noise by seed, faults, files and errors.

use std::cell::RefCell;
use std::rc::Rc;

use bessemer_sim::*;

/// An integrator of its command.
#[derive(Debug)]
pub struct Tank;

impl Plant<1> for Tank {
    type Command = f64;
    type Disturbance = f64;

    fn derivative(&self, _: f64, _: &State<1>, input: &Input<f64, f64>) -> State<1> {
        State::from([input.command + input.disturbance])
    }
}

pub fn level(name: &str, period: u32, quality: Quality) -> Channel<Tank, 1> {
    let signal = Signal::new(name, "m", |view: &View<Tank, 1>| view.state[0]);
    Channel { signal, period: Period::ticks(period).expect("a period"), quality }
}

pub fn setup<const S: usize>(sensors: [Channel<Tank, 1>; S]) -> Setup<Tank, 1, S> {
    Setup {
        plant: Tank,
        start: State::from([0.0]),
        command: 0.0,
        sensors,
        probes: vec![Signal::new("flow", "m/s", |view: &View<Tank, 1>| view.input.command)],
        tick: Tick::nanoseconds(1_000_000).expect("a tick"),
        control: Period::ticks(4).expect("a period"),
        record: Period::ticks(6).expect("a period"),
        solver: Solver::RungeKutta { step: 1e-3 },
    }
}

pub fn scenario(duration: f64) -> Scenario<f64, f64> {
    Scenario {
        duration,
        goals: Timeline::constant(1.0),
        disturbances: Timeline::constant(0.0),
        faults: Vec::new(),
        seed: 7,
    }
}

fn idle<const S: usize>() -> impl FnMut(&[Reading; S], &f64) -> f64 {
    |_, goal| *goal
}

pub fn run<const S: usize>(setup: Setup<Tank, 1, S>, scenario: &Scenario<f64, f64>) -> Recording {
    setup.run(scenario, &mut idle()).expect("it runs").recording
}

/// Readings come before the step, the step before the probes, and each at its own rate.
#[test]
fn simultaneous_things_have_an_order() {
    let steps = Rc::new(RefCell::new(Vec::new()));
    let seen = Rc::clone(&steps);
    let mut computer = move |readings: &[Reading; 2], goal: &f64| {
        seen.borrow_mut().push((readings[0], readings[1], *goal));
        *goal
    };
    let mut scenario = scenario(0.012);
    scenario.goals = Timeline::new(1.0, vec![(0.008, 2.0)]).expect("in order");
    scenario.disturbances = Timeline::new(0.0, vec![(0.0105, 100.0)]).expect("in order");
    let setup = setup([level("fast", 1, Quality::default()), level("slow", 8, Quality::default())]);
    let outcome = setup.run(&scenario, &mut computer).expect("it runs");
    let steps = steps.borrow();
    let values: Vec<_> = steps.iter().map(|step| (step.0.value, step.1.value, step.2)).collect();
    // The disturbance is in effect from the tick at 11 ms on: 1 ms · 100 m/s.
    let near = |a: f64, b: f64| (a - b).abs() < 1e-15;
    let expected = [(0.0, 0.0, 1.0), (0.004, 0.0, 1.0), (0.008, 0.008, 2.0), (0.116, 0.008, 2.0)];
    assert_eq!(values.len(), expected.len());
    for (value, expected) in values.iter().zip(expected) {
        assert!(near(value.0, expected.0) && near(value.1, expected.1), "{values:?}");
        assert_eq!(value.2, expected.2);
    }
    assert_eq!(
        steps.iter().map(|it| it.1.is_fresh).collect::<Vec<_>>(),
        [true, false, true, false]
    );
    let flow = outcome.recording.channel("flow").expect("it is recorded");
    assert_eq!(
        (flow.times(), flow.values()),
        (&[0, 6_000_000, 12_000_000][..], &[1.0, 1.0, 2.0][..])
    );
}

/// A second sensor, before or behind, changes no bit of the first.
#[test]
fn noise_is_by_seed_and_name() {
    let quality = Quality { noise: 1.0, walk: 0.1, dropout: 0.2, ..Quality::default() };
    let noisy = |name: &str| level(name, 1, quality);
    let recorded = |recording: &Recording, name: &str| recording.channel(name).expect("it").clone();
    let alone = recorded(&run(setup([noisy("a")]), &scenario(1.0)), "a");
    let both = run(setup([noisy("b"), noisy("a")]), &scenario(1.0));
    assert_eq!(recorded(&both, "a"), alone);
    assert_ne!(recorded(&both, "b").values(), alone.values());
    let other = Scenario { seed: 8, ..scenario(1.0) };
    assert_ne!(recorded(&run(setup([noisy("a")]), &other), "a").values(), alone.values());
}

/// Mean, variance and lost readings of 100 000 samples, within five standard deviations of each figure.
#[test]
fn noise_is_normal_and_losses_are_rare() {
    let count = 100_000_u32;
    let mut chance = Chance::new(3, "gyroscope");
    let (mut sum, mut squares, mut fourths, mut lost) = (0.0, 0.0, 0.0, 0);
    for sample in 0..u64::from(count) {
        let ([one, other], uniform) = chance.normal(sample);
        for value in [one, other] {
            sum += value;
            squares += value * value;
            fourths += value.powi(4);
        }
        lost += u32::from(uniform < 0.1);
    }
    let n = 2.0 * f64::from(count);
    assert!((sum / n).abs() < 5.0 / n.sqrt());
    assert!((squares / n - 1.0).abs() < 5.0 * (2.0 / n).sqrt());
    assert!((fourths / n - 3.0).abs() < 5.0 * (96.0 / n).sqrt());
    assert!(
        (f64::from(lost) / f64::from(count) - 0.1).abs() < 5.0 * (0.09 / f64::from(count)).sqrt()
    );
    // The bits are those of every machine.
    let (normal, uniform) = Chance::new(1, "a").normal(5);
    assert_eq!(
        [normal[0], normal[1], uniform].map(f64::to_bits),
        [13_823_043_049_161_272_563, 13_825_512_185_665_718_388, 4_584_926_455_373_456_592]
    );
}

/// A walk of 1 unit/√s has the variance t: over 200 channels at 1 s, within five standard deviations.
#[test]
fn a_bias_walks() {
    let quality = Quality { walk: 1.0, bias: 2.0, ..Quality::default() };
    let mut squares = 0.0;
    for seed in 0..200 {
        let mut scenario = Scenario { seed, ..scenario(1.0) };
        scenario.goals = Timeline::constant(0.0);
        let recording = run(setup([level("a", 10, quality)]), &scenario);
        let end = recording.channel("a").expect("it is recorded").last().expect("a sample");
        squares += (end - 2.0).powi(2);
    }
    assert!((squares / 200.0 - 1.0).abs() < 5.0 * (2.0_f64 / 200.0).sqrt());
}

#[test]
fn faults_come_and_go() {
    let fault = |from, until, kind| Fault { sensor: "a".to_owned(), from, until, kind };
    let mut scenario = scenario(0.008);
    scenario.faults = vec![
        fault(0.002, 0.004, FaultKind::Stuck),
        fault(0.005, 0.006, FaultKind::Silent),
        fault(0.007, f64::INFINITY, FaultKind::Offset(1.0)),
    ];
    let quality = Quality { resolution: 0.0005, ..Quality::default() };
    let recording = run(setup([level("a", 1, quality)]), &scenario);
    let values = recording.channel("a").expect("it is recorded").values();
    let expected = [0.0, 0.001, 0.001, 0.001, 0.004, 0.006, 1.007, 1.008];
    assert_eq!(values.len(), expected.len());
    assert!(values.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{values:?}");
}

#[test]
fn tables_have_each_number() {
    let recording = run(setup([level("a", 4, Quality::default())]), &scenario(0.008));
    let csv = recording.csv();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "time [s],a [m],flow [m/s]");
    assert_eq!(lines[1], "0.000000000,0,1");
    assert!(lines[2].starts_with("0.004000000,0.00") && lines[2].ends_with(','), "{csv}");
    assert_eq!((lines[3], lines.len()), ("0.006000000,,1", 5));
    let a: f64 = lines[4].split(',').nth(1).and_then(|it| it.parse().ok()).expect("a number");
    assert_eq!(Some(a), recording.channel("a").expect("it is recorded").last());
}

/// A loop of one's own records, too; times in s count from behind the lead.
#[test]
fn a_recording_may_be_ones_own() {
    let mut recording = Recording::new(0.25).expect("a lead");
    let channels = ["a", "b"].map(|name| recording.add(name, "1").expect("a channel"));
    for (channel, time, value) in [(0, 0, 1.0), (1, 0, 2.0), (1, 250_000_000, f64::NAN)] {
        recording.sample(channels[channel], time, value).expect("it is in order");
    }
    recording.sample(channels[0], 500_000_000, -1.5).expect("it is in order");
    let csv = "time [s],a [1],b [1]\n-0.250000000,1,2\n0.000000000,,NaN\n0.250000000,-1.5,\n";
    assert_eq!(recording.csv(), csv);
    let a = recording.channel("a").expect("it is recorded");
    assert_eq!((a.between(-0.25, 0.0), a.between(0.1, 0.25)), (&[1.0][..], &[-1.5][..]));
    let errors = [
        (recording.add("a", "1").expect_err("refused"), "two channels have the name `a`"),
        (recording.add("c", "").expect_err("refused"), "`` cannot name a channel or a unit"),
        (
            recording.sample(0, 500_000_000, 0.0).expect_err("refused"),
            "the sample of `a` at 0.25 s",
        ),
        (recording.sample(2, 0, 0.0).expect_err("refused"), "no channel has the name `2`"),
        (Recording::new(f64::NAN).expect_err("refused"), "`lead` is NaN"),
    ];
    for (error, expected) in errors {
        let error = error.to_string();
        assert!(error.starts_with(expected) && error.contains(';'), "{error}");
    }
}

#[test]
fn logs_have_each_number() {
    let recording = run(setup([level("a", 4, Quality::default())]), &scenario(0.008));
    let bytes = recording.mcap().expect("it is written");
    let messages =
        mcap::MessageStream::new(&bytes).expect("a log").map(|it| it.expect("a message"));
    let all: Vec<_> = messages
        .map(|it| {
            (it.channel.topic.clone(), it.log_time, String::from_utf8_lossy(&it.data).into_owned())
        })
        .collect();
    let value = |channel: &str| recording.channel(channel).expect("it is recorded").values();
    let expected = [
        ("/a", 0, 0),
        ("/flow", 0, 0),
        ("/a", 4_000_000, 1),
        ("/flow", 6_000_000, 1),
        ("/a", 8_000_000, 2),
    ];
    let expected = expected.map(|(topic, time, index)| {
        (topic.to_owned(), time, format!("{{\"value\":{}}}", value(&topic[1..])[index]))
    });
    assert_eq!(all, expected);
}

/// The file has the bits of each number, and the units.
#[cfg(feature = "parquet")]
#[test]
fn parquet_has_each_number() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    let setup = |name: &str| setup([level(name, 4, Quality { noise: 1.0, ..Quality::default() })]);
    let recording = run(setup("a"), &scenario(0.008));
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("loop.parquet");
    std::fs::write(&path, recording.parquet().expect("it is written")).expect("a file");
    let file = SerializedFileReader::new(std::fs::File::open(path).expect("it")).expect("a file");
    let metadata = file.metadata().file_metadata().key_value_metadata().expect("units").clone();
    let units: Vec<_> = metadata.iter().map(|it| (it.key.as_str(), it.value.as_deref())).collect();
    assert_eq!(units[..2], [("unit.a", Some("m")), ("unit.flow", Some("m/s"))]);
    let rows = file.get_row_iter(None).expect("rows");
    let rows: Vec<Vec<Field>> = rows
        .map(|row| row.expect("a row").into_columns().into_iter().map(|it| it.1).collect())
        .collect();
    let number = |channel: &str, index: usize| {
        Field::Double(recording.channel(channel).expect("it is recorded").values()[index])
    };
    let expected = [
        vec![Field::Long(0), number("a", 0), number("flow", 0)],
        vec![Field::Long(4_000_000), number("a", 1), Field::Null],
        vec![Field::Long(6_000_000), Field::Null, number("flow", 1)],
        vec![Field::Long(8_000_000), number("a", 2), Field::Null],
    ];
    assert_eq!(rows, expected);
    let twice = run(setup("time_ns"), &scenario(0.008)).parquet().expect_err("it is refused");
    assert!(matches!(twice, Error::Twice { .. }), "{twice}");
}

#[test]
fn pictures_have_each_curve() {
    let recording = run(setup([level("a", 1, Quality::default())]), &scenario(1.0));
    let picture = recording.svg(&[&["a"], &["flow"]]).expect("it is drawn");
    assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"));
    assert!(picture.matches("<polyline").count() >= 2);
    assert!(picture.contains("flow") && picture.contains("time, s"));
    assert!(matches!(recording.svg(&[&["b"]]), Err(Error::Unknown { .. })));
}

/// Each mistake is an error with a remedy.
#[test]
fn mistakes_are_errors() {
    let ideal = || level("a", 1, Quality::default());
    let said = |setup: Setup<Tank, 1, 1>, scenario: &Scenario<f64, f64>| {
        setup.run(scenario, &mut idle()).expect_err("it is refused").to_string()
    };
    let fault = |sensor: &str, until| Fault {
        sensor: sensor.to_owned(),
        from: 0.1,
        until,
        kind: FaultKind::Silent,
    };
    let with = |fault| Scenario { faults: vec![fault], ..scenario(1.0) };
    let quality = |quality| setup([level("a", 1, quality)]);
    let errors = [
        (Tick::nanoseconds(0).expect_err("refused").to_string(), "the tick is 0 ns"),
        (Period::ticks(0).expect_err("refused").to_string(), "a period has 0 ticks"),
        (
            Timeline::new(0, vec![(1.0, 1), (1.0, 2)]).expect_err("refused").to_string(),
            "the change at 1 s is not after",
        ),
        (
            Timeline::new(0, vec![(f64::NAN, 1)]).expect_err("refused").to_string(),
            "`time of a change` is NaN",
        ),
        (said(setup([ideal()]), &scenario(-1.0)), "`duration` is -1"),
        (said(setup([ideal()]), &scenario(1e10)), "`duration` is 10000000000"),
        (
            said(setup([level("flow", 1, Quality::default())]), &scenario(1.0)),
            "two channels have the name `flow`",
        ),
        (said(setup([level("a,b", 1, Quality::default())]), &scenario(1.0)), "`a,b` cannot name"),
        (
            said(setup([ideal()]), &with(fault("b", 1.0))),
            "no channel has the name `b`; the channels are a",
        ),
        (said(setup([ideal()]), &with(fault("a", 0.1))), "the interval from 0.1 s to 0.1 s"),
        (
            said(quality(Quality { noise: -1.0, ..Quality::default() }), &scenario(1.0)),
            "`noise of a` is -1",
        ),
        (
            said(quality(Quality { dropout: 1.5, ..Quality::default() }), &scenario(1.0)),
            "`dropout of a` is 1.5",
        ),
        (
            said(quality(Quality { outliers: -0.1, ..Quality::default() }), &scenario(1.0)),
            "`outliers of a` is -0.1",
        ),
        (
            said(
                quality(Quality { limits: Some((2.0, 1.0)), ..Quality::default() }),
                &scenario(1.0),
            ),
            "`limits of a` is 1; write a number that is at least the lower limit",
        ),
        (
            said(Setup { start: State::from([f64::NAN]), ..setup([ideal()]) }, &scenario(1.0)),
            "state 0 or its derivative is not finite at 0 s",
        ),
    ];
    for (error, expected) in errors {
        assert!(error.starts_with(expected) && error.contains(';'), "{error}");
    }
}

/// An input that jumps lets an event occur at the tick of the jump, once.
#[test]
fn a_jump_of_an_input_is_an_event() {
    struct Fuse {
        is_blown: bool,
    }
    impl Plant<1> for Fuse {
        type Command = f64;
        type Disturbance = f64;
        fn derivative(&self, _: f64, _: &State<1>, _: &Input<f64, f64>) -> State<1> {
            State::from([if self.is_blown { 0.0 } else { 1.0 }])
        }
        fn events(&self) -> usize {
            1
        }
        fn crossing(&self, _: usize, _: f64, _: &State<1>, input: &Input<f64, f64>) -> f64 {
            1.0 - input.disturbance
        }
        fn handle(&mut self, _: usize, _: f64, _: &mut State<1>) {
            self.is_blown = true;
        }
    }
    let setup = Setup {
        plant: Fuse { is_blown: false },
        start: State::from([0.0]),
        command: 0.0,
        sensors: [],
        probes: Vec::new(),
        tick: Tick::nanoseconds(1_000_000).expect("a tick"),
        control: Period::ticks(100).expect("a period"),
        record: Period::ticks(100).expect("a period"),
        solver: Solver::DormandPrince(Tolerances::default()),
    };
    let disturbances = Timeline::new(0.0, vec![(0.3, 2.0), (0.6, 3.0)]).expect("in order");
    let scenario = Scenario { disturbances, ..scenario(1.0) };
    let outcome = setup.run(&scenario, &mut idle()).expect("it runs");
    assert_eq!(outcome.events, [Occurrence { time: 0.3, event: 0 }]);
    assert!(outcome.plant.is_blown && (outcome.state[0] - 0.3).abs() < 1e-12);
}

#[test]
fn a_computer_may_fail() {
    struct Dead;
    impl Computer<1, f64, f64> for Dead {
        fn step(&mut self, _: &[Reading; 1], _: &f64) -> Result<f64, Failure> {
            Err("the process ended".into())
        }
    }
    let setup = setup([level("a", 1, Quality::default())]);
    let error = setup.run(&scenario(1.0), &mut Dead).expect_err("it fails");
    assert_eq!(error.to_string(), "the computer failed at 0 s: the process ended");
}
