#include "FrameCost.h"

#include "CommandLine/ReportedErrors.h"
#include "CommandLine/Results.h"
#include "Scene/Median.h"

#include <vtkVariationFieldVolumeMapper.h>

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace varimarch
{

namespace
{

vtkVariationFieldVolumeMapper* OurMapper(OffscreenView& view)
{
  return vtkVariationFieldVolumeMapper::SafeDownCast(view.Pipeline().Mapper());
}

// The time that the last frame spent on its field.
class FieldStopwatch
{
public:
  explicit FieldStopwatch(OffscreenView& view)
    : mapper(OurMapper(view))
  {
  }

  double Milliseconds()
  {
    const int buildsBefore = this->builds;
    this->builds = this->mapper ? this->mapper->GetFieldBuilds() : 0;
    return this->builds > buildsBefore ? 1000.0 * this->mapper->GetFieldBuildSeconds() : 0.0;
  }

private:
  vtkVariationFieldVolumeMapper* mapper; ///< our mapper; null for VTK's
  int builds = 0;
};

// Several frames, because other processes may take a third of a single one's time.
double StillMs(OffscreenView& view)
{
  constexpr std::size_t FewestPictures = 5;
  constexpr double LeastMs = 50.0;
  std::vector<double> times;
  for (double sum = 0.0; times.size() < FewestPictures || sum < LeastMs; sum += times.back())
  {
    times.push_back(1000.0 * view.Render());
  }
  return Median(times);
}

// Changes every opacity, so that nothing built for the previous look can be reused.
Look HalfAsOpaque(Look look)
{
  for (OpacityNode& node : look.opacities)
  {
    node.opacity *= 0.5;
  }
  return look;
}

}

FrameCost CostOfFrames(OffscreenView& view, const Look& look)
{
  FrameCost cost = {};
  FieldStopwatch field(view);
  cost.firstMs = 1000.0 * view.Render();
  cost.firstFieldMs = field.Milliseconds();
  cost.stillMs = StillMs(view);
  view.Pipeline().SetLook(HalfAsOpaque(look));
  const double changedMs = 1000.0 * view.Render();
  cost.changeFieldMs = field.Milliseconds();
  cost.rebuildMs = changedMs - 1000.0 * view.Render();
  ThrowIfVtkReportedError();
  return cost;
}

FrameCost MedianOf(const std::vector<FrameCost>& rounds)
{
  FrameCost median = {};
  for (double FrameCost::*time : { &FrameCost::firstMs, &FrameCost::stillMs, &FrameCost::rebuildMs,
         &FrameCost::firstFieldMs, &FrameCost::changeFieldMs })
  {
    std::vector<double> times;
    for (const FrameCost& cost : rounds)
    {
      times.push_back(cost.*time);
    }
    median.*time = Median(times);
  }
  return median;
}

nlohmann::ordered_json ToJson(const FrameCost& cost)
{
  return { { "firstMs", cost.firstMs }, { "stillMs", cost.stillMs },
    { "rebuildMs", cost.rebuildMs }, { "firstFieldMs", cost.firstFieldMs },
    { "changeFieldMs", cost.changeFieldMs } };
}

std::optional<double> FetchesPerPixel(OffscreenView& view)
{
  const auto mapper = OurMapper(view);
  if (!mapper)
  {
    return std::nullopt;
  }
  mapper->DrawFetchCountsOn();
  const auto counts = view.FloatImage();
  mapper->DrawFetchCountsOff();
  try
  {
    ThrowIfVtkReportedError();
  }
  catch (const std::runtime_error&)
  {
    return std::nullopt; // shaders count, but this volume is too large for their textures
  }
  const auto* red = static_cast<const float*>(counts->GetScalarPointer());
  double sum = 0.0;
  for (vtkIdType pixel = 0; pixel < counts->GetNumberOfPoints(); ++pixel)
  {
    sum += red[4 * pixel];
  }
  return sum / double(counts->GetNumberOfPoints());
}

std::optional<double> GraphicsBytes(OffscreenView& view)
{
  const auto mapper = OurMapper(view);
  return mapper ? std::optional<double>(mapper->GetGraphicsMemoryBytes()) : std::nullopt;
}

}
