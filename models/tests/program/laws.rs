//! What the program says of friction laws, and the units that it gives with everything.

use serde_json::Value;

use crate::{stickslip, words};

fn json(line: &str) -> Value {
    let answer = stickslip(&words(line));
    assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

#[test]
fn every_law_is_listed_with_its_curve() {
    let laws = json("laws --json");
    let laws = laws["laws"].as_array().unwrap();
    assert!(laws.len() >= 12);
    // Those with internal state have loops instead.
    for law in laws.iter().filter(|law| law.get("stick").is_some()) {
        assert_eq!(law["units"]["force"], "N", "{law}");
        let limit = law["limit_at_rest"].as_f64().unwrap();
        let forces = law["curve"]["force"].as_array().unwrap();
        let largest = forces.iter().filter_map(Value::as_f64).fold(0.0, f64::max);
        assert!(limit > 0.0 && largest >= limit, "{law}");
        for parameter in law["parameters"].as_array().unwrap() {
            assert_ne!(parameter["doc"], "", "{parameter}");
            assert!(law["values"][parameter["name"].as_str().unwrap()].is_f64());
        }
    }
}

#[test]
fn a_law_is_drawn_as_it_is_set() {
    let law = json("laws weakening --set limit=2 --set decay=4 --speed 1 --smooth tanh:50 --json");
    assert_eq!(law["smoothing"], "tanh:50");
    let column = |name: &str| law["curve"][name].as_array().unwrap().clone();
    let (speeds, forces, copies) = (column("speed"), column("force"), column("copy"));
    let last = speeds.len() - 1;
    assert_eq!((&speeds[0], &speeds[last]), (&(-1.0).into(), &1.0.into()));
    assert_eq!((&forces[0], &forces[last]), (&(-0.4).into(), &0.4.into()));
    assert!((copies[last].as_f64().unwrap() - 0.4).abs() < 1e-12);
}

/// A spring with a slider goes round a parallelogram, and says where it stops.
#[test]
fn a_law_with_stops_is_drawn_to_them() {
    let law = json("laws jenkins --set level=2 --json");
    assert_eq!(law["states"][0]["stop"], "level");
    let force = law["loops"][0]["force"].as_array().unwrap();
    let largest = force.iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    assert_eq!(largest, 2.0);
    let text = stickslip(&words("laws jenkins")).stdout;
    assert!(text.contains("  stop z at level\n"), "{text}");
}

#[test]
fn a_model_shows_the_laws_that_act_in_it() {
    let law = json("laws drill-string --set theta=2 --set kinetic=1 --json");
    assert_eq!(
        (&law["name"], &law["limit_at_rest"]),
        (&"CoulombStatic".into(), &3.0.into())
    );
    let pair = json("laws belt-pair --json");
    assert_eq!(pair["laws"].as_array().unwrap().len(), 2);
    let belt = json("laws belt-oscillator --json");
    assert_eq!(belt["units"]["speed"], "m/s");
}

#[test]
fn wrong_words_are_named() {
    for (line, part) in [
        ("laws weakning", "did you mean `weakening`?"),
        ("laws weakening --set deacy=1", "did you mean `decay`?"),
        ("laws weakening --set decay=-1", "decay >= 0"),
        (
            "laws weakening --smooth quartic:1e-2",
            "`Weakening` has none",
        ),
        (
            "laws coulomb-static --smooth arctan:1e3",
            "static peak of `CoulombStatic`",
        ),
        ("laws --set limit=1", "name it"),
        ("laws van-der-pol", "has no friction"),
        ("laws weakening --speed 0", "not above 0"),
    ] {
        let answer = stickslip(&words(line));
        assert_eq!(answer.code, Some(2), "{line}: {}", answer.stdout);
        assert!(answer.stderr.contains(part), "{line}: {}", answer.stderr);
    }
}

#[test]
fn every_column_and_document_has_its_units() {
    let folder = std::env::temp_dir().join(format!("stickslip-units-{}", std::process::id()));
    let out = folder.display();
    for (line, file, head) in [
        (
            "simulate belt-oscillator --time 5",
            "trajectory",
            "t (s),x (m),v (m/s),F (N)\n",
        ),
        (
            "orbit belt-oscillator",
            "orbit",
            "t (s),x (m),v (m/s),F (N)",
        ),
        (
            "branch belt-oscillator --along v_dr=0.2..0.19",
            "branch",
            "v_dr (m/s),period (s),",
        ),
        (
            "equilibria belt-oscillator --along v_dr=0.2..0.19",
            "equilibria",
            "v_dr (m/s),x (m),v (m/s),eigenvalue_1_re (1/s)",
        ),
        ("laws weakening", "weakening", "speed (m/s),force (N),"),
    ] {
        let answer = stickslip(&words(&format!("{line} --out {out}")));
        assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
        let sheet = std::fs::read_to_string(folder.join(format!("{file}.csv"))).unwrap();
        assert!(
            sheet.starts_with(head),
            "{line}: {}",
            sheet.lines().next().unwrap()
        );
        let picture = std::fs::read_to_string(folder.join(format!("{file}.svg"))).unwrap();
        assert!(picture.contains(" (m"), "{line}");
        if file != "weakening" {
            let document = std::fs::read_to_string(folder.join(format!("{file}.json"))).unwrap();
            let document: Value = serde_json::from_str(&document).unwrap();
            let units = &document["units"];
            assert_eq!(
                (&units["x"], &units["F"], &units["time"]),
                (&"m".into(), &"N".into(), &"s".into())
            );
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
}
