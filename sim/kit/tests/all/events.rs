//! Events by time: their order, the queue of those that are due, and times that are no numbers.

use bessemer_sim::Events;

fn names<'a>(events: &[(f64, &'a str)]) -> Vec<&'a str> {
    events.iter().map(|(_, name)| *name).collect()
}

/// Every way to add events has one order: by time, and simultaneous ones as they were added.
#[test]
fn events_are_in_order() {
    let all =
        [(2.0, "c"), (-1.0, "a"), (2.0, "d"), (0.0, "b"), (f64::INFINITY, "never"), (2.0, "e")];
    let collected: Events<&str> = all.into_iter().collect();
    let mut added = Events::default();
    all.into_iter().for_each(|(time, name)| added.add(time, name));
    let mut extended: Events<&str> = all.into_iter().take(3).collect();
    extended.extend(all.into_iter().skip(3));
    for events in [&collected, &added, &extended] {
        let order: Vec<_> = events.into_iter().map(|(_, name)| *name).collect();
        assert_eq!(order, ["a", "b", "c", "d", "e", "never"]);
    }
    assert_eq!(collected, added);
    assert_eq!(extended.into_iter().count(), 6);
}

/// An event is due once, at the first time that is not before its own.
#[test]
fn an_event_is_due_once() {
    let events: Events<&str> =
        [(0.3, "b"), (0.1, "a"), (0.3, "c"), (0.30001, "d")].into_iter().collect();
    let mut pending = events.pending();
    let cases: [(f64, &[&str]); 7] = [
        (0.0, &[]),
        (0.1, &["a"]),
        (0.1, &[]),
        (f64::NAN, &[]),
        (0.3, &["b", "c"]),
        (0.2, &[]),
        (9.0, &["d"]),
    ];
    for (time, expected) in cases {
        assert_eq!(names(pending.due(time)), expected, "{time}");
    }
    for (time, expected) in [(0.0, 0), (0.1, 1), (0.3, 3), (1.0, 4), (f64::NAN, 0)] {
        assert_eq!(events.past(time).len(), expected, "{time}");
    }
    // Another queue begins with the first event.
    assert_eq!(names(events.pending().due(0.1)), ["a"]);
}

/// A time that is no number never comes, and delays no other event.
#[test]
fn no_number_is_no_time() {
    let mut events: Events<&str> =
        [(f64::NAN, "never"), (1.0, "b"), (-f64::NAN, "nor"), (f64::NEG_INFINITY, "a")]
            .into_iter()
            .collect();
    events.add(f64::NAN, "neither");
    events.add(2.0, "c");
    let mut pending = events.pending();
    assert_eq!(names(pending.due(f64::NEG_INFINITY)), ["a"]);
    assert_eq!(names(pending.due(f64::MAX)), ["b", "c"]);
    assert_eq!(names(pending.due(f64::INFINITY)), [""; 0]);
}
