// Whole programs as a newcomer writes them: frames over a wire, a particle filter, a bus with errors.
/// CRC32 with a table built at compile time, and COBS.
const fn found_programs_crccobs_crc_table() -> [u32; 256] {
    let mut table = [0u32; 256];
    let mut i = 0;
    while i < 256 {
        let mut crc = i as u32;
        let mut bit = 0;
        while bit < 8 {
            crc = if crc & 1 != 0 { (crc >> 1) ^ 0xEDB8_8320 } else { crc >> 1 };
            bit += 1;
        }
        table[i] = crc;
        i += 1;
    }
    table
}

static FOUND_PROGRAMS_CRCCOBS_CRC_TABLE: [u32; 256] = found_programs_crccobs_crc_table();

#[function]
fn found_programs_crccobs_crc32(data: &[u8]) -> u32 {
    !data.iter().fold(!0u32, |crc, &byte| FOUND_PROGRAMS_CRCCOBS_CRC_TABLE[((crc ^ byte as u32) & 0xFF) as usize] ^ (crc >> 8))
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FoundProgramsCrccobsCobsError {
    BufferTooSmall { needed: usize },
    UnexpectedZero,
    Truncated,
}

#[function]
fn found_programs_crccobs_encode(input: &[u8], out: &mut [u8]) -> Result<usize, FoundProgramsCrccobsCobsError> {
    let needed = input.len() + input.len() / 254 + 1;
    if out.len() < needed {
        return Err(FoundProgramsCrccobsCobsError::BufferTooSmall { needed });
    }
    let mut code_at = 0;
    let mut len = 1;
    let mut code = 1u8;
    for &b in input {
        if b != 0 {
            out[len] = b;
            len += 1;
            code += 1;
        }
        if b == 0 || code == u8::MAX {
            out[code_at] = code;
            code_at = len;
            len += 1;
            code = 1;
        }
    }
    out[code_at] = code;
    Ok(len)
}

#[function]
fn found_programs_crccobs_decode(input: &[u8], out: &mut [u8]) -> Result<usize, FoundProgramsCrccobsCobsError> {
    let mut rest = input;
    let mut len = 0;
    while let [code, tail @ ..] = rest {
        let n = match *code {
            0 => return Err(FoundProgramsCrccobsCobsError::UnexpectedZero),
            c => c as usize - 1,
        };
        let block = tail.get(..n).ok_or(FoundProgramsCrccobsCobsError::Truncated)?;
        out.get_mut(len..len + n).ok_or(FoundProgramsCrccobsCobsError::BufferTooSmall { needed: len + n })?.copy_from_slice(block);
        len += n;
        rest = &tail[n..];
        if !rest.is_empty() && *code != u8::MAX {
            *out.get_mut(len).ok_or(FoundProgramsCrccobsCobsError::BufferTooSmall { needed: len + 1 })? = 0;
            len += 1;
        }
    }
    Ok(len)
}

#[function]
pub fn found_programs_crccobs(mut data: [u8; 10], zero: u8) -> (u32, u32) {
    for b in data.iter_mut().filter(|b| **b < zero) {
        *b = 0;
    }
    let mut enc = [0u8; 12];
    let mut dec = [0u8; 12];
    let before = found_programs_crccobs_crc32(&data);
    let Ok(n) = found_programs_crccobs_encode(&data, &mut enc) else {
        return (before, 0);
    };
    match found_programs_crccobs_decode(&enc[..n], &mut dec) {
        Ok(m) => (before, found_programs_crccobs_crc32(&dec[..m])),
        Err(FoundProgramsCrccobsCobsError::UnexpectedZero) => (before, 1),
        Err(FoundProgramsCrccobsCobsError::Truncated) => (before, 2),
        Err(FoundProgramsCrccobsCobsError::BufferTooSmall { needed }) => (before, 3 + needed as u32),
    }
}
/// FoundProgramsParticleParticle filter with xorshift.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FoundProgramsParticleRng(u32);

#[data]
impl FoundProgramsParticleRng {
    fn new(seed: u32) -> Self {
        Self(if seed == 0 { 0xDEAD_BEEF } else { seed })
    }

    fn next_u32(&mut self) -> u32 {
        let Self(mut x) = *self;
        x ^= x << 13;
        x ^= x >> 17;
        x ^= x << 5;
        self.0 = x;
        x
    }

    fn uniform(&mut self) -> f32 {
        (self.next_u32() >> 8) as f32 / (1u32 << 24) as f32
    }

    fn gauss(&mut self) -> f32 {
        (0..12).map(|_| self.uniform()).sum::<f32>() - 6.0
    }
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FoundProgramsParticleParticle {
    x: f32,
    w: f32,
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundProgramsParticleFilter<const N: usize> {
    particles: [FoundProgramsParticleParticle; N],
    rng: FoundProgramsParticleRng,
}

#[data]
impl<const N: usize> FoundProgramsParticleFilter<N> {
    pub fn new(seed: u32, spread: f32) -> Self {
        let mut rng = FoundProgramsParticleRng::new(seed);
        let particles = core::array::from_fn(|_| FoundProgramsParticleParticle { x: spread * (rng.uniform() - 0.5), w: 1.0 / N as f32 });
        Self { particles, rng }
    }

    pub fn step(&mut self, u: f32, z: f32, noise: f32) -> Option<f32> {
        let Self { particles, rng } = self;
        for FoundProgramsParticleParticle { x, w } in particles.iter_mut() {
            *x += u + noise * rng.gauss();
            let e = (z - *x) / 0.5;
            *w *= (-0.5 * e * e).exp();
        }
        let total: f32 = particles.iter().map(|p| p.w).sum();
        if !(total > f32::MIN_POSITIVE) {
            return None;
        }
        particles.iter_mut().for_each(|p| p.w /= total);
        let n_eff = particles.iter().map(|p| p.w * p.w).sum::<f32>().recip();
        if n_eff < N as f32 / 2.0 {
            self.resample();
        }
        Some(self.particles.iter().map(|p| p.x * p.w).sum())
    }

    fn resample(&mut self) {
        let old = self.particles;
        let step = 1.0 / N as f32;
        let mut target = self.rng.uniform() * step;
        let mut sum = old[0].w;
        let mut i = 0;
        for p in &mut self.particles {
            while sum < target && i + 1 < N {
                i += 1;
                sum += old[i].w;
            }
            *p = FoundProgramsParticleParticle { w: step, ..old[i] };
            target += step;
        }
    }
}

#[function]
pub fn found_programs_particle(seed: u32, us: [f32; 3], zs: [f32; 3]) -> ([Option<f32>; 3], f32) {
    let mut pf = FoundProgramsParticleFilter::<10>::new(seed, 4.0);
    let mut out = [None; 3];
    for (i, slot) in out.iter_mut().enumerate() {
        *slot = pf.step(us[i], zs[i], 0.1);
    }
    (out, pf.particles.iter().map(|p| p.x).fold(f32::INFINITY, f32::min))
}
/// Result-based error enums with From, `?` and map_err.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FoundProgramsErrorsBusError {
    Nack(u8),
    Timeout,
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FoundProgramsErrorsSensorError {
    FoundProgramsErrorsBus(FoundProgramsErrorsBusError),
    Id { expected: u8, found: u8 },
    OutOfRange(f32),
    Stale,
}

#[data]
impl From<FoundProgramsErrorsBusError> for FoundProgramsErrorsSensorError {
    fn from(e: FoundProgramsErrorsBusError) -> Self {
        match e {
            FoundProgramsErrorsBusError::Timeout => Self::Stale,
            other => Self::FoundProgramsErrorsBus(other),
        }
    }
}

#[interface]
pub trait FoundProgramsErrorsBus {
    fn read(&mut self, reg: u8) -> Result<u8, FoundProgramsErrorsBusError>;

    fn read_u16(&mut self, reg: u8) -> Result<u16, FoundProgramsErrorsBusError> {
        let [hi, lo] = [self.read(reg)?, self.read(reg + 1)?];
        Ok(u16::from_be_bytes([hi, lo]))
    }
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundProgramsErrorsFake {
    regs: [u8; 8],
    fail_at: u8,
    reads: u8,
}

#[data]
impl FoundProgramsErrorsBus for FoundProgramsErrorsFake {
    fn read(&mut self, reg: u8) -> Result<u8, FoundProgramsErrorsBusError> {
        self.reads = self.reads.wrapping_add(1);
        if self.reads == self.fail_at {
            return Err(FoundProgramsErrorsBusError::Timeout);
        }
        self.regs.get(reg as usize).copied().ok_or(FoundProgramsErrorsBusError::Nack(reg))
    }
}

type FoundProgramsErrorsOutcome<T> = Result<T, FoundProgramsErrorsSensorError>;

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundProgramsErrorsThermometer<B> {
    bus: B,
    offset: f32,
}

#[data]
impl<B: FoundProgramsErrorsBus> FoundProgramsErrorsThermometer<B> {
    const ID: u8 = 0x5A;

    fn open(mut bus: B, offset: f32) -> FoundProgramsErrorsOutcome<Self> {
        let found = bus.read(0)?;
        if found & 0x0F != Self::ID & 0x0F {
            return Err(FoundProgramsErrorsSensorError::Id { expected: Self::ID, found });
        }
        Ok(Self { bus, offset })
    }

    fn celsius(&mut self) -> FoundProgramsErrorsOutcome<f32> {
        let raw = self.bus.read_u16(2).map_err(|e| match e {
            FoundProgramsErrorsBusError::Nack(r) => FoundProgramsErrorsSensorError::FoundProgramsErrorsBus(FoundProgramsErrorsBusError::Nack(r | 0x80)),
            e => e.into(),
        })?;
        let t = f32::from(raw as i16) / 128.0 + self.offset;
        (-40.0..=125.0).contains(&t).then_some(t).ok_or(FoundProgramsErrorsSensorError::OutOfRange(t))
    }
}

#[function]
pub fn found_programs_errors(regs: [u8; 8], fail_at: u8, offset: f32) -> (f32, u8) {
    let outcome = FoundProgramsErrorsThermometer::open(FoundProgramsErrorsFake { regs, fail_at: fail_at & 7, reads: 0 }, offset)
        .and_then(|mut t| {
            let first = t.celsius()?;
            let second = t.celsius().or_else(|e| if e == FoundProgramsErrorsSensorError::Stale { Ok(first) } else { Err(e) })?;
            Ok(0.5 * (first + second))
        });
    match outcome {
        Ok(t) => (t, 0),
        Err(FoundProgramsErrorsSensorError::FoundProgramsErrorsBus(FoundProgramsErrorsBusError::Nack(r))) => (0.0, r),
        Err(FoundProgramsErrorsSensorError::Id { expected, found }) => (0.0, expected ^ found),
        Err(FoundProgramsErrorsSensorError::OutOfRange(t)) if t.is_nan() => (0.0, 1),
        Err(FoundProgramsErrorsSensorError::OutOfRange(t)) => (t, 2),
        Err(e) => (0.0, if e == FoundProgramsErrorsSensorError::Stale { 3 } else { 4 }),
    }
}
