/* The C of tests/corpus/src/programs/data/units.rs. Written by a test. */

/* air_density.c */

void air_density_init(air_density_t *self)
{
    self->density = 0.0F;
}

float air_density_step(air_density_t *BESSEMER_RESTRICT self, const barometer_t *reading,
    float rate, float period)
{
    self->density += (units_density(reading) - self->density) * rate * period;
    return self->density;
}

/* air_density.h */

/** Smooths the density of the air. */
typedef struct {
    /** Present density. Unit: kg/m³. */
    float density;
} air_density_t;

/* units.c */

/** Specific gas constant of dry air. Unit: J/(kg·K). */
static const float GAS = 287.05F;

float units_density(const barometer_t *reading)
{
    return reading->pressure / (GAS * (reading->temperature + 273.15F));
}

/* units.h */

/** State of the barometer. */
typedef struct {
    /** Pressure of the air. Unit: Pa. Range: 30000 to 110000. */
    float pressure;
    /** Unit: °C. */
    float temperature;
} barometer_t;
