#ifndef Varimarch_Tolerance_ToleranceSearch_h
#define Varimarch_Tolerance_ToleranceSearch_h

#include "Core/Quality/StepSearch.h"
#include "Tolerance/SearchFacts.h"
#include "Tolerance/TrialImages.h"
#include "VarimarchVolumeModule.h" // for the export macro

#include <list>
#include <optional>
#include <vector>

namespace varimarch
{

/// Finds the steps that keep a frame's error tolerance by drawing trial images with some of its
/// rays, and reuses them as long as they are valid: Documentation/Decisions/0008. It remembers the
/// choices for the last images, so that times that are played again and views that take turns are
/// searched once. Some rays of each image have tried its choice: while a view, a light or geometry
/// moves, the steps stay if a quarter of the rays of a search confirm them.
class ToleranceSearch
{
public:
  /// @param volume  the first volume
  /// @param inputs  the inputs of all volumes of the frame
  void Update(const VolumeMarch& march, const VolumeResources& volume,
    const ToleranceInputs& inputs, const TrialDrawing& draw);
  void Forget();
  /// Takes the steps of a search that did not end.
  void Take(const ToleranceInputs& inputs, ToleranceChoice made);
  /// The steps of a volume of which nothing but these facts and its trial images is known, without
  /// those of earlier images. The choice has no inputs.
  VARIMARCHVOLUME_EXPORT static ToleranceChoice ChooseAnew(
    const SearchFacts& facts, const TrialDrawing& draw);

  /// The choice for the last image. Empty if it had no tolerance.
  const std::optional<ToleranceChoice>& Choice() const { return this->choice; }
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
    StepChoice FirstThatKeeps(Integration integration, const std::vector<double>& distancesMm);
  };

  /// Finds out what has changed since the last image.
  void BeginImage(const ToleranceInputs& inputs);
  /// The choice for an image whose view, lights or geometry move, if some rays confirm an earlier
  /// one.
  std::optional<ToleranceChoice> KeptChoice(Trial trial, const ToleranceInputs& inputs) const;
  /// An earlier choice for nearly the same image; null if there is none.
  const ToleranceChoice* NearbyChoice(const ToleranceInputs& inputs) const;
  bool IsAtRest() const { return this->viewRests && this->lightsRest && this->castersRest; }
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
  /// A way to light in lattices that is exact enough for a choice; none if there is none.
  /// @param ofLimit  the error of the light of the choice
  static std::optional<LightSource> ExactLight(
    Trial& trial, ToleranceChoice choice, double ofLimit);
  /// Lets the light of a choice take longer steps than its image, as long as it is exact enough.
  /// @param ofLimit  the error of the light of the choice
  /// @return the same with the steps that it has then
  static double LengthenLight(Trial& trial, ToleranceChoice& choice, double ofLimit);
  /// The error of the light of a choice beside that of its sample distance.
  static double KeptLightOfLimit(Trial& trial, const ToleranceChoice& choice);
  /// True if light in lattices is exact enough; adds its error to the choice.
  static bool KeepsLight(Trial& trial, ToleranceChoice& choice);
  /// A choice by the rule of the last one; none if another rule may be better.
  std::optional<ToleranceChoice> ChooseByLastRule(
    Trial& trial, const ToleranceInputs& inputs) const;
  /// True if pre-integration might keep the limit in less time than midpoints.
  /// @param finest  see FoundSteps
  static bool PreIntegrationMayPay(
    Trial& trial, const ToleranceChoice& choice, const std::vector<float>& finest);
  static ToleranceChoice ChoiceOf(
    Trial& trial, const ToleranceInputs& inputs, Integration integration, const FoundSteps& found);
  /// The choice with an estimated error of at least that of the peaks that its rule misses.
  static ToleranceChoice WithMissed(Trial& trial, ToleranceChoice choice);
  /// The part of the error that no sample distance shows.
  static double MissedOfLimit(Trial& trial, const ToleranceChoice& choice);
  static double MissedPeaksOfLimit(Trial& trial, const ToleranceChoice& choice);
  static double LostOfLimit(Trial& trial, double distanceMm);

  std::optional<ToleranceChoice> choice;
  std::list<ToleranceChoice> remembered; ///< Earlier choices, the last first.
  std::vector<CornersClip> view;         ///< The view of the last image with a tolerance.
  bool viewRests = false;                ///< True if the previous image had the same view.
  ToleranceLights lights;                ///< The lights of the last image.
  bool lightsRest = false;               ///< True if the previous image had the same lights.
  Fingerprint casters;                   ///< The geometry of the last image.
  bool castersRest = false;              ///< True if the previous image had the same geometry.
  Fingerprint voxels;                    ///< The voxels of the last image.
  bool voxelsWereNew = false;            ///< True if they were not those of the image before it.
  bool isSeries = false;                 ///< True if the last two images had new voxels.
  int searches = 0;
};

}

#endif
