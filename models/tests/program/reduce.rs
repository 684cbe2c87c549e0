//! `reduce`: structures from matrices.

use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};

use stickslip::reduce::{Coefficients, Method, Pencil, Point, Source, reduce};

use crate::{stickslip, words};

/// The case made by CalculiX: its deck, its matrices and its own frequencies.
fn blade(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/program/blade");
    folder.join(name).display().to_string()
}

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("stickslip-{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn made(line: &str, out: &Path) -> String {
    let line = format!("{line} --out {}", out.display());
    let answer = stickslip(&words(&line));
    assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
    fs::read_to_string(out).unwrap()
}

fn frequencies(structure: &str) -> Vec<f64> {
    let modes = structure
        .lines()
        .filter_map(|line| line.strip_prefix("mode "));
    modes
        .map(|line| line.split(' ').next().unwrap().parse().unwrap())
        .collect()
}

/// The angular frequencies in CalculiX's `.dat`, which has seven digits.
fn by_calculix() -> Vec<f64> {
    let text = fs::read_to_string(blade("frequencies.dat")).unwrap();
    let rows = text.lines().map(|line| line.split_whitespace().collect());
    let rows = rows.filter(|row: &Vec<&str>| row.len() == 5 && row[0].parse::<u32>().is_ok());
    let mut all: Vec<f64> = rows.map(|row| row[2].parse().unwrap()).collect();
    all.truncate(10);
    all
}

#[test]
fn frequencies_of_a_finite_element_model_are_those_of_calculix() {
    let (stiffness, mass) = (blade("blade.sti"), blade("blade.mas"));
    let line = format!("reduce {stiffness} {mass} --at tip=28:y --units m-kg-s --modes 10");
    let out = folder("calculix").join("blade.structure");
    let found = frequencies(&made(&line, &out));
    let known = by_calculix();
    assert_eq!(known.len(), 10);
    for (mine, theirs) in found.iter().zip(&known) {
        assert!(
            (mine - theirs).abs() < 1e-6 * theirs,
            "{mine} is not {theirs}"
        );
    }
}

/// CalculiX prints seven digits of the displacements of three nodes; the sign of a mode is nobody's.
#[test]
fn shapes_of_a_finite_element_model_are_those_of_calculix() {
    let (stiffness, mass) = (blade("blade.sti"), blade("blade.mas"));
    let nodes = [14, 25, 28].map(|node| ["x", "y", "z"].map(|way| format!("{node}:{way}")));
    let places = nodes.as_flattened().iter().enumerate();
    let points = places.map(|(i, place)| format!("--at p{i}={place}"));
    let points = points.collect::<Vec<_>>().join(" ");
    let line = format!("reduce {stiffness} {mass} {points} --units m-kg-s --modes 10");
    let structure = made(&line, &folder("shapes").join("blade.structure"));
    let numbers = |line: &str, from: usize| -> Vec<f64> {
        let words = line.split(' ').skip(from);
        words.map(|word| word.parse().unwrap()).collect()
    };
    let modes = structure.lines().filter(|line| line.starts_with("mode "));
    let known = fs::read_to_string(blade("shapes.dat")).unwrap();
    let known: Vec<Vec<f64>> = known.lines().skip(1).map(|line| numbers(line, 2)).collect();
    assert_eq!(known.len(), 30);
    for (mine, theirs) in modes.map(|line| numbers(line, 3)).zip(known.chunks(3)) {
        let theirs = theirs.concat();
        let product: f64 = mine.iter().zip(&theirs).map(|(a, b)| a * b).sum();
        let largest = theirs.iter().fold(0.0_f64, |most, one| most.max(one.abs()));
        for (mine, theirs) in mine.iter().zip(&theirs) {
            let off = (mine * product.signum() - theirs).abs();
            assert!(off < 1e-6 * largest, "{mine} is not {theirs}");
        }
    }
}

/// The gallery's beam, which rubs: its matrices and what was made of them, to what rounding leaves.
#[test]
fn the_beam_of_the_gallery_is_what_its_matrices_give() {
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/gallery/structures");
    let file = |name: &str| gallery.join(name).display().to_string();
    let matrices = ["stiffness.mtx", "mass.mtx", "damping.mtx"].map(file);
    let line = format!(
        "reduce {} --at contact=5 --at tip=15 --modes 5 --units mm-t-s",
        matrices.join(" ")
    );
    let found = made(&line, &folder("beam").join("beam.structure"));
    let kept = fs::read_to_string(gallery.join("beam.structure")).unwrap();
    assert_eq!(found.lines().count(), kept.lines().count());
    let pairs = found.split_whitespace().zip(kept.split_whitespace());
    for (found, kept) in pairs {
        match (found.parse::<f64>(), kept.parse::<f64>()) {
            (Ok(found), Ok(kept)) => {
                let off = (found - kept).abs();
                assert!(off <= 1e-6 * kept.abs(), "{found} is not {kept}");
            }
            _ => assert_eq!(found, kept),
        }
    }
}

/// The matrix of a CalculiX file in the other formats: each number as CalculiX wrote it.
fn converted(file: &str, dofs: &str) -> (String, String) {
    let entries: Vec<[&str; 3]> = (file.lines())
        .map(|line| {
            let words: Vec<&str> = line.split_whitespace().collect();
            words.try_into().unwrap()
        })
        .collect();
    let count = dofs.lines().count();
    let mut market = format!(
        "%%MatrixMarket matrix coordinate real general\n{count} {count} {}\n",
        entries
            .iter()
            .map(|one| 1 + usize::from(one[0] != one[1]))
            .sum::<usize>()
    );
    let mut punch = "DMIG,KAAX,0,6,1\n".to_owned();
    let places: Vec<String> = dofs
        .lines()
        .map(|line| line.trim().replace('.', ","))
        .collect();
    for [row, column, value] in entries {
        market += &format!("{row} {column} {value}\n");
        if row != column {
            market += &format!("{column} {row} {value}\n");
        }
        let place = |word: &str| places[word.parse::<usize>().unwrap() - 1].clone();
        punch += &format!("DMIG,KAAX,{},,{},{value}\n", place(column), place(row));
    }
    (market, punch)
}

#[test]
fn three_formats_of_one_structure_give_the_same_file() {
    let folder = folder("formats");
    let dofs = fs::read_to_string(blade("blade.dof")).unwrap();
    for name in ["sti", "mas"] {
        let text = fs::read_to_string(blade(&format!("blade.{name}"))).unwrap();
        let (market, punch) = converted(&text, &dofs);
        fs::write(folder.join(format!("{name}.mtx")), market).unwrap();
        fs::write(folder.join(format!("{name}.pch")), punch).unwrap();
    }
    let path = |name: &str| folder.join(name).display().to_string();
    let inputs = [
        format!("{} {}", blade("blade.sti"), blade("blade.mas")),
        format!(
            "{} {} --dofs {}",
            path("sti.mtx"),
            path("mas.mtx"),
            blade("blade.dof")
        ),
        format!("{} {}", path("sti.pch"), path("mas.pch")),
    ];
    for method in Method::names() {
        let files: Vec<String> = inputs
            .iter()
            .map(|files| {
                let line = format!(
                    "reduce {files} --at tip=28:y --at root=9:z --modes 6 --method {method}"
                );
                let text = made(&line, &folder.join("one.structure"));
                let lines = text.lines().filter(|line| !line.starts_with("source"));
                lines.collect::<Vec<_>>().join("\n")
            })
            .collect();
        assert!(files[0].contains("point root 9:z"));
        assert_eq!(files[0], files[1], "{method}");
        assert_eq!(files[0], files[2], "{method}");
    }
}

#[test]
fn what_cannot_be_reduced_is_told() {
    let (stiffness, mass) = (blade("blade.sti"), blade("blade.mas"));
    let files = format!("reduce {stiffness} {mass}");
    let cases = [
        ("reduce".to_owned(), "needs the stiffness and the mass"),
        (files.clone(), "no point is named"),
        (format!("{files} --at tip=28:w"), "`w` is no direction"),
        (
            format!("{files} --at tip=28:rx"),
            "node 28 moves in 28:x, 28:y, 28:z",
        ),
        (format!("{files} --at tip=1:y"), "numbers from 2 to"),
        (
            format!("{files} --at tip=28:y --at tip=27:y"),
            "more than once",
        ),
        (
            format!("{files} --at tip=28:y --at top=28:y"),
            "lie both at 28:y",
        ),
        (
            format!("{files} --at 2tip=28:y"),
            "no name that a model can use",
        ),
        (
            format!("{files} --at tip=28:y --method fre"),
            "did you mean `free`?",
        ),
        (
            format!("{files} --at tip=28:y --units mm-t"),
            "names no three units",
        ),
        (
            format!("{files} --at tip=28:y --modes 0"),
            "no whole number from 1",
        ),
        (
            format!("{files} {mass} --at tip=28:y --ratio 0.01"),
            "exclude each other",
        ),
    ];
    for (line, part) in cases {
        let answer = stickslip(&words(&line));
        assert_eq!(answer.code, Some(2), "{line}: {}", answer.stderr);
        assert!(answer.stderr.contains(part), "{line}: {}", answer.stderr);
        assert_eq!(answer.stdout, "", "{line}");
    }
    let answer = stickslip(&words(&format!("{files} --at tip=28:y --modes 120")));
    assert_eq!(answer.code, Some(1), "{}", answer.stderr);
    assert!(answer.stderr.contains("has only"), "{}", answer.stderr);
}

/// Linear finite elements along a line, held at both ends: a tridiagonal matrix by its diagonal and what is beside it.
type Line = (f64, f64);

/// The Kronecker product of lines: a block of finite elements, scalar, whose eigenvalues are known.
fn block(sides: [u32; 3], terms: &[[Line; 3]]) -> Coefficients {
    let [a, b, c] = sides;
    let mut entries = Vec::new();
    for row in 0..a * b * c {
        let at = [row % a, row / a % b, row / a / b];
        for neighbour in 0..27_u32 {
            let to = [neighbour % 3, neighbour / 3 % 3, neighbour / 9];
            let to: Vec<u32> = (0..3).map(|i| (at[i] + to[i]).wrapping_sub(1)).collect();
            let column = to[0]
                .wrapping_add(to[1].wrapping_mul(a))
                .wrapping_add(to[2].wrapping_mul(a * b));
            if (0..3).any(|i| to[i] >= sides[i]) || column > row {
                continue;
            }
            let product = |lines: &[Line; 3]| -> f64 {
                (0..3)
                    .map(|i| {
                        if to[i] == at[i] {
                            lines[i].0
                        } else {
                            lines[i].1
                        }
                    })
                    .product()
            };
            entries.push((row, column, terms.iter().map(product).sum()));
        }
    }
    Coefficients {
        source: Source::default(),
        unknowns: (a * b * c) as usize,
        places: Vec::new(),
        scattered: false,
        whole: false,
        entries,
    }
}

/// A block of 100,000 unknowns, each with 26 neighbours: its frequencies are known, and many of them coincide.
#[test]
#[ignore = "long"]
fn a_large_block_has_its_frequencies() {
    let sides = [40, 50, 50];
    let (k, m): (Line, Line) = ((2.0, -1.0), (4.0 / 6.0, 1.0 / 6.0));
    let stiffness = block(sides, &[[k, m, m], [m, k, m], [m, m, k]]);
    let pencil = Pencil::new(&stiffness, &block(sides, &[[m, m, m]]), None).unwrap();
    assert_eq!(pencil.unknowns(), 100_000);
    let point = Point {
        name: "middle".into(),
        place: "51020".parse().unwrap(),
    };
    let structure = reduce(&pencil, &[point], 12, Method::Free).unwrap();
    let along = |j: u32, side: u32| {
        let cosine = (f64::from(j) * PI / f64::from(side + 1)).cos();
        6.0 * (1.0 - cosine) / (2.0 + cosine)
    };
    let mut known = Vec::new();
    for i in 1..8 {
        for j in 1..8 {
            for l in 1..8 {
                known.push((along(i, sides[0]) + along(j, sides[1]) + along(l, sides[2])).sqrt());
            }
        }
    }
    known.sort_by(f64::total_cmp);
    for (mode, known) in structure.modes.iter().take(12).zip(known) {
        assert!(
            (mode.frequency - known).abs() < 1e-10 * known,
            "{} is not {known}",
            mode.frequency
        );
    }
}
