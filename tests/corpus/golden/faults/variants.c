/* The C of tests/corpus/src/programs/faults/variants.rs. Written by a test. */

/* follower.c */

void follower_init(follower_t *self)
{
    self->height = 0.0;
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t follower_step(follower_t *BESSEMER_RESTRICT self, wish_t wish,
    double *BESSEMER_RESTRICT result)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    if ((uint32_t)wish >= 3U) {
        self->fault = BESSEMER_STATUS_VARIANT;
        return BESSEMER_STATUS_VARIANT;
    }
    double height_choice;
    switch (wish) {
    case WISH_STAY:
        height_choice = 0.0;
        break;
    case WISH_CLIMB:
        height_choice = 0.1;
        break;
    case WISH_SINK:
    default:
        height_choice = -0.1;
        break;
    }
    self->height += height_choice;
    *result = self->height;
    return BESSEMER_STATUS_OK;
}

/* follower.h */

/** Executes the pilot's commands. */
typedef struct {
    double height;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} follower_t;

/* variants.h */

/** Commands of the pilot. */
typedef enum {
    WISH_STAY = 0,
    WISH_CLIMB = 1,
    WISH_SINK = 2
} wish_t;
