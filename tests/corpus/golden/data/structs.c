/* The C of tests/corpus/src/programs/data/structs.rs. Written by a test. */

/* structs.c */

double structs_merged(const structs_reading_t *one, const structs_reading_t *other)
{
    if (one->valid && other->valid) {
        return (one->height + other->height) / 2.0;
    }
    if (one->time > other->time) {
        return one->height;
    } else {
        return other->height;
    }
}

/* structs.h */

/** Reading of the altimeter. */
typedef struct {
    /** Height above ground, m. */
    double height;
    /** Time since start, ms. */
    uint32_t time;
    /** True if the echo was received. */
    bool valid;
} structs_reading_t;
