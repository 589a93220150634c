#include "Tolerance/SharedSearch.h"

#include "Core/Geometry/ProjectedBox.h"
#include "Frame/FrameBuilder.h"
#include "Frame/FrameMeasures.h"
#include "Levels/LevelOfDetail.h"
#include "March/MapperInternals.h"
#include "Tolerance/SearchFacts.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

// Facts that several processes share as numbers. They are merged by taking the least of each
// number; one of which the greatest counts is negative there.

/// The numbers of a process that draws no part.
constexpr double NumberOfNoPart = std::numeric_limits<double>::infinity();

/// The number of a condition that one part suffices for.
double IfAny(bool holds)
{
  return holds ? -1.0 : 0.0;
}

bool HoldsForAny(double least)
{
  return least < 0.0;
}

// Calls functions for all facts: of numbers of which the least counts, of numbers of which the
// greatest counts, of conditions that one part suffices for, and of conditions that all must meet.
// A new fact does not compile until it is here.
template <class Facts, class Merge>
void ForEachFact(Facts& facts, Merge& merge)
{
  auto& [limit, range, firstMm, usual, choosesIntegration, preIntegratesByTable, hasLight, isShaded,
    looksForPeaks, hasNarrowPeaks, losesByTable, hasNodesInTable, mayPreIntegrate, tracesLight,
    keepsLight, lightOfLimit, preIntegrationCost] = facts;
  auto& [percentile999, largest] = limit;
  auto& [coarsest, finest, isOfHalfOctaves, supposedOrder] = range;
  merge.Least(percentile999);
  merge.Least(largest);
  merge.Least(coarsest);
  merge.Greatest(finest);
  merge.IfAny(isOfHalfOctaves);
  merge.Least(supposedOrder);
  merge.Least(firstMm);
  merge.Least(usual);
  merge.IfAll(choosesIntegration);
  merge.IfAny(preIntegratesByTable);
  merge.IfAny(hasLight);
  merge.IfAny(isShaded);
  merge.IfAny(looksForPeaks);
  merge.IfAny(hasNarrowPeaks);
  merge.IfAny(losesByTable);
  merge.IfAny(hasNodesInTable);
  merge.IfAll(mayPreIntegrate);
  merge.IfAny(tracesLight);
  merge.IfAny(keepsLight);
  merge.Least(lightOfLimit);
  merge.Greatest(preIntegrationCost);
}

// Appends facts to numbers.
struct FactsToNumbers
{
  std::vector<double> numbers;

  template <class Number>
  void Least(Number number)
  {
    this->numbers.push_back(double(number));
  }
  void Greatest(double number) { this->numbers.push_back(-number); }
  void IfAny(bool holds) { this->numbers.push_back(varimarch::IfAny(holds)); }
  void IfAll(bool holds) { this->numbers.push_back(holds ? 1.0 : 0.0); }
};

// Takes facts from numbers in the same order.
struct FactsFromNumbers
{
  std::vector<double>::const_iterator next;

  void Least(double& number) { number = *this->next++; }
  void Least(Integration& choice) { choice = Integration(int(*this->next++)); }
  void Greatest(double& number) { number = -*this->next++; }
  void IfAny(bool& holds) { holds = HoldsForAny(*this->next++); }
  void IfAll(bool& holds) { holds = *this->next++ > 0.0; }
};

std::vector<double> NumbersOf(const SearchFacts& facts)
{
  FactsToNumbers to;
  ForEachFact(facts, to);
  return to.numbers;
}

/// @param numbers  as many as NumbersOf returns, or more
SearchFacts FactsOf(const std::vector<double>& numbers)
{
  SearchFacts facts;
  FactsFromNumbers from{ numbers.begin() };
  ForEachFact(facts, from);
  facts.range.finest = std::min(facts.range.finest, facts.range.coarsest);
  return facts;
}

}

/// A part that this process draws.
struct SharedSearch::Part
{
  RayMarcher* marcher;
  Frame frame;
  PreparedTrials trials;
};

struct SharedSearch::Made
{
  std::vector<ToleranceInputs> inputs; ///< The inputs of the parts on this process.
  CommonSteps steps;
};

namespace
{

constexpr std::size_t NumbersPerBox = 6;

// The box that a part draws, in the coordinates of the data.
std::vector<double> NumbersOfBox(const Frame& frame)
{
  const Box& own = frame.cuts.boxGrid;
  if (glm::any(glm::greaterThanEqual(own.lower, own.upper)))
  {
    return std::vector<double>(NumbersPerBox, NumberOfNoPart);
  }
  const Box box = BoxAround(own, frame.geometry.dataFromGrid);
  return { box.lower.x, box.lower.y, box.lower.z, -box.upper.x, -box.upper.y, -box.upper.z };
}

Box BoxOf(const double* numbers)
{
  return { { numbers[0], numbers[1], numbers[2] }, { -numbers[3], -numbers[4], -numbers[5] } };
}

void MergeNumbers(std::vector<double>& least, const std::vector<double>& numbers)
{
  for (std::size_t i = 0; i < least.size(); ++i)
  {
    least[i] = std::min(least[i], numbers[i]);
  }
}

// A message of the leader to the others: the next trial image, or the end of the search.
using SearchMessage = std::vector<double>;
constexpr double DrawsTrial = 1.0;
constexpr double EndsSearch = 0.0;
constexpr std::size_t SearchMessageLength = 7;

SearchMessage MessageOf(const TrialImage& image)
{
  return { DrawsTrial, double(image.integration), image.sampleDistanceMm, double(image.isLit),
    double(image.hasSmallTable), image.light.latticePart, image.light.sampleDistanceMm };
}

TrialImage ImageOf(const SearchMessage& message)
{
  return { Integration(int(message[1])), message[2], message[3] != 0.0, message[4] != 0.0, false,
    { message[5], message[6] } };
}

SearchMessage MessageOf(const std::optional<CommonSteps>& found)
{
  return found
    ? SearchMessage{ EndsSearch, found->step.sampleDistance, found->step.error, found->step.ofLimit,
        double(found->isPreIntegrated), found->light.latticePart, found->light.sampleDistanceMm }
    : SearchMessage(SearchMessageLength, EndsSearch);
}

std::optional<CommonSteps> StepsOf(const SearchMessage& message)
{
  return message[1] > 0.0 ? std::optional<CommonSteps>({ { message[1], message[2], message[3] },
                              message[4] != 0.0, { message[5], message[6] }, {} })
                          : std::nullopt;
}

// The longest of a few distances that is not above another. Where parts meet, their segments end,
// which makes the errors of trial images a little different; this rarely changes the result.
double RoundedDown(double distance, const SearchFacts& facts)
{
  constexpr double PerOctave = 4.0;
  constexpr double Same = 1e-6;
  const double level = std::floor(PerOctave * std::log2(distance / facts.firstMm) + Same);
  return std::max(
    std::min(facts.range.finest, distance), facts.firstMm * std::exp2(level / PerOctave));
}

// Draws the parts of this process in a trial image.
using PartsDrawing = std::function<std::vector<float>(const TrialImage& image)>;

// Searches, and lets the others draw trial images until it is done.
std::optional<CommonSteps> LeadSearch(
  const SearchFacts& facts, const PartsDrawing& drawOwn, const SearchingProcesses& processes)
{
  const auto draw = [&](const std::vector<TrialImage>& images)
  {
    std::vector<std::vector<float>> drawn;
    for (const TrialImage& image : images)
    {
      SearchMessage message = MessageOf(image);
      processes.takeFromLeader(message);
      std::vector<float> whole = processes.layOver(drawOwn(image));
      drawn.push_back(
        whole.empty() ? throw std::runtime_error("no part drew a trial image") : std::move(whole));
    }
    return drawn;
  };
  std::optional<CommonSteps> found;
  try
  {
    const ToleranceChoice choice = ToleranceSearch::ChooseAnew(facts, draw);
    found = { choice.step, choice.integration == Integration::PreIntegrated, choice.light, {} };
    found->step.sampleDistance = RoundedDown(choice.step.sampleDistance, facts);
  }
  catch (const std::exception&)
  {
    found.reset(); // drawing reports what is wrong
  }
  SearchMessage message = MessageOf(found);
  processes.takeFromLeader(message);
  return found;
}

// Draws the trial images that the leader asks for, until it has found the steps.
std::optional<CommonSteps> FollowSearch(
  const PartsDrawing& drawOwn, const SearchingProcesses& processes)
{
  SearchMessage message(SearchMessageLength);
  for (processes.takeFromLeader(message); message[0] == DrawsTrial;
       processes.takeFromLeader(message))
  {
    processes.layOver(drawOwn(ImageOf(message)));
  }
  return StepsOf(message);
}

}

SearchingProcesses SearchingProcesses::Single()
{
  const auto keep = [](std::vector<double>&) {};
  return { true, keep, keep, [](std::vector<float> own) { return own; } };
}

std::vector<float> LaidOver(std::vector<float> front, const std::vector<float>& behind)
{
  if (front.empty())
  {
    return behind;
  }
  for (std::size_t pixel = 0; pixel < behind.size(); pixel += 4)
  {
    const float transmittance = 1.0F - front[pixel + 3];
    for (std::size_t channel = pixel; channel < pixel + 4; ++channel)
    {
      front[channel] += transmittance * behind[channel];
    }
  }
  return front;
}

SharedSearch::SharedSearch() = default;

SharedSearch::~SharedSearch() = default;

std::optional<CommonSteps> SharedSearch::Find(vtkRenderer* renderer, vtkVolume* volume,
  const std::vector<vtkVariationFieldVolumeMapper*>& mappers, const SearchingProcesses& processes)
{
  bool isRefused = false;
  std::vector<Part> parts = this->PartsOf(renderer, volume, mappers, isRefused);
  const std::optional<CommonSteps> found = this->Search(parts, isRefused, processes);
  for (vtkVariationFieldVolumeMapper* mapper : mappers)
  {
    mapper->Private->Marcher.SetCommonSteps(found);
  }
  return found;
}

// Faults are those of the drawing that follows, which reports them.
std::vector<SharedSearch::Part> SharedSearch::PartsOf(vtkRenderer* renderer, vtkVolume* volume,
  const std::vector<vtkVariationFieldVolumeMapper*>& mappers, bool& isRefused) const
{
  std::vector<Part> parts;
  try
  {
    // The renderer moves lights with the camera only while it draws.
    if (renderer->GetLightFollowCamera())
    {
      renderer->UpdateLightsGeometryToFollowCamera();
    }
    for (vtkVariationFieldVolumeMapper* mapper : mappers)
    {
      std::optional<Frame> frame = BuildFrame(mapper, renderer, volume);
      if (!frame)
      {
        continue;
      }
      isRefused = isRefused || IsInteractive(mapper, volume, *frame);
      frame->settings.sceneGeometry = false;
      frame->view.window->MakeCurrent();
      RayMarcher& marcher = mapper->Private->Marcher;
      if (std::optional<PreparedTrials> trials =
            isRefused ? std::nullopt : marcher.PrepareTrials(*frame))
      {
        parts.push_back({ &marcher, std::move(*frame), std::move(*trials) });
      }
    }
  }
  catch (const std::exception&)
  {
    isRefused = true;
  }
  return parts;
}

// A part that cannot be drawn shows nothing here, and drawing reports why.
std::vector<float> SharedSearch::DrawParts(std::vector<Part>& parts, const TrialImage& image)
{
  std::vector<float> whole;
  try
  {
    for (Part& part : parts)
    {
      whole = LaidOver(std::move(whole),
        part.marcher->DrawTrials(part.frame, part.trials.plan, { image }).front());
    }
  }
  catch (const std::exception&)
  {
    whole.clear();
  }
  return whole;
}

// Tells the parts the box of the whole, and returns the coarsest distance of all processes for it:
// a part is thinner.
double SharedSearch::TellWhole(
  std::vector<Part>& parts, const Box& wholeData, const SearchingProcesses& processes)
{
  std::vector<double> coarsest = { NumberOfNoPart };
  for (Part& part : parts)
  {
    part.trials.plan.wholeData = wholeData;
    const Box grid = BoxInGrid(part.frame, wholeData);
    MergeNumbers(coarsest, { CoarsestDistanceMm(part.frame, grid, DiagonalMm(part.frame, grid)) });
  }
  processes.takeLeast(coarsest);
  return coarsest.front();
}

std::optional<CommonSteps> SharedSearch::Search(
  std::vector<Part>& parts, bool isRefused, const SearchingProcesses& processes)
{
  std::vector<ToleranceInputs> inputs;
  const std::size_t factCount = NumbersOf(SearchFacts()).size();
  std::vector<double> least(factCount + NumbersPerBox, NumberOfNoPart);
  for (const Part& part : parts)
  {
    inputs.push_back(part.trials.inputs);
    std::vector<double> numbers = NumbersOf(part.trials.facts);
    const std::vector<double> ofBox = NumbersOfBox(part.frame);
    numbers.insert(numbers.end(), ofBox.begin(), ofBox.end());
    MergeNumbers(least, numbers);
  }
  const bool isKnown = this->made && this->made->inputs == inputs;
  least.insert(least.end(), { IfAny(isRefused), IfAny(!isKnown) });
  processes.takeLeast(least);
  const bool isNew = HoldsForAny(least.back());
  least.pop_back();
  if (HoldsForAny(least.back()) || least.front() == NumberOfNoPart)
  {
    return std::nullopt;
  }
  if (!isNew)
  {
    return this->made->steps;
  }
  const Box wholeData = BoxOf(&least[factCount]);
  SearchFacts facts = FactsOf(least);
  facts.range.coarsest = TellWhole(parts, wholeData, processes);
  const auto drawOwn = [&](const TrialImage& image) { return DrawParts(parts, image); };
  std::optional<CommonSteps> found =
    processes.isLeader ? LeadSearch(facts, drawOwn, processes) : FollowSearch(drawOwn, processes);
  if (found)
  {
    found->wholeData = wholeData;
  }
  this->made = found ? std::make_unique<Made>(Made{ std::move(inputs), *found }) : nullptr;
  ++this->searches;
  return found;
}

}
