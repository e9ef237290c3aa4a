//! Shortest paths in a constant graph (Dijkstra's algorithm).
use bessemer::prelude::*;

pub const NODES: usize = 6;

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
struct Edge {
    to: u8,
    cost: u16,
}

const fn edge(to: u8, cost: u16) -> Edge {
    Edge { to, cost }
}

static GRAPH: [[Option<Edge>; 3]; NODES] = [
    [Some(edge(1, 7)), Some(edge(2, 9)), Some(edge(5, 14))],
    [Some(edge(0, 7)), Some(edge(2, 10)), Some(edge(3, 15))],
    [Some(edge(0, 9)), Some(edge(3, 11)), Some(edge(5, 2))],
    [Some(edge(1, 15)), Some(edge(4, 6)), None],
    [Some(edge(3, 6)), Some(edge(5, 9)), None],
    [Some(edge(0, 14)), Some(edge(2, 2)), Some(edge(4, 9))],
];

#[function]
pub fn distances(from: u8) -> [Option<u16>; NODES] {
    let mut best: [Option<u16>; NODES] = [None; NODES];
    let mut open: List<(u16, u8), 18> = List::new();
    if usize::from(from) >= NODES {
        return best;
    }
    open.push((0, from));
    #[bound(40)]
    while let Some((i, &(cost, node))) = open.iter().enumerate().min_by_key(|(_, entry)| entry.0) {
        open.swap_remove(i);
        let node = node as usize;
        if best[node].is_some_and(|known| known <= cost) {
            continue;
        }
        best[node] = Some(cost);
        for edge in GRAPH[node].iter().flatten() {
            let next = cost + edge.cost;
            match best[edge.to as usize] {
                Some(known) if known <= next => {}
                _ => open.push((next, edge.to)),
            }
        }
    }
    best
}

#[function]
pub fn route(from: u8, to: u8) -> List<u8, 6> {
    let costs = distances(to);
    let mut way = List::new();
    let mut at = from;
    way.push(at);
    #[bound(6)]
    while at != to {
        let Some(here) = costs.get(at as usize).copied().flatten() else { break };
        let next = GRAPH[at as usize]
            .iter()
            .flatten()
            .find(|edge| costs[edge.to as usize].map_or(false, |there| there + edge.cost == here));
        match next {
            Some(edge) => at = edge.to,
            None => break,
        }
        way.push(at);
    }
    way
}
