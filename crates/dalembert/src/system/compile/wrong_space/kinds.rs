//! Which kinds of joints and shapes belong to one space only, and what the other has instead.

use crate::model::{
    JointKind, ShapeKind,
    SpaceKind::{self, Planar, Spatial},
};

/// A kind that belongs to one space.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kind {
    /// Its word in a model file.
    pub word: &'static str,
    /// The space that has it.
    pub space: SpaceKind,
    /// What to do in the other space.
    pub remedy: &'static str,
}

const fn planar(word: &'static str, remedy: &'static str) -> Option<Kind> {
    Some(Kind {
        word,
        space: Planar,
        remedy,
    })
}

const fn spatial(word: &'static str, remedy: &'static str) -> Option<Kind> {
    Some(Kind {
        word,
        space: Spatial,
        remedy,
    })
}

/// What is special in a kind of joint; none where both spaces have it.
pub(super) fn of_joint(kind: &JointKind) -> Option<Kind> {
    match kind {
        JointKind::Revolute { .. }
        | JointKind::Prismatic { .. }
        | JointKind::Weld { .. }
        | JointKind::Distance { .. } => None,
        JointKind::PinSlot { .. } => planar(
            "pin-slot",
            "in space `point-on-line` keeps a point on a line, and `cylindrical` turns and slides",
        ),
        JointKind::Gear { .. } => planar(
            "gear",
            "in space write a `gear-pair` of the two joints on which the gears turn",
        ),
        JointKind::Rack { .. } => planar(
            "rack",
            "in space write a `rack-pair` of the joint of the pinion and the joint of the rack",
        ),
        JointKind::Cam { .. } => planar(
            "cam",
            "in space `point-on-curve` keeps a point on a curve of another body",
        ),
        JointKind::RollingOnLine { .. } => planar(
            "rolling-on-line",
            "in space a `rack-pair` couples the displacement of one joint with the angle of another",
        ),
        JointKind::RollingOnCircle { .. } => planar(
            "rolling-on-circle",
            "in space a `gear-pair` couples the angles of two joints",
        ),
        JointKind::Spherical { .. } => spatial(
            "spherical",
            "in the plane `revolute` holds two points together",
        ),
        JointKind::Cylindrical { .. } => {
            spatial("cylindrical", "in the plane `pin-slot` turns and slides")
        }
        JointKind::Universal { .. } => spatial(
            "universal",
            "in the plane `revolute` holds two points together",
        ),
        JointKind::ConstantVelocity { .. } => spatial(
            "constant-velocity",
            "in the plane `revolute` holds two points together",
        ),
        JointKind::Screw { .. } => spatial(
            "screw",
            "in the plane a constraint of kind `coupler` couples an angle with a displacement",
        ),
        JointKind::Planar { .. } => spatial(
            "planar",
            "all bodies of a planar model move in its plane: leave the joint out",
        ),
        JointKind::PointOnLine { .. } => spatial(
            "point-on-line",
            "in the plane `pin-slot` keeps a point on a line",
        ),
        JointKind::PointOnPlane { .. } => spatial(
            "point-on-plane",
            "in the plane `pin-slot` keeps a point on a line",
        ),
        JointKind::PointOnCurve { .. } => spatial(
            "point-on-curve",
            "in the plane `cam` with a `knife-edge` keeps a point on a curve",
        ),
        JointKind::ParallelAxes { .. } => spatial(
            "parallel-axes",
            "in the plane a constraint of kind `fixed` keeps a `relative-angle`",
        ),
        JointKind::PerpendicularAxes { .. } => spatial(
            "perpendicular-axes",
            "in the plane a constraint of kind `fixed` keeps a `relative-angle`",
        ),
        JointKind::RollingDisc { .. } => {
            spatial("rolling-disc", "in the plane write `rolling-on-line`")
        }
        JointKind::RollingBall { .. } => {
            spatial("rolling-ball", "in the plane write `rolling-on-line`")
        }
        JointKind::SurfaceContact { .. } => {
            spatial("surface-contact", "in the plane write a `cam`")
        }
        JointKind::PointOnSurface { .. } => spatial(
            "point-on-surface",
            "in the plane write a `cam` with a knife edge",
        ),
        JointKind::KnifeEdge { .. } => spatial(
            "knife-edge",
            "in the plane write a constraint of kind `velocity`",
        ),
        JointKind::GearPair { .. } => {
            spatial("gear-pair", "in the plane write a `gear` of the two bodies")
        }
        JointKind::RackPair { .. } => {
            spatial("rack-pair", "in the plane write a `rack` of the two bodies")
        }
    }
}

/// What is special in a kind of shape; none where both spaces have it.
pub(super) fn of_shape(kind: &ShapeKind) -> Option<Kind> {
    let picture = "planar shapes are `bar`, `rectangle`, `circle`, `ring`, `polygon` and `lump`";
    match kind {
        ShapeKind::Lump { .. } => None,
        ShapeKind::Bar { .. } => planar("bar", "in space write a `rod`, a `cylinder` or a `box`"),
        ShapeKind::Rectangle { .. } => planar("rectangle", "in space write a `plate` or a `box`"),
        ShapeKind::Circle { .. } => planar(
            "circle",
            "in space write a `disk`, a `cylinder` or a `sphere`",
        ),
        ShapeKind::Ring { .. } => planar("ring", "in space write a `tube`"),
        ShapeKind::Polygon { .. } => planar("polygon", "in space write a `mesh`"),
        ShapeKind::Box { .. } => spatial("box", "in the plane write a `rectangle`"),
        ShapeKind::Cylinder { .. } => {
            spatial("cylinder", "in the plane write a `circle` or a `rectangle`")
        }
        ShapeKind::Tube { .. } => spatial("tube", "in the plane write a `ring`"),
        ShapeKind::Sphere { .. } => spatial("sphere", "in the plane write a `circle`"),
        ShapeKind::Shell { .. } => spatial("shell", "in the plane write a `ring`"),
        ShapeKind::Hemisphere { .. } => spatial("hemisphere", picture),
        ShapeKind::Cone { .. } => spatial("cone", "in the plane write a `polygon`"),
        ShapeKind::Rod { .. } => spatial("rod", "in the plane write a `bar`"),
        ShapeKind::Disk { .. } => spatial("disk", "in the plane write a `circle`"),
        ShapeKind::Plate { .. } => spatial("plate", "in the plane write a `rectangle`"),
        ShapeKind::Ellipsoid { .. } => spatial("ellipsoid", picture),
        ShapeKind::Mesh { .. } => spatial("mesh", "in the plane write a `polygon`"),
        ShapeKind::Torus { .. } => spatial("torus", "in the plane write a `ring`"),
    }
}
