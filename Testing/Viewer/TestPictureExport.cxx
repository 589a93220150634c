// Exported images: size, transparency, and the scene in their metadata.

#include "Scene/SceneFile.h"
#include "SmallStudy.h"
#include "Viewer/View/PictureExport.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace varimarch;

TEST(ExportedPicture, HasTheRequestedSizeAndBackground)
{
  const auto study = SmallStudy();
  const QImage onBackground =
    PictureMaker(SceneOfPatient(), study->volume, { { 120, 80 }, false, false }).Draw();
  EXPECT_EQ(onBackground.size(), QSize(120, 80));
  EXPECT_EQ(onBackground.pixelColor(0, 0), QColor(0, 0, 255));
  const QImage transparent =
    PictureMaker(SceneOfPatient(), study->volume, { { 120, 80 }, true, false }).Draw();
  EXPECT_EQ(transparent.pixelColor(0, 0).alpha(), 0);
  EXPECT_GT(transparent.pixelColor(60, 40).alpha(), 200) << "the spine";
}

TEST(ExportedPicture, HasANoticeThatIsLegibleOnAnyBackground)
{
  const auto study = SmallStudy();
  for (const double gray : { 0.0, 0.5, 1.0 })
  {
    Scene scene = SceneOfPatient();
    scene.background = { gray, gray, gray };
    const QImage picture =
      PictureMaker(scene, study->volume, { { 800, 600 }, false, false }).Draw();
    int darkest = 255;
    int brightest = 0;
    for (int y = 560; y < 600; ++y)
    {
      for (int x = 0; x < 100; ++x)
      {
        darkest = std::min(darkest, qGray(picture.pixel(x, y)));
        brightest = std::max(brightest, qGray(picture.pixel(x, y)));
      }
    }
    EXPECT_GT(brightest - darkest, 150) << gray;
  }
}

TEST(ExportedPicture, StoresTheSettingsWithoutPatientData)
{
  const auto study = SmallStudy();
  Scene scene = SceneOfPatient();
  scene.volume = FileSource{ "/scans/DOE^JOHN/head.nrrd", std::nullopt, "1.2.840.99" };
  scene.look.name = "bone of DOE";
  scene.look.description = "as DOE needs it";
  scene.distances.push_back({ { 0.0, 0.0, 0.0 }, { 30.0, 40.0, 0.0 }, "DOE" });
  const QString text =
    PictureMaker(scene, study->volume, { { 32, 32 }, false, false }).Draw().text("varimarch-scene");
  EXPECT_FALSE(text.contains("DOE")) << text.toStdString();
  EXPECT_FALSE(text.contains("1.2.840.99"));
  const Scene back = SceneFromText(text.toStdString(), "picture");
  EXPECT_EQ(back.look.opacities.size(), 2);
  EXPECT_EQ(back.distances.size(), 1);
  EXPECT_EQ(back.size, (std::array<int, 2>{ 32, 32 }));
}
