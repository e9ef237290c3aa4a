//! Longest path through blocks with bounded loops.
//!
//! Rule: a strongly connected set of blocks is a loop, entered at its first block in the text that is reached from
//! outside. Without the edges to that block it has inner loops, which are taken first. With at most `n` passes the path
//! goes around `n` times and then out; `n - 1` times if each edge back is taken by a block that can also leave, and the
//! entry cannot leave or is the whole loop: the test is then behind the pass.
//!
//! A loop whose number of passes follows the counter of a loop around it has another number in each pass of that one, since
//! the counter never has a value twice. So `n` passes of the outer loop cost the sum of their longest paths, the inner loop
//! having its `n` largest numbers of passes one after the other.

use std::cell::{Cell, RefCell};

use super::passes::{Line, Times};

/// Most passes of a loop that are computed one by one.
const ONE_BY_ONE: u64 = 64;

/// Returns the cost of the longest path from block 0 to a block that may `leave` the function.
///
/// # Errors
/// The reason why a loop has no bound.
pub fn longest(
    next: &[Vec<usize>],
    leave: &[bool],
    costs: &[u64],
    bound: &dyn Fn(&[usize]) -> Result<Times, String>,
) -> Result<u64, String> {
    let graph = Graph { next, costs, bound, seen: RefCell::default() };
    let all: Vec<usize> = (0..next.len()).collect();
    let ends = graph.from(&all, 0, &[], None)?;
    let left = ends.into_iter().zip(leave).filter(|(_, leave)| **leave);
    Ok(left.filter_map(|(end, _)| end).max().unwrap_or_default())
}

struct Graph<'g> {
    next: &'g [Vec<usize>],
    costs: &'g [u64],
    bound: &'g dyn Fn(&[usize]) -> Result<Times, String>,
    /// Lines of the loops so far.
    seen: RefCell<Vec<Line>>,
}

/// A pass of a loop around some blocks.
struct Around<'g> {
    /// The line of the loop, among others of its function. No other one of them is around a loop within.
    places: &'g [Line],
    /// Number of the pass, in the order of falling cost.
    pass: usize,
    /// Set if a loop within follows its counter.
    followed: &'g Cell<bool>,
    outer: Option<&'g Around<'g>>,
}

impl Around<'_> {
    /// Returns the passes of a loop within.
    fn passes(this: Option<&Around<'_>>, times: &Times) -> u64 {
        let Some((place, passes)) = &times.following else { return times.most };
        let mut around = this;
        while let Some(it) = around {
            if it.places.contains(place) {
                it.followed.set(true);
                return passes.get(it.pass).map_or(times.most, |it| times.most.min(*it));
            }
            around = it.outer;
        }
        times.most
    }
}

/// Cost of the longest path to the end of each block; none if the block is not reached.
type Ends = Vec<Option<u64>>;

impl Graph<'_> {
    /// Returns the longest paths within some blocks, without the edges to the `cut` ones.
    fn from(
        &self,
        blocks: &[usize],
        entry: usize,
        cut: &[usize],
        outer: Option<&Around<'_>>,
    ) -> Result<Ends, String> {
        let mut inside = vec![false; self.next.len()];
        blocks.iter().for_each(|it| inside[*it] = true);
        let follow = |block: usize| {
            self.next[block].iter().copied().filter(|it| inside[*it] && !cut.contains(it))
        };
        let mut begins: Ends = vec![None; self.next.len()];
        let mut ends = begins.clone();
        begins[entry] = Some(0);
        for part in self.parts(blocks, &follow) {
            let loops = part.len() > 1 || follow(part[0]).any(|it| it == part[0]);
            if loops {
                let Some(first) = part.iter().copied().filter(|it| begins[*it].is_some()).min()
                else {
                    continue;
                };
                let start = part.iter().filter_map(|it| begins[*it]).max().unwrap_or_default();
                let around: Vec<usize> = cut.iter().copied().chain([first]).collect();
                let bound = (self.bound)(&part)?;
                let followed = Cell::new(false);
                let nth = |pass: usize| {
                    let places = &bound.places;
                    let around_it = Around { places, pass, followed: &followed, outer };
                    self.from(&part, first, &around, Some(&around_it))
                };
                // The longest pass, which is also the last one on the way out.
                let seen = self.seen.borrow().len();
                let inner = nth(0)?;
                let merged = bound
                    .within
                    .iter()
                    .filter(|(line, _)| !self.seen.borrow()[seen..].contains(line));
                let merged = merged.fold(1_u64, |product, (_, most)| product.saturating_mul(*most));
                self.seen.borrow_mut().extend(bound.places.iter().cloned());
                let back = |it: &&usize| self.next[**it].contains(&first);
                let pass = |inner: &Ends| {
                    let all = part.iter().filter(back).filter_map(|it| inner[*it]);
                    all.max().unwrap_or_default()
                };
                let leaves = |it: usize| self.next[it].iter().any(|to| !part.contains(to));
                let behind = part.iter().filter(back).all(|it| leaves(*it));
                let behind = behind && (part.len() == 1 || !leaves(first));
                let times = Around::passes(outer, &bound).saturating_sub(u64::from(behind));
                let mut passes = pass(&inner).saturating_mul(times);
                if followed.get() && times <= ONE_BY_ONE {
                    passes = 0;
                    for number in 0..times as usize {
                        passes = passes.saturating_add(pass(&nth(number)?));
                    }
                }
                // Two loops may have one first block, to which both go back.
                if merged > 1 && part.iter().filter(back).count() > 1 {
                    let all = Around::passes(outer, &bound).saturating_mul(merged + 1);
                    passes = passes.max(pass(&inner).saturating_mul(all));
                }
                let all = start.saturating_add(passes);
                for block in &part {
                    ends[*block] = inner[*block].map(|it| it.saturating_add(all));
                }
            } else if let Some(begin) = begins[part[0]] {
                ends[part[0]] = Some(begin.saturating_add(self.costs[part[0]]));
            }
            for block in &part {
                let Some(end) = ends[*block] else { continue };
                for to in follow(*block).filter(|to| !part.contains(to)) {
                    begins[to] = begins[to].max(Some(end));
                }
            }
        }
        Ok(ends)
    }

    /// Returns the strongly connected parts, each before those that follow it: Kosaraju's two searches.
    fn parts<I: Iterator<Item = usize>>(
        &self,
        blocks: &[usize],
        follow: &dyn Fn(usize) -> I,
    ) -> Vec<Vec<usize>> {
        let count = self.next.len();
        let mut order = Vec::new();
        let mut seen = vec![false; count];
        for root in blocks {
            let mut open = vec![(*root, false)];
            while let Some((block, done)) = open.pop() {
                if done {
                    order.push(block);
                } else if !std::mem::replace(&mut seen[block], true) {
                    open.push((block, true));
                    open.extend(follow(block).filter(|it| !seen[*it]).map(|it| (it, false)));
                }
            }
        }
        let mut before: Vec<Vec<usize>> = vec![Vec::new(); count];
        for block in blocks {
            follow(*block).for_each(|to| before[to].push(*block));
        }
        let mut parts = Vec::new();
        let mut taken = vec![false; count];
        for root in order.into_iter().rev() {
            let (mut part, mut open) = (Vec::new(), vec![root]);
            while let Some(block) = open.pop() {
                if !std::mem::replace(&mut taken[block], true) {
                    part.push(block);
                    open.extend(&before[block]);
                }
            }
            if !part.is_empty() {
                parts.push(part);
            }
        }
        parts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn leave(next: &[Vec<usize>]) -> Vec<bool> {
        next.iter().map(Vec::is_empty).collect()
    }

    fn of(next: &[&[usize]], costs: &[u64], passes: u64) -> u64 {
        let next: Vec<Vec<usize>> = next.iter().map(|it| it.to_vec()).collect();
        longest(&next, &leave(&next), costs, &|_| Ok(Times::from(passes))).expect("bounded")
    }

    #[test]
    fn the_longer_side_counts() {
        assert_eq!(of(&[&[1, 2], &[3], &[3], &[]], &[1, 10, 5, 2], 0), 13);
    }

    #[test]
    fn a_test_before_the_pass_runs_once_more() {
        // 0 → 1 (test) → 2 (body) → 1; 1 → 3.
        assert_eq!(of(&[&[1], &[2, 3], &[1], &[]], &[1, 2, 10, 5], 4), 1 + 4 * 12 + 2 + 5);
    }

    #[test]
    fn a_test_behind_the_pass_runs_as_often_as_the_pass() {
        assert_eq!(of(&[&[1], &[1, 2], &[]], &[1, 10, 5], 4), 1 + 40 + 5);
        // The loop has two blocks: 1 (body) → 2 (test) → 1 or 3.
        assert_eq!(of(&[&[1], &[2], &[1, 3], &[]], &[1, 10, 2, 5], 4), 1 + 48 + 5);
    }

    #[test]
    fn inner_loops_count_in_each_pass() {
        // 1 → 2 (inner, itself) → 3 → 1 or 4.
        assert_eq!(of(&[&[1], &[2], &[2, 3], &[1, 4], &[]], &[0, 1, 10, 1, 0], 3), 3 * 32);
    }

    /// 1 (test) → 2 (inner, itself) → 3 → 1; 1 → 4. The inner loop has four passes, then three, two and one.
    #[test]
    fn a_loop_that_follows_a_counter_has_the_passes_of_each_value() {
        let next: Vec<Vec<usize>> = vec![vec![1], vec![2, 4], vec![2, 3], vec![1], vec![]];
        let outer = ("a.c".to_owned(), 3);
        let following = Some((outer.clone(), vec![4, 3, 2, 1]));
        let bound = |blocks: &[usize]| {
            Ok(match blocks {
                [2] => Times { most: 4, following: following.clone(), ..Times::default() },
                _ => Times { places: vec![outer.clone()], most: 4, ..Times::default() },
            })
        };
        let cost = longest(&next, &leave(&next), &[0, 1, 10, 1, 0], &bound).expect("bounded");
        assert_eq!(cost, 4 * 2 + (4 + 3 + 2 + 1) * 10 + 1);
    }

    /// 1 → 2 → 1 is a loop of four passes within 1 → 3 → 1 of three, and both go back to 1.
    #[test]
    fn loops_with_one_first_block_have_the_passes_of_both() {
        let next: Vec<Vec<usize>> = vec![vec![1], vec![2, 3], vec![1], vec![1, 4], vec![]];
        let within = vec![(("a.c".to_owned(), 5), 4)];
        let bound = |_: &[usize]| Ok(Times { most: 3, within: within.clone(), ..Times::default() });
        let cost = longest(&next, &leave(&next), &[0, 1, 10, 1, 0], &bound).expect("bounded");
        assert!(cost >= 3 * (4 * 11 + 2), "{cost}");
    }

    /// All graphs of four blocks without a way back, against all paths.
    #[test]
    fn without_loops_it_is_the_longest_of_all_paths() {
        fn walked(next: &[Vec<usize>], costs: &[u64], at: usize) -> u64 {
            costs[at] + next[at].iter().map(|to| walked(next, costs, *to)).max().unwrap_or(0)
        }
        for edges in 0..64_u32 {
            let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
            let mut next = vec![Vec::new(); 4];
            for (bit, (from, to)) in pairs.iter().enumerate() {
                if edges >> bit & 1 == 1 {
                    next[*from].push(*to);
                }
            }
            let costs = [3, 1, 4, 2];
            let found = longest(&next, &leave(&next), &costs, &|_| Err("no loop".to_owned()));
            assert_eq!(found, Ok(walked(&next, &costs, 0)));
        }
    }
}
