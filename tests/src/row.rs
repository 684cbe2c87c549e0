//! Three contacts in a row, which come to rest and let go in many orders.

use stickslip::model;
use stickslip_models::friction::Weakening;

model! {
    /// Three masses in a row between walls, each rubbing on one belt: nondimensional.
    pub struct Row {
        state x[3] = 0.1;
        state v[3] = 0.0;
        param k = 1.3 where k > 0.0;
        param v_dr = 0.2;
        param limit = 0.4 where limit >= 0.0;
        param decay = 2.0 where decay >= 0.0;
        param second = 1.1 where second > 0.0;
        param third = 1.3 where third > 0.0;
        friction F[0] = Weakening { limit, decay } opposing v[0] - v_dr;
        friction F[1] = Weakening { limit: limit * second, decay } opposing v[1] - v_dr;
        friction F[2] = Weakening { limit: limit * third, decay } opposing v[2] - v_dr;
        for i in 0..3 {
            der(x[i]) = v[i];
        }
        der(v[0]) = F[0] - k * (2 * x[0] - x[1]);
        der(v[1]) = F[1] - k * (2 * x[1] - x[0] - x[2]);
        der(v[2]) = F[2] - k * (2 * x[2] - x[1]);
    }
}
