/* A stand-in for ESP-IDF's header of this name, for a test: its FreeRTOS is that of the other test. */
#include "../../freertos/FreeRTOS.h"
