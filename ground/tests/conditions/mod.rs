//! Under which conditions something was measured: what a figure says depends on who else was at work.

/// How many processors there are, and how many programs wanted one in the minute before.
pub fn conditions() -> String {
    let processors = std::thread::available_parallelism().map_or(0, usize::from);
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let before = load.split(' ').next().unwrap_or("unknown");
    let build = if cfg!(debug_assertions) { "debug" } else { "release" };
    format!("{processors} processors, a load of {before} before, a {build} build\n")
}
