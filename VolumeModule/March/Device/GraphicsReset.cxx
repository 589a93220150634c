#include "March/Device/GraphicsReset.h"

#include "VtkVersions.h"

#include <stdexcept>

namespace varimarch
{

void CheckForGraphicsReset()
{
  // A function of OpenGL 4.5, whose name stands for a pointer.
  const bool isKnown = glGetGraphicsResetStatus != nullptr;
  if (isKnown && glGetGraphicsResetStatus() != GL_NO_ERROR)
  {
    throw std::runtime_error("The graphics card was reset while the image was drawn: start the "
                             "program again, or make a new window; if this happens again, choose a "
                             "smaller image, or another driver");
  }
}

}
