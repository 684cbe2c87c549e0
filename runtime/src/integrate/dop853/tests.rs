//! The order conditions of all rooted trees: every digit of every coefficient takes part in one of them.

use super::*;

/// A rooted tree: its number of nodes, its density γ, and its subtrees by number.
struct Tree {
    order: usize,
    density: f64,
    children: Vec<usize>,
}

/// All rooted trees with at most `order` nodes, each once.
fn trees(order: usize) -> Vec<Tree> {
    let mut all = vec![Tree {
        order: 1,
        density: 1.0,
        children: vec![],
    }];
    for nodes in 2..=order {
        let mut forests = Vec::new();
        grow(&all, nodes - 1, all.len(), &mut vec![], &mut forests);
        for children in forests {
            let below: f64 = children.iter().map(|&c| all[c].density).product();
            all.push(Tree {
                order: nodes,
                density: nodes as f64 * below,
                children,
            });
        }
    }
    all
}

/// Multisets of trees with `nodes` nodes together, in falling order of their numbers below `bound`.
fn grow(
    all: &[Tree],
    nodes: usize,
    bound: usize,
    chosen: &mut Vec<usize>,
    out: &mut Vec<Vec<usize>>,
) {
    if nodes == 0 {
        out.push(chosen.clone());
    }
    for next in (0..bound).filter(|&t| all[t].order <= nodes) {
        chosen.push(next);
        grow(all, nodes - all[next].order, next + 1, chosen, out);
        chosen.pop();
    }
}

/// The tables unpacked, so that one entry can be spoilt.
#[derive(Clone)]
struct Tables {
    stages: Vec<Vec<f64>>,
    end: Vec<f64>,
    fifth: Vec<f64>,
    third: Vec<f64>,
    dense: Vec<Vec<f64>>,
}

fn unpack(weights: Weights) -> Vec<f64> {
    let mut row = vec![0.0; 16];
    for &(j, weight) in weights {
        row[j] = weight;
    }
    row
}

impl Tables {
    fn printed() -> Self {
        let rows = [&[] as Weights].into_iter().chain(STAGES);
        let more = [END].into_iter().chain(MORE);
        Self {
            stages: rows.chain(more).map(unpack).collect(),
            end: unpack(END),
            fifth: unpack(ERROR_5),
            third: unpack(ERROR_3),
            dense: DENSE.into_iter().map(unpack).collect(),
        }
    }

    /// For each tree the product over its subtrees, one value for each stage.
    fn elementary(&self, trees: &[Tree]) -> Vec<Vec<f64>> {
        let mut all: Vec<Vec<f64>> = Vec::new();
        for tree in trees {
            let mut value = vec![1.0; 16];
            for &child in &tree.children {
                for (v, row) in value.iter_mut().zip(&self.stages) {
                    *v *= dot(row, &all[child]);
                }
            }
            all.push(value);
        }
        all
    }

    /// Weights of the dense output at θ.
    fn weights(&self, theta: f64) -> Vec<f64> {
        let unit = |k| (0..16).map(|i| f64::from(i == k)).collect::<Vec<_>>();
        let (first, last, end) = (unit(0), unit(12), &self.end);
        let terms: Vec<Vec<f64>> = [
            end.clone(),
            (0..16).map(|i| first[i] - end[i]).collect(),
            (0..16).map(|i| 2.0 * end[i] - first[i] - last[i]).collect(),
        ]
        .into_iter()
        .chain(self.dense.clone())
        .collect();
        let mut sum = vec![0.0; 16];
        for (k, term) in terms.iter().enumerate().rev() {
            let factor = if k % 2 == 0 { theta } else { 1.0 - theta };
            for i in 0..16 {
                sum[i] = (sum[i] + term[i]) * factor;
            }
        }
        sum
    }

    /// The largest violation of any order condition.
    fn violation(&self, trees: &[Tree]) -> f64 {
        let elementary = self.elementary(trees);
        let mut worst: f64 = 0.0;
        for (tree, value) in trees.iter().zip(&elementary) {
            let mut check = |weights: &[f64], theta: f64, order: usize, wanted: f64| {
                if tree.order <= order {
                    let exact = wanted * theta.powi(tree.order as i32) / tree.density;
                    worst = worst.max((dot(weights, value) - exact).abs());
                }
            };
            check(&self.end, 1.0, 8, 1.0);
            check(&self.fifth, 1.0, 5, 0.0);
            check(&self.third, 1.0, 2, 0.0);
            for theta in [0.13, 0.37, 0.5, 0.71, 0.93] {
                check(&self.weights(theta), theta, 7, 1.0);
            }
        }
        worst
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[test]
fn there_are_as_many_trees_as_known() {
    let mut counts = [0; 9];
    for tree in trees(8) {
        counts[tree.order] += 1;
    }
    assert_eq!(counts, [0, 1, 1, 2, 4, 9, 20, 48, 115]);
}

#[test]
fn all_order_conditions_hold() {
    let violation = Tables::printed().violation(&trees(8));
    assert!(violation < 3e-14, "{violation:e}");
}

#[test]
fn a_wrong_digit_breaks_an_order_condition() {
    let (trees, printed) = (trees(8), Tables::printed());
    let rows = printed.stages.len() + 3 + printed.dense.len();
    for row in 0..rows {
        for column in 0..16 {
            let mut spoilt = printed.clone();
            let entry = match row {
                0..16 => &mut spoilt.stages[row][column],
                16 => &mut spoilt.end[column],
                17 => &mut spoilt.fifth[column],
                18 => &mut spoilt.third[column],
                _ => &mut spoilt.dense[row - 19][column],
            };
            if *entry == 0.0 {
                continue;
            }
            *entry *= 1.0 + 1e-9;
            let violation = spoilt.violation(&trees);
            assert!(
                violation > 1e-13,
                "row {row}, column {column}: {violation:e}"
            );
        }
    }
}
