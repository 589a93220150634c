// Messages in parts that archives send.
#include "Archive/Multipart.h"
#include "Fuzz/FuzzTarget.h"

#include <QDir>
#include <QTemporaryDir>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace varimarch
{

namespace
{

// Longer text before a part is refused as soon as so much of it has come.
constexpr std::size_t MostInputBytes = 60000;

constexpr double SpaceBytes = 1e6;

/// The files that a message is divided into, or nothing if it is refused.
using Parts = std::optional<std::vector<QByteArray>>;

std::vector<QByteArray> FilesOf(const QString& folder, int count)
{
  std::vector<QByteArray> files;
  for (int i = 1; i <= count; ++i)
  {
    QFile file(folder + QStringLiteral("/image-%1.dcm").arg(i));
    Require(file.open(QIODevice::ReadOnly), "a part has no file");
    files.push_back(file.readAll());
  }
  Require(QDir(folder).entryList(QDir::Files | QDir::Hidden).size() == count,
    "there are other files than those of the parts");
  return files;
}

/// @param step  how many bytes come at a time
Parts DividedInSteps(const QByteArray& message, int step)
{
  const QTemporaryDir folder;
  MultipartWriter writer("limit", folder.path().toStdString(), SpaceBytes);
  try
  {
    for (int begin = 0; begin < message.size(); begin += step)
    {
      writer.Add(message.mid(begin, step));
    }
    writer.Finish();
  }
  catch (const std::runtime_error& error)
  {
    RequireOneLine(error.what());
    return {};
  }
  return FilesOf(folder.path(), writer.PartCount());
}

// The first line is a header, the rest a message. Its parts must not depend on how its bytes come.
bool Divide(const std::string& input)
{
  if (input.size() > MostInputBytes)
  {
    return false;
  }
  const std::size_t lineEnd = std::min(input.find('\n'), input.size());
  BoundaryOf(QByteArray::fromStdString(input.substr(0, lineEnd)));
  const QByteArray message = QByteArray::fromStdString(input.substr(lineEnd));
  const Parts parts = DividedInSteps(message, std::max(1, message.size()));
  for (const int step : { 1, 3, 17 })
  {
    Require(DividedInSteps(message, step) == parts,
      "the parts are others if " + std::to_string(step) + " bytes come at a time");
  }
  return parts.has_value();
}

std::vector<std::string> Messages()
{
  const std::string header = "multipart/related; type=\"application/dicom\"; boundary=limit\n";
  return { header + "--limit\r\nContent-Type: application/dicom\r\n\r\nDICM\r\n--limit--\r\n",
    header + "preamble\r\n--limit\r\n\r\n\r\n--limi\r\n--limit\r\n\r\n\r\n--limit--" };
}

}

std::vector<FuzzTarget> ArchiveTargets()
{
  return { { "multipart", Divide, Messages,
    { "multipart/related", "boundary=", "\"", ";", "\r\n--limit", "--limit--", "\r\n\r\n" } } };
}

}
