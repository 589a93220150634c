// Loading ends in exactly one way, also when it is cancelled, replaced or destroyed, and does with
// its result what the request says.

#include "LabelledStudy.h"
#include "Module/Files/PhantomFiles.h"
#include "SilentFile.h"
#include "SmallStudy.h"
#include "Viewer/Model/RecentScans.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/Open/LoadController.h"
#include "Waiting.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <thread>

using namespace varimarch;

namespace
{

/// A model into which a controller loads.
class LoadingInto : public testing::Test
{
protected:
  /// @param read  as ReadRequest
  explicit LoadingInto(decltype(LoadController::Context::read) read = ReadRequest)
    : loader({ &this->model, &this->work,
        [this]
        {
          ++this->questions;
          return this->mayLeaveScan;
        },
        std::move(read) })
  {
  }

  int Ends() const
  {
    return this->opened.count() + this->added.count() + this->formShown.count() +
      this->labelled.count() + this->found.count() + this->labelsFound.count() +
      this->failed.count() + this->cancelled.count();
  }

  std::shared_ptr<const Study> Shown() const { return this->model.CurrentStudy(); }

  TemporaryFolder folder;
  SceneModel model;
  Autosave autosave{ &this->model, QString::fromStdString(this->folder.Path("copies")) };
  SavedWork work{ &this->model, &this->autosave };
  bool mayLeaveScan = true;
  int questions = 0;
  LoadController loader;
  QSignalSpy opened{ &this->loader, &LoadController::Opened };
  QSignalSpy added{ &this->loader, &LoadController::Added };
  QSignalSpy formShown{ &this->loader, &LoadController::FormShown };
  QSignalSpy labelled{ &this->loader, &LoadController::LabelsShown };
  QSignalSpy found{ &this->loader, &LoadController::SeriesFound };
  QSignalSpy labelsFound{ &this->loader, &LoadController::LabelsFound };
  QSignalSpy failed{ &this->loader, &LoadController::Failed };
  QSignalSpy cancelled{ &this->loader, &LoadController::Cancelled };
};

class Loading : public LoadingInto
{
protected:
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

  FileSource Disc() { return { this->folder.Path("disc"), std::nullopt }; }

  /// Makes a file of 512 MB, of which only the first voxel is stored.
  FileSource LargeFile()
  {
    const std::string path = this->folder.Write("large.raw", "1");
    std::filesystem::resize_file(path, 512 << 20);
    return { path, RawLayout{ { 1024, 1024, 512 } } };
  }
};

/// The steps of a test's reader, which its threads share.
struct ReaderSteps
{
  std::atomic<bool> mayEnd{ false };
  std::atomic<int> begun{ 0 };
  std::atomic<bool> previews{ false }; ///< shows a coarse copy first
  std::function<LoadResult(const LoadRequest&)> end;
};

/// Loads by a reader that goes on until it is cancelled, or may end.
class LoadingInSteps : public LoadingInto
{
protected:
  LoadingInSteps()
    : LoadingInSteps(std::make_shared<ReaderSteps>())
  {
  }

  bool IsBegun(int count = 1)
  {
    return QTest::qWaitFor([&] { return this->steps->begun >= count; }, MostMilliseconds);
  }

  void ShowTorso()
  {
    this->model.Open(Torso, SmallStudy());
    this->work.TakeAsSaved();
  }

  void Measure()
  {
    this->model.Edit(ScenePart::Measures, "measure",
      [](Scene& scene) {
        scene.measures.push_back(
          { MeasureKind::Distance, { { 0, 0, 0 }, { 30, 40, 0 } }, "aorta" });
      });
  }

  static LoadResult LoadedTorso(const LoadRequest&)
  {
    LoadResult result;
    result.source = Torso;
    result.study = SmallStudy();
    return result;
  }

  static inline const ProceduralSource Torso{ ProceduralKind::Torso, { 32, 28, 20 }, 1 };
  static inline const FileSource Pet{ "/scans/pet.nrrd", std::nullopt };
  std::shared_ptr<ReaderSteps> steps;

private:
  explicit LoadingInSteps(const std::shared_ptr<ReaderSteps>& steps)
    : LoadingInto(
        [steps](const LoadRequest& request, const LoadObserver& observe, const ShowPreview& show)
        {
          ++steps->begun;
          if (steps->previews)
          {
            Study copy = *SmallStudy();
            copy.volume.isPreview = true;
            show(Torso, std::make_shared<const Study>(copy));
          }
          while (!steps->mayEnd)
          {
            if (!observe(0.5))
            {
              throw std::runtime_error("It was cancelled.");
            }
            std::this_thread::yield();
          }
          return steps->end(request);
        })
    , steps(steps)
  {
    steps->end = LoadedTorso;
  }
};

const ProceduralSource SmallVolume{ ProceduralKind::Shells, { 16, 16, 16 }, 1 };

}

TEST_F(Loading, LeavesVoxelsInTheirFileThatDoNotFitInTheMemoryOfTheUser)
{
  const std::string path = this->folder.Write("large.raw", "");
  std::filesystem::resize_file(path, 512 << 20);
  ChooseMemoryGigabytes(2);
  this->loader.Start(NewScan{ FileSource{ path, RawLayout{ { 1024, 1024, 512 } } } });
  ASSERT_TRUE(this->opened.wait(10 * MostMilliseconds));
  ChooseMemoryGigabytes(0);
  EXPECT_TRUE(this->Shown()->volume.isOnDisk);
  const auto kept = this->opened.first()[0].value<VolumeSource>();
  EXPECT_EQ(std::get<FileSource>(kept).memoryMegabytes, 0.0) << "belongs to the computer";
}

TEST_F(Loading, ShowsACoarseCopyBeforeAVolumeThatTakesLong)
{
  const FileSource source = this->LargeFile();
  std::vector<std::shared_ptr<const Study>> copies;
  QObject::connect(&this->loader, &LoadController::Previewed, &this->loader,
    [&] { copies.push_back(this->Shown()); });
  ChooseMemoryGigabytes(2);
  for (const std::size_t expected : { 1, 1 }) // the ranges are there the second time
  {
    this->loader.Start(NewScan{ source });
    ASSERT_TRUE(this->opened.wait(10 * MostMilliseconds));
    EXPECT_EQ(copies.size(), expected);
  }
  ChooseMemoryGigabytes(0);
  EXPECT_TRUE(copies.front()->volume.isPreview);
  EXPECT_FALSE(copies.front()->volume.isOnDisk);
  EXPECT_EQ(copies.front()->volume.image->GetDimensions()[0], 256);
  EXPECT_FALSE(this->Shown()->volume.isPreview);
}

TEST_F(Loading, ReadsNoCoarseCopyThatIsOfNoUse)
{
  ChooseMemoryGigabytes(2);
  int shown = 0;
  const LoadResult result = ReadRequest(AddedScan{ this->LargeFile() }, {},
    [&](const VolumeSource&, const std::shared_ptr<const Study>&) { ++shown; });
  ChooseMemoryGigabytes(0);
  EXPECT_TRUE(result.study);
  EXPECT_EQ(shown, 0);
}

TEST_F(Loading, BringsTheVolumeAndItsStatistics)
{
  this->loader.Start(NewScan{ SmallVolume });
  EXPECT_TRUE(this->loader.IsLoading());
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  EXPECT_FALSE(this->loader.IsLoading());
  const auto study = this->Shown();
  EXPECT_EQ(study->volume.image->GetNumberOfPoints(), 16 * 16 * 16);
  EXPECT_EQ(study->statistics.Largest(), study->volume.image->GetScalarRange()[1]);
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, AMissingFileFailsWithItsName)
{
  this->loader.Start(NewScan{ FileSource{ "/missing/head.nrrd", std::nullopt } });
  ASSERT_TRUE(this->failed.wait(MostMilliseconds));
  EXPECT_TRUE(this->failed.first().first().toString().contains("/missing/head.nrrd"));
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, SeveralSeriesAreListedTheLargestFirst)
{
  this->WriteSeries("1.2.33", 2);
  this->WriteSeries("1.2.44", 3);
  this->loader.Start(NewScan{ this->Disc() });
  ASSERT_TRUE(this->found.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 1);
  const auto request = this->found.first()[0].value<LoadRequest>();
  const auto result = this->found.first()[1].value<LoadResult>();
  ASSERT_EQ(result.series.size(), 2u);
  EXPECT_EQ(result.series[0].uid, "1.2.44");
  EXPECT_EQ(result.series[0].imageCount, 3);
  EXPECT_EQ(result.series[1].description, "Series 1.2.33");
  EXPECT_EQ(result.series[1].modality, "CT");
  EXPECT_EQ(result.series[1].middle.pixels.size(), 20u) << "the pixels of a slice";

  this->loader.Start(WithSeries(request, result, "1.2.33"));
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  EXPECT_EQ(this->Shown()->volume.image->GetDimensions()[2], 2);
}

TEST_F(Loading, FindsTheSeriesOfADigestOrListsAll)
{
  this->WriteSeries("1.2.33", 2);
  this->WriteSeries("1.2.44", 3);
  this->loader.Start(NewScan{ this->Disc(), DigestOfSeries("1.2.33") });
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  const auto source = this->opened.first()[0].value<VolumeSource>();
  EXPECT_EQ(std::get<FileSource>(source).series, "1.2.33");
  EXPECT_EQ(this->Ends(), 1);
  this->loader.Start(NewScan{ this->Disc(), DigestOfSeries("1.2.55") });
  ASSERT_TRUE(this->found.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 2);
}

TEST_F(Loading, DoesNotReplaceAMissingSeriesByTheOnlyOne)
{
  this->WriteSeries("1.2.33", 2);
  this->loader.Start(NewScan{ this->Disc(), DigestOfSeries("1.2.55") });
  ASSERT_TRUE(this->found.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, AFolderWithOneSeriesNeedsNoChoice)
{
  this->WriteSeries("1.2.33", 3);
  this->loader.Start(NewScan{ this->Disc() });
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 1);
}

TEST_F(Loading, PutsLabelsOverAScan)
{
  const FileSource file{ this->folder.Write("a.nii", NiftiBytes(phantom::Stored(0))),
    std::nullopt };
  this->loader.Start(NewScan{ file });
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  const auto scan = this->Shown();
  this->loader.StartLabels({ file.path }, 0);
  ASSERT_TRUE(this->labelled.wait(MostMilliseconds));
  EXPECT_EQ(this->model.CurrentScene().labels->path, file.path);
  const auto study = this->Shown();
  EXPECT_EQ(study->volume.image, scan->volume.image);
  EXPECT_EQ(this->labelled.first()[0].toInt(), int(study->labels->segments.size()));
  EXPECT_EQ(study->segmentStatistics.size(), study->labels->segments.size());
  EXPECT_EQ(study->segmentStatistics[0].mean, study->labels->segments[0].value);
  this->loader.StartLabels({ this->folder.Path("missing.nii") }, 0);
  ASSERT_TRUE(this->failed.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 3);
}

TEST_F(Loading, CancellingShowsNoVolume)
{
  this->loader.Start(NewScan{ SmallVolume });
  this->loader.Cancel();
  ASSERT_TRUE(this->cancelled.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 1);
  EXPECT_FALSE(this->Shown());
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
  this->loader.Start(NewScan{ source });
  EXPECT_FALSE(this->opened.wait(500));
  this->loader.Cancel();
  ASSERT_TRUE(this->cancelled.wait(MostMilliseconds));
  EXPECT_FALSE(this->loader.IsLoading());
  this->loader.Start(NewScan{ SmallVolume });
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  this->loader.Start(NewScan{ source });
  this->loader.Start(NewScan{ SmallVolume });
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  EXPECT_EQ(this->opened.count(), 2);
  EXPECT_EQ(this->Ends(), 4);
}

TEST_F(Loading, ANewRequestCancelsTheLast)
{
  this->loader.Start(NewScan{ SmallVolume });
  this->loader.Start(NewScan{ SmallVolume });
  EXPECT_EQ(this->cancelled.count(), 1);
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 2);
}

TEST_F(Loading, WaitsForItsThreadWhenItIsDestroyed)
{
  LoadController other({ &this->model, &this->work, [] { return true; } });
  other.Start(NewScan{ ProceduralSource{ ProceduralKind::Torso, { 64, 64, 64 }, 1 } });
}

TEST_F(LoadingInSteps, LeavesNothingBehindWhenItIsCancelled)
{
  this->ShowTorso();
  const auto before = this->Shown();
  const QSignalSpy progress(&this->loader, &LoadController::Progress);
  this->loader.Start(AddedScan{ Pet });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !progress.isEmpty(); }, MostMilliseconds));
  this->loader.Cancel();
  EXPECT_TRUE(this->loader.IsLoading()) << "its thread has the memory still";
  ASSERT_TRUE(this->cancelled.wait(MostMilliseconds));
  EXPECT_FALSE(this->loader.IsLoading());
  this->steps->mayEnd = true;
  QTest::qWait(100);
  EXPECT_EQ(this->Ends(), 1);
  EXPECT_EQ(this->Shown(), before);

  this->loader.Start(NewScan{ Torso });
  ASSERT_TRUE(this->opened.wait(MostMilliseconds)) << "it is not taken for an added scan";
  EXPECT_TRUE(this->model.CurrentScene().overlays.empty());
}

TEST_F(LoadingInSteps, LeavesTheSceneIfAnAddedScanFails)
{
  this->ShowTorso();
  this->Measure();
  const auto before = this->Shown();
  const int steps = this->model.History()->count();
  this->steps->end = [](const LoadRequest&) -> LoadResult { throw std::runtime_error("It ends."); };
  this->steps->mayEnd = true;
  this->loader.Start(AddedScan{ Pet });
  ASSERT_TRUE(this->failed.wait(MostMilliseconds));
  EXPECT_EQ(this->failed.first().first().toString(), "It ends.");
  EXPECT_EQ(this->Ends(), 1);
  EXPECT_FALSE(this->loader.IsLoading());
  EXPECT_EQ(this->Shown(), before);
  EXPECT_TRUE(this->model.CurrentScene().overlays.empty());
  EXPECT_EQ(this->model.CurrentScene().measures.size(), 1u);
  EXPECT_EQ(this->model.History()->count(), steps);

  this->steps->end = LoadedTorso;
  this->loader.Start(NewScan{ Torso });
  ASSERT_TRUE(this->opened.wait(MostMilliseconds)) << "it is not taken for an added scan";
}

TEST_F(LoadingInSteps, ReplacesTheRequestBefore)
{
  this->ShowTorso();
  bool isShownAsLoading = false;
  QObject::connect(&this->loader, &LoadController::LoadingChanged, &this->loader,
    [&](bool isLoading) { isShownAsLoading = isLoading; });
  this->loader.Start(AddedScan{ Pet });
  ASSERT_TRUE(this->IsBegun());
  this->loader.Start(NewScan{ Torso });
  EXPECT_EQ(this->cancelled.count(), 1);
  EXPECT_TRUE(this->loader.IsLoading());
  EXPECT_TRUE(isShownAsLoading);
  ASSERT_TRUE(this->IsBegun(2)) << "after the first has ended";
  this->steps->mayEnd = true;
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 2);
  EXPECT_FALSE(isShownAsLoading);
  EXPECT_TRUE(this->model.CurrentScene().overlays.empty());
}

TEST_F(LoadingInSteps, ReadsOnlyTheLatestOfSeveralRequests)
{
  std::vector<LoadRequest> read;
  this->steps->end = [&](const LoadRequest& request)
  {
    read.push_back(request);
    return LoadedTorso(request);
  };
  this->loader.Start(NewScan{ Pet });
  ASSERT_TRUE(this->IsBegun());
  this->loader.Start(AddedScan{ Pet });
  this->loader.Start(NewScan{ Torso });
  EXPECT_EQ(this->cancelled.count(), 2);
  ASSERT_TRUE(this->IsBegun(2));
  this->steps->mayEnd = true;
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<NewScan>(read.front()));
}

TEST_F(LoadingInSteps, SaysThatThereIsNotEnoughMemory)
{
  this->steps->end = [](const LoadRequest&) -> LoadResult { throw std::bad_alloc(); };
  this->steps->mayEnd = true;
  this->loader.Start(NewScan{ Torso });
  ASSERT_TRUE(this->failed.wait(MostMilliseconds));
  EXPECT_EQ(this->failed.first().first().toString(), "There is not enough memory for this volume.");
}

TEST_F(LoadingInSteps, KeepsTheWorkOnACoarseCopyAsUnsaved)
{
  this->steps->previews = true;
  QSignalSpy previewed(&this->loader, &LoadController::Previewed);
  this->loader.Start(NewScan{ Torso });
  ASSERT_TRUE(previewed.wait(MostMilliseconds));
  ASSERT_TRUE(this->Shown()->volume.isPreview);
  EXPECT_TRUE(this->work.IsSaved());
  this->Measure();
  this->steps->mayEnd = true;
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  EXPECT_FALSE(this->Shown()->volume.isPreview);
  EXPECT_EQ(this->model.CurrentScene().measures.size(), 1u);
  EXPECT_FALSE(this->work.IsSaved());
  EXPECT_EQ(this->questions, 0);

  this->steps->previews = false;
  this->loader.Start(NewScan{ Torso });
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  EXPECT_TRUE(this->model.CurrentScene().measures.empty()) << "this is another scan";
  EXPECT_TRUE(this->work.IsSaved());
}

TEST_F(LoadingInSteps, LeavesTheCoarseCopyIfItIsCancelled)
{
  this->steps->previews = true;
  QSignalSpy previewed(&this->loader, &LoadController::Previewed);
  this->loader.Start(NewScan{ Torso });
  ASSERT_TRUE(previewed.wait(MostMilliseconds));
  this->loader.Cancel();
  ASSERT_TRUE(this->cancelled.wait(MostMilliseconds));
  EXPECT_TRUE(this->Shown()->volume.isPreview);
}

TEST_F(LoadingInSteps, AsksBeforeADroppedScanReplacesTheShownOne)
{
  this->ShowTorso();
  const auto before = this->Shown();
  this->steps->mayEnd = true;
  this->mayLeaveScan = false;
  this->loader.StartDropped("/scans/other.nrrd");
  ASSERT_TRUE(QTest::qWaitFor([&] { return this->questions == 1; }, MostMilliseconds));
  EXPECT_EQ(this->Shown(), before);
  EXPECT_EQ(this->Ends(), 0);
  this->mayLeaveScan = true;
  this->loader.StartDropped("/scans/other.nrrd");
  ASSERT_TRUE(this->opened.wait(MostMilliseconds));
  EXPECT_NE(this->Shown(), before);
  EXPECT_EQ(this->questions, 2);
}

TEST_F(LoadingInSteps, LeavesTheChoiceIfADroppedFileMayBeLabels)
{
  this->ShowTorso();
  this->steps->end = [scan = this->Shown()](const LoadRequest& request)
  {
    LoadResult result = LoadedTorso(request);
    const LoadedVolume labels = LabelsOf(scan->volume.image);
    result.labelled = WithLabels(*scan, LabelMapOf(labels, "labels.nrrd", scan->volume));
    result.labels.path = "labels.nrrd";
    return result;
  };
  this->steps->mayEnd = true;
  this->loader.StartDropped("/scans/labels.nrrd");
  ASSERT_TRUE(this->labelsFound.wait(MostMilliseconds));
  EXPECT_EQ(this->Ends(), 1);
  EXPECT_FALSE(this->model.CurrentScene().labels);
  const auto request = this->labelsFound.first()[0].value<LoadRequest>();
  const auto result = this->labelsFound.first()[1].value<LoadResult>();
  this->loader.ShowLabels(request, result);
  EXPECT_EQ(this->model.CurrentScene().labels->path, "labels.nrrd");
  EXPECT_EQ(this->labelled.count(), 1);
  this->loader.ShowAsScan(request, result);
  EXPECT_FALSE(this->model.CurrentScene().labels);
  EXPECT_EQ(this->opened.count(), 1);
}

TEST_F(LoadingInSteps, RestoresAnAutosavedSessionAsUnsaved)
{
  this->ShowTorso();
  this->Measure();
  SavedSession session{ this->model.CurrentScene() };
  this->steps->mayEnd = true;
  for (const bool isAutosaved : { true, false })
  {
    session.isAutosaved = isAutosaved;
    this->loader.Start(session);
    ASSERT_TRUE(this->opened.wait(MostMilliseconds));
    EXPECT_EQ(this->model.CurrentScene().measures.size(), 1u);
    EXPECT_EQ(this->work.IsSaved(), !isAutosaved);
  }
}

TEST(LoadRequest, StaysWhatItWasForAChosenSeries)
{
  LoadResult found;
  found.source = FileSource{ "/disc", std::nullopt };
  found.series.resize(2);
  found.series[1].modality = "SEG";
  SavedSession session;
  session.scene.volume = found.source;
  session.scene.labels = SceneLabels{ "labels.nrrd" };
  const LoadRequest chosen = WithSeries(session, found, "1.2.33");
  ASSERT_TRUE(std::holds_alternative<SavedSession>(chosen));
  const Scene& scene = std::get<SavedSession>(chosen).scene;
  EXPECT_EQ(std::get<FileSource>(scene.volume).series, "1.2.33");
  EXPECT_TRUE(scene.labels);
  EXPECT_TRUE(
    std::holds_alternative<AddedScan>(WithSeries(AddedScan{ found.source }, found, "1.2.33")));
  const LoadRequest scan = WithSeries(ScanOfFiles{ { "/disc/a", "/disc/b" } }, found, "1.2.33");
  ASSERT_TRUE(std::holds_alternative<NewScan>(scan));
  EXPECT_EQ(std::get<NewScan>(scan).segmentations.size(), 1u) << "they are offered later";
}
