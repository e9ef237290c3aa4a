//! Time measurement: programs run a case alternately, round by round, so that a disturbance affects all of them.
//! Unequal disturbances, such as a neighbour on the processor, are detected.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::Instant;

/// A running program that executes requests.
pub struct Server {
    child: Child,
    requests: ChildStdin,
    answers: BufReader<ChildStdout>,
}

impl Server {
    /// Starts a program.
    ///
    /// # Errors
    /// An error of the system.
    pub fn start(program: &Path, environment: &[(&str, &str)]) -> Result<Server, String> {
        Server::spawn(Command::new(program).envs(environment.iter().copied()))
    }

    /// Starts a program of the Cortex-A9.
    ///
    /// # Errors
    /// An error of the system.
    pub fn emulated(program: &Path) -> Result<Server, String> {
        Server::spawn(Command::new("qemu-arm").args(["-cpu", "cortex-a9"]).arg(program))
    }

    fn spawn(command: &mut Command) -> Result<Server, String> {
        let mut child = command
            .arg("serve")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("{command:?}: {error}"))?;
        match (child.stdin.take(), child.stdout.take()) {
            (Some(requests), Some(answers)) => {
                Ok(Server { child, requests, answers: BufReader::new(answers) })
            }
            _ => Err("a program has no pipes".into()),
        }
    }

    fn ask(&mut self, request: &str) -> Result<String, String> {
        let mut answer = String::new();
        writeln!(self.requests, "{request}")
            .and_then(|()| self.requests.flush())
            .and_then(|()| self.answers.read_line(&mut answer))
            .map_err(|error| format!("{request}: {error}"))?;
        match answer.trim() {
            "unknown" | "" => Err(format!("no answer to `{request}`")),
            answer => Ok(answer.to_owned()),
        }
    }

    /// Returns the nanoseconds of a run, averaged over `repetitions`.
    ///
    /// # Errors
    ///
    /// The program does not know the case, or died.
    pub fn time(&mut self, case: &str, repetitions: u32) -> Result<f64, String> {
        let answer = self.ask(&format!("time {case} {repetitions}"))?;
        let total: f64 = answer.parse().map_err(|_| format!("no time: `{answer}`"))?;
        Ok(total / f64::from(repetitions))
    }

    /// Returns the words of the result.
    ///
    /// # Errors
    /// The program does not know the case, or died.
    pub fn result(&mut self, case: &str) -> Result<Vec<u64>, String> {
        let answer = self.ask(&format!("result {case}"))?;
        answer
            .split_whitespace()
            .map(|word| u64::from_str_radix(word, 16).map_err(|error| error.to_string()))
            .collect()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Summary of the rounds: quartiles of the times, and the median of the ratios to the first program.
#[derive(Clone, Copy, Debug)]
pub struct Times {
    /// Lower quartile, nanoseconds.
    pub low: f64,
    /// Median, nanoseconds.
    pub median: f64,
    /// Upper quartile, nanoseconds.
    pub high: f64,
    /// Median over the rounds of the first program's time divided by this one's.
    pub ratio: f64,
}

/// A fixed piece of work next to the rounds, which shows whether the processor is shared.
///
/// Another program on the same physical core uses its units, too: dense code then takes up to 1.6 times as long and
/// code that waits 1.2 times, so ratios would be wrong.
pub struct Reference {
    least: f64,
    rounds: u32,
    disturbed: u32,
}

/// No measurement yet.
impl Default for Reference {
    fn default() -> Reference {
        Reference { least: f64::INFINITY, rounds: 0, disturbed: 0 }
    }
}

impl Reference {
    /// Returns the present duration of the reference work relative to the shortest ever.
    fn disturbance(&mut self) -> f64 {
        // More sums than wait for each other: as dense as the processor takes them.
        let mut sums = [0.0f64; 24];
        let terms = std::hint::black_box([1.0; 24]);
        let start = Instant::now();
        for _ in 0..4000 {
            for (sum, term) in sums.iter_mut().zip(&terms) {
                *sum += term;
            }
        }
        std::hint::black_box(sums);
        let time = start.elapsed().as_secs_f64();
        self.least = self.least.min(time);
        time / self.least
    }

    /// Returns the number of rounds kept, and how many of them were disturbed.
    pub fn rounds(&self) -> [u32; 2] {
        [self.rounds, self.disturbed]
    }
}

/// Runs a case on every program alternately: gives the times of each, round by round. Of up to six times as many rounds, those are kept
/// in which the processor was shared least.
///
/// # Errors
/// A program does not know the case, or died.
pub fn race(
    servers: &mut [Server],
    case: &str,
    rounds: usize,
    reference: &mut Reference,
) -> Result<Vec<Vec<f64>>, String> {
    /// Duration of a sample, ns: long enough for the clock, short enough to be undisturbed.
    const SAMPLE: f64 = 200_000.0;
    /// Ratio below which a variation of the reference work is not a disturbance.
    const CALM: f64 = 1.1;
    let mut repetitions = Vec::new();
    for server in servers.iter_mut() {
        let once = server.time(case, 3)?;
        repetitions.push((SAMPLE / once).clamp(1.0, 20_000.0) as u32);
    }
    let mut taken: Vec<(f64, Vec<f64>)> = Vec::new();
    let mut calm = 0;
    while calm < rounds && taken.len() < 6 * rounds {
        let before = reference.disturbance();
        let mut times = Vec::new();
        for (server, repetitions) in servers.iter_mut().zip(&repetitions) {
            times.push(server.time(case, *repetitions)?);
        }
        let disturbance = before.max(reference.disturbance());
        calm += usize::from(disturbance <= CALM);
        taken.push((disturbance, times));
    }
    taken.sort_by(|a, b| a.0.total_cmp(&b.0));
    taken.truncate(rounds);
    reference.rounds += rounds as u32;
    reference.disturbed += taken.iter().filter(|(it, _)| *it > CALM).count() as u32;
    let of = |server: usize| taken.iter().map(|(_, times)| times[server]).collect();
    Ok((0..servers.len()).map(of).collect())
}

/// Returns the summary of each program's rounds, the first program's first.
pub fn summary(times: &[Vec<f64>]) -> Vec<Times> {
    let ratio = |own: &[f64]| {
        let ratios = times[0].iter().zip(own).map(|(first, own)| first / own).collect();
        quartiles(ratios)[1]
    };
    let summary = |own: &Vec<f64>| {
        let [low, median, high] = quartiles(own.clone());
        Times { low, median, high, ratio: ratio(own) }
    };
    times.iter().map(summary).collect()
}

fn quartiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    let at = |part: usize| values[(values.len() - 1) * part / 4];
    [at(1), at(2), at(3)]
}
