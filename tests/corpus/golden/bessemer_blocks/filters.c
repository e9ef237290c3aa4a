/* The C of blocks/src/filters.rs. Written by a test. */

/* cascade_direct_f32_1.c */

void cascade_direct_f32_1_init(cascade_direct_f32_1_t *self)
{
    self->states[0][0] = 0.0F;
    self->states[0][1] = 0.0F;
    self->states[0][2] = 0.0F;
    self->states[0][3] = 0.0F;
}

float cascade_direct_f32_1_step(cascade_direct_f32_1_t *BESSEMER_RESTRICT self,
    const section_f32_t sections[1], float sample)
{
    float value = sample;
    for (uint32_t i = 0U; i < 1U; i++) {
        const float x1 = self->states[i][0];
        const float x2 = self->states[i][1];
        const float y1 = self->states[i][2];
        const float y2 = self->states[i][3];
        const float fed = sections[i].b0 * value + sections[i].b1 * x1 + sections[i].b2 * x2;
        const float output = fed - sections[i].a1 * y1 - sections[i].a2 * y2;
        self->states[i][0] = value;
        self->states[i][1] = x1;
        self->states[i][2] = output;
        self->states[i][3] = y1;
        value = output;
    }
    return value;
}

/* cascade_direct_f32_1.h */

/**
 * Cascade of `N` sections in direct form I: four values of state for each section.
 *
 * The coefficients may change while it runs: the state is past inputs and outputs, whatever the coefficients were.
 * Initialisation: `Default` is at rest at 0. Nothing saturates.
 *
 * ```
 * use bessemer_blocks::{CascadeDirect, Section};
 *
 * let mut filter = CascadeDirect::<f64, 2>::default();
 * let sections = [Section::low_pass(10.0, 0.54, 100.0), Section::low_pass(10.0, 1.31, 100.0)];
 * let last = (0..200).map(|_| filter.step(&sections, 1.0)).last().unwrap();
 * assert!((last - 1.0).abs() < 1e-9);
 * ```
 */
typedef struct {
    /** Past values of each section: input, input before, output, output before. */
    float states[1][4];
} cascade_direct_f32_1_t;

/* cascade_f32_2.c */

void cascade_f32_2_init(cascade_f32_2_t *self)
{
    self->states[0][0] = 0.0F;
    self->states[0][1] = 0.0F;
    self->states[1][0] = 0.0F;
    self->states[1][1] = 0.0F;
}

float cascade_f32_2_step(cascade_f32_2_t *BESSEMER_RESTRICT self, const section_f32_t sections[2],
    float sample)
{
    float value = sample;
    for (uint32_t i = 0U; i < 2U; i++) {
        const float output = sections[i].b0 * value + self->states[i][0];
        self->states[i][0] = sections[i].b1 * value - sections[i].a1 * output + self->states[i][1];
        self->states[i][1] = sections[i].b2 * value - sections[i].a2 * output;
        value = output;
    }
    return value;
}

void cascade_f32_2_preset(cascade_f32_2_t *BESSEMER_RESTRICT self, const section_f32_t sections[2],
    float sample)
{
    float value = sample;
    for (uint32_t i = 0U; i < 2U; i++) {
        const float gain = (sections[i].b0 + sections[i].b1 + sections[i].b2)
            / (1.0F + sections[i].a1 + sections[i].a2);
        const float output = gain * value;
        const float second = sections[i].b2 * value - sections[i].a2 * output;
        self->states[i][0] = sections[i].b1 * value - sections[i].a1 * output + second;
        self->states[i][1] = second;
        value = output;
    }
}

void cascade_f32_2_block_8(cascade_f32_2_t *BESSEMER_RESTRICT self, const section_f32_t sections[2],
    float samples[BESSEMER_RESTRICT 8])
{
    for (uint32_t i = 0U; i < 2U; i++) {
        float first = self->states[i][0];
        float second = self->states[i][1];
        for (uint32_t j = 0U; j < 8U; j++) {
            const float output = sections[i].b0 * samples[j] + first;
            first = sections[i].b1 * samples[j] - sections[i].a1 * output + second;
            second = sections[i].b2 * samples[j] - sections[i].a2 * output;
            samples[j] = output;
        }
        self->states[i][0] = first;
        self->states[i][1] = second;
    }
}

/* cascade_f32_2.h */

/**
 * Cascade of `N` sections in direct form II, transposed: two values of state for each section.
 *
 * The usual choice for floats. Initialisation: `Default` is at rest at 0. Nothing saturates.
 */
typedef struct {
    /** Two values of each section. */
    float states[2][2];
} cascade_f32_2_t;

/* cascade_f64_2.c */

void cascade_f64_2_init(cascade_f64_2_t *self)
{
    self->states[0][0] = 0.0;
    self->states[0][1] = 0.0;
    self->states[1][0] = 0.0;
    self->states[1][1] = 0.0;
}

double cascade_f64_2_step(cascade_f64_2_t *BESSEMER_RESTRICT self, const section_f64_t sections[2],
    double sample)
{
    double value = sample;
    for (uint32_t i = 0U; i < 2U; i++) {
        const double output = sections[i].b0 * value + self->states[i][0];
        self->states[i][0] = sections[i].b1 * value - sections[i].a1 * output + self->states[i][1];
        self->states[i][1] = sections[i].b2 * value - sections[i].a2 * output;
        value = output;
    }
    return value;
}

/* cascade_f64_2.h */

/**
 * Cascade of `N` sections in direct form II, transposed: two values of state for each section.
 *
 * The usual choice for floats. Initialisation: `Default` is at rest at 0. Nothing saturates.
 */
typedef struct {
    /** Two values of each section. */
    double states[2][2];
} cascade_f64_2_t;

/* cascade_f64_3.c */

void cascade_f64_3_init(cascade_f64_3_t *self)
{
    self->states[0][0] = 0.0;
    self->states[0][1] = 0.0;
    self->states[1][0] = 0.0;
    self->states[1][1] = 0.0;
    self->states[2][0] = 0.0;
    self->states[2][1] = 0.0;
}

double cascade_f64_3_step(cascade_f64_3_t *BESSEMER_RESTRICT self, const section_f64_t sections[3],
    double sample)
{
    double value = sample;
    for (uint32_t i = 0U; i < 3U; i++) {
        const double output = sections[i].b0 * value + self->states[i][0];
        self->states[i][0] = sections[i].b1 * value - sections[i].a1 * output + self->states[i][1];
        self->states[i][1] = sections[i].b2 * value - sections[i].a2 * output;
        value = output;
    }
    return value;
}

/* cascade_f64_3.h */

/**
 * Cascade of `N` sections in direct form II, transposed: two values of state for each section.
 *
 * The usual choice for floats. Initialisation: `Default` is at rest at 0. Nothing saturates.
 */
typedef struct {
    /** Two values of each section. */
    double states[3][2];
} cascade_f64_3_t;

/* first_order_filter_f32.c */

void first_order_filter_f32_init(first_order_filter_f32_t *self)
{
    self->past = 0.0F;
}

float first_order_filter_f32_step(first_order_filter_f32_t *BESSEMER_RESTRICT self,
    const first_order_f32_t *section, float sample)
{
    const float output = section->b0 * sample + self->past;
    self->past = section->b1 * sample - section->a1 * output;
    return output;
}

/* first_order_filter_f32.h */

/**
 * Filter of first order: low-pass, high-pass or lead-lag, by its coefficients (direct form II, transposed).
 *
 * Initialisation: `Default` is at rest at 0; `FirstOrderFilter::preset` is at rest at a value. Nothing
 * saturates.
 */
typedef struct {
    /** Part of the next output that the past decides. */
    float past;
} first_order_filter_f32_t;

/* first_order_filter_f64.c */

void first_order_filter_f64_init(first_order_filter_f64_t *self)
{
    self->past = 0.0;
}

double first_order_filter_f64_step(first_order_filter_f64_t *BESSEMER_RESTRICT self,
    const first_order_f64_t *section, double sample)
{
    const double output = section->b0 * sample + self->past;
    self->past = section->b1 * sample - section->a1 * output;
    return output;
}

void first_order_filter_f64_preset(first_order_filter_f64_t *BESSEMER_RESTRICT self,
    const first_order_f64_t *section, double sample, double output)
{
    self->past = output - section->b0 * sample;
}

/* first_order_filter_f64.h */

/**
 * Filter of first order: low-pass, high-pass or lead-lag, by its coefficients (direct form II, transposed).
 *
 * Initialisation: `Default` is at rest at 0; `FirstOrderFilter::preset` is at rest at a value. Nothing
 * saturates.
 */
typedef struct {
    /** Part of the next output that the past decides. */
    double past;
} first_order_filter_f64_t;
