#include "Viewer/View/ViewLayout.h"

#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace varimarch
{

ViewLayout::ViewLayout(
  QWidget* volume, const std::vector<QWidget*>& slices, QWidget* bar, QWidget* parent)
  : QWidget(parent)
  , volume(volume)
  , slices(slices)
  , columns(new QSplitter(Qt::Horizontal))
  , left(new QSplitter(Qt::Vertical))
  , right(new QSplitter(Qt::Vertical))
  , rightColumn(new QWidget)
{
  const auto columnOf = [](QWidget* owner)
  {
    auto* const column = new QVBoxLayout(owner);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    return column;
  };
  QVBoxLayout* const column = columnOf(this->rightColumn);
  column->addWidget(this->right, 1);
  column->addWidget(bar);
  this->left->addWidget(volume);
  this->columns->addWidget(this->left);
  this->columns->addWidget(this->rightColumn);
  columnOf(this)->addWidget(this->columns);
  this->Arrange(Arrangement::VolumeLarge);
}

// The widget of the volume never moves, because it would lose its graphics context.
void ViewLayout::Arrange(Arrangement newArrangement)
{
  this->arrangement = newArrangement;
  const bool isEqual = newArrangement == Arrangement::Equal;
  for (QWidget* const slice : this->slices)
  {
    (isEqual && slice == this->slices.back() ? this->left : this->right)->addWidget(slice);
  }
  constexpr int Any = 1000; // splitters share their room in these proportions
  this->left->setSizes({ Any, Any });
  this->right->setSizes({ Any, Any, Any });
  this->columns->setSizes(isEqual ? QList<int>{ Any, Any } : QList<int>{ 720, 280 });
  this->columns->setStretchFactor(0, isEqual ? 1 : 3);
  this->columns->setStretchFactor(1, 1);
  this->ShowAlone(nullptr);
}

void ViewLayout::Toggle(QWidget* view)
{
  this->ShowAlone(this->alone ? nullptr : view);
}

void ViewLayout::ShowAlone(QWidget* view)
{
  this->alone = view;
  this->ShowParts();
  if (view)
  {
    view->setFocus();
  }
  emit this->Changed();
}

void ViewLayout::ShowSlices(bool shown)
{
  this->hasSlices = shown;
  this->ShowAlone(nullptr);
}

void ViewLayout::ShowParts()
{
  const auto isShown = [this](QWidget* view)
  { return this->alone ? view == this->alone : view == this->volume || this->hasSlices; };
  this->volume->setVisible(isShown(this->volume));
  for (QWidget* const slice : this->slices)
  {
    slice->setVisible(isShown(slice));
  }
  const auto holdsShown = [&](const QSplitter* splitter)
  {
    return std::any_of(this->slices.begin(), this->slices.end(),
      [&](QWidget* slice) { return slice->parentWidget() == splitter && isShown(slice); });
  };
  this->left->setVisible(isShown(this->volume) || holdsShown(this->left));
  this->rightColumn->setVisible(holdsShown(this->right));
}

}
