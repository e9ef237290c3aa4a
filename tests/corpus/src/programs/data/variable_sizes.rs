//! Vectors and matrices with a maximum size; each dimension is fixed or variable.

use bessemer::prelude::*;

/// Hits of a scanner.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scan {
    /// At most five ranges.
    pub ranges: List<f32, 5>,
    /// At most four points of three coordinates.
    pub points: List<Vector3<f32>, 4>,
    /// A matrix of at most two by three.
    pub hits: BoundedMatrix<u8, 2, 3>,
    /// A matrix of two by three.
    pub grid: SMatrix<f32, 2, 3>,
}

/// Stores the results of a beam; a fault if there is no room.
#[function]
pub fn seen(scan: &mut Scan, point: &Vector3<f32>, hits: &[u8; 2]) {
    scan.ranges.push(point.norm());
    scan.points.push(*point);
    scan.hits.push_column(&hits[..scan.hits.nrows()]);
}

/// The mean of the points.
#[function]
pub fn middle(scan: &Scan) -> Vector3<f32> {
    let mut sum = Vector3::zeros();
    for point in &scan.points {
        sum += *point;
    }
    sum / scan.points.len().max(1) as f32
}

/// Number of hits above a level.
#[function]
pub fn strong(scan: &Scan, level: u8) -> u32 {
    let mut count = 0;
    for column in 0..scan.hits.ncols() {
        for row in 0..scan.hits.nrows() {
            if scan.hits[(row, column)] > level {
                count += 1;
            }
        }
    }
    count
}
