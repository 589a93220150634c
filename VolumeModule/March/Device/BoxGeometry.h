#ifndef Varimarch_March_Device_BoxGeometry_h
#define Varimarch_March_Device_BoxGeometry_h

#include "Core/Geometry/Box.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLVertexArrayObject.h"

class vtkShaderProgram;

namespace varimarch
{

/// The volume's box as triangles in grid space. Its inner faces cover each pixel whose ray meets
/// the volume exactly once, wherever the camera is.
class VolumeBoxGeometry
{
public:
  /// Draws the box with a program that takes positions as vertexGrid.
  void Draw(vtkShaderProgram* program, const Box& boxGrid);
  void Release();

private:
  // The handle of the program that has the attributes. A program gets another one when a window
  // that shares it is closed.
  int attributesOf = 0;
  Box uploaded = { glm::dvec3(0.0), glm::dvec3(0.0) };
  vtkNew<vtkOpenGLBufferObject> vertices;
  vtkNew<vtkOpenGLBufferObject> triangles;
  vtkNew<vtkOpenGLVertexArrayObject> attributes;
};

}

#endif
