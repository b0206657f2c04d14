//! JSON.

use serde_json::{Map, Value, json};

use super::Columns;

pub(super) fn text(selected: &Columns<'_>) -> String {
    let table = selected.table;
    let columns: Vec<Value> = selected
        .of(table.columns())
        .into_iter()
        .map(|column| {
            json!({
                "name": column.label.to_string(),
                "unit": column.unit.to_string(),
                "order": column.label.order,
                // NaN becomes null
                "values": column.values,
            })
        })
        .collect();
    let outcomes: Vec<&str> = table.rows().map(|row| super::outcome(row.outcome())).collect();
    let margins: Vec<Option<f64>> = (0..table.count()).map(|row| table.margin(row)).collect();
    let limits: Vec<Value> = table
        .limits()
        .iter()
        .map(|limit| {
            let names = selected
                .of(table.columns())
                .into_iter()
                .map(|column| column.label.to_string());
            let known = names
                .zip(selected.of(table.values_at(limit)))
                .filter(|(_, value)| !value.is_nan())
                .map(|(name, value)| (name, value.into()));
            json!({
                "at": limit.at,
                "kind": limit.kind.to_string(),
                "block": limit.block,
                "row": limit.row,
                "closes": if limit.closes_before { "before" } else { "behind" },
                "values": known.collect::<Map<String, Value>>(),
            })
        })
        .collect();
    json!({
        "variable": table.variable().label.to_string(),
        "columns": columns,
        "outcome": outcomes,
        "margin": margins,
        "limits": limits,
    })
    .to_string()
}
