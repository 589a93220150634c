#include "Viewer/Panels/PresetGallery.h"

#include "Scene/Images/OffscreenView.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Volumes/VolumeLoading.h"
#include "Viewer/Model/OwnPresets.h"
#include "Viewer/View/VtkPictures.h"

#include <QAction>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QThread>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <exception>

namespace varimarch
{

namespace
{

constexpr QSize PresetPictureSize(104, 86);
constexpr int HasPictureRole = Qt::UserRole;
constexpr int NameRole = Qt::UserRole + 1; // name of a user's preset; null for built-in ones

// The appearance of a scene as text, without names.
std::string NamelessText(const Scene& scene)
{
  Preset preset = PresetOf(scene);
  preset.look.name.clear();
  preset.look.description.clear();
  return PresetText(preset);
}

// The same after SceneModel::SetPreset.
std::string NamelessText(const SceneModel& model, const Preset& preset)
{
  Scene scene = model.EditedScene();
  if (model.EditedVolume() == 0)
  {
    TakePreset(preset, scene);
  }
  else
  {
    scene.look = preset.look;
  }
  return NamelessText(scene);
}

// Built-in presets that can show a volume, by whether they are for its kind of scan.
struct PresetGroups
{
  std::vector<std::string> suitable;
  std::vector<std::string> others;
};

PresetGroups PresetsFor(const Study& study)
{
  PresetGroups groups;
  const std::string kind = SuggestedPreset(study.volume, study.statistics).name.substr(0, 3);
  for (const std::string& name : PresetNames())
  {
    if (Suits(BuiltInPreset(name).look, study.statistics))
    {
      (name.substr(0, 3) == kind ? groups.suitable : groups.others).push_back(name);
    }
  }
  return groups;
}

QIcon EmptyIcon()
{
  QPixmap empty(PresetPictureSize);
  empty.fill(QColor(40, 40, 40));
  return empty;
}

}

PresetGallery::PresetGallery(SceneModel* model, const QString& folder, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , ownPresets(folder)
{
  this->MakeList();
  this->MakeFold();
  this->problem = new QLabel;
  this->problem->setWordWrap(true);
  this->problem->hide();
  auto* const column = new QVBoxLayout(this);
  column->addWidget(this->list, 1);
  column->addWidget(this->fold);
  column->addWidget(this->problem);
  column->addWidget(this->MakeButtons());
  this->setEnabled(false);
  connect(model, &SceneModel::Changed, this, &PresetGallery::Update);
  connect(&this->thumbnails, &PresetThumbnails::Drawn, this, &PresetGallery::ShowPicture);
}

void PresetGallery::MakeList()
{
  this->list = new QListWidget;
  this->list->setAccessibleName(tr("Presets"));
  this->list->setViewMode(QListView::IconMode);
  this->list->setIconSize(PresetPictureSize);
  this->list->setWordWrap(true);
  const int twoLines = 2 * this->list->fontMetrics().lineSpacing();
  this->list->setGridSize(PresetPictureSize + QSize(8, 8 + twoLines));
  this->list->setResizeMode(QListView::Adjust);
  this->list->setMovement(QListView::Static);
  this->list->setEditTriggers(QAbstractItemView::EditKeyPressed);
  const auto choose = [this](QListWidgetItem* item) { this->Choose(this->list->row(item)); };
  connect(this->list, &QListWidget::itemClicked, this, choose);
  connect(this->list, &QListWidget::itemActivated, this, choose);
  // The arrow keys show one look after another, and screen readers select without a click.
  connect(this->list, &QListWidget::itemSelectionChanged, this,
    [this, choose]
    {
      const QList<QListWidgetItem*> selected = this->list->selectedItems();
      if (!selected.isEmpty())
      {
        choose(selected.front());
      }
    });
  connect(this->list, &QListWidget::itemChanged, this, &PresetGallery::Rename);
  connect(this->list, &QListWidget::currentRowChanged, this,
    [this](int row) { this->remove->setEnabled(this->IsOwn(row)); });
}

void PresetGallery::MakeFold()
{
  this->fold = new QToolButton;
  this->fold->setObjectName("fold");
  this->fold->setCheckable(true);
  this->fold->setAutoRaise(true);
  this->fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  this->fold->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  this->fold->setFocusPolicy(Qt::StrongFocus);
  connect(this->fold, &QToolButton::toggled, this, [this](bool isOpen) { this->Fold(!isOpen); });
}

QWidget* PresetGallery::MakeButtons()
{
  auto* const buttons = new QWidget;
  this->keep = new QPushButton(tr("Add this look"));
  this->keep->setObjectName("keep");
  this->keep->setToolTip(tr("Adds the current look to this list"));
  this->remove = new QPushButton(tr("Remove"));
  this->remove->setObjectName("remove");
  this->remove->setToolTip(tr("Removes one of your own looks from this list"));
  this->remove->setShortcut(QKeySequence::Delete);
  this->remove->setEnabled(false);
  connect(this->keep, &QPushButton::clicked, this, &PresetGallery::Keep);
  connect(this->remove, &QPushButton::clicked, this, &PresetGallery::Remove);
  auto* const row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->keep, 1);
  row->addWidget(this->remove);
  return buttons;
}

void PresetGallery::showEvent(QShowEvent*)
{
  this->DrawPictures();
}

void PresetGallery::Update(ScenePart part)
{
  this->thumbnails.Rest();
  if (IsOtherLookVolume(part))
  {
    this->setEnabled(true);
    this->ListPresets();
  }
  const bool isOfPresets = IsOtherLookVolume(part) || part == ScenePart::Look ||
    part == ScenePart::Render || part == ScenePart::Background;
  if (isOfPresets)
  {
    this->MarkCurrent();
  }
}

void PresetGallery::ListPresets()
{
  const auto study = this->model->EditedStudy();
  this->problem->hide();
  this->presets.clear();
  this->list->clear();
  const PresetGroups groups = PresetsFor(*study);
  for (const std::string& name : groups.suitable)
  {
    this->AddBuiltIn(name);
  }
  this->firstOther = this->list->count();
  for (const std::string& name : groups.others)
  {
    this->AddBuiltIn(name);
  }
  for (const QString& name : this->ownPresets.Names())
  {
    this->AddOwn(name);
  }
  this->fold->setText(tr("For other kinds of scans (%1)").arg(groups.others.size()));
  this->Fold(!this->fold->isChecked());
}

void PresetGallery::AddBuiltIn(const std::string& name)
{
  const Preset preset = BuiltInPreset(name);
  this->AddItem(this->list->count(), PresetTitle(name),
    QString::fromStdString(preset.look.description), preset);
}

QListWidgetItem* PresetGallery::AddItem(
  int row, const QString& title, const QString& tip, const Preset& preset)
{
  const QSignalBlocker quiet(this->list);
  auto* const item = new QListWidgetItem(EmptyIcon(), title);
  item->setToolTip(tip);
  item->setData(HasPictureRole, false);
  this->list->insertItem(row, item);
  Look& look = this->presets.insert(this->presets.begin() + row, preset)->look;
  look = InUnitsOfData(look, this->model->EditedStudy()->statistics);
  return item;
}

// The folder may contain files that are not looks.
void PresetGallery::AddOwn(const QString& name)
{
  this->Attempt(
    [&]
    {
      QListWidgetItem* const item = this->AddItem(this->firstOther, name,
        tr("Your own look: F2 renames it, Delete removes it"), this->ownPresets.Read(name));
      ++this->firstOther;
      const QSignalBlocker quiet(this->list);
      item->setFlags(item->flags() | Qt::ItemIsEditable);
      item->setData(NameRole, name);
    });
}

void PresetGallery::Fold(bool isFolded)
{
  this->fold->setArrowType(isFolded ? Qt::RightArrow : Qt::DownArrow);
  for (int row = 0; row < this->list->count(); ++row)
  {
    this->list->item(row)->setHidden(isFolded && row >= this->firstOther);
  }
  this->DrawPictures();
}

// While the gallery is hidden, nothing is drawn, and nothing more comes of what was asked for
// before.
void PresetGallery::DrawPictures()
{
  if (!this->model->EditedStudy())
  {
    return;
  }
  this->drawnRows.clear();
  std::vector<Preset> wanted;
  for (int row = 0; this->isVisible() && row < this->list->count(); ++row)
  {
    const QListWidgetItem* const item = this->list->item(row);
    if (!item->isHidden() && !item->data(HasPictureRole).toBool())
    {
      this->drawnRows.push_back(row);
      wanted.push_back(this->presets[row]);
    }
  }
  this->thumbnails.Draw(this->model->EditedStudy(), std::move(wanted), PresetPictureSize);
}

void PresetGallery::ShowPicture(int index, const QImage& picture)
{
  const QSignalBlocker quiet(this->list);
  QListWidgetItem* const item = this->list->item(this->drawnRows[index]);
  QIcon icon(QPixmap::fromImage(picture));
  // The same icon for the selected state keeps Qt from tinting it.
  icon.addPixmap(QPixmap::fromImage(picture), QIcon::Selected);
  item->setIcon(icon);
  item->setData(HasPictureRole, true);
  this->list->viewport()->update();
}

void PresetGallery::MarkCurrent()
{
  const std::string text = NamelessText(this->model->EditedScene());
  const auto found = std::find_if(this->presets.begin(), this->presets.end(),
    [&](const Preset& preset) { return NamelessText(*this->model, preset) == text; });
  const int row = found == this->presets.end() ? -1 : int(found - this->presets.begin());
  this->list->setCurrentRow(row);
}

void PresetGallery::Choose(int row)
{
  // A double-click is also reported as a click; apply the preset only once.
  if (NamelessText(*this->model, this->presets[row]) != NamelessText(this->model->EditedScene()))
  {
    this->model->SetPreset(this->presets[row], tr("choose %1").arg(this->list->item(row)->text()));
  }
}

void PresetGallery::Keep()
{
  this->problem->hide();
  this->Attempt(
    [this]
    {
      this->AddOwn(this->ownPresets.Keep(PresetOf(this->model->EditedScene())));
      this->DrawPictures();
      // Let the user type over the provisional name.
      QListWidgetItem* const item = this->list->item(this->firstOther - 1);
      this->list->setCurrentItem(item);
      this->list->editItem(item);
    });
}

void PresetGallery::Rename(QListWidgetItem* item)
{
  const QString name = item->data(NameRole).toString();
  const QSignalBlocker quiet(this->list);
  this->problem->hide();
  this->Attempt(
    [&]
    {
      this->ownPresets.Rename(name, item->text());
      item->setData(NameRole, item->text());
      this->presets[this->list->row(item)].look.name = item->text().toStdString();
    });
  item->setText(item->data(NameRole).toString());
}

void PresetGallery::Remove()
{
  const QString name = this->list->currentItem()->data(NameRole).toString();
  if (QMessageBox::question(this, tr("Remove a preset"),
        tr("Remove the preset %1? This cannot be undone.").arg(name)) != QMessageBox::Yes)
  {
    return;
  }
  this->problem->hide();
  this->Attempt(
    [&]
    {
      const int row = this->list->currentRow();
      this->ownPresets.Remove(name);
      this->presets.erase(this->presets.begin() + row);
      --this->firstOther;
      this->list->setCurrentRow(-1); // Qt would select the next one
      delete this->list->takeItem(row);
      this->DrawPictures();
      this->MarkCurrent();
    });
}

bool PresetGallery::IsOwn(int row) const
{
  return row >= 0 && !this->list->item(row)->data(NameRole).isNull();
}

void PresetGallery::Attempt(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const std::exception& failure)
  {
    this->problem->setText(QString::fromStdString(failure.what()));
    this->problem->show();
  }
}

namespace
{

constexpr int CopyVoxelsPerSide = 128; ///< side of the reduced copy [voxels]
constexpr int RestMilliseconds = 500;
constexpr double ErrorTolerance = 1.0 / 32.0;
constexpr double Zoom = 1.3; // most volumes are empty in their corners

// The pictures that are wanted. The volume is a shallow copy, of which the thread only reads the
// voxels.
struct WantedThumbnails
{
  vtkSmartPointer<vtkImageData> volume;
  std::vector<Preset> presets;
  QSize pixels;
  std::shared_ptr<std::atomic<bool>> rests;
};

// Pauses if requested; returns false if the work was cancelled.
bool ShouldContinue(std::atomic<bool>& rests, const TaskProgress& progress)
{
  while (progress(-1.0) && rests.exchange(false))
  {
    QThread::msleep(RestMilliseconds);
  }
  return progress(-1.0);
}

// Draws the pictures one after the other. Runs in the thread.
void DrawThumbnails(const WantedThumbnails& wanted, const TaskProgress& progress,
  const std::function<void(int, const QImage&)>& show)
{
  // A gallery that is shown again asks for nothing if it has all pictures.
  if (wanted.presets.empty() || !ShouldContinue(*wanted.rests, progress))
  {
    return;
  }
  Scene scene;
  TakePreset(wanted.presets.front(), scene);
  scene.size = { wanted.pixels.width(), wanted.pixels.height() };
  scene.render.errorTolerance = ErrorTolerance;
  scene.camera.zoom = Zoom;
  OffscreenView view(scene, SmallCopy(wanted.volume, CopyVoxelsPerSide), MapperKind::Varimarch);
  for (int index = 0; index < int(wanted.presets.size()) && ShouldContinue(*wanted.rests, progress);
       ++index)
  {
    TakePreset(wanted.presets[index], scene);
    view.Pipeline().SetLook(scene.look);
    view.Pipeline().SetBackground(scene.background);
    view.Render();
    show(index, ImageOfBytes(view.Bytes()));
  }
}

}

// A thread that draws is never left alone. Where there is no OpenGL, the task fails, and there are
// no thumbnails; the presets can still be chosen.
PresetThumbnails::PresetThumbnails(QObject* parent)
  : QObject(parent)
{
  this->task.SetPatience(std::chrono::hours(24));
}

void PresetThumbnails::Draw(
  const std::shared_ptr<const Study>& study, std::vector<Preset> presets, QSize pixels)
{
  this->rests = std::make_shared<std::atomic<bool>>(true);
  const WantedThumbnails wanted = { vtkSmartPointer<vtkImageData>::New(), std::move(presets),
    pixels, this->rests };
  wanted.volume->ShallowCopy(study->volume.image);
  this->task.StartAfterLast(
    [this, wanted](const TaskProgress& progress, const TaskPost& post)
    {
      DrawThumbnails(wanted, progress,
        [&](int index, const QImage& picture)
        { post([this, index, picture] { emit this->Drawn(index, picture); }); });
    },
    [] {});
}

void PresetThumbnails::Rest()
{
  if (this->rests)
  {
    *this->rests = true;
  }
}

}
