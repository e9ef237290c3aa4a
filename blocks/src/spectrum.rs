//! Spectrum: fast Fourier transform and Goertzel's algorithm.

use bessemer::prelude::*;

/// Returns the roots of unity cos(2πk/2H), sin(2πk/2H) for k below `H`, for an FFT of 2 `H` points in single precision.
pub const fn roots_f32<const H: usize>() -> [[f32; 2]; H] {
    let exact = roots_f64::<H>();
    let mut roots = [[0.0; 2]; H];
    let mut k = 0;
    while k < H {
        roots[k] = [exact[k][0] as f32, exact[k][1] as f32];
        k += 1;
    }
    roots
}

/// Returns the roots of unity cos(2πk/2H), sin(2πk/2H) for k below `H`, for an FFT of 2 `H` points.
pub const fn roots_f64<const H: usize>() -> [[f64; 2]; H] {
    let mut roots = [[0.0; 2]; H];
    let mut k = 0;
    while k < H {
        // Within an eighth of a turn, where both series converge fast.
        let (near, swapped, beyond) = match (4 * k <= H, 2 * k <= H, 4 * k <= 3 * H) {
            (true, _, _) => (k as f64, false, false),
            (_, true, _) => (H as f64 / 2.0 - k as f64, true, false),
            (_, _, true) => (k as f64 - H as f64 / 2.0, true, true),
            _ => (H as f64 - k as f64, false, true),
        };
        let angle = core::f64::consts::PI * near / H as f64;
        let (mut cosine, mut sine) = (0.0, 0.0);
        let mut n = 12;
        while n > 0 {
            // Horner's rule for both series of Taylor.
            let even = (2 * n * (2 * n - 1)) as f64;
            let odd = (2 * n * (2 * n + 1)) as f64;
            cosine = (1.0 + cosine) * (-angle * angle / even);
            sine = (1.0 + sine) * (-angle * angle / odd);
            n -= 1;
        }
        let (cosine, sine) = (1.0 + cosine, angle * (1.0 + sine));
        let (cosine, sine) = if swapped { (sine, cosine) } else { (cosine, sine) };
        roots[k] = [if beyond { -cosine } else { cosine }, sine];
        k += 1;
    }
    roots
}

/// Number of stages of a transform of `N` points.
struct Stages<const N: usize>;

impl<const N: usize> Stages<N> {
    const COUNT: u32 = N.trailing_zeros();
}

/// Fast Fourier transform of `N` complex points, in place: X(m) = Σ x(k) exp(−2πi k m/N).
///
/// `N` is a power of two and `H` its half; `roots` are those of [`roots_f32`] or [`roots_f64`], a constant in the
/// firmware's flash. Nothing is scaled. The inverse is the transform of the conjugates, divided by N. Source: Cooley and
/// Tukey, *An Algorithm for the Machine Calculation of Complex Fourier Series*, Mathematics of Computation 19, 1965:
/// decimation in time, radix 2.
///
/// ```
/// use bessemer_blocks::{fft, roots_f64};
///
/// const ROOTS: [[f64; 2]; 4] = roots_f64();
/// // One period of a cosine: half of it in the first bin, half in the last.
/// let mut re = [1.0, 0.7071067811865476, 0.0, -0.7071067811865476, -1.0, -0.7071067811865476, 0.0, 0.7071067811865476];
/// let mut im = [0.0; 8];
/// fft(&mut re, &mut im, &ROOTS);
/// assert!((re[1] - 4.0).abs() < 1e-15 && (re[7] - 4.0).abs() < 1e-15 && re[2].abs() < 1e-15);
/// ```
#[function]
pub fn fft<T: Real, const N: usize, const H: usize>(
    re: &mut [T; N],
    im: &mut [T; N],
    roots: &[[T; 2]; H],
) {
    for k in 0..N as u32 {
        let mirrored = (k.reverse_bits() >> (32 - Stages::<N>::COUNT)) & (N as u32 - 1);
        if mirrored > k {
            re.swap(k as usize, mirrored as usize);
            im.swap(k as usize, mirrored as usize);
        }
    }
    for stage in 0..Stages::<N>::COUNT {
        let half = 1_u32 << stage;
        for butterfly in 0..H as u32 {
            let k = butterfly & (half - 1);
            let low = (((butterfly >> stage) << (stage + 1)) | k) & (N as u32 - 1);
            let high = (low | half) & (N as u32 - 1);
            let root = (k << (Stages::<N>::COUNT - 1 - stage)) & (H as u32 - 1);
            let (low, high) = (low as usize, high as usize);
            let [cosine, sine] = roots[root as usize];
            let turned_re = re[high] * cosine + im[high] * sine;
            let turned_im = im[high] * cosine - re[high] * sine;
            re[high] = re[low] - turned_re;
            im[high] = im[low] - turned_im;
            re[low] += turned_re;
            im[low] += turned_im;
        }
    }
}

/// Goertzel's algorithm: the power |X|² of one tone in a block of samples. Its frequency is in `cycles` per sample, 0 to
/// 0.5: frequency divided by the sample rate.
///
/// For a whole number m of cycles in the block it is |X(m)|² of the FFT. Source: Goertzel, *An Algorithm for the Evaluation of
/// Finite Trigonometric Series*, American Mathematical Monthly 65 (1), 1958.
///
/// ```
/// let power = bessemer_blocks::goertzel(&[1.0, 0.0, -1.0, 0.0, 1.0, 0.0, -1.0, 0.0], 0.25);
/// assert!((power - 16.0_f64).abs() < 1e-12);
/// ```
#[function]
pub fn goertzel<T: Real, const N: usize>(samples: &[T; N], cycles: T) -> T {
    let coefficient = real::<T>(2.0) * (T::TAU * cycles).cos();
    let (mut last, mut before) = (T::ZERO, T::ZERO);
    for sample in samples {
        let next = *sample + coefficient * last - before;
        before = last;
        last = next;
    }
    before * before + last * last - coefficient * before * last
}
