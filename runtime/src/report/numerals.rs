//! Numbers as reports write them.

use std::time::Duration;

/// `value` with this many decimals, and a true minus sign.
///
/// ```
/// # use stickslip::report::numerals::decimals;
/// assert_eq!(decimals(-0.5, 2), "−0.50");
/// ```
#[must_use]
pub fn decimals(value: f64, count: usize) -> String {
    format!("{value:.count$}").replace('-', "−")
}

/// `value` as m × 10ⁿ in the markup of reports, m with this many decimals.
///
/// ```
/// # use stickslip::report::numerals::scientific;
/// assert_eq!(scientific(8.597e-4, 3), "8.597 × 10^{−4}");
/// ```
#[must_use]
pub fn scientific(value: f64, count: usize) -> String {
    let text = format!("{value:.count$e}").replace('-', "−");
    match text.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa} × 10^{{{exponent}}}"),
        None => text,
    }
}

/// `value` with this many significant digits.
///
/// ```
/// # use stickslip::report::numerals::significant;
/// assert_eq!(significant(0.0861, 2), "0.086");
/// assert_eq!(significant(11.02, 2), "11");
/// ```
#[must_use]
pub fn significant(value: f64, count: i32) -> String {
    let digits = count - 1 - value.abs().max(1e-300).log10().floor() as i32;
    decimals(value, digits.max(0) as usize)
}

/// `value` with five significant digits at most.
///
/// ```
/// # use stickslip::report::numerals::short;
/// assert_eq!(short(0.001_463_077), "0.0014631");
/// assert_eq!(short(15.0), "15");
/// ```
#[must_use]
pub fn short(value: f64) -> String {
    let text = significant(value, 5);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// 10 to this power, in the markup of reports.
///
/// ```
/// # use stickslip::report::numerals::power;
/// assert_eq!(power(-3), "10^{−3}");
/// assert_eq!(power(0), "1");
/// ```
#[must_use]
pub fn power(exponent: i32) -> String {
    if exponent == 0 {
        "1".to_owned()
    } else {
        format!("10^{{{exponent}}}").replace('-', "−")
    }
}

/// A count, its thousands set apart by thin spaces.
///
/// ```
/// # use stickslip::report::numerals::count;
/// assert_eq!(count(1_234_567), "1\u{202f}234\u{202f}567");
/// ```
#[must_use]
pub fn count(number: u64) -> String {
    let digits = number.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push('\u{202f}');
        }
        out.push(digit);
    }
    out
}

/// A duration in the unit that suits it.
///
/// ```
/// # use std::time::Duration;
/// # use stickslip::report::numerals::duration;
/// assert_eq!(duration(Duration::from_millis(1500)), "1.5 s");
/// assert_eq!(duration(Duration::from_micros(8)), "8 µs");
/// ```
#[must_use]
pub fn duration(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    if seconds >= 1.0 {
        format!("{seconds:.1} s")
    } else if seconds >= 0.01 {
        format!("{:.0} ms", 1e3 * seconds)
    } else if seconds >= 0.001 {
        format!("{:.1} ms", 1e3 * seconds)
    } else {
        format!("{:.0} µs", 1e6 * seconds)
    }
}
