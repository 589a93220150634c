// The preset that a file gets by itself shows something of it, whatever its format and size.

#include "Module/Files/GoodFiles.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

// The largest difference of a byte from the background of the picture that a user sees first.
double ContrastOf(const LoadedVolume& volume)
{
  const ImageStatistics statistics(volume.image);
  Scene scene;
  TakePreset(BuiltInPreset(SuggestedPreset(volume, statistics).name), scene);
  scene.size = { 48, 48 };
  OffscreenView view(scene, volume.image, MapperKind::Varimarch);
  view.RenderAll();
  EXPECT_EQ(view.ReasonForNothing(scene), "");
  const vtkSmartPointer<vtkImageData> bytes = view.Bytes();
  double largest = 0.0;
  for (int y = 0; y < 48; ++y)
  {
    for (int x = 0; x < 48; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double byte = bytes->GetScalarComponentAsDouble(x, y, 0, c);
        largest = std::max(largest, std::abs(byte - 255.0 * scene.background[c]));
      }
    }
  }
  return largest;
}

}

TEST(EveryFormat, IsSeenInThePresetThatItGets)
{
  const StoredVolume stored = phantom::Stored(0);
  std::vector<GoodFile> files = MoreGoodFiles();
  files.push_back({ "a.nrrd",
    NrrdHeaderText(stored) + "endian: little\nencoding: raw\n\n" + VoxelBytes(stored) });
  files.push_back(
    { "a.mha", MetaImageHeaderText(stored) + "ElementDataFile = LOCAL\n" + VoxelBytes(stored) });
  files.push_back({ "a.vti", VtiText(stored) });
  files.push_back({ "a.nii", NiftiBytes(stored) });
  files.push_back({ "a.dcm", DicomBytes(stored, 0) });
  for (const GoodFile& file : files)
  {
    SCOPED_TRACE(file.name);
    const TemporaryFolder folder;
    const LoadedVolume volume =
      LoadVolume(FileSource{ folder.Write(file.name, file.bytes), std::nullopt });
    EXPECT_GT(ContrastOf(volume), 40.0);
    const double* const spacing = volume.image->GetSpacing();
    volume.image->SetSpacing(1e-5 * spacing[0], 1e-5 * spacing[1], 1e-5 * spacing[2]);
    EXPECT_GT(ContrastOf(volume), 40.0) << "100000 times as small";
  }
}
