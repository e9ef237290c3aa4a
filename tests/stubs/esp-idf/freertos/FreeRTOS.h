/* A stand-in for ESP-IDF's header of this name, for a test; the other test has its FreeRTOS. */
#include "../../freertos/FreeRTOS.h"
