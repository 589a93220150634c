#include "Viewer/Model/BackgroundTask.h"

#include <QMetaObject>

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>

namespace varimarch
{

// State that the thread shares with the task, which may end before it.
struct BackgroundTask::State
{
  Job job;
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
  this->patience.setSingleShot(true);
  this->patience.setInterval(std::chrono::seconds(2));
  connect(&this->patience, &QTimer::timeout, this, &BackgroundTask::GiveUp);
}

BackgroundTask::~BackgroundTask()
{
  if (const std::shared_ptr<State> last = this->LeaveAlone())
  {
    std::unique_lock<std::mutex> lock(last->mutex);
    last->endedChanged.wait_for(
      lock, this->patience.intervalAsDuration(), [&] { return last->hasEnded; });
  }
}

void BackgroundTask::Begin(Job job)
{
  this->Cancel();
  this->state = std::make_shared<State>();
  this->state->job = std::move(job);
  this->state->owner = this;
  std::thread(&BackgroundTask::Run, this->state).detach();
  emit this->RunningChanged(true);
}

void BackgroundTask::BeginAfterLast(Job job)
{
  if (!this->state)
  {
    this->Begin(std::move(job));
    return;
  }
  this->next = std::move(job);
  this->AwaitEnd();
}

// Runs in the thread.
void BackgroundTask::Run(const std::shared_ptr<State>& state)
{
  const TaskProgress progress = [&](double part)
  {
    const std::lock_guard<std::mutex> lock(state->mutex);
    if (state->owner && !state->stop)
    {
      emit state->owner->Progress(part);
    }
    return !state->stop;
  };
  const TaskPost post = [&](std::function<void()> show)
  {
    const std::lock_guard<std::mutex> lock(state->mutex);
    if (state->owner)
    {
      const auto showIfWanted = [owner = state->owner, state, show = std::move(show)]
      {
        if (owner->state == state && !state->stop)
        {
          show();
        }
      };
      QMetaObject::invokeMethod(state->owner, showIfWanted, Qt::QueuedConnection);
    }
  };
  try
  {
    state->done = state->job(progress, post);
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
  state->job = nullptr; // it may own large results
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
    return; // it was left alone
  }
  this->state = nullptr;
  this->patience.stop();
  if (ended->stop)
  {
    this->EndStopped();
    return;
  }
  emit this->RunningChanged(false);
  if (!ended->failure.isEmpty())
  {
    emit this->Failed(ended->failure);
  }
  else if (ended->done)
  {
    ended->done();
  }
}

void BackgroundTask::Cancel()
{
  if (this->LeaveAlone())
  {
    emit this->RunningChanged(false);
  }
}

void BackgroundTask::Stop()
{
  if (this->state)
  {
    this->next = nullptr;
    this->AwaitEnd();
  }
}

void BackgroundTask::AwaitEnd()
{
  if (!this->state->stop.exchange(true))
  {
    this->patience.start();
  }
}

// The work does not end, and is left alone.
void BackgroundTask::GiveUp()
{
  Job following = std::move(this->next);
  this->LeaveAlone();
  this->next = std::move(following);
  this->EndStopped();
}

void BackgroundTask::EndStopped()
{
  if (this->next)
  {
    this->Begin(std::exchange(this->next, nullptr));
    return;
  }
  emit this->RunningChanged(false);
  emit this->Stopped();
}

std::shared_ptr<BackgroundTask::State> BackgroundTask::LeaveAlone()
{
  this->next = nullptr;
  this->patience.stop();
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
