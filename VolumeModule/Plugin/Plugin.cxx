// The library that VTK loads from VTK_AUTOLOAD_PATH. It does not link to VTK, so that it can be
// loaded into a program with any VTK, and can report a mismatch there instead of loading a second
// VTK into the process. VTK calls vtkGetFactoryVersion and accepts the factory if the answer equals
// its own version. Any other answer appears in VTK's warning that it rejects the factory, and VTK's
// own mapper draws.

#include "PluginNames.h"

#include <dlfcn.h>

#include <string>

class vtkObjectFactory;

namespace
{

using NewFactory = vtkObjectFactory* (*)();

// Never closed, because objects that the factory has created may outlive it.
NewFactory FindNewFactory()
{
  static void* const library = dlopen(varimarch::FactoryLibraryName, RTLD_NOW);
  return library ? reinterpret_cast<NewFactory>(dlsym(library, "VarimarchNewObjectFactory"))
                 : nullptr;
}

std::string AnswerForVersion()
{
  // The same version of VTK from another package would be a second copy in the program.
  if (!dlopen(varimarch::VtkLibraryName, RTLD_LAZY | RTLD_NOLOAD))
  {
    return std::string(varimarch::VtkVersion) + " as in " + varimarch::VtkLibraryName +
      ", which this program does not use; VTK's own mapper draws";
  }
  if (!FindNewFactory())
  {
    return std::string("none, for Varimarch cannot be loaded: ") + dlerror() +
      "; VTK's own mapper draws";
  }
  return varimarch::VtkVersion;
}

}

extern "C" [[gnu::visibility("default")]] const char* vtkGetFactoryVersion()
{
  static const std::string answer = AnswerForVersion();
  return answer.c_str();
}

extern "C" [[gnu::visibility("default")]] vtkObjectFactory* vtkLoad()
{
  return FindNewFactory()();
}
