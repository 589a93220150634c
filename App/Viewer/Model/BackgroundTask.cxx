#include "Viewer/Model/BackgroundTask.h"

#include <QMetaObject>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

namespace varimarch
{

// State that the thread shares with the task, which may end before it.
struct BackgroundTask::State
{
  std::function<void(const TaskProgress&)> work;
  std::function<void()> done;
  std::atomic<bool> stop{ false };
  QString failure;

  std::mutex mutex;
  std::condition_variable endedChanged;
  BackgroundTask* owner; ///< null if it has left the thread alone
  bool hasEnded = false;
};

BackgroundTask::BackgroundTask(QObject* parent)
  : QObject(parent)
{
}

BackgroundTask::~BackgroundTask()
{
  if (const std::shared_ptr<State> last = this->LeaveAlone())
  {
    std::unique_lock<std::mutex> lock(last->mutex);
    last->endedChanged.wait_for(lock, std::chrono::seconds(2), [&] { return last->hasEnded; });
  }
}

void BackgroundTask::Start(
  std::function<void(const TaskProgress&)> work, std::function<void()> done)
{
  this->Cancel();
  this->state = std::make_shared<State>();
  this->state->work = std::move(work);
  this->state->done = std::move(done);
  this->state->owner = this;
  std::thread(&BackgroundTask::Run, this->state).detach();
  emit this->RunningChanged(true);
}

// Runs in the thread.
void BackgroundTask::Run(const std::shared_ptr<State>& state)
{
  try
  {
    state->work(
      [&](double part)
      {
        const std::lock_guard<std::mutex> lock(state->mutex);
        if (state->owner)
        {
          emit state->owner->Progress(part);
        }
        return !state->stop;
      });
  }
  catch (const std::bad_alloc&)
  {
    state->failure = tr("There is not enough memory.");
  }
  catch (const std::exception& problem)
  {
    state->failure = QString::fromStdString(problem.what());
  }
  catch (...)
  {
    // The work was cancelled, which each library reports by an exception of its own.
  }
  state->work = nullptr; // it may own large results
  const std::lock_guard<std::mutex> lock(state->mutex);
  state->hasEnded = true;
  state->endedChanged.notify_all();
  if (state->owner)
  {
    QMetaObject::invokeMethod(
      state->owner, [owner = state->owner, state] { owner->Finish(state); }, Qt::QueuedConnection);
  }
}

void BackgroundTask::Finish(const std::shared_ptr<State>& ended)
{
  if (ended != this->state)
  {
    return; // it was cancelled
  }
  this->state = nullptr;
  emit this->RunningChanged(false);
  if (ended->failure.isEmpty())
  {
    ended->done();
  }
  else
  {
    emit this->Failed(ended->failure);
  }
}

void BackgroundTask::Cancel()
{
  if (this->LeaveAlone())
  {
    emit this->RunningChanged(false);
  }
}

std::shared_ptr<BackgroundTask::State> BackgroundTask::LeaveAlone()
{
  std::shared_ptr<State> last = std::exchange(this->state, nullptr);
  if (last)
  {
    last->stop = true;
    const std::lock_guard<std::mutex> lock(last->mutex);
    last->owner = nullptr;
  }
  return last;
}

}
