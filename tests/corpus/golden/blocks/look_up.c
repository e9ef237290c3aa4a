/* The C of tests/corpus/src/programs/blocks/look_up.rs. Written by a test. */

/* ignition.c */

static const uniform_axis_f32_3_t LOADS = {.first = 0.0F, .spacing = 0.5F};
static const axis_f32_4_t SPEEDS = {.points = {800.0F, 1500.0F, 3000.0F, 6000.0F}};

void ignition_init(ignition_t *self)
{
    tables_search_init(&self->speed);
}

float ignition_step(ignition_t *self, float speed, float load)
{
    place_f32_t row;
    tables_search_place_f32_4(&self->speed, &SPEEDS, speed, BEYOND_HOLD, &row);
    place_f32_t result_column;
    uniform_axis_f32_3_place(&LOADS, load, BEYOND_HOLD, &result_column);
    return tables_interpolated_2d_f32_4_3((const float (*)[3])LOOK_UP_ADVANCE, &row,
        &result_column);
}

/* ignition.h */

/** Looks up the ignition's advance. */
typedef struct {
    tables_search_t speed;
} ignition_t;

/* look_up.c */

double look_up_calibrated(const axis_f64_5_t *curve, const double values[5], double input)
{
    if (!tables_ascends_f64_5(curve->points)) {
        return 0.0;
    }
    place_f64_t result_place;
    axis_f64_5_place(curve, input, BEYOND_EXTEND, &result_place);
    return tables_interpolated_f64_5(values, &result_place);
}

double look_up_uniform(const double values[4], double first, double spacing, double input)
{
    const uniform_axis_f64_4_t axis = {.first = first, .spacing = spacing};
    place_f64_t result_place;
    uniform_axis_f64_4_place(&axis, input, BEYOND_EXTEND, &result_place);
    return tables_interpolated_f64_4(values, &result_place);
}
