#ifndef Varimarch_Viewer_BackgroundTask_h
#define Varimarch_Viewer_BackgroundTask_h

#include <QObject>
#include <QString>
#include <QTimer>

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>

namespace varimarch
{

/// Receives the fraction of the work done, [0, 1], or a negative number if that is unknown; returns
/// false to cancel.
using TaskProgress = std::function<bool(double)>;

/// Runs a function in the thread of the task, unless the work has been cancelled until then. Work
/// shows with it what it has found so far.
using TaskPost = std::function<void(std::function<void()>)>;

/// Work in a thread, one at a time, for an object that goes on meanwhile. Work that does not stop
/// when it is cancelled, because a disk or a computer does not answer, is left alone, so it must
/// own all that it uses. PictureThread is another thing: a thread that lives as long as its view,
/// since it owns an OpenGL context.
class BackgroundTask : public QObject
{
  Q_OBJECT

public:
  explicit BackgroundTask(QObject* parent = nullptr);
  /// Cancels the work and waits for its end.
  ~BackgroundTask() override;

  /// Time that cancelled work has to stop, where its end is awaited. Default 2 s.
  void SetPatience(std::chrono::milliseconds time) { this->patience.setInterval(time); }

  /// Cancels the last work and starts another at once.
  /// @param work  runs in the thread, given a TaskProgress, or a TaskProgress and a TaskPost;
  ///              reports a failure by a std::exception, and that it was cancelled by any other
  /// @param done  runs in this object's thread after success, given what the work returned, if
  ///              anything
  template <class Work, class Done>
  void Start(Work work, Done done)
  {
    this->Begin(JobOf(std::move(work), std::move(done)));
  }

  /// The same, but the last work ends first, so that not both of them need memory. Of several that
  /// are started meanwhile, only the latest runs.
  template <class Work, class Done>
  void StartAfterLast(Work work, Done done)
  {
    this->BeginAfterLast(JobOf(std::move(work), std::move(done)));
  }

  /// Cancels the work. Returns at once, and there will be no signal of it.
  void Cancel();

  /// Cancels the work. Returns at once; Stopped is emitted when the work has ended.
  void Stop();

  bool IsRunning() const { return this->state != nullptr; }

signals:
  /// @param part  as for TaskProgress
  void Progress(double part);
  /// @param reason  one sentence
  void Failed(const QString& reason);
  void Stopped();
  /// Work has begun, or has ended in any way.
  void RunningChanged(bool isRunning);

private:
  struct State;

  /// The work; returns what is to be done with its result.
  using Job = std::function<std::function<void()>(const TaskProgress&, const TaskPost&)>;

  template <class Work>
  static auto ResultOf(Work& work, const TaskProgress& progress, const TaskPost& post)
  {
    if constexpr (std::is_invocable_v<Work&, const TaskProgress&, const TaskPost&>)
    {
      return work(progress, post);
    }
    else
    {
      return work(progress);
    }
  }

  template <class Work, class Done>
  static Job JobOf(Work work, Done done)
  {
    return [work = std::move(work), done = std::move(done)](
             const TaskProgress& progress, const TaskPost& post) mutable -> std::function<void()>
    {
      using Result = decltype(ResultOf(work, progress, post));
      if constexpr (std::is_void_v<Result>)
      {
        ResultOf(work, progress, post);
        return done;
      }
      else
      {
        auto result = std::make_shared<Result>(ResultOf(work, progress, post));
        return [done, result]() mutable { done(std::move(*result)); };
      }
    };
  }

  static void Run(const std::shared_ptr<State>& state);
  void Begin(Job job);
  void BeginAfterLast(Job job);
  void AwaitEnd();
  void GiveUp();
  void EndStopped();
  void Finish(const std::shared_ptr<State>& ended);
  /// Asks the thread to stop, and takes nothing from it any more.
  /// @returns the state of the work; null if nothing runs
  std::shared_ptr<State> LeaveAlone();

  std::shared_ptr<State> state; ///< null if nothing runs
  Job next;                     ///< waits for the end of the work
  QTimer patience;              ///< runs out for work that was asked to stop
};

/// Runs a function that may never end, because it asks for a file on a disk of the network that is
/// gone, in a thread of its own, for a caller that waits. The function owns all that it uses.
/// @returns its result; nothing if it has not ended after three seconds, and the thread is left
/// alone
template <class Function>
auto ResultInTime(Function function) -> std::optional<decltype(function())>
{
  std::packaged_task<decltype(function())()> packaged(std::move(function));
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
