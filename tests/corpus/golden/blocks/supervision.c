/* The C of tests/corpus/src/programs/blocks/supervision.rs. Written by a test. */

/* altimeters.c */

void altimeters_init(altimeters_t *self)
{
    voter_f64_init(&self->voter);
}

void altimeters_step(altimeters_t *BESSEMER_RESTRICT self, const voter_limits_f64_t *limits,
    const double sensors[3], pair_f64_f64_t *BESSEMER_RESTRICT result)
{
    const double a = sensors[0];
    const double b = sensors[1];
    const double c = sensors[2];
    vote_f64_t vote;
    voter_f64_step(&self->voter, limits, sensors, &vote);
    result->first = vote.value;
    result->second = logic_median_f64(a, b, c);
}

/* altimeters.h */

/** Votes on an altitude. */
typedef struct {
    voter_f64_t voter;
} altimeters_t;

/* supervisor.c */

void supervisor_init(supervisor_t *self)
{
    debounce_init(&self->button);
    logic_timer_init(&self->warm_up);
    watchdog_init(&self->link);
    voter_f32_init(&self->pressure);
}

bool supervisor_step(supervisor_t *self, bool button, bool message, bool is_cold)
{
    logic_contact_t contact;
    debounce_step(&self->button, 3U, button, &contact);
    if (contact.rose) {
        watchdog_reset(&self->link);
    }
    const bool is_slow = logic_timer_step(&self->warm_up, 1000U, is_cold);
    bool result = false;
    if (contact.is_on) {
        const bool result_step = watchdog_step(&self->link, 5U, message);
        result = !result_step;
    }
    return result && !(is_slow && logic_timer_elapsed(&self->warm_up) > 1200U);
}

void supervisor_pressure(supervisor_t *BESSEMER_RESTRICT self, const voter_limits_f32_t *limits,
    const float sensors[3], bool reset, vote_f32_t *BESSEMER_RESTRICT vote)
{
    if (reset) {
        voter_f32_reset(&self->pressure);
    }
    voter_f32_step(&self->pressure, limits, sensors, vote);
}

/* supervisor.h */

/** Supervises a machine. */
typedef struct {
    debounce_t button;
    logic_timer_t warm_up;
    watchdog_t link;
    voter_f32_t pressure;
} supervisor_t;
