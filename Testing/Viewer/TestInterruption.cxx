// Programs that are killed while they write leave the old file or the new one, whole, and what they
// leave beside it is deleted by the next one that writes there. Each case forks a writer many times
// and kills it after a random time; VARIMARCH_KILLS sets how many times, for a longer run.

#include "Scene/Files/OutputFile.h"
#include "Scene/Images/ImageFiles.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/LookFiles.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"
#include "SmallStudy.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/View/Movies.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <stdexcept>

using namespace varimarch;

namespace
{

constexpr int DefaultKills = 40;

int Kills()
{
  const int kills = qEnvironmentVariableIntValue("VARIMARCH_KILLS");
  return kills > 0 ? kills : DefaultKills;
}

// A volume that takes a few milliseconds to write. It is made without threads, which a forked
// process would lack.
LoadedVolume VolumeOf(int version)
{
  LoadedVolume volume = { vtkSmartPointer<vtkImageData>::New(), "CT", {} };
  volume.image->SetDimensions(64, 64, 48);
  volume.image->AllocateScalars(VTK_SHORT, 1);
  auto* const values = static_cast<short*>(volume.image->GetScalarPointer());
  std::minstd_rand random(unsigned(version) + 1);
  std::generate_n(
    values, volume.image->GetNumberOfPoints(), [&] { return short(random() % 4096); });
  return volume;
}

QImage Picture(int version)
{
  QImage picture(320, 240, QImage::Format_RGB32);
  std::minstd_rand random(unsigned(version) + 1);
  for (int i = 0; i < picture.width() * picture.height(); ++i)
  {
    picture.setPixel(i % picture.width(), i / picture.width(), QRgb(random()));
  }
  return picture;
}

vtkSmartPointer<vtkImageData> Bytes(int version)
{
  const QImage picture = Picture(version).convertToFormat(QImage::Format_RGB888);
  auto bytes = vtkSmartPointer<vtkImageData>::New();
  bytes->SetDimensions(picture.width(), picture.height(), 1);
  bytes->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy_n(picture.constBits(), picture.sizeInBytes(),
    static_cast<unsigned char*>(bytes->GetScalarPointer()));
  return bytes;
}

// A session with a thousand measurements.
Scene Session(int version)
{
  Scene scene = SceneOfPatient();
  for (int i = 0; i < 1000; ++i)
  {
    scene.measures.push_back({ MeasureKind::Distance,
      { { double(i), double(version), 0.0 }, { 1.0, 2.0, 3.0 } }, "aorta" });
  }
  return scene;
}

void WriteTurn(int version, const QString& path)
{
  const std::unique_ptr<TurnWriter> writer = TurnWriterFor(path);
  const auto finish = [&]
  {
    while (writer->IsBusy())
    {
    }
  };
  for (int i = 0; i < 3; ++i)
  {
    writer->Add(Picture(version));
    finish();
  }
  writer->End();
  finish();
  writer->Complete();
}

// The last page of an Ogg stream is marked, and ends with the file. RFC 3533
bool IsWholeOgg(const QByteArray& bytes)
{
  const int page = bytes.lastIndexOf("OggS");
  if (page < 0 || bytes.size() < page + 27)
  {
    return false;
  }
  const int segments = uchar(bytes[page + 26]);
  int end = page + 27 + segments;
  for (int i = 0; i < segments && page + 27 + i < bytes.size(); ++i)
  {
    end += uchar(bytes[page + 27 + i]);
  }
  return (bytes[page + 5] & 4) != 0 && end == bytes.size();
}

// The boxes of an MP4 file fill it, and one of them is its index. ISO/IEC 14496-12
bool IsWholeMp4(const QByteArray& bytes)
{
  bool hasIndex = false;
  qint64 at = 0;
  while (at + 8 <= bytes.size())
  {
    const auto byte = [&](int i) { return quint32(uchar(bytes[int(at) + i])); };
    const qint64 size = byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
    hasIndex = hasIndex || bytes.mid(int(at) + 4, 4) == "moov";
    if (size < 8)
    {
      return false;
    }
    at += size;
  }
  return hasIndex && at == bytes.size();
}

class Killed : public testing::Test
{
protected:
  using Writer = std::function<void(int version)>;
  using Judge = std::function<bool(const QByteArray& bytes)>;

  QString Path(const QString& name) const { return this->folder.filePath(name); }

  QByteArray BytesOf(const QString& name) const
  {
    QFile file(this->Path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  // Writes with a limit of file sizes, as on a full disk: that fails and leaves the old files.
  void FailToWrite(const QStringList& names, const Writer& write)
  {
    std::vector<QByteArray> old;
    for (const QString& name : names)
    {
      old.push_back(this->BytesOf(name));
    }
    RunKilled(
      [&]
      {
        // VTK prints that its pipeline failed.
        close(STDERR_FILENO);
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit = { 2000, 2000 };
        setrlimit(RLIMIT_FSIZE, &limit);
        try
        {
          write(1);
          _exit(1);
        }
        catch (const std::runtime_error&)
        {
          // The destructors of the writers have run.
        }
      },
      -1);
    for (std::size_t i = 0; i < old.size(); ++i)
    {
      EXPECT_EQ(this->BytesOf(names[int(i)]), old[i]) << "the old file is lost";
    }
    EXPECT_EQ(this->Unfinished(), 0);
  }

  // Runs the writer in a process of its own. A negative number of microseconds lets it end.
  static void RunKilled(const std::function<void()>& work, int afterMicroseconds)
  {
    const pid_t process = fork();
    ASSERT_GE(process, 0);
    if (process == 0)
    {
      work();
      _exit(0);
    }
    if (afterMicroseconds >= 0)
    {
      usleep(useconds_t(afterMicroseconds));
      kill(process, SIGKILL);
    }
    int status = 0;
    waitpid(process, &status, 0);
    if (afterMicroseconds < 0)
    {
      ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
  }

  // Kills a writer again and again, and looks at the files each time.
  void KillWriting(const QStringList& names, const Writer& write, const Judge& isWhole,
    bool failsOnFullDisk = true)
  {
    QElapsedTimer timer;
    timer.start();
    RunKilled([&] { write(0); }, -1);
    const int writeMicroseconds = int(timer.nsecsElapsed() / 1000);
    std::minstd_rand random(7);
    int unfinished = 0;
    for (int i = 0; i < Kills(); ++i)
    {
      const auto writeOn = [&]
      {
        for (int version = 1;; ++version)
        {
          write(version % 2);
        }
      };
      RunKilled(writeOn, int(random() % unsigned(2 * writeMicroseconds)));
      for (const QString& name : names)
      {
        ASSERT_TRUE(isWhole(this->BytesOf(name))) << name.toStdString() << " after kill " << i;
      }
      unfinished += this->Unfinished() > 0 ? 1 : 0;
    }
    EXPECT_GT(unfinished, 0) << "no kill came while a file was being written";
    RunKilled([&] { write(0); }, -1);
    EXPECT_EQ(this->Unfinished(), 0) << "what was left is found and deleted";
    if (failsOnFullDisk)
    {
      this->FailToWrite(names, write);
    }
    std::cout << Kills() << " kills, " << unfinished << " of them while a file was being written\n";
  }

  // For writers that make the same bytes again.
  void KillWritingSameBytes(const QString& name, const Writer& write)
  {
    QByteArray versions[2];
    for (const int version : { 0, 1 })
    {
      RunKilled([&] { write(version); }, -1);
      versions[version] = this->BytesOf(name);
      ASSERT_FALSE(versions[version].isEmpty());
    }
    ASSERT_NE(versions[0], versions[1]);
    this->KillWriting({ name }, write,
      [&](const QByteArray& bytes) { return bytes == versions[0] || bytes == versions[1]; });
  }

  int Unfinished() const
  {
    return QDir(this->folder.path()).entryList({ "*.part*" }, QDir::Files).size();
  }

  QTemporaryDir folder;
};

class KilledConverting
  : public Killed
  , public testing::WithParamInterface<const char*>
{
};

}

TEST_F(Killed, LeavesTheSessionWhole)
{
  this->KillWritingSameBytes(
    "a.json", [&](int version) { WriteScene(Session(version), this->Path("a.json")); });
}

TEST_F(Killed, LeavesTheLookWhole)
{
  // The colours are many, so that writing takes a while.
  const auto preset = [](int version)
  {
    Preset made = BuiltInPreset("ct-bone");
    made.look.colors.clear();
    for (int i = 0; i < 1000; ++i)
    {
      made.look.colors.push_back({ double(i), { 0.5, 0.25 * version, 1.0 } });
    }
    return made;
  };
  this->KillWritingSameBytes("a.json",
    [&](int version)
    { WriteLookFile(preset(version), this->Path("a.json").toStdString(), LookContext()); });
}

TEST_F(Killed, LeavesThePictureWhole)
{
  this->KillWritingSameBytes(
    "a.png", [&](int version) { WritePng(Bytes(version), this->Path("a.png").toStdString()); });
}

TEST_P(KilledConverting, LeavesTheVolumeWhole)
{
  const QString name = QString("a") + this->GetParam();
  this->KillWritingSameBytes(
    name, [&](int version) { WriteVolume(VolumeOf(version), this->Path(name).toStdString()); });
}

INSTANTIATE_TEST_SUITE_P(
  To, KilledConverting, testing::Values(".nii", ".nii.gz", ".nrrd", ".mha", ".vti", ".tif"));

TEST_F(Killed, LeavesTheSeriesOfPicturesWhole)
{
  this->KillWriting(
    { "a-000.png", "a-001.png", "a-002.png" },
    [&](int version) { WriteTurn(version, this->Path("a.png")); },
    [](const QByteArray& bytes)
    { return QImage::fromData(bytes, "PNG").size() == QSize(320, 240); });
}

TEST_F(Killed, LeavesTheOggMovieWhole)
{
  this->KillWriting(
    { "a.ogv" }, [&](int version) { WriteTurn(version, this->Path("a.ogv")); }, IsWholeOgg);
}

TEST_F(Killed, LeavesTheMp4MovieWhole)
{
  if (FfmpegProgram().isEmpty())
  {
    GTEST_SKIP() << "ffmpeg is not installed";
  }
  this->KillWriting(
    { "a.mp4" }, [&](int version) { WriteTurn(version, this->Path("a.mp4")); }, IsWholeMp4);
}

TEST_F(Killed, LeavesAnAutosavedCopyThatCanBeRestored)
{
  const Scene session = Session(0);
  const auto autosave = [&](int version)
  {
    SceneModel model;
    model.Edit(ScenePart::Measures, "measure",
      [&](Scene& scene)
      {
        scene = session;
        scene.measures.front().name = std::to_string(version);
      });
    Autosave(&model, this->folder.path()).Save();
  };
  const auto isReadable = [](const QByteArray& bytes)
  { return SceneFromText(bytes.toStdString(), "copy").measures.size() == 1000; };
  // A failed backup is not an error.
  this->KillWriting({ "autosaved.json" }, autosave, isReadable, false);
  SceneModel next;
  const Autosave found(&next, this->folder.path());
  EXPECT_TRUE(found.HasCopy());
  // A writer whose lock was taken for a living one has gone on with a copy of another name.
  QFile copy(found.Path());
  ASSERT_TRUE(copy.open(QIODevice::ReadOnly));
  EXPECT_TRUE(isReadable(copy.readAll())) << "the locks of killed viewers are void";
}

int main(int argumentCount, char** arguments)
{
  testing::InitGoogleTest(&argumentCount, arguments);
  const QCoreApplication application(argumentCount, arguments);
  return RUN_ALL_TESTS();
}
