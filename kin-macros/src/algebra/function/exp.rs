//! exp x: the derivative is exp x itself.

use super::Elementary;

pub(super) const EXP: Elementary = Elementary {
    name: "exp",
    arity: 1,
    value: |x| x[0].exp(),
    domain: super::everywhere,
    partials: |_, _, value| vec![value],
};
