/* The C of blocks/src/windows.rs. Written by a test. */

/* decimator_f32_5.c */

void decimator_f32_5_init(decimator_f32_5_t *self)
{
    for (uint32_t i = 0U; i < 5U; i++) {
        self->samples[i] = 0.0F;
    }
    self->newest = 0U;
    self->wait = 0U;
}

void decimator_f32_5_step(decimator_f32_5_t *BESSEMER_RESTRICT self, const float taps[5],
    uint32_t factor, float sample, option_f32_t *BESSEMER_RESTRICT result)
{
    self->newest = ((self->newest % 5U) + 1U) % 5U;
    self->samples[self->newest] = sample;
    if (self->wait > 0U) {
        self->wait -= 1U;
        *result = (option_f32_t){.is_some = false};
        return;
    }
    self->wait = saturating_sub_u32(factor, 1U);
    float sum = 0.0F;
    uint32_t index = self->newest;
    for (uint32_t i = 0U; i < 5U; i++) {
        const uint32_t here = min_u32(index, 5U - 1U);
        sum += taps[i] * self->samples[here];
        if (here == 0U) {
            index = 5U - 1U;
        } else {
            index = here - 1U;
        }
    }
    result->is_some = true;
    result->value = sum;
}

/* decimator_f32_5.h */

/**
 * Decimator: a low-pass with a finite impulse response whose output is computed for one sample in `factor`.
 *
 * The first output comes with the first sample. The taps remove what lies above half of the lower rate.
 * Initialisation: `Default` has zeros. Nothing saturates.
 *
 * ```
 * let mut decimator = bessemer_blocks::Decimator::<f32, 2>::default();
 * let outputs = [2.0, 4.0, 6.0].map(|sample| decimator.step(&[0.5, 0.5], 2, sample));
 * assert_eq!(outputs, [Some(1.0), None, Some(5.0)]);
 * ```
 */
typedef struct {
    /** The last samples. */
    float samples[5];
    /** Index of the newest. */
    uint32_t newest;
    /** Number of samples before the next output. */
    uint32_t wait;
} decimator_f32_5_t;

/* fir_f32_5.c */

void fir_f32_5_init(fir_f32_5_t *self)
{
    for (uint32_t i = 0U; i < 5U; i++) {
        self->samples[i] = 0.0F;
    }
}

float fir_f32_5_step(fir_f32_5_t *BESSEMER_RESTRICT self, const float taps[5], float sample)
{
    float sum = 0.0F;
    for (uint32_t k = 5U; k-- > 1U;) {
        self->samples[k] = self->samples[k - 1U];
        sum += taps[k] * self->samples[k];
    }
    self->samples[0] = sample;
    return sum + taps[0] * sample;
}

/* fir_f32_5.h */

/**
 * Filter with a finite impulse response: y(k) = Σ taps[i] u(k−i), i from 0 to N − 1.
 *
 * The sum begins with the oldest sample. Initialisation: `Default` has zeros. Nothing saturates.
 *
 * ```
 * let mut filter = bessemer_blocks::Fir::<f64, 3>::default();
 * let taps = [0.5, 0.25, 0.125];
 * assert_eq!([8.0, 0.0, 0.0, 0.0].map(|sample| filter.step(&taps, sample)), [4.0, 2.0, 1.0, 0.0]);
 * ```
 */
typedef struct {
    /** The last samples, newest first. */
    float samples[5];
} fir_f32_5_t;

/* moving_f32_8.c */

static void moving_f32_8_take(moving_f32_8_t *self, float sample);
static float moving_f32_8_mean(const moving_f32_8_t *self);

void moving_f32_8_init(moving_f32_8_t *self)
{
    for (uint32_t i = 0U; i < 8U; i++) {
        self->samples[i] = 0.0F;
    }
    self->oldest = 0U;
    self->filled = false;
}

void moving_f32_8_spread(moving_f32_8_t *BESSEMER_RESTRICT self, float sample,
    spread_f32_t *BESSEMER_RESTRICT spread)
{
    moving_f32_8_take(self, sample);
    const float mean = moving_f32_8_mean(self);
    float sum = 0.0F;
    for (uint32_t i = 0U; i < 8U; i++) {
        const float off = self->samples[i] - mean;
        sum += off * off;
    }
    const float variance = sum / (8.0F - 1.0F);
    spread->mean = mean;
    spread->variance = variance;
}

/** Replaces the oldest sample. */
static void moving_f32_8_take(moving_f32_8_t *self, float sample)
{
    if (!self->filled) {
        for (uint32_t i = 0U; i < 8U; i++) {
            self->samples[i] = sample;
        }
        self->filled = true;
    }
    const uint32_t oldest = self->oldest % 8U;
    self->samples[oldest] = sample;
    self->oldest = (oldest + 1U) % 8U;
}

/** Returns the mean of the window. */
static float moving_f32_8_mean(const moving_f32_8_t *self)
{
    float sum = 0.0F;
    for (uint32_t i = 0U; i < 8U; i++) {
        sum += self->samples[i];
    }
    return sum / 8.0F;
}

/* moving_f32_8.h */

/**
 * Moving average and variance of the last N samples of unit U.
 *
 * Each step adds up the window, so no rounding error remains in the state. Initialisation: the first sample fills
 * the window. Nothing saturates.
 *
 * ```
 * use bessemer_blocks::{Moving, Spread};
 *
 * let mut moving = Moving::<f32, 4>::default();
 * assert_eq!(moving.average(2.0), 2.0);
 * assert_eq!(moving.average(6.0), 3.0);
 * assert_eq!(moving.spread(6.0), Spread { mean: 4.0, variance: 16.0 / 3.0 });
 * ```
 */
typedef struct {
    /** The samples, of which the oldest is replaced next. */
    float samples[8];
    /** Index of the oldest. */
    uint32_t oldest;
    /** True after the first sample. */
    bool filled;
} moving_f32_8_t;

/* moving_f64_3.c */

static void moving_f64_3_take(moving_f64_3_t *self, double sample);
static double moving_f64_3_mean(const moving_f64_3_t *self);

void moving_f64_3_init(moving_f64_3_t *self)
{
    self->samples[0] = 0.0;
    self->samples[1] = 0.0;
    self->samples[2] = 0.0;
    self->oldest = 0U;
    self->filled = false;
}

double moving_f64_3_average(moving_f64_3_t *self, double sample)
{
    moving_f64_3_take(self, sample);
    return moving_f64_3_mean(self);
}

/** Replaces the oldest sample. */
static void moving_f64_3_take(moving_f64_3_t *self, double sample)
{
    if (!self->filled) {
        self->samples[0] = sample;
        self->samples[1] = sample;
        self->samples[2] = sample;
        self->filled = true;
    }
    const uint32_t oldest = self->oldest % 3U;
    self->samples[oldest] = sample;
    self->oldest = (oldest + 1U) % 3U;
}

/** Returns the mean of the window. */
static double moving_f64_3_mean(const moving_f64_3_t *self)
{
    double sum = 0.0;
    for (uint32_t i = 0U; i < 3U; i++) {
        sum += self->samples[i];
    }
    return sum / 3.0;
}

/* moving_f64_3.h */

/**
 * Moving average and variance of the last N samples of unit U.
 *
 * Each step adds up the window, so no rounding error remains in the state. Initialisation: the first sample fills
 * the window. Nothing saturates.
 *
 * ```
 * use bessemer_blocks::{Moving, Spread};
 *
 * let mut moving = Moving::<f32, 4>::default();
 * assert_eq!(moving.average(2.0), 2.0);
 * assert_eq!(moving.average(6.0), 3.0);
 * assert_eq!(moving.spread(6.0), Spread { mean: 4.0, variance: 16.0 / 3.0 });
 * ```
 */
typedef struct {
    /** The samples, of which the oldest is replaced next. */
    double samples[3];
    /** Index of the oldest. */
    uint32_t oldest;
    /** True after the first sample. */
    bool filled;
} moving_f64_3_t;

/* windows.h */

/** Mean and variance of a window. */
typedef struct {
    /** The mean, U. */
    float mean;
    /** The unbiased variance, U²: divided by N − 1; 0 for N = 1. */
    float variance;
} spread_f32_t;
