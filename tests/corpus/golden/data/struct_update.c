/* The C of tests/corpus/src/programs/data/struct_update.rs. Written by a test. */

/* struct_update.c */

void struct_update_braked(const drive_t *drive, drive_t *BESSEMER_RESTRICT result)
{
    result->speed = 0.0F;
    result->torque = drive->torque;
    result->brake = true;
}

/* struct_update.h */

/** A command to a motor. */
typedef struct {
    float speed;
    float torque;
    bool brake;
} drive_t;
