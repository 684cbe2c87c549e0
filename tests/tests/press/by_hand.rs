//! A small event-driven run of squeal that shares no line with the library.

use crate::models::Squeal;

/// Steps of Dormand and Prince's fifth-order method.
const STEP: f64 = 2e-3;

type State = [f64; 4];

#[derive(Debug, Clone, Copy, PartialEq)]
enum Rub {
    Slips(f64),
    Sticks,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Press {
    Open,
    Closed,
    /// The force has fallen to zero before the gap has opened.
    Parted,
}

/// The equations in one mode, written by hand.
struct Run<'a> {
    model: &'a Squeal,
    press: Press,
    rub: Rub,
    state: State,
    time: f64,
}

impl Run<'_> {
    fn normal(&self, y: &State) -> f64 {
        self.model.k3 * y[1] + self.model.c3 * y[3]
    }

    /// The friction that would hold the mass on the belt.
    fn holding(&self, y: &State) -> f64 {
        self.model.a * y[0] + self.model.k12 * y[1] + self.model.c1 * y[2]
    }

    fn rate(&self, y: &State) -> State {
        let Squeal {
            a,
            b,
            k12,
            c1,
            c2,
            load,
            mu,
            ..
        } = *self.model;
        let normal = match self.press {
            Press::Closed => self.normal(y),
            Press::Open | Press::Parted => 0.0,
        };
        let friction = match self.rub {
            Rub::Slips(sign) => -sign * mu * normal,
            Rub::Sticks => self.holding(y),
        };
        [
            y[2],
            y[3],
            friction - a * y[0] - k12 * y[1] - c1 * y[2],
            load - normal - k12 * y[0] - b * y[1] - c2 * y[3],
        ]
    }

    fn stepped(&self, h: f64) -> State {
        const A: [&[f64]; 5] = [
            &[1.0 / 5.0],
            &[3.0 / 40.0, 9.0 / 40.0],
            &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
            &[
                19372.0 / 6561.0,
                -25360.0 / 2187.0,
                64448.0 / 6561.0,
                -212.0 / 729.0,
            ],
            &[
                9017.0 / 3168.0,
                -355.0 / 33.0,
                46732.0 / 5247.0,
                49.0 / 176.0,
                -5103.0 / 18656.0,
            ],
        ];
        const B: [f64; 6] = [
            35.0 / 384.0,
            0.0,
            500.0 / 1113.0,
            125.0 / 192.0,
            -2187.0 / 6784.0,
            11.0 / 84.0,
        ];
        let mut stages = vec![self.rate(&self.state)];
        let moved = |weights: &[f64], stages: &[State]| {
            std::array::from_fn(|i| {
                let sum: f64 = weights.iter().zip(stages).map(|(w, k)| w * k[i]).sum();
                self.state[i] + h * sum
            })
        };
        for weights in A {
            let state = moved(weights, &stages);
            stages.push(self.rate(&state));
        }
        moved(&B, &stages)
    }

    /// What is positive while the modes last: of the press, and of friction.
    fn guards(&self, y: &State) -> [f64; 2] {
        let press = match self.press {
            Press::Closed => self.normal(y),
            Press::Open => -y[1],
            Press::Parted => y[1].min(-self.normal(y)),
        };
        let rub = match self.rub {
            _ if self.press != Press::Closed => 1.0,
            Rub::Slips(sign) => sign * (y[2] - self.model.belt),
            Rub::Sticks => self.model.mu * self.normal(y) - self.holding(y).abs(),
        };
        [press, rub]
    }

    /// One step, shortened to the first event by bisection; the state and time at a fall of vx through zero, if there is one.
    fn step(&mut self) -> Option<(f64, State)> {
        let falls = |run: &Self, h: f64| run.guards(&run.stepped(h)).iter().any(|g| *g < 0.0);
        let mut length = STEP;
        let event = falls(self, STEP);
        if event {
            let mut low = 0.0;
            for _ in 0..60 {
                let middle = 0.5 * (low + length);
                if falls(self, middle) {
                    length = middle;
                } else {
                    low = middle;
                }
            }
        }
        let end = self.stepped(length);
        let mut section = None;
        if self.state[2] > 0.0 && end[2] <= 0.0 {
            let (mut low, mut high) = (0.0, length);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if self.stepped(middle)[2] > 0.0 {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            section = Some((self.time + high, self.stepped(high)));
        }
        let fallen = self.guards(&end).map(|g| g < 0.0);
        (self.state, self.time) = (end, self.time + length);
        if event {
            self.switch(fallen);
        }
        section
    }

    fn switch(&mut self, [press, rub]: [bool; 2]) {
        let way = if self.state[2] > self.model.belt {
            1.0
        } else {
            -1.0
        };
        if press {
            self.press = match self.press {
                Press::Closed if self.state[1] > 0.0 => Press::Parted,
                Press::Parted if self.state[1] > 0.0 => Press::Closed,
                Press::Closed | Press::Parted => Press::Open,
                Press::Open => Press::Closed,
            };
            self.rub = Rub::Slips(way);
        } else if rub {
            self.rub = match self.rub {
                Rub::Sticks => Rub::Slips(-self.holding(&self.state).signum()),
                Rub::Slips(sign) => {
                    self.state[2] = self.model.belt;
                    let holds =
                        self.holding(&self.state).abs() < self.model.mu * self.normal(&self.state);
                    if holds {
                        Rub::Sticks
                    } else {
                        Rub::Slips(-sign)
                    }
                }
            };
        }
    }
}

/// The period on which a run from rest settles, by the falls of vx through zero.
pub(crate) fn period(model: &Squeal) -> f64 {
    let mut run = Run {
        model,
        press: Press::Closed,
        rub: Rub::Slips(-1.0),
        state: [0.0, 0.5 * model.load, 0.01, 0.0],
        time: 0.0,
    };
    let mut falls: Vec<(f64, State)> = Vec::new();
    for _ in 0..600_000 {
        falls.extend(run.step());
    }
    let (end, last) = *falls.last().unwrap();
    let same =
        |(_, state): &&(f64, State)| state.iter().zip(&last).all(|(a, b)| (a - b).abs() < 1e-7);
    let (before, _) = falls.iter().rev().skip(1).find(same).expect("no cycle");
    end - before
}
