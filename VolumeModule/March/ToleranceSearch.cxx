// How a picture keeps an error tolerance: a part of its rays is drawn at several sample distances,
// which tells the error of each.

#include "March/ToleranceSearch.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/Lights.h"
#include "Frame/OverlappingVolumes.h"
#include "Frame/PropertyTransferFunction.h"

#include "vtkVolumeProperty.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// The part of the tolerance that is left for the steps; the field and the early end of rays have
// the rest. The largest error of a picture is one of many more rays than are tried out.
constexpr double PercentileOfTolerance = 0.66;
constexpr double LargestOfTolerance = 1.0;

// Where a ray finds the second highest peak its error is large, and few of the rays do: the tried
// ones show less of it.
constexpr double ExtremesPart = 0.4;

// Where sample distances are searched, in voxels.
constexpr double CoarsestVoxels = 4.0;
constexpr double FinestVoxels = 1.0 / 128.0;
// Nor does the longest get fewer: halving a distance longer than the volume would change nothing,
// and tell nothing.
constexpr double FewestSamples = 16.0;
// For the same reason, across the thinnest side of a volume: a segment has four samples, and half
// as long a one must still end in it.
constexpr double FewestAcross = 8.0;

// What a pre-integrated step takes of the time of a midpoint; that of materials, where what lies
// between two samples is linear, as packets of rays or shaders have it (2.1 to 2.9 times by
// packets, seven pictures).
constexpr double PreIntegrationCost = 1.33;
constexpr double LinearCostOfPackets = 2.5;
constexpr double LinearCostOfShaders = 1.15;

double PreIntegrationCostOf(const Frame& frame)
{
  if (!MarchesMaterial(frame.settings))
  {
    return PreIntegrationCost;
  }
  return frame.marcher == Marcher::Processor ? LinearCostOfPackets : LinearCostOfShaders;
}

// How much smaller the error must be at the same distance for steps that are longer by their cost.
double GainThatPays(const Frame& frame)
{
  constexpr double Order = 1.6;
  return std::pow(PreIntegrationCostOf(frame), Order);
}

// A peak wider than this part of the values is met by more than one in a thousand samples, so that
// trying out sees it.
constexpr double NarrowPeak = 1.0 / 256.0;

// Of a larger optical table a pre-integrated one loses so much that it moves steps, by the same at
// every sample distance: its error would not be seen.
constexpr std::size_t MostPreIntegratedEntries = 8192;

// A pre-integrated table has 1024 values on a side and moves steps by as much: less than this many
// times the limit may be its own error.
constexpr double CertainlyMissed = 4.0;

// A view is near another if no corner of a volume has moved by more than this part of the picture;
// there the error is taken to be that of steps which are longer by the rest of this part.
constexpr double NearMove = 0.05;
constexpr double NearbyPart = 0.9;

// The picture's opacity, which does not depend on light.
std::vector<float> OpacityOf(std::vector<float> picture)
{
  for (std::size_t i = 0; i < picture.size(); ++i)
  {
    picture[i] = i % 4 == 3 ? picture[i] : 0.0f;
  }
  return picture;
}

// A rule that is known to miss something has no smaller error than that.
ToleranceChoice WithMissed(ToleranceChoice choice, double missedOfLimit, const ErrorLimit& limit)
{
  choice.missedOfLimit = missedOfLimit;
  choice.step.ofLimit = std::max(choice.step.ofLimit, missedOfLimit);
  choice.step.error = std::max(choice.step.error, missedOfLimit * limit.percentile999);
  return choice;
}

// Whether the opacity is that of one transfer function, whatever the light.
bool IsShadedTransferFunction(const RenderSettings& settings)
{
  return !settings.overlaps && !settings.gradientOpacity &&
    settings.components == Components::One && settings.functionOf == FunctionOf::Value &&
    settings.mask != Mask::Labels;
}

// What decides on the rule of integration.
std::vector<double> RuleInputsOf(const Frame& frame, const VolumeBuilds& builds)
{
  return { double(builds.volumeTexture), double(builds.opticalTable),
    double(frame.chooseIntegration), double(frame.settings.integration),
    double(frame.settings.blend), double(frame.settings.shading),
    double(frame.settings.gradientOpacity), frame.errorTolerance,
    frame.geometry.SmallestSpacingMm() };
}

// All that decides on the picture in any view, but what is drawn in front of the volume.
std::vector<double> SceneInputsOf(const Frame& frame, const VolumeBuilds& builds)
{
  std::vector<double> inputs{ double(builds.field), double(frame.property->GetMTime()),
    double(frame.settings.acceleration), double(frame.settings.sceneGeometry),
    frame.dampingGradient, FillsGaps(frame.settings) ? frame.gapOptical.a : 0.0,
    frame.averagedRange[0], frame.averagedRange[1], double(frame.settings.mask),
    double(frame.mask.time), frame.labelPart, double(frame.viewport.width),
    double(frame.viewport.height) };
  const std::vector<double> cuts = frame.cuts.Numbers();
  inputs.insert(inputs.end(), cuts.begin(), cuts.end());
  if (frame.settings.lights)
  {
    const HeadLightColors head = HeadLightColorsOf(frame.renderer);
    inputs.insert(inputs.end(), glm::value_ptr(head.diffuse), glm::value_ptr(head.diffuse) + 3);
    inputs.insert(inputs.end(), glm::value_ptr(head.specular), glm::value_ptr(head.specular) + 3);
    for (const glm::vec4& texel : LightTexelsOf(frame.renderer).texels)
    {
      inputs.insert(inputs.end(), glm::value_ptr(texel), glm::value_ptr(texel) + 4);
    }
  }
  return inputs;
}

ErrorLimit LimitOf(const Frame& frame)
{
  const double tolerance =
    IsExtreme(frame.settings.blend) ? ExtremesPart * frame.errorTolerance : frame.errorTolerance;
  return { PercentileOfTolerance * tolerance, LargestOfTolerance * tolerance };
}

StepRange RangeOf(const Frame& frame)
{
  const double voxelMm = SmallestSpacingMm(frame);
  const double coarsestMm = std::min({ CoarsestVoxels * voxelMm,
    LongestRayMm(frame) / FewestSamples, ThinnestSideMm(frame) / FewestAcross });
  // Halves of the finest are drawn too.
  const double finestMm = std::max(FinestVoxels * voxelMm, 2.0 * ShortestSampleDistanceMm(frame));
  return { coarsestMm, std::min(finestMm, coarsestMm) };
}

}

Viewport ProbePixelsFor(const Viewport& picture)
{
  return { 0, 0, std::min(picture.width, 96), std::min(picture.height, 48) };
}

bool ToleranceInputs::IsNear(const ToleranceInputs& other) const
{
  if (this->rule != other.rule || this->scene != other.scene ||
    this->view.size() != other.view.size())
  {
    return false;
  }
  double moved = 0.0;
  for (std::size_t i = 0; i < this->view.size(); ++i)
  {
    moved = std::max(moved, LargestMove(this->view[i], other.view[i]));
  }
  return moved <= NearMove;
}

void ToleranceInputs::Add(const Frame& frame, const VolumeBuilds& builds)
{
  const std::vector<double> ofRule = RuleInputsOf(frame, builds);
  this->rule.insert(this->rule.end(), ofRule.begin(), ofRule.end());
  const std::vector<double> ofScene = SceneInputsOf(frame, builds);
  this->scene.insert(this->scene.end(), ofScene.begin(), ofScene.end());
  this->view.push_back(CornersOf(
    frame.geometry.boxGrid, ClipFromWorld(frame.renderer) * frame.geometry.worldFromGrid));
}

// While the view moves, a search serves until the volume is seen from elsewhere; when it rests, it
// gets its own.
void ToleranceSearch::Update(const Frame& frame, const VolumeResources& volume,
  const ToleranceInputs& inputs, const ProbeDrawing& draw)
{
  if (BeginsPicture(frame.settings.pass))
  {
    this->viewRests = inputs.view == this->view;
  }
  this->view = inputs.view;
  const bool serves = this->choice &&
    (this->viewRests ? this->choice->inputs == inputs : this->choice->inputs.IsNear(inputs));
  if (!serves)
  {
    this->choice = this->ChooseSteps({ frame, volume, draw, LimitOf(frame) }, inputs);
    ++this->searches;
  }
}

double ToleranceSearch::SampleDistanceInViewMm() const
{
  const StepChoice& step = this->choice->step;
  return this->choice->inputs.view == this->view ? step.sampleDistance
                                                 : NearbyPart * step.sampleDistance;
}

const std::vector<float>& ToleranceSearch::Trial::Draw(
  Frame tried, Integration integration, double sampleDistanceMm)
{
  std::vector<float>& picture =
    this->drawn[{ tried.settings.shading, integration, sampleDistanceMm }];
  if (!picture.empty())
  {
    return picture;
  }
  tried.viewport = ProbePixelsFor(tried.viewport);
  tried.settings.pass = RayPass::Whole;
  tried.settings.integration = integration;
  tried.settings.countFetches = false; // errors are of colours, whatever the picture shows
  tried.sampleDistanceMm = sampleDistanceMm;
  picture = this->draw(tried);
  return picture;
}

FoundSteps ToleranceSearch::Trial::Find(
  Integration integration, double firstMm, const std::vector<float>& exact)
{
  const auto drawAt = [&](double sampleDistanceMm)
  { return this->Draw(this->frame, integration, sampleDistanceMm); };
  return FindSampleDistance(drawAt, this->limit, RangeOf(this->frame), firstMm, exact);
}

ToleranceChoice ToleranceSearch::ChooseSteps(Trial trial, const ToleranceInputs& inputs) const
{
  // Each search begins at the same place, so that what it finds does not depend on the one before.
  const double firstMm = SmallestSpacingMm(trial.frame);
  // The rule is chosen anew only for another transfer function or volume: not while a camera moves.
  if (this->choice && this->choice->inputs.rule == inputs.rule)
  {
    const Integration integration = this->choice->integration;
    return WithMissed({ inputs, integration, trial.Find(integration, firstMm).choice },
      this->choice->missedOfLimit, trial.limit);
  }
  const auto choiceOf = [&](Integration integration, const FoundSteps& found)
  {
    const ToleranceChoice choice{ inputs, integration, found.choice };
    return WithMissed(choice, MissedOfLimit(trial, choice), trial.limit);
  };
  const Integration usual = trial.frame.settings.integration;
  const FoundSteps found = trial.Find(usual, firstMm);
  const ToleranceChoice choice = choiceOf(usual, found);
  if (!trial.frame.chooseIntegration || !PreIntegrationMayPay(trial, choice, found.finest))
  {
    return choice;
  }
  constexpr Integration Other = Integration::PreIntegrated;
  const ToleranceChoice preIntegrated = choiceOf(Other,
    choice.step.KeepsLimit() ? trial.Find(Other, choice.step.sampleDistance, found.finest)
                             : trial.Find(Other, firstMm));
  return IsBetter(preIntegrated.step, PreIntegrationCostOf(trial.frame), choice.step)
    ? preIntegrated
    : choice;
}

// Known before it is searched for, which takes longer: by what it errs at the distance that was
// chosen, beside the finest picture, to which all rules tend.
bool ToleranceSearch::PreIntegrationMayPay(
  Trial& trial, const ToleranceChoice& choice, const std::vector<float>& finest)
{
  if (choice.missedOfLimit > 0.0)
  {
    return true;
  }
  const bool losesTooMuch = !MarchesMaterial(trial.frame.settings) &&
    trial.volume.OpticalTables().Table().entries.size() > MostPreIntegratedEntries;
  if (losesTooMuch || !choice.step.KeepsLimit())
  {
    return !losesTooMuch;
  }
  const double distanceMm = choice.step.sampleDistance;
  if (distanceMm >= RangeOf(trial.frame).coarsest)
  {
    return false;
  }
  const std::vector<float> picture =
    trial.Draw(trial.frame, Integration::PreIntegrated, distanceMm);
  return GainThatPays(trial.frame) * ErrorOfLimit(picture, finest, trial.limit) < 1.0;
}

// A shorter distance tells nothing of a peak that lies between all samples. Pre-integration
// misses none: what it differs by, beyond what its own steps make, is an error of the others.
double ToleranceSearch::MissedOfLimit(Trial& trial, const ToleranceChoice& choice)
{
  const double range =
    trial.volume.Blocks().Texels().largestScalar - trial.volume.Blocks().Texels().smallestScalar;
  if (trial.frame.settings.blend != Blend::Composite || !trial.frame.triesPreIntegration ||
    (MarchesMaterial(trial.frame.settings) && !IsShadedTransferFunction(trial.frame.settings)) ||
    (choice.integration == Integration::PreIntegrated && !trial.frame.settings.shading) ||
    TransferFunctionOf(trial.frame.property).SmallestNodeGap() >= NarrowPeak * range)
  {
    return 0.0;
  }
  Frame unlit = trial.frame;
  unlit.settings.shading = false;
  const double distanceMm = choice.step.sampleDistance;
  const std::vector<float> steps =
    OpacityOf(trial.Draw(trial.frame, choice.integration, distanceMm));
  const std::vector<float> coarse =
    OpacityOf(trial.Draw(unlit, Integration::PreIntegrated, distanceMm));
  const std::vector<float> fine =
    OpacityOf(trial.Draw(unlit, Integration::PreIntegrated, 0.5 * distanceMm));
  const double missed =
    DifferenceOfLimit(steps, fine, trial.limit) - DifferenceOfLimit(coarse, fine, trial.limit);
  return missed > CertainlyMissed ? missed : 0.0;
}

}
