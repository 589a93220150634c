#ifndef Varimarch_Testing_UserFaults_h
#define Varimarch_Testing_UserFaults_h

#include <fcntl.h>
#include <linux/userfaultfd.h>
#include <sys/syscall.h>
#include <unistd.h>

/// True if the system lets this process read voxels at page faults. Containers often refuse it.
inline bool HasUserFaults()
{
  const auto descriptor = int(syscall(SYS_userfaultfd, O_CLOEXEC | UFFD_USER_MODE_ONLY));
  if (descriptor >= 0)
  {
    close(descriptor);
  }
  return descriptor >= 0;
}

#endif
