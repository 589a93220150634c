#ifndef Varimarch_Tolerance_SharedSearch_h
#define Varimarch_Tolerance_SharedSearch_h

#include "Frame/MarchPlan.h"
#include "VarimarchVolumeModule.h" // for the export macro

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;
class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

struct TrialImage;

/// Communication of the processes that search together. Each function is called by all of them at
/// the same time. The first process leads.
struct SearchingProcesses
{
  bool isLeader = true;
  /// Replaces each number by the least one of all processes.
  std::function<void(std::vector<double>& numbers)> takeLeast;
  /// Replaces the numbers by those of the leader.
  std::function<void(std::vector<double>& numbers)> takeFromLeader;
  /// Lays the images of all processes over each other, premultiplied RGBA; empty ones show nothing.
  /// Only the leader needs the result.
  std::function<std::vector<float>(std::vector<float> own)> layOver;

  /// One process alone.
  VARIMARCHVOLUME_EXPORT static SearchingProcesses Single();
};

/// Finds the steps that keep the error tolerance of a volume of which several mappers, on one
/// process or on several, draw a part each. The trial images are those of the whole volume, and
/// lengths are rounded to few, so that the result hardly depends on how the volume is divided:
/// Documentation/Decisions/0048-one-search-for-all-parts.md. It remembers the last result.
class VARIMARCHVOLUME_EXPORT SharedSearch
{
public:
  SharedSearch();
  ~SharedSearch();

  /// Lets mappers draw their next still images with the steps of a search. All draw with steps of
  /// their own if no part has a tolerance, if somebody interacts, or if the search fails, which
  /// drawing then reports.
  /// @param mappers  those of the parts on this process, front to back; may be none
  /// @return  the steps, the same on all processes; none for steps of their own
  std::optional<CommonSteps> Find(vtkRenderer* renderer, vtkVolume* volume,
    const std::vector<vtkVariationFieldVolumeMapper*>& mappers,
    const SearchingProcesses& processes);

  int Searches() const { return this->searches; } ///< The number of searches so far.

private:
  struct Part;
  struct Made;

  std::vector<Part> PartsOf(vtkRenderer* renderer, vtkVolume* volume,
    const std::vector<vtkVariationFieldVolumeMapper*>& mappers, bool& isRefused) const;
  static std::vector<float> DrawParts(std::vector<Part>& parts, const TrialImage& image);
  static double TellWhole(
    std::vector<Part>& parts, const Box& wholeData, const SearchingProcesses& processes);
  std::optional<CommonSteps> Search(
    std::vector<Part>& parts, bool isRefused, const SearchingProcesses& processes);

  std::unique_ptr<Made> made; ///< The last result of a search.
  int searches = 0;
};

/// The image of a part laid over the one behind it, premultiplied RGBA. An empty image shows
/// nothing.
VARIMARCHVOLUME_EXPORT std::vector<float> LaidOver(
  std::vector<float> front, const std::vector<float>& behind);

}

#endif
