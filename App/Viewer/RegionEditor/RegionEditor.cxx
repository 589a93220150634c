// State and mouse handling of the editor. Its actions and keys are in RegionCommands.cxx.

#include "Viewer/RegionEditor/RegionEditor.h"

#include "Viewer/Model/Gesture.h"

#include <QAction>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double ZoomPerWheelNotch = 1.25;
constexpr double AnglePerWheelNotch = 120.0;

}

RegionEditor::RegionEditor(QWidget* parent)
  : QWidget(parent)
{
  this->setObjectName("regionEditor");
  this->setAccessibleName(tr("Regions of value and gradient"));
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMouseTracking(true);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  this->MakeActions();
}

void RegionEditor::SetHistogram(std::shared_ptr<const ValueGradientHistogram> histogram)
{
  this->picture.histogram = std::move(histogram);
  this->picture.counts =
    PictureOfCounts(*this->picture.histogram, this->palette().color(QPalette::Text));
  this->picture.layout.values.SetData(
    this->picture.histogram->values[0], this->picture.histogram->values[1]);
  this->picture.layout.gradients.SetData(0.0, this->picture.histogram->largestGradient);
  this->ShowAll();
}

void RegionEditor::SetUnit(const QString& unit)
{
  this->picture.unit = unit;
}

void RegionEditor::SetRegions(const std::vector<LookRegion>& regions)
{
  this->picture.regions = regions;
  if (this->picture.selected >= int(regions.size()))
  {
    this->drag = Drag::None;
    this->Select(int(regions.size()) - 1);
  }
  this->update();
}

const LookRegion* RegionEditor::Selected() const
{
  return this->picture.selected >= 0 ? &this->picture.regions[std::size_t(this->picture.selected)]
                                     : nullptr;
}

void RegionEditor::Select(int index)
{
  this->picture.selected = index;
  this->update();
  emit this->SelectionChanged();
}

void RegionEditor::EditSelected(
  const QString& stepName, const std::function<void(LookRegion&)>& change, int changeGesture)
{
  std::vector<LookRegion> regions = this->picture.regions;
  change(regions[std::size_t(this->picture.selected)]);
  this->Edit(regions, stepName, changeGesture);
}

void RegionEditor::Edit(
  const std::vector<LookRegion>& regions, const QString& stepName, int changeGesture)
{
  this->picture.regions = regions;
  this->update();
  emit this->RegionsEdited(regions, stepName, changeGesture);
}

RegionPlane RegionEditor::Plane() const
{
  return this->picture.histogram
    ? RegionPlane{ this->picture.histogram->values, this->picture.histogram->largestGradient }
    : RegionPlane();
}

void RegionEditor::ShowAll()
{
  const RegionPlane plane = this->Plane();
  this->picture.layout.values.Fit(plane.values[0], plane.values[1]);
  this->picture.layout.gradients.Fit(0.0, plane.largestGradient);
  this->update();
}

void RegionEditor::Zoom(const QPointF& position, double factor)
{
  RegionLayout& layout = this->picture.layout;
  layout.values.Zoom(position.x(), factor);
  layout.gradients.Zoom(layout.plot.bottom() - position.y(), factor);
  this->update();
}

void RegionEditor::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  PaintRegions(painter, this->picture, this->palette());
}

void RegionEditor::resizeEvent(QResizeEvent*)
{
  const QFontMetricsF font(this->font());
  this->picture.layout.Resize(this->size(), font.height(), font.horizontalAdvance("00000"));
}

void RegionEditor::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::PaletteChange && this->picture.histogram)
  {
    this->picture.counts =
      PictureOfCounts(*this->picture.histogram, this->palette().color(QPalette::Text));
  }
  QWidget::changeEvent(event);
}

void RegionEditor::mousePressEvent(QMouseEvent* event)
{
  this->pressed = this->last = event->localPos();
  this->gesture = NewGesture();
  if (event->button() == Qt::MiddleButton)
  {
    this->drag = Drag::Plane;
    return;
  }
  if (event->button() != Qt::LeftButton)
  {
    return;
  }
  const RegionLayout& layout = this->picture.layout;
  const LookRegion* const selected = this->Selected();
  const auto onHandle = selected ? layout.HandleAt(*selected, this->pressed) : std::nullopt;
  const auto under = layout.RegionAt(this->picture.regions, this->pressed, this->picture.selected);
  if (!onHandle)
  {
    this->Select(under.value_or(-1));
  }
  if (onHandle || under)
  {
    this->drag = Drag::Region;
    this->handle = onHandle.value_or(RegionHandle());
    this->atPress = *this->Selected();
  }
}

void RegionEditor::mouseMoveEvent(QMouseEvent* event)
{
  if (this->drag == Drag::Region)
  {
    this->DragTo(event->localPos());
  }
  else if (this->drag == Drag::Plane)
  {
    const QPointF moved = event->localPos() - this->last;
    this->picture.layout.values.Pan(moved.x());
    this->picture.layout.gradients.Pan(-moved.y());
    this->update();
  }
  this->last = event->localPos();
  this->Hover(event->localPos());
}

void RegionEditor::DragTo(const QPointF& position)
{
  const RegionLayout& layout = this->picture.layout;
  const double value = layout.ToValue(position.x()) - layout.ToValue(this->pressed.x());
  const double gradient = layout.ToGradient(position.y()) - layout.ToGradient(this->pressed.y());
  const bool moves = this->handle.value == 0 && this->handle.gradient == 0;
  this->EditSelected(
    moves ? tr("move a region") : tr("resize a region"),
    [&](LookRegion& region)
    { region = DragRegion(this->atPress, this->handle, value, gradient, this->Plane()); },
    this->gesture);
}

void RegionEditor::CancelDrag()
{
  if (this->drag == Drag::Region)
  {
    this->DragTo(this->pressed);
  }
  this->drag = Drag::None;
}

void RegionEditor::mouseReleaseEvent(QMouseEvent* event)
{
  this->drag = Drag::None;
  this->Hover(event->localPos());
}

void RegionEditor::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton && this->Selected())
  {
    this->drag = Drag::None;
    this->ChooseColor();
  }
}

void RegionEditor::wheelEvent(QWheelEvent* event)
{
  const double notches = event->angleDelta().y() / AnglePerWheelNotch;
  this->Zoom(event->position(), std::pow(ZoomPerWheelNotch, notches));
  event->accept();
}

void RegionEditor::Hover(const QPointF& position)
{
  const RegionLayout& layout = this->picture.layout;
  this->picture.reading.clear();
  if (layout.plot.contains(position) && this->picture.histogram)
  {
    const double value = layout.ToValue(position.x());
    const double gradient = layout.ToGradient(position.y());
    const QLocale locale;
    this->picture.reading =
      tr("%1 %2, gradient %3 per mm: %4 voxels")
        .arg(locale.toString(value, 'f', layout.values.Decimals()), this->picture.unit,
          locale.toString(gradient, 'f', layout.gradients.Decimals()),
          locale.toString(qlonglong(this->picture.histogram->CountAt(value, gradient))));
  }
  const LookRegion* const selected = this->Selected();
  const bool onHandle = selected && layout.HandleAt(*selected, position);
  this->setCursor(onHandle ? Qt::SizeAllCursor
      : layout.RegionAt(this->picture.regions, position, this->picture.selected)
      ? Qt::OpenHandCursor
      : Qt::ArrowCursor);
  this->update();
}

void RegionEditor::leaveEvent(QEvent*)
{
  this->picture.reading.clear();
  this->update();
}

}
