/* The C of tests/corpus/src/programs/functions/own_operators.rs. Written by a test. */

/* own_operators.c */

static const phasor_t PHASOR_DEFAULT = {.re = 0.0, .im = 0.0};

void phasor_add(const phasor_t *self, const phasor_t *other, phasor_t *BESSEMER_RESTRICT phasor)
{
    phasor->re = self->re + other->re;
    phasor->im = self->im + other->im;
}

void phasor_sub(const phasor_t *self, const phasor_t *other, phasor_t *BESSEMER_RESTRICT phasor)
{
    phasor_t phasor_other;
    phasor_neg(other, &phasor_other);
    phasor_add(self, &phasor_other, phasor);
}

void phasor_mul(const phasor_t *self, const phasor_t *other, phasor_t *BESSEMER_RESTRICT phasor)
{
    phasor->re = self->re * other->re - self->im * other->im;
    phasor->im = self->re * other->im + self->im * other->re;
}

void phasor_mul_f64(const phasor_t *self, double factor, phasor_t *BESSEMER_RESTRICT phasor)
{
    phasor->re = self->re * factor;
    phasor->im = self->im * factor;
}

void phasor_mul_i32(const phasor_t *self, int32_t count, phasor_t *BESSEMER_RESTRICT phasor)
{
    phasor_mul_f64(self, (double)count, phasor);
}

void phasor_div_f64(const phasor_t *self, double divisor, phasor_t *BESSEMER_RESTRICT phasor)
{
    phasor->re = self->re / divisor;
    phasor->im = self->im / divisor;
}

void phasor_neg(const phasor_t *self, phasor_t *BESSEMER_RESTRICT phasor)
{
    phasor->re = -self->re;
    phasor->im = -self->im;
}

void phasor_add_assign(phasor_t *BESSEMER_RESTRICT self, const phasor_t *other)
{
    self->re += other->re;
    self->im += other->im;
}

void phasor_mul_assign_f64(phasor_t *self, double factor)
{
    phasor_t self_next;
    phasor_mul_f64(self, factor, &self_next);
    *self = self_next;
}

void phasor_from_f64(double re, phasor_t *phasor)
{
    phasor->re = re;
    phasor->im = 0.0;
}

void phasor_from_pair_f64_f64(const pair_f64_f64_t *parts, phasor_t *BESSEMER_RESTRICT phasor)
{
    const double re = parts->first;
    const double im = parts->second;
    phasor->re = re;
    phasor->im = im;
}

void own_operators_phase_try_from_u8(uint8_t letter, result_own_operators_phase_unknown_t *result)
{
    switch (letter) {
    case 65U:
        result->is_ok = true;
        result->as.value = OWN_OPERATORS_PHASE_A;
        break;
    case 66U:
        result->is_ok = true;
        result->as.value = OWN_OPERATORS_PHASE_B;
        break;
    case 67U:
        result->is_ok = true;
        result->as.value = OWN_OPERATORS_PHASE_C;
        break;
    default:
        result->is_ok = false;
        result->as.error.value = letter;
        break;
    }
}

void own_operators_parallel(const phasor_t *a, const phasor_t *b,
    phasor_t *BESSEMER_RESTRICT phasor)
{
    phasor_t product;
    phasor_mul(a, b, &product);
    phasor_t sum;
    phasor_add(a, b, &sum);
    const double length = sum.re * sum.re + sum.im * sum.im;
    const phasor_t conjugate = {.re = sum.re, .im = -sum.im};
    phasor_t phasor_self;
    phasor_mul(&product, &conjugate, &phasor_self);
    phasor_div_f64(&phasor_self, length, phasor);
}

void own_operators_weighted(const phasor_t currents[3], double factor,
    phasor_t *BESSEMER_RESTRICT phasor)
{
    phasor_t sum = PHASOR_DEFAULT;
    for (uint32_t i = 0U; i < 3U; i++) {
        const phasor_t current = currents[i];
        phasor_t other;
        phasor_mul_f64(&current, factor, &other);
        phasor_add_assign(&sum, &other);
    }
    phasor_mul_assign_f64(&sum, 0.5);
    phasor_sub(&sum, &currents[0], phasor);
}

void own_operators_made(double re, double im, phasor_t *phasor)
{
    phasor_t real;
    phasor_from_f64(re, &real);
    const pair_f64_f64_t phasor_parts = {.first = 0.0, .second = im};
    phasor_t phasor_self;
    phasor_from_pair_f64_f64(&phasor_parts, &phasor_self);
    phasor_t phasor_self_2;
    phasor_mul_f64(&phasor_self, 2.0, &phasor_self_2);
    phasor_t phasor_other;
    phasor_mul_i32(&phasor_self_2, 3, &phasor_other);
    phasor_add(&real, &phasor_other, phasor);
}

void own_operators_phase_of(uint8_t letter, result_own_operators_phase_unknown_t *result)
{
    result_own_operators_phase_unknown_t phase_outcome;
    own_operators_phase_try_from_u8(letter, &phase_outcome);
    if (!phase_outcome.is_ok) {
        result->is_ok = false;
        result->as.error = phase_outcome.as.error;
        return;
    }
    const own_operators_phase_t phase = phase_outcome.as.value;
    result->is_ok = true;
    result->as.value = phase;
}

double own_operators_widened(int32_t x, uint8_t y)
{
    const double x_2 = (double)x;
    const uint32_t y_2 = (uint32_t)y;
    return x_2 + (double)y_2;
}

/* own_operators.h */

/** A complex number. */
typedef struct {
    /** The real part. */
    double re;
    /** The imaginary part. */
    double im;
} phasor_t;

/** The error for a letter that is not a phase. */
typedef struct {
    uint8_t value;
} unknown_t;

/** A phase of the mains. */
typedef enum {
    /** First phase. */
    OWN_OPERATORS_PHASE_A = 0,
    /** Second phase. */
    OWN_OPERATORS_PHASE_B = 1,
    /** Third phase. */
    OWN_OPERATORS_PHASE_C = 2
} own_operators_phase_t;

/** `Result<Phase, Unknown>`: a value, or the reason why there is none. */
typedef struct {
    /** True if there is a value. */
    bool is_ok;
    /** What it holds. */
    union {
        /** The value, if there is one. */
        own_operators_phase_t value;
        /** Reason why there is no value. */
        unknown_t error;
    } as;
} result_own_operators_phase_unknown_t;
