//! The Rust of a package as a leg: the text of a program that reads calls and writes results as words.
//!
//! A call is the index of an entry point and the words of the component and the arguments. The answer is 0 and the
//! words of the result, of the component and of each argument that the call may change. After a panic it is one more
//! than the length of the message, and the bytes of the message in words. The program ends with its input.

use std::fmt::Write as _;

use bessemer_ir::{Function, Mode, Module, Owner};

/// The head of the program, before the calls.
const SUPPORT: &str = r#"//! A program around a package's entry points.
#![allow(warnings)]
use std::cell::RefCell;
use std::io::{Read, Write};
use bessemer::Plain;
thread_local! {
    static OUT: RefCell<std::io::BufWriter<std::io::Stdout>> = RefCell::new(std::io::BufWriter::new(std::io::stdout()));
    static IN: RefCell<std::io::BufReader<std::io::Stdin>> = RefCell::new(std::io::BufReader::new(std::io::stdin()));
}
fn end() -> ! { OUT.with_borrow_mut(|out| out.flush()).expect("somebody reads"); std::process::exit(0) }
fn get() -> u64 {
    let mut bytes = [0; 8];
    if IN.with_borrow_mut(|from| from.read_exact(&mut bytes)).is_err() { end() }
    u64::from_le_bytes(bytes)
}
fn put(word: u64) { OUT.with_borrow_mut(|out| out.write_all(&word.to_le_bytes())).expect("somebody reads"); }
fn load<T: Plain>() -> T { T::load(&mut get) }
fn store(value: &impl Plain) { value.store(&mut put); }
fn call<T: Plain>(call: impl FnOnce() -> T) -> Option<T> {
    match std::panic::catch_unwind(std::panic::AssertUnwindSafe(call)) {
        Ok(result) => { put(0); store(&result); Some(result) }
        Err(panic) => {
            let text = panic.downcast_ref::<String>().map(String::as_str);
            let text = text.or(panic.downcast_ref::<&str>().copied()).unwrap_or_default();
            put(text.len() as u64 + 1);
            for part in text.as_bytes().chunks(8) {
                let mut word = [0; 8];
                word[..part.len()].copy_from_slice(part);
                put(u64::from_le_bytes(word));
            }
            None
        }
    }
}
"#;

/// Returns the program with one line for each of these entry points; error messages count lines from the first of
/// them.
pub fn program(module: &Module, names: &[String], entries: &[&Function]) -> (String, usize) {
    let mut text = SUPPORT.to_owned();
    let first = text.lines().count() + 1;
    for (index, function) in entries.iter().enumerate() {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "fn call_{index}() {{ {} }}", call(module, function));
    }
    text += "fn main() {\n    std::panic::set_hook(Box::new(|_| {}));\n";
    for name in names {
        let _ = writeln!(text, "    bessemer::name::register({name:?});");
    }
    text += "    loop {\n        match get() {\n";
    for index in 0..entries.len() {
        let _ = writeln!(text, "            {index} => call_{index}(),");
    }
    text += "            _ => end(),\n        }\n    }\n}\n";
    (text, first)
}

/// Loads, calls, stores.
fn call(module: &Module, function: &Function) -> String {
    let Some(Owner::Struct(id)) = function.owner else { return String::new() };
    let owner = &module.structs[id.index()];
    let (mut loads, mut arguments, mut stores) = (String::new(), Vec::new(), String::new());
    for (index, local) in function.parameters().iter().enumerate() {
        let name = format!("a{index}");
        let _ = write!(loads, "let mut {name} = load(); ");
        arguments.push(match local.mode {
            Mode::Value => name.clone(),
            Mode::Ref => format!("&{name}"),
            Mode::RefMut => format!("&mut {name}"),
        });
        if index == 0 || local.mode == Mode::RefMut {
            let _ = write!(stores, "store(&{name}); ");
        }
    }
    let path = format!("{}::{}::{}", owner.module, owner.name, function.name);
    format!("{loads}if call(|| {path}({})).is_some() {{ {stores}}}", arguments.join(", "))
}
