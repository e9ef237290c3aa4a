//! A persistent map: a copy costs a pointer, and two copies are compared in the time that their differences take.
//!
//! An analysis copies the facts at each branch, changes a few of them on each path, and joins the paths. With ordinary maps
//! the cost of a branch would be the number of facts, and that of a long function the square of its length.
//!
//! Invariant: the path to a key consists of its octal digits, the lowest first, without zeros at its end. So each node is
//! one key, and equal keys have equal paths. Nodes that two maps share are equal.
//!
//! Must not know: the meaning of keys and values.

use std::rc::Rc;

/// The number of children of a node.
const WIDTH: usize = 8;

type Link<T> = Option<Rc<Node<T>>>;

struct Node<T> {
    value: Option<Rc<T>>,
    below: [Link<T>; WIDTH],
}

impl<T> Clone for Node<T> {
    fn clone(&self) -> Node<T> {
        Node { value: self.value.clone(), below: self.below.clone() }
    }
}

impl<T> Default for Node<T> {
    fn default() -> Node<T> {
        Node { value: None, below: Default::default() }
    }
}

/// A map from numbers, small ones preferred, to values.
pub(super) struct Map<T>(Link<T>);

impl<T> Clone for Map<T> {
    fn clone(&self) -> Map<T> {
        Map(self.0.clone())
    }
}

impl<T> Default for Map<T> {
    fn default() -> Map<T> {
        Map(None)
    }
}

/// A key whose values in two maps differ, and both values.
pub(super) type Difference<T> = (u32, Option<Rc<T>>, Option<Rc<T>>);

impl<T> Map<T> {
    /// The value of a key.
    pub(super) fn get(&self, mut key: u32) -> Option<&T> {
        let mut node = self.0.as_ref()?;
        while key > 0 {
            node = node.below[key as usize % WIDTH].as_ref()?;
            key /= WIDTH as u32;
        }
        node.value.as_deref()
    }

    /// Sets or removes the value of a key.
    pub(super) fn set(&mut self, key: u32, value: Option<Rc<T>>) {
        *self.slot(key) = value;
    }

    /// Sets the value of a key.
    pub(super) fn insert(&mut self, key: u32, value: T) {
        self.set(key, Some(Rc::new(value)));
    }

    /// The value of a key, to be changed; the default value is inserted if there is none.
    pub(super) fn change(&mut self, key: u32) -> &mut T
    where
        T: Clone + Default,
    {
        Rc::make_mut(self.slot(key).get_or_insert_default())
    }

    fn slot(&mut self, mut key: u32) -> &mut Option<Rc<T>> {
        let mut node = Rc::make_mut(self.0.get_or_insert_default());
        while key > 0 {
            node = Rc::make_mut(node.below[key as usize % WIDTH].get_or_insert_default());
            key /= WIDTH as u32;
        }
        &mut node.value
    }

    /// The keys whose values differ, in ascending order.
    pub(super) fn differences(&self, other: &Map<T>) -> Vec<Difference<T>>
    where
        T: PartialEq,
    {
        let mut found = Vec::new();
        compare(&self.0, &other.0, 0, 1, &mut found);
        found.sort_unstable_by_key(|it| it.0);
        found
    }
}

/// Compares the subtrees of a `key`; `digit` is the weight of its next digit.
fn compare<T: PartialEq>(
    a: &Link<T>,
    b: &Link<T>,
    key: u32,
    digit: u32,
    found: &mut Vec<Difference<T>>,
) {
    let shared = match (a, b) {
        (Some(a), Some(b)) => Rc::ptr_eq(a, b),
        _ => a.is_none() && b.is_none(),
    };
    if shared {
        return;
    }
    let (a, b) = (a.as_ref(), b.as_ref());
    let value = |node: Option<&Rc<Node<T>>>| node.and_then(|it| it.value.clone());
    let (one, other) = (value(a), value(b));
    if one != other {
        found.push((key, one, other));
    }
    for at in 0..WIDTH {
        let below = |node: Option<&Rc<Node<T>>>| node.and_then(|it| it.below[at].clone());
        let key = key.wrapping_add(digit.wrapping_mul(at as u32));
        compare(&below(a), &below(b), key, digit.wrapping_mul(WIDTH as u32), found);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::{Map, Node, Rc};
    use proptest::prelude::*;

    /// Some writes: a key with its value, or none.
    fn writes() -> impl Strategy<Value = Vec<(u32, Option<u8>)>> {
        let key = prop_oneof![0..70_u32, any::<u32>(), Just(u32::MAX), Just(8), Just(64)];
        prop::collection::vec((key, any::<Option<u8>>()), 0..40)
    }

    fn write(map: &mut Map<u8>, model: &mut BTreeMap<u32, u8>, writes: &[(u32, Option<u8>)]) {
        for (key, value) in writes {
            map.set(*key, value.map(Rc::new));
            match value {
                Some(value) => drop(model.insert(*key, *value)),
                None => drop(model.remove(key)),
            }
        }
    }

    proptest! {
        /// A map holds the last values, whatever its copies do, and two copies differ where ordinary maps do.
        #[test]
        fn copies_are_independent_and_differ_where_they_do(
            before in writes(), one in writes(), other in writes(),
        ) {
            let (mut a, mut model_a) = (Map::default(), BTreeMap::new());
            write(&mut a, &mut model_a, &before);
            let (mut b, mut model_b) = (a.clone(), model_a.clone());
            write(&mut a, &mut model_a, &one);
            write(&mut b, &mut model_b, &other);

            let keys: Vec<u32> =
                [&before, &one, &other].into_iter().flatten().map(|it| it.0).collect();
            for key in &keys {
                prop_assert_eq!(a.get(*key), model_a.get(key));
                prop_assert_eq!(b.get(*key), model_b.get(key));
            }
            let mut wanted: Vec<(u32, Option<u8>, Option<u8>)> = keys
                .iter()
                .map(|key| (*key, model_a.get(key).copied(), model_b.get(key).copied()))
                .filter(|(_, a, b)| a != b)
                .collect();
            wanted.sort_unstable();
            wanted.dedup();
            let found: Vec<_> = a.differences(&b)
                .into_iter()
                .map(|(key, a, b)| (key, a.as_deref().copied(), b.as_deref().copied()))
                .collect();
            prop_assert_eq!(found, wanted);
        }
    }

    /// Counts the nodes that each of two maps has for itself.
    fn own(a: &Option<Rc<Node<u8>>>, b: &Option<Rc<Node<u8>>>) -> usize {
        match (a, b) {
            (Some(a), Some(b)) if Rc::ptr_eq(a, b) => 0,
            (Some(a), Some(b)) => {
                1 + a.below.iter().zip(&b.below).map(|(a, b)| own(a, b)).sum::<usize>()
            }
            _ => 0,
        }
    }

    #[test]
    fn a_change_of_a_copy_copies_one_path() {
        let mut all = Map::default();
        (0..10_000).for_each(|key| all.insert(key, 0));
        let mut copy = all.clone();
        copy.insert(4_321, 1);
        assert_eq!(own(&all.0, &copy.0), 6);
        assert_eq!(copy.differences(&all).len(), 1);
    }
}
