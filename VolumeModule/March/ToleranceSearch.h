#ifndef Varimarch_March_ToleranceSearch_h
#define Varimarch_March_ToleranceSearch_h

#include "Core/Geometry/ProjectedBox.h"
#include "Core/Quality/StepSearch.h"
#include "Resources/VolumeResources.h"

#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace varimarch
{

/// All that the steps which keep a tolerance depend on.
struct ToleranceInputs
{
  std::vector<double> rule;      ///< that the rule of integration depends on too
  std::vector<double> scene;     ///< in any view
  std::vector<CornersClip> view; ///< where the volumes are in it

  /// Those of one volume.
  void Add(const Frame& frame, const VolumeBuilds& builds);

  bool operator==(const ToleranceInputs& other) const
  {
    return this->rule == other.rule && this->scene == other.scene && this->view == other.view;
  }
  /// Whether the scene is the same, and the view nearly.
  bool IsNear(const ToleranceInputs& other) const;
};

/// How a picture keeps an error tolerance.
struct ToleranceChoice
{
  ToleranceInputs inputs; ///< that it was found for
  Integration integration;
  StepChoice step;
  double missedOfLimit = 0.0; ///< found once per rule: peaks between samples, as step.ofLimit
};

/// The rays that a picture of this size is tried out with: enough to show the 99.9th percentile of
/// an error, in two tiles of a software rasteriser, so that two cores share the work.
Viewport ProbePixelsFor(const Viewport& picture);

/// Draws a frame that is to be tried out: premultiplied RGBA of its pixels.
using ProbeDrawing = std::function<std::vector<float>(const Frame& tried)>;

/// Finds the steps that keep a frame's error tolerance, by trying them out with a part of its rays,
/// and keeps them as long as they serve: Documentation/Decisions/0008.
class ToleranceSearch
{
public:
  /// @param inputs  those of all volumes of the frame
  void Update(const Frame& frame, const VolumeResources& volume, const ToleranceInputs& inputs,
    const ProbeDrawing& draw);
  void Forget() { this->choice.reset(); }

  /// For the last picture, or one before from nearly the same place; nothing when there is none.
  const std::optional<ToleranceChoice>& Choice() const { return this->choice; }
  /// Of the choice, which there must be, as far as the view is from where it was found.
  double SampleDistanceInViewMm() const;
  int Searches() const { return this->searches; } ///< so far

private:
  /// What is drawn of a frame to find its steps.
  struct Trial
  {
    const Frame& frame;
    const VolumeResources& volume;
    const ProbeDrawing& draw;
    ErrorLimit limit;
    /// Pictures by what they differ in: whether they are lit, by which rule, at which distance.
    std::map<std::tuple<bool, Integration, double>, std::vector<float>> drawn = {};

    const std::vector<float>& Draw(Frame tried, Integration integration, double sampleDistanceMm);
    /// @param exact  as FindSampleDistance
    FoundSteps Find(Integration integration, double firstMm, const std::vector<float>& exact = {});
  };

  ToleranceChoice ChooseSteps(Trial trial, const ToleranceInputs& inputs) const;
  /// Whether another rule may keep the limit in less time than midpoints.
  /// @param finest  as FoundSteps
  static bool PreIntegrationMayPay(
    Trial& trial, const ToleranceChoice& choice, const std::vector<float>& finest);
  static double MissedOfLimit(Trial& trial, const ToleranceChoice& choice);

  std::optional<ToleranceChoice> choice;
  std::vector<CornersClip> view; ///< of the last picture that kept a tolerance
  bool viewRests = false;        ///< that is also the view of the picture before
  int searches = 0;
};

}

#endif
