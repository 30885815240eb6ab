//! What moving bodies take in, from their motion alone.

use super::run::Instant;

/// Gravity of the gallery's models [m/s^2].
pub const G: f64 = 9.81;

/// A body of a model: name, mass [kg], moment of inertia about the centre of mass [kg m^2], centre of
/// mass on the x axis of its frame [m].
pub struct Mass(pub &'static str, pub f64, pub f64, pub f64);

/// Rate of the energy of the bodies, sum of m a.v + J alpha omega + m g vy at the centres of mass [W].
pub fn energy_rate(instant: Instant<'_>, masses: &[Mass]) -> f64 {
    masses
        .iter()
        .map(|Mass(name, mass, inertia, center)| {
            let of = |suffix: &str| instant.get(&format!("{name}.{suffix}"));
            let (s, c) = of("angle").sin_cos();
            let (omega, alpha) = (of("omega"), of("alpha"));
            let [x, y] = [center * c, center * s];
            let v = [of("vx") - omega * y, of("vy") + omega * x];
            let a = [
                of("ax") - alpha * y - omega * omega * x,
                of("ay") + alpha * x - omega * omega * y,
            ];
            mass * (a[0] * v[0] + (a[1] + G) * v[1]) + inertia * alpha * omega
        })
        .sum()
}
