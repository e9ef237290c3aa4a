//! Warns about the author's code that is not in the C.
//!
//! Generation continues. Must not know: how C is generated.

use std::collections::HashSet;

use bessemer_ir::tree::{self, Callee, DefinitionKind, Package, Site, TemplateKind, Ty};
use bessemer_ir::visit::Walk;
use bessemer_ir::{Const, ConstId, Function, Module, Owner, Role, Span, Type};

use bessemer_backend::c::{Options, Plan, outside};
use bessemer_backend::passes;
use bessemer_frontend::diagnostic::{Diagnostic, Level};

/// Largest number of words of a constant that is no table.
const FEW: usize = 8;

/// Returns the remarks on a package that became `module`, in the order of the source.
pub fn of(package: &Package, module: &Module) -> Vec<Diagnostic> {
    let mut reported: Vec<Diagnostic> = templates(package).chain(with_closures(package)).collect();
    let idle: Vec<&tree::Definition> = idle(package).collect();
    reported.extend(idle.iter().map(|it| {
        warning(
            &it.file,
            it.site,
            format!("the component `{}` has no entry point: the firmware cannot call it", it.name),
            "write `#[entry]` above the method that is called once per period; what is only part of others is `#[data]`",
        )
    }));
    reported.extend(uncalled(module, &idle));
    reported.extend(repeated(module));
    reported.extend(unchecked(module));
    reported.sort_by(|one, other| (&one.file, one.line).cmp(&(&other.file, other.line)));
    reported
}

/// Returns the reasons why a package yields no C at all, though something in it is marked.
pub fn reasons(package: &Package) -> impl Iterator<Item = Diagnostic> {
    let all = templates(package).chain(with_closures(package));
    all.map(|it| Diagnostic { level: Level::Error, ..it })
}

fn warning(file: &str, Site(line, column): Site, message: String, help: &str) -> Diagnostic {
    let (file, help) = (file.to_owned(), help.to_owned());
    Diagnostic { level: Level::Warning, file, line, column, message, help, ..Diagnostic::default() }
}

/// Returns generic items of this package without an instance: only instances are checked and become C.
fn templates(package: &Package) -> impl Iterator<Item = Diagnostic> {
    let root = package.name.replace('-', "_");
    let is_own = move |it: &&tree::Template| {
        it.kind == TemplateKind::Component || it.module.split("::").next() == Some(&*root)
    };
    let is_made = |template: &tree::Template| match template.kind {
        TemplateKind::Component | TemplateKind::Data => {
            let same =
                |it: &tree::Definition| it.name == template.name && it.module == template.module;
            package.types.iter().any(same)
        }
        TemplateKind::Function | TemplateKind::Method => package
            .functions
            .iter()
            .any(|it| (&it.file, it.tree.site) == (&template.file, template.site)),
    };
    // A generic type without an instance is reported itself, its methods are not.
    let is_of_none = |template: &tree::Template| {
        let is_it = |owner: &String| package.types.iter().any(|it| it.name == *owner);
        template.owner.as_ref().is_some_and(|owner| !is_it(owner))
    };
    let is_missing = move |it: &&tree::Template| !is_made(it) && !is_of_none(it);
    package.templates.iter().filter(is_own).filter(is_missing).map(|it| {
        let name = &it.name;
        let (message, help) = match it.kind {
            TemplateKind::Component => (
                format!("the component `{name}` is generic and has no instance: it is not in the C"),
                format!("name an instance: `#[component] pub type {name}F32 = {name}<f32>;`"),
            ),
            TemplateKind::Data => (
                format!("the type `{name}` is generic and has no instance: its methods are neither checked nor in the C"),
                "use it with a concrete type in a marked function or type, or remove it".to_owned(),
            ),
            TemplateKind::Method if it.owner.is_some() => (
                format!("no marked function calls `{name}`, a method of a generic type: it is neither checked nor in the C"),
                "call it in a marked function, or remove it".to_owned(),
            ),
            TemplateKind::Function | TemplateKind::Method => (
                format!("`{name}` is generic and no marked function calls it: it is neither checked nor in the C"),
                "call it in a marked function, with the types for which it is meant, or remove it".to_owned(),
            ),
        };
        warning(&it.file, it.site, message, &help)
    })
}

/// Returns functions of this package that take a closure or an iterator and are not called: the C has a copy for each
/// call.
fn with_closures(package: &Package) -> impl Iterator<Item = Diagnostic> {
    let root = package.name.replace('-', "_");
    let is_own = move |it: &&tree::Function| it.module.split("::").next() == Some(&*root);
    let mut called = HashSet::new();
    for function in &package.functions {
        let by_operators = function.operators.iter().map(|(_, callee)| callee);
        called.extend(function.callees.iter().chain(by_operators).filter_map(|it| match it {
            Callee::Function(path) => Some(path.as_str()),
            Callee::Builtin(_) => None,
        }));
    }
    let functions = package.functions.iter().filter(is_own);
    functions.filter(move |it| !called.contains(it.path.as_str())).filter_map(|it| {
        let param = it.tree.params.iter().find(|param| param.closure)?;
        let what = if param.items { "an iterator" } else { "a closure" };
        let name = &it.tree.name;
        Some(warning(
            &it.file,
            it.tree.site,
            format!("`{name}` takes {what} and no marked function calls it: it is neither checked nor in the C"),
            "call it in a marked function, or remove it",
        ))
    })
}

/// Returns components of this package that no type contains and no function uses.
fn idle(package: &Package) -> impl Iterator<Item = &tree::Definition> {
    let mut held = HashSet::new();
    for definition in &package.types {
        match &definition.kind {
            DefinitionKind::Struct { fields, .. } => {
                fields.iter().for_each(|it| hold(&it.ty, &mut held))
            }
            DefinitionKind::Enum(variants) => {
                let fields = variants.iter().flat_map(|variant| &variant.fields);
                fields.for_each(|it| hold(&it.ty, &mut held));
            }
        }
    }
    let root = package.name.replace('-', "_");
    let is_own = move |it: &&tree::Definition| it.module.split("::").next() == Some(&*root);
    let is_entered = |it: &tree::Definition| {
        package.functions.iter().any(|function| {
            function.owner.as_ref() == Some(&it.path)
                && matches!(function.tree.role, tree::Role::Entry { .. })
        })
    };
    package.types.iter().filter(is_own).filter(move |it| {
        let is_component = matches!(it.kind, DefinitionKind::Struct { initial: Some(_), .. });
        is_component && !held.contains(&it.path) && !is_entered(it)
    })
}

/// Collects the named types in a type.
fn hold(ty: &Ty, held: &mut HashSet<String>) {
    match ty {
        Ty::Named(path) => _ = held.insert(path.clone()),
        Ty::Tuple(parts) => parts.iter().for_each(|it| hold(it, held)),
        Ty::Array(inner, _)
        | Ty::List(inner, _)
        | Ty::Option(inner)
        | Ty::Slice(inner)
        | Ty::Ref(inner, _)
        | Ty::Known(_, inner) => hold(inner, held),
        Ty::Result(value, error) => {
            hold(value, held);
            hold(error, held);
        }
        Ty::Unit | Ty::Scalar(_) | Ty::Matrix(..) => {}
    }
}

/// Returns methods of components that nothing in the C calls.
fn uncalled<'a>(
    module: &'a Module,
    idle: &'a [&tree::Definition],
) -> impl Iterator<Item = Diagnostic> + 'a {
    // Private functions that are no methods of components are in the C even if nothing calls them.
    let of_component = |function: &Function| match (function.role, function.owner) {
        (Role::Private, Some(Owner::Struct(owner))) => {
            module.structs[owner.index()].initial.is_some().then_some(owner)
        }
        _ => None,
    };
    let mut called = HashSet::new();
    for (index, function) in module.functions.iter().enumerate() {
        if of_component(function).is_none() {
            called.extend(passes::reached(module, index));
        }
    }
    let functions = module.functions.iter().enumerate();
    functions.filter(move |(index, _)| !called.contains(index)).filter_map(move |(_, function)| {
        let owner = of_component(function)?;
        let owner_name = &module.structs[owner.index()].name;
        if idle.iter().any(|it| it.name == *owner_name) {
            return None;
        }
        let file = module.files.get(function.span.file as usize)?;
        let site = Site(function.span.line, function.span.column);
        let name = &function.name;
        let (message, help) = match makes(function, owner) {
            true => (
                format!("`{name}` is not in the C, where `Default` sets the initial state of `{owner_name}`"),
                "write these values into `impl Default`, and pass what changes to the entry point; move code for the simulation alone to an `impl` block without `#[component]`",
            ),
            false => (
                format!("`{name}` is not in the C: no entry point of `{owner_name}` calls it"),
                "write `#[entry]` above it if the firmware calls it; move code for the simulation alone to an `impl` block without `#[component]`",
            ),
        };
        Some(warning(file, site, message, help))
    })
}

/// Returns unmarked tables that several modules read, so that the C has several copies.
fn repeated(module: &Module) -> impl Iterator<Item = Diagnostic> + '_ {
    let is_table = |it: &Const| !it.ty.is_word() && it.words.len() > FEW && !it.given.public;
    let root = module.name.replace('-', "_");
    let is_own = move |it: &Const| it.module.split("::").next() == Some(&*root);
    let own = move |it: &&Const| is_table(it) && is_own(it);
    let consts = || module.consts.iter();
    let same = |one: &Const, other: &Const| {
        one.name == other.name && one.ty == other.ty && one.words == other.words
    };
    consts().enumerate().filter(move |(_, it)| own(it)).filter_map(move |(index, it)| {
        let first = consts().position(|other| is_table(other) && same(it, other))?;
        let count = consts().filter(|other| is_table(other) && same(it, other)).count();
        if first != index || count < 2 {
            return None;
        }
        let span = first_use(module, ConstId(index as u32))?;
        let file = module.files.get(span.file as usize)?;
        let (name, site) = (&it.name, Site(span.line, span.column));
        let message =
            format!("{count} modules read the table `{name}`, and the C of each has a copy");
        Some(warning(
            file,
            site,
            message,
            "write `#[data]` above the table, so that the C has it once",
        ))
    })
}

/// Parameters of infallible entry points with enums, which the firmware passes and nothing checks.
fn unchecked(module: &Module) -> impl Iterator<Item = Diagnostic> + '_ {
    let infallible = |it: &&Function| matches!(it.role, Role::Entry { infallible: true });
    module.functions.iter().filter(infallible).flat_map(move |function| {
        let mut warnings: Vec<Diagnostic> = Vec::new();
        let mut last = None;
        for it in outside::read(module, function) {
            let of = &module.enums[it.id.index()];
            let (Some(parameter), Some(variant)) =
                (function.parameters().get(it.parameter), of.variants.last())
            else {
                continue;
            };
            if of.variants.len() < 2 || of.has_fallback() || last == Some(it.parameter) {
                continue;
            }
            last = Some(it.parameter);
            let Some(file) = module.files.get(function.span.file as usize) else { continue };
            let (name, parameter) = (&function.name, &parameter.name);
            let message = format!(
                "`{name}` is infallible, and does not check `{parameter}`: the firmware may pass a value that is no variant of `{}`",
                of.name
            );
            let help = format!(
                "write `#[entry]`, which returns a status and checks it, or `#[c(fallback)]` above the variant as which such a value counts; otherwise it takes the last arm of each `match`, and is `{}` elsewhere",
                variant.name
            );
            let site = Site(function.span.line, function.span.column);
            warnings.push(warning(file, site, message, &help));
        }
        warnings
    })
}

/// Returns a remark for each function whose external name begins as another one's, as far as every linker looks.
pub fn alike(explicit: &Module, options: &Options) -> Vec<Diagnostic> {
    let alike = Plan::new(explicit, options).alike();
    let remark = |(span, name, earlier): (Span, String, String)| {
        let file = explicit.files.get(span.file as usize)?;
        let message = format!(
            "`{name}` and `{earlier}` of the C begin with the same 31 characters, and some linkers see no more"
        );
        let help = "give one a shorter name in the C: `#[c(name = \"…\")]`";
        Some(warning(file, Site(span.line, span.column), message, help))
    };
    alike.into_iter().filter_map(remark).collect()
}

/// Returns the span of the first use of a constant.
fn first_use(module: &Module, id: ConstId) -> Option<Span> {
    let mut spans = Vec::new();
    for function in &module.functions {
        function.body.each_expr(|expr| {
            spans.extend((module.constant(expr) == Some(id)).then_some(expr.span));
        });
    }
    spans.into_iter().min_by_key(|span| (span.file, span.line, span.column))
}

/// Returns true if a function constructs its owner.
fn makes(function: &Function, owner: bessemer_ir::StructId) -> bool {
    let has_receiver =
        function.locals.first().is_some_and(|it| it.name == "self") && function.params > 0;
    function.result == Type::Struct(owner) && !has_receiver
}
