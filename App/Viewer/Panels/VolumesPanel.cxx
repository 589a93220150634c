#include "Viewer/Panels/VolumesPanel.h"

#include "Registration/RigidRegistration.h"
#include "Scene/Model/Scene.h"
#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Panels/NumberSlider.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace varimarch
{

namespace
{

constexpr double FarthestMm = 5000.0;
constexpr int NarrowestNumber = 76; // pixels

QString NameOfSource(const VolumeSource& source)
{
  const auto* const file = std::get_if<FileSource>(&source);
  return file ? QFileInfo(QString::fromStdString(file->path)).fileName()
              : VolumesPanel::tr("computed volume");
}

QDoubleSpinBox* NewNumber(const QString& name, double largest, const QString& suffix)
{
  auto* const box = new QDoubleSpinBox;
  box->setRange(-largest, largest);
  box->setDecimals(1);
  box->setSuffix(suffix);
  box->setAccessibleName(name);
  box->setToolTip(name);
  box->setKeyboardTracking(false);
  // Three of them fit beside each other in a narrow panel.
  box->setMinimumWidth(NarrowestNumber);
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return box;
}

// A text that is being typed stays, unless another number is shown.
void ShowNumber(QDoubleSpinBox* box, double number)
{
  const QSignalBlocker quiet(box);
  if (box->textFromValue(number) != box->textFromValue(box->value()))
  {
    box->setValue(number);
  }
}

}

QString VolumesPanel::TitleOf(const Scene& scene, int volume)
{
  const std::string name = volume == 0 ? std::string() : scene.overlays[volume - 1].name;
  return name.empty() ? NameOfSource(VolumeSourceOf(scene, volume)) : QString::fromStdString(name);
}

VolumesPanel::VolumesPanel(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , list(new QListWidget)
  , note(new QLabel(tr("Several volumes are drawn together as composites.")))
{
  this->note->setWordWrap(true);
  this->note->setObjectName("note");
  this->list->setObjectName("volumes");
  this->list->setAccessibleName(tr("Volumes"));
  this->list->setMinimumHeight(90);
  this->list->setToolTip(tr("The look panels change the selected volume"));
  auto* const column = new QVBoxLayout(this);
  column->addWidget(this->list, 1);
  column->addWidget(this->MakeButtons());
  column->addWidget(this->note);
  column->addWidget(this->MakeAppearance());
  column->addWidget(this->MakePlace());
  connect(this->list, &QListWidget::itemChanged, this, &VolumesPanel::TakeItem);
  connect(this->list, &QListWidget::currentRowChanged, this,
    [this](int row)
    {
      if (row >= 0)
      {
        this->model->SetEditedVolume(row);
      }
    });
  connect(model, &SceneModel::Changed, this, &VolumesPanel::Show);
  this->setEnabled(false);
}

QWidget* VolumesPanel::MakeButtons()
{
  auto* const buttons = new QWidget;
  auto* const grid = new QGridLayout(buttons);
  grid->setContentsMargins(0, 0, 0, 0);
  const auto button = [&](const char* name, const QString& text, int row, int column, int span = 1)
  {
    auto* const added = new QPushButton(text);
    added->setObjectName(name);
    grid->addWidget(added, row, column, 1, span);
    return added;
  };
  this->add = button("addScan", tr("Add a scan…"), 0, 0, 3);
  this->up = button("up", tr("Up"), 1, 0);
  this->down = button("down", tr("Down"), 1, 1);
  this->remove = button("remove", tr("Remove"), 1, 2);
  connect(this->add, &QPushButton::clicked, this, &VolumesPanel::AddWanted);
  connect(this->up, &QPushButton::clicked, this, [this] { this->Move(-1); });
  connect(this->down, &QPushButton::clicked, this, [this] { this->Move(1); });
  connect(this->remove, &QPushButton::clicked, this, &VolumesPanel::Remove);
  return buttons;
}

QWidget* VolumesPanel::MakeAppearance()
{
  this->appearance = new QWidget;
  this->opacity = new NumberSlider(0.0, 1.0, NumberSlider::Scale::Linear);
  this->opacity->setAccessibleName(tr("Opacity of the volume"));
  this->colors = new QComboBox;
  this->colors->setObjectName("sliceColors");
  this->colors->addItems({ tr("Grey"), tr("Hot"), tr("Green") }); // in the order of SliceColors
  auto* const form = new QFormLayout(this->appearance);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("Opacity"), this->opacity);
  form->addRow(tr("In slices"), this->colors);
  connect(this->opacity, &NumberSlider::Edited, this,
    [this](double number, int gesture)
    {
      this->Edit(
        tr("opacity of a volume"), [=](OverlaidVolume& overlay) { overlay.opacity = number; },
        gesture);
    });
  connect(this->colors, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index)
    {
      this->Edit(tr("colours in slices"),
        [=](OverlaidVolume& overlay) { overlay.sliceColors = SliceColors(index); });
    });
  return this->appearance;
}

QWidget* VolumesPanel::MakePlace()
{
  this->place = new QGroupBox(tr("Place beside its patient coordinates"));
  auto* const grid = new QGridLayout(this->place);
  const QString moveNames[] = { tr("Move to the patient's left"), tr("Move to the back"),
    tr("Move to the head") };
  const QString turnNames[] = { tr("Turn about the axis to the left"),
    tr("Turn about the axis to the back"), tr("Turn about the axis to the head") };
  constexpr int Columns = 6;
  grid->addWidget(new QLabel(tr("Move to the left, to the back, to the head")), 0, 0, 1, Columns);
  grid->addWidget(new QLabel(tr("Turn about these axes")), 2, 0, 1, Columns);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->moves[axis] = NewNumber(moveNames[axis], FarthestMm, tr(" mm"));
    this->turns[axis] = NewNumber(turnNames[axis], 180.0, tr("°"));
    this->moves[axis]->setObjectName(QStringLiteral("move%1").arg(axis));
    this->turns[axis]->setObjectName(QStringLiteral("turn%1").arg(axis));
    grid->addWidget(this->moves[axis], 1, 2 * axis, 1, 2);
    grid->addWidget(this->turns[axis], 3, 2 * axis, 1, 2);
    this->ConnectPlace(this->moves[axis], &Placement::moveMm, axis);
    this->ConnectPlace(this->turns[axis], &Placement::turnDegrees, axis);
  }
  auto* const reset = new QPushButton(tr("Patient coordinates"));
  reset->setObjectName("resetPlace");
  connect(reset, &QPushButton::clicked, this,
    [this]
    {
      this->Edit(
        tr("patient coordinates"), [](OverlaidVolume& overlay) { overlay.placement = {}; });
    });
  auto* const fit = new QPushButton(tr("Register"));
  fit->setObjectName("register");
  fit->setToolTip(tr("Finds the place where the volume fits the first one best, as a rigid body"));
  connect(fit, &QPushButton::clicked, this, [this] { this->Register(this->Selected()); });
  grid->addWidget(reset, 4, 0, 1, 4);
  grid->addWidget(fit, 4, 4, 1, 2);
  return this->place;
}

int VolumesPanel::Selected() const
{
  return this->list->currentRow() - 1;
}

void VolumesPanel::Show(ScenePart part)
{
  if (part == ScenePart::Volume || part == ScenePart::Overlays)
  {
    this->setEnabled(true);
    this->ShowRows();
  }
  // The rows stay while one of them is being chosen, whose box may be what the user clicks.
  else if (part == ScenePart::EditedVolume)
  {
    const QSignalBlocker quiet(this->list);
    this->list->setCurrentRow(this->model->EditedVolume());
  }
  else
  {
    return;
  }
  this->ShowSelected();
}

void VolumesPanel::ShowRows()
{
  const Scene& scene = this->model->CurrentScene();
  const QSignalBlocker quiet(this->list);
  while (this->list->count() > VolumeCount(scene))
  {
    delete this->list->takeItem(this->list->count() - 1);
  }
  const QString modality = QString::fromStdString(this->model->CurrentStudy()->volume.modality);
  this->ShowRow(0, (modality + ' ' + TitleOf(scene, 0)).trimmed());
  for (int volume = 1; volume < VolumeCount(scene); ++volume)
  {
    this->ShowRow(volume, TitleOf(scene, volume));
    QListWidgetItem* const item = this->list->item(volume);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
    item->setCheckState(scene.overlays[volume - 1].visible ? Qt::Checked : Qt::Unchecked);
  }
  this->list->setCurrentRow(this->model->EditedVolume());
}

// Rows that stay keep the name that is being typed in them.
void VolumesPanel::ShowRow(int volume, const QString& title)
{
  if (volume == this->list->count())
  {
    this->list->addItem(title);
  }
  if (this->list->item(volume)->text() != title)
  {
    this->list->item(volume)->setText(title);
  }
}

void VolumesPanel::ShowSelected()
{
  const Scene& scene = this->model->CurrentScene();
  const int selected = this->Selected();
  const int count = int(scene.overlays.size());
  const bool isOverlay = selected >= 0 && selected < count;
  this->note->setVisible(count > 0);
  this->add->setEnabled(count + 1 < int(MostVolumes));
  this->up->setEnabled(isOverlay && selected > 0);
  this->down->setEnabled(isOverlay && selected + 1 < count);
  this->remove->setEnabled(isOverlay);
  this->appearance->setVisible(isOverlay);
  this->place->setVisible(isOverlay);
  if (!isOverlay)
  {
    return;
  }
  const OverlaidVolume& overlay = scene.overlays[selected];
  this->opacity->SetNumber(overlay.opacity);
  this->colors->setCurrentIndex(int(overlay.sliceColors));
  for (int axis = 0; axis < 3; ++axis)
  {
    ShowNumber(this->moves[axis], overlay.placement.moveMm[axis]);
    ShowNumber(this->turns[axis], overlay.placement.turnDegrees[axis]);
  }
}

// The user renamed a volume, or showed or hid it.
void VolumesPanel::TakeItem(const QListWidgetItem* item)
{
  const int changed = this->list->row(item) - 1;
  if (changed < 0)
  {
    return;
  }
  const bool isShown = item->checkState() == Qt::Checked;
  const std::string name = item->text().trimmed().toStdString();
  const OverlaidVolume& before = this->model->CurrentScene().overlays[changed];
  if (isShown != before.visible || name != before.name)
  {
    const QString step = isShown == before.visible ? tr("rename")
      : isShown                                    ? tr("show a volume")
                                                   : tr("hide a volume");
    this->model->Edit(ScenePart::Overlays, step,
      [&](Scene& scene)
      {
        scene.overlays[changed].visible = isShown;
        scene.overlays[changed].name = name;
      });
  }
  this->ShowRows(); // the title may be another than the text that was typed
}

// The other numbers of a place keep the digits that the panel does not show.
void VolumesPanel::ConnectPlace(
  const QDoubleSpinBox* box, std::array<double, 3> Placement::*part, int axis)
{
  connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
    [=](double number)
    {
      this->Edit(tr("move a volume"),
        [=](OverlaidVolume& overlay) { (overlay.placement.*part)[axis] = number; });
    });
}

void VolumesPanel::Move(int step)
{
  const int from = this->Selected();
  this->model->MoveOverlay(from, from + step, tr("order of volumes"));
}

void VolumesPanel::Remove()
{
  this->model->RemoveOverlay(this->Selected(), tr("remove a volume"));
}

void VolumesPanel::Edit(
  const QString& step, const std::function<void(OverlaidVolume&)>& change, int gesture)
{
  this->model->Edit(
    ScenePart::Overlays, step,
    [&, selected = this->Selected()](Scene& scene) { change(scene.overlays[selected]); }, gesture);
}

// The dialog is modal to the window, so only a scan that was being loaded before can change the
// volumes meanwhile. A cancelled QProgressDialog only hides, and the next progress shows it again;
// so it is deleted.
void VolumesPanel::Register(int overlay)
{
  auto* const waiting =
    new QProgressDialog(tr("Registering"), tr("Cancel"), 0, 100, this->window());
  waiting->setObjectName("registering");
  waiting->setWindowModality(Qt::WindowModal);
  waiting->setAutoClose(false);
  waiting->setAutoReset(false);
  waiting->setMinimumDuration(0);
  waiting->setValue(0);
  auto* const task = new BackgroundTask(waiting);
  connect(waiting, &QProgressDialog::canceled, waiting,
    [waiting, task]
    {
      task->Cancel();
      waiting->deleteLater();
    });
  connect(task, &BackgroundTask::Progress, waiting,
    [waiting](double part) { waiting->setValue(int(100.0 * part)); });
  connect(task, &BackgroundTask::Failed, this,
    [this, waiting](const QString& reason)
    {
      waiting->close();
      QMessageBox::warning(this->window(), tr("Cannot register"), reason);
    });
  const auto study = this->model->CurrentStudy();
  const Placement start = this->model->CurrentScene().overlays[overlay].placement;
  task->Start([=, moving = study->overlays[overlay]](const TaskProgress& progress)
    { return RegisteredPlacement(study->volume.image, moving->volume.image, start, progress); },
    [=](const Placement& found)
    {
      waiting->close();
      if (this->model->CurrentStudy() == study)
      {
        this->model->Edit(ScenePart::Overlays, tr("register a volume"),
          [&](Scene& scene) { scene.overlays[overlay].placement = found; });
        emit this->Registered();
      }
    });
}

}
