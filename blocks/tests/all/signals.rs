//! Controllers, filters, windows, limits, tables and spectra against SciPy and NumPy.

use bessemer::prelude::{Real, real};
use bessemer_blocks::*;
use num_traits::AsPrimitive;

use crate::data::{Data, near};

/// Runs a test in both precisions.
macro_rules! in_both {
    ($($name:ident)*) => {$(
        #[test]
        fn $name() {
            both::$name::<f64>();
            both::$name::<f32>();
        }
    )*};
}

in_both! { pid first_order sections fir_and_decimator statistics calculus jerk_limiter tables_of_one_input
tables_of_two_inputs transform }

mod both {
    use super::*;

    pub fn pid<T: Real>() {
        let data = Data::read(include_str!("../data/pid.txt"));
        let [
            proportional,
            integral,
            derivative,
            target_weight,
            target_slope_weight,
            filter,
            period,
        ] = data.all::<T, 7>("parameters");
        let parameters = PidParameters {
            proportional,
            integral,
            derivative,
            target_weight,
            target_slope_weight,
            filter,
            period,
            ..PidParameters::default()
        };
        let (mut pid, mut outputs) = (Pid::default(), Vec::new());
        for (target, measured) in data.get("target").into_iter().zip(data.get("measured")) {
            outputs.push(pid.step(&parameters, target, measured));
        }
        near(&outputs, &data.get("output"), 13);
    }

    pub fn first_order<T: Real>() {
        let data = Data::read(include_str!("../data/filters.txt"));
        let period = real(0.004);
        for (name, section) in [
            ("low_pass", FirstOrder::<T>::low_pass(real(0.03), period)),
            ("high_pass", FirstOrder::high_pass(real(0.03), period)),
            ("lead_lag", FirstOrder::lead_lag(real(0.05), real(0.01), period)),
        ] {
            let mut filter = FirstOrderFilter::default();
            let outputs = data.get("input").into_iter().map(|it| filter.step(&section, it));
            let outputs: Vec<T> = outputs.collect();
            near(&outputs, &data.get(&format!("first_{name}")), 13);
        }
    }

    pub fn sections<T: Real>() {
        let data = Data::read(include_str!("../data/filters.txt"));
        let design = [Section::low_pass, Section::high_pass, Section::band_pass, Section::notch];
        let sections: [Section<T>; 4] =
            design.map(|design| design(real(60.0), real(0.8), real(1000.0)));
        for (section, name) in sections.iter().zip(["low_pass", "high_pass", "band_pass", "notch"])
        {
            let Section { b0, b1, b2, a1, a2 } = *section;
            near(&[b0, b1, b2, a1, a2], &data.get(&format!("section_{name}")), 13);
        }
        let chosen = [sections[0], sections[3]];
        let mut transposed = Cascade::<T, 2>::default();
        let mut direct = CascadeDirect::<T, 2>::default();
        let input = data.all::<T, 60>("input");
        let single = input.map(|sample| transposed.step(&chosen, sample));
        near(&single, &data.get("cascade"), 13);
        near(&input.map(|sample| direct.step(&chosen, sample)), &data.get("cascade"), 13);
        let mut block = input;
        Cascade::<T, 2>::default().block(&chosen, &mut block);
        assert_eq!(block, single, "the bits of a block");
    }

    pub fn fir_and_decimator<T: Real>() {
        let data = Data::read(include_str!("../data/windows.txt"));
        let taps = data.all::<T, 7>("taps");
        let (mut fir, mut decimator) = (Fir::<T, 7>::default(), Decimator::<T, 7>::default());
        let input = data.get("input");
        let outputs: Vec<T> = input.iter().map(|sample| fir.step(&taps, *sample)).collect();
        near(&outputs, &data.get("fir"), 14);
        let outputs = input.iter().filter_map(|sample| decimator.step(&taps, 3, *sample));
        near(&outputs.collect::<Vec<T>>(), &data.get("decimated"), 14);
    }

    pub fn statistics<T: Real>() {
        let data = Data::read(include_str!("../data/windows.txt"));
        let mut moving = Moving::<T, 5>::default();
        let spreads = data.get("input").into_iter().map(|sample| moving.spread(sample));
        let (means, variances): (Vec<T>, Vec<T>) =
            spreads.map(|spread| (spread.mean, spread.variance)).unzip();
        near(&means, &data.get("mean"), 14);
        near(&variances, &data.get("variance"), 14);
    }

    pub fn calculus<T: Real>() {
        let data = Data::read(include_str!("../data/windows.txt"));
        let period = real::<T>(0.01);
        let limits = IntegratorParameters { period, ..IntegratorParameters::default() };
        let (mut derivative, mut integrator) = (Derivative::default(), Integrator::default());
        let (mut slopes, mut sums) = (Vec::new(), Vec::new());
        for sample in data.get("input") {
            slopes.push(derivative.step(real(0.02), period, sample));
            sums.push(integrator.step(&limits, sample));
        }
        near(&slopes, &data.get("derivative"), 13);
        near(&sums, &data.get("integral"), 13);
    }

    pub fn jerk_limiter<T: Real>() {
        let data = Data::read(include_str!("../data/limits.txt"));
        let limits =
            JerkLimits { rate: real(2.0), acceleration: real(5.0), period: real::<T>(0.02) };
        let mut limiter = JerkLimiter::default();
        let motions = data.get("target").into_iter().map(|target| limiter.step(&limits, target));
        let found: Vec<T> = motions.flat_map(|motion| [motion.value, motion.rate]).collect();
        // At rest, the last bits decide on which side of the target the next step is.
        near(&found, &data.get("motion"), 12);
    }

    pub fn tables_of_one_input<T: Real + AsPrimitive<u32>>() {
        let data = Data::read(include_str!("../data/tables.txt"));
        let (axis, values) =
            (Axis { points: data.all::<T, 5>("axis") }, data.all::<T, 5>("values"));
        let uniform = UniformAxis::<T, 5> { first: real(-2.0), spacing: real(2.0) };
        assert!(ascends(&axis.points));
        let (mut search, at) = (Search::default(), data.get::<T>("at"));
        for (beyond, name) in [(Beyond::Hold, "held"), (Beyond::Extend, "extended")] {
            let found = at.iter().map(|at| interpolated(&values, axis.place(*at, beyond)));
            near(&found.collect::<Vec<T>>(), &data.get(name), 13);
            // From the other end, so that the search goes down.
            for at in at.iter().rev() {
                assert_eq!(search.place(&axis, *at, beyond), axis.place(*at, beyond));
            }
            let found = at.iter().map(|at| interpolated(&values, uniform.place(*at, beyond)));
            near(&found.collect::<Vec<T>>(), &data.get(&format!("uniform_{name}")), 13);
        }
    }

    pub fn tables_of_two_inputs<T: Real>() {
        let data = Data::read(include_str!("../data/tables.txt"));
        let rows = Axis { points: data.all::<T, 3>("rows") };
        let columns = Axis { points: data.all::<T, 5>("axis") };
        let grid: [[T; 5]; 3] = data.rows("grid").try_into().expect("three rows");
        for (beyond, name) in [(Beyond::Hold, "held"), (Beyond::Extend, "extended")] {
            let places = data.get("row_at").into_iter().zip(data.get("at"));
            let found = places.map(|(row, column)| {
                interpolated_2d(&grid, rows.place(row, beyond), columns.place(column, beyond))
            });
            near(&found.collect::<Vec<T>>(), &data.get(&format!("surface_{name}")), 13);
        }
    }

    pub fn transform<T: Real>() {
        const ROOTS: [[f64; 2]; 16] = roots_f64();
        let data = Data::read(include_str!("../data/spectrum.txt"));
        let roots = ROOTS.map(|root| root.map(real::<T>));
        let (mut re, mut im) = (data.all::<T, 32>("re"), data.all::<T, 32>("im"));
        for (cycles, power) in data.get::<T>("cycles").into_iter().zip(data.get::<T>("tones")) {
            near(&[goertzel(&re, cycles)], &[power], 11);
        }
        fft(&mut re, &mut im, &roots);
        near(&re, &data.get("spectrum_re"), 14);
        near(&im, &data.get("spectrum_im"), 14);
    }
}

#[test]
fn the_roots_of_unity_are_exact_to_two_units_in_the_last_place() {
    const FINE: [[f64; 2]; 128] = roots_f64();
    const COARSE: [[f32; 2]; 128] = roots_f32();
    for (k, (fine, coarse)) in FINE.iter().zip(&COARSE).enumerate() {
        let (sine, cosine) = (std::f64::consts::PI * k as f64 / 128.0).sin_cos();
        assert!((fine[0] - cosine).abs() < 5e-16 && (fine[1] - sine).abs() < 5e-16, "{k}");
        assert!((f64::from(coarse[0]) - cosine).abs() < 6e-8, "{k}");
    }
}
