//! POSIX threads, whose number is `BESSEMER_THREADS`: each of n threads computes every n-th part of a result's
//! columns.
//!
//! Invariant: one thread computes a column, exactly as it would alone, so the number of threads changes no bit.
//! Threads may allocate, so no kernel uses them unless it is compiled for that.

use super::text::fill;

const THREADS: &str = include_str!("threads.c");

/// A C function that computes a share of the work. Its last two parameters are the first part and the distance
/// between parts.
pub(super) struct Work<'a> {
    /// Name of the C function.
    pub name: &'a str,
    /// Parameters shared by the threads: types and names.
    pub shared: &'a [(&'a str, &'a str)],
    /// Parameter private to each thread, after the shared ones: type and name, the memory that a thread declares for
    /// it, and the passed value.
    pub own: Option<Own<'a>>,
}

/// Private memory of a thread.
pub(super) struct Own<'a> {
    pub ty: &'a str,
    pub name: &'a str,
    pub memory: &'a str,
    pub value: &'a str,
}

impl Work<'_> {
    /// Returns the function `by_threads`, and the code before it.
    pub fn text(&self) -> String {
        let own = self.own.iter();
        let parameters = self.shared.iter().copied().chain(own.clone().map(|it| (it.ty, it.name)));
        let parameters: Vec<String> = parameters.map(|(ty, name)| declared(ty, name)).collect();
        let members = self.shared.iter().map(|(ty, name)| format!("    {};\n", declared(ty, name)));
        let of_share = self.shared.iter().map(|(_, name)| format!("share->{name}"));
        let of_share: Vec<String> =
            of_share.chain(own.clone().map(|it| it.value.to_owned())).collect();
        let shared: Vec<&str> = self.shared.iter().map(|(_, name)| *name).collect();
        let memory = own.clone().map(|it| format!("    {}\n", it.memory));
        fill(
            THREADS,
            &[
                ("members", members.collect()),
                ("own", memory.collect()),
                ("work", self.name.to_owned()),
                ("of_share", of_share.join(", ")),
                ("parameters", parameters.join(", ")),
                ("shared", shared.join(", ")),
                ("arguments", self.arguments()),
            ],
        )
    }

    /// Returns the lines that compute the whole, by threads or without.
    pub fn call(&self) -> String {
        let (name, arguments) = (self.name, self.arguments());
        format!(
            "#if defined(BESSEMER_THREADS)\nby_threads({arguments});\n#else\n{name}({arguments}, 0U, 1U);\n#endif\n"
        )
    }

    fn arguments(&self) -> String {
        let shared = self.shared.iter().map(|(_, name)| *name);
        let all: Vec<&str> = shared.chain(self.own.iter().map(|it| it.name)).collect();
        all.join(", ")
    }
}

/// Returns a declaration, such as `const double *a`.
fn declared(ty: &str, name: &str) -> String {
    let gap = if ty.ends_with('*') { "" } else { " " };
    format!("{ty}{gap}{name}")
}
