/* A stand-in for ROS 2's header of this name, for a test. */
#ifndef RCL_RCL_H
#define RCL_RCL_H

#include <stddef.h>

#define RCL_RET_OK 0

typedef int rcl_ret_t;
typedef struct {
    int unused;
} rcl_allocator_t;
typedef struct {
    int unused;
} rcl_context_t;
typedef struct {
    int unused;
} rcl_node_t;
typedef struct {
    int unused;
} rcl_publisher_t;
typedef struct {
    int unused;
} rcl_subscription_t;

rcl_allocator_t rcl_get_default_allocator(void);
rcl_ret_t rcl_publish(const rcl_publisher_t *publisher, const void *message, void *allocation);

#endif
