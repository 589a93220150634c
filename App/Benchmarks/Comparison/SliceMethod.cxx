#include "SliceMethod.h"

#include "SliceGeometry.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

/// A slice's triangles.
struct DrawnSlice
{
  std::size_t firstCorner;
  std::size_t cornerCount;
  int voxelSlice; ///< the slice of voxels that it shows; only for 2D textures
};

/// The slices of a picture, in the order in which they are drawn.
struct SliceSet
{
  std::vector<glm::vec3> triangles;
  std::vector<DrawnSlice> slices;
  double sliceMm;
};

void AddSlice(SliceSet& set, const Box& box, const glm::dvec4& plane, int voxelSlice = 0)
{
  const std::size_t first = set.triangles.size();
  AddFan(SlicePolygon(box, plane), set.triangles);
  set.slices.push_back({ first, set.triangles.size() - first, voxelSlice });
}

glm::dvec3 NormalOfStack(int axis, const ComparisonFrame& frame)
{
  const VolumeGeometry& geometry = frame.volume.Geometry();
  const glm::dvec3 normal = glm::normalize(geometry.WorldFromGridNormal()[axis]);
  return glm::dot(normal, frame.view.directionWorld) < 0.0 ? -normal : normal;
}

SliceSet SlicesAlong(const ComparisonFrame& frame, const glm::dvec3& normal, bool fromBehind)
{
  const VolumeGeometry& geometry = frame.volume.Geometry();
  std::vector<glm::dvec4> planes =
    PlanesAlong(normal, frame.sampleDistanceMm, geometry.boxGrid, geometry.worldFromGrid);
  if (fromBehind)
  {
    std::reverse(planes.begin(), planes.end());
  }
  SliceSet set = { {}, {}, frame.sampleDistanceMm };
  for (const glm::dvec4& plane : planes)
  {
    AddSlice(set, geometry.boxGrid, plane);
  }
  return set;
}

// The slices of voxels themselves; each n-th, as the sample distance has it.
SliceSet SlicesOfVoxels(const ComparisonFrame& frame, int axis, bool fromBehind)
{
  const VolumeGeometry& geometry = frame.volume.Geometry();
  const double spacingMm = glm::length(glm::dvec3(geometry.worldFromGrid[axis]));
  const int apart = std::max(int(std::lround(frame.sampleDistanceMm / spacingMm)), 1);
  // Slices in a face of the box would be cut away by rounding.
  const Box box = { geometry.boxGrid.lower - 1e-6, geometry.boxGrid.upper + 1e-6 };
  SliceSet set = { {}, {}, apart * spacingMm };
  for (int slice = 0; slice < geometry.dimensions[axis]; slice += apart)
  {
    glm::dvec4 plane(0.0, 0.0, 0.0, -slice);
    plane[axis] = 1.0;
    AddSlice(set, box, plane, slice);
  }
  const glm::dvec3 axisWorld(geometry.worldFromGrid[axis]);
  const bool isNearestFirst = glm::dot(axisWorld, frame.view.directionWorld) > 0.0;
  if (isNearestFirst == fromBehind)
  {
    std::reverse(set.slices.begin(), set.slices.end());
  }
  return set;
}

// @param light  parts of a light that arrive, or null
void DrawFrom3DTexture(const ComparisonFrame& frame, const SliceSet& set, vtkTextureObject* light)
{
  frame.Use("Slice.frag.glsl", light ? "Shadow/LightVolume.glsl" : NoShadow);
  frame.program.Set("clipFromGrid", glm::mat4(frame.view.clipFromGrid));
  if (light)
  {
    frame.program.Set("lightVolume", light);
  }
  frame.program.Set("sliceMm", float(set.sliceMm));
  frame.program.SetTriangles(set.triangles);
  frame.program.DrawAll();
  frame.program.DeactivateTextures();
}

void DrawFrom2DTextures(const ComparisonFrame& frame, int axis, const SliceSet& set)
{
  const auto& stack = frame.volume.Stack(frame.view.window, axis);
  frame.program.Use(
    frame.view.window, "Grid.vert.glsl", frame.volume.FragmentFilesOfStack("Slice.frag.glsl"));
  frame.volume.SetUniforms(frame.program, frame.view.eyeGrid);
  frame.program.Set("clipFromGrid", glm::mat4(frame.view.clipFromGrid));
  frame.program.Set("sliceMm", float(set.sliceMm));
  frame.program.Set("sliceAxes", glm::ivec2(axis == 0 ? 1 : 0, axis == 2 ? 1 : 2));
  frame.program.SetTriangles(set.triangles);
  for (const DrawnSlice& slice : set.slices)
  {
    vtkTextureObject* const texture = stack[slice.voxelSlice];
    texture->Activate();
    frame.program.Set("sliceTexture", texture->GetTextureUnit());
    frame.program.Draw(slice.firstCorner, slice.cornerCount);
    texture->Deactivate();
  }
  frame.program.DeactivateTextures();
}

void DrawShells(const ComparisonFrame& frame, bool fromBehind)
{
  const VolumeGeometry& geometry = frame.volume.Geometry();
  std::vector<double> radii = ShellRadii(
    frame.view.eyeWorld, frame.sampleDistanceMm, geometry.boxGrid, geometry.worldFromGrid);
  if (fromBehind)
  {
    std::reverse(radii.begin(), radii.end());
  }
  frame.Use("Shell.frag.glsl");
  frame.program.Set("clipFromGrid", glm::mat4(frame.view.clipFromGrid));
  frame.program.Set("sliceMm", float(frame.sampleDistanceMm));
  frame.program.SetTriangles(CoverOf(geometry.boxGrid, frame.view.clipFromGrid));
  for (const double radius : radii)
  {
    frame.program.Set("radiusMm", float(radius));
    frame.program.DrawAll();
  }
  frame.program.DeactivateTextures();
}

}

void DrawSlices(const ComparisonFrame& frame, Slices slices, bool fromBehind)
{
  const int axis = StackAxis(frame.view.directionWorld, frame.volume.Geometry().worldFromGrid);
  if (slices == Slices::Shells && !frame.view.isParallel)
  {
    DrawShells(frame, fromBehind);
  }
  else if (slices == Slices::Object2D)
  {
    DrawFrom2DTextures(frame, axis, SlicesOfVoxels(frame, axis, fromBehind));
  }
  else
  {
    const glm::dvec3 normal =
      slices == Slices::Object ? NormalOfStack(axis, frame) : frame.view.directionWorld;
    DrawFrom3DTexture(frame, SlicesAlong(frame, normal, fromBehind), nullptr);
  }
}

void DrawLitSlices(const ComparisonFrame& frame, vtkTextureObject* light, bool fromBehind)
{
  DrawFrom3DTexture(frame, SlicesAlong(frame, frame.view.directionWorld, fromBehind), light);
}

}
