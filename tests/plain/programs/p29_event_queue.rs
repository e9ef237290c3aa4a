//! Event queue: one ring buffer per priority, oldest event of the highest
//! priority first, with an overflow policy per queue.

/// Ring buffer of `N` elements, filled and emptied at opposite ends.
#[derive(Clone, Debug)]
pub struct Ring<T, const N: usize> {
    slots: [Option<T>; N],
    head: usize,
    len: usize,
}

impl<T, const N: usize> Ring<T, N> {
    pub const fn new() -> Self {
        const { assert!(N > 0) };
        Self { slots: [const { None }; N], head: 0, len: 0 }
    }

    pub fn push(&mut self, item: T) -> Result<(), T> {
        if self.len == N {
            return Err(item);
        }
        self.slots[(self.head + self.len) % N] = Some(item);
        self.len += 1;
        Ok(())
    }

    pub fn pop(&mut self) -> Option<T> {
        let item = self.slots[self.head].take()?;
        self.head = (self.head + 1) % N;
        self.len -= 1;
        Some(item)
    }

    pub fn iter(&self) -> impl Iterator<Item = &T> {
        let (wrapped, first) = self.slots.split_at(self.head);
        first.iter().chain(wrapped).flatten()
    }

    pub const fn len(&self) -> usize {
        self.len
    }

    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }
}

impl<T, const N: usize> Default for Ring<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// Importance of an event; the discriminant is the index of its ring.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Priority {
    High,
    Normal,
    Low,
}

impl Priority {
    pub const ALL: [Self; 3] = [Self::High, Self::Normal, Self::Low];
}

/// What to do with a new event when its ring is full.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Overflow {
    #[default]
    RejectNewest,
    DropOldest,
}

/// Anything that can be queued.
pub trait Event {
    fn priority(&self) -> Priority;

    /// An event that makes `earlier` superfluous replaces it in place.
    fn supersedes(&self, _earlier: &Self) -> bool {
        false
    }
}

#[derive(Clone, Debug, Default)]
pub struct EventQueue<E, const N: usize> {
    rings: [Ring<E, N>; 3],
    overflow: Overflow,
    lost: u32,
}

impl<E: Event, const N: usize> EventQueue<E, N> {
    pub fn new(overflow: Overflow) -> Self {
        Self { rings: core::array::from_fn(|_| Ring::new()), overflow, lost: 0 }
    }

    /// Queues an event; gives back the one that had to go, if any.
    pub fn push(&mut self, event: E) -> Option<E> {
        let ring = &mut self.rings[event.priority() as usize];
        if let Some(earlier) = ring.slots.iter_mut().flatten().find(|e| event.supersedes(e)) {
            *earlier = event;
            return None;
        }
        let casualty = match (ring.push(event), self.overflow) {
            (Ok(()), _) => return None,
            (Err(newest), Overflow::RejectNewest) => Some(newest),
            (Err(newest), Overflow::DropOldest) => {
                let oldest = ring.pop();
                // There is room now.
                ring.push(newest).err().or(oldest)
            }
        };
        self.lost = self.lost.saturating_add(1);
        casualty
    }

    pub fn pop(&mut self) -> Option<E> {
        self.rings.iter_mut().find_map(Ring::pop)
    }

    /// Takes out everything at or above `least`, in order.
    pub fn drain(&mut self, least: Priority) -> Drain<'_, E, N> {
        Drain { rings: &mut self.rings[..=least as usize] }
    }

    pub fn len(&self) -> usize {
        self.rings.iter().map(Ring::len).sum()
    }

    pub fn is_empty(&self) -> bool {
        self.rings.iter().all(Ring::is_empty)
    }

    pub fn lost(&self) -> u32 {
        self.lost
    }

    pub fn waiting(&self) -> impl Iterator<Item = &E> {
        Priority::ALL.iter().flat_map(|&p| self.rings[p as usize].iter())
    }
}

/// Iterator made by [`EventQueue::drain`].
#[derive(Debug)]
pub struct Drain<'a, E, const N: usize> {
    rings: &'a mut [Ring<E, N>],
}

impl<E, const N: usize> Iterator for Drain<'_, E, N> {
    type Item = E;

    fn next(&mut self) -> Option<E> {
        self.rings.iter_mut().find_map(|ring| ring.pop())
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let n = self.rings.iter().map(Ring::len).sum();
        (n, Some(n))
    }
}

impl<E, const N: usize> ExactSizeIterator for Drain<'_, E, N> {}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy, Debug, PartialEq)]
    enum Ev {
        Fault(u8),
        Key(char),
        Level(f32),
    }

    impl Event for Ev {
        fn priority(&self) -> Priority {
            match self {
                Self::Fault(_) => Priority::High,
                Self::Key(_) => Priority::Normal,
                Self::Level(_) => Priority::Low,
            }
        }

        fn supersedes(&self, earlier: &Self) -> bool {
            matches!((self, earlier), (Self::Level(_), Self::Level(_)))
        }
    }

    #[test]
    fn order_and_replacement() {
        let mut q = EventQueue::<Ev, 4>::new(Overflow::default());
        for e in [Ev::Level(1.0), Ev::Key('a'), Ev::Level(2.0), Ev::Fault(7), Ev::Key('b')] {
            assert_eq!(q.push(e), None);
        }
        assert_eq!(q.len(), 4);
        assert!(q.waiting().eq(&[Ev::Fault(7), Ev::Key('a'), Ev::Key('b'), Ev::Level(2.0)]));
        assert_eq!(q.drain(Priority::Normal).len(), 3);
        assert_eq!(q.drain(Priority::Normal).last(), Some(Ev::Key('b')));
        assert_eq!((q.pop(), q.pop()), (Some(Ev::Level(2.0)), None));
    }

    #[test]
    fn overflow_policies() {
        let keys = ['a', 'b', 'c'].map(Ev::Key);
        let mut reject = EventQueue::<Ev, 2>::new(Overflow::RejectNewest);
        assert_eq!(keys.into_iter().filter_map(|k| reject.push(k)).last(), Some(Ev::Key('c')));
        let mut drop = EventQueue::<Ev, 2>::new(Overflow::DropOldest);
        assert_eq!(keys.into_iter().filter_map(|k| drop.push(k)).last(), Some(Ev::Key('a')));
        assert_eq!((drop.lost(), drop.pop()), (1, Some(Ev::Key('b'))));
    }
}
