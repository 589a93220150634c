#include "Regression/RegressionCase.h"

#include "Core/Geometry/Box.h"
#include "Frame/VolumeGeometry.h"
#include "Module/Scenes/HomogeneousScene.h"
#include "Module/Scenes/ProcessorMarching.h"
#include "Module/Scenes/SupersampledTruth.h"

#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkShaderProperty.h>

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{

// Fewer rays than pixels suffice where nothing but opaque geometry has an edge.
RegressionScene ImageSampleDistance()
{
  const auto scene = std::make_shared<HomogeneousScene>(0.1, RegressionSide);
  scene->mapper->SetErrorTolerance(1.0 / 64.0);
  scene->mapper->ProcessorMarchingOn();
  scene->mapper->SetImageSampleDistance(3.0f);
  const std::array<double, 3> rgb = { 0.1, 0.3, 0.7 };
  scene->renderer->AddActor(Plane(4.0, 1.3, rgb));
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene, rgb]
  {
    std::vector<float> image = scene->Truth();
    const double halfMm = scene->renderer->GetActiveCamera()->GetParallelScale();
    const std::array<double, 4> covered = Over(scene->Piece(4.0), { rgb[0], rgb[1], rgb[2], 1.0 });
    for (int pixel = 0; pixel < scene->size * scene->size; ++pixel)
    {
      const double xMm = (2.0 * (pixel % scene->size + 0.5) / scene->size - 1.0) * halfMm;
      if (xMm > 1.3)
      {
        std::copy(covered.begin(), covered.end(), image.begin() + 4 * pixel);
      }
    }
    return image;
  };
  return regression;
}

void SetSampleDistance(MapperScene& scene)
{
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(1.0);
}

void LockSampleDistance(MapperScene& scene)
{
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->LockSampleDistanceToInputSpacingOn();
}

void DrawInStrips(MapperScene& scene)
{
  scene.volume->GetProperty()->ShadeOn();
  scene.mapper->SetLongestPartSeconds(1e-9);
}

void SharpBone(MapperScene& scene)
{
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(150.0, 0.0);
  scene.opacities->AddPoint(250.0, 0.5);
}

RegressionScene Accumulation()
{
  constexpr int Side = RegressionSide / 2;
  const auto scene = NewScene(SmallTorso(), Side);
  SharpBone(*scene);
  scene->mapper->SetMaximumAccumulatedPictures(64);
  RegressionScene regression = SceneOf(scene);
  regression.truth = [] { return SupersampledTruth(Side, SharpBone); };
  return regression;
}

void MarchInPackets(MapperScene& scene)
{
  scene.mapper->ProcessorMarchingOn();
  scene.volume->GetProperty()->ShadeOn();
  Clip(scene);
}

// Colours between nothing and opacity, scaled about a level.
RegressionScene WindowLevel()
{
  constexpr float Window = 0.6f;
  constexpr float Level = 0.45f;
  const auto scene = NewScene(SmallTorso());
  scene->mapper->SetFinalColorWindow(Window);
  scene->mapper->SetFinalColorLevel(Level);
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene]
  {
    std::vector<float> image = scene->Truth();
    for (std::size_t i = 0; i < image.size(); ++i)
    {
      const float alpha = image[i | 3];
      image[i] = i % 4 == 3
        ? alpha
        : std::clamp((image[i] - Level * alpha) / Window + 0.5f * alpha, 0.0f, alpha);
    }
    return image;
  };
  return regression;
}

// An image of three bytes a pixel.
// @param put  (index of the pixel, its bytes)
template <class Put>
vtkSmartPointer<vtkImageData> BytesOf(vtkImageData* image, const Put& put)
{
  auto bytes = vtkSmartPointer<vtkImageData>::New();
  bytes->SetDimensions(image->GetDimensions());
  bytes->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    put(i, static_cast<unsigned char*>(bytes->GetScalarPointer()) + 3 * i);
  }
  return bytes;
}

// The colour image of a mapper that renders to images, without its opacity.
vtkSmartPointer<vtkImageData> ColorImageOf(MapperScene& scene)
{
  vtkNew<vtkImageData> color;
  auto* const vtk = vtkGPUVolumeRayCastMapper::SafeDownCast(scene.volume->GetMapper());
  vtk ? vtk->GetColorImage(color) : scene.mapper->GetColorImage(color);
  const auto* const rgba = static_cast<const unsigned char*>(color->GetScalarPointer());
  return BytesOf(
    color, [&](vtkIdType i, unsigned char* bytes) { std::copy_n(rgba + 4 * i, 3, bytes); });
}

RegressionScene RenderToImage()
{
  const auto scene = NewScene(SmallTorso());
  scene->mapper->RenderToImageOn();
  RegressionScene regression = SceneOf(scene);
  regression.background = { 1.0, 1.0, 1.0 };
  regression.drawn = [scene] { return ColorImageOf(*scene); };
  return regression;
}

// The depths that a mapper renders, from black to white.
vtkSmartPointer<vtkImageData> DepthImageOf(MapperScene& scene)
{
  vtkNew<vtkImageData> depth;
  auto* const vtk = vtkGPUVolumeRayCastMapper::SafeDownCast(scene.volume->GetMapper());
  vtk ? vtk->GetDepthImage(depth) : scene.mapper->GetDepthImage(depth);
  const auto* const depths = static_cast<const float*>(depth->GetScalarPointer());
  return BytesOf(depth,
    [&](vtkIdType i, unsigned char* bytes)
    { std::fill_n(bytes, 3, static_cast<unsigned char>(std::lround(255.0 * depths[i]))); });
}

// The depths at which the rays of all pixels enter a box of the world, as gray.
std::vector<float> DepthsOfBox(MapperScene& scene, const varimarch::Box& box)
{
  const glm::dmat4 clipFromWorld = varimarch::ClipFromWorld(scene.renderer);
  const glm::dmat4 worldFromClip = glm::inverse(clipFromWorld);
  const auto worldAt = [&](const glm::dvec3& clip)
  {
    const glm::dvec4 world = worldFromClip * glm::dvec4(clip, 1.0);
    return glm::dvec3(world) / world.w;
  };
  std::vector<float> image;
  for (int pixel = 0; pixel < scene.size * scene.size; ++pixel)
  {
    const double x = 2.0 * (pixel % scene.size + 0.5) / scene.size - 1.0;
    const double y = 2.0 * (pixel / scene.size + 0.5) / scene.size - 1.0;
    const glm::dvec3 near = worldAt({ x, y, -1.0 });
    const varimarch::Ray ray = { near, worldAt({ x, y, 1.0 }) - near };
    const varimarch::Interval inside = Intersection(ray, box);
    const glm::dvec4 entry =
      clipFromWorld * glm::dvec4(ray.origin + inside.enter * ray.direction, 1.0);
    const auto depth = float(0.5 + 0.5 * entry.z / entry.w);
    const float seen = inside.IsEmpty() ? 0.0f : 1.0f;
    image.insert(image.end(), { seen * depth, seen * depth, seen * depth, seen });
  }
  return image;
}

// A cube of one material, which is seen from its faces on.
RegressionScene DepthImage()
{
  constexpr double SideMm = HomogeneousScene::SideMm;
  const auto scene = NewScene(HomogeneousCube(SideMm));
  UseOneMaterial(scene->volume->GetProperty(), { 1.0, 1.0, 1.0 }, 0.999999);
  scene->mapper->RenderToImageOn();
  vtkCamera* const camera = scene->renderer->GetActiveCamera();
  camera->Azimuth(33.0);
  camera->Elevation(25.0);
  camera->Zoom(0.7);
  camera->SetClippingRange(camera->GetDistance() - SideMm, camera->GetDistance() + SideMm);
  RegressionScene regression = SceneOf(scene);
  regression.background = { 1.0, 1.0, 1.0 };
  regression.truth = [scene] {
    return DepthsOfBox(*scene, { glm::dvec3(-0.5 * SideMm), glm::dvec3(0.5 * SideMm) });
  };
  regression.drawn = [scene] { return DepthImageOf(*scene); };
  return regression;
}

RegressionScene UserCode()
{
  const auto scene = NewScene(SmallTorso());
  scene->volume->GetShaderProperty()->AddFragmentShaderReplacement(
    "//Varimarch::Window", true, "vec4 Windowed(vec4 picture) { return picture.bgra; }", false);
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene]
  {
    std::vector<float> image = scene->Truth();
    for (std::size_t i = 0; i < image.size(); i += 4)
    {
      std::swap(image[i], image[i + 2]);
    }
    return image;
  };
  return regression;
}

}

std::vector<RegressionCase> ImageCases()
{
  // The mean of 64 frames is one of as many rays, which at an edge differs from that of all rays.
  constexpr double fewRays = 10.0;
  return {
    { "ImageSampleDistance", ImageSampleDistance },
    TorsoCase("SampleDistance", SetSampleDistance),
    TorsoCase("LockedSampleDistance", LockSampleDistance),
    TorsoCase("Strips", DrawInStrips),
    { "Accumulation", Accumulation, fewRays },
    TorsoCase("Jitter", [](MapperScene& scene) { scene.mapper->UseJitteringOn(); }),
    TorsoCase("Packets", MarchInPackets),
    { "WindowLevel", WindowLevel },
    { "RenderToImage", RenderToImage },
    { "DepthImage", DepthImage },
    { "UserCode", UserCode },
  };
}
