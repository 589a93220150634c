// The part of VolumeView that finds what is under the pointer.

#include "Viewer/View/VolumeView.h"

#include "Scene/Placing.h"
#include "Scene/SceneCuts.h"
#include "Scene/ScenePicking.h"
#include "Scene/SceneVolumes.h"
#include "Scene/WorldVector.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/View/WordsEditor.h"

#include <QMouseEvent>

namespace varimarch
{

std::optional<std::array<double, 3>> VolumeView::PointAt(const QPointF& place) const
{
  const SightLine sight = this->Frame().sightLineAt(place);
  return PointSeen(this->model->CurrentScene(), this->model->CurrentStudy()->volume.image,
    NumbersOf(sight.nearest), NumbersOf(sight.farthest), this->Mask());
}

// The point of the edited volume that is seen if it is alone. The cuts are those of the first.
std::optional<std::array<double, 3>> VolumeView::PointOfEdited(const QPointF& place) const
{
  const int edited = this->model->EditedVolume();
  if (edited == 0)
  {
    return this->PointAt(place);
  }
  Scene scene = this->model->EditedScene();
  scene.cuts.planes = PlanesOf(scene.cuts, this->model->CurrentStudy()->volume.image);
  scene.cuts.box = SceneCuts().box;
  const SightLine sight = this->Frame().sightLineAt(place);
  return PointSeen(scene,
    Placed(this->model->EditedStudy()->volume.image, PlacementOf(scene, edited)),
    NumbersOf(sight.nearest), NumbersOf(sight.farthest));
}

void VolumeView::AskForWords(const QPointF& place, const std::function<void(const QString&)>& take)
{
  AskForWordsOver(this, place, take);
}

void VolumeView::Point(const QPointF& place)
{
  const std::optional<std::array<double, 3>> point = this->PointAt(place);
  emit this->Pointed(point
      ? PointText(this->model->CurrentScene(), *this->model->CurrentStudy(), *point)
      : QString());
}

// True if the event is a press that adds a region to a segment.
bool VolumeView::PressSegment(QEvent* event)
{
  const bool isPress = event->type() == QEvent::MouseButtonPress;
  const auto* const mouse = isPress ? static_cast<QMouseEvent*>(event) : nullptr;
  if (!mouse || mouse->button() != Qt::LeftButton || !this->segmentEditor ||
    !this->segmentEditor->TakesVolume())
  {
    return false;
  }
  if (const auto point = this->PointOfEdited(mouse->localPos()))
  {
    this->segmentEditor->AddRegion(*point);
  }
  return true;
}

}
