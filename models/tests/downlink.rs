//! The logger keeps the newest records, and the sender sends one packet per period.

use bessemer::nalgebra::SVector;
use bessemer::requirement;
use models::logger::{Choice, DEPTH, Logger, SIGNALS, WIDTH};
use models::packet::Packet;
use models::sender::{PARAMETER, RECORD, Reply, STATUS, Sender, Status};

/// Returns a logger after this number of periods.
fn logged(choice: &Choice, periods: u32) -> Logger {
    let mut logger = Logger::default();
    for _ in 0..periods {
        logger.step(choice, &SVector::from_fn(|n, _| n as f64));
    }
    logger
}

#[test]
#[requirement("HLR-40")]
fn the_usual_choice_records_the_first_signals_at_20_hz() {
    let mut logger = logged(&Choice::usual(), 100);
    let periods: Vec<u32> =
        std::iter::from_fn(|| logger.has_one().then(|| logger.take().period)).collect();
    // A period takes 5 ms.
    assert_eq!(periods, (0..10).map(|n| 10 * n).collect::<Vec<_>>());
    let record = logged(&Choice::usual(), 1).take();
    assert_eq!((WIDTH, SIGNALS), (36, 64));
    assert!((0..WIDTH).all(|n| record.values[n] == n as f64), "{record:?}");
}

#[test]
#[requirement("HLR-40")]
fn a_full_ring_loses_its_oldest_records_and_counts_them() {
    let mut logger = logged(&Choice { every: 1, ..Choice::usual() }, 20);
    assert_eq!((DEPTH, logger.count, logger.lost), (16, 16, 4));
    assert_eq!([logger.take().period, logger.take().period], [4, 5]);
}

#[test]
#[requirement("HLR-40")]
fn the_state_of_the_link_is_sent_each_half_second() {
    let (mut sender, mut logger) = (Sender::default(), Logger::default());
    let mut kinds = Vec::new();
    for n in 0..400 {
        logger.step(&Choice::usual(), &SVector::zeros());
        let reply = Reply { wanted: n == 350, number: 3, value: 0.5 };
        let packet: Packet = sender.step(&mut logger, &Status::default(), &reply);
        assert!(packet.length == 0 || packet.is_sound(), "{n}");
        kinds.push(if packet.length == 0 { 0 } else { packet.kind() });
    }
    let of = |kind: u8| kinds.iter().zip(1..).filter(move |it| *it.0 == kind).map(|it| it.1);
    assert_eq!(of(STATUS).collect::<Vec<_>>(), [100, 200, 300, 400]);
    assert_eq!(of(PARAMETER).collect::<Vec<_>>(), [351]);
    // Three packets of each record.
    assert_eq!(of(RECORD).count(), 3 * 400 / 10);
}
