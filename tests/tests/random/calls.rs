//! Random calls: of functions, methods and closures, and of the methods that take closures.

use super::types::Ty;
use super::writer::{Callee, Kind, Place, Writer};

impl Writer<'_> {
    /// A call of a function, a method or a closure with such a result.
    pub fn called(&mut self, ty: &Ty, fuel: usize) -> Option<String> {
        let closures: Vec<_> =
            self.closures().into_iter().filter(|it| self.env[*it].ty == *ty).collect();
        if !closures.is_empty() && self.one_in(2) {
            let at = closures[self.below(closures.len())];
            let Kind::Closure(param, changes) = self.env[at].kind.clone() else { return None };
            let name = self.env[at].name.clone();
            self.lend(at, changes);
            let value = self.value(&param, fuel - 1);
            self.end(at, changes);
            self.mention(at, changes);
            return Some(format!("{name}({value})"));
        }
        let fitting: Vec<_> = self.callees.iter().filter(|it| it.result == *ty).cloned().collect();
        if fitting.is_empty() {
            return None;
        }
        let callee = fitting[self.below(fitting.len())].clone();
        self.call(&callee, fuel - 1)
    }

    /// A call, if there is something to lend for each `&mut`.
    pub fn call(&mut self, callee: &Callee, fuel: usize) -> Option<String> {
        let mut loans = Vec::new();
        let mut texts = Vec::new();
        let mut whole = true;
        for (at, (ty, kind)) in callee.params.iter().enumerate() {
            let receiver = at == 0 && callee.method;
            match kind {
                Kind::Owned => texts.push(self.value(ty, fuel)),
                Kind::Closure(from, changes) => {
                    let kept = self.freeze_all(!changes);
                    let (closure, _) = self.lambda(from, ty, fuel);
                    self.thaw(kept);
                    texts.push(closure);
                }
                Kind::Exclusive => {
                    if let Some(t) = self.trace(ty) {
                        self.lend(t, true);
                        loans.push((t, true));
                        self.mention(t, true);
                        texts.push("t".to_owned());
                        continue;
                    }
                    let Some(place) = self.lent(ty, true) else {
                        whole = false;
                        break;
                    };
                    self.lend(place.root, true);
                    loans.push((place.root, true));
                    texts.push(if receiver { place.text } else { format!("&mut {}", place.text) });
                }
                _ => {
                    let Some(place) = self.lent(ty, false) else {
                        whole = false;
                        break;
                    };
                    self.lend(place.root, false);
                    loans.push((place.root, false));
                    texts.push(if receiver { place.text } else { format!("&{}", place.text) });
                }
            }
        }
        loans.into_iter().for_each(|(var, write)| self.end(var, write));
        if !whole {
            return None;
        }
        Some(if callee.method {
            format!("{}.{}({})", texts[0], callee.name, texts[1..].join(", "))
        } else {
            format!("{}({})", callee.name, texts.join(", "))
        })
    }

    /// A place to lend for a parameter: of its type, or some elements for a slice.
    pub fn lent(&mut self, ty: &Ty, write: bool) -> Option<Place> {
        let Ty::Slice(element) = ty else { return self.any_place(write, &|it| it == ty) };
        let fits = |it: &Ty| it.sequence().is_some_and(|(of, _)| *of == **element);
        let mut place = self.any_place(write, &fits)?;
        let (_, len) = place.ty.sequence()?;
        let slice = matches!(place.ty, Ty::Slice(_));
        let of = if matches!(place.ty, Ty::List(..)) {
            format!("{}.as_{}slice()", place.text, if write { "mut_" } else { "" })
        } else {
            place.text.clone()
        };
        self.lend(place.root, write);
        place.text = match self.below(4) {
            0 => format!("{of}[{}..]", self.position(len, 1)),
            1 => format!("{of}[..{}]", self.position(len, 1)),
            2 => {
                let low = self.below(len + 1);
                format!("{of}[{low}..{}]", low + self.below(len + 1 - low))
            }
            _ if slice => of,
            _ => format!("{of}[..]"),
        };
        self.end(place.root, write);
        Some(place)
    }

    /// `t`, for a parameter that may be it.
    fn trace(&mut self, ty: &Ty) -> Option<usize> {
        let t = self.env.iter().position(|var| var.name == "t")?;
        (*ty == Ty::Int("u64") && self.writable(t)).then_some(t)
    }

    /// A value out of an `Option` or a `Result`.
    pub fn unwrapped(&mut self, ty: &Ty, fuel: usize) -> String {
        let option = Ty::Option(Box::new(ty.clone()));
        let value = self.value(&option, fuel - 1);
        match (self.below(4), self.result.clone()) {
            (0 | 1, Some(Ty::Option(_))) => format!("{value}?"),
            (0 | 1, Some(Ty::Result(_, error))) => {
                let error = self.items.error_for(self.random, &error);
                let result = Ty::Result(Box::new(ty.clone()), Box::new(error));
                format!("{}?", self.value(&result, fuel - 1))
            }
            (0, _) if self.risky() => format!("{value}.unwrap()"),
            (1, _) => {
                let (default, _) = self.tracked(|it| it.unreturned(|it| it.value(ty, fuel - 1)));
                format!("{value}.unwrap_or_else(|| {default})")
            }
            (2, _) if self.one_in(3) => {
                let error = self.items.any(self.random, 0, true);
                let result = Ty::Result(Box::new(ty.clone()), Box::new(error.clone()));
                let result = self.value(&result, fuel - 1);
                if self.one_in(2) {
                    return format!("{result}.unwrap_or({})", self.value(ty, fuel - 1));
                }
                let (closure, _) = self.lambda(&error, ty, fuel - 1);
                format!("{result}.unwrap_or_else({closure})")
            }
            (2, _) => {
                let default = self.value(ty, fuel - 1);
                let other = self.items.any(self.random, 0, true);
                let from = self.value(&Ty::Option(Box::new(other.clone())), fuel - 1);
                let (closure, _) = self.lambda(&other, ty, fuel - 1);
                format!("{from}.map_or({default}, {closure})")
            }
            _ => {
                let default = self.value(ty, fuel - 1);
                format!("{value}.unwrap_or({default})")
            }
        }
    }

    /// Writes within a closure, where nothing of the function around can be left.
    pub fn unreturned<T>(&mut self, write: impl FnOnce(&mut Self) -> T) -> T {
        let (result, loops) = (self.result.take(), std::mem::take(&mut self.loops));
        let value = write(self);
        (self.result, self.loops) = (result, loops);
        value
    }

    /// `|x| …`, and what it mentions.
    pub fn lambda(&mut self, from: &Ty, to: &Ty, fuel: usize) -> (String, Vec<(usize, bool)>) {
        self.tracked(|it| {
            it.unreturned(|it| {
                let before = it.env.len();
                let pattern = it.pattern(from, &Kind::Owned, false, 1);
                let value = it.inner_block(to, fuel);
                it.close(before);
                format!("|{pattern}| {{ {value} }}")
            })
        })
    }

    /// `|x| …` of a reference.
    pub fn predicate(&mut self, of: &Ty, fuel: usize) -> String {
        self.unreturned(|it| {
            let before = it.env.len();
            let pattern = it.pattern(of, &Kind::Shared, false, 1);
            let value = it.logical(fuel);
            it.close(before);
            format!("|{pattern}| {value}")
        })
    }
}
