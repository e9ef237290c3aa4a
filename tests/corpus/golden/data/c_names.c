/* The C of tests/corpus/src/programs/data/c_names.rs. Written by a test. */

/* c_names.h */

/** Fields of the variant Slam of Order. */
typedef struct {
    bool open;
} ValveOrder_slam_t;

/** Which variant of `Order`. */
typedef enum {
    VALVE_HOLD = 0,
    /** Move to a fraction of the opening. */
    VALVE_ORDER_TAG_MOVE = 1,
    /** Open or close as fast as possible. */
    VALVE_SLAM = 2
} ValveOrder_tag_t;

/** Commands of the valve. */
typedef struct {
    /** Which variant it is. */
    ValveOrder_tag_t tag;
    /** What it holds. */
    union {
        /** Move to a fraction of the opening. */
        float wanted;
        /** Open or close as fast as possible. */
        ValveOrder_slam_t slam;
    } as;
} ValveOrder_t;

/* motor_valve.c */

/* Stands in a section of its own. Nothing where the compiler is not known. */
#ifndef BESSEMER_SECTION
#if defined(__GNUC__)
#define BESSEMER_SECTION(name) __attribute__((section(name)))
#else
#define BESSEMER_SECTION(name)
#endif
#endif

/** The flow at each eighth of the opening, l/min. */
BESSEMER_SECTION(".rodata.curves")
static const float kValveFlow[9] = {0.0F, 0.5F, 1.75F, 3.5F, 5.5F, 7.25F, 8.5F, 9.25F, 9.5F};

/** Fraction of the opening that it moves in a period. */
static const float kValveStep = 0.125F;

void Valve_init(Valve_t *self)
{
    self->fPosition = 0.0F;
    self->u32Moves = 0U;
    self->fault = BESSEMER_STATUS_OK;
}

bessemer_status_t Valve_step(Valve_t *BESSEMER_RESTRICT pThis, const ValveOrder_t *pOrder,
    float *BESSEMER_RESTRICT pFlow)
{
    if (pThis->fault != BESSEMER_STATUS_OK) {
        return pThis->fault;
    }
    if ((uint32_t)pOrder->tag >= 3U) {
        pThis->fault = BESSEMER_STATUS_VARIANT;
        return BESSEMER_STATUS_VARIANT;
    }
    float target;
    switch (pOrder->tag) {
    case VALVE_HOLD:
        target = pThis->fPosition;
        break;
    case VALVE_ORDER_TAG_MOVE: {
        const float share = pOrder->as.wanted;
        target = clamp_f32(share, 0.0F, 1.0F);
        break;
    }
    case VALVE_SLAM:
    default: {
        const bool open = pOrder->as.slam.open;
        target = (float)(uint8_t)open;
        break;
    }
    }
    const float change = clamp_f32(target - pThis->fPosition, -kValveStep, kValveStep);
    if (change != 0.0F) {
        if (pThis->u32Moves > 0xFFFFFFFEU) {
            pThis->fault = BESSEMER_STATUS_OVERFLOW;
            return BESSEMER_STATUS_OVERFLOW;
        }
        pThis->u32Moves += 1U;
    }
    pThis->fPosition = clamp_f32(pThis->fPosition + change, 0.0F, 1.0F);
    *pFlow = kValveFlow[u64_from_f32(pThis->fPosition * 8.0F)];
    return BESSEMER_STATUS_OK;
}

bool Valve_closed(const Valve_t *self)
{
    return self->fPosition <= 0.0F;
}

/* motor_valve.h */

/** A valve that moves in steps. */
typedef struct {
    /** Opening, 0 to 1. */
    float fPosition;
    /** Number of movements. */
    uint32_t u32Moves;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} Valve_t;
