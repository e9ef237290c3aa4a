//! Flights as files: what is written can be read back, and what is not ours is reported.

use std::collections::BTreeMap;

use serde_json::Value;
use sim::computer::Native;
use sim::flights::find;
use sim::recording::{Error, Log, csv, mcap};
use sim::scenario::Scenario;
use sim::voyage::{Voyage, fly};

fn short() -> Voyage {
    let scenario = (find("hover").expect("a flight").scenario)(1);
    fly(&Scenario { duration: 3.0, ..scenario }, &mut Native::default())
}

#[test]
fn mcap_reads_back_as_it_was_flown() {
    let voyage = short();
    let about = BTreeMap::from([("flight".to_owned(), "hover".to_owned())]);
    let bytes = mcap(&voyage, &about).expect("it is written");
    let log = Log::of(&bytes, "test".into()).expect("it is read");
    assert_eq!(log.about, about);
    let heights = log.column("truth.z").expect("a signal");
    let flown: Vec<f64> = voyage.moments.iter().map(|moment| moment.state.position.z).collect();
    assert!(heights == flown, "to the last bit");
    assert!(matches!(log.column("truth.w"), Err(Error::Lacks { .. })));
}

/// A message's `time`, its log time and the stamp of a pose count from the first period.
#[test]
fn every_time_in_mcap_has_one_origin() {
    let bytes = mcap(&short(), &BTreeMap::new()).expect("it is written");
    let mut poses = 0;
    for message in mcap::MessageStream::new(&bytes).expect("it is read") {
        let message = message.expect("it is whole");
        let value: Value = serde_json::from_slice(&message.data).expect("it is JSON");
        let stamp = &value["timestamp"];
        let seconds = match (&value["time"], stamp["sec"].as_f64(), stamp["nsec"].as_f64()) {
            (_, Some(whole), Some(part)) => whole + 1e-9 * part,
            (time, ..) => time.as_f64().expect("it says when"),
        };
        assert_eq!((1e9 * seconds).round() as u64, message.log_time, "{}", message.channel.topic);
        poses += usize::from(!stamp.is_null());
    }
    assert_eq!(poses, 2 * short().moments.len(), "the true one and the estimate");
}

#[test]
fn mcap_is_compressed_and_says_what_phases_and_alarms_are_called() {
    let voyage = short();
    let bytes = mcap(&voyage, &BTreeMap::new()).expect("it is written");
    let summary = mcap::Summary::read(&bytes).expect("it is read").expect("it has one");
    assert!(summary.chunk_indexes.iter().all(|chunk| chunk.compression == "lz4"));
    let named = |schema: &str, signal: &str, number: u64| {
        let found = summary.schemas.values().find(|it| it.name == schema).expect("a schema");
        let value: Value = serde_json::from_slice(&found.data).expect("it is JSON");
        let names = value["properties"][signal]["oneOf"].as_array().expect("names").clone();
        names.into_iter().find(|it| it["const"] == number).expect("a name")["title"].clone()
    };
    assert_eq!(named("reference", "phase", models::Phase::Hold as u64), "Hold");
    assert_eq!(named("reference", "alarm", models::Alarm::Impact as u64), "Impact");
}

#[test]
fn a_cut_off_file_and_another_file_are_told() {
    let bytes = mcap(&short(), &BTreeMap::new()).expect("it is written");
    for broken in [&bytes[..bytes.len() / 2], b"no such thing".as_slice(), &[]] {
        let error = Log::of(broken, "broken.mcap".into()).expect_err("it is broken");
        assert!(error.to_string().contains("broken.mcap"), "{error}");
    }
}

#[test]
fn csv_has_a_line_for_each_period() {
    let voyage = short();
    let text = csv(&voyage).expect("it is written");
    let mut lines = text.lines();
    let columns = lines.next().expect("a header").split(',').count();
    assert_eq!(lines.clone().count(), voyage.moments.len());
    assert!(lines.clone().all(|line| line.split(',').count() == columns));
    assert!(lines.next().is_some_and(|line| line.starts_with("-1.000000000,")), "before take-off");
}

#[test]
fn every_figure_can_be_drawn() {
    let voyage = short();
    for flight in sim::flights::FLIGHTS {
        for figure in flight.figures {
            let text = figure.draw(flight.name, &voyage).expect("a picture");
            assert!(text.contains(figure.title) && text.ends_with("</svg>\n"), "{}", figure.file);
            assert!(!text.lines().any(|line| is_minus_zero(line.trim())), "{}", figure.file);
        }
    }
}

/// Returns true if a label is a negative zero.
fn is_minus_zero(label: &str) -> bool {
    label.strip_prefix('-').is_some_and(|rest| rest.parse() == Ok(0.0))
}
