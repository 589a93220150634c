#include "Scene/OffscreenView.h"
#include "Scene/Presets.h"
#include "Scene/ProceduralVolume.h"

#include <vtkMath.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

Scene SmallTorso()
{
  Scene scene;
  scene.volume = ProceduralSource{ ProceduralKind::Torso, { 48, 40, 32 }, 1 };
  scene.look = BuiltInPreset("ct-bone").look;
  scene.size = { 70, 50 };
  scene.background = { 0.2, 0.4, 0.6 };
  return scene;
}

class Capture : public testing::Test
{
protected:
  Scene scene = SmallTorso();
  vtkSmartPointer<vtkImageData> volume =
    ProceduralVolume(std::get<ProceduralSource>(this->scene.volume));
  OffscreenView view{ this->scene, this->volume, MapperKind::Varimarch };
};

TEST_F(Capture, BandsMakeTheSamePicture)
{
  const auto whole = this->view.FloatImage();
  int bands = 0;
  const auto banded = this->view.FloatImage([&](double) { ++bands; });
  EXPECT_EQ(bands, 4);
  const auto* a = static_cast<const float*>(whole->GetScalarPointer());
  const auto* b = static_cast<const float*>(banded->GetScalarPointer());
  for (int i = 0; i < 4 * 70 * 50; ++i)
  {
    ASSERT_EQ(a[i], b[i]) << "channel " << i;
  }
}

TEST_F(Capture, IsPremultipliedAndWithoutBackground)
{
  const auto picture = this->view.FloatImage();
  EXPECT_EQ(picture->GetScalarComponentAsFloat(0, 0, 0, 3), 0.0f);
  EXPECT_EQ(picture->GetScalarComponentAsFloat(0, 0, 0, 2), 0.0f);
  EXPECT_GT(picture->GetScalarComponentAsFloat(35, 25, 0, 3), 0.5f);
}

TEST_F(Capture, AgreesWithTheWindow)
{
  const auto picture = this->view.FloatImage();
  this->view.Render();
  const auto bytes = this->view.Bytes();
  for (int y = 0; y < 50; ++y)
  {
    for (int x = 0; x < 70; ++x)
    {
      const double alpha = picture->GetScalarComponentAsDouble(x, y, 0, 3);
      const double blue = picture->GetScalarComponentAsDouble(x, y, 0, 2);
      const double expected = 255.0 * (blue + (1.0 - alpha) * this->scene.background[2]);
      ASSERT_NEAR(bytes->GetScalarComponentAsDouble(x, y, 0, 2), expected, 2.0);
    }
  }
}

}
