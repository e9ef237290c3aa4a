//! Sizes by name: the marked constants by which an author says how many elements a field, a parameter or a result has.
//!
//! A name stands for a constant where a marked one has this name and this number as its value, and other modules may read it;
//! else it says nothing, and the C has the number.

use bessemer_ir::tree;
use bessemer_ir::{Attributes, Local, Type};

use super::Context;

impl Context<'_> {
    /// The constants that names in the type of something mean, with their modules; nothing if none means any.
    pub(super) fn sizes(&mut self, module: &str, ty: &Type, names: &[String]) -> Vec<String> {
        let mut numbers = Vec::new();
        dimensions(ty, &mut numbers);
        let both = names.iter().zip(numbers);
        let all: Vec<String> = both.map(|(name, number)| self.size(module, name, number)).collect();
        if all.iter().all(String::is_empty) { Vec::new() } else { all }
    }

    fn size(&mut self, module: &str, name: &str, number: u32) -> String {
        let words = [u64::from(number)];
        let said = self.table(module, name, &Type::USIZE, &words);
        if !said.is_some_and(|table| table.public) {
            return String::new();
        }
        let id = self.constant(module, name, &Type::USIZE, &words);
        self.module.consts[id.index()].path()
    }

    /// The same of all parameters of a function, and of its result. What its own parameters are called is no constant.
    pub(super) fn sizes_of(
        &mut self,
        source: &tree::Function,
        parameters: &[Local],
        result: &Type,
    ) -> Attributes {
        let mut attributes = source.tree.attributes.clone();
        let own = |name: &String| source.generics.iter().any(|(own, _)| own == name);
        let mut sizes = |ty: &Type, names: &[String]| {
            let names =
                names.iter().map(|name| if own(name) { String::new() } else { name.clone() });
            self.sizes(&source.module, ty, &names.collect::<Vec<_>>())
        };
        for (name, given) in &mut attributes.parameters {
            let local = parameters.iter().find(|local| local.name == *name);
            given.sizes = local.map_or(Vec::new(), |local| sizes(&local.ty, &given.sizes));
        }
        attributes.result.sizes = sizes(result, &attributes.result.sizes);
        attributes
    }
}

/// The numbers of elements of a type, from the outside in, rows before columns.
fn dimensions(ty: &Type, numbers: &mut Vec<u32>) {
    match ty {
        Type::Array { element, len } => {
            numbers.push(*len);
            dimensions(element, numbers);
        }
        Type::Matrix { rows, cols, .. } => numbers.extend([*rows, *cols]),
        _ => {}
    }
}
