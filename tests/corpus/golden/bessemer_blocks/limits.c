/* The C of blocks/src/limits.rs. Written by a test. */

/* bessemer_blocks_limits.c */

double bessemer_blocks_limits_fastest_f64(double away, double rate, double most, double period)
{
    const double half = 0.5;
    const double d = most * period * period;
    const double ahead = period * rate;
    const double y = away + ahead;
    const double root = sqrt(d * (d + 8.0 * fabs(y)));
    double a;
    if (fabs(y) <= d) {
        a = ahead + y;
    } else {
        a = ahead + half * copysign_f64(root - d, y);
    }
    if (fabs(a) <= d) {
        return -most * a / d;
    } else {
        return -copysign_f64(most, a);
    }
}

void bessemer_blocks_limits_saturated_f32(float value, float low, float high,
    saturated_f32_t *saturated)
{
    const float limited = min_f32(max_f32(value, low), high);
    saturated->value = limited;
    saturated->is_low = value < low || isnan(value) != 0;
    saturated->is_high = value > high;
}

float bessemer_blocks_limits_dead_band_f32(float value, float width)
{
    if (value > width) {
        return value - width;
    } else if (value < -width) {
        return value + width;
    } else {
        return 0.0F;
    }
}

/* bessemer_blocks_limits.h */

/** Limits of a `RateLimiter`: of the signal's unit (U) and s. */
typedef struct {
    /** Fastest rise, 0 or more, U/s. */
    float rise;
    /** Fastest fall, 0 or more, U/s. */
    float fall;
    /** Period h, above 0. Unit: s. */
    float period;
} rate_limits_f32_t;

/** Limits of a `JerkLimiter`: of the signal's unit (U) and s. All are above 0. */
typedef struct {
    /** Fastest change of the signal, U/s. */
    double rate;
    /** Fastest change of its rate, U/s². */
    double acceleration;
    /** Period h. Unit: s. */
    double period;
} jerk_limits_f64_t;

/** A signal and its rate. */
typedef struct {
    /** The signal, U. */
    double value;
    /** Its rate of change, U/s. */
    double rate;
} motion_f64_t;

/** A limited value, and the limit that it is at. */
typedef struct {
    /** The limited value. */
    float value;
    /** True if the value was below the lower limit, or NaN. */
    bool is_low;
    /** True if the value was above the upper limit. */
    bool is_high;
} saturated_f32_t;

/* hysteresis.c */

void hysteresis_init(hysteresis_t *self)
{
    self->is_on = false;
}

bool hysteresis_step_f32(hysteresis_t *self, float on, float off, float value)
{
    if (value >= on) {
        self->is_on = true;
    } else if (value <= off) {
        self->is_on = false;
    } else {
        /* Nothing. */
    }
    return self->is_on;
}

bool hysteresis_step_f64(hysteresis_t *self, double on, double off, double value)
{
    if (value >= on) {
        self->is_on = true;
    } else if (value <= off) {
        self->is_on = false;
    } else {
        /* Nothing. */
    }
    return self->is_on;
}

/* hysteresis.h */

/**
 * Hysteresis (a Schmitt trigger): on at `on` and above, off at `off` and below, unchanged between.
 *
 * Initialisation: `Default` is off. Range: `on` is above `off`. NaN changes nothing.
 *
 * ```
 * let mut heater_off = bessemer_blocks::Hysteresis::default();
 * let levels = [20.0, 22.5, 21.0, 19.0].map(|level| heater_off.step(22.0, 20.0, level));
 * assert_eq!(levels, [false, true, true, false]);
 * ```
 */
typedef struct {
    /** The last output. */
    bool is_on;
} hysteresis_t;

/* jerk_limiter_f64.c */

void jerk_limiter_f64_init(jerk_limiter_f64_t *self)
{
    self->motion.value = 0.0;
    self->motion.rate = 0.0;
}

void jerk_limiter_f64_step(jerk_limiter_f64_t *BESSEMER_RESTRICT self,
    const jerk_limits_f64_t *limits, double target, motion_f64_t *BESSEMER_RESTRICT motion)
{
    const double period = limits->period;
    const double value = self->motion.value;
    const double rate = self->motion.rate;
    double away;
    if (isfinite(target) != 0) {
        away = value - target;
    } else {
        away = 0.0;
    }
    const double change = bessemer_blocks_limits_fastest_f64(away, rate, limits->acceleration,
        period);
    const double next = rate + period * change;
    self->motion.value = value + period * rate;
    self->motion.rate = min_f64(max_f64(next, -limits->rate), limits->rate);
    *motion = self->motion;
}

void jerk_limiter_f64_preset(jerk_limiter_f64_t *self, double value)
{
    self->motion.value = value;
    self->motion.rate = 0.0;
}

/* jerk_limiter_f64.h */

/**
 * Jerk limiter: follows a target with a limited rate and a limited change of the rate. The overshoot is less than
 * acceleration · h².
 *
 * For a set point of acceleration, the change of its rate is the jerk's; for a position, it is the acceleration. The
 * rate changes by h·fhan(y − target, rate), Han's time-optimal control of a double integrator in discrete time, then
 * it is limited: rate(k) = rate(k−1) + h·fhan, y(k) = y(k−1) + h·rate(k−1).
 *
 * Initialisation: `Default` rests at 0, `JerkLimiter::preset` at a value. A target that is not finite
 * is replaced by the last output. Source: Han, *From PID to Active Disturbance Rejection Control*, IEEE Transactions
 * on Industrial Electronics 56 (3), 2009, equation (20).
 *
 * ```
 * use bessemer_blocks::{JerkLimiter, JerkLimits};
 *
 * let limits = JerkLimits { rate: 1.0, acceleration: 2.0, period: 0.01 };
 * let mut limiter = JerkLimiter::default();
 * let highest = (0..1000).map(|_| limiter.step(&limits, 3.0).value).fold(0.0, f64::max);
 * assert!((highest - 3.0).abs() < 1e-6);
 * ```
 */
typedef struct {
    /** The last output. */
    motion_f64_t motion;
} jerk_limiter_f64_t;

/* rate_limiter_f32.c */

void rate_limiter_f32_init(rate_limiter_f32_t *self)
{
    self->output = 0.0F;
}

float rate_limiter_f32_step(rate_limiter_f32_t *BESSEMER_RESTRICT self,
    const rate_limits_f32_t *limits, float target)
{
    const float highest = self->output + limits->rise * limits->period;
    const float lowest = self->output - limits->fall * limits->period;
    if (target > highest) {
        self->output = highest;
    } else if (target < lowest) {
        self->output = lowest;
    } else if (isfinite(target) != 0) {
        self->output = target;
    } else {
        /* Nothing. */
    }
    return self->output;
}

void rate_limiter_f32_preset(rate_limiter_f32_t *self, float output)
{
    self->output = output;
}

/* rate_limiter_f32.h */

/**
 * Rate limiter: y(k) is the target, at most h·rise above and h·fall below y(k−1).
 *
 * Initialisation: `Default` begins at 0, `RateLimiter::preset` at a value. A target that is NaN changes
 * nothing; an infinite one is approached at the limit.
 *
 * ```
 * use bessemer_blocks::{RateLimiter, RateLimits};
 *
 * let limits = RateLimits { rise: 2.0, fall: 10.0, period: 0.5 };
 * let mut limiter = RateLimiter::default();
 * assert_eq!([1.5, 1.5, -9.0].map(|target| limiter.step(&limits, target)), [1.0, 1.5, -3.5]);
 * ```
 */
typedef struct {
    /** The last output. */
    float output;
} rate_limiter_f32_t;
