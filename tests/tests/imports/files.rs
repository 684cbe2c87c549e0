//! The files of a crate, and which of them need which.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::paths::{Named, named};

/// Which nodes of a graph need which.
pub(crate) type Graph = BTreeMap<String, BTreeSet<String>>;

/// A module by its path, for instance `["flow", "exact"]`.
type Module = Vec<String>;

/// Every module that is a file, and what it names.
pub(crate) struct Files(BTreeMap<Module, Vec<Named>>);

impl Files {
    /// All below a folder but `lib.rs`, examples and unit tests.
    pub(crate) fn below(root: &Path) -> Self {
        let mut files = BTreeMap::new();
        scan(root, &[], &mut files);
        Self(files)
    }

    /// Each file with those that define what it names; a folder's own file is told by the folder's name.
    ///
    /// What a file only lends to others is no need of its own: a table of names stands on nothing.
    pub(crate) fn needs(&self) -> Graph {
        let mut graph = Graph::new();
        for (module, names) in &self.0 {
            let needs = names.iter().filter(|named| !self.is_lent(module, named));
            let needs = needs.filter_map(|named| self.definer(module, &named.path, 0));
            let needs = needs.filter(|definer| definer != module);
            let needs = needs.map(|definer| definer.join("/")).collect();
            graph.insert(module.join("/"), needs);
        }
        graph
    }

    /// Whether a name is lent from below the module itself.
    fn is_lent(&self, module: &Module, named: &Named) -> bool {
        named.public
            && self
                .absolute(module, &named.path)
                .is_some_and(|path| path.starts_with(module))
    }

    /// The path from the root of the crate; `None` if it leads out of the crate.
    fn absolute(&self, module: &Module, path: &[String]) -> Option<Module> {
        let mut whole = match path[0].as_str() {
            "crate" => Vec::new(),
            "self" => module.clone(),
            "super" => module[..module.len() - 1].to_vec(),
            child => {
                let mut below = module.clone();
                below.push(child.to_owned());
                if !self.0.contains_key(&below) {
                    return None;
                }
                below
            }
        };
        for segment in &path[1..] {
            match segment.as_str() {
                "super" => drop(whole.pop()),
                _ => whole.push(segment.clone()),
            }
        }
        Some(whole)
    }

    /// The file that defines what a path names, whoever lends it on the way.
    fn definer(&self, module: &Module, path: &[String], depth: usize) -> Option<Module> {
        let whole = self.absolute(module, path)?;
        let length = (1..=whole.len()).rev();
        let file = length.map(|length| &whole[..length]);
        let file = file.into_iter().find(|file| self.0.contains_key(*file))?;
        let Some(item) = whole.get(file.len()).filter(|_| depth < 8) else {
            return Some(file.to_vec());
        };
        let lent = self.0[file]
            .iter()
            .find(|lent| lent.import && lent.name == *item);
        let lent = lent.and_then(|lent| self.definer(&file.to_vec(), &lent.path, depth + 1));
        Some(lent.unwrap_or_else(|| file.to_vec()))
    }
}

fn scan(folder: &Path, module: &[String], files: &mut BTreeMap<Module, Vec<Named>>) {
    for entry in std::fs::read_dir(folder).expect("a readable folder") {
        let path = entry.expect("a readable entry").path();
        let stem = path.file_stem().expect("a name").to_string_lossy();
        if ["tests", "lib", "examples"].contains(&&*stem) {
            continue;
        }
        let mut name = module.to_vec();
        if stem != "mod" {
            name.push(stem.into_owned());
        }
        if path.is_dir() {
            scan(&path, &name, files);
        } else {
            let text = std::fs::read_to_string(&path).expect("a readable file");
            files.insert(name, named(&text));
        }
    }
}

/// The same graph between the modules that stand beside each other in this folder, each with all below it.
pub(crate) fn beside(needs: &Graph, folder: &str) -> Graph {
    let child = |file: &str| {
        let below = match folder {
            "" => file,
            folder => file.strip_prefix(folder)?.strip_prefix('/')?,
        };
        below.split('/').next().map(str::to_owned)
    };
    let mut graph = Graph::new();
    for (from, all) in needs {
        if let Some(from) = child(from) {
            let others = all.iter().filter_map(|to| child(to));
            let others = others.filter(|to| *to != from);
            graph.entry(from.clone()).or_default().extend(others);
        }
    }
    graph
}

/// A way from a node back to itself, if there is one; the shortest.
pub(crate) fn circle(graph: &Graph) -> Option<Vec<String>> {
    let circles = graph.keys().filter_map(|start| way_back(graph, start));
    circles.min_by_key(Vec::len)
}

fn way_back(graph: &Graph, start: &str) -> Option<Vec<String>> {
    let mut seen = BTreeSet::new();
    let mut ways = vec![vec![start.to_owned()]];
    while !ways.is_empty() {
        let mut longer = Vec::new();
        for way in &ways {
            for next in graph.get(&way[way.len() - 1]).into_iter().flatten() {
                let mut way = way.clone();
                way.push(next.clone());
                if next == start {
                    return Some(way);
                }
                if seen.insert(next.clone()) {
                    longer.push(way);
                }
            }
        }
        ways = longer;
    }
    None
}

#[test]
fn a_circle_is_found() {
    let graph = |pairs: &[(&str, &str)]| {
        let mut graph = Graph::new();
        for (from, to) in pairs {
            graph
                .entry((*from).to_owned())
                .or_default()
                .insert((*to).to_owned());
        }
        graph
    };
    assert_eq!(circle(&graph(&[("a", "b"), ("b", "c"), ("a", "c")])), None);
    let found = circle(&graph(&[("a", "b"), ("b", "c"), ("c", "d"), ("d", "b")]));
    assert_eq!(found.unwrap(), ["b", "c", "d", "b"]);
}
