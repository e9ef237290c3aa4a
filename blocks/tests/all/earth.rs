//! Coordinate frames against pymap3d, checksums against Python's own, CAN signals against cantools.

use bessemer::nalgebra::Vector3;
use bessemer::prelude::{Real, real};
use bessemer_blocks::*;
use num_traits::AsPrimitive;

use crate::data::{Data, near};

#[test]
fn coordinates_on_the_earth() {
    let data = Data::read(include_str!("../data/frames.txt"));
    let geodetic =
        |[latitude, longitude, height]: [f64; 3]| Geodetic { latitude, longitude, height };
    let origin = geodetic(data.all("origin"));
    let (ecef, enu) = (data.rows::<f64, 3>("ecef"), data.rows::<f64, 3>("enu"));
    for (k, position) in data.rows::<f64, 3>("geodetic").into_iter().enumerate() {
        let point = ecef_from_geodetic(&geodetic(position));
        near(point.as_slice(), &ecef[k], 14);
        let back = geodetic_from_ecef(&Vector3::from(ecef[k]));
        assert!((back.latitude - position[0]).abs() < 1e-13, "{k}: {back:?}");
        assert!((back.longitude - position[1]).abs() < 1e-13, "{k}: {back:?}");
        assert!((back.height - position[2]).abs() < 2e-8, "{k}: {back:?}");
        let local = enu_from_ecef(&origin, &point);
        near(local.as_slice(), &enu[k], 13);
        near(ned_from_enu(&local).as_slice(), &data.rows::<f64, 3>("ned")[k], 13);
        near(ecef_from_enu(&origin, &local).as_slice(), &ecef[k], 14);
    }
}

#[test]
fn checksums() {
    let data = Data::read(include_str!("../data/bytes.txt"));
    let text: Vec<u8> = data.get::<f64>("text").iter().map(|byte| *byte as u8).collect();
    assert_eq!(f64::from(!crc32(&CRC32_IEEE, u32::MAX, &text)), data.get::<f64>("crc32")[0]);
    assert_eq!(f64::from(crc16(&CRC16_CCITT, 0xffff, &text)), data.get::<f64>("crc16")[0]);
    // The check values of the catalogue: SAE J1850, CRC-32C.
    const J1850: [u8; 256] = crc8_table(0x1d);
    const CASTAGNOLI: [u32; 256] = crc32_table(0x82f6_3b78);
    assert_eq!(!crc8(&J1850, 0xff, b"123456789"), 0x4b);
    assert_eq!(!crc32(&CASTAGNOLI, u32::MAX, b"123456789"), 0xe306_9283);
}

fn signals<T: Real + AsPrimitive<u64> + AsPrimitive<i64>>()
where
    u64: AsPrimitive<T>,
    i64: AsPrimitive<T>,
{
    let data = Data::read(include_str!("../data/bytes.txt"));
    for row in data.rows::<f64, 23>("signals") {
        let byte = |number: &f64| *number as u8;
        let signal = Signal {
            start: byte(&row[0]),
            bits: byte(&row[1]),
            order: if row[2] == 1.0 { Order::Little } else { Order::Big },
            is_signed: row[3] == 1.0,
            scale: real::<T>(row[4]),
            offset: real(row[5]),
        };
        let bytes = |from: usize| std::array::from_fn::<u8, 8, _>(|k| byte(&row[from + k]));
        let value = read_signal(&bytes(6), &signal);
        near(&[value], &[real(row[14])], 14);
        let mut alone = [0; 8];
        write_signal(&mut alone, &signal, value);
        assert_eq!(alone, bytes(15), "{row:?}");
        // Other bits of a frame keep their values.
        let mut frame = bytes(6);
        write_signal(&mut frame, &signal, value);
        assert_eq!(frame, bytes(6), "{row:?}");
    }
}

#[test]
fn signals_of_a_bus() {
    signals::<f64>();
    signals::<f32>();
}
