//! A report about a flight for people: commands, settling, and limits.

use std::fmt::Write as _;

use crate::verdict::{judge, saturations, settled};
use crate::{Flight, Mission, Tolerance};

/// Formats a Markdown page about a flight with motors up to `largest_command`.
pub fn page(flight: &Flight, mission: &Mission, largest_command: f64) -> String {
    let tolerance = Tolerance::default();
    let mut text = String::new();
    let steps = flight.steps.len();
    let _ = writeln!(text, "{steps} steps, {} s\n", mission.duration);
    let _ = writeln!(text, "| manoeuvre | settled by, s | height, mm | plane, mm | yaw, ° |");
    let _ = writeln!(text, "|:--|--:|--:|--:|--:|");
    for row in settled(flight, mission, tolerance.window) {
        let errors = row.errors;
        let _ = writeln!(
            text,
            "| {} | {:.2} | {:.1} | {:.1} | {:.2} |",
            row.manoeuvre,
            row.by,
            1e3 * errors.height,
            1e3 * errors.place,
            errors.yaw.to_degrees()
        );
    }
    let _ = writeln!(text, "\n| motor | limit | first, s | periods |\n|--:|:--|--:|--:|");
    for row in saturations(flight, largest_command) {
        let limit = if row.upper { "upper" } else { "lower" };
        let _ =
            writeln!(text, "| {} | {limit} | {:.3} | {} |", row.motor + 1, row.first, row.periods);
    }
    let faults = judge(flight, mission, &tolerance);
    let _ = writeln!(text);
    if faults.is_empty() {
        let _ = writeln!(text, "settled after each manoeuvre, and landed");
    }
    for fault in faults {
        let _ = writeln!(text, "not as asked: {fault}");
    }
    text
}

/// Formats every step as comma-separated values, in SI units.
pub fn csv(flight: &Flight) -> String {
    let mut text = String::from("time,x,y,z,roll,pitch,yaw,motor1,motor2,motor3,motor4\n");
    for step in &flight.steps {
        let (place, angles, motors) = (step.state.position, step.state.angles, step.command.motors);
        let values = place.iter().chain(&angles).chain(&motors);
        let _ = write!(text, "{}", step.time);
        for value in values {
            let _ = write!(text, ",{value}");
        }
        text.push('\n');
    }
    text
}
