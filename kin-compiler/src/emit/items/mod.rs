//! The generated items, one file each.

pub(super) mod assembly;
pub(super) mod batch;
mod closure;
pub(super) mod description;
mod documentation;
pub(super) mod every;
mod forms;
pub(super) mod formulas;
pub(super) mod interface;
pub(super) mod internal;
mod jacobian;
pub(super) mod outputs;
pub(super) mod page;
pub(super) mod picture;
pub(super) mod poses;
pub(super) mod position;
pub(super) mod prepared;
mod rates;
pub(super) mod readable;
pub(super) mod residuals;
pub(super) mod sensitivities;
pub(super) mod solve;
pub(super) mod stored;
pub(super) mod test;
pub(super) mod track;
pub(super) mod transmission;
pub(super) mod values;
