//! Strongly connected components of a directed graph.

/// The components, each after those it can reach. The nodes of a component are in ascending order.
pub fn components(edges: &[Vec<usize>]) -> Vec<Vec<usize>> {
    const UNSEEN: usize = usize::MAX;
    let mut order = vec![UNSEEN; edges.len()];
    let mut low = vec![0; edges.len()];
    let mut on_stack = vec![false; edges.len()];
    let (mut count, mut stack, mut found) = (0, Vec::new(), Vec::new());
    // Tarjan's algorithm with an explicit stack: nodes, and the number of their finished edges.
    let mut work: Vec<(usize, usize)> = Vec::new();
    for root in 0..edges.len() {
        if order[root] != UNSEEN {
            continue;
        }
        work.push((root, 0));
        while let Some(&mut (node, ref mut done)) = work.last_mut() {
            if *done == 0 && order[node] == UNSEEN {
                order[node] = count;
                low[node] = count;
                count += 1;
                stack.push(node);
                on_stack[node] = true;
            }
            if let Some(&next) = edges[node].get(*done) {
                *done += 1;
                if order[next] == UNSEEN {
                    work.push((next, 0));
                } else if on_stack[next] {
                    low[node] = low[node].min(order[next]);
                }
                continue;
            }
            work.pop();
            if let Some(&(parent, _)) = work.last() {
                low[parent] = low[parent].min(low[node]);
            }
            if low[node] == order[node] {
                let start = stack.iter().rposition(|&other| other == node).unwrap_or(0);
                let mut component = stack.split_off(start);
                for &member in &component {
                    on_stack[member] = false;
                }
                component.sort_unstable();
                found.push(component);
            }
        }
    }
    found
}

/// Returns true if a component is a cycle: several nodes, or one node with an edge to itself.
pub(crate) fn is_cycle(component: &[usize], edges: &[Vec<usize>]) -> bool {
    match component {
        [one] => edges[*one].contains(one),
        several => !several.is_empty(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_come_after_what_they_reach() {
        let edges = vec![vec![1], vec![2, 3], vec![1], vec![], vec![4]];
        let found = components(&edges);
        assert_eq!(found, [vec![3], vec![1, 2], vec![0], vec![4]]);
        let cycles: Vec<bool> = found.iter().map(|one| is_cycle(one, &edges)).collect();
        assert_eq!(cycles, [false, true, false, true]);
    }
}
