/* A stand-in for FreeRTOS' header of this name: as much of its interface as an emitted task needs, for a test. */
#ifndef FREERTOS_H
#define FREERTOS_H

#include <stddef.h>
#include <stdint.h>

typedef long BaseType_t;
typedef unsigned long UBaseType_t;
typedef uint32_t TickType_t;
typedef uintptr_t StackType_t;

typedef struct {
    void (*code)(void *);
    void *argument;
} StaticTask_t;

#define configTICK_RATE_HZ 1000U
#define configMINIMAL_STACK_SIZE 128U
#define pdMS_TO_TICKS(milliseconds) ((TickType_t)((milliseconds) * configTICK_RATE_HZ / 1000U))

#endif
