//! Programs that once differed, minimised: one file each in `tests/found`. Every run takes a third of them beside its random ones.
//!
//! A file is plain Rust, written by `cargo xtask fuzz` or an author. Its signatures say what is called: the entry points of
//! its last component, else each public `#[function]` whose name begins with the file's. Helpers are private. A file stays
//! once its fault is mended.

use std::path::{Path, PathBuf};

use bessemer_tests::root;
use quote::ToTokens as _;
use syn::{Attribute, FnArg, ImplItem, Item, Type, Visibility};

use super::shrink::named;
use super::writer::{Entry, Program};

fn folder() -> PathBuf {
    root().join("tests/found")
}

/// Writes a program to its file, and returns the path.
pub fn keep(program: &Program, seed: u64) -> PathBuf {
    let program = named(program, &program.text, &format!("found_{seed}_{}", program.name));
    let path = folder().join(format!("{}.rs", program.name));
    std::fs::create_dir_all(folder()).expect("a folder for what was found");
    std::fs::write(&path, &program.text).expect("a file");
    path
}

/// Returns all programs that are kept.
pub fn programs() -> Vec<Program> {
    programs_in(&folder())
}

/// Returns the programs of any folder.
pub fn programs_in(folder: &Path) -> Vec<Program> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|it| it == "rs"));
    paths.sort();
    let read = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).expect("a program that was found");
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        program(&name, &text).unwrap_or_else(|| panic!("{}: nothing to call", path.display()))
    };
    paths.into_iter().map(read).collect()
}

/// A program read from its text; none where the text is no Rust or has nothing to call.
fn program(name: &str, text: &str) -> Option<Program> {
    let file = syn::parse_file(text).ok()?;
    let component = file.items.iter().rev().find_map(|item| match item {
        Item::Impl(it) if it.trait_.is_none() && attribute(&it.attrs, "component").is_some() => {
            Some(it)
        }
        _ => None,
    });
    let entries: Vec<Entry> = match component {
        Some(component) => component.items.iter().filter_map(method).collect(),
        None => {
            file.items.iter().flat_map(functions).filter(|it| it.name.starts_with(name)).collect()
        }
    };
    let unit = component.map(|it| it.self_ty.to_token_stream().to_string());
    // Only programs that aim at the proofs choose among instances of a function.
    let instances = text.matches(&format!(" => {name}_of::<")).count();
    let instances = (instances > 0).then_some(instances);
    let text = text.to_owned();
    (!entries.is_empty()).then(|| Program { name: name.to_owned(), text, unit, entries, instances })
}

/// Returns the public functions of an item: itself, or those of a public module.
fn functions(item: &Item) -> Vec<Entry> {
    match item {
        Item::Fn(it) if is_public(&it.vis) && attribute(&it.attrs, "function").is_some() => {
            vec![entry(&it.sig, false, false)]
        }
        Item::Mod(it) if is_public(&it.vis) => {
            it.content.iter().flat_map(|(_, items)| items).flat_map(functions).collect()
        }
        _ => Vec::new(),
    }
}

/// An entry point of a component.
fn method(item: &ImplItem) -> Option<Entry> {
    let ImplItem::Fn(it) = item else { return None };
    let arguments = attribute(&it.attrs, "entry")?.to_token_stream().to_string();
    let is_atomic = arguments.contains("atomic");
    let changes = it
        .sig
        .receiver()
        .is_some_and(|it| matches!(it.kind, syn::ReceiverKind::Reference(_, _, Some(_))));
    Some(entry(&it.sig, is_atomic, changes && !is_atomic))
}

fn entry(signature: &syn::Signature, atomic: bool, stops: bool) -> Entry {
    let params = signature.inputs.iter().filter_map(|input| match input {
        FnArg::Typed(it) => Some(passing(&it.ty)),
        FnArg::Receiver(_) => None,
    });
    Entry { name: signature.ident.to_string(), params: params.collect(), atomic, stops }
}

fn passing(ty: &Type) -> (&'static str, String) {
    let (passing, ty) = match ty {
        Type::Reference(it) if it.mutability.is_some() => ("&mut ", &*it.elem),
        Type::Reference(it) => ("&", &*it.elem),
        ty => ("", ty),
    };
    (passing, ty.to_token_stream().to_string())
}

fn attribute<'a>(attributes: &'a [Attribute], name: &str) -> Option<&'a Attribute> {
    attributes.iter().find(|it| it.path().is_ident(name))
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

#[test]
fn a_program_reads_back_from_its_text() {
    let mut random = bessemer_tests::random::Random(3);
    let parts = |program: &Program| {
        let spaceless = |text: &str| text.replace(' ', "");
        let entry = |it: &Entry| {
            let params = it.params.iter().map(|(passing, ty)| (*passing, spaceless(ty)));
            (it.name.clone(), params.collect::<Vec<_>>(), it.atomic, it.stops)
        };
        let entries = program.entries.iter().map(entry).collect::<Vec<_>>();
        (program.name.clone(), program.unit.clone(), entries, program.instances)
    };
    for index in 0..60 {
        let name = format!("p{index}");
        let one = match index % 3 {
            0 => super::aimed::program(&mut random, &name, 1 + index),
            _ => super::writer::program(&mut random, &name),
        };
        let read = program(&one.name, &one.text).expect("its own text");
        assert_eq!(parts(&read), parts(&one), "{}", one.text);
    }
}
