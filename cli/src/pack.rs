//! `cargo bessemer pack`: the C as a module of Zephyr, a module of PX4 or a library of Arduino, each a folder of its own with
//! an example for each component.
//!
//! Invariants: the folder is whole by itself; the same C gives the same folder. It must not know what the C computes.

use std::fmt::Write as _;
use std::path::Path;

use bessemer_codegen::c::interface::{Entry, Interface, Value};
use bessemer_codegen::c::names::Passing;
use bessemer_codegen::compile::Compiled;
use bessemer_project::{Wanted, compile};

use crate::args::{Pack, System};
use crate::error::Error;

/// Flags that the C needs for the bits of the Rust.
const FLAGS: &str = "-std=c99 -ffp-contract=off";

/// Writes the folder; where it is.
///
/// # Errors
/// Errors of the models or the system; [`Error::Exists`] if the folder is there already.
pub fn run(folder: &Path, wanted: &Pack, colour: bool) -> Result<String, Error> {
    let asked = Wanted { package: wanted.package.name(), colour, ..Wanted::default() };
    let (_, compiled) = compile(folder, asked)?;
    let name = compiled.module.name.replace('-', "_");
    let place = wanted.output.join(&name);
    if place.symlink_metadata().is_ok() {
        return Err(Error::Exists { folder: place });
    }
    let sources =
        compiled.files.iter().filter(|it| it.name.ends_with(".c") || it.name.ends_with(".h"));
    let mut files: Vec<(String, String)> =
        sources.map(|it| (format!("src/{}", it.name), it.text.clone())).collect();
    files.extend(match wanted.system {
        System::Zephyr => zephyr(&name, &compiled),
        System::Px4 => px4(&name, &compiled),
        System::Arduino => arduino(&name, &compiled),
    });
    for (path, text) in &files {
        let path = place.join(path);
        let failed = |source| Error::File { path: path.clone(), source };
        std::fs::create_dir_all(path.parent().unwrap_or(&place)).map_err(failed)?;
        std::fs::write(&path, text).map_err(failed)?;
    }
    Ok(format!("{}: {} files\n", place.display(), files.len()))
}

/// An entry point as firmware calls it.
struct Call<'f> {
    entry: &'f Entry,
    /// The variables that live as long as the firmware: the state, and data with defaults.
    kept: Vec<(&'f str, &'f Value)>,
    /// The others, which come new in each period, or leave in it.
    passing: Vec<(&'f str, &'f Value, Passing)>,
    /// The statements that set those that are kept.
    begin: Vec<String>,
}

/// The entry points that can be called without a length that only their caller knows.
fn calls(face: &Interface) -> impl Iterator<Item = Call<'_>> {
    let fixed = |it: &&Entry| it.parameters.iter().all(|it| !it.value.dimensions.contains(&None));
    face.entries.iter().filter(fixed).map(|entry| {
        let (mut kept, mut passing, mut begin) = (Vec::new(), Vec::new(), Vec::new());
        for it in &entry.parameters {
            let set_by = face.structure(&it.value.ty).and_then(|it| it.set_by.as_ref());
            match set_by.filter(|_| it.value.dimensions.is_empty() && it.passing != Passing::Output)
            {
                Some(set_by) => {
                    begin.push(format!("{set_by}(&{});", it.name));
                    kept.push((it.name.as_str(), &it.value));
                }
                None => passing.push((it.name.as_str(), &it.value, it.passing)),
            }
        }
        Call { entry, kept, passing, begin }
    })
}

/// `double place[3]`.
fn declared(name: &str, value: &Value) -> String {
    let dimensions: String =
        value.dimensions.iter().flatten().map(|count| format!("[{count}]")).collect();
    format!("{} {name}{dimensions}", value.ty)
}

impl Call<'_> {
    /// The call itself, with what it gives in `result`.
    fn text(&self) -> String {
        let arguments = self.entry.parameters.iter().map(|it| {
            let by_address = it.passing != Passing::Value && it.value.dimensions.is_empty();
            format!("{}{}", if by_address { "&" } else { "" }, it.name)
        });
        let call = format!("{}({})", self.entry.name, arguments.collect::<Vec<_>>().join(", "));
        match (&self.entry.result, self.entry.status) {
            (Some(value), _) => format!("const {} result = {call};", value.ty),
            (None, true) => format!("const int status = (int){call};"),
            (None, false) => format!("{call};"),
        }
    }

    /// The definitions of the static variables that a call uses.
    fn statics(&self) -> String {
        self.kept
            .iter()
            .map(|(name, value)| format!("static {};\n", declared(name, value)))
            .collect()
    }

    /// The statements of one period: inputs, the call, what to do with its results. `indent` begins each line.
    fn period(&self, indent: &str) -> String {
        let mut text = String::new();
        for (name, value, passing) in &self.passing {
            let said = match passing {
                Passing::Output => "It goes to your actuators.",
                _ => "It comes from your sensors.",
            };
            let unit =
                value.unit.as_ref().map(|unit| format!(" Unit: {unit}.")).unwrap_or_default();
            let zero = if is_number(value) { " = 0" } else { "" };
            let line = declared(name, value);
            let _ = writeln!(text, "{indent}/* {said}{unit} */\n{indent}static {line}{zero};");
        }
        let _ = writeln!(text, "{indent}{}", self.text());
        let given = match (&self.entry.result, self.entry.status) {
            (Some(value), _) => {
                let unit = value.unit.as_ref().map(|unit| format!(" Unit: {unit}."));
                Some(("result", format!("It goes to your actuators.{}", unit.unwrap_or_default())))
            }
            (None, true) => {
                Some(("status", "Other than 0 it names a fault: stop safely.".to_owned()))
            }
            (None, false) => None,
        };
        if let Some((name, said)) = given {
            let _ = writeln!(text, "{indent}/* {said} */\n{indent}(void){name};");
        }
        text
    }
}

/// Whether a value is one number, and no enum or struct.
fn is_number(value: &Value) -> bool {
    let known = ["bool", "float", "double"].contains(&value.ty.as_str());
    value.dimensions.is_empty() && (known || value.ty.contains("int"))
}

fn head(name: &str, compiled: &Compiled, said: &str, comment: &str) -> String {
    format!(
        "{comment} {said} {name}.\n{comment}\n{comment} Generated by Bessemer.\n{comment} SPDX-License-Identifier: {}\n",
        compiled.license
    )
}

fn main(call: &Call, around: &str, wait: &str) -> String {
    let begin: String = call.begin.iter().map(|it| format!("    {it}\n")).collect();
    format!(
        "/* An example of the firmware around {}: replace what is marked. */\n{around}#include \"{}\"\n\n{}\n\
         int main(void)\n{{\n{begin}    for (;;) {{\n{}        {wait}\n    }}\n}}\n",
        call.entry.rust,
        call.entry.header,
        call.statics(),
        call.period("        ")
    )
}

fn zephyr(name: &str, compiled: &Compiled) -> Vec<(String, String)> {
    let upper = name.to_uppercase();
    let c = compiled.files.iter().filter(|it| it.name.ends_with(".c"));
    let sources: String = c.map(|it| format!("    src/{}\n", it.name)).collect();
    let top = head(name, compiled, "The C of", "#");
    let mut files = vec![
        (
            "zephyr/module.yml".to_owned(),
            format!("{top}name: {name}\nbuild:\n  cmake: .\n  kconfig: Kconfig\n"),
        ),
        (
            "Kconfig".to_owned(),
            format!(
                "{top}config {upper}\n\tbool \"The controllers of {name}\"\n\thelp\n\t  Builds what Bessemer made of {name}.\n"
            ),
        ),
        (
            "CMakeLists.txt".to_owned(),
            format!(
                "{top}if(CONFIG_{upper})\n  zephyr_library_named({name})\n  zephyr_include_directories(src)\n  \
                 zephyr_library_sources(\n{sources}  )\n  # The bits of the Rust.\n  \
                 zephyr_library_compile_options({FLAGS})\nendif()\n"
            ),
        ),
    ];
    for call in calls(&compiled.interface) {
        let wait = "k_msleep(1); /* Your control period. */";
        let text = main(&call, "#include <zephyr/kernel.h>\n\n", wait);
        files.push((format!("examples/{}/src/main.c", call.entry.name), text));
    }
    files
}

fn arduino(name: &str, compiled: &Compiled) -> Vec<(String, String)> {
    let headers: Vec<&str> = headers(&compiled.interface);
    let includes: String = headers.iter().map(|it| format!("#include \"{it}\"\n")).collect();
    let mut files = vec![
        (
            "library.properties".to_owned(),
            format!(
                "name={name}\nversion=0.0.0\nauthor=Bessemer\nmaintainer=Bessemer\nsentence=Controllers of {name}.\n\
                 paragraph=C99 that Bessemer made of Rust. Needs an FPU of double precision, or f32 in the models.\n\
                 category=Device Control\nurl=\narchitectures=*\nincludes={name}_all.h\n"
            ),
        ),
        (
            format!("src/{name}_all.h"),
            format!("{}#pragma once\n\n{includes}", head(name, compiled, "All of", "//")),
        ),
    ];
    for call in calls(&compiled.interface) {
        let begin: String = call.begin.iter().map(|it| format!("    {it}\n")).collect();
        let text = format!(
            "// An example of the firmware around {}: replace what is marked.\n#include <{name}_all.h>\n\n{}\nvoid setup()\n{{\n\
             {begin}}}\n\nvoid loop()\n{{\n{}    delay(1); // Your control period, ms.\n}}\n",
            call.entry.rust,
            call.statics(),
            call.period("    ")
        );
        let of = &call.entry.name;
        files.push((format!("examples/{of}/{of}.ino"), text));
    }
    files
}

/// The headers of the entry points and of what they take.
fn headers(face: &Interface) -> Vec<&str> {
    let mut headers: Vec<&str> = face.entries.iter().map(|it| it.header.as_str()).collect();
    headers.extend(face.structs.iter().map(|it| it.header.as_str()));
    headers.sort_unstable();
    headers.dedup();
    headers
}

/// The type of a number in a message of uORB.
fn message_type(ty: &str) -> Option<&'static str> {
    Some(match ty {
        "bool" => "bool",
        "float" => "float32",
        "double" => "float64",
        "int8_t" => "int8",
        "int16_t" => "int16",
        "int32_t" => "int32",
        "int64_t" => "int64",
        "uint8_t" => "uint8",
        "uint16_t" => "uint16",
        "uint32_t" => "uint32",
        "uint64_t" => "uint64",
        _ => return None,
    })
}

/// `motor_step` as `MotorStep`.
fn camel(name: &str) -> String {
    let words = name.split('_').filter(|it| !it.is_empty());
    words.map(|it| it[..1].to_uppercase() + &it[1..]).collect()
}

fn px4(name: &str, compiled: &Compiled) -> Vec<(String, String)> {
    let c = compiled.files.iter().filter(|it| it.name.ends_with(".c"));
    let sources: String = c.map(|it| format!("\t\tsrc/{}\n", it.name)).collect();
    let (upper, top) = (name.to_uppercase(), head(name, compiled, "The C of", "#"));
    let mut files = vec![(
        "Kconfig".to_owned(),
        format!(
            "{top}menuconfig MODULES_{upper}\n\tbool \"{name}\"\n\tdefault n\n\t---help---\n\t\tBuilds what Bessemer made of {name}.\n"
        ),
    )];
    let mut cmake = format!(
        "{top}px4_add_library({name}_c\n{sources})\ntarget_include_directories({name}_c PUBLIC src)\n\
         # The bits of the Rust.\ntarget_compile_options({name}_c PRIVATE {FLAGS})\n"
    );
    for call in calls(&compiled.interface) {
        let of = &call.entry.name;
        let class = camel(of);
        let _ = write!(
            cmake,
            "px4_add_module(\n\tMODULE modules__{name}__{of}\n\tMAIN {of}\n\tSRCS {class}Module.cpp\n\tDEPENDS {name}_c\n)\n"
        );
        let (module, input, output) = module(&call, &class);
        files.push((format!("{class}Module.cpp"), module));
        files.push((format!("msg/{class}Input.msg"), input));
        files.push((format!("msg/{class}Output.msg"), output));
    }
    files.push(("CMakeLists.txt".to_owned(), cmake));
    files
}

/// A module of PX4 around an entry point, and the messages that it reads and writes.
fn module(call: &Call, class: &str) -> (String, String, String) {
    let of = &call.entry.name;
    let time = "uint64 timestamp # time since system start (microseconds)\n";
    let (mut input, mut output) = (time.to_owned(), time.to_owned());
    let (mut locals, mut taken, mut given) = (String::new(), String::new(), String::new());
    for (name, value, passing) in &call.passing {
        let _ = writeln!(locals, "\t\t{}{{}};", declared(name, value));
        let counts: Vec<u32> = value.dimensions.iter().flatten().copied().collect();
        let unit = value.unit.as_ref().map(|unit| format!(" # [{unit}]")).unwrap_or_default();
        let (Some(ty), [] | [_]) = (message_type(&value.ty), counts.as_slice()) else {
            let _ = writeln!(taken, "\t\t// `{name}`: fill it from the topics of your own.");
            continue;
        };
        let array: String = counts.iter().map(|count| format!("[{count}]")).collect();
        if *passing != Passing::Output {
            let _ = writeln!(input, "{ty}{array} {name}{unit}");
            let _ = match counts.first() {
                None => writeln!(taken, "\t\t{name} = input.{name};"),
                Some(_) => writeln!(taken, "\t\tmemcpy({name}, input.{name}, sizeof({name}));"),
            };
        }
        if matches!(passing, Passing::Output | Passing::InOut) {
            let _ = writeln!(output, "{ty}{array} {name}{unit}");
            let _ = match counts.first() {
                None => writeln!(given, "\t\toutput.{name} = {name};"),
                Some(_) => writeln!(given, "\t\tmemcpy(output.{name}, {name}, sizeof({name}));"),
            };
        }
    }
    match (&call.entry.result, call.entry.status) {
        (Some(value), _) => {
            let ty = message_type(&value.ty).unwrap_or("int32");
            let _ = writeln!(output, "{ty} result");
            given += "\t\toutput.result = result;\n";
        }
        (None, true) => {
            output += "int32 status # other than 0 it names a fault\n";
            given += "\t\toutput.status = status;\n";
        }
        (None, false) => {}
    }
    let kept: String = call
        .kept
        .iter()
        .map(|(name, value)| format!("\t{} {{}};\n", declared(name, value)))
        .collect();
    let kept = kept.replace(" {};", "{};");
    let begin: String = call.begin.iter().map(|it| format!("\t\t{it}\n")).collect();
    let text = format!(
        r#"// A module of PX4 around {rust}: it runs when {of}_input is published, and publishes {of}_output.
#include <string.h>

#include <px4_platform_common/module.h>
#include <px4_platform_common/px4_work_queue/WorkItem.hpp>
#include <uORB/Publication.hpp>
#include <uORB/SubscriptionCallback.hpp>
#include <uORB/topics/{of}_input.h>
#include <uORB/topics/{of}_output.h>

#include "{header}"

class {class}Module : public ModuleBase<{class}Module>, public px4::WorkItem
{{
public:
	{class}Module() : WorkItem("{of}", px4::wq_configurations::rate_ctrl)
	{{
{begin}	}}

	static int task_spawn(int argc, char *argv[])
	{{
		(void)argc;
		(void)argv;
		{class}Module *const module = new {class}Module();

		if (module == nullptr || !module->_inputs.registerCallback()) {{
			delete module;
			return -1;
		}}

		_object.store(module);
		_task_id = task_id_is_work_queue;
		return 0;
	}}

	static int custom_command(int argc, char *argv[])
	{{
		(void)argc;
		(void)argv;
		return print_usage("unknown command");
	}}

	static int print_usage(const char *reason)
	{{
		(void)reason;
		PRINT_MODULE_USAGE_NAME("{of}", "controller");
		PRINT_MODULE_USAGE_COMMAND("start");
		PRINT_MODULE_USAGE_DEFAULT_COMMANDS();
		return 0;
	}}

private:
	void Run() override
	{{
		if (should_exit()) {{
			_inputs.unregisterCallback();
			exit_and_cleanup();
			return;
		}}

		{of}_input_s input{{}};

		if (!_inputs.update(&input)) {{
			return;
		}}

{locals}{taken}		{call}
		{of}_output_s output{{}};
		output.timestamp = input.timestamp;
{given}		_outputs.publish(output);
	}}

{kept}	uORB::SubscriptionCallbackWorkItem _inputs{{this, ORB_ID({of}_input)}};
	uORB::Publication<{of}_output_s> _outputs{{ORB_ID({of}_output)}};
}};

extern "C" __EXPORT int {of}_main(int argc, char *argv[])
{{
	return {class}Module::main(argc, argv);
}}
"#,
        rust = call.entry.rust,
        header = call.entry.header,
        call = call.text(),
    );
    (text, input, output)
}
