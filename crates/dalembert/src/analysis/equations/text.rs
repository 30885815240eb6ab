//! The report as readable text.

use super::number::short;
use super::report::EquationsReport;
use super::{EquationBasis, LabelledMatrix, LabelledVector, ReferenceFrame};
use std::fmt::Write;

/// Values below this part of the largest of their column (of their matrix) are rounding and written as zero.
const ROUNDING: f64 = 1e-14;
/// Widest line of a matrix before its columns are continued below.
const WIDTH: usize = 118;

impl EquationsReport {
    /// The report as text with aligned columns; numbers have six digits, zeros (and values that are only rounding) are points.
    pub fn to_text(&self) -> String {
        let mut out = String::new();
        // Writing to a String cannot fail.
        let _ = writeln!(
            out,
            "Equations of motion of {} at t = {} s",
            self.model,
            number(self.time)
        );
        let _ = writeln!(out, "M a + C_q^T lambda = Q_e + Q_v,  C_q a = Q_d");
        let coordinates = match (&self.orientation, self.frame) {
            (Some(set), ReferenceFrame::User) => {
                format!("origins of the body frames, ground axes; {set} of the body frames")
            }
            (Some(set), ReferenceFrame::Center) => {
                format!("centres of mass, ground axes; {set} of the bodies")
            }
            (None, frame) => match (frame, self.rates_are_velocities()) {
                (ReferenceFrame::User, true) =>
                    "origins and angles of the body frames, ground axes",
                (ReferenceFrame::Center, true) => "centres of mass and angles, ground axes",
                (ReferenceFrame::User, false) =>
                    "origins of the body frames, ground axes; turns about the axes of the body frames",
                (ReferenceFrame::Center, false) =>
                    "centres of mass, ground axes; turns about the axes of the bodies",
            }
            .to_owned(),
        };
        let _ = writeln!(out, "coordinates: {coordinates}");
        let mut columns = vec![
            ("q", Some(&self.positions)),
            ("v", Some(&self.velocities)),
            ("a", self.accelerations.as_ref()),
            ("Q_e", Some(&self.applied)),
            ("Q_v", Some(&self.centrifugal)),
            ("p = M v", Some(&self.momenta)),
        ];
        if !self.rates_are_velocities() {
            columns.remove(0);
            let positions = [("q", Some(&self.positions))];
            table(
                &mut out,
                "Positions (b0 to b3: Euler parameters)",
                &positions,
            );
        }
        table(&mut out, "Coordinates", &columns);
        columns = vec![
            ("C", Some(&self.residual)),
            ("C_t", Some(&self.time_derivative)),
            ("Q_d", Some(&self.qd)),
            ("lambda", self.multipliers.as_ref()),
        ];
        table(&mut out, "Constraints", &columns);
        matrix(&mut out, "Mass matrix M", &self.mass);
        matrix(&mut out, "Jacobian C_q", &self.jacobian);
        if let Some(x) = &self.independent {
            let how = match x.basis {
                EquationBasis::Absolute | EquationBasis::Partition => "independent coordinates",
                EquationBasis::Qr => "quasi-velocities by QR",
                EquationBasis::Svd => "quasi-velocities by singular values",
            };
            let _ = writeln!(
                out,
                "\nIn {how}: v = B u + g,  a = B u' + gamma,  Mbar u' = Qbar"
            );
            if x.basis == EquationBasis::Partition {
                let _ = writeln!(out, "  independent: {}", list(&x.force.rows));
                let _ = writeln!(out, "  dependent: {}", list(&x.dependent));
            }
            if let Some(condition) = x.condition {
                let _ = writeln!(
                    out,
                    "  condition of the dependent block: {}",
                    number(condition)
                );
            }
            columns = vec![
                ("u", Some(&x.velocities)),
                ("u'", x.accelerations.as_ref()),
                ("Qbar", Some(&x.force)),
                ("p = dT/du", Some(&x.momenta)),
            ];
            table(&mut out, "Independent velocities", &columns);
            matrix(&mut out, "Mbar = B^T M B", &x.mass);
            matrix(&mut out, "B", &x.motions);
            columns = vec![
                ("g", Some(&x.velocity_offset)),
                ("gamma", Some(&x.acceleration_offset)),
            ];
            table(&mut out, "Particular solutions", &columns);
        }
        self.scalar_text(&mut out);
        for note in &self.notes {
            let _ = writeln!(out, "note: {note}");
        }
        out
    }

    /// Are the velocities the rates of the positions, coordinate by coordinate?
    fn rates_are_velocities(&self) -> bool {
        self.positions.rows == self.velocities.rows
    }

    fn scalar_text(&self, out: &mut String) {
        let s = &self.scalars;
        let rows = [
            ("T", Some(s.kinetic), "kinetic energy [J]"),
            ("T2", s.kinetic_2, "of second degree in u [J]"),
            ("T1", s.kinetic_1, "of first degree in u [J]"),
            ("T0", s.kinetic_0, "of degree zero in u [J]"),
            (
                "V",
                Some(s.potential),
                "potential energy of gravity and springs [J]",
            ),
            ("T + V", Some(s.energy), "energy [J]"),
            ("L", Some(s.lagrangian), "Lagrangian T - V [J]"),
            ("H", Some(s.hamiltonian), "Hamiltonian p . u - L [J]"),
            ("S", s.gibbs_appel, "Gibbs-Appel function [N m/s^2]"),
        ];
        let _ = writeln!(out, "\nScalars");
        let rows: Vec<_> = rows
            .iter()
            .filter_map(|(name, value, meaning)| Some((name, number((*value)?), meaning)))
            .collect();
        let width = rows
            .iter()
            .map(|(_, value, _)| value.len())
            .max()
            .unwrap_or(0);
        for (name, value, meaning) in rows {
            let _ = writeln!(out, "  {name:<5}  {value:>width$}  {meaning}");
        }
        let _ = writeln!(out);
    }
}

/// A scalar that stands alone: zero is written as a digit.
fn number(x: f64) -> String {
    if x == 0.0 { "0".to_owned() } else { short(x) }
}

fn list(names: &[String]) -> String {
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| most.max(x.abs()))
}

fn visible(x: f64, least: f64) -> String {
    short(if x.abs() < least { 0.0 } else { x })
}

/// Vectors over the same rows side by side.
fn table(out: &mut String, title: &str, columns: &[(&str, Option<&LabelledVector>)]) {
    let columns: Vec<_> = columns
        .iter()
        .filter_map(|(name, v)| Some((*name, (*v)?)))
        .collect();
    let rows = columns.first().map_or(&[][..], |(_, v)| v.rows.as_slice());
    let names: Vec<String> = columns.iter().map(|(name, _)| (*name).to_owned()).collect();
    let least: Vec<f64> = columns
        .iter()
        .map(|(name, v)| match *name {
            // How small violations are is what a reader wants to know.
            "C" => 0.0,
            _ => ROUNDING * largest(&v.values),
        })
        .collect();
    let cell = |i: usize, j: usize| visible(columns[j].1.values[i], least[j]);
    grid(out, title, rows, &names, &cell);
}

fn matrix(out: &mut String, title: &str, m: &LabelledMatrix) {
    let least = ROUNDING * m.values.iter().map(|row| largest(row)).fold(0.0, f64::max);
    grid(out, title, &m.rows, &m.columns, &|i, j| {
        visible(m.values[i][j], least)
    });
}

/// Rows and columns with names, in blocks of columns that fit into a line.
fn grid(
    out: &mut String,
    title: &str,
    rows: &[String],
    columns: &[String],
    cell: &dyn Fn(usize, usize) -> String,
) {
    let _ = writeln!(out, "\n{title}");
    if rows.is_empty() || columns.is_empty() {
        let _ = writeln!(out, "  (none)");
        return;
    }
    let length = |text: &str| text.chars().count();
    let label = rows.iter().map(|row| length(row)).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns.len())
        .map(|j| {
            let cells = (0..rows.len()).map(|i| length(&cell(i, j)));
            cells.chain([length(&columns[j])]).max().unwrap_or(0)
        })
        .collect();
    let mut from = 0;
    while from < columns.len() {
        let mut to = from;
        let mut width = 2 + label;
        while to < columns.len() && (to == from || width + 2 + widths[to] <= WIDTH) {
            width += 2 + widths[to];
            to += 1;
        }
        let mut line = " ".repeat(2 + label);
        for j in from..to {
            let _ = write!(line, "  {:>1$}", columns[j], widths[j]);
        }
        let _ = writeln!(out, "{}", line.trim_end());
        for (i, row) in rows.iter().enumerate() {
            let _ = write!(out, "  {row:<label$}");
            for (j, width) in widths.iter().enumerate().take(to).skip(from) {
                let _ = write!(out, "  {:>width$}", cell(i, j));
            }
            let _ = writeln!(out);
        }
        from = to;
        if from < columns.len() {
            let _ = writeln!(out, "  ... continued");
        }
    }
}
