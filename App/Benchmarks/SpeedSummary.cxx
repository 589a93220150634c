#include "SpeedSummary.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace varimarch
{

namespace
{

// The setup of a measurement: true if shaded, and the side of the image [pixels].
using Setup = std::pair<bool, int>;

std::set<Setup> SetupsOf(const std::vector<SpeedCase>& cases)
{
  std::set<Setup> setups;
  for (const SpeedCase& measured : cases)
  {
    setups.insert({ measured.shaded, measured.side });
  }
  return setups;
}

double GeometricMean(const std::vector<double>& numbers)
{
  double sum = 0.0;
  for (const double number : numbers)
  {
    sum += std::log(number);
  }
  return numbers.empty() ? 0.0 : std::exp(sum / double(numbers.size()));
}

SpeedSummary SummaryOf(std::size_t target, const Setup& setup, const std::vector<SpeedCase>& cases)
{
  SpeedSummary summary = { target, setup.first, setup.second, {}, {}, {}, 0.0 };
  std::vector<std::pair<double, std::string>> times;
  for (const SpeedCase& measured : cases)
  {
    if (Setup(measured.shaded, measured.side) != setup || !Rival(measured, SpeedTargets()[target]))
    {
      continue;
    }
    if (const auto timesAsFast = TimesAsFast(measured, target))
    {
      times.push_back({ *timesAsFast, measured.scene });
    }
    else
    {
      summary.failing.push_back(measured.scene);
    }
  }
  std::sort(times.begin(), times.end());
  for (const auto& [timesAsFast, scene] : times)
  {
    summary.timesAsFast.push_back(timesAsFast);
  }
  summary.worstScene = times.empty() ? "" : times.front().second;
  summary.geometricMean = GeometricMean(summary.timesAsFast);
  return summary;
}

}

bool SpeedSummary::IsMet() const
{
  const SpeedTarget& wanted = SpeedTargets()[this->target];
  return this->failing.empty() && this->geometricMean >= wanted.timesWanted &&
    this->timesAsFast.front() >= wanted.timesAtLeast;
}

std::vector<SpeedSummary> SpeedSummaries(const std::vector<SpeedCase>& cases)
{
  std::vector<SpeedSummary> summaries;
  for (std::size_t target = 0; target < SpeedTargets().size(); ++target)
  {
    for (const Setup& setup : SetupsOf(cases))
    {
      const SpeedSummary summary = SummaryOf(target, setup, cases);
      if (!summary.timesAsFast.empty() || !summary.failing.empty())
      {
        summaries.push_back(summary);
      }
    }
  }
  return summaries;
}

LogLogPlot SpeedPlot(const std::vector<SpeedCase>& cases)
{
  LogLogPlot plot = { "Times as fast at the same error", "rank of scene and size, slowest first",
    "times as fast as the rival", {}, { { "equal", 1.0 } } };
  std::vector<std::vector<double>> times(SpeedTargets().size());
  for (const SpeedSummary& summary : SpeedSummaries(cases))
  {
    auto& all = times[summary.target];
    all.insert(all.end(), summary.timesAsFast.begin(), summary.timesAsFast.end());
  }
  for (std::size_t target = 0; target < times.size(); ++target)
  {
    std::sort(times[target].begin(), times[target].end());
    const SpeedTarget& wanted = SpeedTargets()[target];
    PlotCurve curve = { wanted.ours + " against " + wanted.rival, wanted.style, {} };
    for (const double timesAsFast : times[target])
    {
      curve.points.push_back({ double(curve.points.size() + 1), timesAsFast });
    }
    if (!curve.points.empty())
    {
      plot.curves.push_back(curve);
    }
  }
  return plot;
}

}
