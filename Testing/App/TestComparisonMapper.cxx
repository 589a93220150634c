// The comparison methods of the benchmarks: slices, shells, a march in passes, half-angle slices.

#include "App/ComparedScene.h"
#include "Benchmarks/Comparison/SliceGeometry.h"
#include "Benchmarks/WorkPrecision.h"

#include "Core/Geometry/ScalarGrid.h"
#include "Core/Look/OpticalTable.h"
#include "Frame/PropertyTransferFunction.h"
#include "Frame/VolumeGeometry.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

using Mapper = vtkComparisonMapper;

// Ray marching in double precision at given distances from the eye.
struct MarchByHand
{
  ComparedScene& scene;
  VolumeGeometry geometry = VolumeGeometryOf(scene.image, scene.view.Pipeline().Volume());
  OpticalTable table =
    BuildOpticalTable(TransferFunctionOf(scene.view.Pipeline().Volume()->GetProperty()),
      scene.image->GetScalarRange()[0], scene.image->GetScalarRange()[1]);

  glm::dvec4 OpticalAt(double value) const
  {
    const double last = double(this->table.entries.size()) - 1.0;
    const double part =
      (value - this->table.firstValue) / (this->table.lastValue - this->table.firstValue);
    const double index = std::clamp(part * last, 0.0, last);
    const auto below = std::size_t(std::min(std::floor(index), last - 1.0));
    return glm::mix(glm::dvec4(this->table.entries[below]),
      glm::dvec4(this->table.entries[below + 1]), index - double(below));
  }

  double ValueAt(const glm::dvec3& grid) const
  {
    const ScalarGrid<short> voxels(
      static_cast<const short*>(this->scene.image->GetScalarPointer()), this->geometry.dimensions);
    const glm::ivec3 cell = glm::min(glm::ivec3(glm::floor(grid)), this->geometry.dimensions - 2);
    const glm::dvec3 in = grid - glm::dvec3(cell);
    double value = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::dvec3 weight = glm::mix(1.0 - in, in, glm::dvec3(side));
      value += weight.x * weight.y * weight.z * voxels.Voxel(cell + side);
    }
    return value;
  }

  glm::dvec4 Along(const glm::dvec3& eye, const glm::dvec3& direction, double stepMm) const
  {
    glm::dvec4 sum(0.0);
    const glm::dmat4 gridFromWorld = glm::inverse(this->geometry.worldFromGrid);
    for (const double radius :
      ShellRadii(eye, stepMm, this->geometry.boxGrid, this->geometry.worldFromGrid))
    {
      const glm::dvec3 grid(gridFromWorld * glm::dvec4(eye + radius * direction, 1.0));
      const bool inside =
        grid == glm::clamp(grid, this->geometry.boxGrid.lower, this->geometry.boxGrid.upper);
      if (inside)
      {
        const glm::dvec4 optical = this->OpticalAt(this->ValueAt(grid));
        const double absorbed = -std::expm1(-optical.a * stepMm);
        sum += (1.0 - sum.a) * absorbed * glm::dvec4(glm::dvec3(optical), 1.0);
      }
    }
    return sum;
  }

  Pixels Draw(double stepMm) const
  {
    vtkRenderer* const renderer = this->scene.view.Pipeline().Renderer();
    const glm::dmat4 worldFromClip = glm::inverse(ClipFromWorld(renderer));
    const glm::dvec3 eye = glm::make_vec3(renderer->GetActiveCamera()->GetPosition());
    const int* const size = renderer->GetSize();
    Pixels pixels;
    for (int pixel = 0; pixel < size[0] * size[1]; ++pixel)
    {
      const glm::dvec2 place(2.0 * (pixel % size[0] + 0.5) / size[0] - 1.0,
        2.0 * (pixel / size[0] + 0.5) / size[1] - 1.0);
      const glm::dvec4 far = worldFromClip * glm::dvec4(place, 1.0, 1.0);
      const glm::vec4 sum = this->Along(eye, glm::normalize(glm::dvec3(far) / far.w - eye), stepMm);
      pixels.insert(pixels.end(), { sum.r, sum.g, sum.b, sum.a });
    }
    return pixels;
  }
};

// A cube of 16 mm whose opacity is that of 1/mm everywhere.
vtkSmartPointer<vtkImageData> HomogeneousCube()
{
  auto cube = vtkSmartPointer<vtkImageData>::New();
  cube->SetDimensions(9, 9, 9);
  cube->SetSpacing(2.0, 2.0, 2.0);
  cube->AllocateScalars(VTK_SHORT, 1);
  auto* const voxels = static_cast<short*>(cube->GetScalarPointer());
  std::fill(voxels, voxels + cube->GetNumberOfPoints(), short(100));
  voxels[0] = 99; // a range of values
  return cube;
}

// A homogeneous cube under a light, seen along an axis: slices of 1 mm absorb a tenth.
struct LitCube : ComparedScene
{
  LitCube()
    : ComparedScene(Settings(), HomogeneousCube())
  {
    this->mapper->SetSampleDistance(1.0);
  }

  static Scene Settings()
  {
    Scene settings = SoftScene(false);
    settings.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
    settings.look.opacities = { { 0.0, 0.1 } };
    settings.look.opacityUnitDistanceMm = 1.0;
    settings.camera = Camera();
    settings.camera.parallel = true;
    settings.camera.view = View::Anterior;
    return settings;
  }

  // Red and opacity in the middle of the image.
  glm::dvec2 Middle(int method = Mapper::HalfAngle)
  {
    const Pixels drawn = this->Draw(method);
    const float* const middle = &drawn[4 * (64 * 28 + 32)];
    return { middle[0], middle[3] };
  }
};

}

TEST(Shells, EqualRayMarchingAtTheSameDistances)
{
  ComparedScene scene(SoftScene(false));
  const Pixels shells = scene.Draw(Mapper::Shells);
  const Pixels marched = MarchByHand{ scene }.Draw(4.0);
  EXPECT_GT(*std::max_element(marched.begin(), marched.end()), 0.3f) << "nothing to compare";
  // Positions are floats of 24 bits, at distances of a thousand mm.
  EXPECT_LT(Difference(shells, marched).largest, 255.0 * 2e-4);
}

TEST(Slices, OverEqualsUnder)
{
  for (const bool shaded : { false, true })
  {
    ComparedScene scene(SoftScene(shaded));
    for (const int method : { Mapper::ObjectSlices, Mapper::ViewSlices, Mapper::Shells })
    {
      SCOPED_TRACE(testing::Message() << "method " << method << " shaded " << shaded);
      scene.mapper->SetFromBehind(true);
      const Pixels over = scene.Draw(method);
      scene.mapper->SetFromBehind(false);
      EXPECT_LT(Difference(scene.Draw(method), over).largest, 255.0 * 1e-5);
      EXPECT_GT(*std::max_element(over.begin(), over.end()), 0.3f) << "nothing to compare";
    }
  }
}

TEST(Slices, OverEqualsUnderFor2DTextures)
{
  ComparedScene scene(SoftScene(false));
  const Pixels over = scene.Draw(Mapper::ObjectSlices2D);
  scene.mapper->SetFromBehind(false);
  EXPECT_LT(Difference(scene.Draw(Mapper::ObjectSlices2D), over).largest, 255.0 * 1e-5);
  EXPECT_GT(*std::max_element(over.begin(), over.end()), 0.3f) << "nothing to compare";
}

TEST(Slices, MakeTheImageOfOurMapperWhenTheyAreClose)
{
  for (const bool shaded : { false, true })
  {
    Scene settings = SoftScene(shaded);
    settings.camera.parallel = true; // the distance along a ray is that of the slices
    settings.camera.azimuthDegrees = settings.camera.elevationDegrees = 0.0;
    settings.render.errorTolerance = 1.0 / 1024.0;
    ComparedScene scene(settings);
    OffscreenView ours(settings, scene.image, MapperKind::Varimarch);
    const Pixels truth = PixelsOf(ours.FloatImage());
    scene.mapper->SetSampleDistance(0.5);
    for (const int method :
      { Mapper::ObjectSlices, Mapper::ViewSlices, Mapper::Shells, Mapper::Passes })
    {
      SCOPED_TRACE(testing::Message() << "method " << method << " shaded " << shaded);
      EXPECT_LT(Difference(scene.Draw(method), truth).rootMeanSquare, 0.5);
    }
  }
}

TEST(Slices, OfTheStackPopWhereItChanges)
{
  Scene settings = SoftScene(false);
  settings.camera.azimuthDegrees = settings.camera.elevationDegrees = 0.0;
  const auto image = Torso();
  const BenchMethod object = { "object", "", MapperKind::VarimarchShaders, Mapper::ObjectSlices };
  const BenchMethod view = { "view", "", MapperKind::VarimarchShaders, Mapper::ViewSlices };
  MethodView objectView(object, settings, image);
  MethodView viewView(view, settings, image);
  const RenderOptions options = AtDistance(image, 1.0, {}).options;
  objectView.SetOptions(options);
  viewView.SetOptions(options);
  constexpr int Frames = 18;
  int drawn = 0;
  vtkNew<vtkCallbackCommand> counting;
  counting->SetClientData(&drawn);
  counting->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  viewView.Offscreen().Pipeline().Renderer()->AddObserver(vtkCommand::StartEvent, counting);
  const auto changes =
    ChangesInOrbit({ &objectView, &viewView }, settings, image, Frames, [](const std::string&) {});
  EXPECT_GT(changes[0].largest, 3.0 * changes[0].median);
  EXPECT_NEAR(changes[0].largestAtDegrees, 9.0 * 90.0 / (Frames - 1), 1e-9)
    << "the first beyond 45 degrees";
  EXPECT_LT(changes[1].largest, 3.0 * changes[1].median);
  EXPECT_EQ(drawn, Frames + 1) << "each frame once, after a first one";
}

TEST(OrbitChange, NamesTheFrameOfTheLargestChange)
{
  const OrbitChange change = SummaryOf(std::vector<double>{ 1.0, 2.0, 9.0, 2.0, 2.0 });
  EXPECT_EQ(change.frames, 6);
  EXPECT_EQ(change.degreesPerFrame, 18.0);
  EXPECT_EQ(change.median, 2.0);
  EXPECT_EQ(change.largest, 9.0);
  EXPECT_EQ(change.largestAtDegrees, 54.0);
}

TEST(Passes, DoNotChangeTheImage)
{
  for (const bool shaded : { false, true })
  {
    ComparedScene scene(SoftScene(shaded));
    scene.mapper->SetEarlyTerminationTransmittance(0.0);
    scene.mapper->SetStepsPerPass(10000);
    const Pixels inOne = scene.Draw(Mapper::Passes);
    scene.mapper->SetStepsPerPass(5);
    EXPECT_LT(Difference(scene.Draw(Mapper::Passes), inOne).largest, 255.0 * 1e-5);
    EXPECT_GT(*std::max_element(inOne.begin(), inOne.end()), 0.3f) << "nothing to compare";
  }
}

TEST(Passes, HaveWholeStepsInATable)
{
  LitCube cube;
  cube.mapper->SetEarlyTerminationTransmittance(0.0);
  cube.mapper->SetCorrectedTable(true);
  EXPECT_NEAR(cube.Middle(Mapper::Passes).y, 1.0 - std::pow(0.9, 16.0), 1e-5);
  // A step that is not whole counts as one, which happens once in a ray.
  cube.mapper->SetSampleDistance(3.0);
  EXPECT_NEAR(cube.Middle(Mapper::Passes).y, 1.0 - std::pow(0.9, 18.0), 1e-5);
  cube.mapper->SetCorrectedTable(false);
  EXPECT_NEAR(cube.Middle(Mapper::Passes).y, 1.0 - std::pow(0.9, 16.0), 1e-5);
}

TEST(Passes, EndRaysThatHaveMetEnough)
{
  Scene settings = SoftScene(false);
  settings.look.opacities.back().opacity = 0.99;
  ComparedScene scene(settings);
  scene.mapper->SetStepsPerPass(1);
  scene.mapper->SetEarlyTerminationTransmittance(0.0);
  const Pixels whole = scene.Draw(Mapper::Passes);
  scene.mapper->SetEarlyTerminationTransmittance(0.2);
  const Pixels ended = scene.Draw(Mapper::Passes);
  // Rays end when at most this transmittance is left.
  EXPECT_GT(Difference(ended, whole).largest, 1.0);
  EXPECT_LE(Difference(ended, whole).largest, 0.2 * 255.0);
}

// With the light at the eye, slice k of a homogeneous cube gets (1 - a)^k of the light and shows as
// much of it: a geometric series.
TEST(HalfAngle, LightOfAHomogeneousCubeIsAGeometricSeries)
{
  LitCube cube;
  cube.mapper->SetLightDirection(0.0, 0.0, 1.0);
  const double passes = std::pow(0.9, 16.0);
  for (const double spread : { 0.0, 20.0 })
  {
    // Scattered light that leaves the middle is replaced by as much from around it.
    cube.mapper->SetSpreadDegrees(spread);
    const glm::dvec2 middle = cube.Middle();
    EXPECT_NEAR(middle.y, 1.0 - passes, 1e-5);
    EXPECT_NEAR(middle.x, 0.1 * (1.0 - passes * passes) / (1.0 - 0.9 * 0.9), 1e-5) << spread;
  }
}

TEST(HalfAngle, LightFromBehindIsCompositedFromBehind)
{
  LitCube cube;
  cube.mapper->SetLightDirection(0.0, 0.0, -1.0);
  const glm::dvec2 middle = cube.Middle();
  // Slice k from the light is slice 15 - k from the eye.
  EXPECT_NEAR(middle.y, 1.0 - std::pow(0.9, 16.0), 1e-5);
  EXPECT_NEAR(middle.x, 16.0 * 0.1 * std::pow(0.9, 15.0), 1e-5);
}

TEST(HalfAngle, LightFromTheSideShadowsAndScatteringSpreadsIt)
{
  // The light comes from the right, so that the left of the cube is darkest.
  LitCube cube;
  cube.mapper->SetLightDirection(1.0, 0.0, 0.2);
  cube.mapper->SetSpreadDegrees(0.0);
  const Pixels hard = cube.Draw(Mapper::HalfAngle);
  const auto redIn = [&](int row, int column) { return hard[4 * (64 * row + column)]; };
  EXPECT_LT(redIn(28, 22), 0.7 * redIn(28, 42)) << "no shadow";
  cube.mapper->SetSpreadDegrees(40.0);
  EXPECT_GT(Difference(cube.Draw(Mapper::HalfAngle), hard).largest, 1.0);
}

// Samples lie in the middles of steps, and so does the light that reaches them.
TEST(SecondMarch, LightOfAHomogeneousCubeIsAGeometricSeries)
{
  LitCube cube;
  cube.mapper->SetLightDirection(0.0, 0.0, 1.0);
  cube.mapper->SetEarlyTerminationTransmittance(0.0);
  const glm::dvec2 middle = cube.Middle(Mapper::SecondMarch);
  const double passes = std::pow(0.9, 16.0);
  EXPECT_NEAR(middle.y, 1.0 - passes, 1e-5);
  EXPECT_NEAR(middle.x, 0.1 * std::sqrt(0.9) * (1.0 - passes * passes) / (1.0 - 0.9 * 0.9), 1e-5);
}

// VTK begins a step nearer to the light, and goes on for half a voxel beyond the volume: sample k
// of the eye, in the middle of its step, has k + 1 samples between it and the light, but the first
// has none.
TEST(VtkShadows, LightOfAHomogeneousCubeIsThatOfAllSamplesInTheTexture)
{
  LitCube cube;
  cube.mapper->SetLightDirection(0.0, 0.0, 1.0);
  cube.mapper->SetEarlyTerminationTransmittance(0.0);
  double expected = 0.1;
  for (int k = 1; k < 16; ++k)
  {
    expected += 0.1 * std::pow(0.9, k) * std::pow(0.9, k + 1);
  }
  EXPECT_NEAR(cube.Middle(Mapper::VtkShadows).x, expected, 1e-5);
}

TEST(SecondMarch, LightsSurfacesAsOurMapperDoes)
{
  Scene settings = SoftScene(true);
  settings.lights = { { LightKind::Camera, { 0.8, 0.7, 1.0 } } };
  settings.shadows = true;
  ComparedScene scene(settings);
  OffscreenView ours(settings, scene.image, MapperKind::Varimarch);
  const Pixels truth = PixelsOf(ours.FloatImage());
  scene.mapper->SetLightDirection(0.8, 0.7, 1.0);
  for (const int method : { Mapper::SecondMarch, Mapper::LightVolume })
  {
    EXPECT_LT(Difference(scene.Draw(method), truth).rootMeanSquare, 2.0) << "method " << method;
  }
  scene.mapper->SetLightDirection(-0.8, 0.7, 1.0);
  EXPECT_GT(Difference(scene.Draw(Mapper::SecondMarch), truth).rootMeanSquare, 5.0)
    << "another light makes no difference";
}
