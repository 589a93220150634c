#ifndef Varimarch_March_ToleranceSearch_h
#define Varimarch_March_ToleranceSearch_h

#include "Core/Geometry/ProjectedBox.h"
#include "Core/Quality/StepSearch.h"
#include "Resources/VolumeResources.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace varimarch
{

/// Everything that the result of a tolerance search depends on.
struct ToleranceInputs
{
  std::vector<std::string> recipe; ///< The shader files of the request.
  std::vector<double> rule;        ///< Other inputs of the choice of the rule, without voxels.
  std::vector<int> voxels;         ///< The build number of the voxels of each volume.
  std::vector<double> scene;       ///< Other inputs of the image in any view.
  std::vector<CornersClip> view;   ///< The corners of the volumes in the view.

  /// Adds the inputs of one volume.
  void Add(const VolumeMarch& march, const VolumeBuilds& builds);

  bool HasRuleOf(const ToleranceInputs& other) const
  {
    return this->recipe == other.recipe && this->rule == other.rule;
  }
  bool HasSceneOf(const ToleranceInputs& other) const
  {
    return this->HasRuleOf(other) && this->voxels == other.voxels && this->scene == other.scene;
  }
  bool operator==(const ToleranceInputs& other) const
  {
    return this->HasSceneOf(other) && this->view == other.view;
  }
  /// True if the scene is the same, and the view nearly the same.
  bool IsNear(const ToleranceInputs& other) const;
};

/// The integration rule and the steps that keep an error tolerance.
struct ToleranceChoice
{
  ToleranceInputs inputs; ///< The inputs of the search that found it.
  Integration integration;
  StepChoice step;
  double missedOfLimit = 0.0; ///< The error that no sample distance shows, in parts of the limit.
};

/// Draws a trial image and returns premultiplied RGBA of the pixels of the plan's viewport.
using TrialDrawing = std::function<std::vector<float>(const MarchPlan& tried)>;

/// Finds the steps that keep a frame's error tolerance by drawing trial images with some of its
/// rays, and reuses them as long as they are valid: Documentation/Decisions/0008.
class ToleranceSearch
{
public:
  /// @param volume  the first volume
  /// @param inputs  the inputs of all volumes of the frame
  void Update(const VolumeMarch& march, const VolumeResources& volume,
    const ToleranceInputs& inputs, const TrialDrawing& draw);
  void Forget() { this->choice.reset(); }

  /// The choice for the last image, or for an earlier one from nearly the same view. Empty if the
  /// last image had no tolerance.
  const std::optional<ToleranceChoice>& Choice() const { return this->choice; }
  /// The chosen sample distance, scaled to the present view [mm]. Requires a Choice().
  double SampleDistanceInViewMm() const;
  int Searches() const { return this->searches; } ///< The number of searches so far.

private:
  /// The trial images of one search.
  struct Trial
  {
    const VolumeMarch& march;
    const VolumeResources& volume;
    const TrialDrawing& draw;
    ErrorLimit limit;
    /// The images drawn so far, by lighting, rule and sample distance.
    std::map<std::tuple<bool, Integration, double>, std::vector<float>> drawn = {};

    const std::vector<float>& Draw(Integration integration, double sampleDistanceMm);
    const std::vector<float>& DrawUnlit(Integration integration, double sampleDistanceMm);
    /// Unlit, with a pre-integrated table of half as many values on a side.
    std::vector<float> DrawWithSmallTable(double sampleDistanceMm);
    /// @param exact  see FindSampleDistance
    FoundSteps Find(Integration integration, double firstMm, const std::vector<float>& exact = {});

  private:
    const std::vector<float>& DrawOnce(bool isLit, Integration integration, double distanceMm);
    MarchPlan PlanOf(bool isLit, Integration integration, double distanceMm) const;
  };

  ToleranceChoice ChooseSteps(Trial trial, const ToleranceInputs& inputs) const;
  /// True if pre-integration might keep the limit in less time than midpoints.
  /// @param finest  see FoundSteps
  static bool PreIntegrationMayPay(
    Trial& trial, const ToleranceChoice& choice, const std::vector<float>& finest);
  /// The part of the error that no sample distance shows.
  static double MissedOfLimit(Trial& trial, const ToleranceChoice& choice);
  static double MissedPeaksOfLimit(Trial& trial, const ToleranceChoice& choice);
  static double LostOfLimit(Trial& trial, double distanceMm);

  std::optional<ToleranceChoice> choice;
  std::vector<CornersClip> view; ///< The view of the last image with a tolerance.
  bool viewRests = false;        ///< True if the previous image had the same view.
  std::vector<int> voxels;       ///< The build numbers of the voxels of the last image.
  bool voxelsWereNew = false;    ///< True if they were not those of the image before it.
  bool isSeries = false;         ///< True if the last two images had new voxels.
  int searches = 0;
};

}

#endif
