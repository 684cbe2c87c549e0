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
    #[error(
        "the size of a smoothing must be a finite number above 0, and `{word}` is not: write for instance `{kernel}:{example}`"
    )]
    BadSize {
        /// The kernel.
        kernel: Kernel,
        /// The word given for the size.
        word: String,
        /// A usual size.
        example: &'static str,
    },
    /// A sign-type kernel would drop the static peak of a law.
    #[error(
        "`{kernel}` would drop the static peak of `{law}`{}: its limit at rest is {stick}, but sliding \
         starts at {slip}, and the copy would converge to a law with the limit {slip}; use `quartic`, which keeps the peak",
        place(contact)
    )]
    DropsPeak {
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
    /// A bump has nothing to stand on.
    #[error(
        "`{kernel}` smooths a static peak, and `{law}`{} has none (limit at rest {stick}, sliding starts \
         at {slip}): the copy would never stick; use a sign type such as `arctan` or `cubic`",
        place(contact)
    )]
    NoPeak {
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
        let (kernel, name) = (self, L::INFO.name);
        let (stick, slip) = (law.stick(), law.slip(0.0));
        let peak = stick - slip > 1e-12 * stick;
        if stick <= 0.0 || peak == kernel.is_bump() {
            return Ok(());
        }
        Err(if peak {
            SmoothingError::DropsPeak {
                kernel,
                law: name,
                contact,
                stick,
                slip,
            }
        } else {
            SmoothingError::NoPeak {
                kernel,
                law: name,
                contact,
                stick,
                slip,
            }
        })
    }
}
