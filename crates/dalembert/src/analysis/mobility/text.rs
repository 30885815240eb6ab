//! The mobility report in words.

use super::{Dependence, FreeMotion, MobilityReport};
use crate::words::listed;
use std::fmt;

fn plural(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

fn block(f: &mut fmt::Formatter<'_>, title: &str, rows: &[Dependence]) -> fmt::Result {
    const MOST: usize = 20;
    if rows.is_empty() {
        return Ok(());
    }
    writeln!(f, "{title}")?;
    for row in rows.iter().take(MOST) {
        writeln!(f, "  {row}")?;
    }
    if rows.len() > MOST {
        writeln!(f, "  ... and {} more", rows.len() - MOST)?;
    }
    Ok(())
}

fn motions(f: &mut fmt::Formatter<'_>, name: &str, motions: &[FreeMotion]) -> fmt::Result {
    const MOST: usize = 12;
    for (k, motion) in motions.iter().take(MOST).enumerate() {
        writeln!(f, "  {name} {}: {motion}", k + 1)?;
    }
    if motions.len() > MOST {
        writeln!(f, "  ... and {} more", motions.len() - MOST)?;
    }
    Ok(())
}

impl fmt::Display for MobilityReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let m = &self.mobility;
        let auxiliaries = match self.auxiliaries {
            0 => String::new(),
            n => format!(
                " and {}",
                plural(n, "contact parameter", "contact parameters")
            ),
        };
        writeln!(
            f,
            "{}, {}{auxiliaries}, {}",
            plural(self.bodies, "body", "bodies"),
            plural(self.coordinates, "coordinate", "coordinates"),
            plural(m.rows, "constraint row", "constraint rows")
        )?;
        writeln!(
            f,
            "Mobility: {} (coordinates {} - rank {}; counting rows alone gives {})",
            m.freedoms,
            self.coordinates + self.auxiliaries,
            m.rank,
            m.count
        )?;
        if let Some(freedoms) = self.position_freedoms {
            writeln!(
                f,
                "Mobility of positions: {freedoms}; {} velocities only (nonholonomic)",
                if self.velocity_rows == 1 {
                    "1 row holds".to_owned()
                } else {
                    format!("{} rows hold", self.velocity_rows)
                }
            )?;
        }
        if m.is_singular() {
            writeln!(
                f,
                "Singular pose: the rank is {} here and {} nearby; only {} of the free motions {} on beside it",
                m.rank,
                m.generic_rank,
                m.freedoms - (m.generic_rank - m.rank),
                if m.freedoms - (m.generic_rank - m.rank) == 1 {
                    "goes"
                } else {
                    "go"
                }
            )?;
        } else if self.locked {
            writeln!(
                f,
                "Singular pose: free motions exist to first order only, the machine is locked in them"
            )?;
        }
        motions(f, "free motion", &self.motions)?;
        if self.driver_rows > 0 {
            let d = &self.driven;
            let left = match d.freedoms {
                0 => "every motion is driven".to_owned(),
                n => format!("{} left", plural(n, "free motion", "free motions")),
            };
            writeln!(
                f,
                "With {}: {left}",
                plural(self.driver_rows, "driven quantity", "driven quantities")
            )?;
            if d.is_singular() && !m.is_singular() {
                writeln!(
                    f,
                    "Singular pose for the drivers (dead centre): the rank is {} here and {} nearby",
                    d.rank, d.generic_rank
                )?;
            }
            motions(f, "motion left", &self.motions_left)?;
        }
        block(
            f,
            if self.locked || m.is_singular() {
                "Redundant rows (they repeat others; it is not they that lock the machine):"
            } else {
                "Redundant rows (harmless for the motion):"
            },
            &self.redundant,
        )?;
        block(
            f,
            "Rows that are dependent only at this pose:",
            &self.singular,
        )?;
        block(f, "Driven twice:", &self.over_driven)?;
        block(f, "Drivers without hold at this pose:", &self.dead_drivers)?;
        if !self.reactions_not_unique.is_empty() {
            writeln!(
                f,
                "Reactions that are not unique: {}",
                listed(&self.reactions_not_unique)
            )?;
        }
        for motion in &self.massless {
            writeln!(
                f,
                "Masses are missing: nothing determines {}; give mass and inertia of {}, or hold {}",
                listed(&motion.coordinates),
                listed(&motion.bodies),
                if motion.bodies.len() == 1 {
                    "it"
                } else {
                    "them"
                }
            )?;
        }
        for warning in &self.warnings {
            writeln!(f, "Note: {warning}")?;
        }
        Ok(())
    }
}
