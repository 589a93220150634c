#include "Readers/Dicom/SilentErrors.h"

#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

namespace varimarch
{
namespace
{

std::mutex outputMutex;

}

SilentErrors::SilentErrors()
  : lock(outputMutex)
{
  std::fflush(stderr);
  this->printed = dup(STDERR_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (this->printed >= 0 && nowhere >= 0)
  {
    dup2(nowhere, STDERR_FILENO);
  }
  if (nowhere >= 0)
  {
    close(nowhere);
  }
}

SilentErrors::~SilentErrors()
{
  if (this->printed >= 0)
  {
    std::fflush(stderr);
    dup2(this->printed, STDERR_FILENO);
    close(this->printed);
  }
}

}
