#ifndef Varimarch_March_ToleranceSearch_h
#define Varimarch_March_ToleranceSearch_h

#include "Core/Quality/StepSearch.h"
#include "March/SearchFacts.h"
#include "March/ToleranceInputs.h"
#include "March/TrialImages.h"

#include <list>
#include <optional>
#include <vector>

namespace varimarch
{

/// The integration rule and the steps that keep an error tolerance.
struct ToleranceChoice
{
  ToleranceInputs inputs; ///< The inputs of the search that found it.
  Integration integration;
  StepChoice step;
  double missedOfLimit = 0.0; ///< The error that no sample distance shows, in parts of the limit.
  LightSource light = {};     ///< The way to the light of the image.
  bool isOfOtherCasters = false; ///< True if it was found before geometry moved, and tried since.
};

/// Finds the steps that keep a frame's error tolerance by drawing trial images with some of its
/// rays, and reuses them as long as they are valid: Documentation/Decisions/0008. It remembers the
/// choices for the last images, so that times that are played again and views that take turns are
/// searched once.
class ToleranceSearch
{
public:
  /// @param volume  the first volume
  /// @param inputs  the inputs of all volumes of the frame
  void Update(const VolumeMarch& march, const VolumeResources& volume,
    const ToleranceInputs& inputs, const TrialDrawing& draw);
  void Forget();
  /// The steps of a volume of which nothing but these facts and its trial images is known, without
  /// those of earlier images. The choice has no inputs.
  static ToleranceChoice ChooseAnew(const SearchFacts& facts, const TrialDrawing& draw);

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
    SearchFacts facts;
    TrialImages images;
    LightSource light = {};
    bool isSmall = false; ///< True for images with a quarter of the rays.

    const std::vector<float>& Draw(Integration integration, double sampleDistanceMm);
    const std::vector<float>& DrawUnlit(Integration integration, double sampleDistanceMm);
    /// Unlit, with a pre-integrated table of half as many values on a side.
    const std::vector<float>& DrawWithSmallTable(double sampleDistanceMm);
    /// @param exact  see FindSampleDistance
    FoundSteps Find(Integration integration, double firstMm, const std::vector<float>& exact = {});
    FoundSteps FindFrom(Integration integration, double earlierMm);
  };

  /// Finds out what has changed since the last image.
  void BeginImage(const ToleranceInputs& inputs);
  /// Keeps the choice while only geometry moves that casts shadows, if a few rays confirm it.
  bool KeepBesideMovedCasters(Trial trial, const ToleranceInputs& inputs);
  bool Serves(const ToleranceChoice& made, const ToleranceInputs& inputs) const;
  /// Takes an earlier choice for the image, if there is one.
  bool TakeRemembered(const ToleranceInputs& inputs);
  void Remember();
  ToleranceChoice ChooseSteps(Trial trial, const ToleranceInputs& inputs) const;
  static ToleranceChoice ChooseAnew(Trial& trial, const ToleranceInputs& inputs);
  /// A choice that uses as much of the lattices of light as a trial shows to be exact enough, or
  /// one that traces all light.
  /// @param choose  (trial), searches the steps
  template <class Choose>
  static ToleranceChoice ChooseWithLight(Trial& trial, Choose choose);
  /// The error of light that is interpolated in lattices.
  static double KeptLightOfLimit(Trial& trial, const ToleranceChoice& choice);
  /// A choice by the rule of the last one; none if another rule may be better.
  std::optional<ToleranceChoice> ChooseByLastRule(
    Trial& trial, const ToleranceInputs& inputs) const;
  /// True if pre-integration might keep the limit in less time than midpoints.
  /// @param finest  see FoundSteps
  static bool PreIntegrationMayPay(
    Trial& trial, const ToleranceChoice& choice, const std::vector<float>& finest);
  static ToleranceChoice ChoiceOf(
    Trial& trial, const ToleranceInputs& inputs, Integration integration, const FoundSteps& found);
  /// The part of the error that no sample distance shows.
  static double MissedOfLimit(Trial& trial, const ToleranceChoice& choice);
  static double MissedPeaksOfLimit(Trial& trial, const ToleranceChoice& choice);
  static double LostOfLimit(Trial& trial, double distanceMm);

  std::optional<ToleranceChoice> choice;
  std::list<ToleranceChoice> remembered; ///< Earlier choices, the last first.
  std::vector<CornersClip> view;         ///< The view of the last image with a tolerance.
  bool viewRests = false;                ///< True if the previous image had the same view.
  Fingerprint casters;                   ///< The geometry of the last image.
  bool castersRest = false;              ///< True if the previous image had the same geometry.
  Fingerprint voxels;                    ///< The voxels of the last image.
  bool voxelsWereNew = false;            ///< True if they were not those of the image before it.
  bool isSeries = false;                 ///< True if the last two images had new voxels.
  int searches = 0;
};

}

#endif
