// Sessions on disk: they read back as written, and an autosaved copy exists until the end.

#include "LabelledStudy.h"
#include "OverlaidStudy.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Segments/LabelMap.h"
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
  QString copies = folder.filePath("sub");
  QString path = folder.filePath("sub/autosaved.json");
  SceneModel model;
};

}

TEST_F(Sessions, AreRestoredAsTheyWere)
{
  this->model.Edit(ScenePart::Measures, "measure",
    [](Scene& scene) {
      scene.measures = { { MeasureKind::Distance, { { 1.0, 2.0, 3.0 }, { 4.0, 5.0, 6.0 } } } };
    });
  const QString file = this->folder.filePath("scene.json");
  WriteScene(this->model.CurrentScene(), file);
  SceneModel restored;
  restored.Restore(ReadScene(file.toStdString()), SmallStudy());
  ASSERT_EQ(restored.CurrentScene().measures.size(), 1);
  EXPECT_EQ(restored.CurrentScene().look.opacities.size(),
    this->model.CurrentScene().look.opacities.size());
  EXPECT_FALSE(restored.History()->canUndo());
}

TEST_F(Sessions, AreSavedDuringEditsAndDeletedAfterANormalExit)
{
  Autosave autosave(&this->model, this->copies);
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

TEST_F(Sessions, KeepShadows)
{
  this->model.Edit(ScenePart::Lights, "shadows", [](Scene& scene) { scene.shadows = 1.0; });
  EXPECT_TRUE(
    WorkText(this->model.CurrentScene(), *this->model.CurrentStudy()).contains("shadows"));
}

TEST_F(Sessions, KeepScattering)
{
  this->model.Edit(
    ScenePart::Lights, "scattering", [](Scene& scene) { scene.scattering.blending = 0.5; });
  EXPECT_TRUE(
    WorkText(this->model.CurrentScene(), *this->model.CurrentStudy()).contains("scattering"));
}

TEST_F(Sessions, KeepAmbientOcclusion)
{
  this->model.Edit(
    ScenePart::Lights, "occlusion", [](Scene& scene) { scene.occlusion.strength = 0.5; });
  EXPECT_TRUE(
    WorkText(this->model.CurrentScene(), *this->model.CurrentStudy()).contains("occlusion"));
}

TEST_F(Sessions, AreAutosavedApartByViewersThatRunAtOnce)
{
  this->model.Edit(ScenePart::Camera, "zoom", [](Scene& scene) { scene.camera.zoom = 2.5; });
  auto first = std::make_unique<Autosave>(&this->model, this->copies);
  first->Save();
  SceneModel other;
  other.Open(ProceduralSource(), SmallStudy());
  Autosave second(&other, this->copies);
  EXPECT_FALSE(second.HasCopy()) << "the copy of a running viewer is not the rest of a crash";
  second.Save();
  EXPECT_EQ(ReadScene(first->Path().toStdString()).camera.zoom, 2.5);
  second.Remove();
  EXPECT_TRUE(first->HasCopy());

  // The end without Remove is that of a crash.
  first.reset();
  SceneModel later;
  EXPECT_TRUE(Autosave(&later, this->copies).HasCopy());
}

TEST_F(Sessions, AreAutosavedWithTheSegmentsThatWereDrawn)
{
  Autosave autosave(&this->model, this->copies);
  const auto drawnVoxels = [this]
  {
    Scene saved;
    return QTest::qWaitFor(
             [&]
             {
               if (QFile::exists(this->path))
               {
                 saved = ReadScene(this->path.toStdString());
               }
               return saved.labels.has_value();
             },
             30000)
      ? LoadLabels(*saved.labels, this->model.CurrentStudy()->volume).sizes.at(0).voxels
      : -1;
  };
  this->model.AddSegment("tumour", "new segment");
  this->model.ChangeLabels({ { 3, 5, 2, 2, 1, 1 }, { 0, 0, 0 }, { 1, 1, 1 } }, "paint");
  autosave.Save();
  EXPECT_EQ(drawnVoxels(), 3);
  EXPECT_EQ(ReadScene(this->path.toStdString()).labels->segments[0].name, "tumour");
  this->model.History()->undo();
  QFile::remove(this->path);
  autosave.Save();
  EXPECT_EQ(drawnVoxels(), 0);

  // A file that the user has saved is named, and the copy goes.
  this->model.TakeSavedLabels(
    "/scans/tumour.seg.nrrd", this->model.CurrentScene().labels->segments, "save");
  autosave.Save();
  EXPECT_EQ(ReadScene(this->path.toStdString()).labels->path, "/scans/tumour.seg.nrrd");
  EXPECT_FALSE(QFile::exists(autosave.SegmentsPath()));
}

TEST_F(Sessions, NeverNameTheSegmentsOfAnotherScan)
{
  Autosave autosave(&this->model, this->copies);
  this->model.AddSegment("tumour", "new segment");
  autosave.Save();
  ASSERT_TRUE(QTest::qWaitFor([&] { return autosave.HasCopy(); }, 30000));
  this->model.AddSegment("of the first scan", "new segment");
  autosave.Save(); // the thread writes while another scan is opened
  this->model.Open(ProceduralSource(), SmallStudy());
  this->model.AddSegment("of the second scan", "new segment");
  QFile::remove(this->path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return autosave.HasCopy(); }, 30000));
  EXPECT_FALSE(ReadScene(this->path.toStdString()).labels) << "they are in no file yet";
  const auto named = [this] { return ReadScene(this->path.toStdString()).labels.has_value(); };
  ASSERT_TRUE(QTest::qWaitFor(named, 30000));
  EXPECT_EQ(ReadScene(this->path.toStdString()).labels->segments[0].name, "of the second scan");
}

TEST_F(Sessions, HaveNoFilesWhereTheFolderCannotBeWrittenTo)
{
  const QString file = this->folder.filePath("file");
  ASSERT_TRUE(QFile(file).open(QFile::WriteOnly));
  const Autosave autosave(&this->model, file + "/sub");
  EXPECT_TRUE(autosave.Path().isEmpty());
  EXPECT_TRUE(autosave.SegmentsPath().isEmpty());
}

TEST_F(Sessions, LeaveNoSegmentsAfterANormalExit)
{
  QString segments;
  {
    Autosave autosave(&this->model, this->copies);
    segments = autosave.SegmentsPath();
    this->model.AddSegment("tumour", "new segment");
    autosave.Save();
    ASSERT_TRUE(QTest::qWaitFor([&] { return autosave.HasCopy(); }, 30000));
    EXPECT_TRUE(QFile::exists(segments));
    this->model.ChangeLabels({ { 3, 3, 2, 2, 1, 1 }, { 0 }, { 1 } }, "paint");
    autosave.Save(); // the thread writes while the program ends
    autosave.Remove();
  }
  EXPECT_TRUE(QTest::qWaitFor([&] { return !QFile::exists(segments); }, 30000));
}

TEST_F(Sessions, AreAutosavedWhereOnlyTheUserReads)
{
  const Autosave autosave(&this->model, this->copies);
  const auto others = QFile::ReadGroup | QFile::ExeGroup | QFile::ReadOther | QFile::ExeOther;
  EXPECT_FALSE(QFile::permissions(this->copies) & others);
}

TEST_F(Sessions, KeepThePermissionsOfTheFileTheyReplace)
{
  const QString file = this->folder.filePath("private.json");
  WriteScene(Scene(), file);
  ASSERT_TRUE(QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner));
  WriteScene(this->model.CurrentScene(), file);
  EXPECT_FALSE(QFile::permissions(file) & (QFile::ReadGroup | QFile::ReadOther));
}

TEST_F(Sessions, ThatCouldNotBeOpenedAgainLeaveTheFileAsItWas)
{
  const QString file = this->folder.filePath("session.json");
  WriteScene(this->model.CurrentScene(), file);
  Scene large = this->model.CurrentScene();
  const std::vector<std::array<double, 3>> points(2000000);
  large.measures = { { MeasureKind::Freehand, points } };
  EXPECT_THROW(WriteScene(large, file), std::runtime_error);
  EXPECT_TRUE(ReadScene(file.toStdString()).measures.empty());
}

TEST_F(Sessions, AreAutosavedWithTheSegmentsOfEachVolume)
{
  Autosave autosave(&this->model, this->copies);
  this->model.AddSegment("tumour", "new segment");
  AddPet(this->model);
  this->model.AddSegment("hot spot", "new segment");
  this->model.ChangeLabels({ { 3, 5, 2, 2, 1, 1 }, { 0, 0, 0 }, { 1, 1, 1 } }, "paint", 1);
  autosave.Save();
  ASSERT_TRUE(QTest::qWaitFor([&] { return autosave.HasCopy(); }, 30000));
  const Scene saved = ReadScene(this->path.toStdString());
  ASSERT_TRUE(saved.labels && saved.overlays.at(0).labels);
  const SceneLabels& ofPet = *saved.overlays[0].labels;
  EXPECT_NE(saved.labels->path, ofPet.path);
  EXPECT_EQ(ofPet.segments[0].name, "hot spot");
  const LabelMap map = LoadLabels(ofPet, this->model.CurrentStudy()->overlays[0]->volume);
  EXPECT_EQ(map.sizes.at(0).voxels, 3);
  this->model.RemoveOverlay(0, "remove");
  autosave.Save();
  EXPECT_FALSE(QFile::exists(QString::fromStdString(ofPet.path)));
  EXPECT_TRUE(QFile::exists(QString::fromStdString(saved.labels->path)));
}

// While a file is written, the last copy must not name it for other segments.
TEST_F(Sessions, KeepTheFilesOfSegmentsWhenVolumesChangePlaces)
{
  Autosave autosave(&this->model, this->copies);
  for (const char* const name : { "first", "second" })
  {
    AddPet(this->model, name);
    this->model.AddSegment(name, "new segment");
  }
  autosave.Save();
  ASSERT_TRUE(QTest::qWaitFor([&] { return autosave.HasCopy(); }, 30000));
  const Scene before = ReadScene(this->path.toStdString());
  ASSERT_NE(before.overlays.at(0).labels->path, before.overlays.at(1).labels->path);
  this->model.MoveOverlay(0, 1, "move");
  autosave.Save();
  const Scene after = ReadScene(this->path.toStdString());
  EXPECT_EQ(after.overlays.at(0).labels->path, before.overlays[1].labels->path);
  EXPECT_EQ(after.overlays.at(1).labels->path, before.overlays[0].labels->path);
  EXPECT_EQ(after.overlays[0].labels->segments.at(0).name, "second");
}
