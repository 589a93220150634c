// The panel of cuts: its buttons and sliders edit the scene, and show it.

#include "Scene/Model/SceneCuts.h"
#include "SmallStudy.h"
#include "Viewer/Panels/CutsPanel.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <vtkImageData.h>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Cutting : public testing::Test
{
protected:
  Cutting() { this->model.Open(ProceduralSource(), SmallStudy()); }

  void AddPlane(int entry)
  {
    this->panel.findChild<QToolButton*>("addPlane")->menu()->actions()[entry]->trigger();
  }

  QSlider* Slider(const QString& name)
  {
    for (QSlider* slider : this->panel.findChildren<QSlider*>())
    {
      if (slider->accessibleName() == name)
      {
        return slider;
      }
    }
    return nullptr;
  }

  const std::vector<CutPlane>& Planes() const { return this->model.CurrentScene().cuts.planes; }

  SceneModel model;
  CutsPanel panel{ &this->model };
};

}

TEST_F(Cutting, RemovesTheTableOfACt)
{
  auto* const noFace = this->panel.findChild<QCheckBox*>("noFace");
  noFace->click();
  EXPECT_EQ(this->model.CurrentScene().cuts.faceDepthMm, UsualFaceDepthMm);
  this->model.History()->undo();
  EXPECT_FALSE(noFace->isChecked());
  auto* const bodyOnly = this->panel.findChild<QCheckBox*>("bodyOnly");
  auto study = std::make_shared<Study>(*SmallStudy());
  study->volume.modality = "MR";
  this->model.Open(ProceduralSource(), study);
  EXPECT_FALSE(bodyOnly->isEnabled()) << "values of MR have no unit";
  study->volume.modality = "CT";
  this->model.Open(ProceduralSource(), study);
  ASSERT_TRUE(bodyOnly->isEnabled());
  bodyOnly->click();
  EXPECT_TRUE(this->model.CurrentScene().cuts.bodyOnly);
  this->model.History()->undo();
  EXPECT_FALSE(this->model.CurrentScene().cuts.bodyOnly);
  EXPECT_FALSE(bodyOnly->isChecked());
}

TEST_F(Cutting, IsPossibleOnlyWithAVolume)
{
  SceneModel empty;
  CutsPanel before(&empty);
  EXPECT_FALSE(before.isEnabled());
  empty.Open(ProceduralSource(), SmallStudy());
  EXPECT_TRUE(before.isEnabled());
}

TEST_F(Cutting, AHalfKeepsTheOtherHalf)
{
  this->AddPlane(0); // the patient's left is +x
  ASSERT_EQ(this->Planes().size(), 1);
  EXPECT_EQ(this->Planes()[0].normal, (std::array<double, 3>{ -1.0, 0.0, 0.0 }));
  EXPECT_EQ(this->Planes()[0].pointMm, MiddleOf(this->model.CurrentStudy()->volume.image));
  this->model.History()->undo();
  EXPECT_TRUE(this->Planes().empty());
}

TEST_F(Cutting, WithTheSliderReachesFromFaceToFace)
{
  this->AddPlane(0);
  QSlider* const depth = this->Slider("Depth of the plane");
  const double* const bounds = this->model.CurrentStudy()->volume.image->GetBounds();
  depth->setValue(depth->maximum());
  EXPECT_NEAR(this->Planes()[0].pointMm[0], bounds[0], 1e-9);
  depth->setValue(0);
  EXPECT_NEAR(this->Planes()[0].pointMm[0], bounds[1], 1e-9);
}

TEST_F(Cutting, WithADragIsOneStep)
{
  this->AddPlane(0);
  QSlider* const depth = this->Slider("Depth of the plane");
  const int steps = this->model.History()->count();
  depth->setSliderDown(true);
  for (int position : { 510, 540, 580 })
  {
    depth->setSliderPosition(position);
  }
  depth->setSliderDown(false);
  EXPECT_EQ(this->model.History()->count(), steps + 1);
  this->model.History()->undo();
  EXPECT_EQ(depth->value(), 500);
}

TEST_F(Cutting, FlipsAndRemovesAPlane)
{
  this->AddPlane(2);
  const auto click = [&](const QString& text)
  {
    for (QPushButton* button : this->panel.findChildren<QPushButton*>())
    {
      if (button->text() == text)
      {
        button->click();
      }
    }
  };
  click("Flip");
  EXPECT_EQ(this->Planes()[0].normal[1], -1.0);
  EXPECT_EQ(this->panel.findChild<QListWidget*>()->item(0)->text(), "side P cut away");
  click("Remove");
  EXPECT_TRUE(this->Planes().empty());
  EXPECT_EQ(this->panel.findChild<QListWidget*>()->count(), 0);
}

TEST_F(Cutting, NamesTheFacesOfTheBoxAfterTheSidesOfThePatient)
{
  const auto study = std::make_shared<Study>(*SmallStudy());
  study->volume.image = vtkSmartPointer<vtkImageData>::New();
  study->volume.image->DeepCopy(SmallStudy()->volume.image);
  // Columns go to the back, rows to the head, slices to the right.
  study->volume.image->SetDirectionMatrix(0, 0, -1, 1, 0, 0, 0, 1, 0);
  this->model.Open(ProceduralSource(), study);
  const char* const faces[] = { "Front", "Back", "Feet", "Head", "Left", "Right" };
  for (int face = 0; face < 6; ++face)
  {
    this->Slider(faces[face])->setValue(500);
    EXPECT_DOUBLE_EQ(this->model.CurrentScene().cuts.box[face], 0.5) << faces[face];
    this->model.History()->undo();
  }
}

TEST_F(Cutting, WithTheBoxKeepsItsFacesInOrder)
{
  this->Slider("Right")->setValue(700);
  this->Slider("Left")->setValue(300);
  const std::array<double, 6>& box = this->model.CurrentScene().cuts.box;
  EXPECT_DOUBLE_EQ(box[0], 0.7);
  EXPECT_GT(box[1], box[0]);
  this->model.History()->undo();
  this->model.History()->undo();
  EXPECT_EQ(this->Slider("Right")->value(), 0);
}

TEST_F(Cutting, DistancesFromTheEyeStartWithTheWholeVolumeAndKeepTheirOrder)
{
  auto* const box = this->panel.findChild<QGroupBox*>("clippingRange");
  const auto digits = [&](const char* name)
  { return this->panel.findChild<QWidget*>(name)->findChild<QDoubleSpinBox*>(); };
  const Camera& camera = this->model.CurrentScene().camera;
  EXPECT_FALSE(box->isChecked());
  QTest::keyClick(box, Qt::Key_Space);
  ASSERT_TRUE(camera.clippingRangeMm);
  const std::array<double, 2> whole = *camera.clippingRangeMm;
  const double* const bounds = this->model.CurrentStudy()->volume.image->GetBounds();
  EXPECT_NEAR(whole[1] - whole[0], bounds[3] - bounds[2], 1e-6) << "seen from the front";
  digits("nearest")->setValue(0.5 * (whole[0] + whole[1]));
  EXPECT_NEAR((*camera.clippingRangeMm)[0], 0.5 * (whole[0] + whole[1]), 0.01);
  EXPECT_EQ((*camera.clippingRangeMm)[1], whole[1]);
  digits("farthest")->setValue(0.9 * whole[0]);
  EXPECT_LT((*camera.clippingRangeMm)[0], (*camera.clippingRangeMm)[1]) << "the other makes way";
  this->model.History()->undo();
  EXPECT_NEAR(digits("farthest")->value(), whole[1], 0.01);
  QTest::keyClick(box, Qt::Key_Space);
  EXPECT_FALSE(camera.clippingRangeMm);
}
