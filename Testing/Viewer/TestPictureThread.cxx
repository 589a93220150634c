#include "LabelledStudy.h"
#include "Scene/Images/OffscreenView.h"
#include "Viewer/View/PictureThread.h"
#include "Viewer/View/VtkPictures.h"
#include "Waiting.h"

#include <QSignalSpy>
#include <QTest>

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkWeakPointer.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

const QSize Pixels(96, 64);
constexpr double PicturesPerSecondAtRest = 0.01;

Scene SceneOfThread()
{
  Scene scene = SceneOfPatient();
  scene.size = { Pixels.width(), Pixels.height() };
  return scene;
}

std::shared_ptr<const Study> StudyOf(const ProceduralSource& source)
{
  LoadedVolume volume = LoadVolume(source);
  ImageStatistics statistics(volume.image);
  return std::make_shared<const Study>(Study{ std::move(volume), std::move(statistics) });
}

std::shared_ptr<const Study> OtherStudy()
{
  return StudyOf({ ProceduralKind::Shells, { 24, 24, 24 }, 1 });
}

QImage WithoutThread(const Scene& scene, const Study& study)
{
  OffscreenView view(scene, study.volume.image, MapperKind::Varimarch);
  view.Pipeline().SetLabels(study.labels);
  vtkVariationFieldVolumeMapper::SafeDownCast(view.Pipeline().Mapper())
    ->SetMaximumAccumulatedPictures(8);
  view.SetPicturesPerSecond(PicturesPerSecondAtRest);
  view.Render();
  return ImageOfBytes(view.Bytes()).convertToFormat(QImage::Format_RGB32);
}

// The first fine picture of what the thread has taken.
QImage PictureOf(PictureThread& thread)
{
  thread.Draw({ Pixels, PicturesPerSecondAtRest });
  const auto isWhole = [&]
  { return !thread.IsBusy() && thread.Last() && thread.Last()->numbers.averaged > 0; };
  const auto drawOn = [&]
  {
    if (!thread.IsBusy() && !isWhole())
    {
      thread.Draw({ Pixels, PicturesPerSecondAtRest, true });
    }
    return isWhole();
  };
  return QTest::qWaitFor(drawOn, MostMilliseconds) ? thread.Last()->image : QImage();
}

/// The root mean square of the differences of all channels, in 1/255.
double DifferenceOf(const QImage& one, const QImage& other)
{
  double sum = 0.0;
  for (int y = 0; y < one.height(); ++y)
  {
    for (int x = 0; x < one.width(); ++x)
    {
      const QColor a = one.pixelColor(x, y);
      const QColor b = other.pixelColor(x, y);
      sum += std::pow(a.red() - b.red(), 2) + std::pow(a.green() - b.green(), 2) +
        std::pow(a.blue() - b.blue(), 2);
    }
  }
  return std::sqrt(sum / (3.0 * one.width() * one.height()));
}

}

TEST(PictureThread, DrawsThePictureOfItsScene)
{
  const auto study = SmallStudy();
  Scene scene = SceneOfThread();
  PictureThread thread;
  thread.Take(ScenePart::Volume, scene, study);
  EXPECT_EQ(PictureOf(thread), WithoutThread(scene, *study));
  scene.look.opacities.back().opacity = 0.2;
  thread.Take(ScenePart::Look, scene, study);
  const QImage before = PictureOf(thread);
  EXPECT_EQ(before, WithoutThread(scene, *study)) << "of another look";
  scene.camera.azimuthDegrees = 40.0;
  thread.Take(ScenePart::Camera, scene, study);
  // The mapper keeps its steps while only the camera moves.
  const QImage turned = PictureOf(thread);
  ASSERT_EQ(turned.size(), before.size());
  EXPECT_LT(DifferenceOf(turned, WithoutThread(scene, *study)), 1.0);
  EXPECT_GT(DifferenceOf(turned, before), 4.0);
}

TEST(PictureThread, ShowsNothingOfAVolumeThatWasReplaced)
{
  const auto study = SmallStudy();
  const auto other = OtherStudy();
  const Scene scene = SceneOfThread();
  PictureThread thread;
  thread.Take(ScenePart::Volume, scene, study);
  ASSERT_FALSE(PictureOf(thread).isNull());
  thread.Take(ScenePart::Volume, scene, other);
  EXPECT_EQ(thread.Last(), nullptr);
  EXPECT_EQ(PictureOf(thread), WithoutThread(scene, *other));
  // The thread has begun the picture when the volume is replaced.
  const QImage expected = WithoutThread(scene, *study);
  QObject::connect(&thread, &PictureThread::Drawn, &thread,
    [&]
    {
      if (thread.Last()->numbers.averaged == 1)
      {
        EXPECT_EQ(thread.Last()->image, expected);
      }
    });
  thread.Draw({ Pixels, PicturesPerSecondAtRest });
  QTest::qSleep(5);
  thread.Take(ScenePart::Volume, scene, study);
  EXPECT_EQ(PictureOf(thread), expected);
}

TEST(PictureThread, KeepsNoVolumeThatWasReplaced)
{
  auto study = SmallStudy();
  const vtkWeakPointer<vtkImageData> replaced(study->volume.image.Get());
  PictureThread thread;
  thread.Take(ScenePart::Volume, SceneOfThread(), study);
  ASSERT_FALSE(PictureOf(thread).isNull());
  study.reset();
  EXPECT_TRUE(replaced);
  thread.Take(ScenePart::Volume, SceneOfThread(), OtherStudy());
  ASSERT_FALSE(PictureOf(thread).isNull());
  EXPECT_FALSE(replaced);
}

TEST(PictureThread, DrawsTheVoxelsOfAnotherTime)
{
  const auto study = SmallStudy();
  const Scene scene = SceneOfThread();
  Study later = *study;
  later.volume.image = vtkSmartPointer<vtkImageData>::New();
  later.volume.image->DeepCopy(study->volume.image);
  vtkDataArray* const voxels = later.volume.image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < voxels->GetNumberOfTuples(); ++i)
  {
    voxels->SetComponent(i, 0, 0.5 * voxels->GetComponent(i, 0));
  }
  PictureThread thread;
  thread.Take(ScenePart::Volume, scene, study);
  const QImage first = PictureOf(thread);
  thread.Take(ScenePart::Voxels, scene, std::make_shared<const Study>(later));
  const QImage second = PictureOf(thread);
  EXPECT_NE(second, first);
  EXPECT_EQ(second, WithoutThread(scene, later));
}

TEST(VolumeCopies, AreTheSameAsLongAsSomebodyHoldsTheVolume)
{
  VolumeCopies copies;
  LoadedVolume first = OtherStudy()->volume;
  const LoadedVolume second = OtherStudy()->volume;
  const auto copy = copies.Of(first);
  copies.Of(second);
  EXPECT_EQ(copies.Of(first), copy);
  const vtkWeakPointer<vtkImageData> image(first.image.Get());
  first = LoadedVolume();
  copies.Of(second);
  EXPECT_EQ(image, nullptr);
}

// Without that, the window would wait for a search that takes minutes.
TEST(PictureThread, StopsASearchForStepsOncePicturesOfAnotherLookAreWanted)
{
  const auto study = StudyOf({ ProceduralKind::Torso, { 160, 160, 160 }, 1 });
  Scene scene = SceneOfThread();
  scene.render.errorTolerance = 1e-6; // its search takes ten seconds for an image of that size
  PictureThread thread;
  thread.Take(ScenePart::Volume, scene, study);
  thread.Draw({ { 4000, 4000 }, PicturesPerSecondAtRest });
  QTest::qSleep(300);
  scene.render.errorTolerance = 1.0 / 16.0;
  thread.Take(ScenePart::Render, scene, study);
  QSignalSpy drawn(&thread, &PictureThread::Drawn);
  thread.Draw({ Pixels, PicturesPerSecondAtRest });
  ASSERT_TRUE(drawn.wait(MostMilliseconds));
  EXPECT_EQ(thread.Last()->image.size(), Pixels) << "the first picture is the one wanted last";
}

TEST(PictureThread, GoesOnIfOnlyTheCountsOfValuesChange)
{
  const auto study = SmallStudy();
  const Scene scene = SceneOfThread();
  PictureThread thread;
  thread.Take(ScenePart::Volume, scene, study);
  ASSERT_FALSE(PictureOf(thread).isNull());
  const double before = thread.Last()->numbers.drawnPart;
  thread.Take(ScenePart::Voxels, scene, study);
  thread.Draw({ Pixels, PicturesPerSecondAtRest, true });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !thread.IsBusy(); }, MostMilliseconds));
  EXPECT_GT(thread.Last()->numbers.drawnPart, before) << "and does not begin anew";
}

TEST(CopyOfLabels, LeavesOutSegmentsThatTheStudyDoesNotHaveYet)
{
  const auto study = LabelledStudy();
  ASSERT_EQ(study->labels->segments.size(), 2u);
  study->labels->image->SetScalarComponentFromDouble(0, 0, 0, 0, 2.0);
  study->labels->image->SetScalarComponentFromDouble(1, 0, 0, 0, 3.0);
  const vtkSmartPointer<vtkImageData> copy = CopyOfLabels(*study);
  EXPECT_EQ(copy->GetScalarComponentAsDouble(0, 0, 0, 0), 2.0);
  EXPECT_EQ(copy->GetScalarComponentAsDouble(1, 0, 0, 0), 0.0);
}

// The editor of segments writes into their voxels where they are, and counts that. A step that is
// taken back brings the version back, which the thread may have copied with later voxels.
TEST(PictureThread, CopiesLabelsAgainWheneverTheyWereWritten)
{
  const auto study = LabelledStudy();
  const Scene scene = SceneOfThread();
  PictureThread thread;
  thread.Take(ScenePart::Volume, scene, study);
  const QImage before = WithoutThread(scene, *study);
  EXPECT_EQ(PictureOf(thread), before);
  study->labels->image->GetPointData()->GetScalars()->Fill(0.0);
  thread.Take(ScenePart::Labels, scene, study);
  EXPECT_EQ(PictureOf(thread), before) << "the thread has a copy";
  ++study->labelGuard->writes;
  thread.Take(ScenePart::Labels, scene, study);
  EXPECT_NE(PictureOf(thread), before);
}
