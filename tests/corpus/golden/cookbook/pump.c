/* The C of tests/corpus/src/programs/cookbook/pump.rs. Written by a test. */

/* pump.h */

/** Fields of the variant Priming of PumpState. */
typedef struct {
    /** Remaining time, ms. */
    uint16_t left;
} pump_state_priming_t;

/** Fields of the variant Running of PumpState. */
typedef struct {
    /** Time since the last flow, ms. */
    uint16_t dry;
} pump_state_running_t;

/** Which variant of `PumpState`. */
typedef enum {
    /** The pump is off. */
    PUMP_STATE_TAG_OFF = 0,
    /** The pump fills the pipe. */
    PUMP_STATE_TAG_PRIMING = 1,
    /** The pump runs. */
    PUMP_STATE_TAG_RUNNING = 2,
    /** The pump ran dry, and is off until that is acknowledged. */
    PUMP_STATE_TAG_LOCKED_OUT = 3
} pump_state_tag_t;

/** State of the pump. */
typedef struct {
    /** Which variant it is. */
    pump_state_tag_t tag;
    /** What it holds. */
    union {
        /** The pump fills the pipe. */
        pump_state_priming_t priming;
        /** The pump runs. */
        pump_state_running_t running;
    } as;
} pump_state_t;

/** Inputs of a period. */
typedef struct {
    /** True if the pump is to run. */
    bool demand;
    /** True if the flow switch is closed. */
    bool flow;
    /** True if the operator acknowledges the lock-out. */
    bool acknowledge;
} pump_inputs_t;

/* pump_control.c */

static const uint16_t DRY_MS = 500U;
static const uint16_t PRIMING_MS = 3000U;

void pump_control_init(pump_control_t *self)
{
    self->state.tag = PUMP_STATE_TAG_OFF;
}

bool pump_control_step(pump_control_t *BESSEMER_RESTRICT self, const pump_inputs_t *inputs)
{
    switch (self->state.tag) {
    case PUMP_STATE_TAG_OFF:
        if (inputs->demand) {
            self->state.tag = PUMP_STATE_TAG_PRIMING;
            self->state.as.priming.left = PRIMING_MS;
        }
        break;
    case PUMP_STATE_TAG_PRIMING:
        if (!inputs->demand) {
            self->state.tag = PUMP_STATE_TAG_OFF;
        } else if (self->state.as.priming.left == 0U) {
            self->state.tag = PUMP_STATE_TAG_RUNNING;
            self->state.as.running.dry = 0U;
        } else {
            self->state.as.priming.left = (uint16_t)(self->state.as.priming.left - 1U);
        }
        break;
    case PUMP_STATE_TAG_RUNNING:
        if (!inputs->demand) {
            self->state.tag = PUMP_STATE_TAG_OFF;
        } else if (inputs->flow) {
            self->state.as.running.dry = 0U;
        } else if (self->state.as.running.dry >= DRY_MS) {
            self->state.tag = PUMP_STATE_TAG_LOCKED_OUT;
        } else {
            self->state.as.running.dry = (uint16_t)(self->state.as.running.dry + 1U);
        }
        break;
    case PUMP_STATE_TAG_LOCKED_OUT:
    default:
        if (inputs->acknowledge && !inputs->demand) {
            self->state.tag = PUMP_STATE_TAG_OFF;
        } else {
            self->state.tag = PUMP_STATE_TAG_LOCKED_OUT;
        }
        break;
    }
    return self->state.tag == PUMP_STATE_TAG_PRIMING || self->state.tag == PUMP_STATE_TAG_RUNNING;
}

void pump_control_state(const pump_control_t *self, pump_state_t *BESSEMER_RESTRICT pump_state)
{
    *pump_state = self->state;
}

/* pump_control.h */

/** Controls a pump. */
typedef struct {
    pump_state_t state;
} pump_control_t;
