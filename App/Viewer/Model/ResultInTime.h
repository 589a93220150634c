#ifndef Varimarch_Viewer_ResultInTime_h
#define Varimarch_Viewer_ResultInTime_h

#include <chrono>
#include <future>
#include <optional>
#include <thread>
#include <utility>

namespace varimarch
{

/// Runs a task that may never end, because it asks for a file on a disk of the network that is
/// gone, in a thread of its own. The task owns all that it uses.
/// @returns its result; nothing if it has not ended after three seconds, and the thread is left
/// alone
template <class Task>
auto ResultInTime(Task task) -> std::optional<decltype(task())>
{
  std::packaged_task<decltype(task())()> packaged(std::move(task));
  auto result = packaged.get_future();
  std::thread(std::move(packaged)).detach();
  if (result.wait_for(std::chrono::seconds(3)) != std::future_status::ready)
  {
    return std::nullopt;
  }
  return result.get();
}

}

#endif
