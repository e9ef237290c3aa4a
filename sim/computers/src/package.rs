//! A package of models, compiled as `cargo bessemer` compiles it, and its entry points.

use std::io::{Read, Write};
use std::path::Path;

use bessemer_backend::c::Options;
use bessemer_codegen::compile;
use bessemer_codegen::generate;
use bessemer_ir::{FunctionId, Mode, Type};
use bessemer_legs::port::Port;
use bessemer_legs::toolchain::{self, Toolchain};
use bessemer_legs::{board, entries};
use bessemer_project::Project;

use crate::error::Error;
use crate::kept::{Boarded, Compiled, Interpreted, Kept};

/// A package of models, compiled.
pub struct Package {
    compiled: compile::Compiled,
    options: Options,
}

impl Package {
    /// Compiles the package of models around a folder; a test of that package passes `env!("CARGO_MANIFEST_DIR")`.
    ///
    /// This builds the package as `cargo bessemer gen` does, and writes nothing. It takes seconds, so compile once for many loops.
    ///
    /// # Errors
    ///
    /// There is no package of models, or it does not compile.
    pub fn find(folder: impl AsRef<Path>) -> Result<Self, Error> {
        let project = Project::find(folder.as_ref(), None, false)?;
        let mut job = project.job(false);
        // A firmware's own function at a fault does not return, and so reports nothing.
        job.options.hook = None;
        let compiled = generate::compiled(&job).map_err(bessemer_project::Error::from)?.compiled;
        Ok(Self { compiled, options: job.options })
    }

    /// Returns the entry point of a name, in the Rust (`Drive::step`) or in the C (`drive_step`).
    ///
    /// # Errors
    ///
    /// There is none, or it borrows a slice.
    pub fn entry(&self, name: &str) -> Result<Entry<'_>, Error> {
        let module = &self.compiled.module;
        let named = |id: &FunctionId| entries::named(module, &module.functions[id.index()]);
        let [id] = entries::chosen(&self.compiled, Some(name))[..] else {
            let known = entries::all(module).map(|id| named(&id)).collect();
            return Err(Error::NoEntry { name: name.to_owned(), known });
        };
        if !entries::can_call(&module.functions[id.index()]) {
            return Err(Error::Slice(named(&id)));
        }
        Ok(Entry { package: self, id })
    }

    /// Returns the sources of the firmware with which a board runs every entry point: names and texts. The board adds its startup and
    /// the three functions of `uart.h`. `cargo bessemer verify --board FOLDER` writes the same files.
    ///
    /// # Errors
    ///
    /// Two files would have one name.
    pub fn firmware(&self) -> Result<Vec<(String, String)>, Error> {
        Ok(board::sources(&self.compiled, &entries::callable(&self.compiled), &self.options)?)
    }
}

/// Returns the first compiler of C on this machine.
///
/// # Errors
///
/// There is none.
pub fn host() -> Result<Toolchain, Error> {
    toolchain::host().into_iter().next().ok_or(Error::NoCompiler)
}

/// An entry point of a package.
#[derive(Clone, Copy)]
pub struct Entry<'p> {
    package: &'p Package,
    id: FunctionId,
}

impl<'p> Entry<'p> {
    /// Runs the IR in the interpreter.
    pub fn interpreter(&self) -> Kept<Interpreted<'p>> {
        self.kept(Interpreted::new(&self.package.compiled.module, self.id))
    }

    /// Compiles the C and runs it as a process: by [`host`], or by a toolchain of an emulated processor.
    ///
    /// # Errors
    ///
    /// An error of the compiler or of the system.
    pub fn process(&self, toolchain: &Toolchain) -> Result<Kept<Compiled>, Error> {
        let Package { compiled, options } = self.package;
        let toolchain = toolchain.clone().of(options.standard);
        let params = compiled.module.functions[self.id.index()].params;
        let results = self.widths().iter().sum();
        let process = Compiled::start(compiled, options, (self.id, params), &toolchain, results)?;
        Ok(self.kept(process))
    }

    /// Runs the C on a board at the other end of a line, whose timeouts are those of the line.
    ///
    /// # Errors
    ///
    /// The board does not answer, or has other C.
    pub fn board<L: Read + Write>(&self, line: L) -> Result<Kept<Boarded<L>>, Error> {
        let compiled = &self.package.compiled;
        let places = entries::callable(compiled);
        let place = places.iter().position(|(id, _)| *id == self.id).unwrap_or(usize::MAX);
        let board = board::Board::open(line, board::identity(compiled))?;
        Ok(self.kept(Boarded::new(board, place)))
    }

    /// Runs the C on the board at a serial port, at `baud` bits a second.
    ///
    /// # Errors
    ///
    /// The port cannot be opened, or the board does not answer within 5 s, or has other C.
    pub fn port(&self, path: impl AsRef<Path>, baud: u32) -> Result<Kept<Boarded<Port>>, Error> {
        let path = path.as_ref();
        let failed = |source| Error::Port { path: path.to_owned(), source };
        self.board(Port::open(path, baud).map_err(failed)?)
    }

    /// Returns the numbers of words of the result, the component, and each changed argument.
    fn widths(&self) -> Vec<usize> {
        let module = &self.package.compiled.module;
        let function = &module.functions[self.id.index()];
        let (component, others) = function.parameters().split_at(1);
        let changed = others.iter().filter(|it| it.mode == Mode::RefMut);
        let parameters = component.iter().chain(changed).map(|it| module.width(&it.ty));
        std::iter::once(module.width(&function.result)).chain(parameters).collect()
    }

    fn kept<R>(&self, raw: R) -> Kept<R> {
        let module = &self.package.compiled.module;
        let function = &module.functions[self.id.index()];
        let widths: Vec<usize> =
            function.parameters().iter().map(|it| module.width(&it.ty)).collect();
        let component = function.parameters().first().map_or(Type::Unit, |it| it.ty.clone());
        Kept {
            raw,
            name: entries::named(module, function),
            state: entries::initial(module, &component),
            taken: widths.iter().skip(1).sum(),
            returned: module.width(&function.result),
        }
    }
}
