#include "Viewer/Model/StudyTimes.h"

#include "Scene/SceneVolumes.h"
#include "Viewer/Model/MemoryLimit.h"
#include "Viewer/Model/SceneModel.h"

#include <utility>

namespace varimarch
{

StudyTimes::StudyTimes(const Scene& scene, std::shared_ptr<const Study> study)
  : study(std::move(study))
{
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    const Study& one = StudyOfVolume(*this->study, volume);
    this->readers.push_back(FollowsTimes(*this->study, one)
        ? std::make_unique<TimeReader>(
            WithinMemory(std::get<FileSource>(VolumeSourceOf(scene, volume))))
        : nullptr);
  }
}

std::shared_ptr<const Study> StudyTimes::Read(int time, const LoadObserver& observer)
{
  for (int volume = 0; volume < int(this->readers.size()); ++volume)
  {
    const Study& one = StudyOfVolume(*this->study, volume);
    if (this->readers[volume] && one.volume.times.current != time)
    {
      const LoadedVolume ofTime = this->readers[volume]->Read(time, observer);
      CheckSizeOfTime(ofTime, SizeOfVolume(one.volume));
      this->study = WithVolume(*this->study, volume, AtTime(one, ofTime));
    }
  }
  return this->study;
}

std::shared_ptr<const Study> ShownStudy(const SceneModel& model)
{
  return StudyTimes(model.CurrentScene(), model.CurrentStudy()).Read(model.ChosenTime());
}

}
