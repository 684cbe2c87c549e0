//! What the page is about, for readers who have never seen the thesis.

use stickslip::report::Section;

/// The first section.
pub(super) fn section() -> Section {
    Section::new("What this page shows")
        .text(
            "A violin string under its bow, a squealing brake and a drill string in a deep well have one thing in \
             common: dry friction makes them vibrate by themselves. While two surfaces stick, a spring is loaded; when \
             the force in it exceeds what friction can hold, they slip, the spring unloads, and they stick again. Such \
             a *stick-slip* motion repeats itself: it is a periodic orbit, a closed curve in the plane of displacement \
             and velocity.",
        )
        .text(
            "Dry friction is hard on computers because it jumps. At rest the force takes any value up to a limit; as \
             soon as the surfaces slide it has one value, and its sign turns with the direction of sliding. In 1996 \
             B. L. van de Vrande, in a master's thesis at Eindhoven, replaced the jump by a steep but smooth curve, of \
             a steepness called *ε*, and let the finite-element program DIANA find periodic orbits by *shooting* (look \
             for a state and a period *T* after which the motion is back where it began) and by *path following* (change \
             one parameter a little, and shoot again from the orbit before). A periodic orbit is *stable* if all its \
             *Floquet multipliers*, the factors by which small disturbances grow in one period, are less than one in \
             modulus; one multiplier is always 1, for a disturbance along the orbit itself.",
        )
        .text(
            "This page repeats that work for the thesis's four systems, with the same smooth curves: its figures, under \
             its numbers, its values beside ours, and the cost of each branch. Beside the smooth copies it shows, in \
             black, what they approach: the motion with friction as it is, which sticks and jumps, and which the thesis \
             could only reach for a few motions. So every error of smoothing can be seen and measured. Every curve \
             comes from the models as declared, and lies beside the page as a table of numbers.",
        )
}
