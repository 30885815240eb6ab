//! The whole animation, and the check that it hangs together.

use super::check::{finite, list};
use super::{
    AnimatedBody, AnimatedChannel, AnimatedTrace, AnimationError, Form, Ground, Joint, Load, Shape,
    Spring, rounded,
};
use serde::{Deserialize, Serialize};

/// Format tag of the data.
pub const FORMAT: &str = "dalembert-animation/1";

/// Everything that the viewer page shows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Animation {
    /// Format tag, [`FORMAT`].
    pub format: String,
    /// Title of the page: the model's name.
    pub title: String,
    /// "planar" or "spatial".
    pub space: String,
    /// Direction in ground axes that the picture of a spatial machine shows upwards: against
    /// gravity; `None` is z.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        serialize_with = "rounded::optional"
    )]
    pub up: Option<[f64; 3]>,
    /// Name of the analysis.
    pub analysis: String,
    /// Instants of the frames (s).
    #[serde(serialize_with = "rounded::slice")]
    pub time: Vec<f64>,
    /// Moving bodies.
    pub bodies: Vec<AnimatedBody>,
    /// What stands still.
    pub ground: Ground,
    /// Joints.
    pub joints: Vec<Joint>,
    /// Springs, dampers and their like between two points.
    pub springs: Vec<Spring>,
    /// Elements that push a body at a point.
    #[serde(default)]
    pub loads: Vec<Load>,
    /// Points whose paths are drawn.
    pub traces: Vec<AnimatedTrace>,
    /// Channels to plot, one value a frame.
    pub channels: Vec<AnimatedChannel>,
    /// Messages for people.
    pub notes: Vec<String>,
    /// Rows of a small table: heading and value.
    pub summary: Vec<(String, String)>,
}

impl Default for Animation {
    fn default() -> Self {
        Self {
            format: FORMAT.to_owned(),
            title: String::new(),
            space: "planar".to_owned(),
            up: None,
            analysis: String::new(),
            time: Vec::new(),
            bodies: Vec::new(),
            ground: Ground::default(),
            joints: Vec::new(),
            springs: Vec::new(),
            loads: Vec::new(),
            traces: Vec::new(),
            channels: Vec::new(),
            notes: Vec::new(),
            summary: Vec::new(),
        }
    }
}

impl Animation {
    /// The data as JSON; numbers keep seven significant digits.
    ///
    /// Refuses lengths that do not fit the number of instants, bodies that do not exist and
    /// numbers that are not finite.
    pub fn to_json(&self) -> Result<String, AnimationError> {
        self.check()?;
        Ok(serde_json::to_string(self)?)
    }

    /// Checks lengths, references and numbers.
    pub fn check(&self) -> Result<(), AnimationError> {
        let n = self.time.len();
        if let Some(up) = &self.up {
            direction("animation", "up", up)?;
        }
        list("time", "values", &self.time, n)?;
        for body in &self.bodies {
            list(&body.name, "position", &body.position, 3 * n)?;
            list(&body.name, "quaternion", &body.quaternion, 4 * n)?;
            shapes(&body.name, &body.shapes)?;
        }
        shapes("ground", &self.ground.shapes)?;
        for channel in &self.channels {
            list(&channel.name, "values", &channel.values, n)?;
        }
        for joint in &self.joints {
            for end in [&joint.first, &joint.second] {
                self.body_exists(&joint.name, &end.body)?;
                finite(&joint.name, "at", &end.at)?;
                finite(&joint.name, "outline", end.outline.as_flattened())?;
                finite(
                    &joint.name,
                    "direction",
                    end.direction.as_ref().map_or(&[], |d| d),
                )?;
                finite(
                    &joint.name,
                    "reference",
                    end.reference.as_ref().map_or(&[], |d| d),
                )?;
            }
        }
        for spring in &self.springs {
            for end in [&spring.first, &spring.second] {
                self.body_exists(&spring.name, &end.body)?;
                finite(&spring.name, "at", &end.at)?;
            }
        }
        for load in &self.loads {
            self.body_exists(&load.name, &load.on.body)?;
            finite(&load.name, "at", &load.on.at)?;
            if let Some(along) = &load.along {
                self.body_exists(&load.name, &along.body)?;
                direction(&load.name, "direction", &along.direction)?;
            }
        }
        for trace in &self.traces {
            self.body_exists(&trace.name, &trace.body)?;
            finite(&trace.name, "at", &trace.at)?;
        }
        Ok(())
    }

    fn body_exists(&self, element: &str, body: &str) -> Result<(), AnimationError> {
        if body == "ground" || self.bodies.iter().any(|b| b.name == body) {
            Ok(())
        } else {
            Err(AnimationError::UnknownBody {
                element: element.to_owned(),
                body: body.to_owned(),
            })
        }
    }
}

fn direction(element: &str, field: &'static str, vector: &[f64; 3]) -> Result<(), AnimationError> {
    finite(element, field, vector)?;
    if vector.iter().any(|v| *v != 0.0) {
        return Ok(());
    }
    Err(AnimationError::NoDirection {
        element: element.to_owned(),
        field,
    })
}

fn shapes(element: &str, shapes: &[Shape]) -> Result<(), AnimationError> {
    for shape in shapes {
        finite(element, "shape position", &shape.position)?;
        finite(element, "shape quaternion", &shape.quaternion)?;
        match &shape.form {
            Form::Bar { length, width } => finite(element, "bar", &[*length, *width]),
            Form::Rectangle { width, height } => finite(element, "rectangle", &[*width, *height]),
            Form::Circle { radius } => finite(element, "circle", &[*radius]),
            Form::Ring { outer, inner } => finite(element, "ring", &[*outer, *inner]),
            Form::Polygon { points } => finite(element, "polygon", points.as_flattened()),
            Form::Lump => Ok(()),
            Form::Solid(solid) => solid.check(element),
        }?;
    }
    Ok(())
}
