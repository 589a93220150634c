#include "Viewer/Model/StudyTimes.h"

#include "Scene/SceneVolumes.h"
#include "Viewer/Model/SceneModel.h"

#include <stdexcept>
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
        ? std::make_unique<SizedTimes>(scene, volume, one.volume)
        : nullptr);
  }
}

std::shared_ptr<const Study> StudyTimes::Read(int time, const LoadObserver& observer)
{
  bool isCancelled = false;
  const LoadObserver asking = [&](double part)
  {
    isCancelled = isCancelled || (observer && !observer(part));
    return !isCancelled;
  };
  for (int volume = 0; volume < int(this->readers.size()); ++volume)
  {
    try
    {
      this->ReadVolume(volume, time, asking);
    }
    catch (const std::runtime_error& failure)
    {
      if (volume == 0 || isCancelled)
      {
        throw;
      }
      this->problem = this->problem.empty() ? failure.what() : this->problem;
    }
  }
  return this->study;
}

void StudyTimes::ReadVolume(int volume, int time, const LoadObserver& observer)
{
  const Study& one = StudyOfVolume(*this->study, volume);
  if (this->readers[volume] && one.volume.times.current != time)
  {
    const LoadedVolume ofTime = this->readers[volume]->Read(time, observer);
    this->study = WithVolume(*this->study, volume, AtTime(one, ofTime));
  }
}

std::shared_ptr<const Study> ShownStudy(const SceneModel& model)
{
  return StudyTimes(model.CurrentScene(), model.CurrentStudy()).Read(model.ChosenTime());
}

}
