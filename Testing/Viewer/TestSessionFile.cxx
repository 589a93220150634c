// Sessions on disk: they read back as written, and an autosaved copy exists until the end.

#include "LabelledStudy.h"
#include "Scene/SceneFile.h"
#include "Viewer/Model/SessionFile.h"

#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Sessions : public testing::Test
{
protected:
  Sessions() { this->model.Open(ProceduralSource(), SmallStudy()); }

  QTemporaryDir folder;
  QString path = folder.filePath("sub/scene.json");
  SceneModel model;
};

}

TEST_F(Sessions, AreRestoredAsTheyWere)
{
  this->model.Edit(ScenePart::Measures, "measure",
    [](Scene& scene) {
      scene.distances = { { { 1.0, 2.0, 3.0 }, { 4.0, 5.0, 6.0 } } };
    });
  const QString file = this->folder.filePath("scene.json");
  WriteScene(this->model.CurrentScene(), file);
  SceneModel restored;
  restored.Restore(ReadScene(file.toStdString()), SmallStudy());
  ASSERT_EQ(restored.CurrentScene().distances.size(), 1);
  EXPECT_EQ(restored.CurrentScene().look.opacities.size(),
    this->model.CurrentScene().look.opacities.size());
  EXPECT_FALSE(restored.History()->canUndo());
}

TEST_F(Sessions, AreSavedDuringEditsAndDeletedAfterANormalExit)
{
  Autosave autosave(&this->model, this->path);
  EXPECT_FALSE(autosave.HasCopy());
  this->model.Edit(ScenePart::Camera, "zoom", [](Scene& scene) { scene.camera.zoom = 2.5; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return autosave.HasCopy(); }, 30000));
  EXPECT_EQ(ReadScene(this->path.toStdString()).camera.zoom, 2.5);
  autosave.Remove();
  EXPECT_FALSE(autosave.HasCopy());
}

TEST_F(Sessions, KeepSegmentsThatLookOtherThanInTheirFile)
{
  this->model.ShowLabels({ "labels.nrrd" }, LabelledStudy(), "open a segmentation");
  const auto work = [this]
  { return WorkText(this->model.CurrentScene(), *this->model.CurrentStudy()); };
  EXPECT_TRUE(work().isEmpty()) << "it is easily opened again";
  this->model.Edit(
    ScenePart::Segments, "hide", [](Scene& scene) { scene.labels->segments[1].visible = false; });
  EXPECT_TRUE(work().contains("labels.nrrd"));
  this->model.History()->undo();
  EXPECT_TRUE(work().isEmpty());
}
