// Exported pictures: their size, what is transparent, and the scene in their text.

#include "Scene/SceneFile.h"
#include "SmallStudy.h"
#include "Viewer/View/PictureExport.h"

#include <gtest/gtest.h>

using namespace varimarch;

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
  Scene scene = SceneOfPatient();
  scene.volume = FileSource{ "/scans/DOE^JOHN/head.nrrd", std::nullopt, "1.2.840.99" };
  scene.look.name = "bone of DOE";
  scene.look.description = "as DOE needs it";
  scene.distances.push_back({ { 0.0, 0.0, 0.0 }, { 30.0, 40.0, 0.0 }, "DOE" });
  const QString text = PictureMaker(scene, study->volume.image, { { 32, 32 }, false, false })
                         .Draw()
                         .text("varimarch-scene");
  EXPECT_FALSE(text.contains("DOE")) << text.toStdString();
  EXPECT_FALSE(text.contains("1.2.840.99"));
  const Scene back = SceneFromText(text.toStdString(), "picture");
  EXPECT_EQ(back.look.opacities.size(), 2);
  EXPECT_EQ(back.distances.size(), 1);
  EXPECT_EQ(back.size, (std::array<int, 2>{ 32, 32 }));
}
