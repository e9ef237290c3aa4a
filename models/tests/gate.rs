//! SipHash-2-4 against its paper and against another implementation, and what the gate keeps out.

mod recorded;

use bessemer::requirement;
use models::gate::{Gate, Refused, SEAL_BYTES};
use models::packet::{CHECKSUM_START, HEADER_BYTES, Packet};
use models::receiver::{LAND, MODE, POINT, STOP};
use models::siphash::{Key, sip_hash};
use recorded::Recorded;
use siphasher::sip::SipHasher24;

fn key() -> Key {
    let half = |from: u8| u64::from_le_bytes(std::array::from_fn(|n| from + n as u8));
    Key { is_set: true, halves: [half(0), half(8)] }
}

fn bytes_of(key: &Key) -> [u8; 16] {
    std::array::from_fn(|n| (key.halves[n / 8] >> (8 * (n % 8))) as u8)
}

#[test]
#[requirement("HLR-29")]
fn the_papers_vector_comes_out() {
    // Appendix A: the key 00 01 … 0f, the message 00 01 … 0e.
    let message: [u8; 64] = std::array::from_fn(|n| n as u8);
    assert_eq!(sip_hash(&key(), &message, 0, 15), 0xA129_CA61_49BE_45E5);
}

#[test]
#[requirement("HLR-29")]
fn the_reference_vectors_come_out() {
    // The first of the authors' `vectors.h`: messages 00 01 … of 0, 1, 2 … bytes.
    let expected = [
        0x726F_DB47_DD0E_0E31,
        0x74F8_39C5_93DC_67FD,
        0x0D6C_8009_D9A9_4F5A,
        0x8567_6696_D7FB_7E2D,
        0xCF27_94E0_2771_87B7,
        0x1876_5564_CD99_A68D,
        0xCBC9_466E_58FE_E3CE,
        0xAB02_00F5_8B01_D137,
        0x93F5_F579_9A93_2462,
    ];
    let message: [u8; 64] = std::array::from_fn(|n| n as u8);
    for (length, expected) in expected.into_iter().enumerate() {
        assert_eq!(sip_hash(&key(), &message, 0, length), expected, "{length} bytes");
    }
}

#[test]
#[requirement("HLR-29")]
fn every_length_and_place_is_as_in_another_implementation() {
    let message: [u8; 64] = std::array::from_fn(|n| (n * n * 7 + 13) as u8);
    for halves in [[0, 0], [u64::MAX, 1], key().halves] {
        let key = Key { is_set: true, halves };
        let other = SipHasher24::new_with_key(&bytes_of(&key));
        for from in [0, 2, 7] {
            for end in from..=64 {
                let expected = other.hash(&message[from..end]);
                assert_eq!(sip_hash(&key, &message, from, end), expected, "{from}..{end}");
            }
        }
    }
}

/// A packet with a seal.
fn sealed(key: &Key, kind: u8, sequence: u16, payload: &[u8], counter: u64) -> Packet {
    let size = payload.len();
    let mut bytes = [0; 56];
    bytes[..size].copy_from_slice(payload);
    bytes[size..size + 6].copy_from_slice(&counter.to_le_bytes()[..6]);
    let unsummed = Packet::around(kind, sequence, &bytes, size + 14);
    let sum = sip_hash(key, &unsummed.bytes, CHECKSUM_START, HEADER_BYTES + size + 6);
    bytes[size + 6..size + 14].copy_from_slice(&sum.to_le_bytes());
    Packet::around(kind, sequence, &bytes, size + 14)
}

fn plain(kind: u8, sequence: u16, payload: &[u8]) -> Packet {
    let mut bytes = [0; 56];
    bytes[..payload.len()].copy_from_slice(payload);
    Packet::around(kind, sequence, &bytes, payload.len())
}

#[test]
#[requirement("HLR-29")]
fn what_is_sealed_comes_through_without_its_seal() {
    let mut gate = Recorded::<Gate>::default();
    // The longest packet that the ground sends is a set point.
    for (counter, payload) in [(1, &[][..]), (2, &[1][..]), (1 << 47, &[9; 42][..])] {
        let through = gate.step(&key(), &sealed(&key(), POINT, 7, payload, counter));
        assert_eq!(through, plain(POINT, 7, payload));
    }
    assert_eq!(gate.refused, Refused::default());
}

#[test]
fn without_a_key_everything_comes_through() {
    let mut gate = Recorded::<Gate>::default();
    let open = Key { is_set: false, ..key() };
    assert_eq!(gate.step(&open, &plain(LAND, 1, &[])), plain(LAND, 1, &[]));
}

#[test]
#[requirement("HLR-29")]
fn one_wrong_bit_keeps_a_packet_out() {
    let good = sealed(&key(), MODE, 3, &[1], 1000);
    for at in CHECKSUM_START..good.length - 2 {
        for bit in 0..8 {
            let mut bytes = good.bytes;
            bytes[at] ^= 1 << bit;
            // A forger puts the checksum right.
            let size = usize::from(bytes[5]).min(56);
            let payload: [u8; 56] = std::array::from_fn(|n| bytes[HEADER_BYTES + n]);
            let sequence = u16::from_le_bytes([bytes[3], bytes[4]]);
            let forged = Packet::around(bytes[2], sequence, &payload, size);
            let mut gate = Recorded::<Gate>::default();
            assert_eq!(gate.step(&key(), &forged), Packet::none(), "bit {bit} of byte {at}");
            assert_eq!(gate.refused.forged + gate.refused.unsealed, 1);
        }
    }
}

#[test]
#[requirement("HLR-28", "HLR-29")]
fn forged_replayed_and_unsealed_packets_are_counted() {
    let mut gate = Recorded::<Gate>::default();
    let other = Key { is_set: true, halves: [1, 2] };
    let first = sealed(&key(), MODE, 1, &[1], 5000);
    let mut refused = |packet: &Packet, passes: bool| {
        assert_eq!(gate.step(&key(), packet).length != 0, passes);
        gate.refused
    };
    refused(&first, true);
    assert_eq!(refused(&first, false).replayed, 1);
    assert_eq!(refused(&sealed(&key(), MODE, 2, &[1], 4999), false).replayed, 2);
    assert_eq!(refused(&sealed(&other, MODE, 2, &[1], 6000), false).forged, 1);
    assert_eq!(refused(&plain(MODE, 2, &[1]), false).unsealed, 1);
    let cut = Packet { length: first.length - 5, ..first };
    assert_eq!(refused(&cut, false).unsealed, 2);
    refused(&sealed(&key(), MODE, 2, &[1], 5001), true);
}

#[test]
#[requirement("HLR-29")]
fn no_part_of_a_sealed_packet_passes() {
    // A STOP, which would be taken however late: no beginning of it is one.
    let whole = sealed(&key(), STOP, 3, &[], 1000);
    let mut gate = Recorded::<Gate>::default();
    for length in 1..whole.length {
        let mut cut = Packet { length, ..Packet::none() };
        cut.bytes[..length].copy_from_slice(&whole.bytes[..length]);
        assert_eq!(gate.step(&key(), &cut), Packet::none(), "{length} bytes");
        // Nor a shorter packet around what is left, with a checksum of its own.
        let kept = length.saturating_sub(HEADER_BYTES).min(SEAL_BYTES - 1);
        let around = plain(STOP, 3, &whole.bytes[HEADER_BYTES..HEADER_BYTES + kept]);
        assert_eq!(gate.step(&key(), &around), Packet::none(), "{kept} bytes of its payload");
    }
    let cut = 2 * (whole.length as u32 - 1);
    assert_eq!(gate.refused, Refused { unsealed: cut, ..Refused::default() });
    assert_ne!(gate.step(&key(), &whole).length, 0);
}

#[test]
#[requirement("HLR-28")]
fn a_stop_that_was_overtaken_stops_but_an_old_one_does_not() {
    let mut gate = Recorded::<Gate>::default();
    gate.step(&key(), &sealed(&key(), MODE, 9, &[1], 100_000));
    assert_ne!(gate.step(&key(), &sealed(&key(), STOP, 8, &[], 99_000)).length, 0);
    assert_eq!(gate.step(&key(), &sealed(&key(), STOP, 8, &[], 98_000)).length, 0);
    assert_eq!(gate.counter, 100_000);
}
