#include "Viewer/Panels/LookBoxes.h"

#include "Readers/ImageFacts.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Pipeline/ScenePipeline.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/GradientCounting.h"
#include "Viewer/Panels/NumberSlider.h"
#include "Viewer/RegionEditor/RegionEditor.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPixmap>
#include <QSignalBlocker>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace varimarch
{

namespace
{

// The colour of a channel that has none of its own is that of the look where it is most opaque.
QColor ShownColor(const Look& look, const LookChannel& channel)
{
  const glm::dvec3 rgb = channel.rgb.value_or(look.colors.back().rgb);
  return QColor::fromRgbF(rgb.r, rgb.g, rgb.b);
}

QIcon SwatchOfChannel(const QColor& color)
{
  QPixmap swatch(16, 16);
  swatch.fill(color);
  return swatch;
}

// The window of a channel that has none of its own is that of the look.
std::array<double, 2> ShownWindow(const Look& look, const LookChannel& channel)
{
  return channel.window.value_or(
    std::array<double, 2>{ look.opacities.front().value, look.opacities.back().value });
}

}

ChannelsBox::ChannelsBox(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , ofColors(new QLabel(tr("The volume is drawn in its own colours. The curve is their opacity.")))
{
  this->setObjectName("channels");
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  this->ofColors->setObjectName("ofColors");
  this->ofColors->setWordWrap(true);
  column->addWidget(this->ofColors);
  for (std::size_t i = 0; i < MostChannels; ++i)
  {
    this->rows[i] = this->MakeRow(i);
    column->addWidget(this->rows[i].whole);
  }
  this->hide();
  connect(model, &SceneModel::Changed, this, &ChannelsBox::Update);
}

ChannelsBox::Row ChannelsBox::MakeRow(std::size_t channel)
{
  Row row = { new QWidget, new QCheckBox, new QToolButton,
    new NumberSlider(0.0, 1.0, NumberSlider::Scale::Linear), {} };
  const QString number = QString::number(channel + 1);
  row.visible->setObjectName("channelVisible" + number);
  row.visible->setToolTip(tr("Draws the channel"));
  row.visible->setAccessibleName(tr("Channel %1").arg(number));
  row.color->setObjectName("channelColor" + number);
  row.color->setToolTip(tr("Colour of the channel"));
  row.color->setAccessibleName(tr("Colour of channel %1").arg(number));
  row.opacity->setObjectName("channelOpacity" + number);
  row.opacity->setAccessibleName(tr("Opacity of channel %1").arg(number));
  row.opacity->setToolTip(tr("Factor of the opacities of the curve"));
  auto* const upper = new QHBoxLayout;
  upper->addWidget(row.color);
  upper->addWidget(row.visible, 1);
  upper->addWidget(row.opacity, 1);
  auto* const column = new QVBoxLayout(row.whole);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(upper);
  this->MakeWindow(channel, row);
  connect(row.visible, &QCheckBox::clicked, this,
    [this, channel](bool on)
    { this->Edit(channel, tr("channel"), [on](LookChannel& one) { one.visible = on; }); });
  connect(row.color, &QToolButton::clicked, this, [this, channel] { this->ChooseColor(channel); });
  connect(row.opacity, &NumberSlider::Edited, this,
    [this, channel](double opacity, int gesture)
    {
      this->Edit(
        channel, tr("opacity of a channel"), [opacity](LookChannel& one) { one.opacity = opacity; },
        gesture);
    });
  return row;
}

void ChannelsBox::MakeWindow(std::size_t channel, Row& row)
{
  auto* const line = new QHBoxLayout;
  line->addWidget(new QLabel(tr("Values from")));
  const std::array<QString, 2> names = { tr("First value of channel %1").arg(channel + 1),
    tr("Last value of channel %1").arg(channel + 1) };
  for (std::size_t end = 0; end < 2; ++end)
  {
    row.window[end] = new QDoubleSpinBox;
    row.window[end]->setObjectName(
      (end == 0 ? "channelFirst" : "channelLast") + QString::number(channel + 1));
    row.window[end]->setAccessibleName(names[end]);
    row.window[end]->setToolTip(tr("The curve reaches from the first to the last of these values"));
    row.window[end]->setKeyboardTracking(false);
    line->addWidget(row.window[end], 1);
    if (end == 0)
    {
      line->addWidget(new QLabel(tr("to")));
    }
    connect(row.window[end], QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
      [this, channel] { this->EditWindow(channel); });
  }
  qobject_cast<QVBoxLayout*>(row.whole->layout())->addLayout(line);
}

void ChannelsBox::Edit(std::size_t channel, const QString& name,
  const std::function<void(LookChannel&)>& change, int gesture)
{
  Look look = this->model->EditedLook();
  if (channel < look.channels.size())
  {
    change(look.channels[channel]);
    this->model->SetLook(look, name, gesture);
  }
}

void ChannelsBox::EditWindow(std::size_t channel)
{
  const double first = this->rows[channel].window[0]->value();
  const double last = this->rows[channel].window[1]->value();
  if (first < last)
  {
    this->Edit(channel, tr("values of a channel"),
      [=](LookChannel& one) {
        one.window = { first, last };
      });
  }
}

void ChannelsBox::ChooseColor(std::size_t channel)
{
  const Look look = this->model->EditedLook();
  const std::optional<glm::dvec3> before = look.channels[channel].rgb;
  const int gesture = NewGesture();
  const auto edit = [this, channel, gesture](const std::optional<glm::dvec3>& rgb)
  {
    this->Edit(
      channel, tr("colour of a channel"), [&](LookChannel& one) { one.rgb = rgb; }, gesture);
  };
  const QColorDialog* const dialog = OpenLiveColorDialog(
    ShownColor(look, look.channels[channel]),
    [edit](const QColor& color) { edit(glm::dvec3(color.redF(), color.greenF(), color.blueF())); },
    this);
  connect(dialog, &QColorDialog::rejected, this, [edit, before] { edit(before); });
}

void ChannelsBox::Update(ScenePart part)
{
  if (part != ScenePart::Look && !IsOtherLookVolume(part))
  {
    return;
  }
  const auto study = this->model->EditedStudy();
  const std::size_t count = study->statistics.Channels().size();
  const bool areColors = HoldsColors(study->volume.image);
  this->ofColors->setVisible(areColors);
  this->setVisible(areColors || count > 0);
  const std::vector<LookChannel> channels =
    WithAllChannels(this->model->EditedLook().channels, study->statistics.Channels());
  for (std::size_t i = 0; i < MostChannels; ++i)
  {
    this->rows[i].whole->setVisible(i < count);
    if (i < count)
    {
      this->Show(i, channels[i]);
    }
  }
}

void ChannelsBox::Show(std::size_t channel, const LookChannel& settings)
{
  const Row& row = this->rows[channel];
  row.visible->setText(settings.name.empty() ? tr("Channel %1").arg(channel + 1)
                                             : QString::fromStdString(settings.name));
  row.visible->setChecked(settings.visible);
  row.color->setIcon(SwatchOfChannel(ShownColor(this->model->EditedLook(), settings)));
  row.opacity->SetNumber(settings.opacity);
  this->ShowWindow(channel, settings);
}

void ChannelsBox::ShowWindow(std::size_t channel, const LookChannel& settings)
{
  const ImageStatistics& statistics = this->model->EditedStudy()->statistics.OfChannel(channel);
  const std::array<double, 2> window = ShownWindow(this->model->EditedLook(), settings);
  const double width = std::max(statistics.Largest() - statistics.Smallest(), 1e-6);
  for (std::size_t end = 0; end < 2; ++end)
  {
    QDoubleSpinBox* const box = this->rows[channel].window[end];
    const QSignalBlocker quiet(box);
    box->setDecimals(width < 1.0 ? 6 : width < 100.0 ? 3 : 1);
    box->setSingleStep(0.01 * width);
    box->setRange(std::min(statistics.Smallest(), window[0]) - width,
      std::max(statistics.Largest(), window[1]) + width);
    box->setValue(window[end]);
  }
}

namespace
{

// A curve that makes homogeneous regions transparent and keeps edges.
std::vector<OpacityNode> EdgesOf(const ImageStatistics& gradients)
{
  const double dark = gradients.Percentile(60.0);
  const double full = std::max(gradients.Percentile(95.0), dark + gradients.BinSpacing());
  return { { dark, 0.0 }, { full, 1.0 } };
}

}

GradientOpacityBox::GradientOpacityBox(
  SceneModel* model, const GradientCounting* counting, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , counting(counting)
  , isOn(new QCheckBox(tr("Opacity by gradient")))
  , editor(new TransferFunctionEditor)
{
  this->isOn->setObjectName("gradientOpacity");
  this->isOn->setToolTip(tr("Makes edges between materials stand out from homogeneous regions"));
  this->isOn->setEnabled(false);
  this->editor->LeaveOutColors();
  this->editor->setObjectName("gradientEditor");
  this->editor->setAccessibleName(tr("Opacity by gradient"));
  this->editor->hide();
  auto* const tools = new QToolBar;
  tools->setToolButtonStyle(Qt::ToolButtonTextOnly);
  tools->addActions(this->editor->ViewActions());
  tools->hide();
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(this->isOn);
  column->addWidget(tools);
  column->addWidget(this->editor, 1);
  // Hide the editor while the gradient opacity is off.
  connect(this->isOn, &QCheckBox::toggled, tools, &QWidget::setVisible);
  connect(this->isOn, &QCheckBox::toggled, this->editor, &QWidget::setVisible);
  connect(this->isOn, &QCheckBox::clicked, this, &GradientOpacityBox::Switch);
  connect(this->editor, &TransferFunctionEditor::LookEdited, this,
    [this](const Look& edited, const QString& name, int gesture)
    { this->Edit(edited.opacities, name, gesture); });
  connect(counting, &GradientCounting::Begun, this, [this] { this->isOn->setEnabled(false); });
  connect(counting, &GradientCounting::Counted, this, &GradientOpacityBox::TakeCounts);
  connect(model, &SceneModel::Changed, this, &GradientOpacityBox::Update);
}

void GradientOpacityBox::Switch(bool on)
{
  if (!on)
  {
    this->remembered = this->model->EditedLook().gradientOpacities;
    this->Edit({}, tr("switch off opacity by gradient"), SceneModel::NoGesture);
    return;
  }
  this->Edit(
    this->remembered.empty() ? EdgesOf(this->counting->Counts()->gradients) : this->remembered,
    tr("switch on opacity by gradient"), SceneModel::NoGesture);
}

void GradientOpacityBox::Edit(
  const std::vector<OpacityNode>& nodes, const QString& name, int gesture)
{
  Look look = this->model->EditedLook();
  look.gradientOpacities = nodes;
  this->model->SetLook(look, name, gesture);
}

void GradientOpacityBox::Update(ScenePart part)
{
  if (IsOtherLookVolume(part))
  {
    this->remembered.clear();
    const bool isCt = this->model->EditedStudy()->volume.modality == "CT";
    this->editor->SetUnit(isCt ? tr("HU/mm") : tr("per mm"));
  }
  if (part != ScenePart::Look && !IsOtherLookVolume(part))
  {
    return;
  }
  const Look& look = this->model->EditedLook();
  this->setVisible(look.blend == Blend::Composite);
  this->isOn->setChecked(!look.gradientOpacities.empty());
  if (!look.gradientOpacities.empty())
  {
    Look curve;
    curve.opacities = look.gradientOpacities;
    this->editor->SetLook(curve);
  }
}

void GradientOpacityBox::TakeCounts()
{
  this->isOn->setEnabled(true);
  const auto counts = this->counting->Counts();
  this->editor->SetStatistics({ counts, &counts->gradients });
}

namespace
{

// A region of the edges between materials, in volumes that have more than one value.
LookRegion EdgesOfVolume(const ImageStatistics& values, const GradientCounts& counts)
{
  LookRegion region;
  region.values = { values.Percentile(50.0), values.Percentile(99.9) };
  if (!(region.values[0] < region.values[1]))
  {
    region.values = { values.Smallest(), values.Largest() };
  }
  const double largest = counts.withValues.largestGradient;
  region.gradients = { std::min(counts.gradients.Percentile(85.0), 0.5 * largest), largest };
  region.rgb = { 1.0, 0.85, 0.6 };
  region.opacity = 0.3;
  return region;
}

}

RegionsBox::RegionsBox(SceneModel* model, const GradientCounting* counting, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , counting(counting)
  , isOn(new QCheckBox(tr("Regions of value and gradient")))
  , editor(new RegionEditor)
  , content(new QWidget)
{
  this->isOn->setObjectName("regions");
  this->isOn->setToolTip(
    tr("Rectangles and ellipses over the values and their gradients, instead of the curves"));
  this->isOn->setEnabled(false);
  auto* const tools = new QToolBar;
  tools->setToolButtonStyle(Qt::ToolButtonTextOnly);
  tools->addActions(this->editor->EditActions());
  auto* const column = new QVBoxLayout(this->content);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tools);
  column->addWidget(this->editor, 1);
  column->addWidget(this->MakeNumbers());
  this->ShowNumbers();
  this->content->hide();
  auto* const all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(this->isOn);
  all->addWidget(this->content, 1);
  connect(this->isOn, &QCheckBox::toggled, this->content, &QWidget::setVisible);
  connect(this->isOn, &QCheckBox::clicked, this, &RegionsBox::Switch);
  connect(this->editor, &RegionEditor::RegionsEdited, this, &RegionsBox::Edit);
  connect(this->editor, &RegionEditor::SelectionChanged, this, &RegionsBox::ShowNumbers);
  connect(counting, &GradientCounting::Begun, this, [this] { this->isOn->setEnabled(false); });
  connect(counting, &GradientCounting::Counted, this, &RegionsBox::TakeCounts);
  connect(model, &SceneModel::Changed, this, &RegionsBox::Update);
}

QWidget* RegionsBox::MakeNumbers()
{
  auto* const numbers = new QWidget;
  auto* const form = new QFormLayout(numbers);
  form->setContentsMargins(0, 0, 0, 0);
  this->opacity =
    this->MakeNumber("regionOpacity", tr("opacity of a region"), &LookRegion::opacity);
  form->addRow(tr("Opacity"), this->opacity);
  this->softness =
    this->MakeNumber("regionSoftness", tr("soft edge of a region"), &LookRegion::softness);
  form->addRow(tr("Soft edge"), this->softness);
  return numbers;
}

NumberSlider* RegionsBox::MakeNumber(
  const char* objectName, const QString& name, double LookRegion::*number)
{
  auto* const slider = new NumberSlider(0.0, 1.0, NumberSlider::Scale::Linear);
  slider->setObjectName(objectName);
  connect(slider, &NumberSlider::Edited, this,
    [=](double entered, int gesture)
    {
      this->editor->EditSelected(
        name, [=](LookRegion& region) { region.*number = entered; }, gesture);
    });
  return slider;
}

void RegionsBox::Switch(bool on)
{
  if (!on)
  {
    this->remembered = this->model->EditedLook().regions;
    this->Edit({}, tr("switch off regions"), SceneModel::NoGesture);
    return;
  }
  const LookRegion first =
    EdgesOfVolume(this->model->EditedStudy()->statistics, *this->counting->Counts());
  this->Edit(this->remembered.empty() ? std::vector<LookRegion>{ first } : this->remembered,
    tr("switch on regions"), SceneModel::NoGesture);
  this->editor->Select(0);
}

void RegionsBox::Edit(const std::vector<LookRegion>& regions, const QString& name, int gesture)
{
  Look look = this->model->EditedLook();
  look.regions = regions;
  this->model->SetLook(look, name, gesture);
}

void RegionsBox::Update(ScenePart part)
{
  if (IsOtherLookVolume(part))
  {
    this->remembered.clear();
    this->editor->SetUnit(
      this->model->EditedStudy()->volume.modality == "CT" ? tr("HU") : QString());
  }
  if (part != ScenePart::Look && !IsOtherLookVolume(part))
  {
    return;
  }
  const Look& look = this->model->EditedLook();
  this->setVisible(
    CanDrawRegions(MapperKind::Varimarch, look.blend, this->model->EditedStudy()->volume.image));
  this->isOn->setChecked(!look.regions.empty());
  this->editor->SetRegions(look.regions);
  this->ShowNumbers();
}

void RegionsBox::TakeCounts()
{
  const auto counts = this->counting->Counts();
  this->editor->SetHistogram({ counts, &counts->withValues });
  const ImageStatistics& values = this->model->EditedStudy()->statistics;
  this->isOn->setEnabled(values.Smallest() < values.Largest());
}

void RegionsBox::ShowNumbers()
{
  const LookRegion* const selected = this->editor->Selected();
  this->opacity->setEnabled(selected != nullptr);
  this->softness->setEnabled(selected != nullptr);
  if (selected)
  {
    this->opacity->SetNumber(selected->opacity);
    this->softness->SetNumber(selected->softness);
  }
}

}
