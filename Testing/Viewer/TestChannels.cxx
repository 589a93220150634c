// The channels of a volume in the look panel, in undo steps and in sessions; and its scale.

#include "Scene/Json/SceneFile.h"
#include "SmallStudy.h"
#include "Viewer/Panels/LookBoxes.h"
#include "Viewer/Panels/LookPanel.h"
#include "Viewer/View/PictureReport.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QToolButton>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

// A volume whose component c has values from 0 to 100 (c + 1).
std::shared_ptr<const Study> StudyOf(int type, int components, double spacingMm)
{
  LoadedVolume volume;
  volume.image = vtkSmartPointer<vtkImageData>::New();
  volume.image->SetDimensions(10, 10, 10);
  volume.image->SetSpacing(spacingMm, spacingMm, spacingMm);
  volume.image->AllocateScalars(type, components);
  vtkDataArray* const scalars = volume.image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      scalars->SetComponent(i, c, double(i % 101) * (c + 1));
    }
  }
  ImageStatistics statistics(volume.image);
  return std::make_shared<const Study>(Study{ std::move(volume), std::move(statistics) });
}

class PanelOfChannels : public testing::Test
{
protected:
  void Open(const std::shared_ptr<const Study>& study)
  {
    this->model.Open(ProceduralSource(), study);
    this->panel.show();
  }

  template <class Widget>
  Widget* Find(const char* name) const
  {
    return this->panel.findChild<Widget*>(name);
  }

  const std::vector<LookChannel>& Channels() const
  {
    return this->model.CurrentScene().look.channels;
  }

  SceneModel model;
  LookPanel panel{ &this->model };
};

}

TEST_F(PanelOfChannels, EditsEachInAStepOfItsOwn)
{
  this->Open(StudyOf(VTK_UNSIGNED_SHORT, 3, 1.0));
  ASSERT_EQ(this->Channels().size(), 3u);
  const std::string before = LookText(this->model.CurrentScene().look);
  EXPECT_TRUE(this->Find<QWidget>("channels")->isVisible());
  EXPECT_TRUE(this->Find<QCheckBox>("channelVisible3")->isVisible());
  EXPECT_FALSE(this->Find<QCheckBox>("channelVisible4")->isVisible());

  this->Find<QCheckBox>("channelVisible2")->click();
  EXPECT_FALSE(this->Channels()[1].visible);
  this->Find<QWidget>("channelOpacity1")->findChild<QDoubleSpinBox*>()->setValue(0.5);
  EXPECT_EQ(this->Channels()[0].opacity, 0.5);
  this->Find<QDoubleSpinBox>("channelLast3")->setValue(250.0);
  ASSERT_TRUE(this->Channels()[2].window);
  EXPECT_EQ((*this->Channels()[2].window)[1], 250.0);
  EXPECT_EQ(this->model.History()->count(), 3);

  // A scene file keeps them.
  const std::string text = LookText(this->model.CurrentScene().look);
  EXPECT_EQ(LookText(PresetFromText(text, "test").look), text);
  while (this->model.History()->canUndo())
  {
    this->model.History()->undo();
  }
  EXPECT_EQ(LookText(this->model.CurrentScene().look), before);
  EXPECT_TRUE(this->Find<QCheckBox>("channelVisible2")->isChecked());
}

TEST_F(PanelOfChannels, IsOnlyThereForSeveralComponents)
{
  this->Open(StudyOf(VTK_FLOAT, 1, 1.0));
  EXPECT_FALSE(this->Find<QWidget>("channels")->isVisible());
  this->Open(StudyOf(VTK_UNSIGNED_CHAR, 3, 1.0));
  EXPECT_TRUE(this->Find<QLabel>("ofColors")->isVisible());
  EXPECT_FALSE(this->Find<QCheckBox>("channelVisible1")->isVisible());
}

TEST_F(PanelOfChannels, ShowsTheLengthThatWasChosen)
{
  this->Open(StudyOf(VTK_FLOAT, 1, 1e-5));
  const auto* const box = this->Find<QWidget>("unitDistance")->findChild<QDoubleSpinBox*>();
  EXPECT_NEAR(this->model.CurrentScene().look.opacityUnitDistanceMm, 5e-7, 1e-18);
  EXPECT_NEAR(box->value(), 5e-7, 1e-8);
  this->Open(StudyOf(VTK_FLOAT, 1, 1000.0));
  EXPECT_NEAR(box->value(), 50.0, 1e-9);
}

TEST(PictureReport, SaysWhyNothingIsVisible)
{
  PictureNumbers numbers;
  EXPECT_FALSE(PictureReport(numbers, MapperKind::Varimarch, {}, 1.0).contains("visible"));
  numbers.reasonForNothing = "the cuts remove all of the volume; take one away";
  const QString report = PictureReport(numbers, MapperKind::Varimarch, {}, 1.0);
  EXPECT_TRUE(
    report.contains("Nothing is visible: the cuts remove all of\nthe volume; take one away."))
    << report.toStdString();
}
