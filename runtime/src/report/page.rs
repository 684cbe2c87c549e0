//! A report as one HTML page that needs nothing but itself.

use super::figure::Figure;
use super::text::{escape, html, plain};
use super::{Block, Section, Table};

const STYLE: &str = include_str!("page.css");

/// The whole page, of which `bodies` are the sections: see [`section`].
pub(super) fn page(title: &str, subtitle: &str, sections: &[Section], bodies: &[String]) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <header>\n<h1>{title}</h1>\n<p class=\"subtitle\">{subtitle}</p>\n</header>\n\
         {contents}<main>\n{bodies}</main>\n</body>\n</html>\n",
        title = html(title),
        subtitle = html(subtitle),
        contents = contents(sections),
        bodies = bodies.concat(),
    )
}

fn contents(sections: &[Section]) -> String {
    let item = |(section, number): (&Section, usize)| {
        let (title, figures) = (html(&section.title), figures(section));
        format!("<li><a href=\"#section-{number}\">{title}</a>{figures}</li>\n")
    };
    let items: String = sections.iter().zip(1..).map(item).collect();
    format!("<nav aria-label=\"Contents\">\n<ol>\n{items}</ol>\n</nav>\n")
}

/// Links to the figures of a section.
fn figures(section: &Section) -> String {
    let links: Vec<String> = section
        .blocks
        .iter()
        .filter_map(|block| match block {
            Block::Figure(figure) => Some(format!(
                "<a href=\"#{}\" title=\"{}\">{}</a>",
                figure.name(),
                escape(&plain(&figure.title)),
                figure.number
            )),
            _ => None,
        })
        .collect();
    if links.is_empty() {
        String::new()
    } else {
        format!(
            " <span class=\"figures\">Figures {}</span>",
            links.join(", ")
        )
    }
}

/// One section, as it stands on the page.
pub(super) fn section(number: usize, section: &Section) -> String {
    let blocks: String = section.blocks.iter().map(block).collect();
    format!(
        "<section id=\"section-{number}\">\n<h2><span class=\"number\">{number}</span>{}</h2>\n{blocks}</section>\n",
        html(&section.title)
    )
}

fn block(block: &Block) -> String {
    match block {
        Block::Text(text) => format!("<p>{}</p>\n", html(text)),
        Block::Formula(text) => format!("<p class=\"formula\">{}</p>\n", html(text)),
        Block::Figure(one) => figure(one),
        Block::Sketch(svg, caption) => format!(
            "<figure class=\"sketch\">\n{svg}\n<figcaption>{}</figcaption>\n</figure>\n",
            html(caption)
        ),
        Block::Table(one) => table(one),
        Block::Page(one) => format!(
            "<p class=\"page\"><a href=\"{name}.html\">{link}</a> \
             <span class=\"data\"><a href=\"data/{name}.csv\">{name}.csv</a></span></p>\n",
            name = one.name,
            link = html(&one.link),
        ),
    }
}

fn figure(figure: &Figure) -> String {
    // Inside HTML the namespace is known, and the page must name no address at all.
    let svg = figure
        .svg()
        .replace(" xmlns=\"http://www.w3.org/2000/svg\"", "");
    let data: Vec<String> = (0..figure.panels.len())
        .map(|i| {
            let name = figure.panel_name(i);
            format!("<a href=\"data/{name}.csv\">{name}.csv</a>")
        })
        .collect();
    format!(
        "<figure id=\"{name}\">\n{svg}\n<figcaption><strong>Figure {number}. {title}.</strong> {caption} \
         <span class=\"data\"><a href=\"figures/{name}.svg\">SVG</a>, <a href=\"figures/{name}.pdf\">PDF</a>, {data}</span></figcaption>\n</figure>\n",
        name = figure.name(),
        number = figure.number,
        title = html(&figure.title),
        caption = html(&figure.caption),
        data = data.join(", "),
    )
}

fn table(table: &Table) -> String {
    let class = |i: usize| match table.columns.get(i) {
        Some(column) if column.numeric => " class=\"n\"",
        _ => "",
    };
    let line = |tag: &str, cells: Vec<&String>| -> String {
        let scope = if tag == "th" { " scope=\"col\"" } else { "" };
        let cells: String = cells
            .iter()
            .enumerate()
            .map(|(i, cell)| format!("<{tag}{scope}{}>{}</{tag}>", class(i), html(cell)))
            .collect();
        format!("<tr>{cells}</tr>\n")
    };
    let head = line("th", table.columns.iter().map(|c| &c.head).collect());
    let rows: String = table
        .rows
        .iter()
        .map(|row| line("td", row.iter().collect()))
        .collect();
    let body = format!(
        "<div class=\"scroll\" tabindex=\"0\"><table>\n<thead>\n{head}</thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n"
    );
    let body = if table.folded {
        let count = table.rows.len();
        format!("<details>\n<summary>The table: {count} rows</summary>\n{body}</details>\n")
    } else {
        body
    };
    format!(
        "<figure class=\"table\" id=\"{name}\">\n<figcaption>{caption} \
         <span class=\"data\"><a href=\"data/{name}.csv\">{name}.csv</a></span></figcaption>\n{body}</figure>\n",
        name = table.name,
        caption = html(&table.caption),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::draw::contrast::contrast;

    /// The colours that a style sheet gives to letters after its `n`th `:root`.
    fn letters(n: usize) -> Vec<&'static str> {
        let root = STYLE
            .split(":root {")
            .nth(n)
            .and_then(|css| css.split('}').next());
        let all = root
            .expect("colours")
            .split("--")
            .filter(|rule| !rule.starts_with("rule"));
        all.filter_map(|rule| rule.split_once(": ")?.1.get(..7))
            .filter(|colour| colour.starts_with('#'))
            .collect()
    }

    #[test]
    fn letters_are_read_by_day_and_by_night() {
        assert!(STYLE.contains("background: #fff;") && STYLE.contains("background: #161616;"));
        for (n, paper) in [(1, "#ffffff"), (2, "#161616")] {
            let letters = letters(n);
            assert_eq!(letters.len(), 3, "{letters:?}");
            for colour in letters {
                assert!(contrast(colour, paper) >= 4.5, "{colour} on {paper}");
            }
        }
    }
}
