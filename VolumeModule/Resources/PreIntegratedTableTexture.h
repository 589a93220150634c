#ifndef Varimarch_Resources_PreIntegratedTableTexture_h
#define Varimarch_Resources_PreIntegratedTableTexture_h

#include "Core/Look/PreIntegratedTable.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A PreIntegratedTable on the device, or in memory if the processor marches.
class PreIntegratedTableTexture
{
public:
  void Upload(vtkOpenGLRenderWindow* window, PreIntegratedTable table);
  void Keep(vtkWindow* window, PreIntegratedTable table);

  bool IsKept() const { return !this->kept.entries.empty(); }
  const PreIntegratedTable& Kept() const { return this->kept; }
  vtkTextureObject* Texture() const { return this->texture; }
  int EntriesPerSide() const { return this->IsKept() ? this->kept.size : this->size; }
  std::size_t Bytes() const { return std::size_t(this->size) * this->size * sizeof(glm::vec4); }
  void Release(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> texture;
  int size = 0; ///< The number of texels on a side.
  PreIntegratedTable kept = {};
};

}

#endif
