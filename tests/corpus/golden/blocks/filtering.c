/* The C of tests/corpus/src/programs/blocks/filtering.rs. Written by a test. */

/* current_filter.c */

void current_filter_init(current_filter_t *self)
{
    cascade_f32_2_init(&self->smooth);
    cascade_direct_f32_1_init(&self->notch);
    first_order_filter_f32_init(&self->lead);
}

float current_filter_step(current_filter_t *BESSEMER_RESTRICT self, const section_f32_t sections[2],
    float current, float disturbance)
{
    const float smooth = cascade_f32_2_step(&self->smooth, sections, current);
    section_f32_t notch_value;
    section_f32_notch(min_f32(max_f32(disturbance, 1.0F), 4000.0F), 5.0F, 10000.0F, &notch_value);
    const section_f32_t notch[1] = {notch_value};
    const float free = cascade_direct_f32_1_step(&self->notch, notch, smooth);
    first_order_f32_t result_section;
    first_order_f32_lead_lag(0.002F, 0.0005F, 0.0001F, &result_section);
    return first_order_filter_f32_step(&self->lead, &result_section, free);
}

void current_filter_block(current_filter_t *BESSEMER_RESTRICT self, const section_f32_t sections[2],
    float samples[BESSEMER_RESTRICT 8])
{
    cascade_f32_2_block_8(&self->smooth, sections, samples);
}

/* current_filter.h */

/** Filters a current: a low-pass of fourth order, then a notch. */
typedef struct {
    cascade_f32_2_t smooth;
    cascade_direct_f32_1_t notch;
    first_order_filter_f32_t lead;
} current_filter_t;

/* force_filter.c */

void force_filter_init(force_filter_t *self)
{
    cascade_f64_3_init(&self->sections);
    first_order_filter_f64_init(&self->slow);
    self->started = false;
}

double force_filter_step(force_filter_t *self, double force, double cutoff)
{
    section_f64_t sections_low_pass;
    section_f64_low_pass(cutoff, 0.7, 1000.0, &sections_low_pass);
    section_f64_t sections_high_pass;
    section_f64_high_pass(0.1, 0.7, 1000.0, &sections_high_pass);
    section_f64_t sections_band_pass;
    section_f64_band_pass(cutoff, 0.5, 1000.0, &sections_band_pass);
    const section_f64_t sections[3] = {sections_low_pass, sections_high_pass, sections_band_pass};
    first_order_f64_t low_pass;
    first_order_f64_low_pass(0.2, 0.001, &low_pass);
    if (!self->started) {
        self->started = true;
        first_order_filter_f64_preset(&self->slow, &low_pass, force, force);
    }
    const double result_left_step = cascade_f64_3_step(&self->sections, sections, force);
    const double result_left_step_2 = first_order_filter_f64_step(&self->slow, &low_pass, force);
    const double result_left = result_left_step + result_left_step_2;
    first_order_f64_t first_order;
    first_order_f64_high_pass(0.1, 0.001, &first_order);
    return result_left - first_order.b0;
}

/* force_filter.h */

/** Filters a force. */
typedef struct {
    cascade_f64_3_t sections;
    first_order_filter_f64_t slow;
    bool started;
} force_filter_t;
