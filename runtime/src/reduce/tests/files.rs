//! Files of all formats, good and bad.

use std::path::PathBuf;

use crate::reduce::{Pencil, ReduceError, read};

fn written(name: &str, text: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("stickslip-reduce-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path
}

#[test]
fn three_formats_of_one_matrix_are_one_matrix() {
    let market = "%%MatrixMarket matrix coordinate real symmetric\n% a comment\n3 3 4\n1 1 2.5\n2 1 -1\n2 2 2\n3 3 4e2\n";
    let columns = "1 1 2.5\n1 2 -1.\n2 2 2.\n3 3 4.e2\n";
    let punch = "DMIG    KAAX    0       6       2       0                               \n\
                 DMIG*   KAAX                           1               1                        \n\
                 *                      1               1 2.500000000D+00                        \n\
                 *                      1               2-1.000000000D+00                        \n\
                 DMIG*   KAAX                           1               2                        \n\
                 *                      1               2 2.000000000D+00                        \n\
                 DMIG*   KAAX                           7               3                        \n\
                 *                      7               3 4.000000000D+02                        \n";
    let a = read(&written("k.mtx", market), "stiffness").unwrap();
    written("k.dof", "1.1\n1.2\n7.3\n");
    let b = read(&written("k.sti", columns), "stiffness").unwrap();
    let c = read(&written("k.pch", punch), "stiffness").unwrap();
    assert_eq!(b.places, c.places);
    let pencils = [&a, &b, &c].map(|one| Pencil::new(one, one, None).unwrap());
    for pencil in &pencils {
        assert_eq!(pencil.rows, pencils[0].rows);
        assert_eq!(pencil.stiffness, [2.5, -1.0, 2.0, 400.0]);
    }
    let free = "DMIG,KAAX,0,6,1\nDMIG,KAAX,1,1,,1,1,2.5\n,1,2,-1.\nDMIG,KAAX,1,2,,1,2,2.\nDMIG,KAAX,7,3,,7,3,4.D2\n";
    let d = read(&written("free.bdf", free), "stiffness").unwrap();
    assert_eq!((d.entries, d.places), (c.entries, c.places));
}

#[test]
fn files_that_make_no_sense_are_refused_by_their_lines() {
    let head = "%%MatrixMarket matrix coordinate real symmetric\n";
    let cases = [
        ("a.mtx", format!("{head}2 2 1\n1 3 1.0\n"), "line 3"),
        (
            "b.mtx",
            format!("{head}2 2 1\n1 0 1.0\n"),
            "lies outside 1 to 2",
        ),
        (
            "c.mtx",
            format!("{head}2 2 2\n1 1 1.0\n"),
            "2 entries are announced, but there are 1",
        ),
        ("d.mtx", format!("{head}2 3 0\n"), "must be square"),
        ("e.mtx", format!("{head}2 2 1\n1 1 nan\n"), "not finite"),
        (
            "f.mtx",
            "%%MatrixMarket matrix array real general\n".into(),
            "sparse real matrix",
        ),
        ("g.mtx", head.into(), "is missing"),
        ("h.sti", "1 1\n".into(), "three columns"),
        ("i.sti", "1 1 x\n".into(), "`x` is not a number"),
        ("j.txt", "hello world".into(), "no format"),
        (
            "k.pch",
            "DMIG    KAAX    1       1               1       1       2.0\n".into(),
            "no `DMIG` line",
        ),
        (
            "l.pch",
            "DMIG    KAAX    0       9       2       0\n".into(),
            "form `9`",
        ),
    ];
    for (name, text, part) in cases {
        let error = read(&written(name, &text), "mass").unwrap_err().to_string();
        assert!(error.contains(part), "{name}: {error}");
    }
    assert!(matches!(
        read(&PathBuf::from("/nowhere/k.mtx"), "mass"),
        Err(ReduceError::Unreadable { .. })
    ));
}
