#include "Viewer/Panels/BlendingForm.h"

#include "Viewer/Panels/NumberSlider.h"
#include "Viewer/TransferFunctionEditor/LookEditing.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <utility>

namespace varimarch
{

namespace
{

// Lengths for a patient. Other volumes may be much smaller or larger.
constexpr double ShortestUnitMm = 0.01;
constexpr double LongestUnitMm = 100.0;

// Name of a blend mode and its purpose.
struct BlendText
{
  Blend blend;
  QString name;
  QString purpose;
};

std::vector<BlendText> BlendTexts()
{
  return {
    { Blend::Composite, BlendingForm::tr("Composite"),
      BlendingForm::tr("Translucent material with the opacities of the curve") },
    { Blend::MaximumIntensity, BlendingForm::tr("Maximum"),
      BlendingForm::tr("The largest value along each ray: vessels, implants (MIP)") },
    { Blend::MinimumIntensity, BlendingForm::tr("Minimum"),
      BlendingForm::tr("The smallest value along each ray: airways (MinIP)") },
    { Blend::AverageIntensity, BlendingForm::tr("Average"),
      BlendingForm::tr("The mean along each ray, as in a thick slice") },
    { Blend::Additive, BlendingForm::tr("Additive"),
      BlendingForm::tr("The sum along each ray, as in an X-ray image") },
    { Blend::Isosurface, BlendingForm::tr("Isosurfaces"),
      BlendingForm::tr("Surfaces of equal value, each with its colour and opacity") },
  };
}

}

BlendingForm::BlendingForm(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , form(new QFormLayout(this))
{
  this->form->setContentsMargins(0, 0, 0, 0);
  this->MakeBlend();
  this->MakeUnitDistance();
  this->MakeAveragedRange();
  connect(model, &SceneModel::Changed, this, &BlendingForm::Update);
}

void BlendingForm::MakeBlend()
{
  this->blend = new QComboBox;
  this->blend->setObjectName("blend");
  for (const BlendText& text : BlendTexts())
  {
    this->blend->addItem(text.name, int(text.blend));
    this->blend->setItemData(this->blend->count() - 1, text.purpose, Qt::ToolTipRole);
  }
  connect(this->blend, QOverload<int>::of(&QComboBox::activated), this,
    [this](int index) { this->ChooseBlend(Blend(this->blend->itemData(index).toInt())); });
  this->form->addRow(tr("Blend mode"), this->blend);
}

void BlendingForm::MakeUnitDistance()
{
  this->unitDistance =
    new NumberSlider(ShortestUnitMm, LongestUnitMm, NumberSlider::Scale::Logarithmic);
  this->unitDistance->setObjectName("unitDistance");
  this->unitDistance->SetSuffix(tr(" mm"));
  connect(this->unitDistance, &NumberSlider::Edited, this,
    [this](double millimetres, int gesture)
    {
      Look look = this->model->EditedLook();
      look.opacityUnitDistanceMm = millimetres;
      this->model->SetLook(look, tr("opacity distance"), gesture);
    });
  this->form->addRow(tr("Opacity per"), this->unitDistance);
}

void BlendingForm::MakeAveragedRange()
{
  this->averagedRange = new QWidget;
  this->averagedRange->setObjectName("averagedRange");
  this->averagedRange->setToolTip(tr("Values outside this range do not count in the mean"));
  auto* const row = new QHBoxLayout(this->averagedRange);
  row->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const char* name, const QString& meaning)
  {
    auto* const box = new QDoubleSpinBox;
    box->setAccessibleName(meaning);
    box->setObjectName(name);
    box->setKeyboardTracking(false);
    row->addWidget(box, 1);
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
      &BlendingForm::ChooseAveragedRange);
    return box;
  };
  this->averagedFirst = add("averagedFirst", tr("Smallest value of the mean"));
  row->addWidget(new QLabel(tr("to")));
  this->averagedLast = add("averagedLast", tr("Largest value of the mean"));
  this->form->addRow(tr("Values from"), this->averagedRange);
}

void BlendingForm::ChooseBlend(Blend chosen)
{
  Look look = this->model->EditedLook();
  look = chosen == Blend::Isosurface ? WithSurface(look) : look;
  look.blend = chosen;
  this->model->SetLook(look, tr("blend mode"));
}

void BlendingForm::ChooseAveragedRange()
{
  const auto study = this->model->EditedStudy();
  const double first = std::min(this->averagedFirst->value(), this->averagedLast->value());
  const double last = std::max(this->averagedFirst->value(), this->averagedLast->value());
  const bool all = first <= study->statistics.Smallest() && last >= study->statistics.Largest();
  Look look = this->model->EditedLook();
  look.averagedRange = all ? std::nullopt : std::optional(std::array<double, 2>{ first, last });
  this->model->SetLook(look, tr("range of averaged values"));
}

void BlendingForm::ShowRow(QWidget* field, bool shown)
{
  field->setVisible(shown);
  this->form->labelForField(field)->setVisible(shown);
}

void BlendingForm::ShowUnitDistance(double millimetres, double lengthFactor)
{
  this->unitDistance->SetRange(std::min(lengthFactor * ShortestUnitMm, millimetres),
    std::max(lengthFactor * LongestUnitMm, millimetres));
  this->unitDistance->SetNumber(millimetres);
  const QString meaning = tr("Thickness of material that has the opacities of the curve");
  this->unitDistance->setToolTip(lengthFactor == 1.0 ? meaning
                                                     : meaning +
        tr(". Presets set it by the size of the volume, which is not known to show a "
           "patient"));
}

void BlendingForm::Update(ScenePart part)
{
  if (part != ScenePart::Look && !IsOtherLookVolume(part))
  {
    return;
  }
  const Look& look = this->model->EditedLook();
  const ImageStatistics& statistics = this->model->EditedStudy()->statistics;
  this->blend->setCurrentIndex(this->blend->findData(int(look.blend)));
  this->ShowUnitDistance(look.opacityUnitDistanceMm, statistics.LengthFactor());
  const std::array<double, 2> range = look.averagedRange.value_or(
    std::array<double, 2>{ statistics.Smallest(), statistics.Largest() });
  for (const auto& [box, value] :
    { std::pair(this->averagedFirst, range[0]), std::pair(this->averagedLast, range[1]) })
  {
    const QSignalBlocker quiet(box);
    const double width = statistics.Largest() - statistics.Smallest();
    box->setDecimals(width < 100.0 ? 3 : 0);
    box->setSingleStep(width < 100.0 ? 0.01 * width : 10.0);
    box->setRange(statistics.Smallest(), statistics.Largest());
    box->setValue(value);
  }
  this->ShowRow(
    this->unitDistance, look.blend == Blend::Composite || look.blend == Blend::Additive);
  this->ShowRow(this->averagedRange, look.blend == Blend::AverageIntensity);
}

}
