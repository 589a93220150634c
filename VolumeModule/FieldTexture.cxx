#include "FieldTexture.h"

#include "VolumeTexture.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSetGet.h"
#include "vtkType.h"
#include "vtk_glew.h"

#include <chrono>

namespace varimarch
{

namespace
{

VariationField FieldOf(vtkDataArray* scalars, glm::ivec3 dimensions, double tolerance)
{
  void* const voxels = scalars->GetVoidPointer(0);
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(return BuildVariationField(
      ScalarGrid<VTK_TT>(static_cast<VTK_TT*>(voxels), dimensions), tolerance));
  }
  return {};
}

}

void FieldTexture::Build(
  vtkOpenGLRenderWindow* window, vtkDataArray* scalars, glm::ivec3 dimensions, double tolerance)
{
  const auto start = std::chrono::steady_clock::now();
  const VariationField field = FieldOf(scalars, dimensions, tolerance);
  this->buildSeconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  this->cellCount = field.cellCount;
  AllocateTexture3D(
    this->texture, window, field.cellCount, VTK_UNSIGNED_CHAR, GL_R8, "a variation field");
  this->bytes = field.cells.size();

  // Nearest: a value between two cells' radii would promise what neither proves.
  this->texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, field.cellCount.x, field.cellCount.y,
    field.cellCount.z, GL_RED, GL_UNSIGNED_BYTE, field.cells.data());
  this->texture->Deactivate();
}

void FieldTexture::Release(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
  this->bytes = 0;
}

}
