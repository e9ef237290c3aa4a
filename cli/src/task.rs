//! A command carried out in a folder.

use std::io::IsTerminal;
use std::path::Path;

use bessemer_project::{Wanted, generate, said};

use crate::args::{MessageFormat, Task};
use crate::error::Error;
use crate::{
    asap2, campaign, counterpart, doctor, dossier, explain, fmu, new, pack, python, sizes, vectors,
    verify,
};

/// The text to print, and whether all is well. `here` is the folder in which the command was called.
///
/// # Errors
/// Errors of the command.
pub fn perform(here: &Path, task: Task) -> Result<(String, bool), Error> {
    let colour = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    match task {
        Task::Gen(it) => {
            let wanted =
                Wanted { package: it.package.name(), check: it.check, explain: it.explain, colour };
            let for_tools = it.message_format == MessageFormat::Json;
            let said = said(generate(here, wanted), for_tools)?;
            anstream::eprint!("{}", said.remarks);
            Ok((said.text, said.good))
        }
        Task::Explain(it) => Ok((explain::run(here, &it, colour)?, true)),
        Task::Verify(it) => verify::run(here, &it, colour),
        Task::Dossier(it) => dossier::run(here, &it, colour),
        Task::Where(it) => Ok((counterpart::run(here, &it, colour)?, true)),
        Task::Sizes(it) => Ok((sizes::run(here, &it, colour)?, true)),
        Task::New(it) => Ok((new::run(here, &it)?, true)),
        Task::Pack(it) => Ok((pack::run(here, &it, colour)?, true)),
        Task::Fmu(it) => Ok((fmu::run(here, &it, colour)?, true)),
        Task::Vectors(it) => Ok((vectors::run(here, &it, colour)?, true)),
        Task::Py(it) => Ok((python::run(here, &it, colour)?, true)),
        Task::Campaign(it) => campaign::run(here, &it),
        Task::A2l(it) => Ok((asap2::run(here, &it, colour)?, true)),
        Task::Doctor(it) => Ok(doctor::run(here, it.package.name(), &doctor::ThisMachine)),
    }
}
