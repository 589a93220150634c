#include "Viewer/Panels/GradientOpacityBox.h"

#include "Viewer/Model/GradientCounting.h"
#include "Viewer/TransferFunctionEditor/TransferFunctionEditor.h"

#include <QCheckBox>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace varimarch
{

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

}
