#include "Viewer/Panels/CutsPanel.h"

#include "Scene/Model/SceneCamera.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Segments/BodyMask.h"
#include "Scene/Slices/SliceAxes.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Panels/NumberSlider.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace varimarch
{

namespace
{

constexpr int SliderSteps = 1000;
constexpr int MostPlanes = 6; // more would be hard to tell apart

// Selects the plane that is new or was moved by hand. Without one, it keeps the selection, or takes
// the last plane.
int PlaneToSelect(
  const std::vector<CutPlane>& before, const std::vector<CutPlane>& now, int selected)
{
  const auto changed = std::mismatch(now.begin(), now.end(), before.begin(), before.end(),
    [](const CutPlane& a, const CutPlane& b) {
      return a.pointMm == b.pointMm && a.normal == b.normal;
    }).first;
  return before.size() <= now.size() && changed != now.end()
    ? int(changed - now.begin())
    : std::min(selected, int(now.size()) - 1);
}

QString NameOf(const CutPlane& plane)
{
  const std::array<double, 3> away = { -plane.normal[0], -plane.normal[1], -plane.normal[2] };
  return CutsPanel::tr("side %1 cut away")
    .arg(QString::fromStdString(AnatomicalDirection(away.data())));
}

}

CutsPanel::CutsPanel(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
{
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(this->MakeBodyOnly());
  layout->addWidget(this->MakeNoFace());
  layout->addWidget(this->MakePlanes());
  layout->addWidget(this->MakeBox());
  layout->addWidget(this->MakeScissors());
  layout->addWidget(new ClippingRangeBox(model));
  layout->addStretch();
  this->setEnabled(false);
  connect(model, &SceneModel::Changed, this, &CutsPanel::Show);
}

QCheckBox* CutsPanel::MakeBodyOnly()
{
  this->bodyOnly = new QCheckBox(tr("Remove table, head rest and clothes"));
  this->bodyOnly->setObjectName("bodyOnly");
  this->bodyOnly->setToolTip(tr("Shows the body of a CT scan alone"));
  connect(this->bodyOnly, &QCheckBox::clicked, this,
    [this](bool on)
    {
      const WaitCursor wait; // the body of a large scan takes some seconds
      this->model->Edit(ScenePart::Cuts, on ? tr("remove the table") : tr("show the table"),
        [on](Scene& scene) { scene.cuts.bodyOnly = on; });
    });
  return this->bodyOnly;
}

QCheckBox* CutsPanel::MakeNoFace()
{
  this->noFace = new QCheckBox(tr("Remove face"));
  this->noFace->setObjectName("noFace");
  this->noFace->setToolTip(tr(
    "Cuts the front of the head away in the 3D view, to %1 mm behind its smoothed surface. This is "
    "no anonymization: look at the image, ears and bones stay, and slices show the face.")
                             .arg(UsualFaceDepthMm));
  connect(this->noFace, &QCheckBox::clicked, this,
    [this](bool on)
    {
      const WaitCursor wait;
      this->model->Edit(ScenePart::Cuts, on ? tr("remove the face") : tr("show the face"),
        [on](Scene& scene) { scene.cuts.faceDepthMm = on ? UsualFaceDepthMm : 0.0; });
    });
  return this->noFace;
}

QToolButton* CutsPanel::MakeAddButton()
{
  auto* const menu = new QMenu(this);
  const std::tuple<QString, std::array<double, 3>> halves[] = {
    { tr("Cut away the left half"), { -1.0, 0.0, 0.0 } },
    { tr("Cut away the right half"), { 1.0, 0.0, 0.0 } },
    { tr("Cut away the front half"), { 0.0, 1.0, 0.0 } },
    { tr("Cut away the back half"), { 0.0, -1.0, 0.0 } },
    { tr("Cut away the upper half"), { 0.0, 0.0, -1.0 } },
    { tr("Cut away the lower half"), { 0.0, 0.0, 1.0 } },
  };
  for (const auto& [name, normal] : halves)
  {
    menu->addAction(
      name, this, [this, name = name, normal = normal] { this->AddPlane(normal, name); });
  }
  menu->addAction(tr("Cut away the half facing me"), this, &CutsPanel::AddFacingPlane);
  this->add = new QToolButton;
  this->add->setText(tr("Cut away…"));
  this->add->setObjectName("addPlane");
  this->add->setToolTip(
    tr("Adds a plane that cuts away one side, up to %n planes", nullptr, MostPlanes));
  this->add->setMenu(menu);
  this->add->setPopupMode(QToolButton::InstantPopup);
  return this->add;
}

// A drag from press to release is one undo step.
QSlider* CutsPanel::MakeSlider(const QString& name)
{
  auto* const slider = new QSlider(Qt::Horizontal);
  slider->setRange(0, SliderSteps);
  slider->setAccessibleName(name);
  connect(slider, &QSlider::sliderPressed, this, [this] { this->gesture = NewGesture(); });
  connect(
    slider, &QSlider::sliderReleased, this, [this] { this->gesture = SceneModel::NoGesture; });
  return slider;
}

QWidget* CutsPanel::MakePlanes()
{
  auto* const group = new QGroupBox(tr("Planes"));
  this->planes = new QListWidget;
  this->planes->setMaximumHeight(90);
  this->planes->setAccessibleName(group->title());
  this->depth = this->MakeSlider(tr("Depth of the plane"));
  this->flip = new QPushButton(tr("Flip"));
  this->remove = new QPushButton(tr("Remove"));

  auto* const layout = new QGridLayout(group);
  layout->addWidget(this->MakeAddButton(), 0, 0);
  layout->addWidget(this->planes, 1, 0, 1, 2);
  layout->addWidget(this->depth, 2, 0, 1, 2);
  layout->addWidget(this->flip, 3, 0);
  layout->addWidget(this->remove, 3, 1);

  connect(this->planes, &QListWidget::currentRowChanged, this, [this] { this->ShowPlanes(); });
  connect(this->depth, &QSlider::valueChanged, this, &CutsPanel::MovePlane);
  connect(this->flip, &QPushButton::clicked, this, &CutsPanel::FlipPlane);
  connect(this->remove, &QPushButton::clicked, this, &CutsPanel::RemovePlane);
  return group;
}

QWidget* CutsPanel::MakeBox()
{
  auto* const group = new QGroupBox(tr("Box"));
  auto* const layout = new QGridLayout(group);
  for (int face = 0; face < 6; ++face)
  {
    QSlider* const slider = this->MakeSlider(QString());
    this->faceNames[face] = new QLabel;
    layout->addWidget(this->faceNames[face], face, 0);
    layout->addWidget(slider, face, 1);
    connect(slider, &QSlider::valueChanged, this,
      [this, face](int position) { this->MoveFace(face, position); });
    this->faces[face] = slider;
  }
  auto* const all = new QPushButton(tr("Whole volume"));
  layout->addWidget(all, 6, 1);
  connect(all, &QPushButton::clicked, this,
    [this]
    {
      this->model->Edit(ScenePart::Cuts, tr("show the whole volume"),
        [](Scene& scene) { scene.cuts.box = SceneCuts().box; });
    });
  return group;
}

QWidget* CutsPanel::MakeScissors()
{
  auto* const group = new QGroupBox(tr("Scissors"));
  auto* const layout = new QGridLayout(group);
  this->scissors = new QLabel;
  this->scissors->setWordWrap(true);
  this->bringBack = new QPushButton(tr("Remove all cuts"));
  layout->addWidget(this->scissors, 0, 0);
  layout->addWidget(this->bringBack, 1, 0);
  connect(this->bringBack, &QPushButton::clicked, this,
    [this]
    {
      this->model->Edit(ScenePart::Cuts, tr("remove all scissors cuts"),
        [](Scene& scene) { scene.cuts.scissors.clear(); });
    });
  return group;
}

void CutsPanel::ShowScissors()
{
  const int count = int(this->model->CurrentScene().cuts.scissors.size());
  this->scissors->setText(count == 0
      ? tr("Choose Scissors or Keep inside above, then draw around the part to remove or to keep.")
      : tr("Scissors cuts: %1").arg(count));
  this->bringBack->setEnabled(count > 0);
}

void CutsPanel::Show(ScenePart part)
{
  if (part == ScenePart::Volume)
  {
    this->NameFaces();
  }
  if (part == ScenePart::Volume || part == ScenePart::Cuts)
  {
    this->setEnabled(true);
    this->ShowPlanes();
    this->ShowBox();
    this->ShowScissors();
    this->bodyOnly->setChecked(this->model->CurrentScene().cuts.bodyOnly);
    this->noFace->setChecked(this->model->CurrentScene().cuts.faceDepthMm > 0.0);
    this->bodyOnly->setEnabled(HasBodyMask(this->model->CurrentStudy()->volume.modality));
  }
}

void CutsPanel::ShowPlanes()
{
  const std::vector<CutPlane>& cuts = this->model->CurrentScene().cuts.planes;
  const QSignalBlocker quietList(this->planes);
  const QSignalBlocker quietDepth(this->depth);
  const int selected = PlaneToSelect(this->shown, cuts, this->planes->currentRow());
  this->shown = cuts;
  this->add->setEnabled(int(cuts.size()) < MostPlanes);
  this->planes->clear();
  for (const CutPlane& plane : cuts)
  {
    this->planes->addItem(NameOf(plane));
  }
  this->planes->setCurrentRow(selected);
  for (QWidget* widget : std::initializer_list<QWidget*>{ this->depth, this->flip, this->remove })
  {
    widget->setEnabled(selected >= 0);
  }
  if (selected >= 0)
  {
    const double deep = DepthOf(cuts[selected], this->model->CurrentStudy()->volume.image);
    this->depth->setValue(int(std::lround(deep * SliderSteps)));
  }
}

// A face is named after the side of the patient that is nearest to it.
void CutsPanel::NameFaces()
{
  const std::map<char, QString> sides = { { 'R', tr("Right") }, { 'L', tr("Left") },
    { 'A', tr("Front") }, { 'P', tr("Back") }, { 'I', tr("Feet") }, { 'S', tr("Head") } };
  vtkMatrix3x3* const directions = this->model->CurrentStudy()->volume.image->GetDirectionMatrix();
  for (int face = 0; face < 6; ++face)
  {
    const double sign = face % 2 == 0 ? -1.0 : 1.0;
    std::array<double, 3> outwards = {};
    for (int axis = 0; axis < 3; ++axis)
    {
      outwards[axis] = sign * directions->GetElement(axis, face / 2);
    }
    this->faceNames[face]->setText(sides.at(AnatomicalDirection(outwards.data()).front()));
    this->faces[face]->setAccessibleName(this->faceNames[face]->text());
  }
}

void CutsPanel::ShowBox()
{
  for (int face = 0; face < 6; ++face)
  {
    const QSignalBlocker quiet(this->faces[face]);
    this->faces[face]->setValue(
      int(std::lround(this->model->CurrentScene().cuts.box[face] * SliderSteps)));
  }
}

void CutsPanel::AddPlane(const std::array<double, 3>& normal, const QString& stepName)
{
  const std::array<double, 3> middle = MiddleOf(this->model->CurrentStudy()->volume.image);
  this->model->Edit(ScenePart::Cuts, stepName,
    [&](Scene& scene) {
      scene.cuts.planes.push_back({ middle, normal });
    });
}

void CutsPanel::AddFacingPlane()
{
  const std::array<double, 3> direction = ViewDirection(this->model->CurrentScene().camera);
  this->AddPlane(direction, tr("cut away the half facing me"));
}

void CutsPanel::MovePlane(int position)
{
  vtkImageData* const image = this->model->CurrentStudy()->volume.image;
  this->EditPlane(tr("move a plane"),
    [&](CutPlane& plane) { plane = AtDepth(double(position) / SliderSteps, plane, image); });
}

void CutsPanel::EditPlane(const QString& stepName, const std::function<void(CutPlane&)>& change)
{
  const int selected = this->planes->currentRow();
  this->model->Edit(
    ScenePart::Cuts, stepName, [&](Scene& scene) { change(scene.cuts.planes[selected]); },
    this->gesture);
}

void CutsPanel::FlipPlane()
{
  this->EditPlane(tr("flip a plane"),
    [](CutPlane& plane) {
      plane.normal = { -plane.normal[0], -plane.normal[1], -plane.normal[2] };
    });
}

void CutsPanel::RemovePlane()
{
  const int selected = this->planes->currentRow();
  this->model->Edit(ScenePart::Cuts, tr("remove a plane"),
    [&](Scene& scene) { scene.cuts.planes.erase(scene.cuts.planes.begin() + selected); });
}

void CutsPanel::MoveFace(int face, int position)
{
  this->model->Edit(
    ScenePart::Cuts, tr("crop"),
    [&](Scene& scene)
    { varimarch::MoveFace(scene.cuts.box, face, double(position) / SliderSteps); },
    this->gesture);
}

namespace
{

constexpr double LeastDistanceMm = 0.1;

}

ClippingRangeBox::ClippingRangeBox(SceneModel* model, QWidget* parent)
  : QGroupBox(tr("Distance from the eye"), parent)
  , model(model)
{
  this->setObjectName("clippingRange");
  this->setToolTip(tr("Shows only what lies between two distances from the eye"));
  this->setCheckable(true);
  this->setChecked(false);
  auto* const form = new QFormLayout(this);
  this->distances = { this->MakeDistance("nearest", 0), this->MakeDistance("farthest", 1) };
  form->addRow(tr("Nearest"), this->distances[0]);
  form->addRow(tr("Farthest"), this->distances[1]);
  connect(this, &QGroupBox::clicked, this, &ClippingRangeBox::Switch);
  connect(model, &SceneModel::Changed, this, &ClippingRangeBox::Show);
}

NumberSlider* ClippingRangeBox::MakeDistance(const char* name, int end)
{
  auto* const slider = new NumberSlider(LeastDistanceMm, 1000.0, NumberSlider::Scale::Linear);
  slider->setObjectName(name);
  slider->SetSuffix(tr(" mm"));
  connect(slider, &NumberSlider::Edited, this,
    [this, end](double millimetres, int gesture)
    {
      std::array<double, 2> range = *this->model->CurrentScene().camera.clippingRangeMm;
      range[end] = millimetres;
      // The other end makes way.
      range[1] = std::max(range[1], 2.0 * LeastDistanceMm);
      range[1 - end] = end == 0 ? std::max(range[1], range[0] + LeastDistanceMm)
                                : std::min(range[0], range[1] - LeastDistanceMm);
      this->Edit(range, tr("distance from the eye"), gesture);
    });
  return slider;
}

void ClippingRangeBox::Switch(bool on)
{
  std::optional<std::array<double, 2>> range;
  if (on)
  {
    range = DepthRangeMm(this->model->CurrentScene().camera,
      this->model->CurrentStudy()->volume.image->GetBounds(), LeastDistanceMm);
  }
  this->Edit(range, on ? tr("limit the distance from the eye") : tr("show all distances"),
    SceneModel::NoGesture);
}

void ClippingRangeBox::Edit(
  const std::optional<std::array<double, 2>>& range, const QString& name, int gesture)
{
  this->model->Edit(
    ScenePart::Camera, name, [&](Scene& scene) { scene.camera.clippingRangeMm = range; }, gesture);
}

void ClippingRangeBox::Show(ScenePart part)
{
  if (part != ScenePart::Camera && part != ScenePart::Volume)
  {
    return;
  }
  const Camera& camera = this->model->CurrentScene().camera;
  this->setChecked(camera.clippingRangeMm.has_value());
  const std::array<double, 2> all =
    DepthRangeMm(camera, this->model->CurrentStudy()->volume.image->GetBounds(), LeastDistanceMm);
  const std::array<double, 2> shown = camera.clippingRangeMm.value_or(all);
  for (int end : { 0, 1 })
  {
    this->distances[end]->SetRange(LeastDistanceMm, std::max(all[1], shown[1]));
    this->distances[end]->SetNumber(shown[end]);
  }
}

}
