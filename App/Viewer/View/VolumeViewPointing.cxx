// The part of VolumeView that finds what is under the pointer.

#include "Viewer/View/VolumeView.h"

#include "Scene/ScenePicking.h"
#include "Scene/WorldVector.h"
#include "Viewer/Model/NumberText.h"

namespace varimarch
{

namespace
{

// ", liver" in a visible segment of this name, otherwise empty.
QString SegmentText(const SceneLabels& labels, vtkImageData* numbers, std::array<double, 3> pointMm)
{
  const vtkIdType voxel = numbers->FindPoint(pointMm.data());
  const int number =
    voxel < 0 ? 0 : static_cast<const unsigned char*>(numbers->GetScalarPointer())[voxel];
  const bool isShown = number > 0 && labels.segments[number - 1].visible;
  return isShown ? ", " + QString::fromStdString(labels.segments[number - 1].name) : QString();
}

}

std::optional<std::array<double, 3>> VolumeView::PointAt(const QPointF& place) const
{
  const SightLine sight = this->Frame().sightLineAt(place);
  return PointSeen(this->model->CurrentScene(), this->model->CurrentStudy()->volume.image,
    NumbersOf(sight.nearest), NumbersOf(sight.farthest), this->pipeline->Mask());
}

void VolumeView::Point(const QPointF& place)
{
  const std::optional<std::array<double, 3>> point = this->PointAt(place);
  if (!point)
  {
    emit this->Pointed({});
    return;
  }
  const Study& study = *this->model->CurrentStudy();
  const LoadedVolume& volume = study.volume;
  const std::optional<SceneLabels>& labels = this->model->CurrentScene().labels;
  emit this->Pointed(tr("%1%2 at %3, %4, %5 mm")
                       .arg(volume.modality == "CT" ? tr("HU ") : tr("value "))
                       .arg(NumberText(ValueAt(volume.image, *point).value_or(0.0), 0))
                       .arg(NumberText((*point)[0], 1))
                       .arg(NumberText((*point)[1], 1))
                       .arg(NumberText((*point)[2], 1)) +
    (labels ? SegmentText(*labels, study.labels->image, *point) : QString()));
}

}
