//! Nothing is allocated in the step loop: a counting allocator watches it.

mod mechanisms;

use dalembert::analysis::{Assembly, Dynamics, Motion};
use dalembert::integrate::{Dopri5, Ode};
use dalembert::system::compile::compile;
use mechanisms::{moment, motor, slider_crank, spinning, spring};
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

#[test]
fn steps_allocate_nothing() {
    // With a rod that has mass, none, and so little that it is treated as if it had none.
    for (driven, rod) in [
        (false, 0.8),
        (true, 0.8),
        (false, 0.0),
        (true, 0.0),
        (false, 1e-12),
    ] {
        let mut model = slider_crank();
        model.bodies[1].mass = Some(rod.into());
        model.bodies[1].inertia = Some((rod * 0.35 * 0.35 / 12.0).into());
        if driven {
            model
                .drivers
                .push(motor("O", "30 deg + 20*t + 0.1*sin(5*t)"));
        } else {
            model.initial.push(spinning("O", 20.0));
        }
        model.forces.push(spring(
            "spring",
            ["ground", "slider"],
            [[0.8, 0.0], [0.0, 0.0]],
            200.0,
            2.0,
            0.3,
        ));
        // An expression of the state, so that user functions are in the loop too.
        model
            .forces
            .push(moment("brake", "crank", "-0.01 N*m*s * crank.omega"));
        let compiled = compile::<dalembert::space::Planar>(&model, &[]).expect("a valid model");
        let (state, _) = Assembly::default()
            .run(&compiled.system)
            .expect("it assembles");
        let system = compiled.system.running();
        let mut motion = Motion::new(&system, &Dynamics::new(&compiled.options));
        let mut y = state.q.clone();
        y.extend_from_slice(&state.v);
        y.push(0.0);
        assert_eq!(motion.dim(), y.len());
        let mut integrator =
            Dopri5::start(&mut motion, 0.0, &y, 1e-8, f64::INFINITY).expect("it starts");
        let mut out = y.clone();
        // The first step may still size something.
        integrator.step(&mut motion, 10.0).expect("a step");
        let before = COUNT.with(Cell::get);
        for _ in 0..200 {
            integrator.step(&mut motion, 10.0).expect("a step");
            integrator.interpolate(integrator.t, &mut out);
        }
        let allocated = COUNT.with(Cell::get) - before;
        assert_eq!(allocated, 0, "driven: {driven}, rod: {rod} kg");
        assert!(
            integrator.t > 0.1,
            "the steps are real: t = {}; driven: {driven}, rod: {rod} kg",
            integrator.t
        );
    }
}
