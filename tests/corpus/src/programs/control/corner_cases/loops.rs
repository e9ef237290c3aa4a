//! Ranges at the limits of their types, and nested loops.

use bessemer::prelude::*;

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Loops {
    pub hash: u64,
    pub table: [[u16; 3]; 5],
}

const ROWS: usize = 5;
const NONE: i32 = 0;

#[component]
impl Loops {
    fn mix(&mut self, value: u64) {
        self.hash = self.hash.wrapping_mul(31).wrapping_add(value);
    }

    #[entry(infallible)]
    pub fn limits(&mut self) -> u32 {
        let mut count = 0u32;
        for i in 0..=u8::MAX {
            self.mix(i as u64);
            count = count.wrapping_add(1);
        }
        for i in (0..=u8::MAX).rev() {
            self.mix(i as u64);
            count = count.wrapping_add(1);
        }
        for i in (i8::MIN..=i8::MAX).rev() {
            self.mix(i as u64);
            count = count.wrapping_add(1);
        }
        for i in i8::MIN..=i8::MAX {
            self.mix(i as u64);
            count = count.wrapping_add(1);
        }
        for i in (i8::MIN..i8::MAX).rev() {
            self.mix(i as u64);
        }
        for i in i64::MAX - 2..=i64::MAX {
            self.mix(i as u64);
        }
        for i in (i64::MIN..=i64::MIN + 2).rev() {
            self.mix(i as u64);
        }
        for i in (u64::MAX - 1..=u64::MAX).rev() {
            self.mix(i);
        }
        for i in (0..0).rev() {
            self.mix(i);
        }
        for i in 5..=4 {
            self.mix(i);
        }
        for i in (5..=4u8).rev() {
            self.mix(i as u64);
        }
        for i in -3..-3 {
            self.mix(i as u64);
        }
        for i in 0..NONE {
            self.mix(i as u64);
        }
        for i in (0..=0usize).rev() {
            self.mix(i as u64);
        }
        count
    }

    #[entry(infallible)]
    pub fn given(&mut self, a: i8, b: i8, c: u8, d: u8) {
        for i in a..b {
            self.mix(i as u64);
        }
        for i in a..=b {
            self.mix(i as u64);
        }
        for i in (a..b).rev() {
            self.mix(i as u64);
        }
        for i in (a..=b).rev() {
            self.mix(i as u64);
        }
        for i in c..d {
            self.mix(i as u64);
        }
        for i in c..=d {
            self.mix(i as u64);
        }
        for i in (c..d).rev() {
            self.mix(i as u64);
        }
        for i in (c..=d).rev() {
            self.mix(i as u64);
        }
    }

    #[entry]
    pub fn shadowed(&mut self, n: u8) -> u16 {
        let mut i = n % 4;
        let mut sum: u16 = 0;
        for i in 0..i as usize + 2 {
            for j in 0..ROWS {
                let i = i % 3;
                if j == 3 {
                    continue;
                }
                self.table[j][i] += 1;
                match j {
                    4 => break,
                    1 => {
                        if i == 2 {
                            continue;
                        }
                    }
                    _ => {}
                }
                sum += self.table[j][i];
            }
            for _ in 0..2 {
                sum += 1;
                for _ in 0..1 {
                    sum += i as u16;
                }
            }
        }
        i += 1;
        sum + i as u16
    }

    #[entry]
    pub fn matrices(&mut self, m: &Matrix3<f64>, k: usize) -> SMatrix<f64, 1, 1> {
        let mut sum = SMatrix::<f64, 1, 1>::zeros();
        for r in (0..3).rev() {
            for c in r..3 {
                sum[(0, 0)] += m[(r, c)];
            }
        }
        for r in 0..k {
            sum[0] = sum[0] * m[(r, k - r)];
        }
        sum * sum
    }

    #[entry(infallible)]
    pub fn stepped(&mut self, mut n: u32) -> u32 {
        let mut steps = 0;
        for _ in 0..1000 {
            if n <= 1 {
                break;
            }
            n = if n % 2 == 0 { n / 2 } else { n.wrapping_mul(3).wrapping_add(1) };
            steps = n.min(9).max(steps);
        }
        steps
    }
}
