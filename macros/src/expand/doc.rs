//! Doc comments as data.

use syn::{Attribute, Expr, ExprLit, Lit, Meta};

/// Doc comments as one text, without the space after the slashes.
pub(super) fn doc(docs: &[Attribute]) -> String {
    let lines: Vec<String> = docs.iter().filter_map(doc_line).collect();
    lines.join("\n").trim().to_owned()
}

fn doc_line(attribute: &Attribute) -> Option<String> {
    let Meta::NameValue(doc) = &attribute.meta else {
        return None;
    };
    let Expr::Lit(ExprLit {
        lit: Lit::Str(line),
        ..
    }) = &doc.value
    else {
        return None;
    };
    let line = line.value();
    Some(
        line.strip_prefix(' ')
            .unwrap_or(&line)
            .trim_end()
            .to_owned(),
    )
}
