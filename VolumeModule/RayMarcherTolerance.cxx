// How a picture keeps an error tolerance: a part of its rays is drawn at several sample distances,
// which tells the error of each.

#include "RayMarcher.h"

#include "Core/ShaderRecipe.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkVolumeProperty.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

// The part of the tolerance that is left for the steps; the field and the early end of rays have
// the rest. The largest error of a picture is one of many more rays than are tried out.
constexpr double PercentileOfTolerance = 0.75;
constexpr double LargestOfTolerance = 1.2;

// Where a ray finds the second highest peak its error is large, and few of the rays do: the tried
// ones show less of it.
constexpr double ExtremesPart = 0.4;

// Where sample distances are searched, in voxels; and no ray gets more samples than this.
constexpr double CoarsestVoxels = 4.0;
constexpr double FinestVoxels = 1.0 / 128.0;
constexpr double MostSamples = 32768.0;
// Nor does the longest get fewer: halving a distance longer than the volume would change nothing,
// and tell nothing.
constexpr double FewestSamples = 16.0;

// How much smaller the error of a pre-integrated picture must be to pay for its samples, which
// cost a third more: 1.33 squared, for the order of both rules is 2.
constexpr double PreIntegrationGain = 1.8;

// What decides on the rule of integration.
std::vector<double> RuleInputsOf(const Frame& frame, const BuildCounts& builds)
{
  return { double(builds.volumeTexture), double(builds.opticalTable),
    double(frame.chooseIntegration), double(frame.settings.integration), frame.errorTolerance,
    frame.geometry.SmallestSpacingMm() };
}

// All that decides on the picture but what is drawn in front of the volume.
std::vector<double> InputsOf(const Frame& frame, const BuildCounts& builds)
{
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid;
  std::vector<double> inputs = RuleInputsOf(frame, builds);
  inputs.insert(inputs.end(),
    { double(builds.field), double(frame.property->GetMTime()), double(frame.settings.blend),
      double(frame.settings.acceleration), double(frame.settings.shading),
      double(frame.settings.sceneGeometry), FillsGaps(frame.settings) ? frame.gapOptical.a : 0.0,
      frame.averagedRange[0], frame.averagedRange[1], double(frame.viewport.width),
      double(frame.viewport.height) });
  inputs.insert(inputs.end(), glm::value_ptr(clipFromGrid), glm::value_ptr(clipFromGrid) + 16);
  return inputs;
}

StepRange RangeOf(const VolumeGeometry& geometry)
{
  const double voxelMm = geometry.SmallestSpacingMm();
  const double coarsestMm =
    std::min(CoarsestVoxels * voxelMm, geometry.DiagonalMm() / FewestSamples);
  const double finestMm = std::max(FinestVoxels * voxelMm, geometry.DiagonalMm() / MostSamples);
  return { coarsestMm, std::min(finestMm, coarsestMm) };
}

}

void RayMarcher::UpdateTolerance(const Frame& frame)
{
  if (!(frame.errorTolerance > 0.0))
  {
    this->tolerance.reset();
    this->probe.Release(frame.window);
    return;
  }
  if (!this->tolerance || this->tolerance->inputs != InputsOf(frame, this->builds))
  {
    this->tolerance = this->ChooseSteps(frame);
    ++this->builds.tolerance;
  }
}

ToleranceChoice RayMarcher::ChooseSteps(const Frame& frame)
{
  const double stepsTolerance =
    IsExtreme(frame.settings.blend) ? ExtremesPart * frame.errorTolerance : frame.errorTolerance;
  const ErrorLimit limit{ PercentileOfTolerance * stepsTolerance,
    LargestOfTolerance * stepsTolerance };
  const StepRange range = RangeOf(frame.geometry);
  const auto drawingBy = [&](Integration integration)
  {
    return [this, &frame, integration](double sampleDistanceMm)
    { return this->DrawProbe(frame, integration, sampleDistanceMm); };
  };
  // Each search begins at the same place, so that what it finds does not depend on the one before.
  const double firstMm = frame.geometry.SmallestSpacingMm();
  const auto choiceBy = [&](Integration integration)
  {
    return ToleranceChoice{ InputsOf(frame, this->builds), RuleInputsOf(frame, this->builds),
      integration, FindSampleDistance(drawingBy(integration), limit, range, firstMm) };
  };

  // The rule is chosen anew only for another transfer function or volume: not while a camera moves.
  if (this->tolerance && this->tolerance->ruleInputs == RuleInputsOf(frame, this->builds))
  {
    return choiceBy(this->tolerance->integration);
  }
  const ToleranceChoice choice = choiceBy(frame.settings.integration);
  if (!frame.chooseIntegration)
  {
    return choice;
  }
  const double preIntegrated =
    ErrorOfLimit(drawingBy(Integration::PreIntegrated), limit, choice.step.sampleDistance);
  return PreIntegrationGain * preIntegrated < choice.step.ofLimit
    ? choiceBy(Integration::PreIntegrated)
    : choice;
}

std::vector<float> RayMarcher::DrawProbe(
  Frame frame, Integration integration, double sampleDistanceMm)
{
  frame.viewport = ProbeFramebuffer::PixelsFor(frame.viewport);
  frame.settings.integration = integration;
  frame.settings.countFetches = false; // errors are of colours, whatever the picture shows
  frame.sampleDistanceMm = sampleDistanceMm;
  this->UpdatePreIntegratedTable(frame);
  this->UpdateProgram(frame);
  return this->probe.Draw(frame.window, frame.viewport, [&] { this->DrawBox(frame); });
}

}
