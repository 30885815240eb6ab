//! Tables become functions of one variable.

use super::context::Context;
use crate::diagnostic::Diagnostic;
use crate::model::Interpolation;
use dalembert_expr::{Function, Quantity, Spline};
use std::sync::Arc;

impl Context<'_> {
    /// Resolves the tables; expressions then use them by name.
    pub fn tables(&mut self) {
        for (i, table) in self.model.tables.iter().enumerate() {
            let owner = format!("table '{}'", table.name);
            let path = format!("table[{i}]");
            if table.x.is_empty() || table.x.len() != table.y.len() {
                self.report(
                    Diagnostic::error(
                        "table-length",
                        &path,
                        format!(
                            "{owner}: x has {} values and y has {}",
                            table.x.len(),
                            table.y.len()
                        ),
                    )
                    .help("give as many y as x"),
                );
                self.stand_in_table(&table.name);
                continue;
            }
            let mut read = |values: &[crate::model::Value], key: &str| -> Option<Vec<f64>> {
                let list: Vec<Option<f64>> = values
                    .iter()
                    .enumerate()
                    .map(|(k, v)| {
                        self.constant(v, Quantity::Free, &owner, &format!("{path}.{key}[{k}]"))
                    })
                    .collect();
                list.into_iter().collect()
            };
            let (Some(x), Some(y)) = (read(&table.x, "x"), read(&table.y, "y")) else {
                self.stand_in_table(&table.name);
                continue;
            };
            let spline = match table.interpolation {
                Interpolation::Cubic => Spline::cubic(&x, &y, table.periodic),
                Interpolation::Quintic => Spline::quintic(&x, &y, table.periodic),
                Interpolation::Linear => Spline::linear(&x, &y, table.periodic),
            };
            match spline {
                Ok(spline) => {
                    self.functions.insert(table.name.clone(), Arc::new(spline));
                }
                Err(error) => {
                    self.report(
                        Diagnostic::error("bad-table", &path, format!("{owner}: {error}"))
                            .help("check the points of the table"),
                    );
                    self.stand_in_table(&table.name);
                }
            }
        }
    }

    fn stand_in_table(&mut self, name: &str) {
        self.stand_ins = true;
        self.functions.insert(name.to_owned(), Arc::new(Spoilt));
    }
}

/// Stands in for a table with mistakes, so that they are not reported again at every use.
#[derive(Debug)]
struct Spoilt;

impl Function for Spoilt {
    fn jet(&self, _x: f64) -> [f64; 4] {
        [f64::NAN; 4]
    }

    fn dims(&self) -> (Quantity, Quantity) {
        (Quantity::Free, Quantity::Free)
    }
}
