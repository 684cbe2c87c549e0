//! Structures: what is told of their lines, and what these become.

use std::path::PathBuf;

use super::{NONE, of_model};

const BEAM: &str = "stickslip structure 1
method free
units SI
unknowns 60
source stiffness 10 bytes crc32 00000000 beam.sti
point tip 10:y
point root 3:y
point twist 10:rx
mode 1e1 1e-2 1 0.5 2
mode 4e1 2e-2 1 -0.5 0
mode 0e0 0e0 1 1 0
residual 1e-3 0 0
residual 0 2e-3 0
residual 0 0 0
";

/// The folder in which structures lie; each test has its own file.
fn written(name: &str, text: &str) -> PathBuf {
    let path =
        std::env::temp_dir().join(format!("stickslip-{}-{name}.structure", std::process::id()));
    std::fs::write(&path, text).unwrap();
    path
}

/// The messages for a model with a beam and these lines.
fn of_beam(name: &str, keeping: &str, lines: &str) -> Vec<String> {
    let path = written(name, BEAM);
    of_model(&format!("structure beam = {path:?}{keeping}; {lines}"))
}

const GOOD: &str = "
    state z: m = 0.0;
    param pull: N = 1.0;
    param k: N/m = 2.0;
    param level: N = 1.0 where level >= 0.0;
    param omega: rad/s = 1.0;
    drive phi at omega;
    friction F: N = Coulomb { level } opposing der(beam.root) - k / k * der(beam.tip);
    load beam.tip = pull * cos(phi) - k * (beam.tip - z);
    load beam.root = F;
    der(z) = der(beam.root);
";

#[test]
fn nothing_is_said_about_a_good_structure() {
    assert_eq!(of_beam("good", "", GOOD), NONE);
    assert_eq!(of_beam("kept", " keeping 2", GOOD), NONE);
    let flexible = GOOD.replace("2.0;", "2.0; let soft = beam.root.flexibility * k;");
    assert_eq!(of_beam("flexible", " keeping 1", &flexible), NONE);
}

#[test]
fn points_and_structures_must_be_there() {
    let told =
        |text: &str, replacement: &str| of_beam("there", "", &GOOD.replacen(text, replacement, 1));
    assert_eq!(
        told("load beam.tip", "load beam.tp"),
        ["`beam` has no point `tp`; did you mean `tip`?"]
    );
    assert_eq!(
        told("(beam.tip - z)", "(beam.middle - z)"),
        [
            "`beam` has no point `middle`: its file names tip, root, twist; `stickslip reduce ... --at \
          middle=NODE:DIRECTION` names others"
        ]
    );
    assert_eq!(
        told("= der(beam.root)", "= der(bam.root)"),
        ["unknown structure `bam`; did you mean `beam`?"]
    );
    assert_eq!(
        told("(beam.tip - z)", "(wing.tip - z)"),
        [
            "`wing` is no structure; one is declared above its use by `structure wing = \"wing.structure\";`"
        ]
    );
    assert_eq!(
        told(
            "load beam.root = F;",
            "load beam.root = F; load beam.root = 2 * F;"
        ),
        ["second load at `beam.root`; write all forces there as one sum"]
    );
}

#[test]
fn units_are_those_of_the_file() {
    let told =
        |text: &str, replacement: &str| of_beam("units", "", &GOOD.replacen(text, replacement, 1));
    assert_eq!(
        told("load beam.root = F;", "load beam.root = F / k;"),
        ["unit mismatch: the load at `beam.root` is in N, but `F / k` is in m"]
    );
    assert_eq!(
        told(
            "load beam.root = F;",
            "load beam.root = F; load beam.twist = pull;"
        ),
        ["unit mismatch: the load at `beam.twist` is in N*m, but `pull` is in N"]
    );
    assert_eq!(
        told("der(z) = der(beam.root)", "der(z) = beam.root"),
        ["unit mismatch: `der(z)` is in m/s, but `beam.root` is in m"]
    );
}

#[test]
fn files_must_be_there_and_make_sense() {
    let told = of_model("structure beam = \"nowhere.structure\"; load beam.tip = 1.0;");
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(
        told[0].contains("nowhere.structure` cannot be read"),
        "{told:?}"
    );
    let path = written("broken", "hello");
    let told = of_model(&format!("structure beam = {path:?};"));
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].contains("is no reduced structure"), "{told:?}");
    let told = of_beam("many", " keeping 4", "");
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(
        told[0].ends_with("has 3 modes: keep 1 to 3 of them"),
        "{told:?}"
    );
}

#[test]
fn structures_mix() {
    let path = written("mix", BEAM);
    let lines = "
        param k: N/m = 1.0;
        param level: N = 1.0;
        friction F: N = Coulomb { level } opposing der(a.tip) - der(b.tip);
        load a.tip = F - k * (a.tip - b.tip);
        load b.tip = k * (a.tip - b.tip) - F;
    ";
    let both = format!("structure a = {path:?} keeping 2; structure b = {path:?};");
    assert_eq!(of_model(&(both.clone() + lines)), NONE);
    let told = of_model(&format!(
        "{both} state a_tip = 0.0; der(a_tip) = 1; {lines}"
    ));
    assert_eq!(
        told,
        ["`a.tip` is declared twice: first as a `let`, here as a state; rename one"]
    );
}
