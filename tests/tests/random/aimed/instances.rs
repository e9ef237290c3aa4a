//! The instances of a text without rustc: it sees one function of the constants, or one instance, instead of all of them,
//! which costs it a tenth.
//!
//! Invariant: what is made here is what rustc makes of the whole text. Batches that rustc gets as a whole hold it.

use std::collections::BTreeMap;

use bessemer_ir::tree::visit::{self, Visit};
use bessemer_ir::tree::{Argument, Callee, Expr, ExprKind, Function, Package};

use super::super::writer::Program;

/// The text as a function of the constants, in which it is generic: the lines are the same.
pub fn with_constants_as_arguments(program: &Program) -> String {
    let (declared, given) = (format!("{}_of<", program.name), given(program));
    let plain = |line: &str| {
        let (mark, is_declared) = match line {
            _ if line.contains(&declared) => (declared.as_str(), true),
            _ if line.contains(&given) => (given.as_str(), false),
            _ => return line.to_owned(),
        };
        let (before, rest) = line.split_once(mark).expect("it is there");
        let (constants, after) = rest.split_once(">(").expect("constants, then arguments");
        let constants =
            if is_declared { constants.replace("const ", "") } else { constants.to_owned() };
        format!("{before}{}_of({constants}, {after}", program.name)
    };
    lines(program, plain)
}

/// The text with its first instance in the place of each other.
pub fn of_first_instance(program: &Program) -> String {
    let Some(first) = constants(program).into_iter().next() else { return program.text.clone() };
    let (given, first) = (given(program), text(&first));
    lines(program, |line| match line.split_once(&given) {
        Some((before, rest)) => {
            let (_, after) = rest.split_once(">(").expect("constants, then arguments");
            format!("{before}{given}{first}>({after}")
        }
        None => line.to_owned(),
    })
}

/// Puts the instances into the tree of a text that has its first one alone.
pub fn instantiate(package: &mut Package, program: &Program) {
    let constants = constants(program);
    let Some(first) = place(package, program, constants.first()) else { return };
    let paths: Vec<String> =
        constants.iter().map(|it| instance(&package.functions[first], it).path).collect();
    if let Some(selector) = package.functions.iter_mut().find(|it| it.tree.name == program.name) {
        let arms = arms(&paths[0], selector);
        for (at, path) in arms.into_iter().zip(&paths) {
            selector.callees[at] = Callee::Function(path.clone());
        }
    }
    let mut made = BTreeMap::new();
    for constants in &constants[1..] {
        let one = instance(&package.functions[first], constants);
        made.insert(one.path.clone(), one);
    }
    made.remove(&paths[0]);
    package.functions.splice(first + 1..first + 1, made.into_values());
}

/// Whether the instances that rustc made are those that are made here.
pub fn hold(package: &Package, program: &Program) {
    let constants = constants(program);
    let Some(first) = place(package, program, constants.first()) else { return };
    for constants in &constants {
        let made = instance(&package.functions[first], constants);
        let Some(of_rustc) = package.functions.iter().find(|it| it.path == made.path) else {
            panic!("{} is no instance of rustc's", made.path)
        };
        assert_eq!(of_rustc, &made);
    }
}

fn given(program: &Program) -> String {
    format!("{}_of::<", program.name)
}

fn lines(program: &Program, change: impl Fn(&str) -> String) -> String {
    program.text.lines().map(|line| change(line) + "\n").collect()
}

fn text(constants: &[u64]) -> String {
    constants.iter().map(u64::to_string).collect::<Vec<_>>().join(", ")
}

/// The constants of each instance, in the order of the selector's arms.
fn constants(program: &Program) -> Vec<Vec<u64>> {
    let mark = given(program);
    let given = program.text.lines().filter_map(|line| line.split_once(&mark)?.1.split_once(">("));
    given.map(|(all, _)| all.split(", ").filter_map(|it| it.parse().ok()).collect()).collect()
}

fn place(package: &Package, program: &Program, first: Option<&Vec<u64>>) -> Option<usize> {
    let path = format!("{}_of<{}>", program.name, text(first?));
    package.functions.iter().position(|it| it.path.ends_with(&path))
}

/// The callees of the selector's arms, in their order: each is the first instance.
fn arms(first: &str, selector: &Function) -> Vec<usize> {
    let is_instance = |it: &Callee| matches!(it, Callee::Function(path) if path == first);
    let places = selector.callees.iter().enumerate().filter(|(_, it)| is_instance(it));
    places.map(|(at, _)| at).collect()
}

/// The instance of these constants, from one of others.
fn instance(of: &Function, constants: &[u64]) -> Function {
    let mut one = of.clone();
    let (head, _) = one.path.split_once('<').expect("it is generic");
    one.path = format!("{head}<{}>", text(constants));
    let mut words = BTreeMap::new();
    for ((name, argument), word) in one.generics.iter_mut().zip(constants) {
        if let Argument::Number(_, number) = argument {
            *number = *word;
        }
        words.insert(name.clone(), *word);
    }
    for (argument, word) in one.suffix.iter_mut().zip(constants) {
        if let Argument::Number(_, number) = argument {
            *number = *word;
        }
    }
    let mut paths = Paths(BTreeMap::new());
    paths.block(&one.tree.body);
    for (at, name) in paths.0 {
        if let Some(word) = words.get(&name) {
            one.constants[at as usize].words = vec![*word];
        }
    }
    one
}

/// The paths of a text that are constants, by their places among these.
struct Paths(BTreeMap<u32, String>);

impl Visit for Paths {
    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Path(at, name) = &expr.kind {
            self.0.insert(*at, name.clone());
        }
        visit::walk_expr(self, expr);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::aimed::{ANY, POSITIVE, program};
    use bessemer_tests::random::Random;

    #[test]
    fn constants_become_arguments_where_they_are_declared_and_given() {
        let program = program(&mut Random(5), "aimed5_0", 3);
        let text = with_constants_as_arguments(&program);
        let constants = ANY.iter().chain(&POSITIVE).map(|name| format!("{name}: usize, "));
        let declared = format!("fn aimed5_0_of({}mut a:", constants.collect::<String>());
        assert!(text.contains(&declared), "{text}");
        assert_eq!(text.matches("=> aimed5_0_of(").count(), 3);
        assert!(!text.contains("_of<") && !text.contains("_of::<"), "{text}");
        assert_eq!(text.lines().count(), program.text.lines().count());
    }

    #[test]
    fn the_first_instance_stands_for_each() {
        let program = program(&mut Random(5), "aimed5_0", 3);
        let all = constants(&program);
        assert_eq!((all.len(), all[0].len()), (3, ANY.len() + POSITIVE.len()));
        let text = of_first_instance(&program);
        let first = format!("=> aimed5_0_of::<{}>(", super::text(&all[0]));
        assert_eq!(text.matches(&first).count(), 3, "{text}");
    }
}
