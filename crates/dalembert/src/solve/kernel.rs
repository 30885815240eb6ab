//! Dense products of small row-major blocks, compiled for the sizes that mechanisms have.

/// A dimension that is known either to the compiler or only at run time.
pub(super) trait Size: Copy {
    /// The value of the dimension.
    fn get(self) -> usize;
}

/// A dimension known to the compiler.
#[derive(Clone, Copy)]
pub(super) struct Fixed<const N: usize>;

impl<const N: usize> Size for Fixed<N> {
    #[inline(always)]
    fn get(self) -> usize {
        N
    }
}

impl Size for usize {
    #[inline(always)]
    fn get(self) -> usize {
        self
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

/// `c += sign a b^T`, with the common sizes unrolled.
#[inline]
pub(super) fn add_product(
    (m, n, k): (usize, usize, usize),
    sign: f64,
    c: &mut [f64],
    a: &[f64],
    b: &[f64],
) {
    macro_rules! fixed {
        ($m:literal, $n:literal, $k:literal) => {
            product((Fixed::<$m>, Fixed::<$n>, Fixed::<$k>), sign, c, a, b)
        };
    }
    match (m, n, k) {
        (1, 1, 1) => fixed!(1, 1, 1),
        (1, 1, 3) => fixed!(1, 1, 3),
        (1, 2, 3) => fixed!(1, 2, 3),
        (2, 1, 3) => fixed!(2, 1, 3),
        (2, 2, 2) => fixed!(2, 2, 2),
        (2, 2, 3) => fixed!(2, 2, 3),
        (3, 3, 3) => fixed!(3, 3, 3),
        (3, 3, 6) => fixed!(3, 3, 6),
        (5, 5, 5) => fixed!(5, 5, 5),
        (5, 5, 6) => fixed!(5, 5, 6),
        (6, 6, 6) => fixed!(6, 6, 6),
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
