//! The data of the animated page: what moves, how it looks, and the channels to plot beside it.
//!
//! Poses are those of the user's own body frames in ground axes; shapes, points and directions
//! are given in the frame of their body. Quaternions have the scalar first and map body
//! components to ground components. Planar machines lie in the plane z = 0.
//! The direction of a joint's end is the joint's axis: the z axis of its frame in space.

mod check;
mod error;
mod page;
mod parts;
mod rounded;
mod scene;
mod shape;
mod solid;

#[cfg(test)]
mod tests;

pub use error::AnimationError;
pub use page::{MARKER, html};
pub use parts::{
    AnimatedBody, AnimatedChannel, AnimatedTrace, Ground, Joint, JointEnd, Line, Load, Spring,
    SpringEnd,
};
pub use scene::{Animation, FORMAT};
pub use shape::{Form, Shape};
pub use solid::Solid;
