//! The same questions asked of every reference system.

pub mod bisected;
pub mod branches;
pub mod chain;
pub mod exact;
pub mod hand_written;
pub mod lanes;
pub mod random;
pub mod range;
pub mod rotating;
pub mod row;
pub mod subject;
pub mod transformed;

/// Asks each question, a function of a [`subject::Subject`], of all four reference systems: one test for each.
#[macro_export]
macro_rules! on_every_reference_system {
    ($($question:ident),* $(,)?) => {$(
        mod $question {
            use stickslip_tests::subject;

            #[test]
            fn van_der_pol() {
                super::$question(&subject::van_der_pol());
            }

            #[test]
            fn belt_oscillator() {
                super::$question(&subject::belt_oscillator());
            }

            #[test]
            fn belt_pair() {
                super::$question(&subject::belt_pair());
            }

            #[test]
            fn drill_string() {
                super::$question(&subject::drill_string());
            }
        }
    )*};
}
