#include "Viewer/Panels/QualityPanel.h"

#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

// Error tolerances to choose from, as 1/n of full brightness.
constexpr std::array<int, 6> Parts = { 8, 16, 32, 64, 128, 255 };

}

QualityPanel::QualityPanel(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , error(new QSlider(Qt::Horizontal))
  , text(new QLabel)
{
  this->error->setRange(0, int(Parts.size()) - 1);
  this->error->setPageStep(1);
  this->error->setTickPosition(QSlider::TicksBelow);
  this->error->setAccessibleName(tr("Largest error"));
  auto* const layout = new QFormLayout(this);
  layout->addRow(tr("Fast"), this->error);
  layout->addRow(tr("Error at most"), this->text);
  connect(this->error, &QSlider::valueChanged, this,
    [this](int position)
    {
      this->model->Edit(ScenePart::Render, tr("quality"),
        [position](Scene& scene) { scene.render.errorTolerance = 1.0 / Parts[position]; });
    });
  connect(model, &SceneModel::Changed, this, &QualityPanel::Show);
  this->setEnabled(false);
}

void QualityPanel::Show()
{
  this->setEnabled(true);
  const QSignalBlocker quiet(this->error);
  const double parts =
    1.0 / std::max(this->model->CurrentScene().render.errorTolerance, 1.0 / Parts.back());
  const auto nearest = std::min_element(Parts.begin(), Parts.end(),
    [parts](int a, int b) { return std::abs(a - parts) < std::abs(b - parts); });
  this->error->setValue(int(nearest - Parts.begin()));
  this->text->setText(tr("1/%1 of full brightness").arg(int(std::lround(parts))));
}

}
