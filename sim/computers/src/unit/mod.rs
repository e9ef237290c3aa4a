//! A co-simulation unit of FMI 3.0 as a leg. Its library runs in a process of its own, so that nothing here is `unsafe` and no unit ends
//! the test.
//!
//! Must not know: who made the unit.

mod description;

use std::io::{BufReader, BufWriter, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use bessemer_legs::process;
use tempfile::TempDir;

use crate::error::Error;
use crate::leg::Leg;
use crate::package::host;
use description::{Description, Variable};

/// The program around a unit's library.
const HOST: &str = include_str!("host.c");

/// Longest message of a unit, bytes.
const LONGEST: u64 = 4096;

/// A co-simulation unit of FMI 3.0.
///
/// A call takes the words of each input and parameter, and returns those of each output, in the order of the unit's description. A
/// unit of `cargo bessemer fmu` so takes the arguments of its entry point. The word of an enumeration is the index of
/// its item. A call sets the inputs, advances the unit by one period, and reads the outputs.
#[derive(Debug)]
pub struct Unit {
    child: Child,
    input: BufWriter<ChildStdin>,
    output: BufReader<ChildStdout>,
    name: String,
    inputs: Vec<Variable>,
    outputs: Vec<Variable>,
    /// Words of the first call.
    first: Option<Vec<u64>>,
    period: u64,
    // Holds the program and the unit's files while it runs.
    _folder: TempDir,
}

impl Unit {
    /// Starts the unit at a path, a `.fmu` or a folder with its files, with calls every `period` s. A C compiler compiles the
    /// small program around it.
    ///
    /// # Errors
    ///
    /// The unit cannot be read, is not of FMI 3.0 for co-simulation, has no library for this machine, or recommends
    /// another period.
    pub fn open(path: impl AsRef<Path>, period: f64) -> Result<Self, Error> {
        let path = path.as_ref();
        let wrong = |why: String| Error::Unit { path: path.to_owned(), why };
        let folder = tempfile::tempdir().map_err(process::Error::Io)?;
        let files = if path.is_dir() {
            path.to_owned()
        } else {
            let files = folder.path().join("unit");
            unpack(path, &files).map_err(wrong)?;
            files
        };
        let text = std::fs::read_to_string(files.join("modelDescription.xml"))
            .map_err(|why| wrong(format!("modelDescription.xml: {why}; is it a unit?")))?;
        let description = description::read(&text).map_err(wrong)?;
        if let Some(step) = description.step
            && (step - period).abs() > 1e-9 * step.abs()
        {
            return Err(wrong(format!("its step is {step} s, not {period} s; pass that period")));
        }
        let Description { library, token, inputs, outputs, .. } = description;
        let system = match std::env::consts::OS {
            "macos" => "darwin",
            other => other,
        };
        let platform = format!("{}-{system}", std::env::consts::ARCH);
        let ending = std::env::consts::DLL_SUFFIX;
        let binary = files.join("binaries").join(&platform).join(format!("{library}{ending}"));
        if !binary.is_file() {
            return Err(wrong(format!(
                "it has no library for {platform}; build it from its sources, or export it on this machine"
            )));
        }
        let (source, program) = (folder.path().join("host.c"), folder.path().join("host"));
        std::fs::write(&source, HOST).map_err(process::Error::Io)?;
        let compiler = host()?;
        compiler.link(&[source], &program, &["-ldl"]).map_err(process::Error::Compile)?;
        let mut command = Command::new(&program);
        let resources = files.join("resources");
        let resources = format!("{}/", resources.canonicalize().unwrap_or(resources).display());
        command.arg(binary.canonicalize().unwrap_or(binary)).arg(&token).arg(resources);
        let command = command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().map_err(process::Error::Io)?;
        let (Some(input), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(wrong("the process has no pipes".to_owned()));
        };
        let (input, output) = (BufWriter::new(input), BufReader::new(output));
        let (name, _folder) = (library, folder);
        let mut unit =
            Self { child, input, output, name, inputs, outputs, first: None, period: 0, _folder };
        let words = unit.layout(period);
        unit.send(&words)?;
        Ok(unit)
    }

    /// Returns the names of inputs and parameters, in the order of a call's words, with the number of words of each.
    pub fn inputs(&self) -> impl Iterator<Item = (&str, usize)> {
        self.inputs.iter().map(|it| (it.name.as_str(), it.elements))
    }

    /// Returns the names of the outputs, in the order of the result's words, with the number of words of each.
    pub fn outputs(&self) -> impl Iterator<Item = (&str, usize)> {
        self.outputs.iter().map(|it| (it.name.as_str(), it.elements))
    }

    /// Returns the words from which the process knows what to set and what to read.
    fn layout(&self, period: f64) -> Vec<u64> {
        let mut words = vec![period.to_bits(), self.inputs.len() as u64];
        for it in &self.inputs {
            let fixed = u64::from(it.is_fixed);
            words.extend([it.kind as u64, it.reference.into(), it.elements as u64, fixed]);
        }
        words.push(self.outputs.len() as u64);
        for it in &self.outputs {
            words.extend([it.kind as u64, it.reference.into(), it.elements as u64]);
        }
        words
    }

    fn failed(&self, said: impl Into<String>) -> Error {
        Error::UnitFailed { period: self.period, said: said.into() }
    }

    fn send(&mut self, words: &[u64]) -> Result<(), Error> {
        let sent = words.iter().try_for_each(|word| self.input.write_all(&word.to_le_bytes()));
        match sent.and_then(|()| self.input.flush()) {
            Ok(()) => Ok(()),
            // It may have said why before it ended.
            Err(_) => Err(self.receive().err().unwrap_or_else(|| self.failed("it ended"))),
        }
    }

    fn word(&mut self) -> Result<u64, Error> {
        let mut bytes = [0; 8];
        match self.output.read_exact(&mut bytes) {
            Ok(()) => Ok(u64::from_le_bytes(bytes)),
            Err(_) => {
                let status = self.child.wait().map_err(process::Error::Io)?;
                Err(self.failed(format!("its process ended: {status}")))
            }
        }
    }

    /// Receives the words of the outputs.
    fn receive(&mut self) -> Result<Vec<u64>, Error> {
        let status = self.word()?;
        if status > 0 {
            let bytes = (0..(status - 1).min(LONGEST)).map(|_| self.word().map(|it| it as u8));
            let bytes: Vec<u8> = bytes.collect::<Result<_, _>>()?;
            return Err(self.failed(String::from_utf8_lossy(&bytes)));
        }
        let count = self.outputs.iter().map(|it| it.elements).sum();
        let mut words = (0..count).map(|_| self.word()).collect::<Result<Vec<_>, _>>()?;
        let mut rest = words.as_mut_slice();
        for it in &self.outputs {
            let (own, behind) = rest.split_at_mut(it.elements);
            rest = behind;
            let Some(items) = &it.items else { continue };
            for word in own {
                let value = *word as i64;
                let Some(index) = items.iter().position(|item| *item == value) else {
                    return Err(
                        self.failed(format!("`{}` is {value}, which is no item of it", it.name))
                    );
                };
                *word = index as u64;
            }
        }
        Ok(words)
    }

    /// Checks a call, and turns indices of items into their values.
    fn values(&mut self, arguments: &[u64]) -> Result<Vec<u64>, Error> {
        let (found, wanted) = (arguments.len(), self.inputs.iter().map(|it| it.elements).sum());
        if found != wanted {
            return Err(Error::Words { name: self.name.clone(), found, wanted });
        }
        let first = self.first.get_or_insert_with(|| arguments.to_vec()).clone();
        let mut words = arguments.to_vec();
        let mut at = 0;
        for it in &self.inputs {
            let own = at..at + it.elements;
            at = own.end;
            if it.is_fixed && arguments[own.clone()] != first[own.clone()] {
                let said = format!("the parameter `{}` is fixed; keep its first value", it.name);
                return Err(self.failed(said));
            }
            let Some(items) = &it.items else { continue };
            for word in &mut words[own] {
                let value = usize::try_from(*word).ok().and_then(|index| items.get(index));
                let Some(value) = value else {
                    let said = format!("`{}` has no item {word}; they count from 0", it.name);
                    return Err(self.failed(said));
                };
                *word = *value as u64;
            }
        }
        Ok(words)
    }
}

impl Leg for Unit {
    fn call(&mut self, arguments: &[u64]) -> Result<Vec<u64>, Error> {
        let words = self.values(arguments)?;
        self.send(&words)?;
        let result = self.receive()?;
        self.period += 1;
        Ok(result)
    }
}

impl Drop for Unit {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Unpacks a unit's archive into a folder.
fn unpack(path: &Path, folder: &PathBuf) -> Result<(), String> {
    let file = std::fs::File::open(path).map_err(|why| why.to_string())?;
    let mut archive = zip::ZipArchive::new(file).map_err(|why| format!("{why}; is it a unit?"))?;
    archive.extract(folder).map_err(|why| match why {
        zip::result::ZipError::UnsupportedArchive(_) | zip::result::ZipError::CompressionMethodNotSupported(_) => {
            "its files are compressed; unpack it and pass the folder, or enable the feature `deflate`".to_owned()
        }
        why => why.to_string(),
    })
}
