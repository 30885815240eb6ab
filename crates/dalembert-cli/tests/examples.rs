//! The example gallery: every model in `examples/`, run through the program, against closed forms and
//! published digits.

mod examples {
    mod arms;
    mod cams;
    mod free_motion;
    mod gallery;
    mod gears;
    mod geometry;
    mod linkages;
    mod mobility;
    mod power;
    mod rolling;
    mod run;
    mod space;
    mod space_arms;
    mod space_couplings;
    mod space_linkages;
    mod space_shafts;
    mod space_tops;
    mod statics;
    mod straight_lines;
}
