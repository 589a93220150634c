#ifndef Varimarch_Viewer_BackgroundTask_h
#define Varimarch_Viewer_BackgroundTask_h

#include <QObject>
#include <QString>

#include <functional>
#include <memory>

namespace varimarch
{

/// Receives the fraction of the work done, [0, 1], or a negative number if that is unknown; returns
/// false to cancel.
using TaskProgress = std::function<bool(double)>;

/// Work in a thread, one at a time, for a widget that goes on meanwhile. Work that does not stop
/// when it is cancelled, because a disk or a computer does not answer, is left alone, so it must
/// own all that it uses.
class BackgroundTask : public QObject
{
  Q_OBJECT

public:
  explicit BackgroundTask(QObject* parent = nullptr);
  ~BackgroundTask() override;

  /// Cancels the last work and starts another.
  /// @param work  runs in the thread; reports a failure by a std::exception, and that it was
  /// cancelled by any other
  /// @param done  runs in this object's thread after success
  void Start(std::function<void(const TaskProgress&)> work, std::function<void()> done);

  /// Returns at once. There will be no signal of the work.
  void Cancel();

  bool IsRunning() const { return this->state != nullptr; }

signals:
  /// @param part  as for TaskProgress
  void Progress(double part);
  /// @param reason  one sentence
  void Failed(const QString& reason);
  /// Work has begun, or has ended in any way.
  void RunningChanged(bool isRunning);

private:
  struct State;

  static void Run(const std::shared_ptr<State>& state);
  void Finish(const std::shared_ptr<State>& ended);
  /// Asks the thread to stop, and takes nothing from it any more.
  /// @returns the state of the work; null if nothing runs
  std::shared_ptr<State> LeaveAlone();

  std::shared_ptr<State> state; ///< null if nothing runs
};

}

#endif
