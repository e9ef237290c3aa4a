//! Random chains of iterators, and closures that fill arrays.

use super::types::Ty;
use super::writer::{Kind, Place, Var, Writer};

impl Writer<'_> {
    /// An array or a list to go through.
    fn sequence(&mut self, wanted: &dyn Fn(&Ty) -> bool) -> Option<(Place, Ty)> {
        let place = self.any_place(false, &|ty| {
            ty.sequence().is_some_and(|(element, _)| element.is_data() && wanted(element))
        })?;
        let element = place.ty.sequence()?.0.clone();
        Some((place, element))
    }

    /// A chain that ends in a value of the type.
    pub fn chain(&mut self, ty: &Ty, fuel: usize) -> Option<String> {
        let wanted = |element: &Ty| match ty {
            Ty::Option(inner) => **inner == *element || **inner == Ty::Int("usize"),
            _ => true,
        };
        if !ty.is_scalar() && !matches!(ty, Ty::Option(_)) && !self.one_in(3) {
            return None;
        }
        let (place, element) = self.sequence(&wanted)?;
        self.lend(place.root, false);
        let text = self.ended(ty, &place, &element, fuel - 1);
        self.end(place.root, false);
        text
    }

    fn ended(&mut self, ty: &Ty, place: &Place, element: &Ty, fuel: usize) -> Option<String> {
        let iter = format!("{}.iter()", place.text);
        let iter = match self.below(6) {
            0 => format!("{iter}.rev()"),
            1 => format!("{iter}.skip({})", self.below(3)),
            2 => format!("{iter}.take({})", self.below(4)),
            _ => iter,
        };
        Some(match ty {
            Ty::Bool if !self.one_in(4) => {
                let test = self.element_test(element, fuel);
                format!("{iter}.{}({test})", self.random.of(&["any", "all"]))
            }
            Ty::Int("usize") if self.one_in(2) => {
                let test = self.predicate_of_reference(element, fuel);
                format!("{iter}.filter({test}).count()")
            }
            Ty::Option(inner) if **inner == *element => {
                let test = self.predicate_of_reference(element, fuel);
                match self.below(4) {
                    0 if matches!(element, Ty::Int(_)) => {
                        let end = self.random.of(&["min", "max"]);
                        format!("{iter}.copied().{end}()")
                    }
                    1 => {
                        let key = Ty::Int(self.random.of(&["u8", "i16", "u64"]));
                        let before = self.env.len();
                        let name = self.new_name();
                        self.env.push(Var::new(name, element, Kind::Shared, false));
                        let key = self.unreturned(|it| it.value(&key, fuel));
                        self.env.truncate(before);
                        let end = self.random.of(&["min_by_key", "max_by_key"]);
                        format!("{iter}.{end}(|{name}| {key}).copied()")
                    }
                    _ => format!("{iter}.find({test}).copied()"),
                }
            }
            Ty::Option(_) => {
                let test = self.element_test(element, fuel);
                format!("{}.iter().position({test})", place.text)
            }
            _ => {
                let before = self.env.len();
                let names = ["sum", "x", "item", "b"];
                let (sum, name) = (names[self.below(2)], names[2 + self.below(2)]);
                let filter = if self.one_in(3) {
                    // Two closures could change the same; only one of them may.
                    format!(".filter({})", self.predicate_of_reference(element, fuel))
                } else {
                    String::new()
                };
                let kept = self.freeze_all(!filter.is_empty());
                let start = self.value(ty, fuel);
                self.env.push(Var::new(sum, ty, Kind::Owned, false));
                self.env.push(Var::new(name, element, Kind::Shared, false));
                let step = self.unreturned(|it| it.inner_block(ty, fuel));
                self.env.truncate(before);
                self.thaw(kept);
                format!("{iter}{filter}.fold({start}, |{sum}, {name}| {{ {step} }})")
            }
        })
    }

    /// `|x| …` that is handed an element.
    fn element_test(&mut self, element: &Ty, fuel: usize) -> String {
        self.predicate(element, fuel)
    }

    /// `|x| …` that is handed a reference to one, and changes nothing.
    fn predicate_of_reference(&mut self, element: &Ty, fuel: usize) -> String {
        let kept = self.freeze_all(true);
        let text = self.unreturned(|it| {
            let before = it.env.len();
            let name = it.new_name();
            it.env.push(Var::new(name, element, Kind::Shared, false));
            let value = it.logical(fuel);
            it.env.truncate(before);
            format!("|&{name}| {value}")
        });
        self.thaw(kept);
        text
    }

    /// Nothing in scope may be changed, until it thaws.
    pub fn freeze_all(&mut self, really: bool) -> Vec<usize> {
        let all: Vec<usize> = if really { (0..self.env.len()).collect() } else { Vec::new() };
        all.iter().for_each(|var| self.lend(*var, false));
        all
    }

    pub fn thaw(&mut self, frozen: Vec<usize>) {
        frozen.into_iter().for_each(|var| self.end(var, false));
    }

    /// `[…].map(|x| …)`.
    pub fn mapped(&mut self, element: &Ty, len: usize, fuel: usize) -> String {
        let from = self.items.any(self.random, 1, true);
        let source = self.value(&Ty::Array(Box::new(from.clone()), len), fuel);
        let (closure, _) = self.lambda(&from, element, fuel);
        format!("{source}.map({closure})")
    }

    /// `core::array::from_fn(|i| …)`.
    pub fn filled_by_index(&mut self, element: &Ty, len: usize, fuel: usize) -> String {
        let before = self.env.len();
        let name = self.new_name();
        self.env.push(Var::new(name, &Ty::Int("usize"), Kind::Owned, false));
        let value = self.unreturned(|it| it.inner_block(element, fuel));
        self.env.truncate(before);
        let of = self.items.name(element);
        format!("core::array::from_fn::<{of}, {len}, _>(|{name}| {{ {value} }})")
    }
}
