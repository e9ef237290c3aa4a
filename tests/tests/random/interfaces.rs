//! Random interfaces: traits, what implements them, and functions of whatever does.

use std::fmt::Write as _;

use super::types::{INTS, Ty};
use super::writer::{Callee, Kind, Var, Writer};

/// A method of the interface: its name, its parameters behind `self`, its result, and whether it changes `self`.
struct Method {
    name: String,
    of: Ty,
    result: Ty,
    changes: bool,
}

impl Method {
    fn kind(&self) -> Kind {
        if self.changes { Kind::Exclusive } else { Kind::Shared }
    }
}

impl Writer<'_> {
    /// An interface, implemented by some of the program's types and two of its own, and functions that take any of them.
    pub fn interface(&mut self, prefix: &str) -> String {
        let upper = prefix.to_uppercase();
        let (name, limit) = (format!("{upper}Way"), format!("{upper}_LIMIT"));
        let int = self.random.of(&INTS);
        let methods: Vec<Method> = (0..1 + self.below(2))
            .map(|at| Method {
                name: format!("{prefix}_way{at}"),
                of: self.items.any(self.random, 1, true),
                result: self.items.any(self.random, 1, true),
                changes: self.one_in(2),
            })
            .collect();
        let whole = Method {
            name: format!("{prefix}_both"),
            of: methods[0].of.clone(),
            result: methods[0].result.clone(),
            changes: true,
        };
        let mut text = format!("#[interface]\npub trait {name} {{\nconst {limit}: {int};\n");
        for method in &methods {
            let _ = writeln!(text, "{};", self.head(method));
        }
        let _ = writeln!(
            text,
            "{} {{ let _ = self.{1}(x); self.{1}(x) }}\nfn {prefix}_limit(&self) -> {int} {{ Self::{limit} }}\n}}",
            self.head(&whole),
            methods[0].name
        );
        let implementors = self.implementors(&upper, &mut text);
        for this in implementors {
            let own = self.one_in(3).then_some(&whole);
            let of = self.items.name(&this);
            let value = self.below(100);
            let _ =
                writeln!(text, "#[data]\nimpl {name} for {of} {{\nconst {limit}: {int} = {value};");
            for method in methods.iter().chain(own) {
                text += &self.implementation(method, &this);
            }
            text += "}\n";
            for method in methods.iter().chain([&whole]) {
                self.callable(method, &this, method.name.clone(), true);
            }
            let params = vec![(this.clone(), Kind::Shared)];
            let result = Ty::Int(int);
            for function in [format!("{prefix}_limit"), format!("{prefix}_of")] {
                let method = function.ends_with("limit");
                let params = params.clone();
                self.callees.push(Callee {
                    name: function,
                    params,
                    result: result.clone(),
                    method,
                });
            }
            self.callable(&whole, &this, format!("{prefix}_driven"), false);
        }
        let (of, result) = (self.items.name(&whole.of), self.items.name(&whole.result));
        let _ = writeln!(
            text,
            "#[function]\nfn {prefix}_driven<W: {name}>(way: &mut W, x: {of}) -> {result} {{ way.{prefix}_both(x) }}\n\
             #[function]\nfn {prefix}_of<W: {name}>(way: &W) -> {int} {{ way.{prefix}_limit().wrapping_add(W::{limit}) }}"
        );
        text
    }

    fn head(&self, method: &Method) -> String {
        let (of, result) = (self.items.name(&method.of), self.items.name(&method.result));
        let and = if method.changes { "&mut " } else { "&" };
        format!("fn {}({and}self, x: {of}) -> {result}", method.name)
    }

    /// Types that implement the interface: a struct of its own, and one of the program's.
    fn implementors(&mut self, upper: &str, text: &mut String) -> Vec<Ty> {
        let ty = self.items.any(self.random, 0, true);
        let parts = super::types::Parts { names: vec!["low".to_owned()], types: vec![ty.clone()] };
        let of = self.items.name(&ty);
        let own = format!("{upper}Own");
        let _ = writeln!(
            text,
            "#[data]\n#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct {own} {{ pub low: {of} }}"
        );
        self.items.structs.push((own, parts));
        let own = Ty::Struct(self.items.structs.len() - 1);
        let mut all = vec![own.clone()];
        all.extend(self.implemented().filter(|other| *other != own));
        all
    }

    fn implementation(&mut self, method: &Method, this: &Ty) -> String {
        let kind = method.kind();
        self.env = vec![
            Var::new("self", this, kind, false),
            Var::new("x", &method.of, Kind::Owned, false),
        ];
        self.result = Some(method.result.clone());
        // What it calls is what was there before, so that no implementation calls itself.
        let body = self.whole(1, &method.result);
        format!("{} {{\n{body}}}\n", self.head(method))
    }

    fn callable(&mut self, of: &Method, this: &Ty, name: String, method: bool) {
        let kind = if method { of.kind() } else { Kind::Exclusive };
        let params = vec![(this.clone(), kind), (of.of.clone(), Kind::Owned)];
        self.callees.push(Callee { name, params, result: of.result.clone(), method });
    }
}
