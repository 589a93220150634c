#include "Viewer/Panels/LookPanel.h"

#include "Scene/ColorMaps.h"
#include "Scene/LookFiles.h"
#include "Scene/Presets.h"
#include "Viewer/Model/GradientCounting.h"
#include "Viewer/Model/PresetTitles.h"
#include "Viewer/Panels/BlendingForm.h"
#include "Viewer/Panels/ChannelsBox.h"
#include "Viewer/Panels/GradientOpacityBox.h"
#include "Viewer/Panels/RegionsBox.h"
#include "Viewer/Panels/ShadingBox.h"
#include "Viewer/SaveDialog.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QIcon>
#include <QImage>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <exception>

namespace varimarch
{

namespace
{

QIcon PictureOf(const ColorMap& map)
{
  constexpr int Width = 96;
  constexpr int Height = 16;
  const TransferFunction function(map.nodes, {}, 1.0);
  QImage image(Width, Height, QImage::Format_RGB32);
  for (int x = 0; x < Width; ++x)
  {
    for (int y = 0; y < Height; ++y)
    {
      image.setPixelColor(x, y, QColorOf(function.Color((x + 0.5) / Width)));
    }
  }
  return QPixmap::fromImage(image);
}

// Filters of a file dialog: "Looks (*.json)", "3D Slicer volume properties (*.vp.json)" ...
QStringList FileFilters(bool toWrite)
{
  QStringList all;
  QStringList lines;
  for (const LookFileFormat& format : LookFileFormats())
  {
    if (format.canBeWritten || !toWrite)
    {
      const QString pattern = "*" + QString::fromStdString(format.extension);
      all += pattern;
      lines += QStringLiteral("%1 (%2)").arg(QString::fromStdString(format.description), pattern);
    }
  }
  if (!toWrite)
  {
    lines.prepend(LookPanel::tr("All looks (%1)").arg(all.join(' ')));
  }
  return lines;
}

}

LookPanel::LookPanel(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
{
  this->setObjectName("lookPanel");
  auto* const column = new QVBoxLayout(this);
  this->MakePresets(column);
  this->MakeEditor(column);
  column->addWidget(new ChannelsBox(model));
  column->addWidget(new BlendingForm(model));
  auto* const counting = new GradientCounting(model, this);
  column->addWidget(new GradientOpacityBox(model, counting));
  column->addWidget(new RegionsBox(model, counting));
  column->addWidget(new ShadingBox(model));
  // The entries are longer in some languages, and must not widen the panel.
  for (QComboBox* const box : this->findChildren<QComboBox*>())
  {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
  }
  this->setEnabled(false);
  connect(model, &SceneModel::Changed, this, &LookPanel::Update);
}

void LookPanel::MakePresets(QVBoxLayout* column)
{
  this->presets = new QComboBox;
  this->presets->setObjectName("presets");
  this->presets->setAccessibleName(tr("Preset"));
  for (const std::string& name : PresetNames())
  {
    this->presets->addItem(PresetTitle(name), QString::fromStdString(name));
    this->presets->setItemData(this->presets->count() - 1,
      QString::fromStdString(BuiltInPreset(name).look.description), Qt::ToolTipRole);
  }
  connect(this->presets, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index)
    {
      const std::string name = this->presets->itemData(index).toString().toStdString();
      if (IsPresetName(name))
      {
        this->model->SetPreset(BuiltInPreset(name), tr("choose %1").arg(PresetTitle(name)));
      }
    });
  auto* const load = new QPushButton(tr("Load…"));
  load->setToolTip(tr("Loads a look from a file"));
  auto* const save = new QPushButton(tr("Save…"));
  save->setToolTip(tr("Saves the look in a file"));
  connect(load, &QPushButton::clicked, this, &LookPanel::ChooseFileToLoad);
  connect(save, &QPushButton::clicked, this, &LookPanel::ChooseFileToSave);
  auto* const row = new QHBoxLayout;
  row->addWidget(this->presets, 1);
  row->addWidget(load);
  row->addWidget(save);
  column->addLayout(row);

  this->problem = new QLabel;
  this->problem->setObjectName("problem");
  this->problem->setWordWrap(true);
  this->problem->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->problem->hide();
  column->addWidget(this->problem);
}

void LookPanel::MakeEditor(QVBoxLayout* column)
{
  this->editor = new TransferFunctionEditor;
  auto* const tools = new QToolBar;
  tools->setToolButtonStyle(Qt::ToolButtonTextOnly);
  tools->addActions(this->editor->ViewActions());
  tools->addWidget(this->MakeColorMaps());
  column->addWidget(tools);
  column->addWidget(this->editor, 1);
  this->counted = new QLabel;
  this->counted->setObjectName("countedTimes");
  this->counted->hide();
  column->addWidget(this->counted);
  connect(this->editor, &TransferFunctionEditor::LookEdited, this,
    [this](const Look& look, const QString& name, int gesture)
    { this->model->SetLook(look, name, gesture); });
}

QToolButton* LookPanel::MakeColorMaps()
{
  auto* const button = new QToolButton;
  button->setObjectName("colorMaps");
  button->setText(tr("Colours"));
  button->setToolTip(
    tr("Colour maps for any kind of colour vision; the opacity curve stays as it is"));
  button->setPopupMode(QToolButton::InstantPopup);
  auto* const menu = new QMenu(button);
  for (const ColorMap& map : ColorMaps())
  {
    const QString name = QString::fromStdString(map.name);
    menu->addAction(PictureOf(map), name, this,
      [this, &map, name]
      {
        const ImageStatistics& statistics = this->model->EditedStudy()->statistics;
        this->model->SetLook(
          WithColorMap(this->model->EditedLook(), map, statistics.Smallest(), statistics.Largest()),
          tr("colour map %1").arg(name));
      });
  }
  button->setMenu(menu);
  return button;
}

void LookPanel::Update(ScenePart part)
{
  if (part == ScenePart::Voxels && !this->counted->isHidden() &&
    this->model->EditedStudy()->allTimes)
  {
    this->ShowHistogram();
  }
  if (part != ScenePart::Look && !IsOtherLookVolume(part))
  {
    return;
  }
  const Look& look = this->model->EditedLook();
  this->editor->SetLook(look);
  if (IsOtherLookVolume(part))
  {
    const auto study = this->model->EditedStudy();
    this->setEnabled(true);
    this->editor->SetUnit(study->volume.modality == "CT" ? tr("HU") : tr("value"));
    this->ShowHistogram();
  }
  this->ShowPreset();
}

// A copy, since the study would keep the voxels of its time in memory.
void LookPanel::ShowHistogram()
{
  const auto study = this->model->EditedStudy();
  this->editor->SetStatistics(
    study->allTimes ? study->allTimes : std::make_shared<const ImageStatistics>(study->statistics));
  const LoadedTimes& times = study->volume.times;
  this->counted->setText(tr("The histogram is of %1 of %2 times").arg(1).arg(times.values.size()));
  this->counted->setVisible(times.AreSeveral() && !study->allTimes);
}

// Shows the preset's name while the look equals the preset. Otherwise an additional last row names
// the edited look.
void LookPanel::ShowPreset()
{
  const Look& look = this->model->EditedLook();
  const bool isPreset = IsBuiltInLook(look, this->model->EditedStudy()->statistics);
  const int presetCount = int(PresetNames().size());
  this->presets->removeItem(presetCount);
  if (isPreset)
  {
    this->presets->setCurrentIndex(this->presets->findData(QString::fromStdString(look.name)));
  }
  else
  {
    const QString title = PresetTitle(look.name);
    this->presets->addItem(IsPresetName(look.name) ? tr("%1, edited").arg(title)
        : title.isEmpty()                          ? tr("custom look")
                                                   : title);
    this->presets->setCurrentIndex(presetCount);
  }
}

void LookPanel::ChooseFileToLoad()
{
  const QString path =
    QFileDialog::getOpenFileName(this, tr("Load a look"), {}, FileFilters(false).join(";;"));
  if (!path.isEmpty())
  {
    this->Load(path);
  }
}

void LookPanel::ChooseFileToSave()
{
  const QString path = ChosenFileToSave(this, tr("Save the look"), FileFilters(true), QString());
  if (!path.isEmpty())
  {
    this->Save(path);
  }
}

void LookPanel::Load(const QString& path)
{
  this->Attempt(
    [&]
    {
      const std::vector<Preset> presets = ReadLookFile(path.toStdString(), this->FileContext());
      if (const std::optional<std::size_t> chosen = this->ChosenLook(presets))
      {
        this->model->SetPreset(presets[*chosen], tr("load %1").arg(QFileInfo(path).fileName()));
      }
    });
}

std::optional<std::size_t> LookPanel::ChosenLook(const std::vector<Preset>& presets)
{
  if (presets.size() == 1)
  {
    return 0;
  }
  QStringList names;
  for (const Preset& preset : presets)
  {
    names.append(QString::fromStdString(preset.look.name));
  }
  bool isChosen = false;
  const QString name = QInputDialog::getItem(this, tr("Load a look"),
    tr("The file holds %n looks:", nullptr, names.size()), names, 0, false, &isChosen);
  return isChosen ? std::optional<std::size_t>(names.indexOf(name)) : std::nullopt;
}

void LookPanel::Save(const QString& path)
{
  this->Attempt(
    [&] {
      WriteLookFile(PresetOf(this->model->EditedScene()), path.toStdString(), this->FileContext());
    });
}

LookContext LookPanel::FileContext() const
{
  LookContext context = ContextOf(this->model->EditedStudy()->volume.image);
  context.opacities = this->model->EditedLook().opacities;
  return context;
}

void LookPanel::Attempt(const std::function<void()>& action)
{
  this->problem->hide();
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

}
