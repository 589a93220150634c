#include "March/Device/GraphicsReset.h"

#include "VtkVersions.h"

namespace varimarch
{

void CheckForGraphicsReset()
{
  // A function of OpenGL 4.5, whose name stands for a pointer.
  const bool isKnown = glGetGraphicsResetStatus != nullptr;
  const bool isTold = isKnown && glGetGraphicsResetStatus() != GL_NO_ERROR;
  // Somebody else may have asked before, such as Qt; a lost context then answers nothing.
  if (isTold || !glGetString(GL_VERSION))
  {
    throw GraphicsReset("The graphics card was reset while the image was drawn: start the program "
                        "again, or make a new window; if this happens again, choose a smaller "
                        "image, or another driver");
  }
}

}
