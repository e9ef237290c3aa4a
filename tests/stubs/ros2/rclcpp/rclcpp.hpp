// A stand-in for ROS 2's header of this name: as much of its interface as an emitted node needs, for a test.
#pragma once

#include <memory>
#include <string>

#define RCLCPP_ERROR(logger, text) (void)(logger), (void)(text)

namespace rclcpp
{
template <class T> struct Publisher {
  using SharedPtr = std::shared_ptr<Publisher<T>>;
  void publish(const T &) {}
};

template <class T> struct Subscription {
  using SharedPtr = std::shared_ptr<Subscription<T>>;
};

struct Logger {};

class Node
{
public:
  explicit Node(const std::string &) {}
  template <class T> typename Publisher<T>::SharedPtr create_publisher(const std::string &, int) { return std::make_shared<Publisher<T>>(); }
  template <class T, class F> typename Subscription<T>::SharedPtr create_subscription(const std::string &, int, F &&called)
  {
    called(T{});
    return std::make_shared<Subscription<T>>();
  }
  Logger get_logger() const { return Logger{}; }
};

inline void init(int, char **) {}
inline void spin(std::shared_ptr<Node>) {}
inline void shutdown() {}
}
