//! Runs emitted C and the interpreter on the same words: edge values of every type, then random ones.

use std::fmt::Write as _;
use std::io::Write as _;
use std::ops::Range;
use std::path::Path;
use std::process::{Command, Stdio};

use bessemer_backend::c::names::{FAULTS, Names, Passing, Returned, Signature, Storage};
use bessemer_backend::c::{CFile, Options};
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::{Float, FunctionId, Mode, Module, Scalar, Type};
use bessemer_store::once;

use super::compilers::{by_turn, folder, is_there, texts};

/// Up to so many calls of a function.
const CALLS: usize = 500;

/// A function and its arguments as words.
type Call = (FunctionId, Vec<Vec<u64>>);

/// The compilers that the C goes through.
pub const COMPILERS: [&str; 2] = ["gcc", "clang"];

/// Compares every function that other files can call.
pub fn compare(name: &str, module: &Module, explicit: &Module, files: &[CFile]) {
    compare_with(&COMPILERS, name, module, explicit, files);
}

/// Compares the legs with some compilers.
pub fn compare_with(
    compilers: &[&str],
    name: &str,
    module: &Module,
    explicit: &Module,
    files: &[CFile],
) {
    let names = Names::new(explicit, &Options::default());
    let (calls, expected): (Vec<_>, Vec<_>) =
        expected(module, calls(module, &names)).into_iter().unzip();
    let mut list = files.to_vec();
    list.push(CFile {
        name: "main.c".to_owned(),
        text: driver(module, explicit, &names, files),
        map: Vec::new(),
    });
    let folder = folder(&format!("run-{name}"), &list);
    let mut input = String::new();
    for (function, words) in &calls {
        let words: Vec<String> = words.iter().flatten().map(|word| format!("{word:x}")).collect();
        let _ = writeln!(input, "{} {}", function.0, words.join(" "));
    }
    let sanitized =
        ["-O1", "-fsanitize=undefined,float-cast-overflow", "-fno-sanitize-recover=all"];
    let compilers = compilers.iter().copied().enumerate();
    for (index, compiler) in compilers.filter(|(_, compiler)| is_there(compiler)) {
        for flags in by_turn(&[&["-O3"][..], &sanitized, &["-O0"]], 1, index) {
            let content = (texts(&list), compiler, flags, &input, &expected);
            once(name, &content, || {
                let found = run(compiler, flags, &folder, &input);
                let found: Vec<&str> = found.lines().collect();
                assert_eq!(found.len(), expected.len(), "{name} {compiler} {flags:?}");
                for ((found, expected), (function, words)) in
                    found.iter().zip(&expected).zip(&calls)
                {
                    let called = &module.functions[function.index()].name;
                    assert_eq!(found, expected, "{compiler} {flags:?} {called} {words:x?}");
                }
            });
        }
    }
}

fn run(compiler: &str, flags: &[&str], folder: &Path, input: &str) -> String {
    let sources = std::fs::read_dir(folder)
        .expect("just written")
        .map(|entry| entry.expect("readable").path());
    let sources: Vec<_> =
        sources.filter(|path| path.extension().is_some_and(|end| end == "c")).collect();
    // clang compiles the plain C, gcc the kernels of the processor.
    let plain = (compiler == "clang").then_some("-DBESSEMER_PLAIN");
    super::compilers::run(
        Command::new(compiler)
            .args(["-std=c99", "-ffp-contract=off"])
            .args(flags)
            .args(plain)
            .args(["-o", "program"])
            .args(sources)
            .arg("-lm"),
        folder,
    );
    let mut child = Command::new(folder.join("program"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("just compiled");
    let mut stdin = child.stdin.take().expect("piped");
    let input = input.to_owned();
    let writer = std::thread::spawn(move || stdin.write_all(input.as_bytes()));
    let output = child.wait_with_output().expect("it runs");
    assert!(output.status.success(), "{compiler} {flags:?} in {}", folder.display());
    writer.join().expect("no panic").expect("it reads");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// Returns the interpreter's status, words of the borrowed arguments, and words of the result.
fn expected(module: &Module, calls: Vec<Call>) -> Vec<(Call, String)> {
    let mut interpreter = Interpreter::new(module);
    // A random program may count to 2^64.
    interpreter.limit(100_000);
    let mut lines = Vec::new();
    for (id, words) in calls {
        let function = &module.functions[id.index()];
        let mut arguments = words.clone();
        let mut line = String::new();
        match interpreter.call(id, &mut arguments) {
            Err(Stop::Fault { fault, .. }) => {
                let number =
                    FAULTS.iter().position(|other| *other == fault).expect("all are listed");
                let _ = write!(line, "{}", number + 1);
            }
            Err(Stop::Limit) => continue,
            Err(stop) => panic!("{}: {stop}", function.name),
            Ok(result) => {
                line.push('0');
                for (local, words) in function.parameters().iter().zip(&arguments) {
                    if local.mode == Mode::RefMut {
                        show(module, &local.ty, words, &mut line);
                    }
                }
                show(module, &function.result, &result, &mut line);
            }
        }
        lines.push(((id, words), line));
    }
    lines
}

/// Every NaN is one.
fn show(module: &Module, ty: &Type, words: &[u64], line: &mut String) {
    for (ty, word) in module.leaves(ty).iter().zip(words) {
        let word = match ty.as_float() {
            Some(Float::F32) if f32::from_bits(*word as u32).is_nan() => 0x7fc0_0000,
            Some(Float::F64) if f64::from_bits(*word).is_nan() => 0x7ff8_0000_0000_0000,
            _ => *word,
        };
        let _ = write!(line, " {word:x}");
    }
}

/// The arguments of all calls, per function.
fn calls(module: &Module, names: &Names) -> Vec<Call> {
    let mut random = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = move |below: usize| {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        (random >> 20) as usize % below
    };
    let mut list = Vec::new();
    for (index, function) in module.functions.iter().enumerate() {
        let id = FunctionId(index as u32);
        if names.signature(id).storage != Storage::Extern {
            continue;
        }
        let params = function.parameters();
        let edges: Vec<Vec<Vec<u64>>> = params
            .iter()
            .map(|local| module.leaves(&local.ty).iter().map(|leaf| edges(module, leaf)).collect())
            .collect();
        let choices: usize = edges
            .iter()
            .flatten()
            .map(Vec::len)
            .try_fold(1usize, |a, b| a.checked_mul(b))
            .unwrap_or(usize::MAX);
        for call in 0..choices.min(CALLS) {
            let mut rest = call;
            let words = edges.iter().map(|leaves| {
                let pick = leaves.iter().map(|edges| {
                    let at = if choices <= CALLS { rest % edges.len() } else { next(edges.len()) };
                    rest /= edges.len();
                    edges[at]
                });
                pick.collect()
            });
            list.push((id, words.collect()));
        }
    }
    list
}

fn edges(module: &Module, ty: &Type) -> Vec<u64> {
    let floats = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.5,
        -0.3,
        1.5,
        3.0,
        100.7,
        1e-320,
        f64::MIN_POSITIVE,
        f64::MAX,
        -f64::MAX,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        -129.0,
        255.5,
        256.0,
        -2_147_483_649.0,
        2_147_483_648.0,
        4_294_967_296.0,
        -9.3e18,
        9_223_372_036_854_775_808.0,
        1.9e19,
    ];
    match ty {
        Type::Scalar(Scalar::Bool) => vec![0, 1],
        Type::Enum(id) => (0..module.enums[id.index()].variants.len() as u64).collect(),
        Type::Scalar(Scalar::Float(Float::F64)) => {
            floats.iter().map(|value: &f64| value.to_bits()).collect()
        }
        Type::Scalar(Scalar::Float(Float::F32)) => {
            let mut list: Vec<u64> =
                floats.iter().map(|value| u64::from((*value as f32).to_bits())).collect();
            list.extend([1, 0x8000_0001, 0x0080_0000]);
            list
        }
        Type::Scalar(Scalar::Int(int)) => {
            let (min, max) = (bessemer_ir::Int::min(*int), bessemer_ir::Int::max(*int));
            let mut list = vec![
                min,
                min + 1,
                -7,
                -1,
                0,
                1,
                2,
                3,
                7,
                8,
                31,
                33,
                100,
                127,
                128,
                200,
                // Halfway between two of f32 and a little more: by way of f64, the little is lost.
                (1 << 60) + (1 << 36) + 1,
                max / 2,
                max - 1,
                max,
            ];
            list.retain(|value| (min..=max).contains(value));
            list.sort_unstable();
            list.dedup();
            list.iter().map(|value| *value as u64).collect()
        }
        other => unreachable!("no leaf: {other:?}"),
    }
}

const PRELUDE: &str = r#"
static char line[1 << 20];
static char *cursor;

static uint64_t next(void)
{
    return (uint64_t)strtoull(cursor, &cursor, 16);
}

static void put(uint64_t word)
{
    printf(" %llx", (unsigned long long)word);
}

static double get_double(void)
{
    uint64_t word = next();
    double value;
    memcpy(&value, &word, sizeof value);
    return value;
}

static float get_float(void)
{
    uint32_t word = (uint32_t)next();
    float value;
    memcpy(&value, &word, sizeof value);
    return value;
}

static void put_double(double value)
{
    uint64_t word = UINT64_C(0x7ff8000000000000);
    if (value == value) {
        memcpy(&word, &value, sizeof word);
    }
    put(word);
}

static void put_float(float value)
{
    uint32_t word = 0x7fc00000U;
    if (value == value) {
        memcpy(&word, &value, sizeof word);
    }
    put(word);
}

int main(void)
{
    while (fgets(line, sizeof line, stdin) != NULL) {
        cursor = line;
        switch (strtoul(cursor, &cursor, 10)) {
"#;

/// A program that reads calls and prints what they come to.
fn driver(module: &Module, explicit: &Module, names: &Names, files: &[CFile]) -> String {
    let mut text = String::new();
    for header in ["inttypes.h", "stdbool.h", "stdio.h", "stdlib.h", "string.h"] {
        let _ = writeln!(text, "#include <{header}>");
    }
    for file in files.iter().filter(|file| file.name.ends_with(".h")) {
        let _ = writeln!(text, "#include \"{}\"", file.name);
    }
    text.push_str(PRELUDE);
    for (index, signature) in names.functions.iter().enumerate() {
        if signature.storage == Storage::Extern {
            let _ = writeln!(text, "        case {index}: {{");
            let known = module.functions[index].params as usize;
            let lent = known..explicit.functions[index].params as usize;
            call(explicit, names, signature, lent, &mut text);
            text.push_str("            break;\n        }\n");
        }
    }
    text.push_str("        default:\n            return 1;\n        }\n    }\n    return 0;\n}\n");
    text
}

/// A call; what is `lent` to the function holds nothing that means anything, and nobody reads it afterwards.
fn call(
    module: &Module,
    names: &Names,
    signature: &Signature,
    lent: Range<usize>,
    text: &mut String,
) {
    let mut arguments = Vec::new();
    for (at, param) in signature.params.iter().enumerate() {
        let _ = writeln!(
            text,
            "            {};",
            names.declarator(&param.ty, &format!("p_{}", param.name)).text()
        );
        let byte = if lent.contains(&at) { "0xa5" } else { "0" };
        let _ = writeln!(text, "            memset(&p_{0}, {byte}, sizeof p_{0});", param.name);
        let array = matches!(param.ty, Type::Array { .. } | Type::Matrix { .. });
        let mark = if array || param.passing == Passing::Value { "" } else { "&" };
        let nested = names.type_parts(&param.ty).1;
        let cast = match nested.split_once(']') {
            Some((_, rest)) if !rest.is_empty() && param.passing == Passing::Input => {
                format!("(const {} (*){rest})", names.type_parts(&param.ty).0)
            }
            _ => String::new(),
        };
        arguments.push(format!("{cast}{mark}p_{}", param.name));
        if param.passing != Passing::Output && !lent.contains(&at) {
            leaves(module, names, &param.ty, &format!("p_{}", param.name), &mut |leaf, path| {
                let _ = writeln!(text, "            {path} = {};", read(names, leaf));
            });
        }
    }
    let call = format!("{}({})", signature.name, arguments.join(", "));
    match &signature.returned {
        Returned::Nothing => {
            let _ = writeln!(text, "            {call};\n            printf(\"0\");");
        }
        Returned::Value(ty) => {
            let _ = writeln!(
                text,
                "            {} result = {call};\n            printf(\"0\");",
                names.word(ty)
            );
        }
        Returned::Status => {
            let _ = writeln!(text, "            unsigned status = (unsigned){call};");
            text.push_str("            printf(\"%u\", status);\n");
            text.push_str("            if (status != 0U) {\n                puts(\"\");\n                break;\n            }\n");
        }
    }
    for (at, param) in signature.params.iter().enumerate() {
        if matches!(param.passing, Passing::InOut | Passing::Output) && !lent.contains(&at) {
            leaves(module, names, &param.ty, &format!("p_{}", param.name), &mut |leaf, path| {
                let _ = writeln!(text, "            {};", write(leaf, path));
            });
        }
    }
    if let Returned::Value(ty) = &signature.returned {
        let _ = writeln!(text, "            {};", write(ty, "result"));
    }
    text.push_str("            puts(\"\");\n");
}

fn leaves(
    module: &Module,
    names: &Names,
    ty: &Type,
    path: &str,
    visit: &mut dyn FnMut(&Type, &str),
) {
    match ty {
        Type::Unit | Type::Slice(_) => {}
        Type::Scalar(_) | Type::Enum(_) => visit(ty, path),
        Type::Array { element, len } => {
            for index in 0..*len {
                leaves(module, names, element, &format!("{path}[{index}]"), visit);
            }
        }
        Type::Matrix { element, rows, cols } => {
            for index in 0..rows * cols {
                visit(&Type::Scalar(*element), &format!("{path}[{index}]"));
            }
        }
        Type::Struct(id) => {
            let fields = module.structs[id.index()].fields.iter();
            for (field, name) in fields.zip(&names.structs[id.index()].fields) {
                leaves(module, names, &field.ty, &format!("{path}.{name}"), visit);
            }
        }
    }
}

fn read(names: &Names, ty: &Type) -> String {
    match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => "get_double()".to_owned(),
        Type::Scalar(Scalar::Float(Float::F32)) => "get_float()".to_owned(),
        Type::Scalar(Scalar::Bool) => "next() != 0".to_owned(),
        _ => format!("({})next()", names.word(ty)),
    }
}

fn write(ty: &Type, path: &str) -> String {
    match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => format!("put_double({path})"),
        Type::Scalar(Scalar::Float(Float::F32)) => format!("put_float({path})"),
        Type::Scalar(Scalar::Int(int)) if int.signed() => format!("put((uint64_t)(int64_t){path})"),
        _ => format!("put((uint64_t){path})"),
    }
}
