#include "ScalingBench.h"

#include <new>
#include <stdexcept>

namespace varimarch
{

namespace
{

void AddRound(const LoadedScene& loaded, MapperKind kind, ScalingPoint& point)
{
  OffscreenView view(loaded.scene, loaded.volume.image, kind);
  point.rounds.push_back(CostOfFrames(view, loaded.scene.look));
  if (point.rounds.size() == 1)
  {
    view.Pipeline().SetLook(loaded.scene.look);
    point.graphicsBytes = GraphicsBytes(view);
    point.fetchesPerPixel = FetchesPerPixel(view);
  }
}

}

void AddScalingPoints(const LoadedScene& loaded, int side, int rounds, const OnStep& onStep,
  std::vector<ScalingCurve>& curves)
{
  std::vector<ScalingPoint> points(curves.size(), ScalingPoint{ side, {}, {}, {}, {} });
  for (int round = 1; round <= rounds; ++round)
  {
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      if (!curves[i].stopped.empty())
      {
        continue;
      }
      onStep("round " + std::to_string(round) + " of " + std::to_string(rounds));
      try
      {
        AddRound(loaded, curves[i].kind, points[i]);
      }
      catch (const std::runtime_error& problem)
      {
        curves[i].stopped = problem.what();
      }
      catch (const std::bad_alloc&)
      {
        curves[i].stopped = "memory ran out";
      }
    }
  }
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    if (curves[i].stopped.empty())
    {
      points[i].median = MedianOf(points[i].rounds);
      curves[i].points.push_back(points[i]);
    }
  }
}

}
