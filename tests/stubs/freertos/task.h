/* A stand-in for FreeRTOS' header of this name, for a test. It keeps one task, and ends the program where that has waited for
 * its third period: with success, if the task sleeps until a time and asked for its floating-point registers. */
#ifndef TASK_H
#define TASK_H

#include <stdlib.h>

#include "FreeRTOS.h"

#define tskIDLE_PRIORITY ((UBaseType_t)0U)
#define portTASK_USES_FLOATING_POINT() (stub_has_floats = 1)

typedef void (*TaskFunction_t)(void *);
typedef StaticTask_t *TaskHandle_t;

static StaticTask_t *stub_task;
static TickType_t stub_ticks = 7U;
static int stub_has_floats;

static inline TaskHandle_t xTaskCreateStatic(TaskFunction_t code, const char *name, uint32_t depth, void *argument,
    UBaseType_t priority, StackType_t *stack, StaticTask_t *task)
{
    if (name == NULL || stack == NULL || depth <= configMINIMAL_STACK_SIZE || priority <= tskIDLE_PRIORITY) {
        return NULL;
    }
    task->code = code;
    task->argument = argument;
    stub_task = task;
    return task;
}

static inline void vTaskStartScheduler(void)
{
    if (stub_task != NULL) {
        stub_task->code(stub_task->argument);
    }
    exit(1);
}

static inline TickType_t xTaskGetTickCount(void)
{
    return stub_ticks;
}

static inline void vTaskDelayUntil(TickType_t *woken, TickType_t period)
{
    *woken += period;
    stub_ticks = *woken;
    if (stub_ticks == 7U + 3U * period) {
        exit(stub_has_floats == 1 && period > 0U ? 0 : 2);
    }
}

#endif
