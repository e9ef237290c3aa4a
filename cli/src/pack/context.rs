//! The data that the templates of a pack show: the package, its components and their entry points.
//!
//! Invariants: each variable of a pack has a name of its own; the same C gives the same data. It must not know any
//! system but by its [`Style`].

use std::collections::BTreeSet;

use bessemer_backend::c::interface::{Entry as Face, Interface, Parameter, Value};
use bessemer_backend::c::names::Passing;
use bessemer_codegen::compile::Compiled;
use bessemer_project::firmware::{Call, argument, calls, declared};
use bessemer_project::inputs::Inputs;
use bessemer_project::outputs::Outputs;
use bessemer_project::{Project, build_files};
use serde::Serialize;

use super::bridge::{Bridge, Mapped, Wrong};
use super::fields::{Field, Fields, camel, small, snake, unique};

/// Notation of a system for the fields of messages.
pub struct Style {
    /// Precedes a field that is read: `input.`.
    pub input: &'static str,
    /// Precedes a field that is written: `output.`.
    pub output: &'static str,
    /// Follows the name of a variable that lives as long as the firmware: `_` of a member.
    pub kept: &'static str,
    /// Fields that the system adds to each message.
    pub taken: &'static [&'static str],
    /// True if entry points can read and write topics of the system, as `bessemer.toml` maps them.
    pub bridges: bool,
}

/// Names of variables in the templates.
const LOCALS: &[&str] = &[
    "input",
    "output",
    "result",
    "status",
    "pipe",
    "buffer",
    "run",
    "id",
    "size",
    "message",
    "node",
    "support",
    "executor",
    "allocator",
    "i",
];

/// The package.
#[derive(Debug, Serialize)]
pub struct Package {
    /// Name of the package, in small letters.
    pub name: String,
    /// Name of the package in capitals.
    pub upper: String,
    /// Name of the package in capitalised words.
    pub class: String,
    /// Version of the package.
    pub version: String,
    /// The SPDX expression of the C.
    pub license: String,
    /// Flags of the compiler.
    pub flags: String,
    /// Flags of the compiler, one by one.
    pub flag_list: Vec<String>,
    /// Identifiers of the messages of each entry point, for a system without names.
    pub message_ids: Vec<MessageIds>,
    /// The sources of C.
    pub sources: Vec<String>,
    /// The headers of C.
    pub headers: Vec<String>,
    /// The headers that declare the entry points and their types.
    pub includes: Vec<String>,
    /// The components.
    pub components: Vec<Component>,
    /// True if an entry point reads and writes topics of the system.
    pub is_bridged: bool,
    /// Values that the pack leaves to its user.
    pub left_out: Vec<String>,
    /// The files for CMake and make, of systems without a format of their own.
    #[serde(skip)]
    pub build_files: Vec<(String, String)>,
}

/// Identifiers of the messages of an entry point.
#[derive(Debug, Serialize)]
pub struct MessageIds {
    /// The name of the entry point in capitals.
    pub upper: String,
    /// Identifier of its inputs.
    pub input: String,
    /// Identifier of its outputs.
    pub output: String,
}

/// A component.
#[derive(Debug, Serialize)]
pub struct Component {
    /// Name of the component in the C, without `_t`.
    pub name: String,
    /// Name of the component in capitals.
    pub upper: String,
    /// Name of the component in capitalised words.
    pub class: String,
    /// Name of the component in Rust.
    pub rust: String,
    /// Variables that live as long as the firmware.
    pub kept: Vec<Kept>,
    /// Kept variables that a function sets.
    pub begun: Vec<Kept>,
    /// Headers of its entry points.
    pub headers: Vec<String>,
    /// Topics whose headers the entry points need.
    pub topics: Vec<String>,
    /// True if an entry point reads and writes topics of the system.
    pub is_bridged: bool,
    /// Entry points of the component.
    pub entries: Vec<Entry>,
}

/// A variable that lives as long as the firmware.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Kept {
    /// Type of the variable.
    pub ty: String,
    /// Name of the variable.
    pub name: String,
    /// The function that sets it; none for the memory that calls work in.
    pub set_by: Option<String>,
}

/// An entry point.
#[derive(Debug, Serialize)]
pub struct Entry {
    /// Name of the entry point.
    pub name: String,
    /// Name of the entry point in capitals.
    pub upper: String,
    /// Name of the entry point in capitalised words.
    pub class: String,
    /// Name of the entry point in Rust.
    pub rust: String,
    /// The author's first line about it.
    pub docs: String,
    /// Header of the entry point.
    pub header: String,
    /// The name that PX4 and ROS derive from its message of inputs.
    pub input_topic: String,
    /// The name that PX4 and ROS derive from its message of outputs.
    pub output_topic: String,
    /// Bound of its stack, in bytes.
    pub stack_bytes: u64,
    /// Declarations of the variables of one call.
    pub locals: Vec<Local>,
    /// Conditions under which an input holds no enumerator.
    pub refused: Vec<String>,
    /// Statements that read the message of inputs.
    pub taken: Vec<String>,
    /// The call.
    pub call: String,
    /// The call from a member function of the same name.
    pub global_call: String,
    /// Statements that write the message of outputs.
    pub returned: Vec<String>,
    /// Fields of the message of inputs.
    pub inputs: Vec<Field>,
    /// Fields of the message of outputs.
    pub outputs: Vec<Field>,
    /// Places that no field holds.
    pub left_out: Vec<String>,
    /// The topics of the system that it reads and writes, if the author maps them.
    pub bridge: Option<Bridge>,
    /// True if a fault is returned as a status.
    pub has_status: bool,
    /// Definitions of static variables in an example.
    pub statics: String,
    /// Statements of an example that set them.
    pub begin: Vec<String>,
    /// Lines of an example for one period.
    pub period: Vec<String>,
}

/// A variable of one call.
#[derive(Debug, Serialize)]
pub struct Local {
    /// Declaration of the variable.
    pub line: String,
    /// Name of the variable.
    pub name: String,
}

/// The data of a package.
///
/// # Errors
/// A mistake in the mapping to topics.
pub fn package(project: &Project, compiled: &Compiled, style: &Style) -> Result<Package, Wrong> {
    let face = &compiled.interface;
    let name = compiled.module.name.replace('-', "_");
    let named = |end: &str| -> Vec<String> {
        let files = compiled.files.iter().filter(|it| it.name.ends_with(end));
        files.map(|it| it.name.clone()).collect()
    };
    let mut includes: Vec<String> = face.entries.iter().map(|it| it.header.clone()).collect();
    includes.extend(face.structs.iter().map(|it| it.header.clone()));
    includes.sort_unstable();
    includes.dedup();
    let mut variables: BTreeSet<String> = LOCALS.iter().map(|it| (*it).to_owned()).collect();
    let maps = if style.bridges { Maps::of(project, face)? } else { Maps::default() };
    let components = face
        .structs
        .iter()
        .filter(|it| it.component)
        .filter_map(|it| {
            component(compiled, (&it.name, &it.rust), (style, &maps), &mut variables).transpose()
        })
        .collect::<Result<Vec<Component>, Wrong>>()?;
    let mut left_out = Vec::new();
    for entry in components.iter().flat_map(|it| &it.entries) {
        for place in &entry.left_out {
            let why = "holds a value in some states only: fill or read it in code of your own";
            left_out.push(format!("`{place}` of `{}` {why}", entry.rust));
        }
    }
    let entries = components.iter().flat_map(|it| &it.entries);
    let message_ids = entries.zip((0x0980_u32..).step_by(2)).map(|(entry, first)| MessageIds {
        upper: entry.upper.clone(),
        input: format!("0x{first:04X}"),
        output: format!("0x{:04X}", first + 1),
    });
    let message_ids = message_ids.collect();
    let options = &project.settings.options;
    let flags = build_files::flags(options);
    let builds = build_files::files(compiled, options).into_iter();
    Ok(Package {
        upper: name.to_uppercase(),
        class: camel(&name),
        name,
        is_bridged: components.iter().any(|it| it.is_bridged),
        version: project.package.version.clone(),
        license: compiled.license.clone(),
        flag_list: flags.split(' ').map(str::to_owned).collect(),
        flags,
        message_ids,
        sources: named(".c"),
        headers: named(".h"),
        includes,
        components,
        left_out,
        build_files: builds.map(|it| (format!("src/{}", it.name), it.text)).collect(),
    })
}

/// The mapping to topics of the system.
#[derive(Default)]
struct Maps<'m> {
    inputs: &'m [Inputs],
    outputs: &'m [Outputs],
}

impl<'m> Maps<'m> {
    /// Returns the mapping of a package; each of its tables has an entry point.
    fn of(project: &'m Project, face: &Interface) -> Result<Self, Wrong> {
        let settings = &project.settings;
        let known: Vec<String> = calls(face).flat_map(|it| names(it.entry)).collect();
        for table in &settings.outputs {
            if !known.contains(&table.name) {
                let (line, name) = (table.line, table.name.clone());
                let known = calls(face).map(|it| format!("`{}`", it.entry.name));
                let known = known.collect::<Vec<_>>().join(", ");
                return Err(Wrong::Entry { line, name, known });
            }
        }
        Ok(Self { inputs: &settings.inputs, outputs: &settings.outputs })
    }

    /// Returns the bridge of an entry point with these fields; none if its outputs are not mapped.
    fn bridge(
        &self,
        entry: &Face,
        parameters: &[Field],
        results: &[Field],
    ) -> Result<Option<Bridge>, Wrong> {
        let names = names(entry);
        let outputs = names.iter().find_map(|name| self.outputs.iter().find(|it| it.name == *name));
        let inputs = names.iter().find_map(|name| self.inputs.iter().find(|it| it.name == *name));
        let mapped = outputs.map(|outputs| Mapped { inputs, outputs, parameters, results });
        mapped.map(|it| it.bridge()).transpose()
    }
}

/// Returns the names by which a table can be of an entry point: its own in C and in Rust, and its component's.
fn names(entry: &Face) -> Vec<String> {
    let component = entry.parameters.first().map(|it| it.value.ty.trim_end_matches("_t"));
    let component = component.map(str::to_owned);
    [entry.name.clone(), entry.rust.clone()].into_iter().chain(component).collect()
}

fn component(
    compiled: &Compiled,
    (ty, rust): (&str, &str),
    (style, maps): (&Style, &Maps<'_>),
    variables: &mut BTreeSet<String>,
) -> Result<Option<Component>, Wrong> {
    let face = &compiled.interface;
    let name = ty.strip_suffix("_t").unwrap_or(ty).to_owned();
    let mut kept: Vec<(String, Kept)> = Vec::new();
    let of = |it: &Call<'_>| it.entry.parameters.first().is_some_and(|it| it.value.ty == ty);
    let all: Vec<Call<'_>> = calls(face).filter(of).collect();
    // The names of all calls come first, so that a declaration of one call never hides them.
    for (at, parameter) in all.iter().flat_map(|it| it.entry.parameters.iter().enumerate()) {
        let (value, own) = (&parameter.value, if at == 0 { &name } else { &parameter.name });
        let known = kept.iter().any(|(known, it)| known == own && it.ty == value.ty);
        if lives_long(face, parameter) && !known {
            let set_by = face.structure(&value.ty).and_then(|it| it.set_by.clone());
            let name = unique(own, variables) + style.kept;
            kept.push((own.clone(), Kept { ty: value.ty.clone(), name, set_by }));
        }
    }
    let read = |it| entry(compiled, it, (&name, maps), (&kept, style, variables));
    let entries = all.iter().map(read).collect::<Result<Vec<Entry>, Wrong>>()?;
    let mut topics: Vec<String> = entries.iter().flat_map(topics).collect();
    topics.sort_unstable();
    topics.dedup();
    let mut headers: Vec<String> = entries.iter().map(|it| it.header.clone()).collect();
    headers.sort_unstable();
    headers.dedup();
    let kept: Vec<Kept> = kept.into_iter().map(|it| it.1).collect();
    let begun = kept.iter().filter(|it| it.set_by.is_some()).cloned().collect();
    let (upper, class) = (name.to_uppercase(), camel(&small(&name)));
    let rust = rust.rsplit("::").next().unwrap_or(rust).to_owned();
    let some = !entries.is_empty();
    let is_bridged = entries.iter().any(|it| it.bridge.is_some());
    let component =
        Component { is_bridged, name, upper, class, rust, kept, begun, headers, topics, entries };
    Ok(some.then_some(component))
}

/// Returns the topics whose headers an entry point needs.
fn topics(entry: &Entry) -> Vec<String> {
    let mut topics = vec![entry.output_topic.clone()];
    match &entry.bridge {
        Some(bridge) => {
            topics.extend(bridge.topics.iter().map(|it| it.name.clone()));
            topics.extend(bridge.messages.iter().map(|it| it.name.clone()));
        }
        None => topics.push(entry.input_topic.clone()),
    }
    topics
}

/// Returns true if a variable lives as long as the firmware: states, data with defaults, the memory that calls work in.
fn lives_long(face: &Interface, it: &Parameter) -> bool {
    let single = it.value.dimensions.is_empty();
    face.structure(&it.value.ty)
        .filter(|_| single)
        .is_some_and(|of| of.scratch || (of.set_by.is_some() && it.passing != Passing::Output))
}

fn entry(
    compiled: &Compiled,
    example: &Call<'_>,
    (component, maps): (&str, &Maps<'_>),
    (kept, style, variables): (&[(String, Kept)], &Style, &BTreeSet<String>),
) -> Result<Entry, Wrong> {
    let (face, own) = (&compiled.interface, example.entry);
    let mut variables = variables.clone();
    let mut inputs = Fields::new(face, style.taken);
    let mut outputs = Fields::new(face, style.taken);
    let (mut locals, mut arguments) = (Vec::new(), Vec::new());
    for (at, it) in own.parameters.iter().enumerate() {
        let own = if at == 0 { component } else { it.name.as_str() };
        let long = kept.iter().find(|(known, kept)| known == own && kept.ty == it.value.ty);
        let name = match long.filter(|_| lives_long(face, it)) {
            Some((_, kept)) => kept.name.clone(),
            None => {
                let name = unique(own, &mut variables);
                let line = declared(&name, &it.value);
                locals.push(Local { line, name: name.clone() });
                if it.passing != Passing::Output {
                    inputs.add(&name, own, &it.value);
                }
                if matches!(it.passing, Passing::Output | Passing::InOut) {
                    outputs.add(&name, own, &it.value);
                }
                name
            }
        };
        arguments.push(argument(it, &name));
    }
    let call = format!("{}({})", own.name, arguments.join(", "));
    let call = match (&own.result, own.status) {
        (Some(value), _) => {
            outputs.add("result", "result", value);
            format!("const {} result = {call};", value.ty)
        }
        (None, true) => {
            outputs.add("status", "status", &status());
            format!("const int32_t status = (int32_t){call};")
        }
        (None, false) => format!("{call};"),
    };
    let global_call = call.replacen(&format!("{}(", own.name), &format!("::{}(", own.name), 1);
    let class = camel(&small(&own.name));
    let mut left_out = inputs.left_out;
    left_out.extend(outputs.left_out);
    left_out.dedup();
    let stack = compiled.entries.iter().find(|it| it.entry == own.name);
    let bridge = maps.bridge(own, &inputs.all, &outputs.all)?;
    Ok(Entry {
        bridge,
        has_status: own.result.is_none() && own.status,
        upper: own.name.to_uppercase(),
        rust: own.rust.clone(),
        docs: first_line(own),
        header: own.header.clone(),
        input_topic: snake(&format!("{class}Input")),
        output_topic: snake(&format!("{class}Output")),
        stack_bytes: stack.map_or(0, |it| it.stack_bytes),
        locals,
        refused: inputs.all.iter().filter_map(|it| refused(it, style)).collect(),
        taken: inputs.all.iter().map(|it| taken(it, style)).collect(),
        call,
        global_call,
        returned: outputs.all.iter().map(|it| returned(it, style)).collect(),
        inputs: inputs.all,
        outputs: outputs.all,
        left_out,
        statics: example.statics(),
        begin: example.begin.clone(),
        period: example.period("").lines().map(str::to_owned).collect(),
        name: own.name.clone(),
        class,
    })
}

fn first_line(entry: &Face) -> String {
    entry.docs.first().unwrap_or(&entry.rust).trim().to_owned()
}

/// The value of a status: a number.
fn status() -> Value {
    Value {
        ty: "int32_t".to_owned(),
        dimensions: Vec::new(),
        matrix: None,
        unit: None,
        range: None,
    }
}

/// The condition under which a field holds no enumerator.
fn refused(field: &Field, style: &Style) -> Option<String> {
    let (_, values) = field.choice.as_ref()?;
    let each = values.iter().map(|it| format!("({}{} != {it})", style.input, field.name));
    Some(each.collect::<Vec<_>>().join(" && "))
}

fn taken(field: &Field, style: &Style) -> String {
    let Field { name, place, .. } = field;
    let from = style.input;
    match (&field.choice, field.count) {
        (Some((ty, _)), _) => format!("{place} = ({ty}){from}{name};"),
        (None, None) => format!("{place} = {from}{name};"),
        (None, Some(count)) => each_element(count, &format!("{place}[i] = {from}{name}[i];")),
    }
}

fn returned(field: &Field, style: &Style) -> String {
    let Field { name, place, .. } = field;
    let to = style.output;
    match (&field.choice, field.count) {
        (Some(_), _) => format!("{to}{name} = (int32_t){place};"),
        (None, None) => format!("{to}{name} = {place};"),
        (None, Some(count)) => each_element(count, &format!("{to}{name}[i] = {place}[i];")),
    }
}

fn each_element(count: u32, statement: &str) -> String {
    format!("for (uint32_t i = 0U; i < {count}U; i++) {{ {statement} }}")
}
