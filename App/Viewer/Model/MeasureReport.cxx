#include "Viewer/Model/MeasureReport.h"

#include "DicomMeasures/DicomMeasures.h"
#include "Readers/Dicom/TaggedSeries.h"
#include "Scene/Placing.h"
#include "Scene/SceneVolumes.h"

#include <QCoreApplication>

#include <algorithm>
#include <stdexcept>
#include <variant>

namespace varimarch
{

bool MeasureReport::IsPossible(const Scene& scene, const Study& study, int volume)
{
  return !StudyOfVolume(study, volume).volume.frameOfReference.empty() &&
    std::holds_alternative<FileSource>(VolumeSourceOf(scene, volume));
}

MeasureReport::MeasureReport(const Scene& scene, const Study& shown, int volume)
  : scan(std::get<FileSource>(VolumeSourceOf(scene, volume)))
  , volume(StudyOfVolume(shown, volume).volume)
{
  const Placement placement = PlacementOf(scene, volume);
  const bool hasBox = std::any_of(scene.measures.begin(), scene.measures.end(),
    [](const Measure& measure) { return measure.kind == MeasureKind::Box; });
  if (hasBox && !AreTurnedAlike(shown.volume.image, Placed(this->volume.image, placement)))
  {
    throw std::runtime_error(QCoreApplication::translate("MeasureReport",
      "A box lies along the axes of the first scan, and this one has others. "
      "Remove the boxes, or save a table.")
                               .toStdString());
  }
  this->measures = InPatientCoordinates(scene.measures, placement, this->volume.image);
  this->volume.image = SharedCopy(this->volume);
}

void MeasureReport::Write(const std::string& path, const TaskProgress& goesOn) const
{
  ReadProgress progress(goesOn);
  const TaggedSeries images(this->scan.path, this->scan.series, progress);
  WriteDicomMeasures(this->measures, this->volume, images.Files(), path);
}

}
