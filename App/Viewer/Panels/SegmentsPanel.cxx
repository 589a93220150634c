#include "Viewer/Panels/SegmentsPanel.h"

#include "Scene/Files/OutputFile.h"
#include "Scene/Model/Scene.h"
#include "Scene/Pipeline/ScenePipeline.h"
#include "Scene/Segments/Segments.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Panels/NumberSlider.h"
#include "Viewer/Panels/VolumesPanel.h"

#include <QButtonGroup>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <exception>

namespace varimarch
{

namespace
{

enum Column
{
  Name,
  Volume,
  Mean,
  Smallest,
  Largest,
  ColumnCount,
};

constexpr double Mm3PerMl = 1000.0;

QColor ColorOf(const Segment& segment)
{
  return QColor::fromRgbF(segment.rgb.r, segment.rgb.g, segment.rgb.b);
}

QIcon Swatch(const QColor& color)
{
  QPixmap swatch(14, 14);
  swatch.fill(color);
  QIcon icon(swatch);
  icon.addPixmap(swatch, QIcon::Selected); // selected rows would tint it
  return icon;
}

}

SegmentsPanel::SegmentsPanel(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , volume(new QLabel)
  , hint(new QLabel(tr("A segmentation of this scan colours its regions: a DICOM segmentation, a "
                       "segmentation of 3D Slicer, or a label map in NRRD, NIfTI or another "
                       "format.")))
  , all(new QWidget)
  , note(new QLabel)
{
  this->volume->setWordWrap(true);
  this->volume->setObjectName("volumeOfSegments");
  this->hint->setWordWrap(true);
  this->note->setWordWrap(true);
  this->note->setObjectName("note");
  auto* const open = new QPushButton(tr("Open a segmentation…"));
  open->setObjectName("openSegmentation");
  this->MakeTable();
  auto* const column = new QVBoxLayout(this->all);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(this->note);
  column->addWidget(this->table, 1);
  column->addWidget(this->MakeControls());
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(this->volume);
  layout->addWidget(this->hint);
  layout->addWidget(open);
  layout->addWidget(this->all, 1);
  layout->addStretch();
  connect(open, &QPushButton::clicked, this, &SegmentsPanel::OpenWanted);
  connect(model, &SceneModel::Changed, this, &SegmentsPanel::Show);
  this->all->hide();
  this->setEnabled(false);
}

void SegmentsPanel::MakeTable()
{
  this->table = new QTableWidget(0, ColumnCount);
  this->table->setTabKeyNavigation(false); // Tab leads out of it
  this->table->setAccessibleName(tr("Segments"));
  this->table->verticalHeader()->hide();
  this->table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  this->table->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
  this->table->horizontalHeader()->setMinimumSectionSize(40);
  this->table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->table->setWordWrap(false);
  this->table->setMinimumHeight(120);
  connect(this->table, &QTableWidget::itemChanged, this, &SegmentsPanel::TakeItem);
  connect(this->table, &QTableWidget::itemSelectionChanged, this, &SegmentsPanel::ShowSelected);
}

QWidget* SegmentsPanel::MakeControls()
{
  auto* const controls = new QWidget;
  auto* const grid = new QGridLayout(controls);
  grid->setContentsMargins(0, 0, 0, 0);
  const auto button = [&](const char* name, const QString& text, int row, int column, int span = 1)
  {
    auto* const added = new QPushButton(text);
    added->setObjectName(name);
    grid->addWidget(added, row, column, 1, span);
    return added;
  };
  connect(button("showAll", tr("Show all"), 0, 0), &QPushButton::clicked, this,
    [this] { this->SetVisible(true); });
  connect(button("hideAll", tr("Hide all"), 0, 1), &QPushButton::clicked, this,
    [this] { this->SetVisible(false); });
  this->opacity = new NumberSlider(0.0, 1.0, NumberSlider::Scale::Linear);
  this->opacity->setAccessibleName(tr("Opacity"));
  this->opacity->setToolTip(tr("Opacity of the selected segments"));
  grid->addWidget(new QLabel(tr("Opacity")), 1, 0);
  grid->addWidget(this->opacity, 1, 1);
  connect(this->opacity, &NumberSlider::Edited, this, &SegmentsPanel::SetOpacity);
  this->color = button("color", tr("Colour…"), 2, 0);
  connect(this->color, &QPushButton::clicked, this, &SegmentsPanel::ChooseColor);
  connect(button("saveStatistics", tr("Save as CSV…"), 2, 1), &QPushButton::clicked, this,
    &SegmentsPanel::SaveStatistics);
  connect(button("closeSegmentation", tr("Close the segmentation"), 3, 0, 2), &QPushButton::clicked,
    this, [this] { this->model->CloseLabels(tr("close the segmentation")); });
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  return controls;
}

void SegmentsPanel::Show(ScenePart part)
{
  if (part == ScenePart::Look || part == ScenePart::Overlays)
  {
    this->ShowVolume();
    this->ShowNote();
    return;
  }
  if (part == ScenePart::Voxels)
  {
    const QSignalBlocker quiet(this->table);
    for (int row = 0; row < this->table->rowCount(); ++row)
    {
      this->ShowStatistics(row);
    }
    return;
  }
  if (!IsOtherLookVolume(part) && part != ScenePart::Labels && part != ScenePart::Segments)
  {
    return;
  }
  if (part == ScenePart::EditedVolume)
  {
    this->table->setRowCount(0); // a row of another volume is not selected
  }
  this->setEnabled(true);
  this->ShowVolume();
  const bool hasLabels = this->model->EditedLabels().has_value();
  this->hint->setVisible(!hasLabels);
  this->all->setVisible(hasLabels);
  this->ShowNote();
  if (!hasLabels)
  {
    this->table->setRowCount(0);
    return;
  }
  this->ShowHeader();
  this->ShowRows();
  this->ShowSelected();
}

void SegmentsPanel::ShowHeader()
{
  const bool isCt = this->model->EditedStudy()->volume.modality == "CT";
  const auto withUnit = [isCt](const QString& name)
  { return isCt ? name + '\n' + tr("HU") : name; };
  this->table->setHorizontalHeaderLabels({ tr("Segment"), tr("Volume\nml"), withUnit(tr("Mean")),
    withUnit(tr("Min")), withUnit(tr("Max")) });
}

// Keeps the items, and with them the selection; a segment that is added is selected.
void SegmentsPanel::ShowRows()
{
  const std::vector<Segment>& segments = this->model->EditedLabels()->segments;
  const QSignalBlocker quiet(this->table);
  const int rowsBefore = this->table->rowCount();
  this->table->setRowCount(int(segments.size()));
  for (int row = 0; row < this->table->rowCount(); ++row)
  {
    const Segment& segment = segments[row];
    QTableWidgetItem* const name = this->Item(row, Name);
    name->setText(QString::fromStdString(segment.name));
    name->setToolTip(name->text());
    name->setIcon(Swatch(ColorOf(segment)));
    name->setCheckState(segment.visible ? Qt::Checked : Qt::Unchecked);
    this->ShowStatistics(row);
  }
  if (this->table->rowCount() == rowsBefore + 1)
  {
    this->table->selectRow(rowsBefore);
  }
  else if (this->table->currentRow() < 0)
  {
    this->table->selectRow(0);
  }
}

void SegmentsPanel::ShowStatistics(int row)
{
  const Study& study = *this->model->EditedStudy();
  const RegionStatistics& region = study.segmentStatistics[row];
  const double ml = region.volumeMm3 / Mm3PerMl;
  // Data without units may lie between 0 and 1.
  const bool isNarrow = study.statistics.Largest() - study.statistics.Smallest() < 10.0;
  const auto valueText = [&](double value, int decimals)
  { return region.voxels > 0 ? NumberText(value, isNarrow ? 3 : decimals) : QString(); };
  const std::pair<Column, QString> texts[] = { { Column::Volume,
                                                 NumberText(ml, ml < 100.0 ? 2 : 0) },
    { Column::Mean, valueText(region.mean, 1) },
    { Column::Smallest, valueText(region.smallest, 0) },
    { Column::Largest, valueText(region.largest, 0) } };
  for (const auto& [column, text] : texts)
  {
    QTableWidgetItem* const item = this->Item(row, column);
    item->setText(study.areSegmentsCounted ? text : QStringLiteral("…"));
    item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
}

QTableWidgetItem* SegmentsPanel::Item(int row, int column)
{
  if (!this->table->item(row, column))
  {
    this->table->setItem(row, column, new QTableWidgetItem);
  }
  return this->table->item(row, column);
}

void SegmentsPanel::ShowSelected()
{
  const int row = this->table->currentRow();
  emit this->Selected(row);
  const bool isSelected = row >= 0 && this->table->selectionModel()->hasSelection();
  this->opacity->setEnabled(isSelected);
  this->color->setEnabled(isSelected);
  if (isSelected)
  {
    this->opacity->SetNumber(this->model->EditedLabels()->segments[row].opacity);
  }
}

void SegmentsPanel::ShowVolume()
{
  const Scene& scene = this->model->CurrentScene();
  this->volume->setText(
    tr("Segments of %1").arg(VolumesPanel::TitleOf(scene, this->model->EditedVolume())));
  this->volume->setVisible(!scene.overlays.empty());
}

// Among several volumes each segmentation is drawn as one more.
void SegmentsPanel::ShowNote()
{
  const Scene& scene = this->model->CurrentScene();
  if (!scene.overlays.empty())
  {
    this->note->setText(
      tr("The volume shows at most %1 scans and segmentations together; not all fit.")
        .arg(MostVolumes));
    this->note->setVisible(!AreAllSegmentsDrawn(scene));
    return;
  }
  vtkImageData* const image = this->model->CurrentStudy()->volume.image;
  this->note->setText(image->GetNumberOfScalarComponents() == 1
      ? tr("The volume shows segments only with the blend mode Composite.")
      : tr("The volume cannot show segments, since its voxels have several values."));
  this->note->setVisible(!CanDrawLabels(MapperKind::Varimarch, scene.look.blend, image));
}

// The user renamed a segment, or showed or hid it.
void SegmentsPanel::TakeItem(const QTableWidgetItem* item)
{
  const Segment& segment = this->model->EditedLabels()->segments[item->row()];
  const bool isShown = item->checkState() == Qt::Checked;
  const std::string name = item->text().trimmed().toStdString();
  const QString step = isShown == segment.visible ? tr("rename")
    : isShown                                     ? tr("show a segment")
                                                  : tr("hide a segment");
  this->Edit(step,
    [&, changed = item->row()](Segment& edited, int row)
    {
      if (row == changed)
      {
        edited.visible = isShown;
        edited.name = name;
      }
    });
}

void SegmentsPanel::Edit(
  const QString& step, const std::function<void(Segment&, int row)>& change, int gesture)
{
  this->model->Edit(
    ScenePart::Segments, step,
    [&](Scene& scene)
    {
      auto& segments = SceneLabelsOf(scene, this->model->EditedVolume())->segments;
      for (std::size_t row = 0; row < segments.size(); ++row)
      {
        change(segments[row], int(row));
      }
    },
    gesture);
}

void SegmentsPanel::SetVisible(bool visible)
{
  this->Edit(visible ? tr("show all segments") : tr("hide all segments"),
    [visible](Segment& segment, int) { segment.visible = visible; });
}

void SegmentsPanel::SetOpacity(double number, int gesture)
{
  const QItemSelectionModel* const selection = this->table->selectionModel();
  this->Edit(
    tr("opacity of segments"),
    [=](Segment& segment, int row)
    { segment.opacity = selection->isRowSelected(row, {}) ? number : segment.opacity; },
    gesture);
}

void SegmentsPanel::ChooseColor()
{
  const int chosen = this->table->currentRow();
  const glm::dvec3 before = this->model->EditedLabels()->segments[chosen].rgb;
  const auto edit = [this, chosen, gesture = NewGesture()](const glm::dvec3& rgb)
  {
    this->Edit(
      tr("colour of a segment"),
      [&](Segment& segment, int row) { segment.rgb = row == chosen ? rgb : segment.rgb; }, gesture);
  };
  const QColorDialog* const dialog = OpenLiveColorDialog(
    QColor::fromRgbF(before.r, before.g, before.b),
    [edit](const QColor& color) {
      edit({ color.redF(), color.greenF(), color.blueF() });
    },
    this);
  connect(dialog, &QDialog::rejected, this, [edit, before] { edit(before); });
}

void SegmentsPanel::SaveStatistics()
{
  const QString path =
    ChosenFileToSave(this, tr("Save the statistics"), { tr("Table (*.csv)") }, "segments");
  if (path.isEmpty())
  {
    return;
  }
  try
  {
    this->model->CountSegments();
    WriteFileWhole(path.toStdString(),
      CsvOf(this->model->EditedLabels()->segments, this->model->EditedStudy()->segmentStatistics));
    emit this->Saved(path);
  }
  catch (const std::exception& problem)
  {
    QMessageBox::warning(this, tr("Cannot save"), QString::fromStdString(problem.what()));
  }
}

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
