//! Order of evaluation, and side effects inside expressions.

use bessemer::prelude::*;

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Order {
    pub a: [i32; 4],
    pub at: usize,
    pub count: i32,
    pub vectors: [Vector2<f64>; 2],
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Three {
    pub first: i32,
    pub second: i32,
    pub third: [i32; 2],
}

#[function]
fn next(n: &mut usize) -> usize {
    *n += 1;
    *n
}

#[function]
fn add(to: &mut i32, by: i32) -> i32 {
    *to = to.wrapping_add(by);
    *to
}

#[function]
fn both(a: i32, b: i32, c: i32) -> i32 {
    a.wrapping_mul(100).wrapping_add(b.wrapping_mul(10)).wrapping_add(c)
}

#[function]
fn checked(n: i32) -> bool {
    100 / n > 3
}

#[component]
impl Order {
    #[entry]
    pub fn indices(&mut self, mut i: usize) -> i32 {
        self.a[next(&mut i)] += 5;
        self.a[i] = {
            i -= 1;
            self.a[i] + i as i32
        };
        let x = add(&mut self.a[i], {
            i += 1;
            i as i32
        });
        let y = add(&mut self.a[i], {
            i = 0;
            next(&mut i) as i32
        });
        self.a[i] += {
            i = 2;
            10
        };
        self.a[next(&mut self.at)] = if x > y {
            i = 3;
            x
        } else {
            y
        };
        both(x, y, self.a[i])
    }

    #[entry]
    pub fn operands(&mut self, mut n: i32) -> i32 {
        let a = n + {
            n = n.wrapping_add(1);
            n
        };
        let b = both(
            n,
            {
                n = n.wrapping_mul(2);
                n
            },
            add(&mut n, 3),
        );
        let c = add(&mut n, 1).wrapping_sub(add(&mut n, 2)).wrapping_add(n);
        let t = Three { third: [add(&mut n, 1), n], second: add(&mut n, 1), first: n };
        let d =
            if add(&mut n, 1) > 3 && add(&mut n, 1) > 5 || add(&mut n, 1) == 0 { n } else { -1 };
        let e = match n {
            0 => 1,
            1 | 2 => add(&mut n, 4),
            _ => n,
        };
        a.wrapping_add(both(b, c, d))
            .wrapping_add(both(t.first, t.second, t.third[0]))
            .wrapping_add(e)
            .wrapping_add(t.third[1])
    }

    #[entry]
    pub fn circuits(&mut self, n: i32, i: usize) -> bool {
        let first = n != 0 && 100 / n > 5;
        let second = i < 4 && self.a[i] > 0 || i >= 4;
        let third = n == 0
            || checked(n) && {
                self.count = self.count.wrapping_add(1);
                n > 2
            };
        let fourth = first & (n != 3) | second ^ third;
        if !(n > 0 && 10 % n == 0) && fourth {
            return self.a[i] > 3;
        }
        first || second && third
    }

    #[entry]
    pub fn bounds(&mut self, mut n: u8) -> i32 {
        let mut sum = 0;
        for i in n..({
            n += 3;
            n
        }) {
            sum += i as i32;
            n += 1;
        }
        for k in 0..self.count.max(0).min(5) {
            self.count -= 1;
            sum += k * 2;
        }
        sum + n as i32
    }

    #[entry]
    pub fn vectors(&mut self, mut i: usize, x: f64) -> f64 {
        self.vectors[i] += {
            i = 1;
            Vector2::new(x, 1.0)
        };
        self.vectors[i] *= {
            i = 0;
            x
        };
        let s = self.vectors[i].x + {
            i = 1;
            self.vectors[i].y
        };
        let k = {
            let k = x;
            k * k
        } + {
            let k = s;
            k
        };
        k - {
            if k > 1.0 {
                self.vectors[0].x = k;
            }
            self.vectors[0].x
        }
    }

    #[entry]
    pub fn returns(&mut self, n: i32) -> i32 {
        let x = if n > 3 {
            if n == 5 {
                return 55;
            }
            n
        } else {
            match n {
                0 => return 7,
                1 => 2,
                _ => {
                    self.count = n;
                    -n
                }
            }
        };
        for i in 0..4 {
            match self.a[i] {
                0 => continue,
                1 => {
                    if x == 2 {
                        break;
                    }
                    self.count = 3;
                }
                2 => {
                    for j in 0..3usize {
                        if j as i32 == n {
                            return j as i32;
                        }
                        if self.a[j] == 2 {
                            break;
                        }
                    }
                }
                _ => {
                    self.at = i;
                }
            }
            self.a[i] -= 1;
        }
        {
            let y = x;
            {
                let x = y + 1;
                self.count += x;
            }
            x + self.count
        }
    }
}
