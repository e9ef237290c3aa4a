//! `Option` and `Result`: stored, passed, returned, destructured, compared, and used with `?`.

use bessemer::prelude::*;

/// Possible errors.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Trouble {
    #[default]
    Low,
    High,
    Lost,
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    pub last: Option<f64>,
    pub point: Option<Vector3<f64>>,
    pub window: [Option<u8>; 4],
    pub nested: Option<(u8, Option<i16>)>,
    pub outcome: Option<Trouble>,
}

const UNKNOWN: Option<f64> = None;
const KNOWN: Option<f64> = Some(2.5);

#[function]
fn root(x: f64) -> Option<f64> {
    if x >= 0.0 { Some(x.sqrt()) } else { None }
}

#[function]
fn both(x: f64, y: f64) -> Option<f64> {
    let a = root(x)?;
    Some(a + root(y)?)
}

#[function]
fn checked(x: f64) -> Result<f64, Trouble> {
    if x < -5.0 {
        return Err(Trouble::Low);
    }
    if x > 5.0 {
        return Err(Trouble::High);
    }
    Ok(x * 2.0)
}

#[function]
fn within(x: f64) -> Result<(), Trouble> {
    checked(x)?;
    Ok(())
}

#[function]
fn summed(x: f64, y: f64) -> Result<f64, Trouble> {
    within(x)?;
    let sum = checked(x)? + checked(y)?;
    if sum != sum { Err(Trouble::Lost) } else { Ok(sum) }
}

#[function]
fn cleared(slot: &mut Option<u8>) -> bool {
    let was = slot.is_some();
    *slot = None;
    was
}

#[component]
impl Options {
    #[entry(infallible)]
    pub fn roots(&mut self, x: f64, y: f64) -> Option<f64> {
        let before = self.last;
        self.last = both(x, y);
        match before {
            Some(level) if level > 1.0 => Some(level),
            Some(level) => root(level),
            None => self.last,
        }
    }

    #[entry(infallible)]
    pub fn results(&mut self, x: f64, y: f64) -> Result<f64, Trouble> {
        let sum = summed(x, y);
        self.outcome = match sum {
            Ok(_) => None,
            Err(trouble) => Some(trouble),
        };
        let Ok(value) = sum else { return sum };
        if let Some(Trouble::High) = self.outcome {
            return Err(Trouble::Lost);
        }
        Ok(-value)
    }

    #[entry]
    pub fn unwrapped(&mut self, x: f64) -> f64 {
        let a = root(x).unwrap();
        let b = self.last.expect("must be there");
        self.last = None;
        a + b + checked(x).unwrap_or(7.0)
    }

    #[entry]
    pub fn window(&mut self, i: usize, value: Option<u8>) -> u8 {
        let old = self.window[i].take();
        self.window[i] = value.or(old);
        let mut count = 0;
        for slot in &mut self.window {
            if let Some(n) = slot {
                *n = n.wrapping_add(1);
                count += 1;
            } else if cleared(slot) {
                count += 100;
            }
        }
        count + self.window[3 - i].unwrap_or_default()
    }

    #[entry(infallible)]
    pub fn nested(&mut self, a: u8, b: Option<i16>) -> i32 {
        let code = match self.nested {
            None => 0,
            Some((0, None)) => 1,
            Some((n, None)) => n as i32,
            Some((_, Some(m @ 1..=9))) => 1000 + m as i32,
            Some((n, Some(m))) if n > 3 => m as i32,
            Some(_) => -1,
        };
        if let Some((n, inner)) = &mut self.nested {
            *n = a;
            *inner = b;
        } else {
            self.nested = Some((a, b));
        }
        code
    }

    #[entry(infallible)]
    pub fn asked(&mut self, a: Option<u8>, b: Result<u8, Trouble>) -> (bool, bool) {
        self.outcome = b.err();
        let same = a == b.ok();
        let known = a.is_some() && b.is_ok() || a.is_none() && b.is_err();
        if UNKNOWN == self.last || KNOWN == self.last {
            return (known, !same);
        }
        let back = a.ok_or(Trouble::Lost);
        (back == b, matches!(a, Some(1..=9)) || matches!(b, Err(Trouble::Low | Trouble::Lost)))
    }

    #[entry(infallible)]
    pub fn points(&mut self, v: &Vector3<f64>, keep: bool) -> Option<Vector3<f64>> {
        let old = self.point;
        if keep
            && let Some(point) = &self.point
            && point.x < v.x
        {
            return Some(point + v);
        }
        self.point = if v.norm() > 2.0 { Some(*v) } else { None };
        let Some(old) = old else {
            return self.point;
        };
        Some(old * 2.0)
    }

    #[entry]
    pub fn drained(&mut self, mut n: u8) -> u8 {
        let mut left = Some(n);
        #[bound(9)]
        while let Some(k) = left {
            n = n.wrapping_mul(3);
            left = if k > 0 { Some(k - 1) } else { None };
        }
        n
    }

    #[entry(infallible)]
    pub fn replaced(&mut self, x: f64) -> Option<f64> {
        let old = self.last.replace(x);
        if matches!(old, Some(y) if y > x) { old } else { self.last.and(old) }
    }
}
