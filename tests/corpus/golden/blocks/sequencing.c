/* The C of tests/corpus/src/programs/blocks/sequencing.rs. Written by a test. */

/* sequencing.c */

sequencing_phase_t pump_next_phase(pump_t *self, sequencing_phase_t state, uint32_t periods)
{
    if (!self->wanted) {
        return SEQUENCING_PHASE_OFF;
    } else {
        switch (state) {
        case SEQUENCING_PHASE_OFF:
            return SEQUENCING_PHASE_PRIMING;
        case SEQUENCING_PHASE_PRIMING:
            if (periods >= 20U) {
                return SEQUENCING_PHASE_PUMPING;
            } else {
                return SEQUENCING_PHASE_PRIMING;
            }
            break;
        case SEQUENCING_PHASE_PUMPING:
        default:
            return SEQUENCING_PHASE_PUMPING;
        }
    }
}

void pump_enter_phase(pump_t *self, sequencing_phase_t state)
{
    self->valve = state != SEQUENCING_PHASE_OFF;
    if (state == SEQUENCING_PHASE_PUMPING) {
        self->motor = true;
        self->starts = saturating_add_u32(self->starts, 1U);
    }
}

void pump_exit_phase(pump_t *self, sequencing_phase_t state)
{
    if (state == SEQUENCING_PHASE_PUMPING) {
        self->motor = false;
    }
}

/* sequencing.h */

/** States of the pump. */
typedef enum {
    /** Everything is off. */
    SEQUENCING_PHASE_OFF = 0,
    /** The valve is open; the motor waits. */
    SEQUENCING_PHASE_PRIMING = 1,
    /** The motor runs. */
    SEQUENCING_PHASE_PUMPING = 2
} sequencing_phase_t;

/** Inputs and outputs of the pump. */
typedef struct {
    /** True if water is wanted. */
    bool wanted;
    /** True to open the valve. */
    bool valve;
    /** True to run the motor. */
    bool motor;
    /** Number of starts of the motor. */
    uint32_t starts;
} pump_t;

/* station.c */

static const schedule_3_t SCHEDULE = {
    .tasks = {
        {.period = 1U, .phase = 0U, .cost = 40U},
        {.period = 5U, .phase = 1U, .cost = 30U},
        {.period = 10U, .phase = 2U, .cost = 50U}
    }
};

void station_init(station_t *self)
{
    rates_3_init(&self->rates);
    machine_phase_init(&self->machine);
    self->pump.wanted = false;
    self->pump.valve = false;
    self->pump.motor = false;
    self->pump.starts = 0U;
    self->level = 0.0F;
}

void station_step(station_t *BESSEMER_RESTRICT self, float level, pump_t *BESSEMER_RESTRICT pump)
{
    bool elements[3];
    rates_3_step(&self->rates, &SCHEDULE, elements);
    if (elements[0]) {
        self->level += 0.1F * (level - self->level);
    }
    if (elements[1]) {
        self->pump.wanted = self->level < 1.0F;
        (void)machine_phase_step_pump(&self->machine, &self->pump);
    }
    if (elements[2]) {
        self->level = max_f32(self->level, 0.0F);
    }
    *pump = self->pump;
}

/* station.h */

/** Runs the pump every fifth step. */
typedef struct {
    rates_3_t rates;
    machine_phase_t machine;
    pump_t pump;
    float level;
} station_t;
