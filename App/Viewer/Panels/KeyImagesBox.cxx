#include "Viewer/Panels/KeyImagesBox.h"

#include "Viewer/Model/KeyImageTexts.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace varimarch
{

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
