//! Groups of points that lie close together (DBSCAN), on bounded lists.

use bessemer::prelude::*;

/// Group membership of a point.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Belonging {
    #[default]
    Unvisited,
    Noise,
    Group(u8),
}

/// Indices of the points within a radius of the point `of`.
#[function]
fn near(points: &List<Vector2<f64>, 10>, of: usize, radius: f64) -> List<usize, 10> {
    let mut found = List::new();
    for (i, point) in points.iter().enumerate() {
        if (point - points[of]).norm() <= radius {
            found.push(i);
        }
    }
    found
}

/// Assigns each point to a group.
#[function]
pub fn group(points: &List<Vector2<f64>, 10>, radius: f64, least: usize) -> [Belonging; 10] {
    let mut labels = [Belonging::Unvisited; 10];
    let mut groups = 0u8;
    for i in 0..points.len() {
        if labels[i] != Belonging::Unvisited {
            continue;
        }
        let mut open = near(points, i, radius);
        if open.len() < least {
            labels[i] = Belonging::Noise;
            continue;
        }
        labels[i] = Belonging::Group(groups);
        #[bound(110)]
        while let Some(j) = open.pop() {
            match labels[j] {
                Belonging::Noise => labels[j] = Belonging::Group(groups),
                Belonging::Unvisited => {
                    labels[j] = Belonging::Group(groups);
                    let more = near(points, j, radius);
                    if more.len() >= least {
                        for &k in &more {
                            if !open.contains(&k) && open.len() < open.capacity() {
                                open.push(k);
                            }
                        }
                    }
                }
                Belonging::Group(_) => {}
            }
        }
        groups += 1;
    }
    labels
}
