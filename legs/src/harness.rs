//! Generates a C program that calls entry points and functions with words from its input.
//!
//! For each step of an entry point it reads the words of the arguments and writes the status (0 for an infallible
//! entry), the words of the result, and the words of the component's state. It ends with its input. Words have 64
//! bits, least significant byte first, in the order of `Module::leaves`.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use bessemer_backend::c::Options;
use bessemer_backend::c::names::{Names, Passing, Returned};
use bessemer_ir::{Float, FunctionId, Module, Owner, Scalar, StructId, Type};

/// Returns the text of the program for `entry`, a method of a component with `params` parameters of its author. A
/// work struct, which the compiler added, is not among them.
pub fn program(module: &Module, entry: FunctionId, params: u32) -> String {
    around(module, entry, params, "", "", "")
}

/// Returns the program with calls of `bench_begin` and `bench_end` around each call, so that the instructions between
/// them can be counted.
pub fn marked(module: &Module, entry: FunctionId, params: u32) -> String {
    marked_by(module, entry, params, MARKS)
}

/// Returns the program of [`marked`] with other definitions of `bench_begin` and `bench_end`.
pub fn marked_by(module: &Module, entry: FunctionId, params: u32, marks: &str) -> String {
    around(module, entry, params, marks, "        bench_begin();\n", "        bench_end();\n")
}

/// Functions that mark the calls for a counter. They have external linkage and are never inlined, so that they have
/// addresses. Also the stack, filled with a pattern.
pub const MARKS: &str = include_str!("../c/watch.c");

fn around(
    module: &Module,
    entry: FunctionId,
    params: u32,
    marks: &str,
    before: &str,
    after: &str,
) -> String {
    let names = Names::new(module, &Options::default());
    let Some(call) = Call::of(module, &names, entry, params, "self") else { return String::new() };
    let Call { header, own, declarations, init, reads, call, writes, state, .. } = call;
    format!(
        "#include \"{header}\"\n{SUPPORT}{marks}\nint main(void)\n{{\n    uint64_t status;\n\
         {own}{declarations}{init}    for (;;) {{\n{reads}{before}{call}{after}        put(status);\n\
         {writes}{state}        (void)fflush(words_out);\n    }}\n}}\n"
    )
}

/// Returns the text of a program for many entry points and functions, each call independent. It reads the index in
/// `entries`, the words of the state if there is one, and those of the arguments. It writes the status and, without a
/// fault, the words of the result, the state and each changed argument. An index out of range flushes the output: see
/// [`Process::ask`](crate::process::Process::ask).
pub fn programs(module: &Module, entries: &[(FunctionId, u32)]) -> String {
    programs_with(module, entries, &Options::default())
}

/// Returns the program for C that was emitted with these options.
pub fn programs_with(module: &Module, entries: &[(FunctionId, u32)], options: &Options) -> String {
    several(module, entries, options, &Carrier::Streams, alone)
}

/// Returns the program for a board that is called over a serial line, a frame for each call: see
/// [`board`](crate::board).
pub fn answers(
    module: &Module,
    entries: &[(FunctionId, u32)],
    options: &Options,
    identity: u64,
) -> String {
    several(module, entries, options, &Carrier::Line { identity }, alone)
}

/// Returns the C of a call that is independent of others: its state is read with the arguments.
fn alone(call: Call, index: usize) -> ([String; 2], String) {
    let Call { own, declarations, init, sets, reads, call, writes, state, changed, .. } = call;
    let text = format!(
        "static void call_{index}(void)\n{{\n    uint64_t status;\n{own}{declarations}{init}\
         {sets}{reads}{call}        put(status);\n    if (status == 0) {{\n{writes}{state}{changed}    }}\n}}\n\n"
    );
    (Default::default(), text)
}

/// First word of a board's answer to a call. An error report begins with another word (`c/link/wrong.h`).
pub const ANSWER: u64 = 1;

/// Transport of words to and from a program.
enum Carrier {
    /// Standard input and output, until the input ends.
    Streams,
    /// Files of the machine that runs the emulator.
    Files,
    /// Frames on a serial line; a request for the identity is answered with this number.
    Line { identity: u64 },
}

impl Carrier {
    fn head(&self) -> String {
        match self {
            Self::Streams => SUPPORT.to_owned(),
            Self::Files => format!("\n#define SEMIHOSTING\n{SUPPORT}"),
            Self::Line { .. } => format!(
                "\n#include <stddef.h>\n#include <stdint.h>\n#include <string.h>\n\n#include \"link.h\"\n\
                 #include \"uart.h\"\n#include \"wrong.h\"\n\n#define get link_get\n#define put link_put\n\n{}",
                include_str!("../c/numbers.c")
            ),
        }
    }

    fn main(&self, cases: &str) -> String {
        match self {
            Self::Streams | Self::Files => format!(
                "int main(void)\n{{\n    for (;;) {{\n        switch (get()) {{\n{cases}        \
                 default: (void)fflush(words_out); break;\n        }}\n    }}\n}}\n"
            ),
            Self::Line { identity } => format!(
                "int main(void)\n{{\n    uart_open();\n    for (;;) {{\n        if (!link_receive()) {{\n            \
                 wrong(\"a frame came garbled: its checksum is wrong\");\n            continue;\n        }}\n        \
                 link_begin();\n        put({ANSWER}U);\n        switch (get()) {{\n{cases}        \
                 default: put({identity:#x}ULL); break;\n        }}\n        if (link_is_whole()) {{\n            \
                 link_send();\n        }} else {{\n            wrong(\"a frame has not the words of a call\");\n        \
                 }}\n    }}\n}}\n"
            ),
        }
    }
}

/// Returns the program that also counts the instructions of each call, as [`marked`] does, and writes the used stack
/// bytes after the status. `bare`: for a machine without an operating system.
pub fn watched(
    module: &Module,
    entries: &[(FunctionId, u32)],
    options: &Options,
    bare: bool,
) -> String {
    let carrier = if bare { Carrier::Files } else { Carrier::Streams };
    several(module, entries, options, &carrier, |call, index| {
        let Call { own, declarations, init, sets, reads, call, writes, state, changed, .. } = call;
        let text = format!(
            "static void call_{index}(void)\n{{\n    uint64_t status;\n{own}{declarations}{init}\
             {sets}{reads}        stack_paint();\n        bench_begin();\n{call}        bench_end();\n        \
             {{ const uint64_t stack = stack_used(); put(status); put(stack); }}\n    \
             if (status == 0) {{\n{writes}{state}{changed}    }}\n}}\n\n"
        );
        ([MARKS.to_owned(), String::new()], text)
    })
}

/// Returns the program for components that keep their state between calls. It reads the entry point or function, a flag
/// that restarts the component, and the words of the arguments. It writes the status and always the words of the
/// result, the state and each changed argument.
pub fn lives(module: &Module, entries: &[(FunctionId, u32)], options: &Options) -> String {
    several(module, entries, options, &Carrier::Streams, |call, index| {
        let Call { own, declarations, init, reads, call, writes, state, changed, .. } = call;
        let text = format!(
            "static void call_{index}(void)\n{{\n    uint64_t status;\n{declarations}    if (get() != 0) {{\n{init}    }}\n\
             {reads}{call}        put(status);\n{writes}{state}{changed}}}\n\n"
        );
        ([own, String::new()], text)
    })
}

/// Flag of a call in a program of [`counted`] that goes on from the state before it.
pub const GOES_ON: u64 = 0;
/// Flag of a call that restarts its component.
pub const RESTARTS: u64 = 1;
/// Flag of a call whose component's state is kept first.
pub const KEEPS: u64 = 2;
/// Flag of a call whose component first returns to the state that was kept.
pub const RETURNS: u64 = 3;

/// Returns the program of [`lives`] that counts the instructions of each call, as [`marked`] does, and writes nothing. The
/// flag of a call is one of four: [`GOES_ON`], [`RESTARTS`], [`KEEPS`], [`RETURNS`]. `bare`: for a machine without an
/// operating system.
pub fn counted(
    module: &Module,
    entries: &[(FunctionId, u32)],
    options: &Options,
    bare: bool,
) -> String {
    between_marks(module, entries, options, bare, MARKS, &|call| {
        format!("        bench_begin();\n{call}        bench_end();\n")
    })
}

/// Source of the operations that note subnormal numbers.
pub const SUBNORMAL: &str = include_str!("../c/subnormal.c");

/// Instructions that the program of [`noted`] spends between the marks if a call met a subnormal number. It spends a fraction
/// of them otherwise.
pub const LINGERS: u64 = 1_000;

/// Returns the program of [`counted`] that counts no calls: behind each it spends [`LINGERS`] instructions if the call met a
/// subnormal number. It is linked with [`SUBNORMAL`].
pub fn noted(
    module: &Module,
    entries: &[(FunctionId, u32)],
    options: &Options,
    bare: bool,
) -> String {
    let marks = format!(
        "{MARKS}\nextern int subnormal_seen;\n\nstatic void linger(void)\n{{\n    \
         for (volatile uint32_t n = 0U; n < {LINGERS}U; n++) {{\n    }}\n}}\n\n"
    );
    between_marks(module, entries, options, bare, &marks, &|call| {
        format!(
            "        subnormal_seen = 0;\n{call}        bench_begin();\n        if (subnormal_seen != 0) {{\n            \
             linger();\n        }}\n        bench_end();\n"
        )
    })
}

/// Returns the program of [`counted`], with `marked` around the text of each call.
fn between_marks(
    module: &Module,
    entries: &[(FunctionId, u32)],
    options: &Options,
    bare: bool,
    marks: &str,
    marked: &dyn Fn(&str) -> String,
) -> String {
    let carrier = if bare { Carrier::Files } else { Carrier::Streams };
    several(module, entries, options, &carrier, |call, index| {
        let Call { own, declarations, init, kept: [kept, keep, back], reads, call, spare, .. } =
            call;
        let call = marked(&call);
        let text = format!(
            "static void call_{index}(void)\n{{\n    uint64_t status;\n{declarations}    switch (get()) {{\n    \
             case {RESTARTS}:\n{init}        break;\n    case {KEEPS}:\n{keep}        break;\n    \
             case {RETURNS}:\n{back}        break;\n    default:\n        break;\n    }}\n\
             {reads}{call}        (void)status;\n{spare}}}\n\n"
        );
        ([own + &kept, marks.to_owned()], text)
    })
}

/// Returns a program with a function for each entry, written by `text`, below the text that several of them share.
fn several(
    module: &Module,
    entries: &[(FunctionId, u32)],
    options: &Options,
    carrier: &Carrier,
    text: impl Fn(Call, usize) -> ([String; 2], String),
) -> String {
    let names = Names::new(module, options);
    let (mut headers, mut shared) = (BTreeSet::new(), BTreeSet::new());
    let (mut functions, mut cases) = (String::new(), String::new());
    for (index, (entry, params)) in entries.iter().enumerate() {
        let this = match module.functions[entry.index()].owner {
            Some(Owner::Struct(id)) => format!("self_{}", id.index()),
            _ => String::new(),
        };
        let Some(call) = Call::of(module, &names, *entry, *params, &this) else { continue };
        headers.insert(format!("#include \"{}\"\n", call.header));
        let (once, function) = text(call, index);
        shared.extend(once);
        functions.push_str(&function);
        let _ = writeln!(cases, "        case {index}: call_{index}(); break;");
    }
    let (headers, shared) = (String::from_iter(headers), String::from_iter(shared));
    format!("{headers}{}\n{shared}{functions}{}", carrier.head(), carrier.main(&cases))
}

/// Returns for each parameter of a function's author whether a program reads it with each call. A component, or plain data
/// that a function sets, is kept between the calls of [`lives`].
pub fn is_read(module: &Module, id: FunctionId) -> Vec<bool> {
    let names = Names::new(module, &Options::default());
    let function = &module.functions[id.index()];
    let keeps = state(&names, function.owner).is_some();
    function.parameters().iter().map(|it| !(keeps && it.name == "self")).collect()
}

/// Returns the struct that a function's program keeps, and the name of the function that sets it.
fn state(names: &Names, owner: Option<Owner>) -> Option<(StructId, &str)> {
    match owner {
        Some(Owner::Struct(id)) => Some((id, names.structs[id.index()].init.as_deref()?)),
        _ => None,
    }
}

/// The pieces of C around one entry point or function.
#[derive(Default)]
struct Call {
    header: String,
    /// Declaration of the state.
    own: String,
    /// Declarations of arguments and result.
    declarations: String,
    /// Initialisation of the state.
    init: String,
    /// Declaration of a copy of the state, and the statements that set the copy and return to it.
    kept: [String; 3],
    /// Statements that read the state.
    sets: String,
    /// Statements that read the arguments.
    reads: String,
    /// The call, which sets `status`.
    call: String,
    /// Use of a result that nothing else reads; empty if none is returned by value.
    spare: &'static str,
    /// Statements that write the result.
    writes: String,
    /// Statements that write the state.
    state: String,
    /// Statements that write the arguments that the call may change.
    changed: String,
}

impl Call {
    /// Builds the pieces; `this` is the name of the state.
    fn of(
        module: &Module,
        names: &Names,
        entry: FunctionId,
        params: u32,
        this: &str,
    ) -> Option<Call> {
        let function = &module.functions[entry.index()];
        let signature = &names.functions[entry.index()];
        let walk = Walk { module, names };
        let mut pieces = Call { header: signature.header.clone(), ..Call::default() };
        let mut stateful = false;
        // Plain data has no first state: it is an argument like any other.
        if let Some((component, init)) = state(names, function.owner) {
            stateful = true;
            let own = &names.structs[component.index()];
            pieces.own = format!("    static {} {this};\n", own.ty);
            pieces.init = format!("    {init}(&{this});\n");
            pieces.kept = [
                format!("    static {} kept_{this};\n", own.ty),
                format!("        kept_{this} = {this};\n"),
                format!("        {this} = kept_{this};\n"),
            ];
            let ty = Type::Struct(component);
            walk.reads(&ty, this, &mut pieces.sets);
            walk.writes(&ty, this, &mut pieces.state);
        }
        let mut arguments = Vec::new();
        for (index, param) in signature.params.iter().enumerate() {
            // Its author may call it otherwise in the C.
            let receiver =
                stateful && function.parameters().get(index).is_some_and(|it| it.name == "self");
            if receiver {
                arguments.push(format!("&{this}"));
                continue;
            }
            let local = format!("{}_", param.name);
            let declarator = names.declarator(&param.ty, &local).text();
            let _ = writeln!(pieces.declarations, "    static {declarator};");
            let (reads, writes) = (&mut pieces.reads, &mut pieces.writes);
            // What the compiler added is no argument, and its content means nothing.
            let added = index >= params as usize && param.passing != Passing::Output;
            match param.passing {
                // So nothing can rest on it.
                _ if added => {
                    let _ =
                        writeln!(reads, "        (void)memset(&{local}, 0xa5, sizeof({local}));");
                }
                Passing::Output => walk.writes(&param.ty, &local, writes),
                _ => walk.reads(&param.ty, &local, reads),
            }
            if param.passing == Passing::InOut && !added {
                walk.writes(&param.ty, &local, &mut pieces.changed);
            }
            let scalar = !matches!(param.ty, Type::Array { .. } | Type::Matrix { .. });
            let (element, dimensions) = names.type_parts(&param.ty);
            let inner = dimensions.split_inclusive(']').skip(1).collect::<String>();
            arguments.push(match param.passing {
                Passing::Value => local,
                _ if scalar => format!("&{local}"),
                // C99 does not add the `const` of an array's elements by itself.
                Passing::Input if !inner.is_empty() => {
                    format!("(const {element} (*){inner}){local}")
                }
                _ => local,
            });
        }
        let call = format!("{}({})", signature.name, arguments.join(", "));
        pieces.call = match &signature.returned {
            Returned::Nothing => format!("        {call};\n        status = 0;\n"),
            Returned::Status => format!("        status = (uint64_t){call};\n"),
            Returned::Value(ty) => {
                // No parameter is called so: theirs end with a `_`.
                let declarator = names.declarator(ty, "returned").text();
                let _ = writeln!(pieces.declarations, "    static {declarator};");
                walk.writes(ty, "returned", &mut pieces.writes);
                pieces.spare = "        (void)returned;\n";
                format!("        returned = {call};\n        status = 0;\n")
            }
        };
        Some(pieces)
    }
}

/// The C at the beginning of every such program: functions that read and write words.
pub const SUPPORT: &str = concat!(include_str!("../c/stdio.c"), include_str!("../c/numbers.c"));

/// A function of C that moves a value of a struct's type word by word, by functions `get` and `put`.
pub struct Mover {
    /// Name of the parameter.
    pub name: &'static str,
    /// Name of the struct in Rust.
    pub ty: &'static str,
    /// Direction of the parameter.
    pub way: Way,
}

/// Direction in which words move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Words are read by `get`.
    In,
    /// Words are written by `put`.
    Out,
}

/// Returns the text of a C file with such functions; `head` declares them, `get` and `put`. `None` if the models lack
/// a struct.
pub fn movers(module: &Module, head: &str, movers: &[Mover]) -> Option<String> {
    let names = Names::new(module, &Options::default());
    let walk = Walk { module, names: &names };
    let mut text = format!("{head}{}", include_str!("../c/numbers.c"));
    for Mover { name, ty, way } in movers {
        let id = structure(module, ty)?;
        let (c, ty) = (&names.structs[id.index()].ty, Type::Struct(id));
        let (constant, mut body) = (if *way == Way::In { "" } else { "const " }, String::new());
        match way {
            Way::In => walk.reads(&ty, "(*value)", &mut body),
            Way::Out => walk.writes(&ty, "(*value)", &mut body),
        }
        let _ = write!(text, "\nvoid {name}({constant}{c} *value)\n{{\n{body}}}\n");
    }
    Some(text)
}

/// Returns the identity of these structs' layout; `None` if the models lack one.
pub fn identity<'t>(module: &Module, types: impl Iterator<Item = &'t str>) -> Option<u64> {
    let mut letters = Vec::new();
    for ty in types {
        let leaves = module.leaves(&Type::Struct(structure(module, ty)?));
        letters.extend(format!("{leaves:?}").bytes().map(u64::from));
    }
    Some(crate::digest(&letters))
}

fn structure(module: &Module, name: &str) -> Option<StructId> {
    let index = module.structs.iter().position(|it| it.name == name)?;
    Some(StructId(index as u32))
}

struct Walk<'a> {
    module: &'a Module,
    names: &'a Names,
}

impl Walk<'_> {
    /// Appends C that reads a value of type `ty` into the C expression `place`, word by word.
    fn reads(&self, ty: &Type, place: &str, text: &mut String) {
        self.words(ty, place, text, "get();", &|ty, place, count, text| match self.numbers(ty) {
            Some(numbers) => get_numbered(self.names.word(ty), &numbers, place, text),
            None => get(self.names, ty, place, count, text),
        });
    }

    /// Appends C that writes a value, word by word.
    fn writes(&self, ty: &Type, place: &str, text: &mut String) {
        self.words(ty, place, text, "put(0);", &|ty, place, count, text| match self.numbers(ty) {
            Some(numbers) => put_numbered(&numbers, place, text),
            None => put(ty, place, count, text),
        });
    }

    /// Returns the numbers of an enum's variants, if they differ from the indices.
    fn numbers(&self, ty: &Type) -> Option<Vec<i32>> {
        let Type::Enum(id) = ty else { return None };
        let item = &self.module.enums[id.index()];
        item.is_numbered().then(|| item.variants.iter().map(|variant| variant.value).collect())
    }

    /// Writes each word of a value in order; consecutive numbers become one place and their count. Variants that share
    /// memory are written only if active, else `skip`.
    fn words(
        &self,
        ty: &Type,
        place: &str,
        text: &mut String,
        skip: &str,
        found: &dyn Fn(&Type, &str, u32, &mut String),
    ) {
        match ty {
            Type::Unit | Type::Slice(_) => {}
            Type::Scalar(_) | Type::Enum(_) => found(ty, place, 1, text),
            Type::Array { element, len } if bytes(element).is_some() && *len > 0 => {
                found(element, &format!("{place}[0]"), *len, text);
            }
            Type::Array { element, len } => {
                for index in 0..*len {
                    self.words(element, &format!("{place}[{index}]"), text, skip, found);
                }
            }
            Type::Matrix { element, rows, cols } => {
                let (element, shape, len) = (Type::Scalar(*element), (*rows, *cols), rows * cols);
                if self.names.layout.has_columns(shape) && bytes(&element).is_some() && len > 0 {
                    return found(&element, &format!("{place}[0]"), len, text);
                }
                for index in 0..len {
                    let at = self.names.layout.subscript(shape, index);
                    found(&element, &format!("{place}{at}"), 1, text);
                }
            }
            Type::Struct(id) => {
                let item = &self.module.structs[id.index()];
                let names = &self.names.structs[id.index()].fields;
                for (index, (field, name)) in item.fields.iter().zip(names).enumerate() {
                    let case = (0..).find(|word| item.holds(index, *word));
                    let inner = format!("{place}.{name}");
                    if !item.overlaid() || index == 0 {
                        self.words(&field.ty, &inner, text, skip, found);
                        continue;
                    }
                    let (tag, case) = (&names[0], case.unwrap_or_default());
                    let _ = writeln!(text, "        if ((int){place}.{tag} == {case}) {{");
                    self.words(&field.ty, &inner, text, skip, found);
                    let count = self.module.width(&field.ty);
                    let _ = writeln!(text, "        }} else {{");
                    let _ =
                        writeln!(text, "        for (int n = 0; n < {count}; ++n) {{ {skip} }}");
                    let _ = writeln!(text, "        }}");
                }
            }
        }
    }
}

/// Returns the size of a number; `None` for types that are not transferred as bytes.
fn bytes(ty: &Type) -> Option<u32> {
    match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => Some(8),
        Type::Scalar(Scalar::Float(Float::F32)) => Some(4),
        Type::Scalar(Scalar::Int(int)) => Some(int.bits() / 8),
        _ => None,
    }
}

/// Appends a call that reads words. Calls keep the program small: it has thousands of these, and compilers, above all
/// with sanitizers, would take long.
fn get(names: &Names, ty: &Type, place: &str, count: u32, text: &mut String) {
    let name = names.word(ty);
    let _ = match (bytes(ty), ty) {
        (Some(bytes), _) => writeln!(text, "        get_numbers(&{place}, {bytes}, {count});"),
        (None, Type::Scalar(Scalar::Bool)) => writeln!(text, "        {place} = get() != 0;"),
        _ => writeln!(text, "        {place} = ({name})get();"),
    };
}

/// Appends C that reads a variant's index and sets its number; an invalid index sets a number of no variant.
fn get_numbered(name: String, numbers: &[i32], place: &str, text: &mut String) {
    let none = (0..=i32::MAX).find(|number| !numbers.contains(number)).unwrap_or_default();
    let (count, list) = (numbers.len(), list(numbers));
    let _ = writeln!(
        text,
        "        {{ static const int32_t all[] = {{{list}}}; const uint64_t w = get(); \
         {place} = ({name})((w < {count}) ? all[w] : {none}); }}"
    );
}

/// Appends C that writes the index of the variant with a number.
fn put_numbered(numbers: &[i32], place: &str, text: &mut String) {
    let (count, list) = (numbers.len(), list(numbers));
    let _ = writeln!(
        text,
        "        {{ static const int32_t all[] = {{{list}}}; uint64_t w = 0; \
         while ((w < {count}) && (all[w] != (int32_t){place})) {{ ++w; }} put(w); }}"
    );
}

fn list(numbers: &[i32]) -> String {
    let numbers: Vec<String> = numbers.iter().map(i32::to_string).collect();
    numbers.join(", ")
}

fn put(ty: &Type, place: &str, count: u32, text: &mut String) {
    let signed = matches!(ty, Type::Scalar(Scalar::Int(int)) if int.signed());
    let call = if signed { "put_signed" } else { "put_numbers" };
    let _ = match bytes(ty) {
        Some(bytes) => writeln!(text, "        {call}(&{place}, {bytes}, {count});"),
        None => writeln!(text, "        put((uint64_t){place});"),
    };
}
