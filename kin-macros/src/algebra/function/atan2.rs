//! atan2(y, x): the derivatives are x / (x² + y²) by y and -y / (x² + y²) by x.

use super::Elementary;

pub(super) const ATAN2: Elementary = Elementary {
    name: "atan2",
    arity: 2,
    value: |v| v[0].atan2(v[1]),
    domain: |v| super::everywhere(v) && (v[0] != 0.0 || v[1] != 0.0),
    partials: |graph, v, _| {
        let (y, x) = (v[0], v[1]);
        let (y2, x2) = (graph.power(y, 2), graph.power(x, 2));
        let square = graph.add(x2, y2);
        let by_y = graph.divide(x, square);
        let by_x = graph.divide(y, square);
        vec![by_y, graph.negate(by_x)]
    },
};
