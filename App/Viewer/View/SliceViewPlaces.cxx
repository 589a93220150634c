// The part of SliceView that knows which point of the patient is where.

#include "Viewer/View/SliceView.h"

#include "Scene/SceneCuts.h"
#include "Scene/WorldVector.h"
#include "Viewer/View/WordsEditor.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace varimarch
{

PictureFrame SliceView::Frame() const
{
  const SliceAxes axes = this->Axes();
  const glm::dvec3 through = VectorOf(axes.through);
  const auto sightLineAt = [this, through](const QPointF& place)
  {
    const glm::dvec3 point = VectorOf(*this->PointAt(place));
    return SightLine{ point - through, point + through };
  };
  return { this->size(),
    [this](const std::array<double, 3>& point) { return std::optional(this->PlaceOf(point)); },
    sightLineAt, axes.right, NumbersOf(-VectorOf(axes.down)), NumbersOf(-through) };
}

std::optional<glm::dvec3> SliceView::Through() const
{
  return VectorOf(this->Axes().through);
}

// True for objects that reach into the slab, or within half a voxel of a single slice.
bool SliceView::Shows(const std::vector<glm::dvec3>& points) const
{
  const double* const spacing = this->model->CurrentStudy()->volume.image->GetSpacing();
  const double reachMm = 0.5 *
    std::max(this->model->CurrentScene().slices.slabMm, *std::max_element(spacing, spacing + 3));
  const glm::dvec3 through = VectorOf(this->Axes().through);
  const double crosshairMm = glm::dot(VectorOf(this->Crosshair()), through);
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  for (const glm::dvec3& point : points)
  {
    const double depth = glm::dot(point, through) - crosshairMm;
    first = std::min(first, depth);
    last = std::max(last, depth);
  }
  return first <= reachMm && last >= -reachMm;
}

void SliceView::AskForWords(const QPointF& place, const std::function<void(const QString&)>& take)
{
  AskForWordsOver(this, place, take);
}

std::optional<std::array<double, 3>> SliceView::PointAt(const QPointF& place) const
{
  return this->Placement().PointAt(place);
}

QPointF SliceView::PlaceOf(const std::array<double, 3>& pointMm) const
{
  return this->Placement().PlaceOf(pointMm);
}

SliceRequest SliceView::Request() const
{
  const SlicePlacement placement = this->Placement();
  const SliceGrays grays = this->Grays();
  const SliceSettings& slices = this->model->CurrentScene().slices;
  return { this->plane, placement.MiddleMm(), placement.MmPerPixel(), this->width(), this->height(),
    grays.windowLevel[0], grays.windowLevel[1], slices.slabMm, slices.slabBlend, grays.inverted,
    slices.turn };
}

SlicePlacement SliceView::Placement() const
{
  return { this->model->CurrentStudy()->volume.image, this->Axes(), this->Crosshair(), this->size(),
    this->zoom };
}

SliceAxes SliceView::Axes() const
{
  return AxesOf(this->plane, this->model->CurrentScene().slices.turn);
}

CrosshairArms SliceView::Arms() const
{
  return { this->plane, this->model->CurrentScene().slices.turn, this->Placement(),
    this->Crosshair(), this->size() };
}

std::array<double, 3> SliceView::Crosshair() const
{
  return this->model->CurrentScene().slices.crosshairMm.value_or(
    MiddleOf(this->model->CurrentStudy()->volume.image));
}

SliceGrays SliceView::Grays() const
{
  const auto study = this->model->CurrentStudy();
  SliceGrays grays = SuggestedGrays(study->volume, study->statistics);
  grays.windowLevel = this->model->CurrentScene().slices.windowLevel.value_or(grays.windowLevel);
  return grays;
}

void SliceView::SetCrosshair(const std::array<double, 3>& pointMm, int ofGesture)
{
  this->model->Edit(
    ScenePart::Slices, tr("move the crosshair"),
    [&](Scene& scene) { scene.slices.crosshairMm = pointMm; }, ofGesture);
}

}
