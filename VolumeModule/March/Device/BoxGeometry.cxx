#include "March/Device/BoxGeometry.h"
#include "VtkVersions.h"

#include "vtkShaderProgram.h"
#include "vtkType.h"

#include <array>

namespace varimarch
{

namespace
{

// Corner i has the upper x, y or z if bit 0, 1 or 2 of i is set. Triangles are counterclockwise
// seen from outside.
const std::array<GLubyte, 36> corners = { 0, 2, 3, 0, 3, 1, /* z low */ 4, 5, 7, 4, 7,
  6,                                              /* z high */
  0, 1, 5, 0, 5, 4, /* y low */ 2, 6, 7, 2, 7, 3, /* y high */
  0, 4, 6, 0, 6, 2, /* x low */ 1, 3, 7, 1, 7, 5 /* x high */ };

}

void VolumeBoxGeometry::Draw(vtkShaderProgram* program, const Box& boxGrid)
{
  if (!this->vertices->GetHandle() || this->uploaded.lower != boxGrid.lower ||
    this->uploaded.upper != boxGrid.upper)
  {
    std::array<float, 24> positions;
    for (int corner = 0; corner < 8; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const bool upper = corner >> axis & 1;
        positions[3 * corner + axis] = float(upper ? boxGrid.upper[axis] : boxGrid.lower[axis]);
      }
    }
    this->vertices->Upload(positions.data(), positions.size(), vtkOpenGLBufferObject::ArrayBuffer);
    this->triangles->Upload(
      corners.data(), corners.size(), vtkOpenGLBufferObject::ElementArrayBuffer);
    this->uploaded = boxGrid;
  }

  if (this->attributesOf != program->GetHandle())
  {
    this->attributes->ShaderProgramChanged();
    this->attributesOf = program->GetHandle();
  }
  this->attributes->Bind();
  this->vertices->Bind();
  this->attributes->AddAttributeArray(
    program, this->vertices, "vertexGrid", 0, 3 * sizeof(float), VTK_FLOAT, 3, false);
  this->triangles->Bind();
  glDrawElements(GL_TRIANGLES, GLsizei(corners.size()), GL_UNSIGNED_BYTE, nullptr);
  this->triangles->Release();
  this->vertices->Release();
  this->attributes->Release();
}

void VolumeBoxGeometry::Release()
{
  this->attributes->ReleaseGraphicsResources();
  this->attributesOf = 0;
  this->vertices->ReleaseGraphicsResources();
  this->triangles->ReleaseGraphicsResources();
}

}
