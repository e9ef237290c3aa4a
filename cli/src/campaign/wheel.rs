//! The campaign's program as a Python wheel: the compiled program, and a module that runs it by engines.
//!
//! The module runs the program as a process of its own. So a run that crashes ends no interpreter, and a wheel needs no
//! particular version of Python. The format is that of the Python Packaging Authority, "Binary distribution format".

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use sha2::{Digest as _, Sha256};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::error::Error;

const MODULE: &str = include_str!("../../templates/campaign/module.py");

/// Returns the name of the module.
pub fn module(package: &str) -> String {
    format!("{}_campaign", package.replace('-', "_"))
}

/// Returns the platform of a program that is built here, as wheels name it.
fn platform() -> String {
    let processor = std::env::consts::ARCH;
    match std::env::consts::OS {
        "macos" if processor == "aarch64" => "macosx_11_0_arm64".to_owned(),
        "macos" => format!("macosx_11_0_{processor}"),
        "windows" => "win_amd64".to_owned(),
        system => format!("{system}_{processor}"),
    }
}

/// Returns the version of a package as Python writes it: `0.1.0-beta.2` is `0.1.0b2`.
///
/// Any other pre-release becomes one of development.
fn version_in_python(version: &str) -> String {
    let plain = version.split('+').next().unwrap_or_default();
    let Some((base, before)) = plain.split_once('-') else { return plain.to_owned() };
    let (name, number) = before.split_once('.').unwrap_or((before, "0"));
    let letter = match name {
        "alpha" => "a",
        "beta" => "b",
        "rc" => "rc",
        _ => ".dev",
    };
    let number = if number.bytes().all(|it| it.is_ascii_digit()) { number } else { "0" };
    format!("{base}{letter}{number}")
}

/// Writes the wheel into a folder; returns its path.
///
/// # Errors
/// The program cannot be read, or the wheel not written.
pub fn write(
    folder: &Path,
    package: &str,
    version: &str,
    program: &Path,
) -> Result<PathBuf, Error> {
    let module = module(package);
    let version = version_in_python(version);
    let read = std::fs::read(program);
    let program = read.map_err(|source| Error::File { path: program.to_owned(), source })?;
    let tag = format!("py3-none-{}", platform());
    let path = folder.join(format!("{module}-{version}-{tag}.whl"));
    let failed = |source| Error::File { path: path.clone(), source };
    let about = format!("{module}-{version}.dist-info");
    let metadata = format!(
        "Metadata-Version: 2.1\nName: {module}\nVersion: {version}\nSummary: The campaign of {package}, compiled.\nRequires-Python: >=3.9\n\
         Provides-Extra: ray\nRequires-Dist: ray; extra == \"ray\"\nProvides-Extra: dask\nRequires-Dist: dask[distributed]; extra == \"dask\"\n"
    );
    let wheel =
        format!("Wheel-Version: 1.0\nGenerator: bessemer\nRoot-Is-Purelib: false\nTag: {tag}\n");
    let files: [(String, &[u8], u32); 5] = [
        (format!("{module}/__init__.py"), MODULE.as_bytes(), 0o644),
        (format!("{module}/__main__.py"), b"from . import main\n\nmain()\n", 0o644),
        (format!("{module}/program"), &program, 0o755),
        (format!("{about}/METADATA"), metadata.as_bytes(), 0o644),
        (format!("{about}/WHEEL"), wheel.as_bytes(), 0o644),
    ];
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let mut record = String::new();
    let mut add = |name: &str, bytes: &[u8], mode: u32| {
        let options = SimpleFileOptions::default()
            .compression_method(zip::CompressionMethod::Stored)
            .unix_permissions(mode);
        zip.start_file(name, options)?;
        zip.write_all(bytes)
    };
    for (name, bytes, mode) in &files {
        add(name, bytes, *mode).map_err(failed)?;
        let hash = URL_SAFE_NO_PAD.encode(Sha256::digest(bytes));
        let _ = writeln!(record, "{name},sha256={hash},{}", bytes.len());
    }
    let name = format!("{about}/RECORD");
    let _ = writeln!(record, "{name},,");
    add(&name, record.as_bytes(), 0o644).map_err(failed)?;
    let bytes = zip.finish().map_err(|error| failed(error.into()))?.into_inner();
    std::fs::create_dir_all(folder).map_err(failed)?;
    std::fs::write(&path, bytes).map_err(failed)?;
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read as _;

    /// A `-` in the version would end it in the name of the file.
    #[test]
    fn versions_have_pythons_form() {
        for (rust, python) in [
            ("0.1.0", "0.1.0"),
            ("1.2.3-alpha.4", "1.2.3a4"),
            ("1.2.3-rc.1+f00", "1.2.3rc1"),
            ("1.2.3-beta", "1.2.3b0"),
            ("1.2.3-night.x", "1.2.3.dev0"),
        ] {
            assert_eq!(version_in_python(rust), python, "{rust}");
        }
    }

    #[test]
    fn a_wheel_has_an_executable_program_and_a_record_of_each_file() {
        let folder = tempfile::tempdir().expect("a folder");
        let program = folder.path().join("campaign");
        std::fs::write(&program, "#!/bin/sh\n").expect("a program");
        let dist = folder.path().join("dist");
        let path = write(&dist, "my-convoy", "0.1.0", &program).expect("a wheel");
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        assert!(name.starts_with("my_convoy_campaign-0.1.0-py3-none-"), "{name}");
        let file = std::fs::File::open(&path).expect("the wheel");
        let mut wheel = zip::ZipArchive::new(file).expect("an archive");
        let program = wheel.by_name("my_convoy_campaign/program").expect("the program");
        assert_eq!(program.unix_mode().map(|mode| mode & 0o777), Some(0o755));
        drop(program);
        let mut record = String::new();
        let mut file = wheel.by_name("my_convoy_campaign-0.1.0.dist-info/RECORD").expect("it");
        file.read_to_string(&mut record).expect("a text");
        drop(file);
        for name in wheel.file_names() {
            assert!(record.lines().any(|line| line.starts_with(&format!("{name},"))), "{record}");
        }
        // The hash of the program, by sha256sum and base64.
        let line =
            "my_convoy_campaign/program,sha256=qAdtPSjSHgIBKyDq99v3VAmmJ3E0Q5Al8oLjaOMwWr8,10\n";
        assert!(record.contains(line), "{record}");
    }
}
