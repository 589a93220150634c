#ifndef Varimarch_Viewer_StudyTimes_h
#define Varimarch_Viewer_StudyTimes_h

#include "Viewer/Model/Study.h"

#include <memory>
#include <vector>

namespace varimarch
{

struct Scene;
class SceneModel;

/// Reads the times of a scan for images in files, together with those of the volumes over it that
/// follow them.
class StudyTimes
{
public:
  StudyTimes(const Scene& scene, std::shared_ptr<const Study> study);

  /// The study at a time.
  /// @param observer  as for LoadVolume
  /// @throws std::runtime_error with one sentence
  std::shared_ptr<const Study> Read(int time, const LoadObserver& observer = {});

private:
  std::shared_ptr<const Study> study;               ///< at the time that was read last
  std::vector<std::unique_ptr<TimeReader>> readers; ///< one per volume; null if it stays
};

/// The study of a model at the time that its scene names, for images and numbers in files: the
/// window may still show the time before.
/// @throws std::runtime_error with one sentence
std::shared_ptr<const Study> ShownStudy(const SceneModel& model);

}

#endif
