/* What a vendor's library brings: the C of functions/external.rs. */
#ifndef SENSOR_H
#define SENSOR_H

#include <stdint.h>

float sensor_linear(uint16_t raw);
void sensor_axes(const float raw[3], float scale, float axes[3]);

#endif
