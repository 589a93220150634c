// The object factory that makes our mapper where a program asks for vtkGPUVolumeRayCastMapper.
//
// It links to VTK's core alone, and loads our module with the first mapper. That keeps programs
// without volumes as they are, and it has to be so: VTK takes the factory that was registered
// first, and the libraries that the module needs register VTK's own as soon as they are loaded.

#include "PluginNames.h"

#include "vtkObjectFactory.h"
#include "vtkVersion.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string>

namespace
{

using NewMapper = vtkObject* (*)();

bool IsDisabled()
{
  const char* disable = std::getenv("VARIMARCH_DISABLE");
  return disable && std::string(disable) != "" && std::string(disable) != "0";
}

NewMapper LoadNewMapper()
{
  void* library = dlopen(varimarch::ModuleLibraryName, RTLD_NOW);
  void* newMapper = library ? dlsym(library, "VarimarchNewGPUVolumeRayCastMapper") : nullptr;
  if (!newMapper)
  {
    vtkGenericWarningMacro(
      "Varimarch cannot be loaded: " << dlerror() << "; VTK's own mapper draws.");
  }
  return reinterpret_cast<NewMapper>(newMapper);
}

// Nothing, where our module cannot be loaded: then VTK asks the next factory, its own.
vtkObject* CreateMapper()
{
  static const NewMapper newMapper = LoadNewMapper();
  return newMapper ? newMapper() : nullptr;
}

class vtkVarimarchObjectFactory : public vtkObjectFactory
{
public:
  static vtkVarimarchObjectFactory* New();
  vtkTypeMacro(vtkVarimarchObjectFactory, vtkObjectFactory);

  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Varimarch: volumes by variation fields"; }

protected:
  vtkVarimarchObjectFactory()
  {
    // Disabled, it is still there, so that a program may enable it with SetAllEnableFlags.
    this->RegisterOverride("vtkGPUVolumeRayCastMapper", "vtkVariationFieldGPUVolumeRayCastMapper",
      "Varimarch", !IsDisabled(), CreateMapper);
  }
};

vtkStandardNewMacro(vtkVarimarchObjectFactory);

}

extern "C" [[gnu::visibility("default")]] vtkObjectFactory* VarimarchNewObjectFactory()
{
  return vtkVarimarchObjectFactory::New();
}
