//! `cargo bessemer fmu`: an entry point as a co-simulation unit of FMI 3.0, with its sources and a library for this
//! machine.
//!
//! Data that an entry point borrows and that has a `…_defaults()` function becomes parameters. Other inputs become
//! inputs, results become outputs, and the component's state becomes local variables.
//!
//! Invariants: the unit runs the emitted C; the same C gives the same unit. It must not know what the C computes.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use bessemer_backend::c::interface::{Entry, Interface, Struct, Value};
use bessemer_backend::c::names::Passing;
use bessemer_codegen::compile::{Compiled, Options};
use bessemer_legs::process;
use bessemer_legs::toolchain::{CLANG, GCC};
use bessemer_project::{Wanted, build_files, compile};

use crate::args::Fmu;
use crate::error::Error;

/// The C around the entry point.
const GLUE: &str = include_str!("../templates/fmu/fmi3.c");

/// The places of the state and of what is returned by value, which no parameter has.
const STATE: &str = "fmu_state";
const RESULT: &str = "fmu_result";

/// Causality of a variable in FMI: the simulation sets inputs and parameters, the unit sets the others.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Causality {
    Input,
    Parameter,
    Output,
    Local,
}

/// A variable of the unit.
struct Variable<'f> {
    name: String,
    /// Place of the variable in the values of an instance.
    place: String,
    causality: Causality,
    value: &'f Value,
    docs: String,
    /// The start values of its elements, as words.
    start: Vec<u64>,
}

/// Writes the unit; where it is.
///
/// # Errors
/// Errors of the models or the system; an entry point that a unit cannot have; that there is no compiler.
pub fn run(folder: &Path, wanted: &Fmu, colour: bool) -> Result<String, Error> {
    let asked = Wanted { package: wanted.package.name(), colour, ..Wanted::default() };
    let period = wanted.period;
    if !(period.is_finite() && period > 0.0) {
        return Err(Error::Period);
    }
    let compilers = [GCC, CLANG];
    let compiler = compilers.into_iter().find(|it| it.is_there()).ok_or(Error::NoCompiler)?;
    let (project, compiled) = compile(folder, asked)?;
    let face = &compiled.interface;
    let entry = chosen(face, wanted.entry.as_deref())?;
    let name = entry.name.clone();
    let options = &project.settings.options;
    let compiler = compiler.of(options.standard);
    let failed_c = |said: String| Error::Compiler { name: compiler.name(), said };
    let variables = variables(face, entry)?;
    // The token that an importer compares is a checksum of the C, so that no unit takes another's state or parameters.
    let mut sum = crc32fast::Hasher::new();
    compiled.files.iter().for_each(|file| sum.update(file.text.as_bytes()));
    let token = format!("{{bessemer-{name}-{:08x}}}", sum.finalize());
    let glue = glue(&compiled, entry, &variables, (&token, period));

    let laid = process::lay_out(&compiled).map_err(|error| failed_c(error.to_string()))?;
    let in_folder = |file: &str| laid.path().join(file);
    let failed = |source| Error::File { path: wanted.output.clone(), source };
    let own = in_folder("fmi3_unit.c");
    std::fs::write(&own, &glue).map_err(failed)?;
    let library = in_folder("unit.so");
    let sources: Vec<_> = laid.sources().iter().cloned().chain([own]).collect();
    // The standard's header, which belongs to the importer, declares the functions of a unit; here nothing does.
    let flags = ["-shared", "-fPIC", "-fvisibility=hidden", "-Wno-missing-prototypes"];
    compiler.link(&sources, &library, &flags).map_err(failed_c)?;

    let names = compiled.files.iter().map(|file| file.name.as_str());
    let c: Vec<&str> = names.filter(|it| it.ends_with(".c")).chain(["fmi3_unit.c"]).collect();
    let binary = format!("binaries/{}/{name}.so", platform());
    let texts =
        compiled.files.iter().filter(|it| it.name.ends_with(".c") || it.name.ends_with(".h"));
    let mut files = vec![
        (
            "modelDescription.xml".to_owned(),
            description(&compiled, entry, &variables, (&token, period)).into_bytes(),
        ),
        ("sources/buildDescription.xml".to_owned(), build(&name, options, &c).into_bytes()),
        ("sources/fmi3_unit.c".to_owned(), glue.into_bytes()),
        (binary, std::fs::read(&library).map_err(failed)?),
    ];
    files.extend(texts.map(|it| (format!("sources/{}", it.name), it.text.clone().into_bytes())));
    std::fs::create_dir_all(&wanted.output).map_err(failed)?;
    let path = wanted.output.join(format!("{name}.fmu"));
    let packed = packed(&files).map_err(failed)?;
    std::fs::write(&path, packed).map_err(|source| Error::File { path: path.clone(), source })?;
    let count = variables.len();
    Ok(format!(
        "{}: {} with {count} variables, called every {period} s\n",
        path.display(),
        entry.rust
    ))
}

/// The folder of binaries for this machine.
fn platform() -> String {
    format!("{}-{}", std::env::consts::ARCH, std::env::consts::OS)
}

fn packed(files: &[(String, Vec<u8>)]) -> std::io::Result<Vec<u8>> {
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let options =
        zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    for (name, bytes) in files {
        zip.start_file(name, options)?;
        zip.write_all(bytes)?;
    }
    Ok(zip.finish()?.into_inner())
}

/// The entry point that is meant.
fn chosen<'f>(face: &'f Interface, name: Option<&str>) -> Result<&'f Entry, Error> {
    let known = || face.entries.iter().map(|it| it.rust.clone()).collect::<Vec<_>>();
    match (name, face.entries.as_slice()) {
        (None, [only]) => Ok(only),
        (None, _) => Err(Error::WhichEntry { known: known() }),
        (Some(name), entries) => {
            let found = entries.iter().find(|it| it.name == name || it.rust == name);
            found.ok_or_else(|| Error::NoEntry { name: name.to_owned(), known: known() })
        }
    }
}

/// The variables, in the order of the parameters; the state last.
fn variables<'f>(face: &'f Interface, entry: &'f Entry) -> Result<Vec<Variable<'f>>, Error> {
    let mut list = Vec::new();
    let (state, others) =
        entry.parameters.split_first().ok_or(Error::WhichEntry { known: Vec::new() })?;
    let named = others.iter().map(|it| (it.name.as_str(), it.passing, &it.value));
    let result = entry.result.iter().map(|value| (RESULT, Passing::Output, value));
    for (name, passing, value) in named.chain(result) {
        if value.dimensions.contains(&None) {
            return Err(Error::Slice { entry: entry.rust.clone(), name: name.to_owned() });
        }
        let of = face.structure(&value.ty);
        let causality = match (passing, of) {
            (Passing::Output | Passing::InOut, _) => Causality::Output,
            (_, Some(Struct { set_by: Some(_), component: false, .. })) => Causality::Parameter,
            _ => Causality::Input,
        };
        let shown = if name == RESULT { "result" } else { name };
        within(&mut list, face, (shown, name), causality, value, &entry.docs);
    }
    within(&mut list, face, ("", STATE), Causality::Local, &state.value, &[]);
    Ok(list)
}

/// The numbers of a value.
fn within<'f>(
    list: &mut Vec<Variable<'f>>,
    face: &'f Interface,
    (name, place): (&str, &str),
    causality: Causality,
    value: &'f Value,
    docs: &[String],
) {
    let Some(of) = face.structure(&value.ty) else {
        let count = elements(value);
        let docs = if causality == Causality::Output { docs.join(" ") } else { String::new() };
        let start = vec![0; count];
        let (name, place) = (name.to_owned(), place.to_owned());
        list.push(Variable { name, place, causality, value, docs, start });
        return;
    };
    let mut places = vec![String::new()];
    for count in &value.dimensions {
        let each = |place: &String| {
            (0..count.unwrap_or(0)).map(|at| format!("{place}[{at}]")).collect::<Vec<_>>()
        };
        places = places.iter().flat_map(each).collect();
    }
    for at in places {
        let mut words = of.words.iter().flatten().copied();
        for leaf in face.leaves(of) {
            let count = elements(leaf.value);
            let start = (0..count).map(|_| words.next().unwrap_or_default()).collect();
            let dot = if name.is_empty() { "" } else { "." };
            list.push(Variable {
                name: format!("{name}{at}{dot}{}", leaf.path),
                place: format!("{place}{at}.{}", leaf.path),
                causality,
                value: leaf.value,
                docs: leaf.docs.join(" "),
                start,
            });
        }
    }
}

fn elements(value: &Value) -> usize {
    value.dimensions.iter().map(|it| it.unwrap_or(0) as usize).product()
}

/// The type of a variable in FMI; an enum is an `int`.
fn kind(ty: &str) -> &'static str {
    match ty {
        "bool" => "Boolean",
        "float" => "Float32",
        "double" => "Float64",
        "int8_t" => "Int8",
        "int16_t" => "Int16",
        "int64_t" => "Int64",
        "uint8_t" => "UInt8",
        "uint16_t" => "UInt16",
        "uint32_t" => "UInt32",
        "uint64_t" => "UInt64",
        _ => "Int32",
    }
}

/// A word as the description has it: a number that reads back to the same bits.
fn shown(kind: &str, word: u64) -> String {
    match kind {
        "Boolean" => (word != 0).to_string(),
        "Float64" => number(f64::from_bits(word), |it| format!("{it:?}")),
        "Float32" => {
            let value = f32::from_bits(word as u32);
            number(f64::from(value), |_| format!("{value:?}"))
        }
        "UInt64" => word.to_string(),
        _ => (word as i64).to_string(),
    }
}

/// XML's words for what is no number.
fn number(value: f64, finite: impl Fn(f64) -> String) -> String {
    match value {
        it if it.is_nan() => "NaN".to_owned(),
        it if it.is_infinite() => if it > 0.0 { "INF" } else { "-INF" }.to_owned(),
        it => finite(it),
    }
}

fn glue(
    compiled: &Compiled,
    entry: &Entry,
    variables: &[Variable],
    (token, period): (&str, f64),
) -> String {
    let face = &compiled.interface;
    let mut headers = BTreeSet::from([entry.header.as_str()]);
    headers.extend(face.structs.iter().map(|it| it.header.as_str()));
    let includes: String = headers.iter().map(|it| format!("#include \"{it}\"\n")).collect();
    let (mut values, mut begin, mut passed) = (String::new(), String::new(), Vec::new());
    for (at, it) in entry.parameters.iter().enumerate() {
        let name = if at == 0 { STATE } else { it.name.as_str() };
        let counts: Vec<u32> = it.value.dimensions.iter().flatten().copied().collect();
        let dimensions: String = counts.iter().map(|count| format!("[{count}]")).collect();
        let _ = writeln!(values, "    {} {name}{dimensions};", it.value.ty);
        if let Some(set_by) = face.structure(&it.value.ty).and_then(|it| it.set_by.as_ref()) {
            let all: u32 = counts.iter().product();
            let first = "[0]".repeat(counts.len());
            let _ = match counts.len() {
                0 => writeln!(begin, "    {set_by}(&values->{name});"),
                _ => writeln!(
                    begin,
                    "    for (size_t i = 0U; i < {all}U; i++) {{\n        {set_by}(&(&values->{name}{first})[i]);\n    }}"
                ),
            };
        }
        let by_address = it.passing != Passing::Value && counts.is_empty();
        passed.push(format!("{}values->{name}", if by_address { "&" } else { "" }));
    }
    let call = format!("{}({})", entry.name, passed.join(", "));
    let body = match &entry.result {
        Some(value) => {
            let _ = writeln!(values, "    {} {RESULT};", value.ty);
            format!("    values->{RESULT} = {call};\n    return true;\n")
        }
        None if entry.status => format!("    return {call} == 0;\n"),
        None => format!("    {call};\n    return true;\n"),
    };
    let mut table = String::from(
        "    {FMU_FLOAT64, false, offsetof(fmu_values_t, fmu_time), sizeof(double), 1U},\n",
    );
    for it in variables {
        let kind = kind(&it.value.ty);
        let written = matches!(it.causality, Causality::Input | Causality::Parameter);
        let size = if kind == "Int32" { "int32_t" } else { it.value.ty.as_str() };
        let _ = writeln!(
            table,
            "    {{FMU_{}, {written}, offsetof(fmu_values_t, {}), sizeof({size}), {}U}},",
            kind.to_uppercase(),
            it.place,
            it.start.len()
        );
    }
    GLUE.replace("@LICENSE@", &compiled.license)
        .replace("@INCLUDES@", &includes)
        .replace("@TOKEN@", token)
        .replace("@PERIOD@", &format!("{period:?}"))
        .replace("@VALUES@", &values)
        .replace("@VARIABLES@", &table)
        .replace("@BEGIN@", &begin)
        .replace("@PERIOD_BODY@", &body)
}

fn description(
    compiled: &Compiled,
    entry: &Entry,
    variables: &[Variable],
    (token, period): (&str, f64),
) -> String {
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{}\" \
         instantiationToken=\"{token}\" description=\"{}\" license=\"{}\" generationTool=\"Bessemer\" \
         variableNamingConvention=\"structured\">\n  <CoSimulation modelIdentifier=\"{}\" canGetAndSetFMUState=\"true\" \
         canSerializeFMUState=\"true\" fixedInternalStepSize=\"{period:?}\"/>\n",
        escaped(&entry.rust),
        escaped(&entry.docs.join(" ")),
        escaped(&compiled.license),
        entry.name
    );
    let units: BTreeSet<&str> =
        variables.iter().filter_map(|it| it.value.unit.as_deref()).collect();
    if !units.is_empty() {
        text += "  <UnitDefinitions>\n";
        for unit in units {
            let _ = writeln!(text, "    <Unit name=\"{}\"/>", escaped(unit));
        }
        text += "  </UnitDefinitions>\n";
    }
    let taken = variables.iter().any(|it| it.name == "time");
    let time = if taken { "simulation_time" } else { "time" };
    let _ = write!(
        text,
        "  <DefaultExperiment stepSize=\"{period:?}\"/>\n  <ModelVariables>\n    \
         <Float64 name=\"{time}\" valueReference=\"0\" causality=\"independent\" variability=\"continuous\"/>\n"
    );
    let mut structure = String::new();
    for (reference, it) in (1..).zip(variables) {
        let kind = kind(&it.value.ty);
        let (causality, variability, starts) = match it.causality {
            Causality::Input => ("input", "discrete", true),
            Causality::Parameter => ("parameter", "tunable", true),
            Causality::Output => ("output", "discrete", false),
            Causality::Local => ("local", "discrete", false),
        };
        let _ = write!(
            text,
            "    <{kind} name=\"{}\" valueReference=\"{reference}\" causality=\"{causality}\" variability=\"{variability}\"",
            escaped(&it.name)
        );
        if !it.docs.is_empty() {
            let _ = write!(text, " description=\"{}\"", escaped(&it.docs));
        }
        if let (Some(unit), "Float32" | "Float64") = (&it.value.unit, kind) {
            let _ = write!(text, " unit=\"{}\"", escaped(unit));
        }
        if let (Some(range), "Float32" | "Float64") = (it.value.range, kind) {
            let _ = write!(text, " min=\"{:?}\" max=\"{:?}\"", range.low(), range.high());
        }
        if starts {
            let start: Vec<String> = it.start.iter().map(|word| shown(kind, *word)).collect();
            let _ = write!(text, " start=\"{}\"", start.join(" "));
        }
        if it.value.dimensions.is_empty() {
            text += "/>\n";
        } else {
            text += ">\n";
            for count in it.value.dimensions.iter().flatten() {
                let _ = writeln!(text, "      <Dimension start=\"{count}\"/>");
            }
            let _ = writeln!(text, "    </{kind}>");
        }
        if it.causality == Causality::Output {
            let _ = writeln!(structure, "    <Output valueReference=\"{reference}\"/>");
        }
    }
    for (reference, it) in (1..).zip(variables) {
        if it.causality == Causality::Output {
            let _ = writeln!(structure, "    <InitialUnknown valueReference=\"{reference}\"/>");
        }
    }
    text += "  </ModelVariables>\n  <ModelStructure>\n";
    text + &structure + "  </ModelStructure>\n</fmiModelDescription>\n"
}

fn build(name: &str, options: &Options, sources: &[&str]) -> String {
    let files: String =
        sources.iter().map(|it| format!("      <SourceFile name=\"{it}\"/>\n")).collect();
    let (language, flags) = (options.standard.iso(), build_files::flags(options));
    // Where headers have a folder of their own, they are named from that of the sources on.
    let include = match options.headers.is_empty() {
        true => "",
        false => "      <IncludeDirectory name=\".\"/>\n",
    };
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiBuildDescription fmiVersion=\"3.0\">\n  \
         <BuildConfiguration modelIdentifier=\"{name}\">\n    \
         <SourceFileSet language=\"{language}\" compilerOptions=\"{flags}\">\n{files}{include}    </SourceFileSet>\n  \
         </BuildConfiguration>\n</fmiBuildDescription>\n"
    )
}

fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\n' => escaped += " ",
            other => escaped.push(other),
        }
    }
    escaped
}
