// Exported pictures: their size, what is transparent, and the scene in their text.

#include "Scene/SceneFile.h"
#include "SmallStudy.h"
#include "Viewer/View/PictureExport.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <stdexcept>

using namespace varimarch;

namespace
{

Scene SceneOfPatient()
{
  Scene scene;
  scene.volume = FileSource{ "/scans/DOE^JOHN/head.nrrd", std::nullopt };
  scene.look.colors = { { 0.0, { 1.0, 1.0, 1.0 } } };
  scene.look.opacities = { { 100.0, 0.0 }, { 300.0, 0.8 } };
  scene.background = { 0.0, 0.0, 1.0 };
  return scene;
}

}

TEST(ExportedPicture, HasTheSizeAndTheBackgroundThatAreAskedFor)
{
  const auto study = SmallStudy();
  const QImage onBackground =
    PictureMaker(SceneOfPatient(), study->volume.image, { { 120, 80 }, false, false }).Draw();
  EXPECT_EQ(onBackground.size(), QSize(120, 80));
  EXPECT_EQ(onBackground.pixelColor(0, 0), QColor(0, 0, 255));
  const QImage transparent =
    PictureMaker(SceneOfPatient(), study->volume.image, { { 120, 80 }, true, false }).Draw();
  EXPECT_EQ(transparent.pixelColor(0, 0).alpha(), 0);
  EXPECT_GT(transparent.pixelColor(60, 40).alpha(), 200) << "the spine";
}

TEST(ExportedPicture, TellsHowItWasMadeAndNotOfWhom)
{
  const auto study = SmallStudy();
  const Scene scene = SceneOfPatient();
  const QString text = PictureMaker(scene, study->volume.image, { { 32, 32 }, false, false })
                         .Draw()
                         .text("varimarch-scene");
  EXPECT_FALSE(text.contains("DOE"));
  const Scene back = SceneFromText(text.toStdString(), "picture");
  EXPECT_EQ(back.look.opacities.size(), 2);
  EXPECT_EQ(back.size, (std::array<int, 2>{ 32, 32 }));
}

namespace
{

class Turning : public testing::Test
{
protected:
  bool Write(const QString& name, int stopAfter = 100)
  {
    PictureMaker maker(SceneOfPatient(), this->study->volume.image, { { 48, 48 }, false, false });
    int pictures = 0;
    return WriteTurntable(
      maker, 4, this->folder.filePath(name), [&](double) { return pictures++ < stopAfter; });
  }

  QStringList Files() const { return QDir(this->folder.path()).entryList(QDir::Files); }

  std::shared_ptr<const Study> study = SmallStudy();
  QTemporaryDir folder;
};

}

TEST_F(Turning, WritesAPictureForEachStepOfAWholeTurn)
{
  EXPECT_TRUE(this->Write("turn.png"));
  EXPECT_EQ(
    this->Files(), QStringList({ "turn-000.png", "turn-001.png", "turn-002.png", "turn-003.png" }));
  const auto picture = [&](int i)
  { return QImage(this->folder.filePath(QStringLiteral("turn-00%1.png").arg(i))); };
  EXPECT_NE(picture(0), picture(1));
  EXPECT_NE(picture(0), picture(2));
}

TEST_F(Turning, WritesAMovie)
{
  EXPECT_TRUE(this->Write("turn.ogv"));
  ASSERT_EQ(this->Files(), QStringList("turn.ogv"));
  QFile movie(this->folder.filePath("turn.ogv"));
  movie.open(QIODevice::ReadOnly);
  EXPECT_EQ(movie.read(4), "OggS");
}

TEST_F(Turning, LeavesNothingWhenItIsStopped)
{
  EXPECT_FALSE(this->Write("turn.png", 2));
  EXPECT_FALSE(this->Write("turn.ogv", 2));
  EXPECT_TRUE(this->Files().isEmpty());
}

TEST_F(Turning, NamesAFileThatCannotBeWritten)
{
  EXPECT_THROW(this->Write("missing/turn.png"), std::runtime_error);
}
