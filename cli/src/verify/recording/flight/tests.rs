//! Proves that logs of PX4, ArduPilot and Betaflight are read and resampled as stated. Each mistake of a mapping is an error with
//! its place and a remedy, and damage is never a panic.

use bessemer_project::file;

use super::*;
use crate::verify::recording::{self, Recording};

const PX4: &[u8] = include_bytes!("samples/px4.ulg");
const ARDUPILOT: &[u8] = include_bytes!("samples/ardupilot.bin");
const BETAFLIGHT: &[u8] = include_bytes!("samples/betaflight.bbl");

const MODULE: &str = "\
module models
file \"models/src/lib.rs\"

/// Gains.
@0:1:1 struct Gains in models { p: f64, i: f64, } = [2.0, 0.5]

/// Modes.
@0:2:1 enum Mode in models { Idle = 3, Run = 7, }

/// A loop.
@0:3:1 struct Motor in models { last: f64, }

/// A step.
@0:4:1 entry infallible fn Motor::step in models(self: &mut Motor, gains: &Gains, rates: [f64; 3], height: f64, n: u32, mode: Mode) -> f64 as x {
  @4:2 return gains.p;
}
";

/// Reads a log by these settings: the words of each call as text, then the notes; or the error and its remedy.
fn calls(log: &[u8], settings: &str) -> Result<(Vec<String>, Vec<String>), String> {
    let mut read = Err(String::new());
    each(&[log], settings, &mut |it| read = it);
    let Recording { calls, notes } = read?;
    let shown = |call: &Vec<Vec<u64>>| {
        let words = call.iter().flatten().map(|word| match *word {
            small @ 0..=0xffff_ffff => small.to_string(),
            bits => format!("{:?}", f64::from_bits(bits)),
        });
        words.collect::<Vec<_>>().join(" ")
    };
    Ok((calls.iter().map(shown).collect(), notes))
}

/// Shows what each of these logs is read as.
fn each(logs: &[&[u8]], settings: &str, see: &mut dyn FnMut(Result<Recording, String>)) {
    let module = bessemer_ir::text::parse(MODULE).expect("a module");
    let settings = file::read(file::NAME, settings).expect("sound settings");
    let names: Vec<String> = ["motor_step", "Motor::step", "motor"].map(str::to_owned).to_vec();
    let known = names.clone();
    let mapping = Mapping { names, known, inputs: &settings.inputs, periods: &settings.periods };
    for log in logs {
        let read = recording::read(&module, &module.functions[0], log, &mapping);
        see(read.map_err(|wrong| format!("{wrong}; {}", wrong.remedy())));
    }
}

const PX4_MAP: &str = "[inputs.motor_step]\nrates = \"sensor_combined.gyro_rad\"\nheight = \"vehicle_air_data.baro_alt_meter\"\n\
    n = \"sensor_combined[1].accelerometer_clipping\"\nmode = 7\n";

#[test]
fn a_log_of_px4_is_resampled_by_holding_samples() {
    let (calls, notes) =
        calls(PX4, &format!("{PX4_MAP}[periods]\nmotor_step = 0.004\n")).expect("a log");
    // From the first sample of the last topic, 1,002,000 µs, to the last of any, 1,115,000 µs.
    assert_eq!(calls.len(), 29);
    let rate = |n: f64, axis: f64| f64::from((0.1 * axis + (0.1 * n).sin()) as f32);
    let call = |n: f64, height: f64, clipping: u32| {
        let [x, y, z] = [0.0, 1.0, 2.0].map(|axis| rate(n, axis));
        let x = if x == 0.0 { "0".to_owned() } else { format!("{x:?}") };
        format!("2.0 0.5 {x} {y:?} {z:?} {height:?} {clipping} 1")
    };
    assert_eq!(calls[0], call(0.0, 100.1, 0));
    // 1,006,000 µs: the sample of 1,005,000 holds.
    assert_eq!(calls[1], call(1.0, 100.1, 0));
    // 1,022,000 µs: four samples of the sensor, one of the height, two of the second instance.
    assert_eq!(calls[5], call(4.0, 100.1 + 0.7, 2));
    assert_eq!(calls[28], call(22.0, 100.1 + 0.7 * 5.0, 2));
    assert_eq!(notes, ["1 dropouts of 12 ms altogether", "`gains` has its defaults: no column"]);
}

#[test]
fn messages_within_messages_are_fields() {
    let map = "[inputs.motor]\nrates = [\"esc_status.esc[1].esc_rpm\", \"esc_status.esc[0].esc_voltage\", 0]\n\
        height = \"esc_status.esc_count\"\nn = \"esc_status.esc[1].esc_state\"\nmode = 3\n[periods]\nmotor = 0.05\n";
    let (calls, _) = calls(PX4, map).expect("a log");
    assert_eq!(calls[0], "2.0 0.5 910.0 15.5 0 2.0 0 0");
    assert_eq!(calls[2], "2.0 0.5 840.0 15.5 0 2.0 0 0");
    let text = map.replace("esc[1].esc_rpm", "esc_rpm");
    let error = self::calls(PX4, &text).expect_err("no field");
    let listed = "`timestamp`, `esc_count`, `esc[0].esc_rpm`, `esc[0].esc_voltage`";
    assert!(error.contains(listed), "{error}");
}

#[test]
fn a_log_of_ardupilot_is_read_by_instances() {
    let map = "[inputs.motor]\nrates = [\"IMU[1].GyrX\", \"IMU[1].GyrY * -1\", 0.25]\nheight = \"BARO.Temp\"\n\
        n = \"BARO.SMS\"\nmode = 3\ngains.p = \"BARO.Lat\"\ngains.i = \"IMU.T\"\n[periods]\nmotor = 2.5e-3\n";
    let (calls, notes) = calls(ARDUPILOT, map).expect("a log");
    let rate = |n: f64, axis: f64| f64::from((0.2 * n + axis + 1.0).sin() as f32);
    let call = |n: f64, of_baro: u32| {
        let b = f64::from(of_baro);
        let (lat, temp) = ((473_977_418.0 + b) / 1e7, (2000.0 + b) / 100.0);
        let (x, y) = (rate(n, 0.0), -rate(n, 1.0));
        format!("{lat:?} {:?} {x:?} {y:?} 0.25 {temp:?} {of_baro} 0", 40.5 + n)
    };
    // The first call is at the first sample of the barometer, 200 µs behind the third sample of the inertial unit.
    assert_eq!(calls[0], call(2.0, 2));
    assert_eq!(calls[5], call(7.0, 7));
    // The last sample of any is the twentieth of the second unit, before another period has passed.
    assert_eq!((calls.len(), calls.last()), (17, Some(&call(18.0, 17))));
    assert_eq!(notes, Vec::<String>::new());
}

#[test]
fn a_log_of_betaflight_has_the_numbers_of_an_independent_reader() {
    let log = blackbox::read(BETAFLIGHT, &|_| true).unwrap_or_else(|wrong| panic!("{wrong}"));
    let main = &log.topics[0];
    let text = include_str!("samples/betaflight.csv");
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().expect("names");
    let place = |name: &&str| main.fields.iter().position(|it| it.name == **name);
    let places: Vec<usize> = names.iter().map(|it| place(it).expect("a field")).collect();
    let mut rows = 0;
    for (line, sample) in lines.zip(&main.samples) {
        let numbers: Vec<String> = places.iter().map(|at| sample.numbers[*at].text()).collect();
        assert_eq!(numbers, line, "row {rows}");
        rows += 1;
    }
    assert_eq!((main.name.as_str(), main.count, rows), ("main", 230, 230));
    let slow = &log.topics[1];
    assert_eq!((slow.name.as_str(), slow.time), ("slow", Some(5)));
    assert_eq!(slow.samples[0].numbers.len(), 6);
    assert_eq!(log.notes, ["1 damaged frames left out, the first at byte 11981"]);
    // A second log of the file has topics of its own.
    let log = blackbox::read(&[BETAFLIGHT, BETAFLIGHT].concat(), &|_| true);
    let log = log.unwrap_or_else(|wrong| panic!("{wrong}"));
    assert_eq!((log.topics[4].name.as_str(), log.topics[4].count), ("main[1]", 230));
}

/// A damaged stretch costs the differences up to the next whole frame, and nothing before or behind.
#[test]
fn a_damaged_blackbox_goes_on_at_the_next_whole_frame() {
    let whole = blackbox::read(BETAFLIGHT, &|_| true).unwrap_or_else(|wrong| panic!("{wrong}"));
    let mut damaged = BETAFLIGHT.to_vec();
    damaged[6000..6100].fill(0xff);
    let log = blackbox::read(&damaged, &|_| true).unwrap_or_else(|wrong| panic!("{wrong}"));
    let texts = |log: &Log| {
        let text = |it: &log::Sample| it.numbers.iter().map(|it| it.text()).collect::<String>();
        log.topics[0].samples.iter().map(text).collect::<Vec<_>>()
    };
    let (all, left) = (texts(&whole), texts(&log));
    assert!(left.len() > 150 && left.len() < all.len(), "{}", left.len());
    assert!(left.iter().all(|it| all.contains(it)));
    assert!(
        log.notes[0].contains("damaged frames left out, the first at byte "),
        "{:?}",
        log.notes
    );
}

/// Each mistake has its place, what there is, and a remedy.
#[test]
fn mistakes_of_a_mapping_are_errors() {
    let all = "rates = \"sensor_combined.gyro_rad\"\nheight = 1.0\nn = 1\nmode = 3\n";
    let with = |line: &str| format!("[inputs.motor]\n{line}\n[periods]\nmotor = 0.004\n");
    let cases = [
        (
            String::new(),
            "bessemer.toml has no table `[inputs.motor_step]`, which maps the topics `sensor_combined`, `sensor_combined[1]`, \
             `vehicle_air_data`, `esc_status` to `gains`, `rates`, `height`, `n`, `mode`; write `[inputs.motor_step]`",
        ),
        (
            format!("[inputs.motor]\n{all}"),
            "bessemer.toml does not set the period of `motor_step`, to which the log is resampled; write `[periods]`, below it the \
             seconds between two calls: `motor_step = 0.004`",
        ),
        (
            format!("{}[inputs.pump]\n", with(all)),
            "bessemer.toml:9: `[inputs.pump]` is of no entry point; there are `motor_step`, `Motor::step`, `motor`",
        ),
        (
            format!("{}pump = 0.1\n", with(all)),
            "bessemer.toml:9: `[inputs.pump]` is of no entry point",
        ),
        (
            with(&all.replace("height", "hight")),
            "bessemer.toml:3: the entry point takes no `hight`; it takes `gains`, `rates`, `height`, `n`, `mode`",
        ),
        (
            with(&all.replace("sensor_combined", "sensor_combine")),
            "bessemer.toml:2: the log has no topic `sensor_combine`; it has `sensor_combined`, `sensor_combined[1]`, `vehicle_air_data`",
        ),
        (
            with(&all.replace("gyro_rad", "gyro")),
            "bessemer.toml:2: `sensor_combined` has no field `gyro`; it has `timestamp`, `gyro_rad`, `gyro_integral_dt`, \
             `accelerometer_m_s2`, `accelerometer_clipping`; write one of these fields",
        ),
        (
            with(&all.replace("gyro_rad", "gyro_rad[1]")),
            "bessemer.toml:2: `rates` takes 3 numbers, and `sensor_combined.gyro_rad[1]` has 1; write a list with a source for \
             each number: `rates = [\"topic.x\", \"topic.y\"]`",
        ),
        (
            with(&all.replace("height = 1.0", "height = \"sensor_combined.gyro_rad\"")),
            "bessemer.toml:3: `height` takes 1 numbers, and `sensor_combined.gyro_rad` has 3",
        ),
        (
            with(&all.replace("\"sensor_combined.gyro_rad\"", "[1, 2, 3, 4]")),
            "bessemer.toml:2: `rates` takes 3 numbers, and the list has 4",
        ),
        (
            with(&format!("{all}\"rates[1]\" = 2\n")),
            "bessemer.toml:6: `rates[1]` is mapped already; remove one of the two keys",
        ),
        (
            with(&all.replace("height = 1.0\n", "")),
            "`[inputs.motor]` does not map `height`; write `height = \"topic.field\"`, or a number that it always is",
        ),
        (with(&format!("{all}gains.p = 1.0")), "`[inputs.motor]` does not map `gains.i`"),
        (
            with(&all.replace("\"sensor_combined.gyro_rad\"", "[1, 2, 3]")),
            "`[inputs.motor]` maps no topic of the log; it has `sensor_combined`",
        ),
        (
            with(&all.replace("mode = 3", "mode = 4")),
            "call 1 at 1000000.000 µs: `4` is no variant of `Mode` (`Idle`, `Run`, or its number), as `mode` has to be",
        ),
        (
            with(&all.replace("n = 1", "n = \"vehicle_air_data.error_count\"")),
            "call 6 at 1020500.000 µs: `-1` is no whole number from 0 to 4294967295, as `n` has to be",
        ),
        (
            with(all).replace("0.004", "1e-9"),
            "from 1000000 to 1115000 µs there are 115000001 periods, more than 240000; is the period in seconds?",
        ),
    ];
    for (settings, expected) in cases {
        let error = calls(PX4, &settings).expect_err(expected);
        assert!(error.starts_with(expected), "{expected}\n{error}");
    }
    let of_ardupilot = |line: &str| {
        let map = format!("[inputs.motor]\nrates = [1, 2, 3]\nheight = {line}\nn = 1\nmode = 3\n");
        calls(ARDUPILOT, &format!("{map}[periods]\nmotor = 0.1\n")).expect_err(line)
    };
    let cases = [
        (
            "\"GPS.GMS\"",
            "bessemer.toml:3: `GPS` has no samples in this log; log this topic, or map another",
        ),
        ("\"MSG.Message\"", "bessemer.toml:3: `MSG` has no field `Message`; it has `TimeUS`"),
    ];
    for (line, expected) in cases {
        let error = of_ardupilot(line);
        assert!(error.starts_with(expected), "{expected}\n{error}");
    }
}

/// A time that goes back is an error at its sample; equal times are none, and the later sample holds.
#[test]
fn time_does_not_go_back() {
    let at = |time: u64| PX4.windows(8).position(|it| it == time.to_le_bytes()).expect("a sample");
    let mut log = PX4.to_vec();
    let set = |log: &mut Vec<u8>, from: u64, to: u64| {
        let at = at(from);
        log[at..at + 8].copy_from_slice(&to.to_le_bytes());
    };
    let settings = format!("{PX4_MAP}[periods]\nmotor = 0.004\n");
    set(&mut log, 1_025_000, 1_020_000);
    assert!(calls(&log, &settings).is_ok());
    set(&mut log, 1_025_000, 1_019_999);
    let error = calls(&log, &settings).expect_err("time goes back");
    let expected = "sample 6 of `sensor_combined` is of 1019999 µs, and the one before of 1020000 µs; cut the log";
    assert!(error.starts_with(expected), "{error}");
}

/// A log that ends within a message comes from a loss of power. Damage of a log's head is an error at its byte.
#[test]
fn ends_and_unknown_kinds_are_reported() {
    let settings = format!("{PX4_MAP}[periods]\nmotor = 0.004\n");
    let (_, notes) = calls(&PX4[..PX4.len() - 5], &settings).expect("a log");
    assert!(notes[0].ends_with("bytes left out: the file ends within a message"), "{notes:?}");
    let error = calls(&PX4[..12], &settings).expect_err("no head");
    assert_eq!(
        error,
        "byte 0: the file ends within its head; load the log from the vehicle once more"
    );
    let mut appended = PX4.to_vec();
    appended[16 + 3 + 8 + 1] = 1;
    let error = calls(&appended, &settings).expect_err("an unknown feature");
    assert!(error.starts_with("byte 19: it uses features of ULog"), "{error}");
    let mut skipped = ARDUPILOT.to_vec();
    skipped.splice(1500..1500, [1, 2, 3]);
    let log = dataflash::read(&skipped, &|_| true).unwrap_or_else(|wrong| panic!("{wrong}"));
    assert!(log.notes[0].contains(" bytes left out, the first at byte "), "{:?}", log.notes);
    let text = String::from_utf8_lossy(BETAFLIGHT).replacen("version:2", "version:1", 1);
    let error = blackbox::read(text.as_bytes(), &|_| true).err().expect("another version");
    assert!(error.to_string().ends_with("the version of the data is 1, and 2 is read"), "{error}");
}

/// PX4 appends data behind a message that a loss of power cut; the flags say where.
#[test]
fn appended_data_is_read() {
    let settings = format!("{PX4_MAP}[periods]\nmotor = 0.004\n");
    let whole = calls(PX4, &settings).expect("a log");
    let cut =
        PX4.windows(8).position(|it| it == 1_060_000_u64.to_le_bytes()).expect("a sample") - 5;
    let (before, after) = PX4.split_at(cut);
    // A message of data that lacks its end.
    let mut log = [before, &after[..9], after].concat();
    let flags = 16 + 3 + 8;
    log[flags] = 1;
    log[flags + 8..flags + 16].copy_from_slice(&(cut as u64 + 9).to_le_bytes());
    assert_eq!(calls(&log, &settings).expect("a log"), whole);
}

/// Some thousands of damaged logs: bytes changed, stretches cut, doubled and overwritten.
#[test]
fn damage_is_no_panic() {
    let px4 = format!("{PX4_MAP}[periods]\nmotor = 0.004\n");
    let ardupilot = "[inputs.motor]\nrates = [\"IMU[1].GyrX\", \"IMU.GyrY * -1\", 0.25]\nheight = \"BARO.Temp\"\n\
        n = \"BARO.SMS\"\nmode = 3\n[periods]\nmotor = 0.01\n";
    let betaflight = "[inputs.motor]\nrates = \"main.gyroADC * 0.0175\"\nheight = \"slow.stateFlags\"\n\
        n = \"main.motor[3]\"\nmode = 3\n[periods]\nmotor = 0.01\n";
    let mut state = 1_u64;
    let mut random = |below: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % below.max(1)
    };
    let logs =
        [(PX4, px4.as_str(), 1500), (ARDUPILOT, ardupilot, 1500), (BETAFLIGHT, betaflight, 400)];
    for (log, settings, rounds) in logs {
        assert!(calls(log, settings).is_ok(), "{:?}", calls(log, settings).err());
        let mut all: Vec<Vec<u8>> = Vec::new();
        for _ in 0..rounds {
            let mut damaged = log.to_vec();
            for _ in 0..=random(3) {
                let (at, count) = (random(damaged.len()), random(40));
                let end = damaged.len().min(at + count);
                match random(5) {
                    0 => damaged[at] = random(256) as u8,
                    1 => damaged[at] ^= 1 << random(8),
                    2 => _ = damaged.drain(at..end),
                    3 => damaged[at..end].fill(0xff),
                    _ => {
                        let twice = damaged[at..end].to_vec();
                        damaged.splice(at..at, twice);
                    }
                }
            }
            all.push(damaged);
        }
        let all: Vec<&[u8]> = all.iter().map(Vec::as_slice).collect();
        let mut read = 0;
        // Either is right: damage may be where nothing reads.
        each(&all, settings, &mut |it| read += usize::from(it.is_ok()));
        assert!(read > 0 && read < rounds, "{read} of {rounds} damaged logs are read");
    }
}
