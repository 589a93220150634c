// Work in a thread for a widget: what is told of it, and when.

#include "Viewer/Model/BackgroundTask.h"
#include "Waiting.h"

#include <QTest>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

using namespace varimarch;

namespace
{

// Waits without events, so that the end of work is not told yet.
void LetTheThreadEnd(const std::atomic<bool>& isDone)
{
  while (!isDone)
  {
    std::this_thread::yield();
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200)); // the thread frees what it had
}

}

TEST(BackgroundTask, ThatWasReplacedAsItEndedFinishesNoOther)
{
  BackgroundTask task;
  std::atomic<bool> firstHasRun{ false };
  bool firstIsTold = false;
  bool secondIsTold = false;
  task.Start([&](const TaskProgress&) { firstHasRun = true; }, [&] { firstIsTold = true; });
  LetTheThreadEnd(firstHasRun);
  std::atomic<bool> mayEnd{ false };
  task.Start(
    [&](const TaskProgress&)
    {
      while (!mayEnd)
      {
        std::this_thread::yield();
      }
    },
    [&] { secondIsTold = true; });
  QTest::qWait(100);
  EXPECT_FALSE(firstIsTold);
  EXPECT_FALSE(secondIsTold) << "before its work has ended";
  EXPECT_TRUE(task.IsRunning());
  mayEnd = true;
  EXPECT_TRUE(QTest::qWaitFor([&] { return secondIsTold; }, MostMilliseconds));
  EXPECT_FALSE(task.IsRunning());
}

TEST(BackgroundTask, ThatIsCancelledTellsNothing)
{
  BackgroundTask task;
  std::atomic<bool> hasRun{ false };
  bool isTold = false;
  QObject::connect(&task, &BackgroundTask::Failed, [&] { isTold = true; });
  task.Start(
    [&](const TaskProgress&)
    {
      hasRun = true;
      throw std::runtime_error("It has failed.");
    },
    [&] { isTold = true; });
  LetTheThreadEnd(hasRun);
  task.Cancel();
  QTest::qWait(100);
  EXPECT_FALSE(isTold);
  EXPECT_FALSE(task.IsRunning());
}
