#include "Viewer/Panels/SegmentEditingBox.h"

#include "Scene/Segments.h"

#include <QButtonGroup>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace varimarch
{

namespace
{

constexpr double DenseBoneHu = 200.0;
constexpr double PercentOfBright = 90.0; // where the values have no unit

// Four widgets fit beside each other in a narrow panel.
void MakeNarrow(QWidget* widget)
{
  constexpr int NarrowestPixels = 66;
  widget->setMinimumWidth(NarrowestPixels);
  widget->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

}

SegmentEditingBox::SegmentEditingBox(SceneModel* model, SegmentEditor* editor, QWidget* parent)
  : QGroupBox(tr("Draw segments"), parent)
  , model(model)
  , editor(editor)
  , hint(new QLabel)
  , edits(new QWidget)
{
  this->hint->setWordWrap(true);
  this->hint->setObjectName("drawHint");
  QPushButton* const added = this->Button("newSegment", tr("New segment"));
  connect(added, &QPushButton::clicked, this,
    [this]
    {
      const auto& labels = this->model->EditedLabels();
      const std::size_t count = labels ? labels->segments.size() : 0;
      if (count < MostSegments)
      {
        this->model->AddSegment(tr("Segment %1").arg(count + 1), tr("new segment"));
      }
    });
  auto* const grid = new QGridLayout(this->edits);
  grid->setContentsMargins(0, 0, 0, 0);
  this->MakeTools(grid);
  this->MakeNumbers(grid);
  this->MakeActions(grid);
  this->working = this->MakeWorking();
  auto* const column = new QVBoxLayout(this);
  column->addWidget(added);
  column->addWidget(this->edits);
  column->addWidget(this->working);
  column->addWidget(this->hint);
  connect(editor, &SegmentEditor::Unchanged, this,
    [this]
    {
      this->hint->setText(tr("Nothing has changed: the value there is outside the range, or "
                             "no voxels are left."));
    });
  connect(editor, &SegmentEditor::Failed, this->hint, &QLabel::setText);
  connect(editor, &SegmentEditor::WorkingChanged, added, &QWidget::setDisabled);
  connect(model, &SceneModel::Changed, this, &SegmentEditingBox::Show);
  this->setEnabled(false);
}

QWidget* SegmentEditingBox::MakeWorking()
{
  auto* const row = new QWidget;
  auto* const progress = new QProgressBar;
  progress->setRange(0, 0); // nobody knows how far a region reaches
  progress->setAccessibleName(tr("Working on the segment"));
  QPushButton* const cancel = this->Button("cancelSegmentWork", tr("Cancel"));
  auto* const layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(progress, 1);
  layout->addWidget(cancel);
  connect(cancel, &QPushButton::clicked, this->editor, &SegmentEditor::Cancel);
  connect(this->editor, &SegmentEditor::WorkingChanged, row, &QWidget::setVisible);
  connect(this->editor, &SegmentEditor::WorkingChanged, this->edits, &QWidget::setDisabled);
  row->hide();
  return row;
}

QPushButton* SegmentEditingBox::Button(const char* name, const QString& text)
{
  auto* const button = new QPushButton(text);
  button->setObjectName(name);
  return button;
}

QDoubleSpinBox* SegmentEditingBox::Number(const char* name, const QString& meaning, double value)
{
  auto* const number = new QDoubleSpinBox;
  number->setObjectName(name);
  number->setAccessibleName(meaning);
  number->setToolTip(meaning);
  number->setRange(0.1, 1000.0);
  number->setDecimals(1);
  MakeNarrow(number);
  number->setValue(value);
  return number;
}

void SegmentEditingBox::MakeTools(QGridLayout* grid)
{
  this->tools = new QButtonGroup(this);
  const std::pair<const char*, QString> buttons[] = { { "toolNone", tr("Off") },
    { "toolRegion", tr("Region") }, { "toolPaint", tr("Paint") }, { "toolErase", tr("Erase") } };
  for (int i = 0; i < 4; ++i) // in the order of SegmentTool
  {
    QPushButton* const button = this->Button(buttons[i].first, buttons[i].second);
    button->setCheckable(true);
    MakeNarrow(button);
    button->setChecked(i == 0);
    this->tools->addButton(button, i);
    grid->addWidget(button, i / 2, i % 2 * 2, 1, 2);
  }
  connect(this->tools, &QButtonGroup::idClicked, this,
    [this](int id)
    {
      const QString hints[] = { QString(),
        tr("Click in a slice or in the volume: the connected voxels of these values are added."),
        tr("Drag in a slice to paint."), tr("Drag in a slice to erase.") };
      this->hint->setText(hints[id]);
      this->editor->SetTool(SegmentTool(id));
    });
}

void SegmentEditingBox::MakeNumbers(QGridLayout* grid)
{
  this->smallest = this->Number("smallestValue", tr("Smallest value of a region"), 0.0);
  this->largest = this->Number("largestValue", tr("Largest value of a region"), 0.0);
  this->radius = this->Number("brushRadius", tr("Radius of the brush"), this->editor->RadiusMm());
  this->radius->setSuffix(tr(" mm"));
  grid->addWidget(new QLabel(tr("Values")), 2, 0, 1, 4);
  grid->addWidget(this->smallest, 3, 0, 1, 2);
  grid->addWidget(this->largest, 3, 2, 1, 2);
  grid->addWidget(new QLabel(tr("Radius")), 4, 0, 1, 2);
  grid->addWidget(this->radius, 4, 2, 1, 2);
  for (QDoubleSpinBox* const bound : { this->smallest, this->largest })
  {
    bound->setRange(-1e9, 1e9);
    connect(bound, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
      &SegmentEditingBox::TakeRange);
  }
  connect(this->radius, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
    [this](double mm) { this->editor->SetRadiusMm(mm); });
}

void SegmentEditingBox::MakeActions(QGridLayout* grid)
{
  QPushButton* const largestOnly = this->Button("keepLargest", tr("Keep the largest part"));
  QPushButton* const noSmall = this->Button("removeSmall", tr("Remove parts below"));
  QPushButton* const smooth = this->Button("smooth", tr("Smooth"));
  QPushButton* const save = this->Button("saveSegmentation", tr("Save the segmentation…"));
  this->island = this->Number("islandVolume", tr("Volume of the smallest part that is kept"), 1.0);
  this->island->setSuffix(tr(" ml"));
  this->deviation = this->Number("smoothing", tr("Width of the smoothing"), 1.0);
  this->deviation->setSuffix(tr(" mm"));
  grid->addWidget(largestOnly, 5, 0, 1, 4);
  grid->addWidget(noSmall, 6, 0, 1, 2);
  grid->addWidget(this->island, 6, 2, 1, 2);
  grid->addWidget(smooth, 7, 0, 1, 2);
  grid->addWidget(this->deviation, 7, 2, 1, 2);
  grid->addWidget(save, 8, 0, 1, 4);
  connect(largestOnly, &QPushButton::clicked, this->editor, &SegmentEditor::KeepLargestIsland);
  connect(noSmall, &QPushButton::clicked, this,
    [this] { this->editor->RemoveSmallIslands(this->island->value()); });
  connect(smooth, &QPushButton::clicked, this,
    [this] { this->editor->Smooth(this->deviation->value()); });
  connect(save, &QPushButton::clicked, this, &SegmentEditingBox::SaveWanted);
}

void SegmentEditingBox::Show(ScenePart part)
{
  if (!IsOtherLookVolume(part) && part != ScenePart::Labels && part != ScenePart::Segments)
  {
    return;
  }
  const auto& labels = this->model->EditedLabels();
  this->setEnabled(true);
  this->edits->setVisible(labels && !labels->segments.empty());
  if (IsOtherLookVolume(part))
  {
    const Study& study = *this->model->EditedStudy();
    const QSignalBlocker quiet[] = { QSignalBlocker(this->smallest),
      QSignalBlocker(this->largest) };
    this->smallest->setValue(
      study.volume.modality == "CT" ? DenseBoneHu : study.statistics.Percentile(PercentOfBright));
    this->largest->setValue(study.statistics.Largest());
    this->TakeRange();
  }
}

void SegmentEditingBox::TakeRange()
{
  this->editor->SetRange({ this->smallest->value(), this->largest->value() });
}

}
