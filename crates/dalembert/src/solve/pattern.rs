//! Layout of the values on a pattern, and products with the Jacobian.

use super::kernel::{add_apply, add_apply_transposed, with_dof};
use super::shape::SaddleShape;

/// One block of the Jacobian: an element and one of its bodies that moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Incidence {
    /// The element of the block.
    pub element: usize,
    /// The body of the block.
    pub body: usize,
    /// First row of the element.
    pub row: usize,
    /// Rows of the element.
    pub rows: usize,
    /// Where the block starts in the Jacobian's values.
    pub jac: usize,
}

/// Where everything of a [`SaddleShape`] stands in the arrays of values.
///
/// Jacobian: for each element in order, for each of its bodies in order, a row-major `rows x dof` block.
/// Auxiliary Jacobian: for each element a row-major `rows x aux` block.
/// Multipliers and auxiliaries follow the order of the elements.
#[derive(Clone, Debug)]
pub struct Pattern {
    shape: SaddleShape,
    pub(super) incidences: Vec<Incidence>,
    block_start: Vec<usize>,
    row_start: Vec<usize>,
    aux_start: Vec<usize>,
    jac_aux_start: Vec<usize>,
}

impl Pattern {
    /// Lays out a pattern.
    pub fn new(shape: SaddleShape) -> Self {
        let mut pattern = Self {
            incidences: Vec::new(),
            block_start: vec![0],
            row_start: vec![0],
            aux_start: vec![0],
            jac_aux_start: vec![0],
            shape: SaddleShape::default(),
        };
        let (mut jac, mut row, mut aux, mut jac_aux) = (0, 0, 0, 0);
        for (number, element) in shape.elements.iter().enumerate() {
            for &body in &element.bodies {
                if body < shape.bodies {
                    pattern.incidences.push(Incidence {
                        element: number,
                        body,
                        row,
                        rows: element.rows,
                        jac,
                    });
                }
                jac += element.rows * shape.dof;
            }
            row += element.rows;
            aux += element.aux;
            jac_aux += element.rows * element.aux;
            pattern.block_start.push(jac);
            pattern.row_start.push(row);
            pattern.aux_start.push(aux);
            pattern.jac_aux_start.push(jac_aux);
        }
        pattern.shape = shape;
        pattern
    }

    /// The shape that was laid out.
    pub fn shape(&self) -> &SaddleShape {
        &self.shape
    }

    /// Number of velocity coordinates: bodies times coordinates of a body.
    pub fn coordinates(&self) -> usize {
        self.shape.bodies * self.shape.dof
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.shape.elements.len()
    }

    /// Number of constraint rows, which is the number of multipliers.
    pub fn rows(&self) -> usize {
        self.row_start[self.elements()]
    }

    /// Number of auxiliary unknowns.
    pub fn aux(&self) -> usize {
        self.aux_start[self.elements()]
    }

    /// Number of values of the Jacobian.
    pub fn jac_len(&self) -> usize {
        self.block_start[self.elements()]
    }

    /// Number of values of the auxiliary Jacobian.
    pub fn jac_aux_len(&self) -> usize {
        self.jac_aux_start[self.elements()]
    }

    /// Number of values of the mass matrix: one `dof x dof` block a body.
    pub fn mass_len(&self) -> usize {
        self.shape.bodies * self.shape.dof * self.shape.dof
    }

    /// Where the block of an element and one of its bodies starts in the Jacobian's values.
    pub fn jac_offset(&self, element: usize, body_slot: usize) -> usize {
        self.block_start[element] + body_slot * self.shape.elements[element].rows * self.shape.dof
    }

    /// Where the block of an element starts in the auxiliary Jacobian's values.
    pub fn jac_aux_offset(&self, element: usize) -> usize {
        self.jac_aux_start[element]
    }

    /// First row (and multiplier) of an element.
    pub fn row_offset(&self, element: usize) -> usize {
        self.row_start[element]
    }

    /// First auxiliary of an element.
    pub fn aux_offset(&self, element: usize) -> usize {
        self.aux_start[element]
    }

    /// Adds `J^T l` to `out`.
    pub fn jt_mul(&self, jac: &[f64], l: &[f64], out: &mut [f64]) {
        with_dof!(self.shape.dof, dof => {
            use super::kernel::Size;
            for block in &self.incidences {
                let body = block.body * dof.get();
                add_apply_transposed((block.rows, dof), 1.0, &mut out[body..], &jac[block.jac..], &l[block.row..]);
            }
        });
    }

    /// Sets `out` to `J v`.
    pub fn j_mul(&self, jac: &[f64], v: &[f64], out: &mut [f64]) {
        out[..self.rows()].fill(0.0);
        with_dof!(self.shape.dof, dof => {
            use super::kernel::Size;
            for block in &self.incidences {
                let body = block.body * dof.get();
                add_apply((block.rows, dof), 1.0, &mut out[block.row..], &jac[block.jac..], &v[body..]);
            }
        });
    }
}
