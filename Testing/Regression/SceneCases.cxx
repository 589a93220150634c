#include "Regression/RegressionCase.h"

#include "Module/Scenes/HomogeneousScene.h"
#include "Module/Scenes/OverlapLight.h"

#include <vtkPlane.h>
#include <vtkProperty.h>
#include <vtkTransform.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace
{

using Color = std::array<double, 3>;

void Inside(MapperScene& scene)
{
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(5.0, -20.0, 10.0);
  camera->SetFocalPoint(0.0, 40.0, 0.0);
  camera->SetViewAngle(60.0);
  camera->SetClippingRange(1.0, 1000.0);
}

void ShearedAndMirrored(MapperScene& scene)
{
  vtkNew<vtkTransform> transform;
  const double shear[16] = { 1.0, 0.4, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.2, 0.0, 1.0, 0.0, 0.0, 0.0,
    0.0, 1.0 };
  transform->Concatenate(shear);
  transform->Scale(-1.2, 0.8, 1.0);
  scene.volume->SetUserTransform(transform);
  scene.volume->GetProperty()->ShadeOn();
  scene.renderer->ResetCamera();
}

// The rows of the image alternate between the eyes.
RegressionScene Stereo()
{
  const auto scene = NewScene(SmallTorso());
  scene->window->SetStereoTypeToInterlaced();
  scene->window->StereoRenderOn();
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene]
  {
    scene->window->Render(); // makes the camera one of stereo
    vtkCamera* const camera = scene->renderer->GetActiveCamera();
    camera->SetLeftEye(1);
    std::vector<float> mixed = scene->Truth();
    camera->SetLeftEye(0);
    const std::vector<float> right = scene->Truth();
    const std::size_t rowLength = 4 * std::size_t(scene->size);
    for (int row = 1; row < scene->size; row += 2)
    {
      std::copy_n(right.begin() + row * rowLength, rowLength, mixed.begin() + row * rowLength);
    }
    return mixed;
  };
  return regression;
}

// The small torso from above in parallel projection.
std::shared_ptr<MapperScene> TorsoFromAbove()
{
  const auto scene = NewScene(SmallTorso());
  const double* const bounds = scene->volume->GetBounds();
  vtkCamera* const camera = scene->renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.45 * (bounds[3] - bounds[2]));
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 0.0, 1000.0);
  camera->SetClippingRange(1.0, 2000.0);
  return scene;
}

// The truth of the part of the volume between two heights.
std::vector<float> TruthBetween(MapperScene& scene, double lowestMm, double highestMm)
{
  vtkNew<vtkPlane> above;
  above->SetOrigin(0.0, 0.0, lowestMm);
  vtkNew<vtkPlane> below;
  below->SetOrigin(0.0, 0.0, highestMm);
  below->SetNormal(0.0, 0.0, -1.0);
  scene.mapper->AddClippingPlane(above);
  scene.mapper->AddClippingPlane(below);
  const std::vector<float> truth = scene.Truth();
  scene.mapper->RemoveAllClippingPlanes();
  return truth;
}

// A rectangle in the right part of the image, flat and unlit.
struct Sheet
{
  double zMm;
  double fromXMm;
  Color rgb;
  double opacity;

  vtkSmartPointer<vtkActor> Actor() const
  {
    const vtkSmartPointer<vtkActor> actor = Plane(this->zMm, this->fromXMm, this->rgb);
    actor->GetProperty()->SetOpacity(this->opacity);
    return actor;
  }

  // Premultiplied RGBA, in a view from above.
  std::vector<float> Image(const MapperScene& scene) const
  {
    const double halfMm = scene.renderer->GetActiveCamera()->GetParallelScale();
    std::vector<float> image(4 * std::size_t(scene.size) * scene.size);
    for (int pixel = 0; pixel < scene.size * scene.size; ++pixel)
    {
      const double xMm = (2.0 * (pixel % scene.size + 0.5) / scene.size - 1.0) * halfMm;
      const double alpha = xMm > this->fromXMm ? this->opacity : 0.0;
      for (int channel = 0; channel < 4; ++channel)
      {
        image[4 * pixel + channel] = float(alpha * (channel < 3 ? this->rgb[channel] : 1.0));
      }
    }
    return image;
  }
};

// A torso with sheets in it, the highest first.
RegressionScene TorsoWithSheets(
  const std::shared_ptr<MapperScene>& scene, const std::vector<Sheet>& sheets)
{
  for (const Sheet& sheet : sheets)
  {
    scene->renderer->AddActor(sheet.Actor());
  }
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene, sheets]
  {
    constexpr double FarMm = 900.0;
    double topMm = FarMm;
    std::vector<float> image(4 * std::size_t(scene->size) * scene->size);
    for (const Sheet& sheet : sheets)
    {
      image = ImageOver(image, TruthBetween(*scene, sheet.zMm, topMm));
      image = ImageOver(image, sheet.Image(*scene));
      topMm = sheet.zMm;
    }
    return ImageOver(image, TruthBetween(*scene, -FarMm, topMm));
  };
  return regression;
}

RegressionScene OpaqueGeometry()
{
  return TorsoWithSheets(TorsoFromAbove(), { { 5.0, -20.0, { 0.1, 0.7, 0.3 }, 1.0 } });
}

RegressionScene TranslucentGeometry()
{
  const auto scene = TorsoFromAbove();
  UseDepthPeeling(scene->renderer);
  return TorsoWithSheets(scene,
    { { 30.0, -60.0, { 0.9, 0.2, 0.1 }, 0.3 }, { 5.0, -20.0, { 0.1, 0.8, 0.2 }, 0.4 },
      { -25.0, 30.0, { 0.1, 0.3, 0.9 }, 0.5 } });
}

// Two torsos, one behind the other, of which the farther one was added last.
RegressionScene SeveralVolumes()
{
  const auto scene = NewScene(SmallTorso());
  const auto behind = std::make_shared<MapperScene>(SmallTorso(), RegressionSide);
  behind->mapper->SetErrorTolerance(scene->mapper->GetErrorTolerance());
  behind->mapper->ProcessorMarchingOn();
  behind->volume->SetPosition(60.0, 270.0, 50.0);
  behind->colors->RemoveAllPoints();
  behind->colors->AddRGBPoint(0.0, 0.2, 0.5, 1.0);
  scene->renderer->AddVolume(behind->volume);
  behind->renderer->SetActiveCamera(scene->renderer->GetActiveCamera());
  scene->renderer->ResetCamera();
  scene->renderer->GetActiveCamera()->Zoom(1.8);
  RegressionScene regression = SceneOf(scene);
  regression.volumes.push_back(behind);
  regression.truth = [scene, behind] { return ImageOver(scene->Truth(), behind->Truth()); };
  return regression;
}

RegressionScene MultiVolume()
{
  RegressionScene regression;
  regression.overlap = std::make_shared<OverlapScene>(RegressionSide);
  AddBalls(*regression.overlap, { true, false, false, false });
  vtkVariationFieldVolumeMapper* const mapper =
    regression.overlap->mapper->GetVariationFieldMapper();
  mapper->SetErrorTolerance(1.0 / 64.0);
  mapper->ProcessorMarchingOn();
  regression.truth = [overlap = regression.overlap] { return overlap->Truth(); };
  return regression;
}

// Each of the volumes casts a shadow on the other.
RegressionScene VolumesInLight()
{
  RegressionScene regression = MultiVolume();
  for (vtkVolume* const volume : regression.overlap->Volumes())
  {
    volume->GetProperty()->ShadeOn();
  }
  const OverlapLight light{ { { glm::normalize(glm::dvec3(0.7, 0.4, 0.5)) } }, true };
  UseLight(*regression.overlap, light);
  regression.truth = [overlap = regression.overlap, light]
  { return TruthInLight(*overlap, light, 1e-3); };
  return regression;
}

// Two images side by side in one window.
RegressionScene Viewports()
{
  constexpr int Side = RegressionSide / 2;
  const auto left = NewScene(SmallTorso(), Side);
  const auto right = std::make_shared<MapperScene>(SmallTorso(), Side, left->window);
  right->mapper->SetErrorTolerance(left->mapper->GetErrorTolerance());
  right->mapper->ProcessorMarchingOn();
  right->mapper->SetBlendModeToMaximumIntensity();
  right->opacities->AddPoint(400.0, 1.0);
  right->renderer->GetActiveCamera()->Azimuth(60.0);
  right->renderer->ResetCameraClippingRange();
  left->renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  right->renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  left->window->SetSize(2 * Side, Side);
  RegressionScene regression;
  regression.size = { 2 * Side, Side };
  regression.volumes = { left, right };
  regression.truth = [left, right]
  {
    const std::vector<float> parts[2] = { left->Truth(), right->Truth() };
    std::vector<float> both;
    for (int row = 0; row < 2 * Side; ++row)
    {
      const auto begin = parts[row % 2].begin() + row / 2 * 4 * Side;
      both.insert(both.end(), begin, begin + 4 * Side);
    }
    return both;
  };
  return regression;
}

// A torso over the sheet of a layer below, whose depths do not matter.
RegressionScene Layers()
{
  const auto scene = TorsoFromAbove();
  const Sheet sheet = { 30.0, -20.0, { 0.1, 0.6, 0.2 }, 1.0 };
  vtkNew<vtkRenderer> below;
  below->AddActor(sheet.Actor());
  below->SetActiveCamera(scene->renderer->GetActiveCamera());
  scene->renderer->SetLayer(1);
  scene->window->SetNumberOfLayers(2);
  scene->window->AddRenderer(below);
  RegressionScene regression = SceneOf(scene);
  regression.truth = [scene, sheet] { return ImageOver(scene->Truth(), sheet.Image(*scene)); };
  return regression;
}

}

std::vector<RegressionCase> SceneCases()
{
  return {
    TorsoCase("Parallel",
      [](MapperScene& scene) { scene.renderer->GetActiveCamera()->ParallelProjectionOn(); }),
    TorsoCase("Inside", Inside),
    TorsoCase("ShearedAndMirrored", ShearedAndMirrored),
    { "Stereo", Stereo },
    { "OpaqueGeometry", OpaqueGeometry },
    { "TranslucentGeometry", TranslucentGeometry },
    { "SeveralVolumes", SeveralVolumes },
    { "MultiVolume", MultiVolume },
    { "VolumesInLight", VolumesInLight },
    { "Viewports", Viewports },
    { "Layers", Layers },
  };
}
