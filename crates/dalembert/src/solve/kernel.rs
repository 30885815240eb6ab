//! Dense products of small row-major blocks, compiled for the sizes that mechanisms have.

/// A dimension that is known either to the compiler or only at run time.
pub(super) trait Size: Copy {
    /// The value of the dimension.
    fn get(self) -> usize;

    /// Lends an array of this length: on the stack where the size is known, else the start of `spare`.
    fn with_array<R>(self, spare: &mut [f64], run: impl FnOnce(&mut [f64]) -> R) -> R;
}

/// A dimension known to the compiler.
#[derive(Clone, Copy)]
pub(super) struct Fixed<const N: usize>;

impl<const N: usize> Size for Fixed<N> {
    #[inline(always)]
    fn get(self) -> usize {
        N
    }

    #[inline(always)]
    fn with_array<R>(self, _spare: &mut [f64], run: impl FnOnce(&mut [f64]) -> R) -> R {
        run(&mut [0.0; N])
    }
}

impl Size for usize {
    #[inline(always)]
    fn get(self) -> usize {
        self
    }

    #[inline(always)]
    fn with_array<R>(self, spare: &mut [f64], run: impl FnOnce(&mut [f64]) -> R) -> R {
        run(&mut spare[..self])
    }
}

/// Calls a generic function with the size as a constant where it is a common one.
macro_rules! with_size {
    ($n:expr, $size:ident => $body:expr) => {
        match $n {
            1 => {
                let $size = $crate::solve::kernel::Fixed::<1>;
                $body
            }
            2 => {
                let $size = $crate::solve::kernel::Fixed::<2>;
                $body
            }
            3 => {
                let $size = $crate::solve::kernel::Fixed::<3>;
                $body
            }
            4 => {
                let $size = $crate::solve::kernel::Fixed::<4>;
                $body
            }
            5 => {
                let $size = $crate::solve::kernel::Fixed::<5>;
                $body
            }
            6 => {
                let $size = $crate::solve::kernel::Fixed::<6>;
                $body
            }
            other => {
                let $size: usize = other;
                $body
            }
        }
    };
}

/// Calls a generic function with the coordinates of a body as a constant: 3 planar, 6 spatial.
macro_rules! with_dof {
    ($n:expr, $size:ident => $body:expr) => {
        match $n {
            3 => {
                let $size = $crate::solve::kernel::Fixed::<3>;
                $body
            }
            6 => {
                let $size = $crate::solve::kernel::Fixed::<6>;
                $body
            }
            other => {
                let $size: usize = other;
                $body
            }
        }
    };
}

pub(super) use with_dof;
pub(super) use with_size;

/// `c += sign a b^T` with `a` (m x k), `b` (n x k) and `c` (m x n), all row-major.
#[inline(always)]
fn product<M: Size, N: Size, K: Size>(
    (m, n, k): (M, N, K),
    sign: f64,
    c: &mut [f64],
    a: &[f64],
    b: &[f64],
) {
    let (m, n, k) = (m.get(), n.get(), k.get());
    let (c, a, b) = (&mut c[..m * n], &a[..m * k], &b[..n * k]);
    for i in 0..m {
        for j in 0..n {
            let mut sum = 0.0;
            for p in 0..k {
                sum += a[i * k + p] * b[j * k + p];
            }
            c[i * n + j] += sign * sum;
        }
    }
}

/// `c += sign a b^T`, unrolled where both sizes of `c` are one common number.
#[inline(always)]
pub(super) fn add_product<K: Size>(
    (m, n, k): (usize, usize, K),
    sign: f64,
    c: &mut [f64],
    a: &[f64],
    b: &[f64],
) {
    match (m, n) {
        (1, 1) => product((Fixed::<1>, Fixed::<1>, k), sign, c, a, b),
        (2, 2) => product((Fixed::<2>, Fixed::<2>, k), sign, c, a, b),
        (3, 3) => product((Fixed::<3>, Fixed::<3>, k), sign, c, a, b),
        (5, 5) => product((Fixed::<5>, Fixed::<5>, k), sign, c, a, b),
        _ => product((m, n, k), sign, c, a, b),
    }
}

/// `y += sign a x` with `a` (m x n) row-major.
#[inline(always)]
pub(super) fn add_apply<M: Size, N: Size>(
    (m, n): (M, N),
    sign: f64,
    y: &mut [f64],
    a: &[f64],
    x: &[f64],
) {
    let (m, n) = (m.get(), n.get());
    let (y, a, x) = (&mut y[..m], &a[..m * n], &x[..n]);
    for i in 0..m {
        let mut sum = 0.0;
        for j in 0..n {
            sum += a[i * n + j] * x[j];
        }
        y[i] += sign * sum;
    }
}

/// `y += sign a^T x` with `a` (m x n) row-major.
#[inline(always)]
pub(super) fn add_apply_transposed<M: Size, N: Size>(
    (m, n): (M, N),
    sign: f64,
    y: &mut [f64],
    a: &[f64],
    x: &[f64],
) {
    let (m, n) = (m.get(), n.get());
    let (y, a, x) = (&mut y[..n], &a[..m * n], &x[..m]);
    for i in 0..m {
        let factor = sign * x[i];
        for j in 0..n {
            y[j] += factor * a[i * n + j];
        }
    }
}
