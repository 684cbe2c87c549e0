//! How large a line may be: whoever reads formulas calls himself for each part of one, and the stack is finite.

use proc_macro2::{TokenStream, TokenTree};

/// Most tokens of a line, those in brackets included.
const LONGEST: usize = 2000;
/// Most brackets around a token.
const DEEPEST: usize = 60;

/// Why a line is too large to be read; `None` if it is not.
pub(super) fn unreadable(line: &TokenStream) -> Option<String> {
    let mut open = vec![line.clone().into_iter()];
    let mut tokens = 0;
    while let Some(innermost) = open.last_mut() {
        let Some(token) = innermost.next() else {
            open.pop();
            continue;
        };
        tokens += 1;
        if tokens > LONGEST {
            return Some(format!(
                "this line is longer than {LONGEST} words and signs: give names to parts of it with `let`"
            ));
        }
        if let TokenTree::Group(group) = token {
            if open.len() > DEEPEST {
                return Some(format!(
                    "brackets are nested deeper than {DEEPEST} here: give names to parts of the formula with `let`"
                ));
            }
            open.push(group.stream().into_iter());
        }
    }
    None
}
