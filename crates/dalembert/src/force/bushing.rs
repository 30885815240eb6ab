//! Bushings.

use super::{ForceChannel, ForceElement, ForceReport};
use crate::joint::Guarded;
use crate::space::{PoseCoordinate, Space, Tuple, spread};
use nalgebra::DMatrix;
use smallvec::SmallVec;
use std::marker::PhantomData;

/// A bushing: generalized force -(K rho + C rho') on the pose rho of the second marker in the axes of the first
/// ([`Space::pose_coordinates`]); Q = (d rho/dq)^T of that, so action equals reaction.
#[derive(Clone, Debug)]
pub struct Bushing<S: Space> {
    /// K, in the units N/m, N/rad, N m/m, N m/rad of its entries; as large as a twist.
    pub stiffness: DMatrix<f64>,
    /// C.
    pub damping: DMatrix<f64>,
    /// The space.
    pub space: PhantomData<S>,
}

type Pose<S> = SmallVec<[PoseCoordinate<<S as Space>::Twist>; 6]>;

/// Row of a matrix times a vector.
fn row(matrix: &DMatrix<f64>, k: usize, x: impl Iterator<Item = f64>) -> f64 {
    matrix.row(k).iter().zip(x).map(|(a, x)| a * x).sum()
}

impl<S: Space> Bushing<S> {
    /// Generalized force on each coordinate of the pose.
    fn forces(&self, pose: &Pose<S>) -> SmallVec<[f64; 6]> {
        let force = |k| {
            let elastic = row(&self.stiffness, k, pose.iter().map(|c| c.value));
            let viscous = row(&self.damping, k, pose.iter().map(|c| c.rate));
            -elastic - viscous
        };
        (0..pose.len()).map(force).collect()
    }
}

impl<S: Space> ForceElement<S> for Bushing<S> {
    fn wrenches(&self, _t: f64, markers: &[S::Marker], out: &mut [S::Twist]) {
        let pose = S::pose_coordinates(&markers[0], &markers[1]);
        for (force, c) in self.forces(&pose).iter().zip(&pose) {
            out[0].add_scaled(*force, &c.first);
            out[1].add_scaled(*force, &c.second);
        }
    }

    /// Only a bushing that the turn twists has something to lose.
    fn guarded(&self, markers: &[S::Marker], see: &mut dyn FnMut(Guarded)) {
        let turns = |m: &DMatrix<f64>| m.columns_range(S::LINEAR..).iter().any(|x| *x != 0.0);
        if turns(&self.stiffness) || turns(&self.damping) {
            S::turn_guard(&markers[0], &markers[1])
                .into_iter()
                .for_each(see);
        }
    }

    fn report(&self, _t: f64, markers: &[S::Marker]) -> ForceReport {
        let pose = S::pose_coordinates(&markers[0], &markers[1]);
        let force = self.forces(&pose);
        let power: f64 = force.iter().zip(&pose).map(|(f, c)| f * c.rate).sum();
        let (mut potential, mut potential_rate) = (0.0, 0.0);
        for (k, c) in pose.iter().enumerate() {
            // Only the symmetric part of K has a potential.
            let columns = pose.iter().enumerate();
            let elastic: f64 = columns
                .map(|(j, c)| 0.5 * (self.stiffness[(k, j)] + self.stiffness[(j, k)]) * c.value)
                .sum();
            potential += 0.5 * elastic * c.value;
            potential_rate += elastic * c.rate;
        }
        let mut wrenches = [S::Twist::zero(); 2];
        for (f, c) in force.iter().zip(&pose) {
            wrenches[1].add_scaled(*f, &c.second);
        }
        // On the second body, in the axes of the first.
        let axes = S::axes(&markers[0]);
        let [f, m] = spread::<S>(&wrenches[1]).map(|x| axes.tr_mul(&x));
        let mut values: SmallVec<[f64; 8]> = SmallVec::from_slice(&f.as_slice()[..S::LINEAR]);
        values.extend(S::ANGULAR.iter().map(|&k| m[k]));
        values.push(power);
        ForceReport {
            potential,
            potential_rate,
            values,
        }
    }

    fn channels(&self) -> Vec<ForceChannel> {
        const FORCES: [ForceChannel; 3] = [
            ForceChannel {
                suffix: "force_x",
                unit: "N",
                meaning: "force on the second body along the first body's joint x axis",
            },
            ForceChannel {
                suffix: "force_y",
                unit: "N",
                meaning: "force on the second body along the first body's joint y axis",
            },
            ForceChannel {
                suffix: "force_z",
                unit: "N",
                meaning: "force on the second body along the first body's joint z axis",
            },
        ];
        const MOMENTS: [ForceChannel; 3] = [
            ForceChannel {
                suffix: "moment_x",
                unit: "N m",
                meaning: "moment on the second body at its point about the first body's joint x axis",
            },
            ForceChannel {
                suffix: "moment_y",
                unit: "N m",
                meaning: "moment on the second body at its point about the first body's joint y axis",
            },
            ForceChannel {
                suffix: "moment_z",
                unit: "N m",
                meaning: "moment on the second body at its point about the first body's joint z axis",
            },
        ];
        let mut list = FORCES[..S::LINEAR].to_vec();
        if S::ANGULAR.len() == 1 {
            list.push(ForceChannel {
                suffix: "moment",
                unit: "N m",
                meaning: "moment on the second body at its point",
            });
        } else {
            list.extend(MOMENTS);
        }
        list.push(ForceChannel {
            suffix: "power",
            unit: "W",
            meaning: "power into the machine",
        });
        list
    }
}
