//! Every document has the form that the program prints of it.

use serde_json::Value;

use crate::{stickslip, words};

/// One line for each form of a document.
const LINES: [&str; 39] = [
    "attractors belt-oscillator --box x=-2..2,v=-1..1 --starts 5 --along v_dr=0.2..0.4 --values 2 --follow",
    "branch drill-string --along eta=4..6 --and zeta=0.05..0.06",
    "models drill-string",
    "laws hertz",
    "laws --speed 0.1",
    "simulate forced-belt --time 20 --section phi=0",
    "attractors belt-oscillator --box x=-2..2,v=-1..1 --starts 20 --areas",
    "map belt-oscillator --along v_dr=0.1..0.4:2 --and delta=2..3:2 multiplier",
    "models",
    "models belt-pair",
    "models bristle-oscillator",
    "laws",
    "laws stribeck",
    "laws dahl",
    "laws belt-pair",
    "simulate belt-pair --time 5",
    "simulate belt-oscillator --time 20 --section v=0",
    "simulate belt-oscillator --time 5 --section x=5",
    "orbit belt-oscillator --certify --harmonics 1,3",
    "orbit forced-belt",
    "orbit van-der-pol",
    "orbit belt-oscillator --smooth arctan:1e3 --section v=0",
    "branch belt-pair --along v_dr=0.3..0.24 --start x1=-0.03,x2=0.678,v2=0.3 --period 4.3 --switch flips",
    "branch belt-oscillator --smooth arctan --along smooth=1e2..1e3",
    "branch forced-belt --along omega=1.2..1.1",
    "equilibria belt-pair --certify",
    "equilibria belt-oscillator --smooth arctan:100 --along v_dr=0.2..0.01",
    "equilibria drill-string --along eta=5..1",
    "diagram belt-oscillator --along v_dr=0.1..0.2 --values 3 --lyapunov 20",
    "diagram belt-oscillator --along v_dr=0.1..0.2 --values 2 --section x=5",
    "trade belt-oscillator --accuracy 1e-2",
    "trade drill-string",
    "needs belt-oscillator --accuracy 1e-2",
    "needs van-der-pol",
    "needs forced-belt --along omega=1.2..1.1",
    "attractors belt-oscillator --box x=-2..2,v=-1..1 --starts 20",
    "attractors belt-oscillator --box x=-2..2,v=-1..1 --starts 5 --along v_dr=0.2..0.4 --values 2",
    "map belt-oscillator --along v_dr=0.1..0.4:2 --and delta=2..3:2 period",
    "map belt-oscillator --along v_dr=0.1..0.4:2 --and delta=2..3:2 motion",
];

#[test]
fn every_document_has_the_form_that_is_printed() {
    let printed = stickslip(&["--json-schema"]);
    assert_eq!((printed.code, printed.stderr.as_str()), (Some(0), ""));
    let schema: Value = serde_json::from_str(&printed.stdout).unwrap();
    for line in LINES {
        let answer = stickslip(&words(&format!("{line} --json --quiet")));
        let document: Value = serde_json::from_str(&answer.stdout).expect(line);
        assert_eq!(document["schema"], 1, "{line}");
        let forms = schema["anyOf"].as_array().unwrap();
        let fits = |form: &&Value| fault(&schema, form, &document, "").is_none();
        let fitting = forms.iter().filter(fits).count();
        let faults = forms
            .iter()
            .filter_map(|form| fault(&schema, form, &document, ""));
        assert_eq!(fitting, 1, "{line}: {:?}", faults.collect::<Vec<_>>());
    }
}

#[test]
fn what_has_another_form_is_found() {
    let schema: Value = serde_json::from_str(&stickslip(&["--json-schema"]).stdout).unwrap();
    let answer = stickslip(&words("orbit van-der-pol --json --quiet"));
    let orbit: Value = serde_json::from_str(&answer.stdout).unwrap();
    let form = &serde_json::json!({ "$ref": "#/$defs/orbit" });
    assert_eq!(fault(&schema, form, &orbit, ""), None);
    for (field, value) in [
        ("period", Value::from("6.66")),
        ("stability", "good".into()),
        ("new", 1.into()),
        ("multipliers", serde_json::json!([[1.0]])),
        ("log_abs_multipliers", serde_json::json!(["inf"])),
    ] {
        let mut other = orbit.clone();
        other[field] = value;
        assert!(fault(&schema, form, &other, "").is_some(), "{field}");
    }
}

/// Where a value does not have a form, by the words of JSON Schema that ours uses; others are errors.
fn fault(schema: &Value, form: &Value, value: &Value, at: &str) -> Option<String> {
    let wrong = |holds: bool, what: &str| (!holds).then(|| format!("{at}: {what}"));
    let inner = |form: &Value| fault(schema, form, value, at);
    form.as_object()?
        .iter()
        .find_map(|(word, rule)| match word.as_str() {
            "description" | "title" | "$schema" | "$id" | "$defs" => None,
            "$ref" => {
                let name = rule.as_str()?.trim_start_matches("#/$defs/");
                let form = &schema["$defs"][name];
                assert!(form.is_object(), "{name}");
                inner(form)
            }
            "const" => wrong(value == rule, "another constant"),
            "enum" => wrong(rule.as_array()?.contains(value), "not among the words"),
            "type" => {
                let names = rule
                    .as_array()
                    .cloned()
                    .unwrap_or_else(|| vec![rule.clone()]);
                wrong(names.iter().any(|name| is(value, name.as_str())), "type")
            }
            "anyOf" => {
                let any = rule.as_array()?.iter().any(|form| inner(form).is_none());
                wrong(any, "none of the forms")
            }
            "allOf" => rule.as_array()?.iter().find_map(inner),
            "minItems" => wrong(value.as_array()?.len() as u64 >= rule.as_u64()?, "too few"),
            "maxItems" => wrong(value.as_array()?.len() as u64 <= rule.as_u64()?, "too many"),
            "items" => {
                let mut items = value.as_array()?.iter().enumerate();
                items.find_map(|(i, item)| fault(schema, rule, item, &format!("{at}/{i}")))
            }
            "required" if !value.is_object() => None,
            "required" => {
                let missing = |name: &&Value| value.get(name.as_str().unwrap()).is_none();
                let missing = rule.as_array()?.iter().find(missing)?;
                Some(format!("{at} lacks {missing}"))
            }
            "properties" => value.as_object()?.iter().find_map(|(name, field)| {
                fault(schema, rule.get(name)?, field, &format!("{at}/{name}"))
            }),
            "additionalProperties" => value.as_object()?.iter().find_map(|(name, field)| {
                let known = form["properties"].get(name).is_some();
                let at = format!("{at}/{name}");
                match rule {
                    _ if known => None,
                    Value::Bool(allowed) => (!allowed).then(|| format!("{at} is unknown")),
                    rule => fault(schema, rule, field, &at),
                }
            }),
            other => panic!("the schema says `{other}`, which nothing here checks"),
        })
}

fn is(value: &Value, name: Option<&str>) -> bool {
    match name {
        Some("object") => value.is_object(),
        Some("array") => value.is_array(),
        Some("string") => value.is_string(),
        Some("boolean") => value.is_boolean(),
        Some("null") => value.is_null(),
        Some("integer") => value.is_i64() || value.is_u64(),
        Some("number") => value.is_number(),
        other => panic!("{other:?} is no type"),
    }
}
