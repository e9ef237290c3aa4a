//! A C program that makes many calls of scalar functions in one run.
//!
//! It reads the index of a function and its operands as words, and writes the status and the word of the result (0
//! after a fault), until its input ends.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Stdio;

use bessemer_backend::c::Options;
use bessemer_backend::c::names::{Names, Passing, Returned};
use bessemer_codegen::compile::Compiled;
use bessemer_ir::{Float, FunctionId, Int, Scalar, Type};

use crate::harness;
use crate::process::{Error, lay_out};
use crate::toolchain::Toolchain;

/// The outcome of a call: the status, and the word of the result.
pub type Outcome = (u64, u64);

/// Builds the program for `functions` and runs it on the words in the file `input`.
///
/// # Errors
/// An error of the compiler or of the system.
pub fn run(
    compiled: &Compiled,
    functions: &[FunctionId],
    toolchain: &Toolchain,
    flags: &[&str],
    input: &Path,
) -> Result<Vec<Outcome>, Error> {
    let folder = lay_out(compiled)?;
    let main = folder.path().join("batch_main.c");
    std::fs::write(&main, program(compiled, functions))?;
    let program = folder.path().join("batch");
    toolchain.around(&main, folder.sources(), &program, flags).map_err(Error::Compile)?;
    let input = std::fs::File::open(input)?;
    let output = toolchain.runner(&program).stdin(Stdio::from(input)).output()?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(Error::Compile(format!("{} {flags:?}: {said}", toolchain.name())));
    }
    let words: Vec<u64> = output
        .stdout
        .chunks_exact(8)
        .map(|bytes| bytes.iter().rev().fold(0, |word, byte| word << 8 | u64::from(*byte)))
        .collect();
    Ok(words.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect())
}

fn program(compiled: &Compiled, functions: &[FunctionId]) -> String {
    let module = &compiled.explicit;
    let names = Names::new(module, &Options::default());
    let mut text = String::new();
    for header in ["stdint.h", "stdbool.h", "stdio.h", "stdlib.h", "string.h"] {
        let _ = writeln!(text, "#include <{header}>");
    }
    for file in compiled.files.iter().filter(|file| file.name.ends_with(".h")) {
        let _ = writeln!(text, "#include \"{}\"", file.name);
    }
    text.push_str(harness::SUPPORT);
    text.push_str(CONVERSIONS);
    for (number, id) in functions.iter().enumerate() {
        let signature = &names.functions[id.index()];
        let _ = writeln!(text, "        case {number}: {{");
        let mut arguments = Vec::new();
        for (index, param) in signature.params.iter().enumerate() {
            let ty = names.word(&param.ty);
            if param.passing == Passing::Output {
                let _ = writeln!(text, "            {ty} result;");
                arguments.push("&result".to_owned());
            } else {
                let _ = writeln!(text, "            {ty} p{index} = {};", get(&names, &param.ty));
                arguments.push(format!("p{index}"));
            }
        }
        let result = &module.functions[id.index()].result;
        let call = format!("{}({})", signature.name, arguments.join(", "));
        let _ = match &signature.returned {
            Returned::Status => writeln!(
                text,
                "            status = (uint64_t){call};\n            \
                 word = status == 0 ? {} : 0;",
                put(result)
            ),
            _ => writeln!(
                text,
                "            {} result = {call};\n            word = {};",
                names.word(result),
                put(result)
            ),
        };
        text.push_str("            break;\n        }\n");
    }
    text.push_str(
        "        default:\n            return 1;\n        }\n        \
         put(status);\n        put(word);\n    }\n}\n",
    );
    text
}

fn get(names: &Names, ty: &Type) -> String {
    match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => "to_double(get())".to_owned(),
        Type::Scalar(Scalar::Float(Float::F32)) => "to_float(get())".to_owned(),
        Type::Scalar(Scalar::Bool) => "get() != 0".to_owned(),
        Type::Scalar(Scalar::Int(int)) if int.signed() && *int != Int::I64 => {
            // Sign-extended words fit the type: the conversion by way of int64_t changes nothing.
            format!("({})to_int64(get())", names.word(ty))
        }
        Type::Scalar(Scalar::Int(Int::I64)) => "to_int64(get())".to_owned(),
        _ => format!("({})get()", names.word(ty)),
    }
}

fn put(ty: &Type) -> &'static str {
    match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => "of_double(result)",
        Type::Scalar(Scalar::Float(Float::F32)) => "of_float(result)",
        Type::Scalar(Scalar::Int(int)) if int.signed() => "(uint64_t)(int64_t)result",
        _ => "(uint64_t)result",
    }
}

/// Conversions between words and values.
const CONVERSIONS: &str = r"
static int64_t to_int64(uint64_t word)
{
    int64_t value;
    memcpy(&value, &word, 8);
    return value;
}

static double to_double(uint64_t word)
{
    double value;
    memcpy(&value, &word, 8);
    return value;
}

static float to_float(uint64_t word)
{
    uint32_t bits = (uint32_t)word;
    float value;
    memcpy(&value, &bits, 4);
    return value;
}

static uint64_t of_double(double value)
{
    uint64_t word;
    memcpy(&word, &value, 8);
    return word;
}

static uint64_t of_float(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, 4);
    return bits;
}

int main(void)
{
    for (;;) {
        uint64_t status = 0;
        uint64_t word;
        switch (get()) {
";
