/* The C of tests/corpus/src/programs/data/defaults.rs. Written by a test. */

/* programs_data_defaults.c */

static const settings_t SETTINGS_DEFAULT = {.share = 0.25, .count = 100U, .on = true};

void programs_data_defaults_fast(double share, settings_t *settings)
{
    *settings = SETTINGS_DEFAULT;
    settings->share = share;
}

/* programs_data_defaults.h */

/** Settings of a filter. */
typedef struct {
    /** Weight of the new value, 0 to 1. */
    double share;
    /** Values to wait for. */
    uint16_t count;
    bool on;
} settings_t;
