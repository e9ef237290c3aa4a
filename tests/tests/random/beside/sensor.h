/* What a firmware brings: the C of the function that random bodies call as an external one. */
#ifndef BESIDE_SENSOR_H
#define BESIDE_SENSOR_H

#include <stdint.h>

int16_t beside_sensor(int16_t x);

#endif
