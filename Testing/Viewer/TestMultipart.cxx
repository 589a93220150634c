// Messages in parts that an archive sends, divided into files.

#include "Archive/Multipart.h"

#include <QDir>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <stdexcept>

using namespace varimarch;

namespace
{

constexpr int PartCount = 1000;

QByteArray EmptyParts()
{
  QByteArray message;
  for (int i = 0; i < PartCount; ++i)
  {
    message += "--limit\r\n\r\n\r\n";
  }
  return message + "--limit--";
}

}

TEST(Multipart, MakesNoMoreEmptyFilesThanThereIsSpaceFor)
{
  const QTemporaryDir folder;
  MultipartWriter roomy("limit", folder.path().toStdString(), 1e9);
  roomy.Add(EmptyParts());
  roomy.Finish();
  EXPECT_EQ(roomy.PartCount(), PartCount);
  const QTemporaryDir other;
  MultipartWriter narrow("limit", other.path().toStdString(), 1e6);
  EXPECT_THROW(narrow.Add(EmptyParts()), std::runtime_error);
  const int fileCount = QDir(other.path()).entryList(QDir::Files).size();
  EXPECT_GT(fileCount, 0);
  EXPECT_LT(fileCount, PartCount / 2);
}
