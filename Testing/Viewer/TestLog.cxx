// The log contains events, but no texts of others, which may name a patient.

#include "Viewer/Model/Log.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <vtkObject.h>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Logging : public testing::Test
{
protected:
  Logging() { StartLog(this->folder.path()); }

  QString Text()
  {
    QFile file(LogFileIn(this->folder.path()));
    file.open(QIODevice::ReadOnly);
    return QString::fromUtf8(file.readAll());
  }

  QTemporaryDir folder;
};

}

TEST_F(Logging, NotesEventsWithNumbers)
{
  LogEvent("volume opened", { { "columns", 512 }, { "slices", 3 } });
  EXPECT_TRUE(this->Text().contains("volume opened, columns 512, slices 3\n"));
}

TEST_F(Logging, LogsThePlaceOfMessagesAndNotTheirText)
{
  qWarning("Cannot read /scans/DOE^JANE/1.dcm");
  vtkGenericWarningMacro(<< "Cannot read /scans/DOE^JANE/2.dcm, line 7");
  EXPECT_TRUE(this->Text().contains("message of Qt, category default"));
  EXPECT_TRUE(this->Text().contains("message of VTK from TestLog.cxx, line "));
  EXPECT_FALSE(this->Text().contains("DOE"));
}

TEST_F(Logging, KeepsFourFilesOfHalfAMegabyte)
{
  for (int i = 0; i < 60000; ++i)
  {
    LogEvent("an event of some length that comes again and again");
  }
  qint64 bytes = 0;
  const QFileInfoList files = QDir(this->folder.path()).entryInfoList(QDir::Files);
  for (const QFileInfo& file : files)
  {
    bytes += file.size();
  }
  EXPECT_EQ(files.size(), 4);
  EXPECT_LE(bytes, 4 * 512 * 1024);
}
