//! Under which conditions something was measured: what a figure says depends on who else was at work.

/// A measurement that has begun.
pub struct Conditions {
    load: String,
    before: Times,
}

/// Time of the processors by state since boot, hundredths of a second.
#[derive(Clone, Copy, Default)]
struct Times {
    busy: u64,
    idle: u64,
    /// While a program wanted a processor that the host of a virtual machine had given to another one.
    taken: u64,
}

impl Times {
    /// As Linux counts them; zeros elsewhere.
    fn now() -> Self {
        let stat = std::fs::read_to_string("/proc/stat").unwrap_or_default();
        let first = stat.lines().next().unwrap_or_default();
        let of: Vec<u64> = first.split_whitespace().filter_map(|it| it.parse().ok()).collect();
        // user nice system idle iowait irq softirq steal: proc_stat(5).
        let [user, nice, system, idle, waiting, irq, soft, taken, ..] = of[..] else {
            return Self::default();
        };
        Self { busy: user + nice + system + irq + soft, idle: idle + waiting, taken }
    }
}

impl Conditions {
    /// Looks at the machine before something is measured.
    pub fn begin() -> Self {
        let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
        let load = load.split(' ').next().unwrap_or("unknown").to_owned();
        Self { load, before: Times::now() }
    }

    /// Describes the load: number of processors, runnable programs in the last minute, and the use of the processors
    /// meanwhile.
    pub fn told(&self) -> String {
        let processors = std::thread::available_parallelism().map_or(0, usize::from);
        let build = if cfg!(debug_assertions) { "debug" } else { "release" };
        let (before, now) = (self.before, Times::now());
        let [busy, idle, taken] =
            [(now.busy, before.busy), (now.idle, before.idle), (now.taken, before.taken)]
                .map(|(now, before)| now.saturating_sub(before) as f64);
        let share = 100.0 * busy / (busy + idle + taken).max(1.0);
        format!(
            "{processors} processors, a load of {} before, a {build} build; meanwhile they were busy for {share:.0} % of the time, and the host took {:.0} ms\n",
            self.load,
            10.0 * taken
        )
    }
}
