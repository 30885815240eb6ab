//! Results that others published, or that follow from closed forms, against what the program answers.
//!
//! Every case is a model file in `cases/`, which also serves as an example, and a list of values at
//! given instants. Sources are named at each case.

mod published {
    pub mod harness;
    mod in_space;

    mod adams_joints;
    mod benchmarks;
    mod mobility;
    mod modelica;
    mod own_machines;
    mod puma;
    mod shabana_dynamics;
    mod shabana_equations;
    mod shabana_four_bar;
    mod shabana_inverse;
    mod shabana_kinematics;
    mod shabana_recursion;
    mod shabana_slider_crank;
    mod shabana_space;
    mod space_benchmarks;
    mod statics;
    mod textbook_kinematics;
}
