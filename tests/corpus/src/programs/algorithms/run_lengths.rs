//! Run-length coding of a line of pixels.

use bessemer::prelude::*;

/// A run of pixels of one colour, and its length.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Run {
    pub colour: u8,
    pub length: u8,
}

/// The runs of a line; more than eight are a fault.
#[function]
pub fn encode(line: &[u8; 16]) -> List<Run, 8> {
    let mut runs: List<Run, 8> = List::new();
    for colour in line.iter().copied() {
        match runs.last() {
            Some(run) if run.colour == colour => {
                let last = runs.len() - 1;
                runs[last].length += 1;
            }
            _ => runs.push(Run { colour, length: 1 }),
        }
    }
    runs
}

/// The line of some runs; a line that is too short is filled with zeros.
#[function]
pub fn decode(runs: &List<Run, 8>) -> [u8; 16] {
    let mut line = [0; 16];
    let mut at = 0;
    for run in runs {
        let end = (at + usize::from(run.length)).min(line.len());
        line[at..end].fill(run.colour);
        at = end;
    }
    line
}
