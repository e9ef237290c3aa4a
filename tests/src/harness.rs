//! A C program around one entry point: words in, words out.
//!
//! For each step it reads the words of the arguments and writes the status (0 for an infallible
//! entry), the words of the result, and the words of the component's state. It ends with its input.
//! Words are 64 bits, least significant byte first, in the order of `Module::leaves`.

use std::fmt::Write as _;

use bessemer_codegen::c::Options;
use bessemer_codegen::c::names::{Names, Passing, Returned};
use bessemer_ir::{Float, FunctionId, Int, Module, Owner, Scalar, Type};

/// The text of the program for `entry`, a method of a component; `params`: how many parameters the
/// author gave it. What the compiler added, a work struct, is no argument.
pub fn program(module: &Module, entry: FunctionId, params: u32) -> String {
    let names = Names::new(module, &Options::default());
    let function = &module.functions[entry.index()];
    let Some(Owner::Struct(component)) = function.owner else { return String::new() };
    let state = &names.structs[component.index()];
    let signature = &names.functions[entry.index()];
    let mut declarations = format!("    static {} self;\n", state.ty);
    let (mut reads, mut writes, mut arguments) = (String::new(), String::new(), Vec::new());
    for (index, param) in signature.params.iter().enumerate() {
        if param.name == "self" {
            arguments.push("&self".to_owned());
            continue;
        }
        let local = format!("{}_", param.name);
        let declarator = names.declarator(&param.ty, &local).text();
        let _ = writeln!(declarations, "    static {declarator};");
        let walk = Walk { module, names: &names };
        let added = index >= params as usize && param.passing != Passing::Output;
        if added {
            // Its content means nothing.
        } else if param.passing == Passing::Output {
            walk.words(&param.ty, &local, &mut |ty, place| put(ty, place, &mut writes));
        } else {
            walk.words(&param.ty, &local, &mut |ty, place| get(&names, ty, place, &mut reads));
        }
        let scalar = !matches!(param.ty, Type::Array { .. } | Type::Matrix { .. });
        let pointer = scalar && param.passing != Passing::Value;
        arguments.push(format!("{}{local}", if pointer { "&" } else { "" }));
    }
    let call = format!("{}({})", signature.name, arguments.join(", "));
    let call = match &signature.returned {
        Returned::Nothing => format!("        {call};\n        put(0);\n"),
        Returned::Status => format!("        put((uint64_t){call});\n"),
        Returned::Value(ty) => {
            let _ =
                writeln!(declarations, "    static {};", names.declarator(ty, "result_").text());
            put(ty, "result_", &mut writes);
            format!("        result_ = {call};\n        put(0);\n")
        }
    };
    let walk = Walk { module, names: &names };
    walk.words(&Type::Struct(component), "self", &mut |ty, place| put(ty, place, &mut writes));
    let init = state.init.clone().unwrap_or_default();
    let header = &signature.header;
    format!(
        "#include \"{header}\"\n#include <stdint.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n\n\
         {SUPPORT}\nint main(void)\n{{\n{declarations}    {init}(&self);\n    for (;;) {{\n{reads}{call}{writes}        \
         (void)fflush(stdout);\n    }}\n}}\n"
    )
}

const SUPPORT: &str = "\
static uint64_t get(void)
{
    unsigned char bytes[8];
    uint64_t word = 0;
    int i;
    if (fread(bytes, 1, 8, stdin) != 8) {
        exit(0);
    }
    for (i = 7; i >= 0; --i) {
        word = (word << 8) | bytes[i];
    }
    return word;
}

static void put(uint64_t word)
{
    unsigned char bytes[8];
    int i;
    for (i = 0; i < 8; ++i) {
        bytes[i] = (unsigned char)(word >> (8 * i));
    }
    if (fwrite(bytes, 1, 8, stdout) != 8) {
        exit(1);
    }
}
";

struct Walk<'a> {
    module: &'a Module,
    names: &'a Names,
}

impl Walk<'_> {
    /// Every word of a value of type `ty` at the C place `place`, in order.
    fn words(&self, ty: &Type, place: &str, found: &mut dyn FnMut(&Type, &str)) {
        match ty {
            Type::Unit => {}
            Type::Scalar(_) | Type::Enum(_) => found(ty, place),
            Type::Array { element, len } => {
                for index in 0..*len {
                    self.words(element, &format!("{place}[{index}]"), found);
                }
            }
            Type::Matrix { element, rows, cols } => {
                for index in 0..rows * cols {
                    found(&Type::Scalar(*element), &format!("{place}[{index}]"));
                }
            }
            Type::Struct(id) => {
                let fields = &self.module.structs[id.index()].fields;
                for (field, name) in fields.iter().zip(&self.names.structs[id.index()].fields) {
                    self.words(&field.ty, &format!("{place}.{name}"), found);
                }
            }
        }
    }
}

fn get(names: &Names, ty: &Type, place: &str, text: &mut String) {
    let name = names.word(ty);
    let _ = match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => {
            writeln!(text, "        {{ uint64_t w = get(); memcpy(&{place}, &w, 8); }}")
        }
        Type::Scalar(Scalar::Float(Float::F32)) => {
            writeln!(text, "        {{ uint32_t w = (uint32_t)get(); memcpy(&{place}, &w, 4); }}")
        }
        Type::Scalar(Scalar::Int(int)) => {
            let bytes = int.bits() / 8;
            let unsigned = format!("uint{}_t", int.bits());
            writeln!(
                text,
                "        {{ {unsigned} w = ({unsigned})get(); memcpy(&{place}, &w, {bytes}); }}"
            )
        }
        Type::Scalar(Scalar::Bool) => writeln!(text, "        {place} = get() != 0;"),
        _ => writeln!(text, "        {place} = ({name})get();"),
    };
}

fn put(ty: &Type, place: &str, text: &mut String) {
    let _ = match ty {
        Type::Scalar(Scalar::Float(Float::F64)) => {
            writeln!(text, "        {{ uint64_t w; memcpy(&w, &{place}, 8); put(w); }}")
        }
        Type::Scalar(Scalar::Float(Float::F32)) => {
            writeln!(text, "        {{ uint32_t w; memcpy(&w, &{place}, 4); put(w); }}")
        }
        Type::Scalar(Scalar::Int(int)) if int.signed() && *int != Int::Isize => {
            writeln!(text, "        put((uint64_t)(int64_t){place});")
        }
        _ => writeln!(text, "        put((uint64_t){place});"),
    };
}
