/* The C of tests/corpus/src/programs/cookbook/low_pass.rs. Written by a test. */

/* biquad_filter.c */

void biquad_filter_init(biquad_filter_t *self)
{
    self->memory[0] = 0.0F;
    self->memory[1] = 0.0F;
}

float biquad_filter_step(biquad_filter_t *BESSEMER_RESTRICT self,
    const biquad_coefficients_t *coefficients, float sample)
{
    const float output = coefficients->b[0] * sample + self->memory[0];
    self->memory[0] = coefficients->b[1] * sample - coefficients->a[0] * output + self->memory[1];
    self->memory[1] = coefficients->b[2] * sample - coefficients->a[1] * output;
    return output;
}

void biquad_filter_preset(biquad_filter_t *BESSEMER_RESTRICT self,
    const biquad_coefficients_t *coefficients, float sample)
{
    self->memory[1] = (coefficients->b[2] - coefficients->a[1]) * sample;
    self->memory[0] = (coefficients->b[1] - coefficients->a[0]) * sample + self->memory[1];
}

/* biquad_filter.h */

/** State of a second-order filter. */
typedef struct {
    float memory[2];
} biquad_filter_t;

/* low_pass.c */

static const float F32_PI = 3.1415927F;
static const float SQRT_2 = 1.4142135F;

void low_pass_butterworth(float cutoff, float rate, biquad_coefficients_t *biquad_coefficients)
{
    const float share = min_f32(max_f32(cutoff / rate, 0.001F), 0.45F);
    const float warped = math_single_tanf(F32_PI * share);
    const float damping = SQRT_2 * warped;
    const float square = warped * warped;
    const float scale = 1.0F / (1.0F + damping + square);
    const float b0 = square * scale;
    biquad_coefficients->b[0] = b0;
    biquad_coefficients->b[1] = 2.0F * b0;
    biquad_coefficients->b[2] = b0;
    biquad_coefficients->a[0] = 2.0F * (square - 1.0F) * scale;
    biquad_coefficients->a[1] = (1.0F - damping + square) * scale;
}

/* low_pass.h */

/** Coefficients of `(b0 + b1/z + b2/z²) / (1 + a1/z + a2/z²)`. */
typedef struct {
    /** Coefficients of the input: b0, b1, b2. */
    float b[3];
    /** Coefficients of the output: a1, a2. */
    float a[2];
} biquad_coefficients_t;
