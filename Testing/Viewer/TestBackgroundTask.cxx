// Work in a thread for a widget: what is told of it, and when.

#include "Viewer/Model/BackgroundTask.h"
#include "Waiting.h"

#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

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

TEST(BackgroundTask, HandsOverWhatTheWorkReturns)
{
  BackgroundTask task;
  std::vector<int> found;
  task.Start(
    [](const TaskProgress&) {
      return std::vector<int>{ 3, 5 };
    },
    [&](const std::vector<int>& returned) { found = returned; });
  EXPECT_TRUE(QTest::qWaitFor([&] { return !found.empty(); }, MostMilliseconds));
  EXPECT_EQ(found, (std::vector<int>{ 3, 5 }));
}

TEST(BackgroundTask, BeginsTheLatestOfSeveralWhenTheLastHasEnded)
{
  BackgroundTask task;
  std::atomic<int> atWork{ 0 };
  std::atomic<int> mostAtWork{ 0 };
  std::vector<int> told;
  const auto start = [&](int number)
  {
    task.StartAfterLast(
      [&, number](const TaskProgress& progress)
      {
        mostAtWork = std::max(int(mostAtWork), ++atWork);
        while (progress(0.5) && number == 1)
        {
          std::this_thread::yield();
        }
        --atWork;
        return number;
      },
      [&](int number) { told.push_back(number); });
  };
  start(1);
  EXPECT_TRUE(QTest::qWaitFor([&] { return atWork == 1; }, MostMilliseconds));
  start(2);
  start(3);
  EXPECT_TRUE(task.IsRunning());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !told.empty(); }, MostMilliseconds));
  EXPECT_EQ(told, std::vector<int>{ 3 });
  EXPECT_EQ(mostAtWork, 1);
  EXPECT_FALSE(task.IsRunning());
}

TEST(BackgroundTask, LeavesWorkAloneThatDoesNotEndInTime)
{
  BackgroundTask task;
  task.SetPatience(std::chrono::milliseconds(50));
  const auto mayEnd = std::make_shared<std::atomic<bool>>(false);
  bool firstIsTold = false;
  bool secondIsTold = false;
  task.Start(
    [mayEnd](const TaskProgress&)
    {
      while (!*mayEnd)
      {
        std::this_thread::yield();
      }
    },
    [&] { firstIsTold = true; });
  task.StartAfterLast([](const TaskProgress&) {}, [&] { secondIsTold = true; });
  EXPECT_TRUE(QTest::qWaitFor([&] { return secondIsTold; }, MostMilliseconds));
  *mayEnd = true;
  QTest::qWait(100);
  EXPECT_FALSE(firstIsTold);
}

TEST(BackgroundTask, TellsWhenItHasStopped)
{
  BackgroundTask task;
  bool hasStopped = false;
  bool isTold = false;
  QObject::connect(&task, &BackgroundTask::Stopped, [&] { hasStopped = true; });
  const auto mayEnd = std::make_shared<std::atomic<bool>>(false);
  task.Start(
    [mayEnd](const TaskProgress&)
    {
      while (!*mayEnd)
      {
        std::this_thread::yield();
      }
    },
    [&] { isTold = true; });
  task.Stop();
  EXPECT_TRUE(task.IsRunning()) << "until the work has ended";
  *mayEnd = true;
  EXPECT_TRUE(QTest::qWaitFor([&] { return hasStopped; }, MostMilliseconds));
  EXPECT_FALSE(task.IsRunning());
  EXPECT_FALSE(isTold);
}

TEST(BackgroundTask, PostsWhatItHasFoundSoFarUntilItIsCancelled)
{
  BackgroundTask task;
  const auto mayEnd = std::make_shared<std::atomic<bool>>(false);
  const auto hasEnded = std::make_shared<std::atomic<bool>>(false);
  std::vector<int> found;
  task.Start(
    [&found, mayEnd, hasEnded](const TaskProgress&, const TaskPost& post)
    {
      post([&] { found.push_back(1); });
      while (!*mayEnd)
      {
        std::this_thread::yield();
      }
      post([&] { found.push_back(2); });
      *hasEnded = true;
    },
    [] {});
  EXPECT_TRUE(QTest::qWaitFor([&] { return !found.empty(); }, MostMilliseconds));
  task.Cancel();
  *mayEnd = true;
  LetTheThreadEnd(*hasEnded);
  QTest::qWait(100);
  EXPECT_EQ(found, std::vector<int>{ 1 });
}
