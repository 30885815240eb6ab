//! Tables become functions of one variable.

use super::context::Context;
use super::geometry::Geometry;
use crate::diagnostic::Diagnostic;
use crate::model::{Interpolation, Table, Value};
use crate::words::counted;
use dalembert_expr::{Function, Quantity, Spline, Unit};
use std::sync::Arc;

/// The arguments or the values of a table, in SI.
struct Column {
    numbers: Vec<f64>,
    quantity: Quantity,
}

impl<S: Geometry> Context<'_, S> {
    /// Resolves the tables; expressions then use them by name.
    pub fn tables(&mut self) {
        let model = self.model;
        for (i, table) in model.tables.iter().enumerate() {
            let owner = format!("table '{}'", table.name);
            let path = format!("table[{i}]");
            self.check_name(&table.name, &owner, &format!("{path}.name"));
            if self.functions.contains_key(&table.name) {
                let message = format!("{owner}: there is another table of this name");
                self.report(
                    Diagnostic::error("duplicate-name", format!("{path}.name"), message)
                        .help("choose another name"),
                );
            }
            let function: Arc<dyn Function> = match self.spline(table, &owner, &path) {
                Some(spline) => Arc::new(spline),
                None => {
                    self.stand_ins = true;
                    Arc::new(Spoilt)
                }
            };
            self.functions.insert(table.name.clone(), function);
        }
    }

    fn spline(&mut self, table: &Table, owner: &str, path: &str) -> Option<Spline> {
        if table.x.is_empty() || table.x.len() != table.y.len() {
            let (x, y) = (table.x.len(), table.y.len());
            self.report(
                Diagnostic::error(
                    "table-length",
                    path,
                    format!("{owner}: x has {} and y has {y}", counted(x, "value")),
                )
                .help("give as many y as x"),
            );
            return None;
        }
        let (x, y) = match table.file {
            Some(_) => (
                self.file_column(&table.x, table.x_unit.as_deref(), "x", owner, path),
                self.file_column(&table.y, table.y_unit.as_deref(), "y", owner, path),
            ),
            None => (
                self.column(&table.x, "x", owner, path),
                self.column(&table.y, "y", owner, path),
            ),
        };
        let (x, y) = (x?, y?);
        let fit = match table.interpolation {
            Interpolation::Cubic => Spline::cubic,
            Interpolation::Quintic => Spline::quintic,
            Interpolation::Linear => Spline::linear,
        };
        match fit(&x.numbers, &y.numbers, table.periodic) {
            Ok(spline) => Some(spline.with_dims(x.quantity, y.quantity)),
            Err(error) => {
                self.report(
                    Diagnostic::error("bad-table", path, format!("{owner}: {error}"))
                        .help("check the points of the table"),
                );
                None
            }
        }
    }

    /// Numbers and expressions with units, which must be of one dimension. A number without a
    /// unit, such as 0, goes with any.
    fn column(&mut self, values: &[Value], key: &str, owner: &str, path: &str) -> Option<Column> {
        let mut known: Option<(usize, Quantity)> = None;
        let mut likely = Quantity::Free;
        let mut numbers = Vec::with_capacity(values.len());
        let mut usable = true;
        for (k, value) in values.iter().enumerate() {
            let path = format!("{path}.{key}[{k}]");
            let Some((number, quantity)) = self.measured(value, Quantity::Free, owner, &path)
            else {
                usable = false;
                continue;
            };
            numbers.push(number);
            if quantity.known().is_none() {
                likely = quantity;
                continue;
            }
            let (first, wanted) = *known.get_or_insert((k, quantity));
            if quantity != wanted {
                usable = false;
                let (found, wanted) = (quantity.describe(), wanted.describe());
                let message =
                    format!("{owner}: {key}[{k}] is {found}, but {key}[{first}] is {wanted}");
                self.report(
                    Diagnostic::error("unit-mismatch", path, message)
                        .help(format!("give all {key} units of one kind")),
                );
            }
        }
        let quantity = known.map_or(likely, |(_, quantity)| quantity);
        usable.then_some(Column { numbers, quantity })
    }

    /// Numbers with the unit of their column. The model's parameters do not reach into a file: a
    /// parameter of the name of a unit changes nothing there.
    fn file_column(
        &mut self,
        values: &[Value],
        unit: Option<&str>,
        key: &str,
        owner: &str,
        path: &str,
    ) -> Option<Column> {
        let unit = unit.map(|unit| self.unit(unit, key, owner, path));
        // A unit that is wrong is reported once, not at every number.
        let quantity = match unit {
            Some(unit) => Quantity::Known(unit?.dim()),
            None => Quantity::Free,
        };
        let mut numbers = Vec::with_capacity(values.len());
        for (k, value) in values.iter().enumerate() {
            let path = format!("{path}.{key}[{k}]");
            let number = match value {
                Value::Number(number) => *number,
                Value::Text(text) => match dalembert_expr::parse_quantity(text, quantity) {
                    Ok(number) => number,
                    Err(errors) => {
                        self.report_expression(owner, &path, errors);
                        return None;
                    }
                },
            };
            numbers.push(self.constant(&Value::Number(number), quantity, owner, &path)?);
        }
        Some(Column { numbers, quantity })
    }

    fn unit(&mut self, text: &str, key: &str, owner: &str, path: &str) -> Option<Unit> {
        match dalembert_expr::parse_unit(text) {
            Ok(unit) => Some(unit),
            Err(errors) => {
                self.report_expression(owner, &format!("{path}.{key}_unit"), errors);
                None
            }
        }
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
