//! The chapter of algorithms: each tested program of `tests/corpus/src/programs/algorithms/` as a page, included from
//! its source.
//!
//! Invariant: a title has the words that a reader searches for, because a search weighs titles most.

use std::fmt::Write as _;
use std::path::Path;

use crate::error::Error;

/// Folder of the programs.
pub const PROGRAMS: &str = "tests/corpus/src/programs/algorithms";

/// Programs and the titles of their pages.
pub const TITLES: &[(&str, &str)] = &[
    ("active_set", "Bounded quadratic programme by an active set"),
    ("alpha_beta", "Alpha-beta filter: position and speed"),
    ("attitude_filter", "EKF of attitude and gyro bias"),
    ("base64", "Base64 encoding"),
    ("battery", "State of charge of a battery"),
    ("bit_codes", "Bits: Gray, Morton and Hamming codes"),
    ("cobs", "COBS framing: consistent overhead byte stuffing"),
    ("complementary", "Complementary filter of one angle"),
    ("cordic", "CORDIC: sine and cosine in fixed point"),
    ("coulomb_counter", "Coulomb counter with a correction at rest"),
    ("dc_motor", "Luenberger observer of a DC motor"),
    ("debouncer", "Debounced button with edges"),
    ("decompressor", "LZ4-like decompressor"),
    ("density_groups", "DBSCAN: groups of points"),
    ("dijkstra", "Dijkstra: shortest ways on a graph"),
    ("event_queue", "Event queue by due time"),
    ("fault_detector", "Sensor voting: detection of a fault"),
    ("field_oriented", "Field-oriented current control (FOC)"),
    ("fletcher", "Fletcher checksum"),
    ("geodetic", "WGS84: geodetic, earth-fixed and local coordinates"),
    ("geofence", "Geofence: point in a polygon"),
    ("goertzel", "Goertzel: the strongest of four tones"),
    ("hampel", "Hampel filter: removal of outliers"),
    ("inertia", "Inertia of a body made of parts"),
    ("kalman", "Kalman filter of height and climb"),
    ("least_squares", "Recursive least squares (RLS) with forgetting"),
    ("lookup", "Lookup of an ignition's advance"),
    ("lqr", "LQR: state feedback with scheduled gains"),
    ("mahony", "Mahony attitude filter"),
    ("min_jerk", "Minimum jerk: a quintic through waypoints"),
    ("modbus", "Modbus RTU slave"),
    ("moving_median", "Moving median of five samples"),
    ("mppt", "MPPT: maximum power point tracking"),
    ("path", "A*: shortest path through a grid"),
    ("pid", "PID with anti-windup and bumpless transfer"),
    ("postfix", "Postfix calculator on a bounded stack"),
    ("priority_queue", "Priority queue of bounded length"),
    ("quaternion_rates", "Quaternion propagation by rates"),
    ("rainflow", "Rainflow counting of load cycles"),
    ("random_numbers", "Random numbers: generators, distribution, shuffle"),
    ("reed_solomon", "Reed-Solomon over GF(256)"),
    ("run_lengths", "Run-length encoding"),
    ("s_curve", "S-curve trajectory with limited jerk"),
    ("savitzky_golay", "Savitzky-Golay filter: the slope of a signal"),
    ("sorting", "Insertion sort, binary search, trimmed mean"),
    ("state_machine", "Retries of a link: a state machine with data"),
    ("ublox", "UBX receiver: a parser byte by byte"),
    ("viterbi", "Viterbi decoder"),
];

/// Returns the entries of the chapter for the contents.
pub fn contents() -> String {
    let mut text = "- [Algorithms](algorithms/index.md)\n".to_owned();
    for (program, title) in TITLES {
        let _ = writeln!(text, "  - [{title}](algorithms/{program}.md)");
    }
    text
}

/// Returns the pages of the chapter: path and text.
///
/// # Errors
/// [`Error::File`] if a program cannot be read.
pub fn pages(root: &Path) -> Result<Vec<(String, String)>, Error> {
    let mut list = String::from(
        "# Algorithms\n\nEach page is a tested program: Rust, interpreter and C compute the same bits of it on every compiler.\n\n",
    );
    let mut pages = Vec::new();
    for (program, title) in TITLES {
        let path = format!("{PROGRAMS}/{program}.rs");
        let source = super::read(&root.join(&path))?;
        let (about, code): (Vec<&str>, Vec<&str>) =
            source.lines().partition(|line| line.starts_with("//!"));
        let about = about.iter().map(|line| line.trim_start_matches("//!").trim());
        let (about, code) = (about.collect::<Vec<_>>().join(" "), code.join("\n"));
        let text = format!("# {title}\n\n{about}\n\n`{path}`:\n\n```rust\n{}\n```\n", code.trim());
        pages.push((format!("algorithms/{program}.md"), text));
        let _ = writeln!(list, "* [{title}]({program}.md)");
    }
    pages.push(("algorithms/index.md".to_owned(), list));
    Ok(pages)
}
