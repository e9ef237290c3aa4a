//! Each packet with each size of its payload: one size is valid, and its order takes effect.

mod recorded;

use bessemer::requirement;
use models::packet::Packet;
use models::receiver::{
    ARM, ASK, ASK_BYTES, CHOOSE, CHOOSE_BYTES, COMMIT, COMMIT_BYTES, DISARM, GOODBYE, HEARTBEAT,
    HELLO, LAND, MODE, MODE_BYTES, POINT, POINT_BYTES, Receiver, Request, SET, SET_BYTES, STICKS,
    STICKS_BYTES, STOP, TAKE_OFF,
};
use models::{Inputs, Onboard, Outputs, Settings};
use recorded::Recorded;

fn packet(kind: u8, sequence: u16, size: usize) -> Packet {
    // A set point by zeros is inside the space; the first two bytes of a commit are a count and a name.
    let payload: [u8; 56] = std::array::from_fn(|n| u8::from(n == 0 && kind == COMMIT));
    Packet::around(kind, sequence, &payload, size)
}

/// The kinds with the sizes of their payloads; take-off is valid once there is a trajectory.
const VALID: [(u8, usize); 15] = [
    (HELLO, 0),
    (POINT, POINT_BYTES),
    (COMMIT, COMMIT_BYTES),
    (TAKE_OFF, 0),
    (MODE, MODE_BYTES),
    (LAND, 0),
    (STICKS, STICKS_BYTES),
    (STOP, 0),
    (HEARTBEAT, 0),
    (ARM, 0),
    (ASK, ASK_BYTES),
    (SET, SET_BYTES),
    (CHOOSE, CHOOSE_BYTES),
    (DISARM, 0),
    (GOODBYE, 0),
];

/// Returns true if the order of a packet is among the orders of this period.
fn took_effect(receiver: &Receiver, kind: u8) -> bool {
    let (orders, wish) = (&receiver.orders, &receiver.wish);
    match kind {
        HELLO => orders.link,
        GOODBYE => !orders.link && !orders.watched,
        TAKE_OFF => orders.take_off,
        LAND => orders.land,
        STOP => orders.stop,
        HEARTBEAT => orders.watched,
        ARM => orders.arm,
        DISARM => orders.disarm,
        ASK => wish.request == Request::Ask,
        SET => wish.request == Request::Set,
        CHOOSE => wish.request == Request::Choose,
        // Modes, points and sticks have values, which other tests compare.
        _ => true,
    }
}

#[test]
#[requirement("HLR-27")]
fn a_packet_is_valid_with_one_size() {
    let space = Settings::mambo().space;
    let mut receiver = Recorded::<Receiver>::default();
    let mut sequence = 0;
    for (kind, right) in VALID.into_iter().chain([(0, 99), (16, 99), (255, 99)]) {
        // The right size last, so that each order finds what the one before it left.
        for size in
            [0, 1, 2, 9, 32, 38, 42, 56].into_iter().filter(|it| *it != right).chain(Some(right))
        {
            sequence += 1;
            let before = receiver.tally;
            receiver.step(0.005, &space, &packet(kind, sequence, size.min(56)));
            let valid = size == right && right < 99;
            let counts = (
                receiver.tally.accepted - before.accepted,
                receiver.tally.invalid - before.invalid,
            );
            assert_eq!(counts, (u32::from(valid), u32::from(!valid)), "kind {kind}, {size} bytes");
            assert!(!valid || took_effect(&receiver, kind), "kind {kind}");
        }
    }
}

/// The software on a bench, which receives packets one after the other; what comes out after each.
fn received(packets: &[(u8, usize)]) -> Vec<Outputs> {
    let (mut onboard, settings) = (Recorded::<Onboard>::default(), Settings::mambo());
    let mut step = |(n, (kind, size)): (usize, &(u8, usize))| {
        let uplink = packet(*kind, n as u16 + 1, *size);
        onboard.step(&settings, &Inputs { time: 5000 * n as u64, uplink, ..Inputs::default() })
    };
    packets.iter().enumerate().map(&mut step).collect()
}

#[test]
fn wishes_reach_the_owner_of_the_settings() {
    let wishes = [(ASK, Request::Ask), (SET, Request::Set), (CHOOSE, Request::Choose)];
    for (kind, request) in wishes {
        let size = VALID.iter().find(|it| it.0 == kind).expect("a kind").1;
        let outputs = received(&[(HELLO, 0), (kind, size)]);
        assert_eq!(outputs.last().expect("two").wish.request, request);
    }
}

#[test]
#[requirement("HLR-33")]
fn without_measurements_no_order_starts_the_motors() {
    let orders = [(HELLO, 0), (ARM, 0), (DISARM, 0), (ARM, 0), (STOP, 0), (ARM, 0), (GOODBYE, 0)];
    for outputs in received(&orders) {
        assert_eq!(outputs.command.motors.amax(), 0.0);
    }
}
