#include "OrderFit.h"

#include "Benchmark.h"
#include "CommandLine/Progress.h"
#include "CommandLine/ReportedErrors.h"
#include "CommandLine/Truth.h"
#include "Core/Quality/ImageError.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Model/Scene.h"
#include "Scene/Reference/ReferencePicture.h"
#include "Scene/Reference/ReferenceRequest.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

namespace
{

// The 97.5th percentile of Student's t distribution.
double StudentQuantile(int degreesOfFreedom)
{
  constexpr std::array<double, 10> Quantiles = { 12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
    2.306, 2.262, 2.228 };
  return Quantiles[std::size_t(std::min(degreesOfFreedom, int(Quantiles.size())) - 1)];
}

/// The errors of one method under refinement.
struct OrderCurve
{
  std::string method;
  std::optional<double> expected; ///< order by theory; empty: no theory
  std::vector<OrderPoint> points; ///< points, coarsest first
  std::optional<OrderFit> fit;
};

/// The errors of all methods under one kind of refinement of a scene.
struct OrderExperiment
{
  std::string name;      ///< name, usable as a file name
  std::string title;     ///< title, with what is refined and the scene
  std::string widthName; ///< the refined width, with its unit
  std::vector<OrderCurve> curves;
  /// Widths above this are not in the range in which the error has an order.
  double widestFitted = std::numeric_limits<double>::infinity();
};

/// Errors below this are left out of fits: those of sums of floats [1/255].
constexpr double OrderFloor = 0.0005;

constexpr double CubeSideMm = 100.0;

Scene SceneOfBytes(int side)
{
  Scene scene;
  scene.look.colors = { { 0.0, { 0.9, 0.3, 0.1 }, {} }, { 255.0, { 0.1, 0.5, 1.0 }, {} } };
  scene.look.opacities = { { 0.0, 0.004, {} }, { 255.0, 0.04, {} } };
  scene.look.shading.enabled = false;
  scene.camera.azimuthDegrees = 25.0;
  scene.camera.elevationDegrees = 15.0;
  // Only rays through opposite faces: elsewhere their lengths, and with them the image, have kinks.
  scene.camera.zoom = 6.0;
  scene.size = { side, side };
  scene.render.acceleration = Acceleration::Off;
  scene.render.earlyTerminationTransmittance = 0.0;
  return scene;
}

// A scene of a ramp or a checkerboard, without early termination and field, so that nothing but
// the steps makes errors.
Scene OrderScene(ProceduralKind kind, int side)
{
  constexpr int Voxels = 17;
  Scene scene = SceneOfBytes(side);
  scene.volume = ProceduralSource{ kind, { Voxels, Voxels, Voxels }, 1 };
  return scene;
}

// The same of the smooth field.
Scene SmoothScene(int side)
{
  return SceneOfBytes(side);
}

// The field of the refinement of grids: smooth, from 0 to 255, in a cube of 100 mm at the world's
// origin.
double SmoothField(const glm::dvec3& positionMm)
{
  const glm::dvec3 p = 6.0 * positionMm / CubeSideMm;
  return 127.5 * (1.0 + std::sin(2.0 * p.x + 0.7 * p.y) * std::cos(1.7 * p.y - 1.3 * p.z));
}

// Samples of the smooth field, as floats.
// @param side  number of voxels along each axis
vtkSmartPointer<vtkImageData> SmoothVolume(int side)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  const double spacing = CubeSideMm / (side - 1);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-0.5 * CubeSideMm, -0.5 * CubeSideMm, -0.5 * CubeSideMm);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* const voxels = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double place[3];
    image->GetPoint(i, place);
    voxels[i] = float(SmoothField({ place[0], place[1], place[2] }));
  }
  return image;
}

// The image of the smooth field itself, as if of infinitely many voxels.
// @param image  any of its volumes, which tells the rays
vtkSmartPointer<vtkImageData> SmoothTruth(const Scene& scene, vtkImageData* image)
{
  constexpr double Tolerance = 1e-8;
  const ReferenceRequest request = ReferenceRequestFor(scene, image, Tolerance);
  ReferenceScene smooth{ {}, request.geometry.boxGrid, request.transferFunction };
  smooth.material = [&](glm::dvec3 positionGrid, const Ray&)
  {
    const glm::dvec4 world = request.geometry.worldFromGrid * glm::dvec4(positionGrid, 1.0);
    const double value = SmoothField(glm::dvec3(world));
    return OpticalProperties{ request.transferFunction.Color(value),
      request.transferFunction.Extinction(value) };
  };
  const auto drawn = DrawReference(ReferenceIntegrator(smooth, Tolerance), request.view);
  auto truth = vtkSmartPointer<vtkImageData>::New();
  truth->SetDimensions(drawn->width, drawn->height, 1);
  truth->AllocateScalars(VTK_FLOAT, 4);
  std::copy(drawn->rgba.begin(), drawn->rgba.end(), static_cast<float*>(truth->GetScalarPointer()));
  return truth;
}

// Tolerance of the reference integrator, far below what is measured.
constexpr double TruthTolerance = 1e-8;

/// A mapper with fixed choices.
struct Method
{
  std::string title;
  MapperKind kind;
  Integration integration;
  bool isCubic;
  std::optional<double> order; ///< expected order
};

const Method MidpointPackets = { "Varimarch, midpoint, packets", MapperKind::Varimarch,
  Integration::Midpoint, false, 2.0 };
const Method VtkGpu = { "VTK GPU mapper", MapperKind::VtkGpu, Integration::Midpoint, false, 1.0 };
const Method VtkCpu = { "VTK fixed-point mapper", MapperKind::VtkCpu, Integration::Midpoint, false,
  1.0 };

// Each is shorter by the root of two, so that short curves have enough points for a fit.
constexpr double StepsVoxels[] = { 4.0, 2.828, 2.0, 1.414, 1.0, 0.7071, 0.5, 0.3536, 0.25, 0.1768,
  0.125, 0.08839, 0.0625 };

// The rules and mappers whose steps are refined. Kinks at the faces of cells reduce higher orders.
std::vector<Method> MethodsOfSteps(bool isSmooth)
{
  constexpr MapperKind Shaders = MapperKind::VarimarchShaders;
  return {
    { "Varimarch, midpoint", Shaders, Integration::Midpoint, false, 2.0 },
    MidpointPackets,
    { "Varimarch, pre-integrated", Shaders, Integration::PreIntegrated, false, 2.0 },
    { "Varimarch, Simpson", Shaders, Integration::Simpson, false, isSmooth ? 4.0 : 2.0 },
    { "published sum", Shaders, Integration::PublishedSum, false, 1.0 },
    VtkGpu,
    VtkCpu,
  };
}

vtkSmartPointer<vtkImageData> Drawn(
  const Method& method, Scene scene, vtkImageData* image, double stepMm)
{
  if (stepMm > 0.0)
  {
    scene.render.sampleDistanceMm = stepMm;
    scene.render.integration = method.integration;
  }
  OffscreenView view(scene, image, method.kind);
  if (auto* ours = vtkVariationFieldVolumeMapper::SafeDownCast(view.Pipeline().Mapper()))
  {
    ours->SetCubicInterpolation(method.isCubic);
  }
  view.Render();
  const auto picture = view.FloatImage();
  ThrowIfVtkReportedError();
  return picture;
}

OrderPoint PointOf(double width, vtkImageData* picture, vtkImageData* truth)
{
  const ImageError error = CompareImages(static_cast<const float*>(picture->GetScalarPointer()),
    static_cast<const float*>(truth->GetScalarPointer()), std::size_t(truth->GetNumberOfPoints()));
  return { width, error.rootMeanSquare, error.largest };
}

OrderCurve CurveOf(const Method& method)
{
  return { method.title, method.order, {}, {} };
}

double VoxelSideMm(vtkImageData* image)
{
  return image->GetSpacing()[0];
}

std::string NameOfVolume(ProceduralKind kind)
{
  return kind == ProceduralKind::Ramp ? "ramp" : "checkerboard";
}

OrderExperiment RefineSteps(ProceduralKind kind, int side, const OnStep& onStep)
{
  const std::string volume = NameOfVolume(kind);
  OrderExperiment experiment = { "steps-" + volume, "Steps, " + volume, "sample distance [voxels]",
    {} };
  if (kind == ProceduralKind::Checkerboard)
  {
    experiment.widestFitted = 1.0; // its values turn over from voxel to voxel
  }
  const Scene scene = OrderScene(kind, side);
  const auto image = ProceduralVolume(std::get<ProceduralSource>(scene.volume));
  const auto truth = DrawReferencePicture(scene, image, TruthTolerance)->image;
  for (const Method& method : MethodsOfSteps(kind == ProceduralKind::Ramp))
  {
    OrderCurve curve = CurveOf(method);
    for (const double voxels : StepsVoxels)
    {
      onStep(experiment.title + ": " + method.title);
      const auto picture = Drawn(method, scene, image, voxels * VoxelSideMm(image));
      curve.points.push_back(PointOf(voxels, picture, truth));
    }
    experiment.curves.push_back(curve);
  }
  return experiment;
}

// Our defaults keep an error, instead of having an order in the sample distance.
OrderExperiment RefineTolerance(ProceduralKind kind, int side, const OnStep& onStep)
{
  const std::string volume = NameOfVolume(kind);
  OrderExperiment experiment = { "tolerance-" + volume, "Error tolerance, " + volume,
    "error tolerance", {} };
  Scene scene = OrderScene(kind, side);
  scene.render = {};
  const auto image = ProceduralVolume(std::get<ProceduralSource>(scene.volume));
  const auto truth = DrawReferencePicture(scene, image, TruthTolerance)->image;
  const Method packets = { "Varimarch", MapperKind::Varimarch, Integration::Midpoint, false, 1.0 };
  const Method shaders = { "Varimarch, by shaders", MapperKind::VarimarchShaders,
    Integration::Midpoint, false, 1.0 };
  for (const Method& method : { packets, shaders })
  {
    OrderCurve curve = CurveOf(method);
    for (const int part : { 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096 })
    {
      onStep(experiment.title + ": " + method.title);
      scene.render.errorTolerance = 1.0 / part;
      curve.points.push_back(PointOf(1.0 / part, Drawn(method, scene, image, 0.0), truth));
    }
    experiment.curves.push_back(curve);
  }
  return experiment;
}

// Steps so short that the grid makes all the error, except in VTK's mappers.
constexpr double FineStepMm = 0.2;

// Limits a view to the half of the depth of the smooth volume that lies around its middle.
void ClipToInside(Scene& scene)
{
  constexpr double HalfDepthMm = 25.0;
  OffscreenView view(scene, SmoothVolume(2), MapperKind::Varimarch);
  const double middleMm = view.Pipeline().Renderer()->GetActiveCamera()->GetDistance();
  scene.camera.clippingRangeMm = { middleMm - HalfDepthMm, middleMm + HalfDepthMm };
}

// Beyond its faces a spline goes on as its mirror image, with a kink at each face: it errs by h
// over a length of h there, so that whole rays have order 2, as those of linear interpolation have.
OrderExperiment RefineGrid(int side, bool isInside, const OnStep& onStep)
{
  OrderExperiment experiment = { isInside ? "grid-inside" : "grid",
    isInside ? "Grid, inside of the smooth field" : "Grid, smooth field", "width of a cell [mm]",
    {} };
  Scene scene = SmoothScene(side);
  if (isInside)
  {
    ClipToInside(scene);
  }
  const Method linear = { "Varimarch, linear", MapperKind::VarimarchShaders, Integration::Midpoint,
    false, 2.0 };
  const Method cubic = { "Varimarch, cubic spline", MapperKind::VarimarchShaders,
    Integration::Midpoint, true, isInside ? 4.0 : 2.0 };
  Method gpu = VtkGpu;
  Method cpu = VtkCpu;
  gpu.order = cpu.order = 2.0;
  for (const Method& method : { linear, cubic, gpu, cpu })
  {
    OrderCurve curve = CurveOf(method);
    for (const int voxels : { 9, 13, 17, 25, 33, 49, 65 })
    {
      onStep(experiment.title + ": " + method.title);
      const auto image = SmoothVolume(voxels);
      const auto picture = Drawn(method, scene, image, FineStepMm);
      curve.points.push_back(PointOf(VoxelSideMm(image), picture, SmoothTruth(scene, image)));
    }
    experiment.curves.push_back(curve);
  }
  return experiment;
}

// The image at the pixel centres of a finer one of the same view, linear between its own. Pixels
// beyond the outermost centres are those of the truth, so that they do not count.
vtkSmartPointer<vtkImageData> Enlarged(vtkImageData* picture, vtkImageData* truth)
{
  auto enlarged = vtkSmartPointer<vtkImageData>::New();
  enlarged->DeepCopy(truth);
  const int from = picture->GetDimensions()[0];
  const int to = truth->GetDimensions()[0];
  const auto placeOf = [&](int pixel) { return (pixel + 0.5) * from / to - 0.5; };
  for (int row = 0; row < to; ++row)
  {
    for (int column = 0; column < to; ++column)
    {
      const double x = placeOf(column);
      const double y = placeOf(row);
      if (std::min(x, y) < 0.0 || std::max(x, y) > from - 1.0)
      {
        continue;
      }
      const int left = std::min(int(x), from - 2);
      const int below = std::min(int(y), from - 2);
      for (int channel = 0; channel < 4; ++channel)
      {
        const auto at = [&](int right, int up)
        { return picture->GetScalarComponentAsDouble(left + right, below + up, 0, channel); };
        const double lower = at(0, 0) + (x - left) * (at(1, 0) - at(0, 0));
        const double upper = at(0, 1) + (x - left) * (at(1, 1) - at(0, 1));
        enlarged->SetScalarComponentFromDouble(
          column, row, 0, channel, lower + (y - below) * (upper - lower));
      }
    }
  }
  return enlarged;
}

OrderExperiment RefinePixels(int side, const OnStep& onStep)
{
  constexpr int Voxels = 65;
  OrderExperiment experiment = { "pixels", "Pixels, smooth field", "width of a pixel [image]", {} };
  const auto image = SmoothVolume(Voxels);
  const auto truth = DrawReferencePicture(SmoothScene(2 * side), image, TruthTolerance)->image;
  Method ours = MidpointPackets;
  ours.title = "Varimarch";
  Method gpu = VtkGpu;
  Method cpu = VtkCpu;
  gpu.order = cpu.order = 2.0;
  for (const Method& method : { ours, gpu, cpu })
  {
    OrderCurve curve = CurveOf(method);
    for (const int parts : { 8, 4, 2, 1 })
    {
      onStep(experiment.title + ": " + method.title);
      const auto picture = Drawn(method, SmoothScene(side / parts), image, FineStepMm);
      curve.points.push_back(PointOf(double(parts) / side, Enlarged(picture, truth), truth));
    }
    experiment.curves.push_back(curve);
  }
  return experiment;
}

// Measures the observed orders of convergence, after Etiene et al., "Verifying volume rendering
// using discretization error analysis", TVCG 20(1), 2014, and Etiene, Kirby, Silva, "A study of
// discretization errors in volume rendering integral approximations", Eurographics short papers,
// 2013: under refinement of the steps, of the tolerance, of the grid and of the pixels. The
// volumes of the first two are the ramp and the checkerboard of ProceduralVolume.h.
// @param side     height and width of the images [pixels]; pixels are refined from an eighth of it
// @param onResult receives all finished experiments after each of them
void MeasureOrders(
  int side, const OnStep& onStep, const std::function<void(const OrderExperiment&)>& onResult)
{
  const std::function<OrderExperiment()> measurements[] = {
    [&] { return RefineSteps(ProceduralKind::Ramp, side, onStep); },
    [&] { return RefineSteps(ProceduralKind::Checkerboard, side, onStep); },
    [&] { return RefineTolerance(ProceduralKind::Ramp, side, onStep); },
    [&] { return RefineTolerance(ProceduralKind::Checkerboard, side, onStep); },
    [&] { return RefineGrid(side, false, onStep); },
    [&] { return RefineGrid(side, true, onStep); },
    [&] { return RefinePixels(side, onStep); },
  };
  for (const auto& measure : measurements)
  {
    OrderExperiment experiment = measure();
    for (OrderCurve& curve : experiment.curves)
    {
      std::vector<OrderPoint> fitted;
      std::copy_if(curve.points.begin(), curve.points.end(), std::back_inserter(fitted),
        [&](const OrderPoint& point) { return point.width <= experiment.widestFitted; });
      curve.fit = FitOrder(fitted, OrderFloor);
    }
    onResult(experiment);
  }
}

nlohmann::ordered_json ToJson(const OrderCurve& curve)
{
  nlohmann::ordered_json json = { { "method", curve.method } };
  if (curve.expected)
  {
    json["expectedOrder"] = *curve.expected;
  }
  if (curve.fit)
  {
    json["order"] = curve.fit->order;
    json["orderHalfWidth95"] = curve.fit->halfWidth;
    json["fittedPoints"] = curve.fit->points;
  }
  for (const OrderPoint& point : curve.points)
  {
    json["points"].push_back(
      { { "width", point.width }, { "rmse255", point.rmse }, { "largest255", point.largest } });
  }
  return json;
}

nlohmann::ordered_json ToJson(const OrderExperiment& experiment)
{
  nlohmann::ordered_json json = { { "name", experiment.name }, { "title", experiment.title },
    { "width", experiment.widthName }, { "methods", nlohmann::ordered_json::array() } };
  if (std::isfinite(experiment.widestFitted))
  {
    json["widestFitted"] = experiment.widestFitted;
  }
  for (const OrderCurve& curve : experiment.curves)
  {
    json["methods"].push_back(ToJson(curve));
  }
  return json;
}

struct OrderOptions
{
  int side = 128; ///< height and width of the images [pixels], a multiple of 8
};

void AddOrderOptions(CLI::App& command, OrderOptions& options)
{
  command
    .add_option("--side", options.side, "Side of the square images, a multiple of 8 (default 128)")
    ->check(CLI::Range(16, 1024).description(""))
    ->type_name("PIXELS");
}

void RunOrder(const OrderOptions& options, BenchResults& results)
{
  results.json.update({ { "side", options.side }, { "floor", OrderFloor },
    { "experiments", nlohmann::ordered_json::array() } });
  Progress progress("Measuring orders of convergence");
  MeasureOrders(
    options.side, [&](const std::string& step) { progress.SetActivity(step); },
    [&](const OrderExperiment& experiment)
    {
      results.json["experiments"].push_back(ToJson(experiment));
      results.Write("orders up to " + experiment.title);
    });
}

}

Benchmark OrderBenchmark()
{
  return MakeBenchmark("order",
    "Measure orders of convergence under refinement of steps, grid and pixels",
    "Example:\n  varimarch-bench order -o order", AddOrderOptions, RunOrder);
}

std::optional<OrderFit> FitOrder(const std::vector<OrderPoint>& points, double floor)
{
  std::vector<std::array<double, 2>> logs;
  for (const OrderPoint& point : points)
  {
    if (point.rmse > floor)
    {
      logs.push_back({ std::log(point.width), std::log(point.rmse) });
    }
  }
  const int count = int(logs.size());
  if (count < 3)
  {
    return std::nullopt;
  }
  std::array<double, 2> mean = {};
  for (const auto& [x, y] : logs)
  {
    mean[0] += x / count;
    mean[1] += y / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const auto& [x, y] : logs)
  {
    xx += (x - mean[0]) * (x - mean[0]);
    xy += (x - mean[0]) * (y - mean[1]);
    yy += (y - mean[1]) * (y - mean[1]);
  }
  const double order = xy / xx;
  const double variance = std::max(yy - order * xy, 0.0) / (count - 2);
  return OrderFit{ order, StudentQuantile(count - 2) * std::sqrt(variance / xx), count };
}

}
