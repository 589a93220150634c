#include "OrderBench.h"

#include "CommandLine/VtkMessages.h"
#include "Core/Quality/ImageError.h"
#include "OrderScenes.h"
#include "Scene/OffscreenView.h"
#include "Scene/ProceduralVolume.h"
#include "Scene/ReferencePicture.h"

#include <vtkCamera.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace varimarch
{

namespace
{

// Tolerance of the reference integrator, far below what is measured.
constexpr double TruthTolerance = 1e-8;

/// A mapper with fixed choices.
struct Method
{
  std::string title;
  CurveStyle style;
  MapperKind kind;
  Integration integration;
  bool isCubic;
  std::optional<double> order; ///< expected order
};

// Colours of M. Okabe, K. Ito, "Color universal design", 2008.
constexpr CurveStyle MidpointStyle = { { 0, 114, 178 }, Marker::Circle, Stroke::Solid };
constexpr CurveStyle PreIntegratedStyle = { { 204, 121, 167 }, Marker::Square, Stroke::Solid };
constexpr CurveStyle SimpsonStyle = { { 0, 158, 115 }, Marker::Diamond, Stroke::Solid };
constexpr CurveStyle SumStyle = { { 230, 159, 0 }, Marker::Plus, Stroke::Dashed };
constexpr CurveStyle VtkGpuStyle = { { 213, 94, 0 }, Marker::Square, Stroke::Dashed };
constexpr CurveStyle VtkCpuStyle = { { 0, 0, 0 }, Marker::Diamond, Stroke::Dashed };

const Method MidpointPackets = { "Varimarch, midpoint, packets",
  { { 86, 180, 233 }, Marker::Cross, Stroke::Dashed }, MapperKind::Varimarch, Integration::Midpoint,
  false, 2.0 };
const Method VtkGpu = { "VTK GPU mapper", VtkGpuStyle, MapperKind::VtkGpu, Integration::Midpoint,
  false, 1.0 };
const Method VtkCpu = { "VTK fixed-point mapper", VtkCpuStyle, MapperKind::VtkCpu,
  Integration::Midpoint, false, 1.0 };

// Each is shorter by the root of two, so that short curves have enough points for a fit.
constexpr double StepsVoxels[] = { 4.0, 2.828, 2.0, 1.414, 1.0, 0.7071, 0.5, 0.3536, 0.25, 0.1768,
  0.125, 0.08839, 0.0625 };

// The rules and mappers whose steps are refined. Kinks at the faces of cells reduce higher orders.
std::vector<Method> MethodsOfSteps(bool isSmooth)
{
  constexpr MapperKind Shaders = MapperKind::VarimarchShaders;
  return {
    { "Varimarch, midpoint", MidpointStyle, Shaders, Integration::Midpoint, false, 2.0 },
    MidpointPackets,
    { "Varimarch, pre-integrated", PreIntegratedStyle, Shaders, Integration::PreIntegrated, false,
      2.0 },
    { "Varimarch, Simpson", SimpsonStyle, Shaders, Integration::Simpson, false,
      isSmooth ? 4.0 : 2.0 },
    { "published sum", SumStyle, Shaders, Integration::PublishedSum, false, 1.0 },
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
  return { method.title, method.style, method.order, {}, {} };
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
  const Method packets = { "Varimarch", MidpointStyle, MapperKind::Varimarch, Integration::Midpoint,
    false, 1.0 };
  const Method shaders = { "Varimarch, by shaders", PreIntegratedStyle,
    MapperKind::VarimarchShaders, Integration::Midpoint, false, 1.0 };
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
  const Method linear = { "Varimarch, linear", MidpointStyle, MapperKind::VarimarchShaders,
    Integration::Midpoint, false, 2.0 };
  const Method cubic = { "Varimarch, cubic spline", SimpsonStyle, MapperKind::VarimarchShaders,
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

}

void MeasureOrders(int side, const OnStep& onStep,
  const std::function<void(const std::vector<OrderExperiment>&)>& onResult)
{
  std::vector<OrderExperiment> experiments;
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
    experiments.push_back(measure());
    for (OrderCurve& curve : experiments.back().curves)
    {
      std::vector<OrderPoint> fitted;
      std::copy_if(curve.points.begin(), curve.points.end(), std::back_inserter(fitted),
        [&](const OrderPoint& point) { return point.width <= experiments.back().widestFitted; });
      curve.fit = FitOrder(fitted, OrderFloor);
    }
    onResult(experiments);
  }
}

}
