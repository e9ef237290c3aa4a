// Parameters that the C only writes, since their types decide the reads: compilers warn of such a parameter.
#[data]
#[derive(Clone, Copy, PartialEq)]
pub enum FoundParametersOnlyWrittenWay {
    On,
    Off,
    Idle,
}
#[function]
pub fn found_parameters_only_written_0(mut x: bool, n: i16) -> i16 {
    if x != x {
        return 7;
    }
    x = n > 3;
    n
}
#[function]
pub fn found_parameters_only_written_1(mut way: FoundParametersOnlyWrittenWay, n: i16) -> i16 {
    way = way;
    let mut i = 0_i16;
    #[bound(5)]
    while i < 3 {
        i += 1;
        if way != way {
            return 7;
        }
        way = FoundParametersOnlyWrittenWay::Off;
    }
    n
}
#[function]
pub fn found_parameters_only_written_2(mut k: u8, mut c: i32, n: i16) -> i16 {
    match k {
        x if (x as u16) <= (x as u16) => k = 4,
        _ => {}
    }
    if c != c {
        return 1;
    }
    c = i32::from(n);
    n
}
