//! What a scene needs, as text.

use crate::app::text::{heading, label, line, number, short, table};
use crate::field::Kernel;
use crate::model::ModelInfo;
use crate::study::trade::{Cost, Need, Setting};
use crate::study::{
    Case, ContactNeed, Lack, ModesNeed, NeedsRecord, ParameterNeed, Role, Topic, TradeRecord,
};

/// What is being looked at, for the progress.
pub(super) const fn topic(topic: Topic) -> &'static str {
    match topic {
        Topic::Orbits => "orbits",
        Topic::Modes => "modes",
        Topic::Contacts => "contacts",
        Topic::Parameters => "parameters",
        Topic::Copies => "smooth copies",
    }
}

pub(super) fn describe(info: &ModelInfo, case: &Case, record: &NeedsRecord) -> String {
    let what = format!("the least that answers to {}", short(record.accuracy));
    let mut text = heading(info, case, &what);
    text += &judged(info, record);
    let parts = [
        ("modes", record.modes.iter().map(modes).collect()),
        ("contact", record.contacts.iter().map(contact).collect()),
        ("parameter", parameters(info, record)),
        (
            "computed",
            record.copies.as_ref().map_or(String::new(), copies),
        ),
    ];
    for (word, lines) in parts {
        let lines: String = lines;
        if !lines.is_empty() {
            text += &format!("\n{}", table(&(head(word).to_owned() + &lines)));
        }
    }
    for remark in remarks(record) {
        text += &format!("\n  {remark}\n");
    }
    text
}

/// The heads of the columns.
fn head(word: &str) -> &'static str {
    match word {
        "modes" => "structure\tmodes\tof\tneeded\terror\tsteps saved\n",
        "contact" => "contact\there\tmay be written as\terror\tmargin\n",
        "parameter" => "parameter\tdoes not matter from\tto\terror\n",
        _ => "computed\terror\ttolerance\tsteps\tone period\n",
    }
}

/// Where it was judged.
fn judged(info: &ModelInfo, record: &NeedsRecord) -> String {
    let Some(along) = &record.along else {
        return match record.places.first() {
            Some(place) => format!(
                "  judged on one orbit, of the period {}\n",
                number(place.period, 6)
            ),
            None => "  there is no orbit to judge it on\n".to_owned(),
        };
    };
    let followed = along.design.parameter();
    let values = record
        .places
        .iter()
        .filter_map(|place| place.parameters.get(followed?).copied());
    let values: Vec<String> = values.map(|value| number(value, 5)).collect();
    let mut text = format!("  judged at {} = {}\n", along.name(info), values.join(", "));
    if let Some(ended) = record.ended.as_ref().filter(|ended| !ended.is_whole()) {
        text += &format!(
            "  beyond which its branch was not followed: {}\n",
            ended.reason
        );
    }
    text
}

fn modes(need: &ModesNeed) -> String {
    let needed = match (need.needed, need.more) {
        (Some(needed), _) => needed.to_string(),
        (None, Some(more)) => format!("about {more}"),
        (None, None) => format!("more than {}", need.there),
    };
    let error = match need.needed {
        Some(_) => need.error + need.beyond,
        None => need.beyond,
    };
    line([
        need.structure.to_owned(),
        need.kept.to_string(),
        need.there.to_string(),
        needed,
        number(error, 2),
        saved(need.steps),
    ])
}

/// Steps that are saved, of how many.
fn saved([whole, thin]: [u64; 2]) -> String {
    format!("{} of {whole}", whole.saturating_sub(thin))
}

fn contact(need: &ContactNeed) -> String {
    let role = match need.role {
        Role::Switches => "switches",
        Role::NeverSticks => "slides both ways, never sticks",
        Role::SlidesOneWay => "slides one way",
        Role::NeverSlides => "never slides",
        Role::NeverRubs => "never rubs",
        Role::NeverCloses => "never closes",
        Role::NeverOpens => "never opens",
    };
    let written = need.role.instead();
    line([
        need.name.to_owned(),
        role.to_owned(),
        written.unwrap_or("-").to_owned(),
        if written.is_some() { "0" } else { "-" }.to_owned(),
        need.margin
            .map_or_else(|| "-".to_owned(), |margin| number(margin, 2)),
    ])
}

fn parameters(info: &ModelInfo, record: &NeedsRecord) -> String {
    let idle = record.parameters.iter().filter(|need| !need.matters);
    idle.map(|need| parameter(info, need)).collect()
}

fn parameter(info: &ModelInfo, need: &ParameterNeed) -> String {
    let mut declared = info.parameters.iter();
    let declared = declared.find(|declared| declared.name == need.name);
    let ends = need.over.unwrap_or([need.value; 2]);
    let error = need
        .error
        .map_or_else(|| "-".to_owned(), |error| number(error, 2));
    let [from, to] = ends.map(|end| number(end, 4));
    line([
        label(need.name, declared.and_then(|declared| declared.unit)),
        from,
        to,
        error,
    ])
}

/// The exact system and the copies, each where it is most demanding.
fn copies(record: &TradeRecord) -> String {
    let exact = record.ends.iter().filter_map(|end| end.trade.need.as_ref());
    let exact = exact.max_by_key(|need| need.as_ref().map_or(u64::MAX, |one| one.cost.work.steps));
    let mut lines = match exact {
        Some(Ok(found)) => format!("exact\t{}\n", setting(found)),
        Some(Err(reason)) => format!("exact\t{reason}\n"),
        None => String::new(),
    };
    for kernel in Kernel::ALL {
        lines += &match record.need(kernel) {
            Some((
                _,
                Ok(Need {
                    smoothing,
                    setting: found,
                    ..
                }),
            )) => {
                let size = number(smoothing.size, 3);
                format!("{kernel}:{size}\t{}\n", setting(&found))
            }
            Some((_, Err(reason))) => format!("{kernel}\t{reason}\n"),
            None => String::new(),
        };
    }
    lines
}

fn setting(found: &Setting) -> String {
    let Cost { seconds, work } = &found.cost;
    let (error, tolerance) = (number(found.error, 2), number(found.tolerance, 2));
    format!(
        "{error}\t{tolerance}\t{}\t{:.0} us",
        work.steps,
        1e6 * seconds
    )
}

fn remarks(record: &NeedsRecord) -> Vec<String> {
    let mut remarks = Vec::new();
    if let Some(together) = record.together {
        let together = number(together, 2);
        remarks.push(format!(
            "all structures reduced to that at once: an error of {together}"
        ));
    }
    if let Some(cheapest) = record.cheapest() {
        remarks.push(format!("fewest steps: {cheapest}"));
    }
    let count = record.parameters.len();
    let matter = record.parameters.iter().filter(|need| need.matters).count();
    if count > 0 {
        remarks.push(format!("{matter} of {count} parameters matter"));
    }
    if record.copies.is_none() && !record.places.is_empty() {
        remarks.push("nothing here could be smoothed".to_owned());
    }
    remarks.extend(
        record
            .lacks
            .iter()
            .map(|one| format!("lacking: {}", lack(one))),
    );
    remarks
}

/// What is lacking, in a sentence.
pub(super) fn lack(lack: &Lack) -> String {
    match lack {
        Lack::Press {
            force,
            bound,
            value,
            time,
        } => format!(
            "the law of `{force}` wants {bound}, and that comes to {} at t = {}: if that is the force that presses the contact, it \
             opens there, and wants a `press` line",
            number(*value, 3),
            number(*time, 6)
        ),
        Lack::Modes {
            structure,
            kept,
            there,
            needed,
            error,
            next,
        } => {
            let next = next.map_or(String::new(), |next| {
                format!(", the next of angular frequency {}", number(next, 5))
            });
            let way = match needed {
                Some(needed) => format!("`keeping {needed}` would do"),
                None => format!("the {there} of its file do not suffice: reduce it to more"),
            };
            format!(
                "the modes of `{structure}` beyond the {kept} that are kept{next} change the answer by about {}; {way}",
                number(*error, 2)
            )
        }
    }
}
