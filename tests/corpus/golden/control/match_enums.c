/* The C of tests/corpus/src/programs/control/match_enums.rs. Written by a test. */

/* match_enums.h */

/** Phases of a flight. */
typedef enum {
    MATCH_ENUMS_PHASE_GROUND = 0,
    MATCH_ENUMS_PHASE_CLIMB = 1,
    MATCH_ENUMS_PHASE_CRUISE = 2,
    MATCH_ENUMS_PHASE_LANDING = 3
} match_enums_phase_t;

/* sequence.c */

void sequence_init(sequence_t *self)
{
    self->phase = MATCH_ENUMS_PHASE_GROUND;
    self->ticks = 0U;
}

match_enums_phase_t sequence_step(sequence_t *self, double height, bool land)
{
    self->ticks = (uint16_t)((uint32_t)self->ticks + 1U);
    match_enums_phase_t next;
    switch (self->phase) {
    case MATCH_ENUMS_PHASE_GROUND:
        if (!land) {
            next = MATCH_ENUMS_PHASE_CLIMB;
        } else {
            next = self->phase;
        }
        break;
    case MATCH_ENUMS_PHASE_CLIMB:
        if (height > 10.0) {
            next = MATCH_ENUMS_PHASE_CRUISE;
        } else if (land) {
            next = MATCH_ENUMS_PHASE_LANDING;
        } else {
            next = self->phase;
        }
        break;
    case MATCH_ENUMS_PHASE_CRUISE:
        if (land) {
            next = MATCH_ENUMS_PHASE_LANDING;
        } else {
            next = self->phase;
        }
        break;
    case MATCH_ENUMS_PHASE_LANDING:
    default:
        if (height < 0.05) {
            next = MATCH_ENUMS_PHASE_GROUND;
        } else {
            next = self->phase;
        }
        break;
    }
    if (next != self->phase) {
        self->ticks = 0U;
        self->phase = next;
    }
    return next;
}

/* sequence.h */

/** Steps through the phases in order. */
typedef struct {
    match_enums_phase_t phase;
    uint16_t ticks;
} sequence_t;
