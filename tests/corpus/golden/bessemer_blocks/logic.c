/* The C of blocks/src/logic.rs. Written by a test. */

/* logic.c */

float logic_median_f32(float a, float b, float c)
{
    return max_f32(min_f32(a, b), min_f32(max_f32(a, b), c));
}

double logic_median_f64(double a, double b, double c)
{
    return max_f64(min_f64(a, b), min_f64(max_f64(a, b), c));
}

float logic_middle_f32(float a, float b)
{
    if (isfinite(a) == 0) {
        return b;
    } else if (isfinite(b) == 0) {
        return a;
    } else {
        return 0.5F * (a + b);
    }
}

double logic_middle_f64(double a, double b)
{
    if (isfinite(a) == 0) {
        return b;
    } else if (isfinite(b) == 0) {
        return a;
    } else {
        return 0.5 * (a + b);
    }
}

/* logic.h */

/** Debounced contact, and its edges. */
typedef struct {
    /** The debounced level. */
    bool is_on;
    /** True in the period in which the level became true. */
    bool rose;
    /** True in the period in which the level became false. */
    bool fell;
} logic_contact_t;

/** Limits of a `Voter`. */
typedef struct {
    /** Largest difference between a good sensor and the vote, 0 or more, in the sensors' unit. */
    float tolerance;
    /** Number of periods in a row with a larger difference after which a sensor has failed. */
    uint32_t periods;
} voter_limits_f32_t;

/** Limits of a `Voter`. */
typedef struct {
    /** Largest difference between a good sensor and the vote, 0 or more, in the sensors' unit. */
    double tolerance;
    /** Number of periods in a row with a larger difference after which a sensor has failed. */
    uint32_t periods;
} voter_limits_f64_t;

/** Result of a vote. */
typedef struct {
    /** The voted value, in the sensors' unit. It keeps its value when no sensor is left. */
    float value;
    /** Number of sensors that have not failed. */
    uint8_t good;
    /**
     * True if two sensors are left that differ by more than twice the tolerance: the value is their mean.
     */
    bool is_doubtful;
} vote_f32_t;

/** Result of a vote. */
typedef struct {
    /** The voted value, in the sensors' unit. It keeps its value when no sensor is left. */
    double value;
    /** Number of sensors that have not failed. */
    uint8_t good;
    /**
     * True if two sensors are left that differ by more than twice the tolerance: the value is their mean.
     */
    bool is_doubtful;
} vote_f64_t;

/* logic_debounce.c */

void debounce_init(debounce_t *self)
{
    self->is_on = false;
    self->different = 0U;
}

void debounce_step(debounce_t *BESSEMER_RESTRICT self, uint32_t periods, bool contact,
    logic_contact_t *BESSEMER_RESTRICT result)
{
    if (contact == self->is_on) {
        self->different = 0U;
    } else {
        self->different = saturating_add_u32(self->different, 1U);
    }
    const bool changed = self->different > 0U && self->different >= periods;
    if (changed) {
        self->is_on = contact;
        self->different = 0U;
    }
    result->is_on = self->is_on;
    result->rose = changed && contact;
    result->fell = changed && !contact;
}

/* logic_debounce.h */

/**
 * Debounce: the level changes after the contact had the other level for `periods` periods in a row.
 *
 * Initialisation: `Default` is off. A number of 0 means 1: the level follows at once.
 *
 * ```
 * let mut debounce = bessemer_blocks::Debounce::default();
 * let levels = [true, false, true, true, true].map(|contact| debounce.step(3, contact).is_on);
 * assert_eq!(levels, [false, false, false, false, true]);
 * ```
 */
typedef struct {
    /** The debounced level. */
    bool is_on;
    /** Periods for which the contact has had the other level. */
    uint32_t different;
} debounce_t;

/* timer.c */

void logic_timer_init(logic_timer_t *self)
{
    self->elapsed = 0U;
}

bool logic_timer_step(logic_timer_t *self, uint32_t periods, bool waiting)
{
    if (waiting) {
        self->elapsed = saturating_add_u32(self->elapsed, 1U);
    } else {
        self->elapsed = 0U;
    }
    return waiting && self->elapsed >= periods;
}

uint32_t logic_timer_elapsed(const logic_timer_t *self)
{
    return self->elapsed;
}

/* timer.h */

/**
 * Timer with an on delay, the TON of IEC 61131-3.
 *
 * The output is true as soon as the input has been true for `periods` periods, until the input is false.
 * It is a timeout, too: the input is the waiting. Initialisation: `Default` has waited for no period. The count
 * saturates at 2³² − 1 periods.
 *
 * ```
 * let mut timer = bessemer_blocks::Timer::default();
 * assert_eq!([true, true, true, false].map(|waiting| timer.step(2, waiting)), [false, true, true, false]);
 * ```
 */
typedef struct {
    /** Periods for which the input has been true. */
    uint32_t elapsed;
} logic_timer_t;

/* voter_f32.c */

void voter_f32_init(voter_f32_t *self)
{
    self->value = 0.0F;
    self->wrong[0] = 0U;
    self->wrong[1] = 0U;
    self->wrong[2] = 0U;
    self->failed[0] = false;
    self->failed[1] = false;
    self->failed[2] = false;
}

void voter_f32_step(voter_f32_t *BESSEMER_RESTRICT self, const voter_limits_f32_t *limits,
    const float sensors[3], vote_f32_t *BESSEMER_RESTRICT vote)
{
    const float a = sensors[0];
    const float b = sensors[1];
    const float c = sensors[2];
    bool is_doubtful = false;
    float vote_value;
    if (!self->failed[0] && !self->failed[1] && !self->failed[2]) {
        vote_value = logic_median_f32(a, b, c);
    } else if (self->failed[0] && !self->failed[1] && !self->failed[2]) {
        vote_value = logic_middle_f32(b, c);
    } else if (!self->failed[0] && self->failed[1] && !self->failed[2]) {
        vote_value = logic_middle_f32(a, c);
    } else if (!self->failed[0] && !self->failed[1] && self->failed[2]) {
        vote_value = logic_middle_f32(a, b);
    } else if (!self->failed[0] && self->failed[1] && self->failed[2]) {
        vote_value = a;
    } else if (self->failed[0] && !self->failed[1] && self->failed[2]) {
        vote_value = b;
    } else if (self->failed[0] && self->failed[1] && !self->failed[2]) {
        vote_value = c;
    } else {
        vote_value = self->value;
    }
    if (isfinite(vote_value) != 0) {
        self->value = vote_value;
    }
    int32_t left = 0;
    for (uint32_t i = 0U; i < 3U; i++) {
        if (!self->failed[i]) {
            left += 1;
        }
    }
    uint8_t good = 0U;
    for (uint32_t i = 0U; i < 3U; i++) {
        const float sensor = sensors[i];
        const float off = fabsf(sensor - self->value);
        const bool is_wrong = off > limits->tolerance || isnan(off) != 0;
        if (left == 2 && !self->failed[i] && is_wrong && isfinite(sensor) != 0) {
            /* Two that differ: neither is known to be the wrong one. */
            is_doubtful = true;
            self->wrong[i] = 0U;
        } else if (is_wrong) {
            self->wrong[i] = saturating_add_u32(self->wrong[i], 1U);
        } else {
            self->wrong[i] = 0U;
        }
        if (self->wrong[i] >= max_u32(limits->periods, 1U)) {
            self->failed[i] = true;
        }
        if (!self->failed[i]) {
            good = (uint8_t)(good + 1U);
        }
    }
    vote->value = self->value;
    vote->good = good;
    vote->is_doubtful = is_doubtful;
}

void voter_f32_reset(voter_f32_t *self)
{
    self->wrong[0] = 0U;
    self->wrong[1] = 0U;
    self->wrong[2] = 0U;
    self->failed[0] = false;
    self->failed[1] = false;
    self->failed[2] = false;
}

/* voter_f32.h */

/**
 * Voter of three sensors: the median of three, the mean of two, the last one.
 *
 * A sensor fails after `periods` periods in a row in which it differs from the vote by more than the
 * tolerance, or is NaN or infinite; it stays failed. The last sensor fails by a value that is not finite only.
 * Initialisation: `Default` trusts all three, with the value 0.
 *
 * ```
 * use bessemer_blocks::{Voter, VoterLimits};
 *
 * let limits = VoterLimits { tolerance: 0.5, periods: 2 };
 * let mut voter = Voter::default();
 * assert_eq!(voter.step(&limits, [1.0, 1.2, 9.0]).value, 1.2);
 * let vote = voter.step(&limits, [1.0, 1.2, 9.0]);
 * assert_eq!((vote.value, vote.good), (1.2, 2));
 * assert_eq!(voter.step(&limits, [1.0, 1.5, 9.0]).value, 1.25);
 * ```
 */
typedef struct {
    /** The last vote. */
    float value;
    /** Periods in a row in which each sensor differed. */
    uint32_t wrong[3];
    /** True for each sensor that has failed. */
    bool failed[3];
} voter_f32_t;

/* voter_f64.c */

void voter_f64_init(voter_f64_t *self)
{
    self->value = 0.0;
    self->wrong[0] = 0U;
    self->wrong[1] = 0U;
    self->wrong[2] = 0U;
    self->failed[0] = false;
    self->failed[1] = false;
    self->failed[2] = false;
}

void voter_f64_step(voter_f64_t *BESSEMER_RESTRICT self, const voter_limits_f64_t *limits,
    const double sensors[3], vote_f64_t *BESSEMER_RESTRICT vote)
{
    const double a = sensors[0];
    const double b = sensors[1];
    const double c = sensors[2];
    bool is_doubtful = false;
    double vote_value;
    if (!self->failed[0] && !self->failed[1] && !self->failed[2]) {
        vote_value = logic_median_f64(a, b, c);
    } else if (self->failed[0] && !self->failed[1] && !self->failed[2]) {
        vote_value = logic_middle_f64(b, c);
    } else if (!self->failed[0] && self->failed[1] && !self->failed[2]) {
        vote_value = logic_middle_f64(a, c);
    } else if (!self->failed[0] && !self->failed[1] && self->failed[2]) {
        vote_value = logic_middle_f64(a, b);
    } else if (!self->failed[0] && self->failed[1] && self->failed[2]) {
        vote_value = a;
    } else if (self->failed[0] && !self->failed[1] && self->failed[2]) {
        vote_value = b;
    } else if (self->failed[0] && self->failed[1] && !self->failed[2]) {
        vote_value = c;
    } else {
        vote_value = self->value;
    }
    if (isfinite(vote_value) != 0) {
        self->value = vote_value;
    }
    int32_t left = 0;
    for (uint32_t i = 0U; i < 3U; i++) {
        if (!self->failed[i]) {
            left += 1;
        }
    }
    uint8_t good = 0U;
    for (uint32_t i = 0U; i < 3U; i++) {
        const double sensor = sensors[i];
        const double off = fabs(sensor - self->value);
        const bool is_wrong = off > limits->tolerance || isnan(off) != 0;
        if (left == 2 && !self->failed[i] && is_wrong && isfinite(sensor) != 0) {
            /* Two that differ: neither is known to be the wrong one. */
            is_doubtful = true;
            self->wrong[i] = 0U;
        } else if (is_wrong) {
            self->wrong[i] = saturating_add_u32(self->wrong[i], 1U);
        } else {
            self->wrong[i] = 0U;
        }
        if (self->wrong[i] >= max_u32(limits->periods, 1U)) {
            self->failed[i] = true;
        }
        if (!self->failed[i]) {
            good = (uint8_t)(good + 1U);
        }
    }
    vote->value = self->value;
    vote->good = good;
    vote->is_doubtful = is_doubtful;
}

/* voter_f64.h */

/**
 * Voter of three sensors: the median of three, the mean of two, the last one.
 *
 * A sensor fails after `periods` periods in a row in which it differs from the vote by more than the
 * tolerance, or is NaN or infinite; it stays failed. The last sensor fails by a value that is not finite only.
 * Initialisation: `Default` trusts all three, with the value 0.
 *
 * ```
 * use bessemer_blocks::{Voter, VoterLimits};
 *
 * let limits = VoterLimits { tolerance: 0.5, periods: 2 };
 * let mut voter = Voter::default();
 * assert_eq!(voter.step(&limits, [1.0, 1.2, 9.0]).value, 1.2);
 * let vote = voter.step(&limits, [1.0, 1.2, 9.0]);
 * assert_eq!((vote.value, vote.good), (1.2, 2));
 * assert_eq!(voter.step(&limits, [1.0, 1.5, 9.0]).value, 1.25);
 * ```
 */
typedef struct {
    /** The last vote. */
    double value;
    /** Periods in a row in which each sensor differed. */
    uint32_t wrong[3];
    /** True for each sensor that has failed. */
    bool failed[3];
} voter_f64_t;

/* watchdog.c */

static const watchdog_t WATCHDOG_DEFAULT = {.silent = 0U, .tripped = false};

void watchdog_init(watchdog_t *self)
{
    self->silent = 0U;
    self->tripped = false;
}

bool watchdog_step(watchdog_t *self, uint32_t periods, bool alive)
{
    if (alive) {
        self->silent = 0U;
    } else {
        self->silent = saturating_add_u32(self->silent, 1U);
    }
    self->tripped = self->tripped || self->silent > periods;
    return self->tripped;
}

void watchdog_reset(watchdog_t *self)
{
    *self = WATCHDOG_DEFAULT;
}

/* watchdog.h */

/**
 * Watchdog: trips after more than `periods` periods in a row without a sign of life, and stays so until a reset.
 *
 * Initialisation: `Default` counts from 0, so a peer that never reports trips it.
 *
 * ```
 * let mut watchdog = bessemer_blocks::Watchdog::default();
 * let tripped = [true, false, false, true].map(|alive| watchdog.step(1, alive));
 * assert_eq!(tripped, [false, false, true, true]);
 * watchdog.reset();
 * assert!(!watchdog.step(1, true));
 * ```
 */
typedef struct {
    /** Periods since the last sign of life. */
    uint32_t silent;
    /** True after a timeout, until a reset. */
    bool tripped;
} watchdog_t;
