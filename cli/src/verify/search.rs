//! A search for calls that raise the coverage. Known lives of a function are changed at random, and those that add
//! something are changed again.
//!
//! Invariants: each life begins in the initial state, so that what it reaches can be reached; a seed gives the same lives
//! each time. It must not know how the coverage is measured.

use std::rc::Rc;

use bessemer_ir::{FunctionId, Mode, Module, Owner, Role, Scalar, Type};
use bessemer_legs::arguments::{self, Numbers, Size};
use bessemer_legs::harness;
use bessemer_legs::longest::Numbers as Met;
use bessemer_legs::random::Random;

use super::{CALLS, LIFE};

/// Number of changed lives of a function in one round, unless their words are more than [`MOST`].
const BATCH: usize = 64;
/// Number of words after which a round has enough lives of a function.
const MOST: usize = 1 << 18;
/// Number of calls of a recording whose beginning is changed: all calls are repeated for each change.
const BEGINNING: usize = 200;
/// Number of lives of a function that are kept for changes.
const KEPT: usize = 256;

/// Successive calls of a function, the first in the initial state.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Life {
    /// Place of the function among the targets.
    pub target: usize,
    /// The words of the arguments of each call.
    pub calls: Vec<Vec<u64>>,
}

impl Life {
    /// Returns the input of a program that makes the calls from the initial state (`harness::lives`).
    pub fn bytes(&self) -> Vec<u8> {
        self.bytes_with(harness::RESTARTS)
    }

    /// Returns the input of a program that makes the calls, with a flag for the first one (`harness::counted`).
    pub fn bytes_with(&self, first: u64) -> Vec<u8> {
        let mut bytes = Vec::new();
        for (at, call) in self.calls.iter().enumerate() {
            let head = [self.target as u64, if at == 0 { first } else { harness::GOES_ON }];
            bytes.extend(head.iter().chain(call).flat_map(|word| word.to_le_bytes()));
        }
        bytes
    }
}

/// A change of one word, or of a struct.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// Place of the argument.
    pub argument: usize,
    /// Place of the first word in it.
    pub leaf: usize,
    /// The new words.
    pub words: Rc<[u64]>,
    /// True if all calls of a life are changed, and not only the last one.
    pub all: bool,
}

/// A struct with its words.
pub type Value = (Type, Rc<[u64]>);

/// A function that is called.
#[derive(Clone)]
pub struct Target {
    /// The function.
    pub id: FunctionId,
    /// Each argument with its parts.
    arguments: Vec<(Type, Vec<Type>)>,
    numbers: Numbers,
    /// Lives that reached something.
    pub known: Vec<Life>,
}

/// Returns the entry points and the public functions of a module, without those that take slices.
pub fn targets(module: &Module) -> Vec<Target> {
    let ids = (0..module.functions.len()).map(|index| FunctionId(index as u32));
    let called = |id: &FunctionId| {
        let function = &module.functions[id.index()];
        let role = matches!(function.role, Role::Entry { .. } | Role::Public);
        let has_slice = function.parameters().iter().any(|it| matches!(it.ty, Type::Slice(_)));
        role && !has_slice
    };
    ids.filter(called).map(|id| Target::of(module, id)).collect()
}

impl Target {
    fn of(module: &Module, id: FunctionId) -> Target {
        let parameters = module.functions[id.index()].parameters().iter();
        let read = harness::is_read(module, id);
        let taken = parameters.zip(read).filter(|(_, read)| *read).map(|(it, _)| it);
        let arguments = taken.map(|it| (it.ty.clone(), module.leaves(&it.ty))).collect();
        Target { id, arguments, numbers: Numbers::of(module, id), known: Vec::new() }
    }

    fn call(&self, random: &mut Random, module: &Module, size: Size<'_>) -> Vec<u64> {
        let made = |(ty, _): &(Type, Vec<Type>)| arguments::words(random, module, ty, size);
        self.arguments.iter().flat_map(made).collect()
    }

    /// Changes some words of one argument of a call.
    fn change(&self, random: &mut Random, module: &Module, call: &mut [u64]) {
        if self.arguments.is_empty() {
            return;
        }
        let chosen = random.below(self.arguments.len());
        let before: usize = self.arguments[..chosen].iter().map(|it| it.1.len()).sum();
        let (ty, leaves) = &self.arguments[chosen];
        let value = &mut call[before..before + leaves.len()];
        let size = random.of(&[Size::Edges, Size::Tame, Size::Near(&self.numbers)]);
        arguments::change(random, module, ty, leaves, value, size);
    }
}

/// The search.
#[derive(Clone)]
pub struct Search<'m> {
    module: &'m Module,
    random: Random,
    /// The functions.
    pub targets: Vec<Target>,
}

impl<'m> Search<'m> {
    /// Begins a search.
    pub fn new(module: &'m Module) -> Search<'m> {
        Search { module, random: Random(0), targets: targets(module) }
    }

    /// Returns lives of all functions with edge values, small numbers and the constants of the code.
    pub fn first(&mut self) -> Vec<Life> {
        let Search { module, random, targets } = self;
        let mut lives = Vec::new();
        for (place, target) in targets.iter().enumerate() {
            let near = Size::Near(&target.numbers);
            for (size, count, length) in
                [(Size::Edges, CALLS, 1), (Size::Tame, 1, CALLS), (near, CALLS / LIFE, LIFE)]
            {
                for _ in 0..count {
                    let calls = (0..length).map(|_| target.call(random, module, size)).collect();
                    lives.push(Life { target: place, calls });
                }
            }
        }
        lives
    }

    /// Keeps a life that reached something.
    pub fn keep(&mut self, life: &Life) {
        let Some(target) = self.targets.get_mut(life.target) else { return };
        let calls = life.calls.iter().take(BEGINNING).cloned().collect();
        if target.known.len() == KEPT {
            target.known.remove(self.random.below(KEPT));
        }
        target.known.push(Life { target: life.target, calls });
    }

    /// Returns the places of the other functions that may change the component of this one.
    pub fn others(&self, place: usize) -> Vec<usize> {
        let of = |at: usize| &self.module.functions[self.targets[at].id.index()];
        let changes = |at: usize| of(at).parameters().iter().any(|it| it.mode == Mode::RefMut);
        let is_other =
            |at: &usize| *at != place && of(*at).owner == of(place).owner && changes(*at);
        match of(place).owner {
            Some(Owner::Struct(_)) => (0..self.targets.len()).filter(is_other).collect(),
            _ => Vec::new(),
        }
    }

    /// Returns the structs of the last call of a life.
    pub fn values(&self, life: &Life) -> Vec<Value> {
        let mut words = life.calls.last().map_or(&[][..], Vec::as_slice);
        let mut values = Vec::new();
        for (ty, leaves) in &self.targets[life.target].arguments {
            let Some((own, rest)) = words.split_at_checked(leaves.len()) else { break };
            if let Type::Struct(_) = ty {
                values.push((ty.clone(), Rc::from(own)));
            }
            words = rest;
        }
        values
    }

    /// Returns the changes of one word or of a struct to one of `values` that may make a call longer.
    ///
    /// Flags and variants choose a path, so their changes come first, behind those of structs, and the changes of numbers last.
    /// Each group is in random order.
    pub fn steps(&mut self, place: usize, numbers: Met, values: &[Value]) -> Vec<Step> {
        let (mut choices, mut others) = (Vec::new(), Vec::new());
        for (argument, (_, leaves)) in self.targets[place].arguments.iter().enumerate() {
            for (leaf, ty) in leaves.iter().enumerate() {
                let chooses = matches!(ty, Type::Enum(_) | Type::Scalar(Scalar::Bool));
                let steps = if chooses { &mut choices } else { &mut others };
                for word in arguments::slow(self.module, ty, numbers == Met::Any) {
                    let of = |all| Step { argument, leaf, words: Rc::from([word]), all };
                    steps.extend([of(false), of(true)]);
                }
            }
        }
        let mut structs = Vec::new();
        for (argument, (ty, _)) in self.targets[place].arguments.iter().enumerate() {
            for (ty, leaf) in parts(self.module, ty) {
                for (_, words) in values.iter().filter(|it| it.0 == ty) {
                    let of = |all| Step { argument, leaf, words: words.clone(), all };
                    structs.extend([of(false), of(true)]);
                }
            }
        }
        for steps in [&mut structs, &mut choices, &mut others] {
            for at in (1..steps.len()).rev() {
                steps.swap(at, self.random.below(at + 1));
            }
        }
        [structs, choices, others].concat()
    }

    /// Returns a life with these changes, each of the last call or of all.
    pub fn stepped(&self, life: &Life, steps: &[Step]) -> Life {
        let mut life = life.clone();
        let target = &self.targets[life.target];
        for step in steps {
            let before: usize = target.arguments[..step.argument].iter().map(|it| it.1.len()).sum();
            let (ty, leaves) = &target.arguments[step.argument];
            let first = if step.all { 0 } else { life.calls.len().saturating_sub(1) };
            for call in life.calls.iter_mut().skip(first) {
                let value = &mut call[before..before + leaves.len()];
                for (at, word) in step.words.iter().enumerate() {
                    arguments::set(self.module, ty, leaves, value, (step.leaf + at, *word));
                }
            }
        }
        life
    }

    /// Returns changed lives of one function.
    pub fn changed(&mut self, place: usize) -> Vec<Life> {
        let Search { module, random, targets } = self;
        let target = &targets[place];
        if target.arguments.is_empty() {
            return Vec::new();
        }
        let (mut lives, mut words) = (Vec::new(), 0);
        while lives.len() < BATCH && words < MOST {
            let calls = match target.known.len() {
                0 => vec![target.call(random, module, Size::Near(&target.numbers))],
                // Every other time one of the last.
                count => {
                    let from = if random.one_in(2) { count.saturating_sub(8) } else { 0 };
                    let one = &target.known[from + random.below(count - from)];
                    let other = &target.known[random.below(count)];
                    altered(random, module, target, one, other)
                }
            };
            words += calls.iter().map(Vec::len).sum::<usize>();
            lives.push(Life { target: place, calls });
        }
        lives
    }
}

/// Returns the structs that a type is or has, each with the place of its first word.
fn parts(module: &Module, ty: &Type) -> Vec<(Type, usize)> {
    let of = |ty: &Type, first: usize| {
        let inner = parts(module, ty).into_iter();
        inner.map(move |(ty, at)| (ty, first + at)).collect::<Vec<_>>()
    };
    match ty {
        Type::Struct(id) => {
            let (mut all, mut first) = (vec![(ty.clone(), 0)], 0);
            for field in &module.structs[id.index()].fields {
                all.extend(of(&field.ty, first));
                first += module.leaves(&field.ty).len();
            }
            all
        }
        Type::Array { element, len } => {
            let width = module.leaves(element).len();
            (0..*len as usize).flat_map(|at| of(element, at * width)).collect()
        }
        _ => Vec::new(),
    }
}

/// Returns the calls of a life with one to four changes.
fn altered(
    random: &mut Random,
    module: &Module,
    target: &Target,
    life: &Life,
    other: &Life,
) -> Vec<Vec<u64>> {
    let mut calls = life.calls.clone();
    for _ in 0..=random.below(4) {
        let at = random.below(calls.len().max(1));
        match random.below(8) {
            // Ends early, or goes on as another life does.
            0 => calls.truncate(at + 1),
            1 => {
                calls.truncate(at + 1);
                let from = random.below(other.calls.len().max(1));
                calls.extend(other.calls.iter().skip(from).cloned());
                calls.truncate(2 * BEGINNING);
            }
            // The last call again and again: time passes.
            2 => {
                let last = calls.last().cloned();
                let count = random.of(&[1, 4, 16, 64]);
                calls.extend(last.into_iter().flat_map(|it| std::iter::repeat_n(it, count)));
                calls.truncate(2 * BEGINNING);
            }
            3 => {
                calls.truncate(2 * BEGINNING - 1);
                calls.push(target.call(random, module, Size::Near(&target.numbers)));
            }
            // A change of the last call, of one call, or of a call and all after it.
            4 => {
                if let Some(call) = calls.last_mut() {
                    target.change(random, module, call);
                }
            }
            5 => {
                if let Some(call) = calls.get_mut(at) {
                    target.change(random, module, call);
                }
            }
            _ => {
                let seed = random.bits();
                for call in calls.iter_mut().skip(at) {
                    target.change(&mut Random(seed), module, call);
                }
            }
        }
    }
    calls
}

#[cfg(test)]
mod tests {
    use super::*;

    fn module() -> Module {
        let text = include_str!("../../../codegen/backend/tests/c/height.ir");
        bessemer_ir::text::parse(text).expect("it is a module")
    }

    #[test]
    fn a_call_has_the_words_of_its_arguments_and_a_seed_gives_the_same_lives() {
        let module = module();
        let lives = || {
            let mut search = Search::new(&module);
            let first = search.first();
            first.iter().for_each(|life| search.keep(life));
            let changed: Vec<Life> =
                (0..search.targets.len()).flat_map(|place| search.changed(place)).collect();
            for life in first.iter().chain(&changed) {
                let arguments = search.targets[life.target].arguments.iter();
                let words: usize = arguments.map(|(_, leaves)| leaves.len()).sum();
                assert!(life.calls.iter().all(|call| call.len() == words));
                assert!(life.calls.len() <= 2 * BEGINNING);
            }
            (first, changed)
        };
        let (first, changed) = lives();
        assert!(!first.is_empty() && changed.iter().any(|life| !first.contains(life)));
        assert_eq!((first, changed), lives());
    }

    /// A component is no argument of its entry points and of its other public methods.
    ///
    /// As an argument, its words would be read as those of the next one.
    #[test]
    fn a_component_is_no_argument_of_its_methods() {
        let mut module = module();
        for function in module.functions.iter_mut().filter(|it| it.role == Role::Private) {
            function.role = Role::Public;
        }
        // `height_settled` is no entry point.
        for (name, arguments) in [("step", 5), ("settled", 1)] {
            let all = targets(&module);
            let is_it = |it: &&Target| module.functions[it.id.index()].name == name;
            let target = all.iter().find(is_it).expect("it is there");
            assert_eq!(target.arguments.len(), arguments, "{name}");
        }
    }

    #[test]
    fn the_lives_that_are_kept_are_bounded() {
        let module = module();
        let mut search = Search::new(&module);
        let life = Life { target: 0, calls: vec![search.first()[0].calls[0].clone(); 1000] };
        for _ in 0..2 * KEPT {
            search.keep(&life);
        }
        let known = &search.targets[0].known;
        assert!(known.len() == KEPT && known.iter().all(|life| life.calls.len() == BEGINNING));
    }
}
