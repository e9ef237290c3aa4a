/* The C of tests/corpus/src/programs/cookbook/debounce.rs. Written by a test. */

/* debounce.h */

/** Change of the debounced level at a sample. */
typedef enum {
    /** The level did not change. */
    BUTTON_EDGE_STEADY = 0,
    /** The button was pressed. */
    BUTTON_EDGE_PRESSED = 1,
    /** The button was released. */
    BUTTON_EDGE_RELEASED = 2
} button_edge_t;

/* push_button.c */

static const uint8_t STABLE_SAMPLES = 5U;

void push_button_init(push_button_t *self)
{
    self->pressed = false;
    self->differing = 0U;
}

button_edge_t push_button_sample(push_button_t *self, bool closed)
{
    if (closed == self->pressed) {
        self->differing = 0U;
        return BUTTON_EDGE_STEADY;
    }
    self->differing = saturating_add_u8(self->differing, 1U);
    if (self->differing < STABLE_SAMPLES) {
        return BUTTON_EDGE_STEADY;
    }
    self->differing = 0U;
    self->pressed = closed;
    if (closed) {
        return BUTTON_EDGE_PRESSED;
    } else {
        return BUTTON_EDGE_RELEASED;
    }
}

bool push_button_is_pressed(const push_button_t *self)
{
    return self->pressed;
}

/* push_button.h */

/** A debounced push button. */
typedef struct {
    /** The debounced state: true if the button is pressed. */
    bool pressed;
    /** Number of consecutive samples that differ from `pressed`; below `STABLE_SAMPLES`. */
    uint8_t differing;
} push_button_t;
