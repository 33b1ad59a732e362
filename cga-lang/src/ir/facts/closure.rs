//! Least fixpoints over a graph.

use crate::graph::components;
use std::ops::BitOr;

/// The union of each node's own value and the values of all nodes that it reaches.
pub(crate) fn closure<T: Copy + BitOr<Output = T>>(edges: &[Vec<usize>], own: &[T]) -> Vec<T> {
    let mut found = own.to_vec();
    // Each component comes after those that it reaches, and its nodes reach each other.
    for component in components(edges) {
        let reached = component.iter().flat_map(|node| edges[*node].iter().chain([node])).map(|&at| found[at]);
        if let Some(union) = reached.reduce(BitOr::bitor) {
            component.iter().for_each(|&node| found[node] = union);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_has_what_it_reaches() {
        let edges = vec![vec![1], vec![2, 3], vec![1], vec![], vec![4]];
        assert_eq!(closure(&edges, &[1, 2, 4, 8, 16]), [15, 14, 14, 8, 16]);
    }
}
