// Loading in a thread: it ends in exactly one of three ways, also when it is stopped or left.

#include "Viewer/Model/VolumeLoader.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

constexpr int MostMilliseconds = 30000;

class Loading : public testing::Test
{
protected:
  int Ends() const { return this->loaded.count() + this->failed.count() + this->cancelled.count(); }

  VolumeLoader loader;
  QSignalSpy loaded{ &this->loader, &VolumeLoader::Loaded };
  QSignalSpy failed{ &this->loader, &VolumeLoader::Failed };
  QSignalSpy cancelled{ &this->loader, &VolumeLoader::Cancelled };
};

const ProceduralSource SmallVolume{ ProceduralKind::Shells, { 16, 16, 16 }, 1 };

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

TEST_F(Loading, OfAMissingFileFailsWithItsName)
{
  this->loader.Load(FileSource{ "/missing/head.nrrd", std::nullopt });
  ASSERT_TRUE(this->failed.wait(MostMilliseconds));
  EXPECT_TRUE(this->failed.first().first().toString().contains("/missing/head.nrrd"));
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, ThatIsCancelledBringsNothing)
{
  this->loader.Load(SmallVolume);
  this->loader.Cancel();
  ASSERT_TRUE(this->cancelled.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, OfAnotherVolumeEndsTheLast)
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
