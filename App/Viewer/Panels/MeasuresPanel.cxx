#include "Viewer/Panels/MeasuresPanel.h"

#include "Scene/Files/OutputFile.h"
#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Model/WorldVector.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/Reports/ScanReport.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <exception>

namespace varimarch
{

MeasuresPanel::MeasuresPanel(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , table(new QTableWidget(0, 2))
  , goTo(new QPushButton(tr("Go to")))
  , remove(new QPushButton(tr("Remove")))
  , removeAll(new QPushButton(tr("Remove all")))
  , save(new QPushButton(tr("Save…")))
{
  auto* const hint = new QLabel(
    tr("Choose a measurement above, then drag in the volume or in a slice. Points can be dragged "
       "later. Double-click a name to change it, or a value to go there."));
  hint->setWordWrap(true);
  this->table->setAccessibleName(tr("Measurements"));
  this->table->setTabKeyNavigation(false); // Tab leads out of it
  this->table->setHorizontalHeaderLabels({ tr("Name"), tr("Value") });
  this->table->horizontalHeader()->setStretchLastSection(true);
  this->table->verticalHeader()->hide();
  this->table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  this->table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->table->setSelectionMode(QAbstractItemView::SingleSelection);
  auto* const buttons = new QGridLayout;
  buttons->addWidget(this->goTo, 0, 0);
  buttons->addWidget(this->save, 0, 1);
  buttons->addWidget(this->remove, 1, 0);
  buttons->addWidget(this->removeAll, 1, 1);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(hint);
  layout->addWidget(this->table, 1);
  layout->addLayout(buttons);
  connect(this->table, &QTableWidget::itemChanged, this, &MeasuresPanel::Change);
  connect(this->table, &QTableWidget::cellDoubleClicked, this,
    [this](int, int column)
    {
      if (column == 1)
      {
        this->GoToSelected();
      }
    });
  connect(this->goTo, &QPushButton::clicked, this, &MeasuresPanel::GoToSelected);
  connect(this->remove, &QPushButton::clicked, this, &MeasuresPanel::RemoveSelected);
  connect(this->removeAll, &QPushButton::clicked, this, &MeasuresPanel::RemoveAll);
  this->save->setObjectName("save");
  connect(this->save, &QPushButton::clicked, this, &MeasuresPanel::Save);
  connect(model, &SceneModel::Changed, this, &MeasuresPanel::Show);
  this->setEnabled(false);
}

void MeasuresPanel::Show(ScenePart part)
{
  const Scene& scene = this->model->CurrentScene();
  if (part == ScenePart::Voxels || part == ScenePart::Overlays)
  {
    this->ShowValues();
  }
  if (part != ScenePart::Volume && part != ScenePart::Measures)
  {
    return;
  }
  this->setEnabled(true);
  const QSignalBlocker quiet(this->table);
  const int row = this->table->currentRow();
  const int rowsBefore = this->table->rowCount();
  const MeasureTexts& texts = this->model->Texts();
  this->table->setRowCount(0);
  for (int i = 0; i < texts.values.size(); ++i)
  {
    this->AddRow(scene.measures[i], texts.values[i]);
  }
  const int rows = this->table->rowCount();
  const bool isNew = rows > rowsBefore;
  this->table->setCurrentCell(row >= 0 && row < rows && !isNew ? row : rows - 1, 0);
  for (QPushButton* const button : { this->goTo, this->remove, this->removeAll, this->save })
  {
    button->setEnabled(rows > 0);
  }
}

// The rows stay, since the user may be typing a name while times are played.
void MeasuresPanel::ShowValues()
{
  const QSignalBlocker quiet(this->table);
  const QStringList& values = this->model->Texts().values;
  for (int row = 0; row < this->table->rowCount(); ++row)
  {
    if (!TraitsOf(this->model->CurrentScene().measures[row].kind).hasWords)
    {
      this->table->item(row, 1)->setText(values[row]);
    }
  }
}

void MeasuresPanel::AddRow(const Measure& measure, const QString& text)
{
  const int row = this->table->rowCount();
  this->table->insertRow(row);
  const QString kind = TitleOf(measure.kind);
  auto* const name =
    new QTableWidgetItem(measure.name.empty() ? kind : QString::fromStdString(measure.name));
  name->setFlags(name->flags() | Qt::ItemIsUserCheckable);
  name->setCheckState(measure.visible ? Qt::Checked : Qt::Unchecked);
  name->setToolTip(tr("%1; the box shows or hides it").arg(kind));
  this->table->setItem(row, 0, name);
  const bool hasWords = TraitsOf(measure.kind).hasWords;
  auto* const value = new QTableWidgetItem(hasWords ? kind : text);
  value->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
  this->table->setItem(row, 1, value);
}

// The name and the box before it change apart from each other.
void MeasuresPanel::Change(QTableWidgetItem* item)
{
  const int row = item->row();
  const Measure& before = this->model->CurrentScene().measures[row];
  const bool visible = item->checkState() == Qt::Checked;
  const std::string name = item->text().trimmed().toStdString();
  if (visible != before.visible)
  {
    this->model->Edit(ScenePart::Measures,
      visible ? tr("show a measurement") : tr("hide a measurement"),
      [&](Scene& scene) { scene.measures[row].visible = visible; });
  }
  else
  {
    this->model->Edit(
      ScenePart::Measures, tr("rename"), [&](Scene& scene) { scene.measures[row].name = name; });
  }
}

void MeasuresPanel::GoToSelected()
{
  const glm::dvec3 middle =
    MiddleOf(this->model->CurrentScene().measures[this->table->currentRow()]);
  this->model->Edit(ScenePart::Slices, tr("go to a measurement"),
    [&](Scene& scene) { scene.slices.crosshairMm = NumbersOf(middle); });
}

void MeasuresPanel::RemoveSelected()
{
  const int row = this->table->currentRow();
  this->model->Edit(ScenePart::Measures, tr("remove a measurement"),
    [&](Scene& scene) { scene.measures.erase(scene.measures.begin() + row); });
}

void MeasuresPanel::RemoveAll()
{
  this->model->Edit(ScenePart::Measures, tr("remove all measurements"),
    [](Scene& scene) { scene.measures.clear(); });
}

void MeasuresPanel::Save()
{
  const Scene& scene = this->model->CurrentScene();
  const int edited = this->model->EditedVolume();
  QStringList filters = { tr("Table (*.csv)") };
  const bool isDicom = MeasureReport::IsPossible(scene, *this->model->CurrentStudy(), edited);
  if (isDicom)
  {
    filters.append(tr("DICOM structured report (*.dcm)"));
  }
  const QString path = ChosenFileToSave(this, tr("Save the measurements"), filters, "measurements");
  if (path.isEmpty())
  {
    return;
  }
  try
  {
    const WaitCursor waiting;
    const auto study = ShownStudy(*this->model);
    if (isDicom && path.endsWith(".dcm", Qt::CaseInsensitive))
    {
      MeasureReport(scene, *study, edited).Write(path.toStdString(), [](double) { return true; });
    }
    else
    {
      WriteFileWhole(
        path.toStdString(), CsvOf(scene.measures, study->volume, VisibleOverlays(scene, *study)));
    }
    emit this->Saved(path);
  }
  catch (const std::exception& problem)
  {
    QMessageBox::warning(this, tr("Cannot save"), QString::fromStdString(problem.what()));
  }
}

KeyImagesBox::KeyImagesBox(SceneModel* model, QWidget* parent)
  : QGroupBox(tr("Key images"), parent)
  , model(model)
  , list(new QListWidget)
  , goTo(new QPushButton(tr("Go to")))
  , remove(new QPushButton(tr("Remove")))
{
  this->list->setAccessibleName(tr("Key images"));
  this->list->setToolTip(tr("Tools, Mark a key image adds the view that was clicked last. "
                            "Reports show all of them."));
  this->list->setEditTriggers(QAbstractItemView::EditKeyPressed);
  auto* const buttons = new QHBoxLayout;
  buttons->addWidget(this->goTo);
  buttons->addWidget(this->remove);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(this->list);
  layout->addLayout(buttons);
  connect(this->list, &QListWidget::itemChanged, this, &KeyImagesBox::Rename);
  connect(this->list, &QListWidget::itemDoubleClicked, this, &KeyImagesBox::GoToCurrent);
  connect(this->goTo, &QPushButton::clicked, this, &KeyImagesBox::GoToCurrent);
  connect(this->remove, &QPushButton::clicked, this, &KeyImagesBox::RemoveCurrent);
  connect(model, &SceneModel::Changed, this, &KeyImagesBox::Show);
}

void KeyImagesBox::Mark(KeyView view)
{
  const Scene& now = this->model->CurrentScene();
  if (this->model->CurrentStudy() && now.keyImages.size() < MostKeyImages)
  {
    this->model->Edit(ScenePart::KeyImages, tr("mark a key image"),
      [&](Scene& scene) {
        scene.keyImages.push_back({ view, {}, now.slices, now.camera, this->ShownTime() });
      });
  }
}

std::optional<int> KeyImagesBox::ShownTime() const
{
  const LoadedTimes& times = this->model->CurrentStudy()->volume.times;
  return times.AreSeveral() ? std::optional(times.current) : std::nullopt;
}

void KeyImagesBox::Show(ScenePart part)
{
  if (part != ScenePart::Volume && part != ScenePart::KeyImages)
  {
    return;
  }
  const QSignalBlocker quiet(this->list);
  const int row = this->list->currentRow();
  const std::vector<KeyImage>& images = this->model->CurrentScene().keyImages;
  const int countBefore = this->list->count();
  this->list->clear();
  for (const KeyImage& image : images)
  {
    auto* const item = new QListWidgetItem(TitleOf(image), this->list);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setToolTip(TimeTextOf(image, this->model->CurrentStudy()->volume.times));
  }
  const int last = int(images.size()) - 1;
  this->list->setCurrentRow(last >= countBefore ? last : std::min(row, last));
  this->goTo->setEnabled(!images.empty());
  this->remove->setEnabled(!images.empty());
}

void KeyImagesBox::Rename(QListWidgetItem* item)
{
  const int row = this->list->row(item);
  const std::string name = item->text().trimmed().toStdString();
  this->model->Edit(
    ScenePart::KeyImages, tr("rename"), [&](Scene& scene) { scene.keyImages[row].name = name; });
}

void KeyImagesBox::GoToCurrent()
{
  const KeyImage image = this->model->CurrentScene().keyImages[this->list->currentRow()];
  const bool isOfVolume = image.view == KeyView::Volume;
  const bool hasTime = IsAtTime(image, this->model->CurrentStudy()->volume.times);
  std::vector<ScenePart> parts = { isOfVolume ? ScenePart::Camera : ScenePart::Slices };
  if (hasTime)
  {
    parts.push_back(ScenePart::Time);
  }
  this->model->EditParts(parts, tr("go to a key image"),
    [&](Scene& scene)
    {
      isOfVolume ? void(scene.camera = image.camera) : void(scene.slices = image.slices);
      if (hasTime)
      {
        std::get<FileSource>(scene.volume).time = *image.time;
      }
    });
}

void KeyImagesBox::RemoveCurrent()
{
  const int row = this->list->currentRow();
  this->model->Edit(ScenePart::KeyImages, tr("remove a key image"),
    [&](Scene& scene) { scene.keyImages.erase(scene.keyImages.begin() + row); });
}

}
