// The part of VolumeView that finds what is under the pointer.

#include "Viewer/View/VolumeView.h"

#include "Scene/ScenePicking.h"
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
    NumbersOf(sight.nearest), NumbersOf(sight.farthest), this->pipeline->Mask());
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
  if (const auto point = this->PointAt(mouse->localPos()))
  {
    this->segmentEditor->AddRegion(*point);
  }
  return true;
}

}
