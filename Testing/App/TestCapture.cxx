#include "Module/Files/PhantomFiles.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

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
  const auto banded = this->view.FloatImage(
    [&](double)
    {
      ++bands;
      return true;
    });
  EXPECT_EQ(bands, 4);
  const auto* a = static_cast<const float*>(whole->GetScalarPointer());
  const auto* b = static_cast<const float*>(banded->GetScalarPointer());
  for (int i = 0; i < 4 * 70 * 50; ++i)
  {
    ASSERT_EQ(a[i], b[i]) << "channel " << i;
  }
}

TEST_F(Capture, IsCancelledBetweenBands)
{
  int bands = 0;
  EXPECT_EQ(this->view.FloatImage([&](double) { return ++bands < 3; }), nullptr);
  EXPECT_EQ(bands, 3);
  const auto after = this->view.FloatImage();
  const auto fresh = OffscreenView(this->scene, this->volume, MapperKind::Varimarch).FloatImage();
  const auto* const a = static_cast<const float*>(after->GetScalarPointer());
  EXPECT_TRUE(std::equal(a, a + 4 * 70 * 50, static_cast<const float*>(fresh->GetScalarPointer())));
}

TEST_F(Capture, IsStoppedDuringTheSearchForSteps)
{
  auto* const mapper = vtkVariationFieldVolumeMapper::SafeDownCast(this->view.Pipeline().Mapper());
  EXPECT_FALSE(this->view.RenderWhile([] { return false; }));
  EXPECT_EQ(mapper->GetToleranceSearches(), 0);
  EXPECT_TRUE(this->view.RenderWhile([] { return true; }));
  EXPECT_EQ(mapper->GetToleranceSearches(), 1);
  OffscreenView fresh(this->scene, this->volume, MapperKind::Varimarch);
  fresh.Render();
  const auto a = this->view.Bytes();
  const auto b = fresh.Bytes();
  const auto* const bytes = static_cast<const unsigned char*>(a->GetScalarPointer());
  EXPECT_TRUE(std::equal(bytes, bytes + a->GetNumberOfPoints() * a->GetNumberOfScalarComponents(),
    static_cast<const unsigned char*>(b->GetScalarPointer())));
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

// Images of a refined level begin with the coarse level, of which no band may be left.
TEST(CaptureOfRefinedLevels, HasTheSameLevelsInAllBands)
{
  Scene scene = SmallTorso();
  scene.look.shading.enabled = false;
  scene.look.opacities = { { -1000.0, 0.0 }, { 1000.0, 0.05 } };
  scene.render.level = VolumeLevel::Refined;
  const auto torso = ProceduralVolume(std::get<ProceduralSource>(scene.volume));
  vtkDataArray* const scalars = torso->GetPointData()->GetScalars();
  const TemporaryFolder folder;
  const std::string path = folder.Write("torso.raw",
    { static_cast<const char*>(scalars->GetVoidPointer(0)),
      std::size_t(scalars->GetNumberOfValues() * scalars->GetDataTypeSize()) });
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetRawDimensions(torso->GetDimensions());
  reader->SetRawScalarType(scalars->GetDataType());
  reader->SetRawSpacing(torso->GetSpacing());
  constexpr vtkIdType TooLittle = 100000;
  reader->SetMaximumHostMemory(TooLittle);
  reader->Update();
  OffscreenView view(scene, reader->GetOutput(), MapperKind::Varimarch);
  const auto banded = view.FloatImage([](double) { return true; });
  const auto whole = view.FloatImage();
  const auto* a = static_cast<const float*>(banded->GetScalarPointer());
  const auto* b = static_cast<const float*>(whole->GetScalarPointer());
  EXPECT_TRUE(std::equal(a, a + 4 * banded->GetNumberOfPoints(), b));
  auto* const mapper = vtkVariationFieldVolumeMapper::SafeDownCast(view.Pipeline().Mapper());
  EXPECT_EQ(mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::RefinedLevel);
}

}
