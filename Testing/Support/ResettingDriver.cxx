#include "Support/ResettingDriver.h"

#include "VtkVersions.h"

#include <utility>

namespace
{

// Presets are drawn in a thread with a context of its own, which is not lost.
thread_local int resetsToTell = 0;

GLenum Status()
{
  return resetsToTell > 0 && resetsToTell-- > 0 ? GL_UNKNOWN_CONTEXT_RESET : GL_NO_ERROR;
}

decltype(glGetGraphicsResetStatus) statusOfDriver = nullptr;

}

ResettingDriver::ResettingDriver(int count)
{
  resetsToTell = count;
  statusOfDriver = std::exchange(glGetGraphicsResetStatus, Status);
}

ResettingDriver::~ResettingDriver()
{
  resetsToTell = 0;
  glGetGraphicsResetStatus = statusOfDriver;
}

bool ResettingDriver::CanTell()
{
  return glGetGraphicsResetStatus != nullptr;
}
