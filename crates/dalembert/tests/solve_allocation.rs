//! Factor and solve must not allocate: a counting allocator watches them.

use dalembert::solve::{ElementShape, Rhs, Saddle, SaddleShape};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

/// The system allocator, counting the calls of each thread.
struct Counting;

// SAFETY: every call is handed on unchanged to the system allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn allocations(run: impl FnOnce()) -> usize {
    let before = COUNT.with(Cell::get);
    run();
    COUNT.with(Cell::get) - before
}

/// A chain of bodies whose last joint is doubled, with auxiliaries in the first element.
fn shape(bodies: usize, dof: usize) -> SaddleShape {
    let mut elements: Vec<ElementShape> = (0..bodies)
        .map(|i| ElementShape {
            rows: 2,
            bodies: (i.saturating_sub(1)..=i).collect(),
            aux: usize::from(i == 0),
        })
        .collect();
    elements.push(elements[bodies - 1].clone());
    SaddleShape {
        bodies,
        dof,
        elements,
    }
}

#[test]
fn factor_and_solve_allocate_nothing() {
    for dof in [3, 6] {
        let bodies = 50;
        let mut saddle = Saddle::new(shape(bodies, dof));
        let mut identity = vec![0.0; bodies * dof * dof];
        for body in 0..bodies {
            for i in 0..dof {
                identity[body * dof * dof + i * (dof + 1)] = 1.0;
            }
        }
        let mut jac: Vec<f64> = (0..saddle.jac_len())
            .map(|i| (i as f64 * 1.7).sin())
            .collect();
        let (from, to) = (
            saddle.jac_offset(bodies - 1, 0),
            saddle.jac_offset(bodies, 0),
        );
        jac.copy_within(from..to, to);
        let jac_aux = vec![0.8, -0.3];
        let f = vec![1.0; bodies * dof];
        let g = vec![0.0; saddle.rows()];
        let (mut a, mut l, mut s) = (vec![0.0; f.len()], vec![0.0; g.len()], vec![0.0; 1]);
        let count = allocations(|| {
            let vanished = saddle.factor(&identity, &jac, &jac_aux).vanished.len();
            assert_eq!(vanished, 2);
            let residual = saddle.solve(
                &identity,
                Rhs {
                    f: &f,
                    g: &g,
                    h: &[0.0],
                },
                &mut a,
                &mut l,
                &mut s,
            );
            assert!(residual.converged, "{residual:?}");
            assert!(residual.sweeps > 0);
        });
        assert_eq!(count, 0);
    }
}

#[test]
fn the_count_counts() {
    assert_eq!(allocations(|| drop(std::hint::black_box(Box::new(1)))), 1);
}
