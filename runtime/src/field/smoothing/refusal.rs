//! Which smoothing a law accepts, and why not.

use super::Kernel;
use crate::friction::FrictionLaw;

/// Why a smoothing cannot be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SmoothingError {
    /// No kernel has this name.
    #[error(
        "there is no smoothing `{word}`: {}; write for instance `arctan:1e5`",
        Kernel::suggest(word)
    )]
    UnknownKernel {
        /// The word given.
        word: String,
    },
    /// The size is not a number, not finite, or not positive.
    #[error("{}: write for instance `{kernel}:{}`", bad_size(*.kernel, word), kernel.example())]
    BadSize {
        /// The kernel.
        kernel: Kernel,
        /// The word given for the size.
        word: String,
    },
    /// A press gives no way, and how much it gives back depends on the speed of approach.
    #[error(
        "`{press}` has no smooth copy: its restitution changes with the speed of approach ({slow} at 0.001, {fast} at \
         1000), and a copy keeps one number"
    )]
    Rebound {
        /// The force.
        press: &'static str,
        /// Restitution after a slow approach.
        slow: f64,
        /// The same after a fast one.
        fast: f64,
    },
    /// A sign type would drop the static peak of the law, or a bump has none to stand on.
    #[error("{}", unsuited(*.kernel, law, contact, *.stick, *.slip))]
    Unsuited {
        /// The kernel.
        kernel: Kernel,
        /// The law.
        law: &'static str,
        /// The contact, if it acts at one.
        contact: Option<&'static str>,
        /// Limit at rest.
        stick: f64,
        /// slip(0⁺).
        slip: f64,
    },
}

fn bad_size(kernel: Kernel, word: &str) -> String {
    if word.trim().is_empty() {
        return format!("the smoothing `{kernel}` has no size yet, which stands after a colon");
    }
    format!("the size of a smoothing must be a finite number above 0, and `{word}` is not")
}

fn unsuited(kernel: Kernel, law: &str, contact: &Option<&str>, stick: f64, slip: f64) -> String {
    let place = place(contact);
    if kernel.is_bump() {
        return format!(
            "`{kernel}` smooths a static peak, and `{law}`{place} has none (limit at rest {stick}, sliding starts \
             at {slip}): the copy would never stick; use a sign type such as `arctan` or `cubic`"
        );
    }
    format!(
        "`{kernel}` would drop the static peak of `{law}`{place}: its limit at rest is {stick}, but sliding \
         starts at {slip}, and the copy would converge to a law with the limit {slip}; use `quartic`, which keeps the peak"
    )
}

/// Where a law acts, after its name.
fn place(contact: &Option<&str>) -> String {
    contact.map_or_else(String::new, |name| format!(" at contact `{name}`"))
}

impl Kernel {
    /// Whether a copy of the law by this kernel tends to the law.
    ///
    /// # Errors
    /// A sign type would drop its static peak, or it has none for a bump.
    pub(crate) fn suits<L: FrictionLaw<f64>>(
        self,
        law: &L,
        contact: Option<&'static str>,
    ) -> Result<(), SmoothingError> {
        let (stick, slip) = (law.stick(), law.slip(0.0));
        let peak = stick - slip > 1e-12 * stick;
        if stick <= 0.0 || peak == self.is_bump() {
            return Ok(());
        }
        Err(SmoothingError::Unsuited {
            kernel: self,
            law: L::INFO.name,
            contact,
            stick,
            slip,
        })
    }
}
