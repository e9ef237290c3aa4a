/* The C of tests/corpus/src/programs/matrices/state.rs. Written by a test. */

/* programs_matrices_state_tracker.c */

void programs_matrices_state_tracker_init(programs_matrices_state_tracker_t *self)
{
    self->state[0] = 0.0;
    self->state[1] = 0.0;
    self->gains[0] = 0.5;
    self->gains[1] = 0.25;
}

void programs_matrices_state_tracker_step(programs_matrices_state_tracker_t *BESSEMER_RESTRICT self,
    double measured, double time, double result[BESSEMER_RESTRICT 2])
{
    const double predicted_matrix[4] = {
        1.0, 0.0,
        time, 1.0
    };
    const double predicted[2] = {
        predicted_matrix[0 + 2 * 0] * self->state[0] + predicted_matrix[0 + 2 * 1] * self->state[1],
        predicted_matrix[1 + 2 * 0] * self->state[0] + predicted_matrix[1 + 2 * 1] * self->state[1]
    };
    const double surprise = measured - predicted[0];
    self->state[0] = predicted[0] + self->gains[0] * surprise;
    self->state[1] = predicted[1] + self->gains[1] * surprise;
    result[0] = self->state[0];
    result[1] = self->state[1];
}

/* programs_matrices_state_tracker.h */

/** A tracker of a position and its speed with fixed gains. */
typedef struct {
    double state[2];
    double gains[2];
} programs_matrices_state_tracker_t;
