// A walk through everything that writes: nothing that the viewer leaves on the disk names the
// patient of the scan. What the user asked for, such as a session, may hold the path of the scan.

#include "Answers.h"
#include "Module/Files/PhantomFiles.h"
#include "Scene/Looks/LookFiles.h"
#include "Scene/Looks/Presets.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/Open/TagsWindow.h"
#include "Viewer/View/ComparisonView.h"
#include "Viewer/View/VolumeView.h"
#include "Waiting.h"

#include <QAction>
#include <QDirIterator>
#include <QFile>
#include <QImage>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

// The name in the files of the phantom.
const QString Family = "Doe";
const QString Given = "Jane";

class Privacy : public testing::Test
{
protected:
  Privacy()
  {
    qputenv("TMPDIR", this->Made("tmp").toUtf8());
    qputenv("HOME", this->Made("home").toUtf8());
    qputenv("XDG_CACHE_HOME", this->Made("cache").toUtf8());
    qputenv("XDG_DATA_HOME", this->Made("data").toUtf8());
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, this->Made("settings"));
    StartLog(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
    this->window = std::make_unique<MainWindow>();
    this->window->resize(900, 600);
    this->window->show();
  }

  QString Made(const QString& name) const
  {
    QDir(this->written.path()).mkpath(name);
    return this->written.filePath(name);
  }

  void OpenScan(const std::string& name)
  {
    for (int slice = 0; slice < 3; ++slice)
    {
      this->scans.Write(name + "/" + std::to_string(slice), DicomBytes(phantom::Stored(0), slice));
    }
    this->window->Open(QString::fromStdString(this->scans.Path(name)));
    QSignalSpy drawn(this->window->CentralView()->Ours(), &VolumeView::Drawn);
    ASSERT_TRUE(QTest::qWaitFor(
      [&] { return this->window->Model()->CurrentStudy() && !drawn.isEmpty(); }, MostMilliseconds));
  }

  // Chooses an item of a menu, and answers that its file goes to the folder of exports.
  void Export(const QString& start, const QString& file)
  {
    const QString path = this->Made("exports") + '/' + file;
    const Answers answers(QMessageBox::Ok, path);
    for (QAction* const action : this->window->findChildren<QAction*>())
    {
      if (action->text().remove('&').startsWith(start))
      {
        action->trigger();
      }
    }
    EXPECT_TRUE(QFile::exists(path)) << path.toStdString();
  }

  // Everything that the menu of exports offers, and what is saved without being asked.
  void ExportEverything()
  {
    this->window->Model()->Edit(ScenePart::Measures, "measure",
      [](Scene& scene) {
        scene.measures.push_back({ MeasureKind::Distance, { { 0, 0, 0 }, { 3, 4, 0 } }, "aorta" });
      });
    this->Export("Export an image", "picture.png");
    this->Export("Export a turntable", "turn.ogv");
    this->Export("Export a report", "report.pdf");
    WriteLookFile(PresetOf(this->window->Model()->CurrentScene()),
      (this->Made("exports") + "/look.json").toStdString(), LookContext());
    emit this->window->findChild<QMenu*>("recent")->aboutToShow();
    for (const QAction* const action : this->window->findChild<QMenu*>("recent")->actions())
    {
      EXPECT_FALSE(Names(action->text().toUtf8())) << action->text().toStdString();
    }
    EXPECT_FALSE(Names(this->window->windowTitle().toUtf8()));
    QTest::qWait(2500); // an autosaved copy is made
  }

  // Opens the window of attributes, which shows the patient.
  void ReadAttributes()
  {
    this->window->findChild<QAction*>("showTags")->trigger();
    auto* const tags = this->window->findChild<TagsWindow*>();
    ASSERT_TRUE(tags);
    const auto showsName = [&] { return tags->SelectedText().contains(Family + '^' + Given); };
    ASSERT_TRUE(QTest::qWaitFor(showsName, MostMilliseconds));
    tags->findChild<QPushButton*>("copy")->click();
    delete tags; // at once, since Export lists all actions
  }

  // True if bytes hold the name in Latin letters, or in UTF-16 of either byte order.
  static bool Names(const QByteArray& bytes)
  {
    const QByteArray lower = bytes.toLower();
    const auto has = [&](const QString& name)
    {
      const QByteArray latin = name.toLower().toLatin1();
      QByteArray wide;
      for (const char letter : latin)
      {
        wide.append(letter).append('\0');
      }
      wide.chop(1);
      return lower.contains(latin) || lower.contains(wide);
    };
    // Three letters occur in compressed data by chance.
    return has(Given) || has(Family + '^') || has('^' + Family);
  }

  // The files below a folder whose names or contents name the patient.
  static QStringList NamingFiles(const QString& folder)
  {
    QStringList naming;
    QDirIterator files(
      folder, QDir::Files | QDir::Hidden | QDir::NoSymLinks, QDirIterator::Subdirectories);
    int count = 0;
    while (files.hasNext())
    {
      QFile file(files.next());
      EXPECT_TRUE(file.open(QIODevice::ReadOnly));
      const QString inPicture = QImage(file.fileName()).text();
      if (Names(file.readAll()) || Names(inPicture.toUtf8()) || Names(file.fileName().toUtf8()))
      {
        naming.append(file.fileName());
      }
      ++count;
    }
    EXPECT_GT(count, 0) << folder.toStdString();
    return naming;
  }

  TemporaryFolder scans;
  QTemporaryDir written;
  std::unique_ptr<MainWindow> window;
};

}

TEST_F(Privacy, NothingWrittenNamesThePatientOfTheFiles)
{
  this->OpenScan("scan");
  ASSERT_FALSE(NamingFiles(QString::fromStdString(this->scans.Path("scan"))).isEmpty());
  this->ReadAttributes();
  this->ExportEverything();
  WriteScene(this->window->Model()->CurrentScene(), this->Made("exports") + "/session.json");
  EXPECT_EQ(NamingFiles(this->written.path()), QStringList());
  {
    const Answers discard(QMessageBox::Discard, {});
    this->window->close();
  }
  EXPECT_EQ(NamingFiles(this->written.path()), QStringList());
}

TEST_F(Privacy, ExportsAndLogsDoNotNameTheFolderOfTheScan)
{
  this->OpenScan("DOE^JANE");
  this->ExportEverything();
  EXPECT_EQ(NamingFiles(this->Made("exports")), QStringList());
  EXPECT_FALSE(NamingFiles(this->Made("data")).isEmpty()) << "the autosaved copy names its scan";
  const Answers discard(QMessageBox::Discard, {});
  this->window->close();
  EXPECT_EQ(NamingFiles(this->Made("data")), QStringList()) << "the log stays, the copy does not";
  QFile settings(QSettings().fileName());
  const auto others = QFile::ReadGroup | QFile::ReadOther;
  EXPECT_FALSE(settings.permissions() & others) << "recent scans are for this user only";
}
