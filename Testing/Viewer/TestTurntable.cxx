// Turntables: images and movies, complete or absent. A script stands in for ffmpeg; an installed
// ffmpeg is tested too.

#include "SmallStudy.h"
#include "Viewer/Model/StudyTimes.h"
#include "Viewer/View/Movies.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <stdexcept>

using namespace varimarch;

namespace
{

class Turning : public testing::Test
{
protected:
  bool Write(const QString& name, int stopAfter = 1000000, QSize pixels = { 48, 48 })
  {
    PictureMaker maker(SceneOfPatient(), *this->study, { pixels, false, false });
    int told = 0;
    return WriteTurntable(
      maker, 4, this->folder.filePath(name), [&](double) { return told++ < stopAfter; });
  }

  // The error message of a write that must fail.
  QString Failure(const QString& name)
  {
    try
    {
      this->Write(name);
    }
    catch (const std::runtime_error& problem)
    {
      return QString::fromStdString(problem.what());
    }
    return {};
  }

  QStringList Files() const { return QDir(this->folder.path()).entryList(QDir::Files); }

  QByteArray BytesOf(const QString& name) const
  {
    QFile file(this->folder.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  std::shared_ptr<const Study> study = SmallStudy();
  QTemporaryDir folder;
};

// Uses a PATH on which ffmpeg is a script or missing.
class TurningWithAScript : public Turning
{
protected:
  ~TurningWithAScript() override { qputenv("PATH", this->path); }

  // @param work  commands that replace ffmpeg's encoding; $last is the file to write
  void Pretend(const QByteArray& encoder, const QByteArray& work)
  {
    QFile script(this->programs.filePath("ffmpeg"));
    ASSERT_TRUE(script.open(QIODevice::WriteOnly));
    script.write("#!/bin/sh\ncase \"$*\" in *-encoders) echo ' V..... " + encoder +
      "  a codec'; exit;; esac\nfor last; do :; done; last=${last#file:}\n" + work + "\n");
    script.close();
    script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    qputenv("PATH", this->programs.path().toUtf8() + ":" + this->path);
  }

  QByteArray path = qgetenv("PATH");
  QTemporaryDir programs;
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
  EXPECT_TRUE(this->BytesOf("turn.ogv").startsWith("OggS"));
}

TEST_F(Turning, LeavesNoFilesWhenCancelled)
{
  EXPECT_FALSE(this->Write("turn.png", 2));
  EXPECT_FALSE(this->Write("turn.ogv", 2));
  EXPECT_TRUE(this->Files().isEmpty());
}

// A search for steps asks before each trial image, long before the first picture is there.
TEST_F(Turning, CanBeCancelledDuringASearchForSteps)
{
  constexpr int Asked = 3; // before the first picture, before its first rows, and in the search
  Scene scene = SceneOfPatient();
  scene.render.errorTolerance = 1.0 / 256.0;
  PictureMaker maker(scene, *this->study, { { 96, 96 }, false, false });
  std::vector<double> parts;
  EXPECT_FALSE(WriteTurntable(maker, 4, this->folder.filePath("turn.png"),
    [&](double part)
    {
      parts.push_back(part);
      return parts.size() < Asked;
    }));
  ASSERT_EQ(parts.size(), Asked);
  EXPECT_EQ(parts.back(), 0.0) << "no row of the first picture was drawn";
}

TEST_F(Turning, WritesAChangeFromItsBeginningToItsEnd)
{
  PictureMaker maker(SceneOfPatient(), *this->study, { { 48, 48 }, false, false });
  std::vector<double> parts;
  EXPECT_TRUE(WriteChange(
    maker, 3,
    [&](double part)
    {
      parts.push_back(part);
      SceneCuts cuts;
      cuts.box[1] = 1.0 - 0.5 * part;
      maker.SetCuts(cuts);
    },
    this->folder.filePath("cut.png"), [](double) { return true; }));
  EXPECT_EQ(parts, (std::vector<double>{ 0.0, 0.5, 1.0 }));
  const auto picture = [&](int i)
  { return QImage(this->folder.filePath(QStringLiteral("cut-00%1.png").arg(i))); };
  EXPECT_NE(picture(0), picture(1));
  EXPECT_NE(picture(1), picture(2));
  Look clear = SceneOfPatient().look;
  clear.opacities = { { 0.0, 0.0 } };
  const QImage cut = maker.Draw();
  maker.SetLook(clear);
  EXPECT_NE(maker.Draw(), cut);
}

TEST_F(Turning, NamesAFileThatCannotBeWritten)
{
  EXPECT_TRUE(this->Failure("missing/turn.png").contains("missing/turn-000.png"));
}

TEST_F(Turning, WritesAMovieThatTheRealFfmpegReads)
{
  const QString probe = QStandardPaths::findExecutable("ffprobe");
  if (probe.isEmpty() || QStandardPaths::findExecutable("ffmpeg").isEmpty())
  {
    GTEST_SKIP() << "there is no ffmpeg";
  }
  EXPECT_TRUE(this->Write("turn.mp4", 1000000, { 161, 123 }));
  ASSERT_EQ(this->Files(), QStringList("turn.mp4"));
  QProcess ffprobe;
  ffprobe.start(probe,
    { "-v", "error", "-count_frames", "-show_entries",
      "stream=width,height,nb_read_frames,pix_fmt:format_tags=comment", "-of", "flat",
      this->folder.filePath("turn.mp4") });
  ASSERT_TRUE(ffprobe.waitForFinished());
  const QString told = QString::fromUtf8(ffprobe.readAllStandardOutput());
  for (const char* const fact : { "width=160", "height=122", "nb_read_frames=\"4\"", "yuv420p",
         "\\\"opacities\\\"", "comment" })
  {
    EXPECT_TRUE(told.contains(fact)) << fact << " in " << told.toStdString();
  }
  EXPECT_FALSE(told.contains("DOE"));
}

TEST_F(TurningWithAScript, SendsEveryPictureInEvenSizesToFfmpeg)
{
  this->Pretend("libx264", "echo \"$*\" >&2; echo \"$*\" >\"$last\"; wc -c >>\"$last\"");
  EXPECT_TRUE(this->Write("turn.mp4", 1000000, { 49, 47 }));
  ASSERT_EQ(this->Files(), QStringList("turn.mp4"));
  const QByteArray told = this->BytesOf("turn.mp4");
  EXPECT_TRUE(told.contains("-s 48x46")) << told.toStdString();
  EXPECT_TRUE(told.contains("-c:v libx264")) << told.toStdString();
  EXPECT_EQ(told.trimmed().split('\n').last().toInt(), 4 * 3 * 48 * 46);
}

TEST_F(TurningWithAScript, UsesAnotherEncoderIfX264IsMissing)
{
  this->Pretend("mpeg4", "cat >/dev/null; echo \"$*\" >\"$last\"");
  EXPECT_TRUE(this->Write("turn.mp4"));
  EXPECT_TRUE(this->BytesOf("turn.mp4").contains("-c:v mpeg4"));
}

TEST_F(TurningWithAScript, ReportsTheLastMessageOfFfmpeg)
{
  this->Pretend("libx264", "echo >\"$last\"; echo first >&2; echo 'No space left' >&2; exit 1");
  const QString failure = this->Failure("turn.mp4");
  EXPECT_TRUE(failure.contains("turn.mp4: ffmpeg reports: No space left")) << failure.toStdString();
  EXPECT_TRUE(this->Files().isEmpty());
  this->Pretend("libx264", "cat >/dev/null; echo >\"$last\"; exit 3");
  EXPECT_TRUE(this->Failure("turn.mp4").contains("code 3"));
  EXPECT_TRUE(this->Files().isEmpty());
}

TEST_F(TurningWithAScript, CanBeCancelledWhileFfmpegHangs)
{
  this->Pretend("libx264", "echo >\"$last\"; exec sleep 1000");
  QElapsedTimer clock;
  clock.start();
  EXPECT_FALSE(this->Write("turn.mp4", 4, { 300, 200 }));
  EXPECT_LT(clock.elapsed(), 100000) << "it still waits for ffmpeg";
  EXPECT_TRUE(this->Files().isEmpty());
}

TEST_F(TurningWithAScript, OffersMp4OnlyIfFfmpegIsInstalled)
{
  this->Pretend("libx264", "");
  EXPECT_TRUE(TurntableFilters().first().contains("*.mp4"));
  qputenv("PATH", this->folder.path().toUtf8());
  ASSERT_FALSE(TurntableFilters().isEmpty());
  EXPECT_FALSE(TurntableFilters().join(' ').contains("mp4"));
  EXPECT_TRUE(this->Failure("turn.mp4").contains("ffmpeg"));
  EXPECT_TRUE(this->Files().isEmpty());
}

TEST(TimesInMovies, AreShownForAsLongAsTheyWereAcquired)
{
  LoadedTimes times;
  times.values = { 0.0, 0.1, 0.4, 0.5 };
  times.areSeconds = true;
  EXPECT_EQ(TimesOfMovie(times, {}, 10.0), (std::vector<int>{ 0, 1, 1, 1, 2, 3 }));
  EXPECT_EQ(TimesOfMovie(times, { 5.0 }, 10.0), (std::vector<int>{ 0, 0, 1, 1, 2, 2, 3, 3 }));
  EXPECT_EQ(TimesOfMovie(times, { 100.0 }, 10.0), (std::vector<int>{ 0, 1, 2, 3 }))
    << "no time is left out";
  times.values.back() = 1e9;
  EXPECT_THROW(TimesOfMovie(times, {}, 10.0), std::runtime_error);
}
