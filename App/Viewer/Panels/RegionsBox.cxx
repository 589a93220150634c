#include "Viewer/Panels/RegionsBox.h"

#include "Scene/ScenePipeline.h"
#include "Viewer/Model/GradientCounting.h"
#include "Viewer/Panels/NumberSlider.h"
#include "Viewer/RegionEditor/RegionEditor.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace varimarch
{

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
