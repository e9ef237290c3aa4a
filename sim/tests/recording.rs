//! Flights as files: what is written can be read back, and what is not ours is told.

use std::collections::BTreeMap;

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
    let text = csv(&voyage);
    let mut lines = text.lines();
    let columns = lines.next().expect("a header").split(',').count();
    assert_eq!(lines.clone().count(), voyage.moments.len());
    assert!(lines.all(|line| line.split(',').count() == columns));
}

#[test]
fn every_figure_can_be_drawn() {
    let voyage = short();
    for flight in sim::flights::FLIGHTS {
        for figure in flight.figures {
            let text = figure.draw(flight.name, &voyage).expect("a picture");
            assert!(text.contains(figure.title) && text.ends_with("</svg>\n"), "{}", figure.file);
        }
    }
}
