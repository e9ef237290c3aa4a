//! Calls of `geoconv` over plain numbers.

use crate::*;

pub fn placed(at: [f64; 3], of: [f64; 3]) -> ([f64; 3], [f64; 3], [f64; 3]) {
    let here = Lle::<Wgs84>::new(Degrees::new(at[0]), Degrees::new(at[1]), Meters::new(at[2]));
    let there = Lle::<Wgs84>::new(Degrees::new(of[0]), Degrees::new(of[1]), Meters::new(of[2]));
    let xyz = Xyz::from(here);
    let enu = here.enu_to(&there);
    let aer: Aer<Degrees> = enu.into();
    (
        [xyz.x.as_float(), xyz.y.as_float(), xyz.z.as_float()],
        [enu.east.as_float(), enu.north.as_float(), enu.up.as_float()],
        [aer.azimuth.as_float(), aer.elevation.as_float(), aer.range.as_float()],
    )
}

pub fn back(at: [f64; 3]) -> [f64; 3] {
    let xyz = Xyz { x: Meters::new(at[0]), y: Meters::new(at[1]), z: Meters::new(at[2]) };
    let lle = Lle::<Wgs84, Radians>::from(xyz);
    [lle.latitude.as_float(), lle.longitude.as_float(), lle.elevation.as_float()]
}

pub fn great_circle(one: [f64; 2], other: [f64; 2]) -> (f64, f64) {
    let (a, b) = ((Degrees::new(one[0]), Degrees::new(one[1])), (Degrees::new(other[0]), Degrees::new(other[1])));
    (haversine_distance(a, b).as_float(), bearing(a, b).as_float())
}
