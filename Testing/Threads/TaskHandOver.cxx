// Tells ThreadSanitizer that a task which Qt's pool of threads runs comes after what its giver did.
// Qt is not built with the sanitizer, so that it does not see the lock of the pool.

#include <QRunnable>
#include <QThreadPool>

#include <dlfcn.h>
#include <sanitizer/tsan_interface.h>

namespace
{

/// A task that was given to the pool.
class HandedOver : public QRunnable
{
public:
  explicit HandedOver(QRunnable* task)
    : task(task)
  {
    __tsan_release(this);
  }

  void run() override
  {
    __tsan_acquire(this);
    const bool isOwned = this->task->autoDelete();
    this->task->run();
    if (isOwned)
    {
      delete this->task;
    }
  }

private:
  QRunnable* task;
};

}

// The program's own definition takes the place of Qt's.
void QThreadPool::start(QRunnable* task, int priority)
{
  using Start = void (*)(QThreadPool*, QRunnable*, int);
  static const auto start =
    reinterpret_cast<Start>(dlsym(RTLD_NEXT, "_ZN11QThreadPool5startEP9QRunnablei"));
  start(this, new HandedOver(task), priority);
}
