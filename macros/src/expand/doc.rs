//! Doc comments as data.

use syn::{Attribute, Expr, ExprLit, Lit};

/// Doc comments as one text, without the space after the slashes.
pub(super) fn doc(docs: &[Attribute]) -> String {
    let lines: Vec<String> = docs.iter().filter_map(doc_line).collect();
    lines.join("\n").trim().to_owned()
}

fn doc_line(attribute: &Attribute) -> Option<String> {
    let doc = attribute.meta.require_name_value().ok()?;
    let Expr::Lit(ExprLit {
        lit: Lit::Str(line),
        ..
    }) = &doc.value
    else {
        return None;
    };
    let line = line.value();
    let line = line.strip_prefix(' ').unwrap_or(&line);
    Some(line.trim_end().to_owned())
}
