// The object factory that creates the module's mapper when a program asks for
// vtkGPUVolumeRayCastMapper.
//
// It links only to VTK's core, and loads the module with the first mapper. Programs without volumes
// are therefore not affected. It also has to be so: VTK uses the factory that was registered first,
// and the module's libraries register VTK's own factory as soon as they are loaded.

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

// Returns null if the module cannot be loaded; VTK then asks the next factory, its own.
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
    // A disabled override is registered too, so that a program can enable it with
    // SetAllEnableFlags.
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
