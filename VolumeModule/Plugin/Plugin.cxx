// What VTK loads from VTK_AUTOLOAD_PATH. It links to no VTK, so that it loads into a program of any
// VTK, and can say there why it does not fit, instead of pulling a second VTK into the process.
// VTK asks vtkGetFactoryVersion, and takes the factory if the answer is its own version; any other
// answer stands in the warning with which it rejects the factory, and its own mapper goes on
// drawing.

#include "PluginNames.h"

#include <dlfcn.h>

#include <string>

class vtkObjectFactory;

namespace
{

using NewFactory = vtkObjectFactory* (*)();

// Never closed: what the factory has made may outlive it.
NewFactory FindNewFactory()
{
  static void* const library = dlopen(varimarch::FactoryLibraryName, RTLD_NOW);
  return library ? reinterpret_cast<NewFactory>(dlsym(library, "VarimarchNewObjectFactory"))
                 : nullptr;
}

std::string AnswerForVersion()
{
  // VTK of the same version from another package would be another copy beside the program's own.
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
