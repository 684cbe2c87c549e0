//! Ticks on axes.

use super::scale::Scale;

/// Letters of a label up to which nobody misses a power of ten.
const SHORT: usize = 6;
/// Letters that a power of ten is as wide as.
const POWER: usize = 4;

/// A value marked on an axis: exactly what its label says.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    /// In the markup of reports.
    pub(super) label: String,
}

impl Scale {
    /// The densest ticks that fit.
    pub(super) fn ticks(&self, fits: impl Fn(&[Tick]) -> bool) -> Vec<Tick> {
        if !self.logarithmic {
            return self.even(self.ends, fits);
        }
        let decades = self.decades(&[1]);
        if decades.len() > 1 {
            let every = |n: i32| decades.iter().filter(move |(_, power)| power % n == 0);
            let sets = (1..).map(|n| every(n).map(|&(_, power)| decade(power)).collect());
            return first(sets, fits);
        }
        let least = self.ends[0].floor() as i32;
        let few = self.decades(&[1, 2, 5]).into_iter();
        let numbers = few.map(|(digit, power)| digit * 10_i64.pow((power - least) as u32));
        let few = labelled(numbers.collect(), least);
        if few.len() > 2 && fits(&few) {
            return few;
        }
        self.even(self.ends.map(|end| 10_f64.powf(end)), fits)
    }

    /// Values on a logarithmic axis that deserve a tick but no label.
    pub(super) fn unlabelled(&self) -> Vec<f64> {
        if !self.logarithmic {
            return Vec::new();
        }
        let digits: &[i64] = match self.decades(&[1]).len() {
            2..10 => &[2, 3, 4, 5, 6, 7, 8, 9],
            10..40 => &[1],
            _ => &[],
        };
        let values = self.decades(digits).into_iter();
        values.map(|(digit, power)| value(digit, power)).collect()
    }

    /// Multiples of 1, 2 or 5 of a power of ten from `low` to `high`.
    fn even(&self, [low, high]: [f64; 2], fits: impl Fn(&[Tick]) -> bool) -> Vec<Tick> {
        let finest = (0.01 * (high - low)).log10().floor() as i32;
        let finest = finest.max(self.finest());
        let steps = (finest..).flat_map(|power| [1, 2, 5].map(|digit| (digit, power)));
        let sets = steps.map(|(digit, power)| {
            let step = value(digit, power);
            let [from, to] = [(low / step).floor(), (high / step).ceil()];
            let multiples = (from as i64..=to as i64).map(|n| n * digit);
            let inside = |n: &i64| self.holds(value(*n, power));
            labelled(multiples.filter(inside).collect(), power)
        });
        first(sets, fits)
    }

    /// Products of these digits and powers of ten on a logarithmic axis, upwards.
    fn decades(&self, digits: &[i64]) -> Vec<(i64, i32)> {
        let [low, high] = self.ends;
        let powers = (low - 1.0).floor() as i32..=(high + 1.0).ceil() as i32;
        let all = powers.flat_map(|power| digits.iter().map(move |digit| (*digit, power)));
        all.filter(|&(digit, power)| self.holds(value(digit, power)))
            .collect()
    }
}

/// The first set that fits; where only single ticks do, the outer two of the last set of which these fit.
fn first(sets: impl Iterator<Item = Vec<Tick>>, fits: impl Fn(&[Tick]) -> bool) -> Vec<Tick> {
    let mut outer = Vec::new();
    for mut set in sets {
        if set.len() < 2 {
            return if outer.is_empty() { set } else { outer };
        }
        if fits(&set) {
            return set;
        }
        set.drain(1..set.len() - 1);
        if fits(&set) {
            outer = set;
        }
    }
    outer
}

/// The floating-point number next to number · 10ᵖᵒʷᵉʳ.
fn value(number: i64, power: i32) -> f64 {
    // A product would round twice, and at large powers overflow.
    format!("{number}e{power}").parse().unwrap_or(f64::NAN)
}

fn decade(power: i32) -> Tick {
    Tick {
        value: value(1, power),
        label: format!("10^{{{power}}}").replace('-', "−"),
    }
}

/// Ticks at numbers · 10ᵖᵒʷᵉʳ, all with the same decimals; and as mantissas with one power of ten where that is shorter.
fn labelled(numbers: Vec<i64>, power: i32) -> Vec<Tick> {
    let longest = |power: i32| {
        let lengths = numbers.iter().map(|n| decimal(n.abs(), power).len());
        lengths.max().unwrap_or(0)
    };
    let largest = numbers.iter().map(|n| n.abs()).max().unwrap_or(0);
    let top = largest.checked_ilog10().unwrap_or(0) as i32 + power;
    let plain = longest(power);
    let shorter = plain > SHORT && longest(power - top) + POWER <= plain;
    let label = |n: i64| match n {
        0 if shorter => "0".to_owned(),
        n if shorter => format!("{}·{}", decimal(n, power - top), decade(top).label),
        n => decimal(n, power),
    };
    let ticks = numbers.iter().map(|&n| Tick {
        value: value(n, power),
        label: label(n),
    });
    ticks.collect()
}

/// number · 10ᵖᵒʷᵉʳ, digit by digit.
fn decimal(number: i64, power: i32) -> String {
    let sign = if number < 0 { "−" } else { "" };
    let [places, zeros] = [-power, power].map(|count| count.max(0) as usize);
    let digits = format!("{:0>1$}", number.unsigned_abs(), places + 1);
    let (whole, rest) = digits.split_at(digits.len() - places);
    let zeros = "0".repeat(if number == 0 { 0 } else { zeros });
    let point = if rest.is_empty() { "" } else { "." };
    format!("{sign}{whole}{zeros}{point}{rest}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::figure::Axis;

    fn scale(low: f64, high: f64) -> Scale {
        Scale::new(&Axis::new("").from(low, high), std::iter::empty())
    }

    fn logarithmic(low: f64, high: f64) -> Scale {
        let axis = Axis::new("").from(low, high).logarithmic();
        Scale::new(&axis, std::iter::empty())
    }

    /// Whether these are the labels where so many fit.
    #[track_caller]
    fn check(scale: Scale, labels: &[&str]) {
        let ticks = scale.ticks(|ticks| ticks.len() <= labels.len());
        let found: Vec<&str> = ticks.iter().map(|tick| tick.label.as_str()).collect();
        assert_eq!(found, labels);
    }

    #[test]
    fn labels_have_the_digits_that_the_window_needs() {
        let five = ["0.2000", "0.2001", "0.2002", "0.2003", "0.2004"];
        check(scale(0.2, 0.2004), &five);
        check(scale(0.2, 0.2004), &["0.2000", "0.2002", "0.2004"]);
        check(scale(0.0, 1.0), &["0.0", "0.5", "1.0"]);
        check(scale(-1.0, 2.0), &["−1", "0", "1", "2"]);
        check(scale(-0.3, 0.31), &["−0.2", "0.0", "0.2"]);
        check(scale(1e6, 1e6 + 1e-4), &["1000000.0000", "1000000.0001"]);
    }

    #[test]
    fn powers_of_ten_stand_where_they_are_shorter() {
        check(scale(0.0, 100_000.0), &["0", "50000", "100000"]);
        check(scale(0.0, 1e6), &["0", "0.5·10^{6}", "1.0·10^{6}"]);
        check(scale(-3e-7, 3e-7), &["−2·10^{−7}", "0", "2·10^{−7}"]);
        check(scale(1e-299, 2e-299), &["1·10^{−299}", "2·10^{−299}"]);
        check(scale(-1e300, 1e300), &["−1·10^{300}", "0", "1·10^{300}"]);
    }

    #[test]
    fn decades_are_whole() {
        let four = ["10^{−2}", "10^{−1}", "10^{0}", "10^{1}"];
        check(logarithmic(0.01, 10.0), &four);
        check(logarithmic(1e-7, 1.0), &["10^{−6}", "10^{−3}", "10^{0}"]);
        assert_eq!(logarithmic(0.9, 11.0).unlabelled().len(), 9);
        assert_eq!(logarithmic(1e-20, 1.0).unlabelled().len(), 21);
        assert!(scale(0.9, 11.0).unlabelled().is_empty());
    }

    #[test]
    fn what_counts_is_marked_at_whole_numbers() {
        for (high, wanted) in [
            (4.0, vec!["3", "4"]),
            (12.0, vec!["4", "6", "8", "10", "12"]),
        ] {
            let axis = Axis::new("").from(3.0, high).counting();
            let ticks = Scale::new(&axis, std::iter::empty()).ticks(|ticks| ticks.len() <= 6);
            let labels: Vec<_> = ticks.iter().map(|tick| tick.label.as_str()).collect();
            assert_eq!(labels, wanted);
        }
    }

    #[test]
    fn a_window_without_decades_has_ticks() {
        check(logarithmic(0.2, 5.0), &["0.2", "0.5", "1.0", "2.0", "5.0"]);
        check(logarithmic(2.0, 4.0), &["2", "3", "4"]);
        check(logarithmic(0.2, 0.2004), &["0.2000", "0.2002", "0.2004"]);
    }

    #[test]
    fn two_ticks_are_better_than_one() {
        let far = |pair: &[Tick]| pair[1].value - pair[0].value > 3.5;
        let ticks = scale(0.0, 4.0).ticks(|ticks| ticks.windows(2).all(far));
        assert_eq!([ticks[0].value, ticks[1].value], [0.0, 4.0]);
    }

    #[test]
    fn a_label_says_the_value_of_its_tick() {
        let mut random = fastrand::Rng::with_seed(14);
        for _ in 0..300 {
            let low = (random.f64() - 0.5) * 10_f64.powi(random.i32(-12..12));
            let width = 10_f64.powi(random.i32(-9..1)) * low.abs();
            let ticks = scale(low, low + width).ticks(|ticks| ticks.len() <= 7);
            assert!((2..=7).contains(&ticks.len()), "{low} {width}: {ticks:?}");
            for Tick { value, label } in ticks {
                let text = label.replace('−', "-").replace("·10^{", "e");
                assert_eq!(text.trim_end_matches('}').parse(), Ok(value));
            }
        }
    }
}
