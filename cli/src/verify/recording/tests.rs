//! Proves that each way in which people record inputs is read, or is an error at its place with a remedy.

use super::*;

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
@0:4:1 entry infallible fn Motor::step in models(self: &mut Motor, gains: &Gains, mode: Mode, n: u32, on: bool, a: [f64; 2]) -> f64 as x {
  @4:2 return gains.p;
}
";

/// Tables need no mapping.
const UNMAPPED: flight::Mapping<'_> =
    flight::Mapping { names: Vec::new(), known: Vec::new(), inputs: &[], periods: &[] };

fn module() -> Module {
    bessemer_ir::text::parse(MODULE).expect("a module")
}

/// The words of each call in a line, or the error; then the notes.
fn read_text(bytes: &[u8]) -> Result<(Vec<String>, Vec<String>), String> {
    let module = module();
    let read =
        read(&module, &module.functions[0], bytes, &UNMAPPED).map_err(|wrong| wrong.to_string())?;
    let shown = |call: &Vec<Vec<u64>>| {
        let words = call.iter().flatten().map(|word| match *word {
            small @ 0..=0xffff_ffff => small.to_string(),
            bits => f64::from_bits(bits).to_string(),
        });
        words.collect::<Vec<_>>().join(" ")
    };
    Ok((read.calls.iter().map(shown).collect(), read.notes))
}

#[test]
fn tables_of_each_kind_are_read() {
    let no_gains = "`gains` has its defaults: no column";
    let cases: [(&str, &str, &[&str]); 14] = [
        (
            "gains.p,gains.i,mode,n,on,a[0],a[1]\n1.5,2.5,Run,7,true,-1.5,4.5\n",
            "1.5 2.5 1 7 1 -1.5 4.5",
            &[],
        ),
        ("mode,n,on,a[0],a[1]\nIdle,7,0,-1.5,4.5\n", "2 0.5 0 7 0 -1.5 4.5", &[no_gains]),
        ("mode;n;on;a[0];a[1]\nRun;7;0;-1.5;4.5\n", "2 0.5 1 7 0 -1.5 4.5", &[no_gains]),
        ("mode\tn\ton\ta[0]\ta[1]\nRun\t7\t0\t-1.5\t4.5\n", "2 0.5 1 7 0 -1.5 4.5", &[no_gains]),
        (
            "\u{feff}mode,n,on,a[0],a[1]\r\nRun,7,0,-1.5,4.5\r\n",
            "2 0.5 1 7 0 -1.5 4.5",
            &[no_gains],
        ),
        (
            "# a bench\nmode,n,on,a[0],a[1]\n# later\nRun,7,0,-1.5,4.5\n",
            "2 0.5 1 7 0 -1.5 4.5",
            &[no_gains],
        ),
        ("# mode,n,on,a[0],a[1]\n7,7.0,1.0,-1.5,4.5\n", "2 0.5 1 7 1 -1.5 4.5", &[no_gains]),
        (
            "mode,n [rpm],on,a[0] [V],a[1] (V)\n3,7,False,-1.5,4.5\n",
            "2 0.5 0 7 0 -1.5 4.5",
            &[no_gains],
        ),
        (
            "t,mode,n,on,a[0],a[1]\ns,-,rpm,-,V,V\n0,3,7,1,-1.5,4.5\n",
            "2 0.5 0 7 1 -1.5 4.5",
            &["line 2 skipped: it has units", no_gains],
        ),
        ("mode,n,on,a[0],a[1]\n3,7.00,TRUE,NaN,inf\n", "2 0.5 0 7 1 NaN inf", &[no_gains]),
        ("t,t,mode,n,on,a[0],a[1]\n1,2,3,7,1,-1.5,4.5\n", "2 0.5 0 7 1 -1.5 4.5", &[no_gains]),
        ("mode,n,on,a[0],a[1]\n\n 3 , 7 ,1,-1.5,4.5\n,,,,\n", "2 0.5 0 7 1 -1.5 4.5", &[no_gains]),
        (
            "mode,n,on,a[0],a[1],a[2] [V],at,gains.P\n3,7,1,-1.5,4.5,0,1,2\n",
            "2 0.5 0 7 1 -1.5 4.5",
            &["`a[2]`, `gains.P` left out: no parameter has such a part", no_gains],
        ),
        (
            "mode,n,on,a[0],a[1],a[2],a[3],a[4],a[5],a[6]\n3,7,1,-1.5,4.5,0,1,2,3,4\n",
            "2 0.5 0 7 1 -1.5 4.5",
            &[
                "`a[2]`, `a[3]`, `a[4]`, `a[5]` and 1 more left out: no parameter has such a part",
                no_gains,
            ],
        ),
    ];
    for (text, words, notes) in cases {
        let expected = (vec![words.to_owned()], notes.iter().map(ToString::to_string).collect());
        assert_eq!(read_text(text.as_bytes()), Ok(expected), "{text}");
    }
}

#[test]
fn mistakes_are_reported_at_their_place() {
    let head = "mode,n,on,a[0],a[1]\n";
    let cases = [
        ("", "it has no rows"),
        (head, "it has no rows"),
        ("t\n1\n", "it has no column `gains.p`; wanted are `gains.p`, `gains.i`, `mode`"),
        ("mode,n,on,a[0]\n1,2,3,4\n", "it has no column `a[1]`; wanted are "),
        ("mode,n,on,a[0]\n1,2,3,4\n", "found are `mode`, `n`, `on`, `a[0]`"),
        ("gains.p,mode,n,on,a[0],a[1]\n", "it has no column `gains.i`"),
        ("mode,n,on,a[0],a[1],n\n", "line 1: the column `n` occurs twice; rename or remove one"),
        ("#x\n\nmode,n,on,n,a[0],a[1]\n", "line 3: the column `n` occurs twice"),
        ("mode,n,on,a[0],a[1]\n3,7,1,2\n", "line 2 has 4 columns, and the first 5"),
        (
            "mode,n,on,a[0],a[1]\n3,4.29E+09,1,2,3\n",
            "line 2: `4.29E+09` is no whole number from 0 to 4294967295, as `n` has to be; it was rounded",
        ),
        ("mode,n,on,a[0],a[1]\n3,7.5,1,2,3\n", "line 2: `7.5` is no whole number"),
        ("mode,n,on,a[0],a[1]\n3,-1,1,2,3\n", "line 2: `-1` is no whole number"),
        (
            "mode;n;on;a[0];a[1]\n3;1;1;2,5;3\n",
            "line 2: `2,5` is no number, as `a[0]` has to be; write a decimal point",
        ),
        (
            "mode,n,on,a[0],a[1]\n3,1,1,,3\n",
            "line 2: `` is no number, as `a[0]` has to be; remove rows",
        ),
        (
            "mode,n,on,a[0],a[1]\n4,1,1,2,3\n",
            "line 2: `4` is no variant of `Mode` (`Idle`, `Run`, or its number)",
        ),
        (
            "mode,n,on,a[0],a[1]\n3,1,2,2,3\n",
            "line 2: `2` is no `true` or `false`, as `on` has to be",
        ),
        ("mode,n,on,a[0],a[1]\n3,1,1,2,3\n3,1,1,2,high\n", "line 3: `high` is no number"),
        ("mode,n,on,a[0],a[1]\n3,1,1,2,3\n-,-,-,V,V\n", "line 3: `-` is no variant"),
    ];
    for (text, expected) in cases {
        let error = read_text(text.as_bytes()).expect_err(text);
        assert!(error.contains(expected), "{text}: {error}");
    }
    let error = read_text(b"mode,n\n3,\xff\n").expect_err("no text");
    assert_eq!(error, "line 2 is not UTF-8; save the file as UTF-8");
}

/// An MCAP file of messages: a topic, a log time and a text each.
fn recorded(messages: &[(&str, u64, &str)]) -> Vec<u8> {
    let mut file = std::io::Cursor::new(Vec::new());
    let mut writer = ::mcap::Writer::new(&mut file).expect("a file");
    for (topic, log_time, text) in messages {
        let channel = writer.add_channel(0, topic, "json", &Default::default());
        let channel_id = channel.expect("a channel");
        let times = (*log_time, *log_time);
        let header = ::mcap::records::MessageHeader {
            channel_id,
            sequence: 0,
            log_time: times.0,
            publish_time: times.1,
        };
        writer.write_to_known_channel(&header, text.as_bytes()).expect("a file");
    }
    writer.finish().expect("a file");
    drop(writer);
    file.into_inner()
}

const NESTED: &str =
    r#"{"mode": "Run", "n": 7, "on": true, "a": [NaN, -Infinity], "text": "NaN\""}"#;
const FLAT: &str =
    r#"{"mode": 3, "n": 8.0, "on": 0, "a[0]": 0.1, "a[1]": 1e300, "gains": {"p": 1.5, "i": 2.5}}"#;
const NO_GAINS: &str = r#"{"mode": 3, "n": 8, "on": 0, "a[0]": 0.1, "a[1]": 1e300}"#;

#[test]
fn messages_are_rows_in_the_order_of_their_log_times() {
    let other = ("/other", 0, r#"{"n": 1}"#);
    let file = recorded(&[other, ("/log", 2, NESTED), ("/log", 5, NESTED), ("/log", 3, NO_GAINS)]);
    let (calls, notes) = read_text(&file).expect("a recording");
    assert_eq!(
        calls,
        ["2 0.5 1 7 1 NaN -inf", "2 0.5 0 8 0 0.1 1e300", "2 0.5 1 7 1 NaN -inf"]
            .map(|it| it.replace("1e300", &1e300_f64.to_string()))
    );
    assert_eq!(
        notes,
        [
            "messages sorted by log time; the file has another order",
            "`gains` has its defaults: no column"
        ]
    );

    let (calls, notes) = read_text(&recorded(&[("/log", 1, FLAT)])).expect("a recording");
    assert!(calls[0].starts_with("1.5 2.5 0 8 0 0.1"), "{calls:?}");
    assert!(notes.is_empty(), "{notes:?}");

    let long = FLAT.replace(r#""a[1]""#, r#""x": 1, "a": [0, {"b": 2}], "a[1]""#);
    let (_, notes) = read_text(&recorded(&[("/log", 1, &long)])).expect("a recording");
    assert_eq!(notes, ["`a[1].b` left out: no parameter has such a part"]);

    let others = [("/bad", 0, "{nan}"), ("/a", 1, FLAT), ("/b", 2, FLAT), ("/c", 3, FLAT)];
    let (calls, notes) = read_text(&recorded(&others)).expect("a recording");
    assert_eq!((calls.len(), &*notes), (1, &["`/a` read; `/b`, `/c` left out".to_owned()][..]));
}

#[test]
fn messages_that_cannot_be_rows_are_reported() {
    let other = ("/other", 0, r#"{"n": 1}"#);
    let good = ("/log", 1, NESTED);
    let cases = [
        (recorded(&[other, other]), "it has no column `mode`"),
        (recorded(&[("/x", 0, "{}"), other]), "none of its topics has the columns `gains.p`, "),
        (recorded(&[("/x", 0, "{}"), other]), "; in JSON are `/x`, `/other`"),
        (
            recorded(&[good, ("/log", 2, r#"{"n": 1}"#)]),
            "message 2 of `/log` has 1 columns, and the first 5",
        ),
        (recorded(&[good, ("/log", 2, "{nan}")]), "message 2 of `/log` is no JSON: "),
        (recorded(&[other, ("/log", 1, "{nan}"), good]), "message 1 of `/log` is no JSON: "),
        (recorded(&[good, ("/log", 2, r#"{"n": NaN"#)]), "message 2 of `/log` is no JSON: "),
        (recorded(&[]), "none of its topics"),
    ];
    for (file, expected) in cases {
        let error = read_text(&file).expect_err(expected);
        assert!(error.contains(expected), "{expected}: {error}");
    }
    let whole = recorded(&[good]);
    let error = read_text(&whole[..whole.len() / 4]).expect_err("half a file");
    assert!(error.starts_with("it is no whole MCAP file"), "{error}");
}

/// Written by the Python package `mcap` 1.6.0: a chunk compressed by zstd, log times 2, 1, 3, 4, and `NaN` and `Infinity` in JSON.
const PYTHON: &[u8] = include_bytes!("python.mcap");

#[test]
fn files_of_pythons_writer_are_read() {
    let module = bessemer_ir::text::parse(
        "module models\nfile \"models/src/lib.rs\"\n\n/// A loop.\n@0:3:1 struct Motor in models { last: f64, }\n\n/// A part.\n@0:1:1 struct Part in models { c: bool, }\n\n/// A step.\n@0:4:1 entry infallible fn Motor::step in models(self: &mut Motor, a: f64, b: &Part, d: [u8; 2]) -> f64 as x {\n  @4:2 return a;\n}\n",
    )
    .expect("a module");
    let read = read(&module, &module.functions[0], PYTHON, &UNMAPPED).expect("a recording");
    let numbers: Vec<f64> = read.calls.iter().map(|call| f64::from_bits(call[0][0])).collect();
    assert_eq!(format!("{numbers:?}"), "[0.1, NaN, -inf, inf]");
    let others: Vec<&[Vec<u64>]> = read.calls.iter().map(|call| &call[1..]).collect();
    assert_eq!(others[0], [vec![0], vec![1, 1]]);
    assert_eq!(others[3], [vec![1], vec![1, 4]]);
    assert_eq!(read.notes.len(), 1);
}

#[test]
fn damaged_files_are_errors_and_no_panics() {
    let files = [PYTHON.to_vec(), recorded(&[("/log", 1, NESTED), ("/log", 2, FLAT)])];
    for mut file in files {
        for at in 0..file.len() {
            let byte = file[at];
            for other in [0, 1, 0x7f, 0xff, byte ^ 1, byte ^ 0x80] {
                file[at] = other;
                // Either is right: a changed byte may be one that nothing reads.
                let _ = read_text(&file);
            }
            file[at] = byte;
            let _ = read_text(&file[..at]);
        }
    }
}
