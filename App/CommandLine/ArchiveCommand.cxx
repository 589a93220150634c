#include "ArchiveArguments.h"
#include "Messages.h"
#include "OutputFolder.h"
#include "Progress.h"
#include "UsageError.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <unistd.h>

namespace varimarch
{

namespace
{

// Never an argument, which all users of the computer can see.
std::string PasswordFor(const ArchiveAddress& address)
{
  if (address.user.empty())
  {
    return {};
  }
  if (const char* const given = std::getenv("VARIMARCH_ARCHIVE_PASSWORD"))
  {
    return given;
  }
  const char* const typed = isatty(STDIN_FILENO)
    ? getpass(("Password of " + address.user + " for " + address.url + ": ").c_str())
    : nullptr;
  if (!typed)
  {
    throw UsageError("--user: there is no terminal to ask for the password; set the environment "
                     "variable VARIMARCH_ARCHIVE_PASSWORD");
  }
  return typed;
}

// Qt's network classes need an application, which is kept beside the archive.
class ConnectedArchive
{
public:
  explicit ConnectedArchive(const ArchiveAddress& address)
  {
    try
    {
      CheckAddress(address);
    }
    catch (const std::invalid_argument& problem)
    {
      throw UsageError(problem.what());
    }
    this->archive = ArchiveAt(address, PasswordFor(address));
  }

  Archive* operator->() { return this->archive.get(); }

private:
  int argumentCount = 1;
  char name[10] = "varimarch";
  char* arguments[2] = { this->name, nullptr };
  QCoreApplication application{ this->argumentCount, this->arguments };
  std::unique_ptr<Archive> archive;
};

std::string EmptyFolder(const std::string& path)
{
  const std::filesystem::path folder = OutputFolder(path);
  if (!std::filesystem::is_empty(folder))
  {
    throw std::runtime_error(
      "Cannot fetch into \"" + path + "\": expected a new or an empty folder, found files in it.");
  }
  return folder.string();
}

bool GoesOn(double)
{
  return true;
}

// A text of the archive for a table on a terminal, which would obey control characters.
std::string Cell(const std::string& text)
{
  QString shown = QString::fromStdString(text);
  const auto isControl = [](QChar letter) { return letter.category() == QChar::Other_Control; };
  std::replace_if(shown.begin(), shown.end(), isControl, QChar(' '));
  return shown.toStdString();
}

void PrintRow(const std::vector<std::string>& cells)
{
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    std::cout << (i > 0 ? "\t" : "") << Cell(cells[i]);
  }
  std::cout << '\n';
}

// Says that texts of studies or series are missing.
template <class Found>
void WarnOfUnreadable(const std::vector<Found>& found)
{
  if (const auto count = UnreadableCount(found))
  {
    PrintMessage("warning: Texts of " + std::to_string(count) +
      " entries were left out: they are in an unknown set of characters, or in another than the "
      "archive says.");
  }
}

}

void RunArchiveCheck(const ArchiveAddress& address)
{
  ConnectedArchive archive(address);
  archive->Check(GoesOn);
  std::cout << "The archive answers.\n";
}

void RunArchiveFind(const ArchiveFindArguments& arguments)
{
  ConnectedArchive archive(arguments.address);
  const Progress waiting("searching");
  if (!arguments.study.empty())
  {
    const std::vector<ArchiveSeries> found = archive->FindSeries(arguments.study, GoesOn);
    PrintRow({ "series", "number", "modality", "images", "description" });
    for (const ArchiveSeries& one : found)
    {
      PrintRow({ one.uid, one.number, one.modality, one.imageCount, one.description });
    }
    WarnOfUnreadable(found);
    return;
  }
  const std::vector<ArchiveStudy> found = archive->FindStudies(arguments.query, GoesOn);
  PrintRow({ "study", "date", "modalities", "patient ID", "patient", "description" });
  for (const ArchiveStudy& one : found)
  {
    PrintRow(
      { one.uid, one.date, one.modalities, one.patientId, one.patientName, one.description });
  }
  WarnOfUnreadable(found);
}

void RunArchiveGet(const ArchiveGetArguments& arguments)
{
  ConnectedArchive archive(arguments.address);
  const std::string folder = EmptyFolder(arguments.folder);
  int count = 0;
  {
    const Progress waiting("fetching");
    count = archive->Fetch(arguments.study, arguments.series, folder, GoesOn);
  }
  std::cout << "Wrote " << count << " images into \"" << folder << "\".\n";
}

void RunArchiveSend(const ArchiveSendArguments& arguments)
{
  ConnectedArchive archive(arguments.address);
  {
    const Progress waiting("sending");
    archive->Send(arguments.files, GoesOn);
  }
  std::cout << "The archive has stored " << arguments.files.size() << " files.\n";
}

}
