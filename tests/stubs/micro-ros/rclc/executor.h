/* A stand-in for micro-ROS' header of this name, for a test. */
#ifndef RCLC_EXECUTOR_H
#define RCLC_EXECUTOR_H

#include <rclc/rclc.h>

typedef struct {
    int unused;
} rclc_executor_t;
typedef enum { ON_NEW_DATA, ALWAYS } rclc_executor_handle_invocation_t;
typedef void (*rclc_subscription_callback_t)(const void *message);

rclc_executor_t rclc_executor_get_zero_initialized_executor(void);
rcl_ret_t rclc_executor_init(rclc_executor_t *executor, rcl_context_t *context, size_t handles,
    const rcl_allocator_t *allocator);
rcl_ret_t rclc_executor_add_subscription(rclc_executor_t *executor, rcl_subscription_t *subscription, void *message,
    rclc_subscription_callback_t callback, rclc_executor_handle_invocation_t invocation);
rcl_ret_t rclc_executor_spin(rclc_executor_t *executor);

#endif
