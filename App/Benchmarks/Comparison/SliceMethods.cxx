#include "ComparisonMethods.h"

#include "SliceGeometry.h"
#include "VtkVersions.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <glm/common.hpp>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

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

namespace
{

// Distances between neighbouring voxels along each axis [mm].
glm::dvec3 SpacingsMm(const VolumeGeometry& geometry)
{
  const glm::dmat3 worldFromGrid = geometry.WorldFromGridDirection();
  return { glm::length(worldFromGrid[0]), glm::length(worldFromGrid[1]),
    glm::length(worldFromGrid[2]) };
}

// Points that are as far apart along each axis as the voxels allow.
glm::ivec3 PointsFor(const VolumeGeometry& geometry, int mostPoints)
{
  const glm::dvec3 cells = glm::max(geometry.dimensions - 1, glm::ivec3(1));
  const glm::dvec3 lengths = cells * SpacingsMm(geometry);
  const double longest = std::max({ lengths.x, lengths.y, lengths.z });
  const glm::dvec3 points = glm::ceil(double(mostPoints - 1) * lengths / longest) + 1.0;
  return glm::max(glm::ivec3(glm::min(points, cells + 1.0)), glm::ivec3(2));
}

// Optical depth between a point and a distant light, by samples in the middles of steps.
double OpticalDepth(const ComparisonVolume& volume, const Ray& toLightGrid, double stepMm)
{
  const ScalarGrid<float> texels = volume.Texels();
  const Interval inside = Intersection(toLightGrid, volume.Geometry().boxGrid);
  double depth = 0.0;
  for (double t = inside.enter; t < inside.exit; t += stepMm)
  {
    const double lengthMm = std::min(stepMm, inside.exit - t);
    const glm::dvec3 middle = toLightGrid.origin + (t + 0.5 * lengthMm) * toLightGrid.direction;
    depth += volume.Extinction(texels.Value(middle)) * lengthMm;
  }
  return depth;
}

std::vector<float> LightAt(
  const ComparisonVolume& volume, glm::ivec3 points, const glm::dvec3& toLightWorld)
{
  const VolumeGeometry& geometry = volume.Geometry();
  const glm::dvec3 directionGrid = glm::inverse(geometry.WorldFromGridDirection()) * toLightWorld;
  const glm::dvec3 spacings = SpacingsMm(geometry);
  const double stepMm = std::min({ spacings.x, spacings.y, spacings.z });
  const Box& box = geometry.boxGrid;
  std::vector<float> light(std::size_t(points.x) * points.y * points.z);
  tbb::parallel_for(0, points.y * points.z,
    [&](int row)
    {
      for (int x = 0; x < points.x; ++x)
      {
        const glm::dvec3 part =
          glm::dvec3(x, row % points.y, row / points.y) / glm::dvec3(points - 1);
        const Ray ray = { glm::mix(box.lower, box.upper, part), directionGrid };
        light[std::size_t(row) * points.x + x] =
          float(std::exp(-OpticalDepth(volume, ray, stepMm)));
      }
    });
  return light;
}

}

void LightVolumeMethod::Draw(const ComparisonFrame& frame, int mostPoints, bool fromBehind)
{
  this->Update(frame, mostPoints);
  DrawLitSlices(frame, this->light, fromBehind);
}

void LightVolumeMethod::Update(const ComparisonFrame& frame, int mostPoints)
{
  const glm::dvec3& toLightWorld = frame.toLightWorld;
  if (this->builtVersion == frame.volume.Version() && this->builtFor == toLightWorld &&
    this->builtMostPoints == mostPoints)
  {
    return;
  }
  vtkOpenGLRenderWindow* const window = frame.view.window;
  const glm::ivec3 points = PointsFor(frame.volume.Geometry(), mostPoints);
  std::vector<float> texels = LightAt(frame.volume, points, toLightWorld);
  this->Release(window);
  this->light->SetContext(window);
  this->light->SetInternalFormat(GL_R32F);
  this->light->SetFormat(GL_RED);
  this->light->SetDataType(GL_FLOAT);
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (!this->light->Create3DFromRaw(
        unsigned(points.x), unsigned(points.y), unsigned(points.z), 1, VTK_FLOAT, texels.data()))
  {
    throw std::runtime_error("A comparison method found no memory for a texture of light");
  }
  FilterLinearly(this->light);
  this->builtVersion = frame.volume.Version();
  this->builtFor = toLightWorld;
  this->builtMostPoints = mostPoints;
}

std::size_t LightVolumeMethod::Bytes() const
{
  return this->builtVersion < 0
    ? 0
    : sizeof(float) * this->light->GetWidth() * this->light->GetHeight() * this->light->GetDepth();
}

void LightVolumeMethod::Release(vtkWindow* window)
{
  this->light->ReleaseGraphicsResources(window);
  this->builtVersion = -1;
}

namespace
{

constexpr int BufferSide = 256; // pixels of the buffer of light along each side

/// The view of a distant light of the whole volume.
glm::dmat4 LightFromGrid(const VolumeGeometry& geometry, const glm::dvec3& toLightWorld)
{
  const glm::dvec3 middle(geometry.worldFromGrid *
    glm::dvec4(0.5 * (geometry.boxGrid.lower + geometry.boxGrid.upper), 1.0));
  const double radiusMm = 0.5 * geometry.DiagonalMm();
  const glm::dvec3 up =
    std::abs(toLightWorld.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dmat4 view = glm::lookAt(middle + 2.0 * radiusMm * toLightWorld, middle, up);
  return glm::ortho(-radiusMm, radiusMm, -radiusMm, radiusMm, radiusMm, 3.0 * radiusMm) * view *
    geometry.worldFromGrid;
}

void DrawSlice(const ComparisonFrame& frame, const std::vector<glm::vec3>& slice)
{
  frame.program.SetTriangles(slice);
  frame.program.DrawAll();
  frame.program.DeactivateTextures();
}

}

void HalfAngleMethod::Draw(
  const ComparisonFrame& frame, ComparisonImage& image, double spreadDegrees)
{
  const glm::dvec3& toLightWorld = frame.toLightWorld;
  const ComparedView& view = frame.view;
  const VolumeGeometry& geometry = frame.volume.Geometry();
  // Slices are met in the order of the light. The eye meets them in the same order if it is on the
  // light's side, and in the opposite order if not; then the axis turns away from the eye.
  const bool sameSide = glm::dot(toLightWorld, view.directionWorld) < 0.0;
  const glm::dvec3 along =
    glm::normalize((sameSide ? view.directionWorld : -view.directionWorld) - toLightWorld);
  const double radiusMm = 0.5 * geometry.DiagonalMm();
  const double blurMm = frame.sampleDistanceMm * std::tan(glm::radians(spreadDegrees));
  const Light light = { LightFromGrid(geometry, toLightWorld),
    glm::vec2(float(0.5 * blurMm / radiusMm)) };
  for (ComparisonImage& buffer : this->buffers)
  {
    buffer.Begin(view.window, glm::ivec2(BufferSide), glm::vec4(1.0f));
  }
  for (const glm::dvec4& plane :
    PlanesAlong(along, frame.sampleDistanceMm, geometry.boxGrid, geometry.worldFromGrid))
  {
    std::vector<glm::vec3> slice;
    AddFan(SlicePolygon(geometry.boxGrid, plane), slice);
    image.Continue(view.window);
    SetComparisonState(
      view.window, sameSide ? ComparisonBlending::Under : ComparisonBlending::Over);
    frame.Use("Slice.frag.glsl", "Shadow/LightBuffer.glsl");
    frame.program.Set("clipFromGrid", glm::mat4(view.clipFromGrid));
    frame.program.Set("sliceMm", float(frame.sampleDistanceMm));
    frame.program.Set("lightFromGrid", glm::mat4(light.lightFromGrid));
    frame.program.Set("lightTexture", this->buffers[this->present].Color());
    DrawSlice(frame, slice);
    this->DimLight(frame, light, slice);
  }
  image.Continue(view.window);
}

void HalfAngleMethod::DimLight(
  const ComparisonFrame& frame, const Light& light, const std::vector<glm::vec3>& slice)
{
  vtkOpenGLRenderWindow* const window = frame.view.window;
  if (light.blurTexture.x > 0.0f)
  {
    ComparisonImage& before = this->buffers[this->present];
    this->present = 1 - this->present;
    this->buffers[this->present].Continue(window);
    SetComparisonState(window, ComparisonBlending::Replace);
    frame.program.Use(window, "Screen.vert.glsl", { "Blur.frag.glsl" });
    frame.program.Set("lightTexture", before.Color());
    frame.program.Set("blurTexture", light.blurTexture);
    DrawSlice(frame, { { -1.0f, -1.0f, 0.0f }, { 3.0f, -1.0f, 0.0f }, { -1.0f, 3.0f, 0.0f } });
  }
  this->buffers[this->present].Continue(window);
  SetComparisonState(window, ComparisonBlending::Dim);
  frame.Use("Shadow.frag.glsl");
  frame.program.Set("clipFromGrid", glm::mat4(light.lightFromGrid));
  frame.program.Set("sliceMm", float(frame.sampleDistanceMm));
  DrawSlice(frame, slice);
}

std::size_t HalfAngleMethod::Bytes() const
{
  return this->buffers[0].Bytes() + this->buffers[1].Bytes();
}

void HalfAngleMethod::Release(vtkWindow* window)
{
  for (ComparisonImage& buffer : this->buffers)
  {
    buffer.Release(window);
  }
}

}
