/* The C of tests/corpus/src/programs/cookbook/low_pass.rs. Written by a test. */

/* low_pass.c */

static const float QUALITIES[2] = {0.5411961F, 1.306563F};

void low_pass_butterworth(float cutoff, float rate, section_f32_t result[2])
{
    const float limited = min_f32(max_f32(cutoff, 0.001F * rate), 0.45F * rate);
    for (uint32_t i = 0U; i < 2U; i++) {
        section_f32_low_pass(limited, QUALITIES[i], rate, &result[i]);
    }
}

/* low_pass_low_pass.c */

void low_pass_low_pass_init(low_pass_low_pass_t *self)
{
    cascade_f32_2_init(&self->cascade);
}

float low_pass_low_pass_step(low_pass_low_pass_t *BESSEMER_RESTRICT self,
    const section_f32_t sections[2], float sample)
{
    return cascade_f32_2_step(&self->cascade, sections, sample);
}

void low_pass_low_pass_preset(low_pass_low_pass_t *BESSEMER_RESTRICT self,
    const section_f32_t sections[2], float sample)
{
    cascade_f32_2_preset(&self->cascade, sections, sample);
}

/* low_pass_low_pass.h */

/** Filters a signal. */
typedef struct {
    cascade_f32_2_t cascade;
} low_pass_low_pass_t;
