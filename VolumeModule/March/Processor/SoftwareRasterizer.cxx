#include "March/Processor/SoftwareRasterizer.h"
#include "VtkVersions.h"

#include <string>

namespace varimarch
{

bool IsSoftwareRasterizer()
{
  const auto* const renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return renderer && std::string(renderer).find("llvmpipe") != std::string::npos;
}

}
