/* A stand-in for micro-ROS' header of this name, for a test. */
#ifndef RCLC_RCLC_H
#define RCLC_RCLC_H

#include <rcl/rcl.h>

typedef struct {
    rcl_context_t context;
} rclc_support_t;
typedef struct {
    int unused;
} rosidl_message_type_support_t;

#define ROSIDL_GET_MSG_TYPE_SUPPORT(package, folder, name) ((const rosidl_message_type_support_t *)#package #name)

rcl_ret_t rclc_support_init(rclc_support_t *support, int argc, char const *const *argv, rcl_allocator_t *allocator);
rcl_ret_t rclc_node_init_default(rcl_node_t *node, const char *name, const char *space, rclc_support_t *support);
rcl_ret_t rclc_publisher_init_default(rcl_publisher_t *publisher, const rcl_node_t *node,
    const rosidl_message_type_support_t *type, const char *topic);
rcl_ret_t rclc_subscription_init_default(rcl_subscription_t *subscription, rcl_node_t *node,
    const rosidl_message_type_support_t *type, const char *topic);

#endif
