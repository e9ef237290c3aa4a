//! The documentation of the blocks on the book's pages, read from the sources of `bessemer-blocks`.
//!
//! Between `<!-- blocks: pid of pid_f32_step -->` and `<!-- end -->` is the documentation of `blocks/src/pid.rs`: first the
//! module's, then each public item's with its fields and methods; at last that function of its C.

use std::fmt::Write as _;
use std::fs;

use bessemer_tests::root;
use syn::{Attribute, ImplItem, Item, Type, Visibility};

/// Folder of the sources.
pub const SOURCES: &str = "blocks/src";
/// Instructions of the blocks, as `examples/blocks/costs.sh` counts them.
const COSTS: &str = "examples/blocks/costs.tsv";
/// The mark of a module's documentation on a page.
pub const MARK: &str = "<!-- blocks: ";

/// Returns the module whose documentation a line of a page requests, and the function whose C is shown.
pub fn marked(line: &str) -> Option<(&str, &str)> {
    line.strip_prefix(MARK)?.strip_suffix(" -->")?.split_once(" of ")
}

/// Returns the name of the golden C of a module's instances.
pub fn golden(module: &str) -> String {
    format!("bessemer_blocks/{module}")
}

/// Returns the modules of the crate.
pub fn modules() -> Vec<String> {
    let files = fs::read_dir(root().join(SOURCES)).expect("the blocks are there").flatten();
    let names = files.filter_map(|it| Some(it.path().file_stem()?.to_str()?.to_owned()));
    let mut modules: Vec<String> = names.filter(|name| name != "lib").collect();
    modules.sort();
    modules
}

/// Returns the documentation of a module.
pub fn documentation(module: &str) -> String {
    let path = root().join(SOURCES).join(format!("{module}.rs"));
    let source = fs::read_to_string(&path).unwrap_or_else(|_| panic!("no blocks in {path:?}"));
    let file = syn::parse_file(&source).expect("Rust");
    let mut text = format!("\n{}\n", documented(&file.attrs));
    let costs = fs::read_to_string(root().join(COSTS)).expect("the costs are there");
    for item in &file.items {
        let Some((name, attributes)) = public(item) else { continue };
        let _ = write!(text, "\n## `{name}`\n\n{}\n", documented(attributes));
        text.push_str(&cost(&costs, &name));
        match item {
            Item::Struct(it) => {
                let fields = it.fields.iter().filter(|field| is_public(&field.vis));
                list(
                    &mut text,
                    fields.filter_map(|it| Some((it.ident.as_ref()?.to_string(), &it.attrs[..]))),
                );
                list(&mut text, methods(&file.items, &name));
            }
            Item::Enum(it) => {
                list(&mut text, it.variants.iter().map(|it| (it.ident.to_string(), &it.attrs[..])));
            }
            _ => {}
        }
    }
    text.push('\n');
    text
}

/// Returns the cost of an item, of each counted entry point.
fn cost(costs: &str, name: &str) -> String {
    let snake = name.chars().fold(String::new(), |text, letter| match letter.is_uppercase() {
        true if !text.is_empty() => text + "_" + &letter.to_lowercase().to_string(),
        _ => text + &letter.to_lowercase().to_string(),
    });
    let row = |line: &str| {
        let mut cells = line.split('\t');
        let (entry, m4f, a9) = (cells.next()?, cells.next()?, cells.next()?);
        let (owner, method) = entry.split_once("::")?;
        let what = match owner {
            "Functions" if method == snake => String::new(),
            _ if owner.strip_suffix("Cost") == Some(name) => format!("`{method}`: "),
            _ => return None,
        };
        Some(format!("{what}{m4f} instructions on a Cortex-M4F, {a9} on a Cortex-A9"))
    };
    let rows: Vec<String> = costs.lines().filter_map(row).collect();
    match rows.is_empty() {
        true => String::new(),
        false => format!("\nAt most, in `f32`: {}.\n", rows.join("; ")),
    }
}

/// Returns the name and the attributes of a public item that has a place in the book.
fn public(item: &Item) -> Option<(String, &[Attribute])> {
    let (visibility, name, attributes) = match item {
        Item::Struct(it) => (&it.vis, &it.ident, &it.attrs),
        Item::Enum(it) => (&it.vis, &it.ident, &it.attrs),
        Item::Trait(it) => (&it.vis, &it.ident, &it.attrs),
        Item::Fn(it) => (&it.vis, &it.sig.ident, &it.attrs),
        Item::Static(it) => (&it.vis, &it.ident, &it.attrs),
        Item::Const(it) => (&it.vis, &it.ident, &it.attrs),
        _ => return None,
    };
    is_public(visibility).then(|| (name.to_string(), &attributes[..]))
}

/// Returns the public methods of a type, by their calls.
fn methods<'f>(items: &'f [Item], name: &str) -> Vec<(String, &'f [Attribute])> {
    let mut found = Vec::new();
    for item in items {
        let Item::Impl(block) = item else { continue };
        let Type::Path(ty) = &*block.self_ty else { continue };
        if block.trait_.is_some() || ty.path.segments.last().is_none_or(|last| last.ident != name) {
            continue;
        }
        for item in &block.items {
            let ImplItem::Fn(method) = item else { continue };
            if !is_public(&method.vis) {
                continue;
            }
            let arguments = method.sig.inputs.iter().filter_map(|input| match input {
                syn::FnArg::Typed(it) => match &*it.pat {
                    syn::Pat::Ident(name) => Some(name.ident.to_string()),
                    _ => None,
                },
                syn::FnArg::Receiver(_) => None,
            });
            let call =
                format!("{}({})", method.sig.ident, arguments.collect::<Vec<_>>().join(", "));
            found.push((call, &method.attrs[..]));
        }
    }
    found
}

/// Appends a list of documented parts.
fn list<'f>(text: &mut String, parts: impl IntoIterator<Item = (String, &'f [Attribute])>) {
    for (index, (name, attributes)) in parts.into_iter().enumerate() {
        let unit = attributes.iter().find(|it| it.path().is_ident("unit"));
        let unit = unit.and_then(|it| it.parse_args::<syn::LitStr>().ok());
        let unit = unit.map_or(String::new(), |unit| format!(" Unit: {}.", unit.value()));
        let said = documented(attributes).replace('\n', " ");
        let _ = writeln!(text, "{}* `{name}`: {said}{unit}", if index == 0 { "\n" } else { "" });
    }
}

/// Returns the text of a documentation. Links to items become their names.
fn documented(attributes: &[Attribute]) -> String {
    let lines = attributes.iter().filter(|it| it.path().is_ident("doc"));
    let lines = lines.filter_map(|it| match &it.meta.require_name_value().ok()?.value {
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
        _ => None,
    });
    let (mut text, mut is_code) = (String::new(), false);
    for line in lines {
        let line = line.strip_prefix(' ').unwrap_or(&line);
        if line == "```" {
            text += if is_code { "```\n" } else { "```rust\n" };
            is_code = !is_code;
            continue;
        }
        is_code ^= line.starts_with("```");
        let line =
            if is_code { line.to_owned() } else { line.replace("[`", "`").replace("`]", "`") };
        let _ = writeln!(text, "{line}");
    }
    text.trim_end().to_owned()
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

#[test]
fn each_module_of_blocks_is_on_one_page() {
    let pages = fs::read_dir(root().join("docs/book/blocks")).expect("the pages are there");
    let texts = pages.flatten().map(|it| fs::read_to_string(it.path()).expect("a page"));
    let texts: Vec<String> = texts.collect();
    let mut shown: Vec<String> = texts
        .iter()
        .flat_map(|text| text.lines().filter_map(marked).map(|(module, _)| module.to_owned()))
        .collect();
    shown.sort();
    assert_eq!(shown, modules());
}
