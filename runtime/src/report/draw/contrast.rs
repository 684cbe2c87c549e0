//! How well colours stand out, for tests: by the formula of WCAG 2.

/// Luminance of a colour, `#0072B2`, as the eye weighs it.
pub(in crate::report) fn luminance(colour: &str) -> f64 {
    let channel = |i: usize| {
        let value = u8::from_str_radix(&colour[i..i + 2], 16).expect("a colour of six digits");
        let value = f64::from(value) / 255.0;
        if value <= 0.04045 {
            value / 12.92
        } else {
            ((value + 0.055) / 1.055).powf(2.4)
        }
    };
    0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5)
}

/// The contrast of two colours: from 1 to 21.
pub(in crate::report) fn contrast(one: &str, other: &str) -> f64 {
    let [dark, light] = match [one, other].map(luminance) {
        [a, b] if a <= b => [a, b],
        [a, b] => [b, a],
    };
    (light + 0.05) / (dark + 0.05)
}
