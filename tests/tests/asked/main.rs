//! A branch says the same, however it is asked.

mod answer;
mod doubled;
mod question;

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use answer::{Answer, compare};
use question::Question;
use stickslip_tests::random::Random;

/// Branches that are drawn, if nothing else is said: half an hour of two cores.
const BRANCHES: usize = 500;
/// Points after which one that is drawn is left: one in six hundred answers has more, and what is left was a quarter of all time
/// when that was twice as much. Of those that once differed, one has five hundred.
const MOST: usize = 300;
/// Share of the answers that may end with a warning; none may say something else.
const UNDECIDED: f64 = 0.02;

/// What came of many random branches.
#[derive(Debug, Default)]
struct Tally {
    branches: usize,
    answers: usize,
    /// Special points of the branches that were asked at another accuracy, too, each to the sum of both estimates.
    special: usize,
    undecided: Vec<String>,
    differ: Vec<String>,
}

impl Tally {
    /// Asks one random branch, as it is adapted, in four more ways.
    fn ask(&mut self, seed: u64, adapt: impl Fn(Question) -> Question) {
        let mut dice = Random::new(seed);
        let question = adapt(Question::random(&mut dice));
        let Some(first) = question.answer() else {
            return;
        };
        self.branches += 1;
        self.answers += 1;
        if let Some(reason) = &first.undecided {
            self.undecided.push(format!("{seed}: {question}: {reason}"));
            return;
        }
        let others = [
            (
                "accuracy",
                Some(question.at_accuracy(dice.positive(1e-11, 1e-7))),
            ),
            ("far end", question.up_to(&first, dice.between(0.3, 0.9))),
            ("reverse", question.reversed(&first)),
            ("middle", question.begun_within(&first, dice.unit())),
        ];
        for (way, other) in others {
            let Some(other) = other else { continue };
            self.answers += 1;
            let told = format!("{seed}, {way}: {question}\n  {other}");
            match other.answer() {
                None => continue,
                Some(Answer {
                    undecided: Some(reason),
                    ..
                }) => {
                    self.undecided.push(format!("{told}: {reason}"));
                }
                Some(answer) => {
                    if way == "accuracy" {
                        self.special += first.record.special.len();
                    }
                    let gap = compare(&first, &answer, way);
                    self.differ.extend(gap.map(|gap| format!("{told}: {gap}")));
                }
            }
        }
    }
}

/// How many branches, and from which seed on, if it is not the usual: `ASKED=60 SEED=1000`.
fn number(name: &str, usual: usize) -> usize {
    let given = std::env::var(name).ok();
    given.and_then(|given| given.parse().ok()).unwrap_or(usual)
}

#[test]
#[ignore = "long"]
fn branches_say_the_same_however_they_are_asked() {
    let (count, seed) = (number("ASKED", BRANCHES), number("SEED", 0));
    let (tally, next) = (Mutex::new(Tally::default()), AtomicUsize::new(seed));
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while tally.lock().is_ok_and(|tally| tally.branches < count) {
                    let mut own = Tally::default();
                    let seed = next.fetch_add(1, Ordering::Relaxed) as u64;
                    own.ask(seed, |question| question.left_after(MOST));
                    if let Ok(mut all) = tally.lock() {
                        own.undecided
                            .iter()
                            .for_each(|one| println!("UNDECIDED {one}"));
                        own.differ.iter().for_each(|one| println!("DIFFERS {one}"));
                        all.branches += own.branches;
                        all.answers += own.answers;
                        all.special += own.special;
                        all.undecided.extend(own.undecided);
                        all.differ.extend(own.differ);
                    }
                }
            });
        }
    });
    let tally = tally.into_inner().expect("all is told");
    let undecided = tally.undecided.len();
    println!(
        "{} branches, {} answers, {} special points at two accuracies, {undecided} undecided, {} differ",
        tally.branches,
        tally.answers,
        tally.special,
        tally.differ.len()
    );
    assert!(tally.differ.is_empty(), "{:#?}", tally.differ);
    assert!(
        undecided as f64 <= UNDECIDED * tally.answers as f64,
        "{:#?}",
        tally.undecided
    );
}

/// Seeds of branches that once said something else when they were asked in another way: where orbits that double end at a
/// graze, where a flip, a fold, both or another border follow a border at once, where the step past one leaps over a loop,
/// and where two events are exchanged next to a fold; where a step behind a fold falls back, where orbits begin next to a
/// resonance, where two flips lie between two points, where two runs agree by chance, and where a flip lies next to the border
/// at which orbits that double end, or next to a meeting what digits leave of a multiplier; where a contact is held just at its
/// limit, where a step leaps out of the range and back, and where a border is one of the orbit that is doubled; where one begins
/// with a doubled orbit next to its flip, or with one that amplifies too much, and where a stretch begins right behind a fold;
/// where multipliers are so large that no orbit on a border is found at one of two accuracies, and where a
/// stretch that vanishes is known worse than orbits are.
const DIFFERED: [u64; 24] = [
    241, 285, 327, 339, 347, 364, 400, 412, 421, 423, 454, 501, 527, 100_033, 200_022, 300_017,
    500_037, 500_055, 700_028, 700_010, 700_030, 800_034, 800_013, 830_078,
];

#[test]
#[ignore = "long"]
fn branches_that_once_differed_agree() {
    let mut tally = Tally::default();
    let seeds = DIFFERED.into_iter();
    seeds.for_each(|seed| tally.ask(seed, std::convert::identity));
    assert_eq!(tally.branches, DIFFERED.len());
    assert!(tally.differ.is_empty(), "{:#?}", tally.differ);
    assert!(tally.undecided.is_empty(), "{:#?}", tally.undecided);
}
