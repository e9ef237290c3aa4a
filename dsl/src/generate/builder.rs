//! The package while it is built: definitions, each after those that it uses, and refusals.
//!
//! Must not know: slots, companions and operators, which use it.

use alloc::borrow::ToOwned;
use alloc::collections::{BTreeMap, BTreeSet};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use bessemer_tree as tree;
use bessemer_tree::attributes::{Beyond, Given, Range};
use bessemer_tree::number::Scalar;
use bessemer_tree::{Argument, DefinitionKind, Package, Refusal, Site, Ty};

use super::own::Own;
use crate::Plain;

/// Contents of a package so far.
#[derive(Default)]
pub struct Builder {
    pub(super) package: Package,
    pub(super) known: BTreeSet<String>,
    /// The functions being built, outermost first.
    pub(super) stack: Vec<Underway>,
    /// Functions of generic types' instances that have no call in the source, by trait, type and operand; they are
    /// not built yet.
    pub(super) untold: BTreeMap<[&'static str; 3], OwnOperator>,
}

/// A marked implementation of an operator, or of a function without a call in the source.
#[derive(Clone, Copy)]
pub struct OwnOperator {
    /// Trait.
    pub name: &'static str,
    /// Type of the first operand.
    pub left: fn(&mut Builder) -> Ty,
    /// Type of the second operand; for a sign, of the operand.
    pub right: fn(&mut Builder) -> Ty,
    /// Function that builds it.
    pub build: fn(&mut Builder) -> tree::Callee,
}

/// A function that is being built, with the data that functions in its body need.
#[derive(Clone)]
pub(super) struct Underway {
    pub path: String,
    /// Number of functions around it.
    pub depth: u32,
    pub owner: Option<String>,
    pub interface: Option<String>,
    pub name: String,
    pub suffix: Vec<Argument>,
}

/// Results of rustc for one function.
#[derive(Default)]
pub struct Witness {
    /// Types of its slots.
    pub slots: Vec<Ty>,
    /// Callees of its calls.
    pub callees: Vec<tree::Callee>,
    /// Author's functions of its operators; none for built-in ones.
    pub operators: Vec<Option<tree::Callee>>,
    /// Values of its constants.
    pub constants: Vec<tree::Constant>,
}

/// Marker of a function: builds the function, and names it for calls.
#[diagnostic::on_unimplemented(
    message = "this function is not part of the DSL",
    label = "not part of the DSL"
)]
pub trait Callee {
    /// Builds the function unless it is built already, and returns its name.
    fn callee(cx: &mut Builder) -> tree::Callee;
}

/// Place and name of an item.
pub struct Named {
    /// Module.
    pub module: &'static str,
    /// File, as rustc names it.
    pub file: &'static str,
    /// The author's name.
    pub name: &'static str,
}

/// The author's attributes of an item for its C: name and site, unit, range, section.
pub struct Said {
    /// C name.
    pub name: Option<&'static str>,
    /// The unit.
    pub unit: Option<&'static str>,
    /// The least and the greatest number, and what becomes of others: they are taken (0), clamped (1) or reported (2).
    pub range: Option<(f64, f64, u8)>,
    /// Fields with the points of its axes.
    pub axes: &'static [&'static str],
    /// The section of the object file.
    pub section: Option<&'static str>,
    /// True if the author writes it in hexadecimal.
    pub hexadecimal: bool,
    /// Expression of the value, if it is more than a literal.
    pub expression: Option<&'static str>,
    /// Constants that name its lengths.
    pub sizes: &'static [&'static str],
    /// True for the variant as which a value counts in the C that is no variant.
    pub fallback: bool,
    /// Site of the name, or else of the range or the axes.
    pub site: (u32, u32),
}

pub(super) fn said(said: Option<Said>) -> Given {
    let Some(said) = said else { return Given::default() };
    let Said { name, unit, range, axes, section, hexadecimal, expression, sizes, fallback, site } =
        said;
    let text = |text: Option<&'static str>| text.map(ToOwned::to_owned);
    let (name, unit, section, sizes) = (text(name), text(unit), text(section), owned(sizes));
    let (expression, axes) = (text(expression), owned(axes));
    let beyond = [Beyond::Taken, Beyond::Clamped, Beyond::Reported];
    let range = range.and_then(|(low, high, at)| {
        Some(Range::new(low, high)?.with(beyond.get(usize::from(at)).copied().unwrap_or_default()))
    });
    let site = Site(site.0, site.1);
    Given {
        name,
        unit,
        range,
        axes,
        section,
        public: false,
        hexadecimal,
        expression,
        sizes,
        fallback,
        site,
    }
}

/// Query for the default of a type. If it has one, the inherent method [`Defaults::words`] is called, which Rust
/// prefers to the trait method of [`NoDefault`].
pub struct Defaults<T>(core::marker::PhantomData<T>);

impl<T> Defaults<T> {
    /// Creates the query for the type `T`.
    pub fn of() -> Defaults<T> {
        Defaults(core::marker::PhantomData)
    }
}

impl<T: Default + Plain> Defaults<T> {
    /// Returns the words of the default.
    pub fn words(&self) -> Option<Vec<u64>> {
        Some(words(&T::default()))
    }
}

/// Answer for a type without a default.
pub trait NoDefault {
    /// Returns none.
    fn words(&self) -> Option<Vec<u64>> {
        None
    }
}

impl<T> NoDefault for Defaults<T> {}

/// Returns the words of a value.
pub fn words<T: Plain>(value: &T) -> Vec<u64> {
    let mut words = Vec::new();
    value.store(&mut |word| words.push(word));
    words
}

/// Returns a Rust path with its arguments, such as `models::Fir<f32, 4>`.
pub(super) fn path(owner: &str, name: &str, arguments: &[(String, Argument)]) -> String {
    if arguments.is_empty() {
        return format!("{owner}::{name}");
    }
    let arguments: Vec<_> = arguments.iter().map(|(_, argument)| text(argument)).collect();
    format!("{owner}::{name}<{}>", arguments.join(", "))
}

pub(super) fn text(argument: &Argument) -> String {
    match argument {
        Argument::Type(ty) => type_text(ty),
        Argument::Number(Scalar::Int(int), word) => format!("{}", int.from_word(*word)),
        Argument::Number(_, word) => format!("{word}"),
    }
}

pub(super) fn type_text(ty: &Ty) -> String {
    match ty {
        Ty::Unit => "()".to_owned(),
        Ty::Scalar(scalar) => scalar.name().to_owned(),
        Ty::Array(element, len) => format!("[{}; {len}]", type_text(element)),
        Ty::Matrix(scalar, rows, cols) => format!("SMatrix<{}, {rows}, {cols}>", scalar.name()),
        Ty::Named(path) => path.clone(),
        Ty::Slice(element) => format!("[{}]", type_text(element)),
        Ty::Ref(inner, false) => format!("&{}", type_text(inner)),
        Ty::Tuple(parts) => {
            let parts: Vec<_> = parts.iter().map(type_text).collect();
            format!("({},)", parts.join(", "))
        }
        Ty::List(element, n) => format!("List<{}, {n}>", type_text(element)),
        Ty::Option(value) => format!("Option<{}>", type_text(value)),
        Ty::Result(value, error) => format!("Result<{}, {}>", type_text(value), type_text(error)),
        Ty::Ref(inner, true) => format!("&mut {}", type_text(inner)),
        Ty::Known(name, inner) => match &**inner {
            Ty::Matrix(scalar, ..) => format!("{name}<{}>", scalar.name()),
            Ty::Scalar(_) => name.clone(),
            inner => format!("{name}<{}>", type_text(inner)),
        },
    }
}

impl Builder {
    /// Returns true if the package has a type; types without a name always exist.
    pub(super) fn knows(&self, ty: &Ty) -> bool {
        match ty {
            Ty::Named(path) => self.known.contains(path),
            _ => true,
        }
    }

    /// Adds a struct or an enum, with the derived traits among `PartialEq`, `PartialOrd` and `Copy`; `kind` is called
    /// once.
    pub fn definition(
        &mut self,
        named: Named,
        docs: &[&str],
        site: (u32, u32),
        arguments: &[(String, Argument)],
        ([equal, ordered, copied], own, given): ([bool; 3], Own, Option<Said>),
        kind: &dyn Fn(&mut Builder) -> DefinitionKind,
    ) -> Ty {
        let path = path(named.module, named.name, arguments);
        if self.known.insert(path.clone()) {
            for (message, remedy) in own.told(named.name) {
                self.refuse(named.file, Site(site.0, site.1), message, remedy);
            }
            self.package.derefs.extend(own.lends.then(|| named.name.to_owned()));
            let kind = kind(self);
            self.package.types.push(tree::Definition {
                path: path.clone(),
                module: named.module.to_owned(),
                name: named.name.to_owned(),
                arguments: arguments.iter().map(|(_, argument)| argument.clone()).collect(),
                docs: owned(docs),
                file: named.file.to_owned(),
                site: Site(site.0, site.1),
                equal,
                ordered,
                copied,
                given: said(given),
                kind,
            });
        }
        Ty::Named(path)
    }

    /// Adds a generic item; `owner` is the generic type of which it is a method.
    pub fn template(
        &mut self,
        kind: tree::TemplateKind,
        named: Named,
        site: (u32, u32),
        owner: Option<&str>,
    ) {
        self.package.templates.push(tree::Template {
            kind,
            module: named.module.to_owned(),
            name: named.name.to_owned(),
            file: named.file.to_owned(),
            site: Site(site.0, site.1),
            owner: owner.map(str::to_owned),
        });
    }

    /// Records an author-defined iterator that is `Copy`.
    pub fn copied_iterator(&mut self, named: Named, site: (u32, u32)) {
        self.refuse_copied(named.name, named.file, Site(site.0, site.1));
    }

    /// Refuses an iterator whose type derives `Copy`.
    pub(super) fn check_iterator(&mut self, owner: &Ty) {
        let is_it = |it: &&tree::Definition| matches!(owner, Ty::Named(path) if *path == it.path);
        let copied = self.package.types.iter().find(is_it).filter(|it| it.copied);
        if let Some((name, file, site)) =
            copied.map(|it| (it.name.clone(), it.file.clone(), it.site))
        {
            self.refuse_copied(&name, &file, site);
        }
    }

    fn refuse_copied(&mut self, name: &str, file: &str, site: Site) {
        let message = format!(
            "`{name}` is `Copy`, so a loop consumes a copy, and the iterator itself does not advance"
        );
        self.refuse(file, site, message, "derive `Clone` without `Copy`");
    }

    /// Returns the chain of calls by which a function calls itself.
    pub(super) fn round_trip(&self, path: &str) -> String {
        let from = self.stack.iter().position(|known| known.path == path).unwrap_or_default();
        let through: Vec<_> = self.stack[from + 1..].iter().map(|it| it.path.as_str()).collect();
        match through.as_slice() {
            [] => format!("`{path}` calls itself"),
            through => format!("`{path}` calls itself through `{}`", through.join("`, `")),
        }
    }

    pub(super) fn recursion(&mut self, path: &str, file: &str, text: &str) {
        let site = tree::read::<tree::FunctionTree>(text).map(|tree| tree.site);
        let message = self.round_trip(path);
        self.refuse(
            file,
            site.unwrap_or_default(),
            message,
            "write a loop over a range: a recursive function has no bound on its stack",
        );
    }

    pub(super) fn refuse(&mut self, file: &str, site: Site, message: String, remedy: &str) {
        let (file, remedy) = (file.to_owned(), remedy.to_owned());
        self.package.errors.push(Refusal { file, site, message, remedy });
    }
}

pub(super) fn owned(lines: &[&str]) -> Vec<String> {
    lines.iter().map(|&line| line.to_owned()).collect()
}
