// Loading in a thread ends in exactly one way, also when it is cancelled or destroyed.

#include "Module/PhantomFiles.h"
#include "SilentFile.h"
#include "Viewer/Model/MemoryLimit.h"
#include "Viewer/Model/RecentScans.h"
#include "Viewer/Model/VolumeLoader.h"
#include "Viewer/Model/VolumeRequests.h"
#include "Waiting.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

#include <filesystem>

using namespace varimarch;

namespace
{

class Loading : public testing::Test
{
protected:
  int Ends() const
  {
    return this->loaded.count() + this->labelled.count() + this->found.count() +
      this->failed.count() + this->cancelled.count();
  }

  /// Writes slices of the phantom to a folder, as a separate series.
  void WriteSeries(const std::string& uid, int sliceCount)
  {
    DicomOptions options;
    options.seriesUid = uid;
    options.description = "Series " + uid;
    for (int slice = 0; slice < sliceCount; ++slice)
    {
      this->folder.Write("disc/" + uid + "-" + std::to_string(slice),
        DicomBytes(phantom::Stored(0), slice, options));
    }
  }

  TemporaryFolder folder;
  VolumeLoader loader;
  QSignalSpy loaded{ &this->loader, &VolumeLoader::Loaded };
  QSignalSpy labelled{ &this->loader, &VolumeLoader::LabelsLoaded };
  QSignalSpy found{ &this->loader, &VolumeLoader::SeriesFound };
  QSignalSpy failed{ &this->loader, &VolumeLoader::Failed };
  QSignalSpy cancelled{ &this->loader, &VolumeLoader::Cancelled };
};

const ProceduralSource SmallVolume{ ProceduralKind::Shells, { 16, 16, 16 }, 1 };

}

TEST_F(Loading, LeavesVoxelsInTheirFileThatDoNotFitInTheMemoryOfTheUser)
{
  const std::string path = this->folder.Write("large.raw", "");
  std::filesystem::resize_file(path, 512 << 20);
  FileSource source{ path, RawLayout{ { 1024, 1024, 512 } } };
  ChooseMemoryGigabytes(2);
  this->loader.Load(source);
  ASSERT_TRUE(this->loaded.wait(10 * MostMilliseconds));
  ChooseMemoryGigabytes(0);
  const auto study = this->loaded.first()[1].value<std::shared_ptr<const Study>>();
  EXPECT_TRUE(study->volume.isOnDisk);
  const auto kept = this->loaded.first()[0].value<VolumeSource>();
  EXPECT_EQ(std::get<FileSource>(kept).memoryMegabytes, 0.0) << "belongs to the computer";
}

TEST_F(Loading, ShowsACoarseCopyBeforeAVolumeThatTakesLong)
{
  const std::string path = this->folder.Write("large.raw", "1"); // a stored voxel in a hole
  std::filesystem::resize_file(path, 512 << 20);
  const FileSource source{ path, RawLayout{ { 1024, 1024, 512 } } };
  const QSignalSpy previewed(&this->loader, &VolumeLoader::Previewed);
  ChooseMemoryGigabytes(2);
  for (const int expected : { 1, 1 }) // the ranges are there the second time
  {
    this->loader.Load(source);
    ASSERT_TRUE(this->loaded.wait(10 * MostMilliseconds));
    EXPECT_EQ(previewed.count(), expected);
  }
  ChooseMemoryGigabytes(0);
  const auto copy = previewed.first()[1].value<std::shared_ptr<const Study>>();
  EXPECT_TRUE(copy->volume.isPreview);
  EXPECT_FALSE(copy->volume.isOnDisk);
  EXPECT_EQ(copy->volume.image->GetDimensions()[0], 256);
  EXPECT_FALSE(this->loaded.last()[1].value<std::shared_ptr<const Study>>()->volume.isPreview);
}

TEST_F(Loading, ReadsNoCoarseCopyThatIsOfNoUse)
{
  const std::string path = this->folder.Write("large.raw", "1");
  std::filesystem::resize_file(path, 512 << 20);
  const QSignalSpy previewed(&this->loader, &VolumeLoader::Previewed);
  ChooseMemoryGigabytes(2);
  VolumeWish wish = { FileSource{ path, RawLayout{ { 1024, 1024, 512 } } }, {}, {}, {} };
  wish.isForItself = false;
  this->loader.Load(wish);
  ASSERT_TRUE(this->loaded.wait(10 * MostMilliseconds));
  ChooseMemoryGigabytes(0);
  EXPECT_EQ(previewed.count(), 0);
}

TEST_F(Loading, BringsTheVolumeAndItsStatistics)
{
  this->loader.Load(SmallVolume);
  EXPECT_TRUE(this->loader.IsLoading());
  ASSERT_TRUE(this->loaded.wait(MostMilliseconds));
  EXPECT_FALSE(this->loader.IsLoading());
  const auto study = this->loaded.first()[1].value<std::shared_ptr<const Study>>();
  EXPECT_EQ(study->volume.image->GetNumberOfPoints(), 16 * 16 * 16);
  EXPECT_EQ(study->statistics.Largest(), study->volume.image->GetScalarRange()[1]);
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, AMissingFileFailsWithItsName)
{
  this->loader.Load(FileSource{ "/missing/head.nrrd", std::nullopt });
  ASSERT_TRUE(this->failed.wait(MostMilliseconds));
  EXPECT_TRUE(this->failed.first().first().toString().contains("/missing/head.nrrd"));
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, SeveralSeriesAreListedTheLargestFirst)
{
  this->WriteSeries("1.2.33", 2);
  this->WriteSeries("1.2.44", 3);
  this->loader.Load(FileSource{ this->folder.Path("disc"), std::nullopt });
  ASSERT_TRUE(this->found.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 1);
  const auto series = this->found.first()[1].value<std::vector<SeriesSummary>>();
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].uid, "1.2.44");
  EXPECT_EQ(series[0].imageCount, 3);
  EXPECT_EQ(series[1].description, "Series 1.2.33");
  EXPECT_EQ(series[1].modality, "CT");
  EXPECT_EQ(series[1].middle.pixels.size(), 20u) << "the pixels of a slice";

  this->loader.Load(FileSource{ this->folder.Path("disc"), std::nullopt, "1.2.33" });
  ASSERT_TRUE(this->loaded.wait(MostMilliseconds));
  const auto study = this->loaded.first()[1].value<std::shared_ptr<const Study>>();
  EXPECT_EQ(study->volume.image->GetDimensions()[2], 2);
}

TEST_F(Loading, FindsTheSeriesOfADigestOrListsAll)
{
  this->WriteSeries("1.2.33", 2);
  this->WriteSeries("1.2.44", 3);
  const FileSource disc{ this->folder.Path("disc"), std::nullopt };
  this->loader.Load(disc, DigestOfSeries("1.2.33"));
  ASSERT_TRUE(this->loaded.wait(MostMilliseconds));
  const auto source = this->loaded.first()[0].value<VolumeSource>();
  EXPECT_EQ(std::get<FileSource>(source).series, "1.2.33");
  EXPECT_EQ(this->Ends(), 1);
  this->loader.Load(disc, DigestOfSeries("1.2.55"));
  ASSERT_TRUE(this->found.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 2);
}

TEST_F(Loading, DoesNotReplaceAMissingSeriesByTheOnlyOne)
{
  this->WriteSeries("1.2.33", 2);
  this->loader.Load(
    FileSource{ this->folder.Path("disc"), std::nullopt }, DigestOfSeries("1.2.55"));
  ASSERT_TRUE(this->found.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, AFolderWithOneSeriesNeedsNoChoice)
{
  this->WriteSeries("1.2.33", 3);
  this->loader.Load(FileSource{ this->folder.Path("disc"), std::nullopt });
  ASSERT_TRUE(this->loaded.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, PutsLabelsOverAScan)
{
  const FileSource file{ this->folder.Write("a.nii", NiftiBytes(phantom::Stored(0))),
    std::nullopt };
  this->loader.Load(file);
  ASSERT_TRUE(this->loaded.wait(MostMilliseconds));
  const auto scan = this->loaded.first()[1].value<std::shared_ptr<const Study>>();
  this->loader.LoadLabels({ file.path }, scan);
  ASSERT_TRUE(this->labelled.wait(MostMilliseconds));
  EXPECT_EQ(this->labelled.first()[0].value<SceneLabels>().path, file.path);
  const auto study = this->labelled.first()[1].value<std::shared_ptr<const Study>>();
  EXPECT_EQ(study->volume.image, scan->volume.image);
  EXPECT_EQ(study->segmentStatistics.size(), study->labels->segments.size());
  EXPECT_EQ(study->segmentStatistics[0].mean, study->labels->segments[0].value);
  this->loader.LoadLabels({ this->folder.Path("missing.nii") }, scan);
  ASSERT_TRUE(this->failed.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 3);
}

TEST_F(Loading, CancellingEmitsNoVolume)
{
  this->loader.Load(SmallVolume);
  this->loader.Cancel();
  ASSERT_TRUE(this->cancelled.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, FromADiskThatDoesNotAnswerEndsWhenItIsCancelled)
{
  const FileSource source{ this->folder.Write("a.nii", NiftiBytes(phantom::Stored(0))),
    std::nullopt };
  const SilentFile file(source.path);
  if (!file.IsSilent())
  {
    GTEST_SKIP() << "the file system has no leases";
  }
  this->loader.Load(source);
  EXPECT_FALSE(this->loaded.wait(500));
  this->loader.Cancel();
  ASSERT_TRUE(this->cancelled.wait(MostMilliseconds));
  EXPECT_FALSE(this->loader.IsLoading());
  this->loader.Load(SmallVolume);
  ASSERT_TRUE(this->loaded.wait(MostMilliseconds));
  this->loader.Load(source);
  this->loader.Load(SmallVolume);
  ASSERT_TRUE(this->loaded.wait(MostMilliseconds));
  EXPECT_EQ(this->loaded.count(), 2);
  EXPECT_EQ(this->Ends(), 4);
}

TEST_F(Loading, ANewRequestCancelsTheLast)
{
  this->loader.Load(SmallVolume);
  this->loader.Load(SmallVolume);
  EXPECT_EQ(this->cancelled.count(), 1);
  ASSERT_TRUE(this->loaded.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 2);
}

TEST(LoaderThatIsDestroyed, WaitsForItsThread)
{
  VolumeLoader loader;
  loader.Load(ProceduralSource{ ProceduralKind::Torso, { 64, 64, 64 }, 1 });
}
