// Stereo images, viewports and layers of renderers.

#include "Module/Scenes/MapperScene.h"

#include <vtkActor.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr int ViewSize = 48;

// An opaque cube of 5 voxels per side.
vtkSmartPointer<vtkImageData> OpaqueCube()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(5, 5, 5);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  image->GetPointData()->GetScalars()->Fill(100.0);
  return image;
}

// Horizontal centre of the covered pixels, in pixels from the left.
double MiddleOf(const std::vector<float>& picture)
{
  double sum = 0.0;
  double weighted = 0.0;
  for (int pixel = 0; pixel < ViewSize * ViewSize; ++pixel)
  {
    sum += picture[4 * pixel + 3];
    weighted += picture[4 * pixel + 3] * (pixel % ViewSize);
  }
  EXPECT_GT(sum, 20.0) << "nothing is visible";
  return weighted / sum;
}

// The window as displayed: RGB, from 0 to 255.
std::vector<double> Shown(vtkRenderWindow* window)
{
  window->Render();
  const int* const size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  return std::vector<double>(pixels->GetPointer(0), pixels->GetPointer(0) + 3 * size[0] * size[1]);
}

}

// VTK's mapper shows both eyes the rays of a single eye in the middle.
TEST(Stereo, EachEyeSeesTheVolumeWhereItSeesGeometry)
{
  MapperScene scene(OpaqueCube(), ViewSize);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 1.0);
  vtkNew<vtkCubeSource> source;
  source->SetBounds(scene.image->GetBounds());
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> cube;
  cube->SetMapper(surface);
  scene.renderer->AddActor(cube);
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(2.0, 2.0, 14.0);
  camera->SetFocalPoint(2.0, 2.0, 8.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetEyeAngle(12.0);
  scene.renderer->ResetCameraClippingRange();
  scene.window->StereoRenderOn();
  std::vector<double> middles;
  for (int leftEye : { 1, 0 })
  {
    camera->SetLeftEye(leftEye);
    cube->VisibilityOff();
    scene.volume->VisibilityOn();
    middles.push_back(MiddleOf(scene.Draw()));
    cube->VisibilityOn();
    scene.volume->VisibilityOff();
    EXPECT_NEAR(middles.back(), MiddleOf(scene.Draw()), 0.1);
  }
  EXPECT_GT(std::abs(middles[0] - middles[1]), 1.0) << "the eyes see the same";
}

TEST(Viewports, APartOfAWindowShowsWhatAWindowOfItsSizeDoes)
{
  MapperScene alone(SmallTorso(), ViewSize);
  const std::vector<double> expected = Shown(alone.window);
  MapperScene left(SmallTorso(), ViewSize);
  MapperScene right(SmallTorso(), ViewSize, left.window);
  left.renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  right.renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  left.window->SetSize(2 * ViewSize, ViewSize);
  for (vtkRenderer* renderer : { left.renderer.Get(), right.renderer.Get() })
  {
    renderer->GetActiveCamera()->DeepCopy(alone.renderer->GetActiveCamera());
  }
  const std::vector<double> shown = Shown(left.window);
  for (int row = 0; row < ViewSize; ++row)
  {
    for (int column = 0; column < 6 * ViewSize; ++column)
    {
      ASSERT_NEAR(shown[row * 6 * ViewSize + column],
        expected[row * 3 * ViewSize + column % (3 * ViewSize)], 1.0)
        << column << ", " << row;
    }
  }
}

// A view that a splitter has closed is drawn too.
TEST(Viewports, WithoutAreaDrawNothingAndReportNothing)
{
  MapperScene scene(SmallTorso(), ViewSize);
  for (const double width : { 0.0, 1.0 })
  {
    scene.renderer->SetViewport(0.0, 0.0, width, 1.0 - width);
    const std::vector<double> shown = Shown(scene.window);
    EXPECT_EQ(*std::max_element(shown.begin(), shown.end()), 0.0);
  }
}

TEST(Layers, AVolumeIsDrawnOverTheLayerBelow)
{
  MapperScene scene(SmallTorso(), ViewSize);
  const std::vector<float> alone = scene.Draw();
  vtkNew<vtkRenderer> below;
  below->SetBackground(0.0, 0.6, 0.2);
  below->SetLayer(0);
  scene.renderer->SetLayer(1);
  scene.window->SetNumberOfLayers(2);
  scene.window->AddRenderer(below);
  const std::vector<double> shown = Shown(scene.window);
  const double background[3] = { 0.0, 0.6, 0.2 };
  for (int pixel = 0; pixel < ViewSize * ViewSize; ++pixel)
  {
    const float* const rgba = &alone[4 * pixel];
    for (int channel = 0; channel < 3; ++channel)
    {
      const double over = rgba[channel] + (1.0 - rgba[3]) * background[channel];
      ASSERT_NEAR(shown[3 * pixel + channel], 255.0 * over, 2.0) << pixel;
    }
  }
}

TEST(Layers, GeometryOfTheLayerBelowHidesAVolumeWhereDepthIsKept)
{
  MapperScene scene(SmallTorso(), ViewSize);
  const double* const bounds = scene.volume->GetBounds();
  vtkNew<vtkCubeSource> source;
  source->SetBounds(bounds[0] - 1.0, bounds[1] + 1.0, bounds[2] - 1.0, bounds[3] + 1.0,
    bounds[4] - 1.0, bounds[5] + 1.0);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> box;
  box->SetMapper(surface);
  box->GetProperty()->LightingOff();
  box->GetProperty()->SetColor(0.0, 0.6, 0.2);
  vtkNew<vtkRenderer> below;
  below->AddActor(box);
  below->SetActiveCamera(scene.renderer->GetActiveCamera());
  below->SetLayer(0);
  scene.renderer->SetLayer(1);
  scene.renderer->PreserveDepthBufferOn();
  scene.window->SetNumberOfLayers(2);
  scene.window->AddRenderer(below);
  const std::vector<double> shown = Shown(scene.window);
  const double* const middle = &shown[3 * (ViewSize / 2 * ViewSize + ViewSize / 2)];
  EXPECT_NEAR(middle[0], 0.0, 0.5);
  EXPECT_NEAR(middle[1], 255.0 * 0.6, 1.0);
  EXPECT_NEAR(middle[2], 255.0 * 0.2, 1.0);
}

namespace
{

constexpr int SideCount = 26;

// Views along the faces, edges and corners of a cube.
void LookFromSide(MapperScene& scene, int side)
{
  const int place = side < SideCount / 2 ? side : side + 1; // all 3^3 directions but the centre
  const double toEye[3] = { place % 3 - 1.0, place / 3 % 3 - 1.0, place / 9 - 1.0 };
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(toEye);
  camera->SetViewUp(toEye[1] + 0.3, toEye[2] + 0.5, toEye[0] - 0.4);
  scene.renderer->ResetCamera();
}

void ExpectSame(const std::vector<float>& picture, const std::vector<float>& other, int side)
{
  const varimarch::ImageError difference =
    varimarch::CompareImages(picture.data(), other.data(), other.size() / 4);
  EXPECT_LT(difference.rootMeanSquare, 1.0) << "side " << side;
}

}

// A field is built for the directions of the rays.
TEST(Views, FromAllSidesShowAllThatThereIs)
{
  MapperScene withoutField(SmallTorso());
  withoutField.mapper->SetAccelerationModeToOff();
  MapperScene turned(SmallTorso());
  for (int side = 0; side < SideCount; ++side)
  {
    MapperScene fresh(SmallTorso());
    LookFromSide(withoutField, side);
    LookFromSide(turned, side);
    LookFromSide(fresh, side);
    const std::vector<float> whole = withoutField.Draw();
    ExpectSame(turned.Draw(), whole, side);
    ExpectSame(turned.DrawByProcessor(), whole, side);
    ExpectSame(fresh.Draw(), whole, side);
    ExpectSame(fresh.DrawByProcessor(), whole, side);
  }
}

TEST(Views, FromOtherSidesBuildNoOtherField)
{
  MapperScene scene(SmallTorso());
  scene.Draw();
  for (int side = 0; side < SideCount; ++side)
  {
    LookFromSide(scene, side);
    scene.Draw();
  }
  EXPECT_EQ(scene.mapper->GetFieldBuilds(), 1);
}
