#ifndef Varimarch_Viewer_StudyTimes_h
#define Varimarch_Viewer_StudyTimes_h

#include "Viewer/Model/SizedTimes.h"
#include "Viewer/Model/Study.h"

#include <memory>
#include <string>
#include <vector>

namespace varimarch
{

struct Scene;
class SceneModel;

/// Reads the times of a scan for images in files, together with those of the volumes over it that
/// follow them. A volume over it whose time cannot be read stays at the time before, as in the
/// window.
class StudyTimes
{
public:
  StudyTimes(const Scene& scene, std::shared_ptr<const Study> study);

  /// The study at a time.
  /// @param observer  as for LoadVolume
  /// @throws std::runtime_error with one sentence if it is cancelled or the scan cannot be read
  std::shared_ptr<const Study> Read(int time, const LoadObserver& observer = {});

  /// Why a volume over the scan stayed at the time before, for the first time that this happened;
  /// empty if none did.
  const std::string& Problem() const { return this->problem; }

private:
  void ReadVolume(int volume, int time, const LoadObserver& observer);

  std::string problem;
  std::shared_ptr<const Study> study;               ///< at the time that was read last
  std::vector<std::unique_ptr<SizedTimes>> readers; ///< one per volume; null if it stays
};

/// The study of a model at the time that its scene names, for images and numbers in files: the
/// window may still show the time before.
/// @throws std::runtime_error with one sentence
std::shared_ptr<const Study> ShownStudy(const SceneModel& model);

}

#endif
