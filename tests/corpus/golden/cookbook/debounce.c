/* The C of tests/corpus/src/programs/cookbook/debounce.rs. Written by a test. */

/* debounce.h */

/** Event of a button at a sample. */
typedef enum {
    /** Nothing happened. */
    BUTTON_EVENT_STEADY = 0,
    /** The button was released before the press was long. */
    BUTTON_EVENT_SHORT = 1,
    /** The press became long. */
    BUTTON_EVENT_LONG = 2
} button_event_t;

/* push_button.c */

static const uint32_t LONG_SAMPLES = 800U;
static const uint32_t STABLE_SAMPLES = 5U;

void push_button_init(push_button_t *self)
{
    debounce_init(&self->contact);
    logic_timer_init(&self->held);
    self->is_long = false;
}

button_event_t push_button_sample(push_button_t *self, bool closed)
{
    logic_contact_t contact;
    debounce_step(&self->contact, STABLE_SAMPLES, closed, &contact);
    const bool was_long = self->is_long;
    self->is_long = logic_timer_step(&self->held, LONG_SAMPLES, contact.is_on);
    if (self->is_long && !was_long) {
        return BUTTON_EVENT_LONG;
    } else if (contact.fell && !was_long) {
        return BUTTON_EVENT_SHORT;
    } else {
        return BUTTON_EVENT_STEADY;
    }
}

/* push_button.h */

/** A debounced push button. */
typedef struct {
    debounce_t contact;
    /** Time for which it is pressed. */
    logic_timer_t held;
    /** True if the press is long. */
    bool is_long;
} push_button_t;
