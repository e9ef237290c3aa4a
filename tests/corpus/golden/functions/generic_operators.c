/* The C of tests/corpus/src/programs/functions/generic_operators.rs. Written by a test. */

/* generic_operators.c */

void complex_f32_add(const complex_f32_t *self, const complex_f32_t *other,
    complex_f32_t *BESSEMER_RESTRICT complex_)
{
    complex_->re = self->re + other->re;
    complex_->im = self->im + other->im;
}

void complex_f64_add(const complex_f64_t *self, const complex_f64_t *other,
    complex_f64_t *BESSEMER_RESTRICT complex_)
{
    complex_->re = self->re + other->re;
    complex_->im = self->im + other->im;
}

void complex_f64_add_assign(complex_f64_t *BESSEMER_RESTRICT self, const complex_f64_t *other)
{
    complex_f64_t self_next;
    complex_f64_add(self, other, &self_next);
    *self = self_next;
}

void complex_f32_mul(const complex_f32_t *self, const complex_f32_t *other,
    complex_f32_t *BESSEMER_RESTRICT complex_)
{
    complex_->re = self->re * other->re - self->im * other->im;
    complex_->im = self->re * other->im + self->im * other->re;
}

void complex_f64_mul(const complex_f64_t *self, const complex_f64_t *other,
    complex_f64_t *BESSEMER_RESTRICT complex_)
{
    complex_->re = self->re * other->re - self->im * other->im;
    complex_->im = self->re * other->im + self->im * other->re;
}

void complex_f64_mul_f64(const complex_f64_t *self, double factor,
    complex_f64_t *BESSEMER_RESTRICT complex_)
{
    complex_->re = self->re * factor;
    complex_->im = self->im * factor;
}

void complex_f64_neg(const complex_f64_t *self, complex_f64_t *BESSEMER_RESTRICT complex_)
{
    complex_->re = -self->re;
    complex_->im = -self->im;
}

void complex_f32_from_f32(float re, complex_f32_t *complex_)
{
    complex_->re = re;
    complex_->im = 0.0F;
}

void complex_f64_from_f64(double re, complex_f64_t *complex_)
{
    complex_->re = re;
    complex_->im = 0.0;
}

void generic_operators_polynomial_f32_2(const float coefficients[2], const complex_f32_t *z,
    complex_f32_t *BESSEMER_RESTRICT sum)
{
    complex_f32_from_f32(0.0F, sum);
    for (uint32_t i = 0U; i < 2U; i++) {
        complex_f32_t sum_self;
        complex_f32_mul(sum, z, &sum_self);
        complex_f32_t sum_other;
        complex_f32_from_f32(coefficients[i], &sum_other);
        complex_f32_add(&sum_self, &sum_other, sum);
    }
}

void generic_operators_polynomial_f64_3(const double coefficients[3], const complex_f64_t *z,
    complex_f64_t *BESSEMER_RESTRICT sum)
{
    complex_f64_from_f64(0.0, sum);
    for (uint32_t i = 0U; i < 3U; i++) {
        complex_f64_t sum_self;
        complex_f64_mul(sum, z, &sum_self);
        complex_f64_t sum_other;
        complex_f64_from_f64(coefficients[i], &sum_other);
        complex_f64_add(&sum_self, &sum_other, sum);
    }
}

void generic_operators_response(double re, double im, complex_f64_t *sum)
{
    const complex_f64_t z = {.re = re, .im = im};
    const double sum_coefficients[3] = {1.0, -0.5, 0.25};
    complex_f64_t sum_self;
    generic_operators_polynomial_f64_3(sum_coefficients, &z, &sum_self);
    complex_f64_mul_f64(&sum_self, 2.0, sum);
    complex_f64_t other;
    complex_f64_neg(&z, &other);
    complex_f64_add_assign(sum, &other);
}

void generic_operators_single(const complex_f32_t *z, complex_f32_t *BESSEMER_RESTRICT complex_)
{
    const float complex_coefficients[2] = {0.5F, 2.0F};
    generic_operators_polynomial_f32_2(complex_coefficients, z, complex_);
}

/* generic_operators.h */

/** A number with a real and an imaginary part. */
typedef struct {
    float re;
    float im;
} complex_f32_t;

/** A number with a real and an imaginary part. */
typedef struct {
    double re;
    double im;
} complex_f64_t;
