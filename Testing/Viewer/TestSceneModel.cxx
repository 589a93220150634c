// The model: every edit is an undo step, a gesture is a single step, and a new volume clears them.

#include "LabelledStudy.h"
#include "Scene/Looks/Presets.h"

#include <QSignalSpy>

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class OpenedModel : public testing::Test
{
protected:
  OpenedModel() { this->model.Open(ProceduralSource(), SmallStudy()); }

  void Zoom(double zoom, int gesture = SceneModel::NoGesture)
  {
    this->model.Edit(
      ScenePart::Camera, "zoom", [&](Scene& scene) { scene.camera.zoom = zoom; }, gesture);
  }

  SceneModel model;
};

}

TEST_F(OpenedModel, HasALookInUnitsOfTheData)
{
  EXPECT_EQ(this->model.CurrentScene().look.name, "ct-bone");
  EXPECT_EQ(this->model.CurrentScene().look.domain, Domain::Data);
  Look relative;
  relative.domain = Domain::Relative;
  relative.colors = { { 1.0, { 1.0, 0.0, 0.0 } } };
  relative.opacities = { { 0.0, 0.0 }, { 1.0, 0.5 } };
  this->model.SetLook(relative, "a look");
  EXPECT_EQ(this->model.CurrentScene().look.domain, Domain::Data);
  EXPECT_EQ(this->model.CurrentScene().look.opacities[1].value,
    this->model.CurrentStudy()->statistics.Percentile(99.9));
}

TEST_F(OpenedModel, EditsAreUndoneAndDoneAgain)
{
  QSignalSpy changes(&this->model, &SceneModel::Changed);
  this->Zoom(2.0);
  this->Zoom(3.0);
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 3.0);
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 2.0);
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 1.0);
  this->model.History()->redo();
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 2.0);
  ASSERT_EQ(changes.count(), 5);
  EXPECT_EQ(changes.last().first().value<ScenePart>(), ScenePart::Camera);
}

TEST_F(OpenedModel, AGestureIsOneStep)
{
  this->Zoom(2.0, 7);
  this->Zoom(3.0, 7);
  this->Zoom(4.0, 7);
  this->Zoom(5.0, 8);
  EXPECT_EQ(this->model.History()->count(), 2);
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 4.0);
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 1.0);
}

TEST_F(OpenedModel, AGestureThatEndsWhereItBeganIsNoStep)
{
  this->Zoom(2.0, 7);
  this->Zoom(3.0, 8);
  this->Zoom(2.0, 8);
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 2.0);
  EXPECT_EQ(this->model.History()->count(), 1);
  EXPECT_FALSE(this->model.History()->canRedo());
}

TEST_F(OpenedModel, APointThatIsDraggedBackIsNoStep)
{
  const auto dragTo = [this](double x, int gesture)
  {
    this->model.Edit(
      ScenePart::Measures, "measure",
      [x](Scene& scene) {
        scene.measures = { { MeasureKind::Distance, { { 0, 0, 0 }, { x, 0, 0 } } } };
      },
      gesture);
  };
  dragTo(1.0, 7);
  dragTo(2.0, 8);
  dragTo(3.0, 8);
  EXPECT_EQ(this->model.History()->count(), 2);
  dragTo(1.0, 8);
  EXPECT_EQ(this->model.History()->count(), 1);
}

TEST_F(OpenedModel, AnotherFormOfTheVolumeIsAStepThatKeepsTheRest)
{
  this->Zoom(2.0);
  const std::shared_ptr<const Study> before = this->model.CurrentStudy();
  const std::shared_ptr<const Study> form = SmallStudy();
  const FileSource rectified{ "/scans/head", std::nullopt, "", true };
  QSignalSpy changes(&this->model, &SceneModel::Changed);
  this->model.Exchange(rectified, form, "rectify");
  EXPECT_EQ(this->model.CurrentStudy(), form);
  EXPECT_EQ(this->model.ExchangedStudy(), before);
  EXPECT_TRUE(std::get<FileSource>(this->model.CurrentScene().volume).rectified);
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 2.0);
  EXPECT_EQ(changes.last().first().value<ScenePart>(), ScenePart::Volume);
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentStudy(), before);
  EXPECT_TRUE(std::holds_alternative<ProceduralSource>(this->model.CurrentScene().volume));
  EXPECT_EQ(changes.last().first().value<ScenePart>(), ScenePart::Volume);
  this->model.History()->undo();
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 1.0);
  this->model.History()->redo();
  this->model.History()->redo();
  EXPECT_EQ(this->model.CurrentStudy(), form);
  this->model.Open(ProceduralSource(), SmallStudy());
  EXPECT_FALSE(this->model.ExchangedStudy());
}

TEST_F(OpenedModel, AnotherFormDoesNotBringClosedLabelsBack)
{
  const FileSource rectified{ "/scans/head", std::nullopt, "", true };
  this->model.Exchange(rectified, LabelledStudy(), "rectify");
  EXPECT_FALSE(this->model.CurrentScene().labels);
  EXPECT_FALSE(this->model.CurrentStudy()->labels);
}

TEST_F(OpenedModel, TheWholeVolumeReplacesItsCoarseCopyAndKeepsTheRest)
{
  this->Zoom(2.0);
  const Look look = this->model.CurrentScene().look;
  const std::shared_ptr<const Study> whole = SmallStudy();
  QSignalSpy changes(&this->model, &SceneModel::Changed);
  this->model.Complete(whole);
  EXPECT_EQ(this->model.CurrentStudy(), whole);
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 2.0);
  EXPECT_EQ(this->model.CurrentScene().look.name, look.name);
  EXPECT_EQ(changes.last().first().value<ScenePart>(), ScenePart::Volume);
  EXPECT_FALSE(this->model.History()->canUndo()) << "steps have the coarse copy";
}

TEST_F(OpenedModel, TheWholeVolumeHasThePresetOfItsOwnValuesAndTheLabelsOfItsFile)
{
  this->model.Open(FileSource{ "labels.nrrd", std::nullopt }, SmallStudy());
  this->model.SetPreset(BuiltInPreset("mr-head"), "a look in parts of the range");
  Study whole = *LabelledStudy();
  whole.volume.image = vtkSmartPointer<vtkImageData>::New();
  whole.volume.image->DeepCopy(this->model.CurrentStudy()->volume.image);
  vtkDataArray* const values = whole.volume.image->GetPointData()->GetScalars();
  for (vtkIdType voxel = 0; voxel < values->GetNumberOfTuples(); ++voxel)
  {
    values->SetComponent(voxel, 0, 2.0 * values->GetComponent(voxel, 0));
  }
  whole.statistics = ImageStatistics(whole.volume.image);
  ASSERT_FALSE(IsBuiltInLook(this->model.CurrentScene().look, whole.statistics));
  this->model.Complete(std::make_shared<const Study>(whole));
  EXPECT_TRUE(IsBuiltInLook(this->model.CurrentScene().look, whole.statistics));
  ASSERT_TRUE(this->model.CurrentScene().labels);
  EXPECT_EQ(this->model.CurrentScene().labels->path, "labels.nrrd");
  EXPECT_EQ(this->model.CurrentScene().labels->segments.size(), 2u);
}

TEST_F(OpenedModel, AnotherVolumeForgetsTheStepsOfTheLast)
{
  this->Zoom(2.0);
  this->model.Open(ProceduralSource(), SmallStudy());
  EXPECT_FALSE(this->model.History()->canUndo());
  EXPECT_EQ(this->model.CurrentScene().camera.zoom, 1.0);
}
