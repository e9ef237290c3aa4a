/* The C of tests/corpus/src/programs/data/nested_structs.rs. Written by a test. */

/* nested_structs.c */

void nested_structs_widened(const servo_t *servo, const span_t *margin,
    servo_t *BESSEMER_RESTRICT wide)
{
    *wide = *servo;
    wide->angle.low -= margin->low;
    wide->angle.high += margin->high;
    wide->rate.low = servo->rate.low * 2.0F;
    wide->rate.high = servo->rate.high * 2.0F;
}

/* nested_structs.h */

/** A range of values. */
typedef struct {
    float low;
    float high;
} span_t;

/** Limits of a servo. */
typedef struct {
    span_t angle;
    span_t rate;
} servo_t;
